#include "base/constants.hpp"
#include "bearing/given_surface.hpp"
#include "contact/wavy_groove_model.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "core/dynamics/thrust_scene.hpp"
#include "dynamics/constrained.hpp"
#include "setup/surface_table.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

/// Races whose surface varies across, with steps and spalls, and balls that are not round.
using namespace adore;
using namespace adore::fixture;
using dynamics::InstructionSet;
using dynamics::RaceMotion;

namespace {

using Surface = std::function<double(double x, double psi)>;

bearing::RaceErrors table_errors(const bearing::Bearing& b, std::size_t race, const Surface& radius,
                                 const Surface& factor = {}) {
  const std::vector<double> places = setup::surface_table_axial_positions(b, race, 0);
  std::vector<double> of_radius, of_factor;
  for (const double x : places)
    for (int k = 0; k < setup::kTableAround; ++k) {
      const double psi = 2.0 * kPi * k / setup::kTableAround;
      of_radius.push_back(radius(x, psi));
      if (factor) of_factor.push_back(factor(x, psi));
    }
  auto given = std::make_shared<bearing::TabulatedSurface>(
      setup::build_surface_table(b, race, places, of_radius, of_factor));
  if (factor) {
    const auto [low, high] = std::minmax_element(of_factor.begin(), of_factor.end());
    given->curvature_factor.least = *low;
    given->curvature_factor.largest = *high;
  }
  bearing::RaceErrors errors;
  errors.given = std::move(given);
  return errors;
}

double height_at(const bearing::RaceErrors& errors, double psi, double phi) {
  const bearing::SurfaceTable& t = *bearing::table_of(errors.given.get());
  const contact::SurfaceDeviationTable table{t.height.data(), nullptr, t.around, t.across,
                                             t.first,         t.step,  1.0};
  return contact::table_value(table, table.height, psi, phi).value;
}

/// Ball forms of one shape: h = a (u_x² + 0.5 u_y u_z), in a spline over azimuth and latitude.
struct Lobed {
  std::vector<double> height;
  std::vector<contact::SurfaceDeviationTable> of_ball;
  std::vector<Mat3> attitude;
  contact::BallFormErrors forms;

  Lobed(std::size_t balls, double a) {
    constexpr int kAround = 256, kAcross = 129;
    const double step = kPi / (kAcross - 1);
    for (int m = 0; m < kAcross; ++m)
      for (int k = 0; k < kAround; ++k) {
        const double latitude = -0.5 * kPi + m * step, psi = 2.0 * kPi * k / kAround;
        const double y = -std::cos(latitude) * std::sin(psi),
                     z = std::cos(latitude) * std::cos(psi);
        height.push_back(a * (std::pow(std::sin(latitude), 2) + 0.5 * y * z));
      }
    setup::convert_to_spline_coefficients(height, kAround, true);
    of_ball.assign(balls, {height.data(), nullptr, kAround, kAcross, -0.5 * kPi, step, 1.0});
    for (std::size_t i = 0; i < balls; ++i) {
      const Vec3 axis = Vec3(0.3, 1.0, 0.2 * static_cast<double>(i)).normalized();
      attitude.push_back(Eigen::AngleAxisd(0.7 + static_cast<double>(i), axis).toRotationMatrix());
    }
    forms = {of_ball.data(), attitude.front().data()};
  }
};

Surface ripples() {
  return [](double x, double psi) {
    return 1e-6 * std::sin(7.0 * psi + 300.0 * x) + 1e-4 * x * std::cos(psi);
  };
}

}  // namespace

TEST_CASE(
    "rolled over: a spall lets the ball sink by L²/8R or its depth, a bump acts beyond its edge",
    "[unit][setup][imperfections]") {
  const double cost = 0.02;
  std::vector<double> spall(400, 0.0), bump(400, 0.0);
  for (std::size_t k = 150; k < 171; ++k)
    spall[k] = 100.0;  // 20 steps between its edges and 2 more
  for (std::size_t k = 150; k < 171; ++k) bump[k] = -1.0;
  const std::vector<double> sunk = setup::moreau_envelope(spall, cost, true, nullptr);
  CHECK(*std::max_element(sunk.begin(), sunk.end()) == Approx(cost * 11.0 * 11.0));
  CHECK(sunk[149] == 0.0);
  CHECK(sunk[152] == Approx(cost * 9.0));
  const std::vector<double> shallow = setup::moreau_envelope(
      [&] {
        std::vector<double> out = spall;
        for (double& one : out) one *= 0.01;
        return out;
      }(),
      cost, true, nullptr);
  CHECK(*std::max_element(shallow.begin(), shallow.end()) == 1.0);
  const std::vector<double> lifted = setup::moreau_envelope(bump, cost, true, nullptr);
  CHECK(lifted[160] == -1.0);
  CHECK(lifted[147] == Approx(-1.0 + cost * 9.0));
  CHECK(lifted[100] == 0.0);
  // Smooth waves are lowered by the square of their slope, between places, too.
  std::vector<double> wave;
  for (int k = 0; k < 400; ++k) wave.push_back(0.5 * std::sin(2.0 * kPi * k / 400.0));
  const std::vector<double> rolled = setup::moreau_envelope(wave, cost, true, nullptr);
  const double slope = 0.5 * 2.0 * kPi / 400.0;
  CHECK(rolled[0] - wave[0] == Approx(-slope * slope / (4.0 * cost)).epsilon(1e-3));
}

TEST_CASE("tables of grooves: curvature across is that of an arc, a radius that of its waves",
          "[unit][setup][imperfections]") {
  const bearing::Bearing b = angular_contact();
  const double D = b.balls().diameter, nominal = b.balls().contact_angle;
  const auto even = table_errors(
      b, 0, [](double, double) { return 0.0; }, [](double, double) { return 2e-4; });
  for (const double phi : {-0.4, 0.2, 0.9}) {
    const double w = 2e-4 * D * (1.0 - std::cos(phi - nominal));
    // Less what the ball finds nearer beside, of second order.
    CHECK(height_at(even, 1.0, phi) == Approx(w).margin(0.01 * 2e-4 * D));
  }
  const auto wave =
      table_errors(b, 1, [](double, double psi) { return 1e-7 * std::sin(5.0 * psi); });
  for (const double psi : {0.3, 2.0, 5.1})
    CHECK(height_at(wave, psi, 0.1) ==
          Approx(-1e-7 * std::sin(5.0 * psi) * std::cos(0.1)).margin(2e-10));
}

TEST_CASE("tables and balls that are not round: forces and moments are the gradient of the energy",
          "[unit][dynamics][imperfections]") {
  const bearing::Bearing b = angular_contact();
  for (const std::size_t n : {std::size_t{3}, std::size_t{8}}) {
    test::ThrustScene scene = test::thrust_scene("dyn3_40_30k_twoslope_curved", n,
                                                 tribology::make_ellipse_rule(12, 4), 1.0);
    Lobed lobed(n, 2e-6);
    for (std::size_t j = 0; j < 2; ++j) {
      auto& model = scene.model[j];
      model.traction = false;
      const bearing::RaceErrors errors = table_errors(b, j, ripples(), [](double x, double psi) {
        return 1e-3 * x / 5e-3 + 1e-3 * std::cos(psi);
      });
      contact::WavyGroove wavy =
          contact::make_wavy_groove(b.balls(), static_cast<int>(j), errors, 0.43);
      wavy.forms = &lobed.forms;
      model.wavy = std::make_shared<const contact::WavyGroove>(wavy);
      RaceMotion race = scene.race[j];
      race.axis = Vec3(1.0, 3e-5, -2e-5).normalized();
      race.z = (Vec3::UnitZ() - race.axis[2] * race.axis).normalized();
      race.turn = 1.1;
      const auto energy = [&](const RaceMotion& at) {
        test::Outputs out(n);
        return dynamics::evaluate_race_contacts(InstructionSet::Baseline, model, scene.arrays(), at,
                                                out.forces())
            .elastic_energy;
      };
      for (const InstructionSet set :
           {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
        if (!dynamics::is_instruction_set_available(set)) continue;
        INFO("race " << j << ' ' << dynamics::instruction_set_name(set));
        test::Outputs out(n);
        const auto sums =
            dynamics::evaluate_race_contacts(set, model, scene.arrays(), race, out.forces());
        REQUIRE(sums.elastic_energy > 0.0);
        // The race moves, and turns about its axis.
        for (int k = 0; k < 3; ++k) {
          RaceMotion more = race, less = race;
          more.centre[k] += 1e-8;
          less.centre[k] -= 1e-8;
          CHECK(sums.force[k] ==
                Approx((energy(less) - energy(more)) / 2e-8).margin(3e-5 * sums.force.norm()));
        }
        RaceMotion more = race, less = race;
        more.turn += 1e-6;
        less.turn -= 1e-6;
        CHECK(sums.moment.dot(race.axis) ==
              Approx((energy(less) - energy(more)) / 2e-6).margin(3e-5 * sums.moment.norm()));
        // Each ball turns about the base axes.
        double most = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
          const double s = scene.ball[2][i], c = scene.ball[3][i];
          const Vec3 moment(out.value[3][i], -s * out.value[4][i] - c * out.value[5][i],
                            c * out.value[4][i] - s * out.value[5][i]);
          const Mat3 before = lobed.attitude[i];
          Vec3 found;
          for (int k = 0; k < 3; ++k) {
            const auto turned = [&](double angle) {
              lobed.attitude[i] =
                  Eigen::AngleAxisd(angle, Vec3::Unit(k)).toRotationMatrix() * before;
              const double out_energy = energy(race);
              lobed.attitude[i] = before;
              return out_energy;
            };
            found[k] = (turned(-1e-5) - turned(1e-5)) / 2e-5;
          }
          CHECK((moment - found).norm() < 2e-4 * found.norm() + 1e-12);
          most = std::max(most, moment.norm() / out.value[6][i]);
        }
        CHECK(most > 1e-7);  // [m]: the lever of the lobes
      }
      // One ball by dual numbers, as balances have it.
      test::Outputs out(n);
      dynamics::evaluate_race_contacts(model, scene.arrays(), race, out.forces());
      for (std::size_t i = 0; i < n; ++i) {
        dynamics::ConstrainedBall ball(model.groove, {model.hertz.K, model.hertz.K}, 1.0,
                                       {model.angle, model.angle});
        ball.set_wavy_grooves({model.wavy.get(), model.wavy.get()}, i);
        const double s = scene.ball[2][i], c = scene.ball[3][i];
        Mat3 frame;
        frame << 1, 0, 0, 0, -s, c, 0, -c, -s;
        const auto contact = ball.contact_with(
            static_cast<int>(j),
            {frame * race.centre, frame * race.axis, frame * race.zero(), frame.transpose()},
            {scene.ball[0][i], scene.ball[1][i]});
        CHECK(out.value[6][i] == Approx(contact.load).epsilon(1e-10));
        for (int k = 0; k < 3; ++k)
          CHECK(out.value[static_cast<std::size_t>(k)][i] ==
                Approx(contact.force[k]).margin(1e-10 * contact.load));
      }
    }
  }
}

TEST_CASE("tables: at rest the loads are those of the static solution",
          "[physics][dynamics][imperfections]") {
  bearing::Bearing b = angular_contact();
  b.cage.reset();
  b.speed = {0.0, 0.0};
  const Surface spall = [](double x, double psi) {
    return std::abs(psi - 1.4) < 0.04 && std::abs(x - 0.002) < 0.003 ? 4e-6 : 0.0;
  };
  const Surface across = [](double x, double psi) {
    return 1e-3 * (1.0 + std::cos(psi)) * x / 5e-3;
  };
  const bearing::RaceErrors of_cases[][2] = {
      {table_errors(b, 0, ripples()), table_errors(b, 1, ripples())},
      {table_errors(b, 0, spall), table_errors(
                                      b, 1, [](double, double) { return 0.0; }, across)}};
  for (const auto& errors : of_cases) {
    b.imperfections.race = {errors[0], errors[1]};
    const auto solution = statics_of(b, b.balls().contact_angle);
    dynamics::System system = make_system(b, plan_with({scene::Effect::RaceContact}), solution);
    const std::vector<double> y = system.initial_state();
    system.set_start(0.0, y);
    const scene::Snapshot s = system.snapshot(0.0, y);
    double largest = 0.0, smallest = 1e9;
    for (std::size_t i = 0; i < s.elements.size(); ++i) {
      const double load = solution.balls[i].Q[1];
      CHECK(s.elements[i].race[1].load == Approx(load).epsilon(1e-4));
      CHECK(s.elements[i].race[0].load == Approx(solution.balls[i].Q[0]).epsilon(1e-4));
      largest = std::max(largest, load);
      smallest = std::min(smallest, load);
    }
    CHECK(largest > 1.02 * smallest);
    CHECK((s.races[1].applied_force - Vec3(1500.0, 0.0, 500.0)).norm() < 1e-4 * 1500.0);
  }
}

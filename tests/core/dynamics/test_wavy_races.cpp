#include "base/constants.hpp"
#include "contact/race_errors.hpp"
#include "contact/wavy_groove_model.hpp"
#include "core/dynamics/allocation_counter.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "core/dynamics/thrust_scene.hpp"
#include "core/dynamics/wave_record.hpp"
#include "dynamics/constrained.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

/// Races with geometric imperfections in motion.
using namespace adore;
using namespace adore::fixture;
using bearing::RaceErrors;
using dynamics::InstructionSet;
using dynamics::RaceMotion;
using dynamics::System;
using scene::Effect;
using scene::Snapshot;
using scene::Vec3;
using wave_record::about_mean;
using wave_record::Record;
using wave_record::record_of;
using wave_record::rms;

namespace {

RaceErrors wave(double amplitude, double order, double phase = 0.0) {
  RaceErrors e;
  e.roundness = RaceErrors::Roundness::Sinusoidal;
  e.variation = {amplitude, order, phase};
  return e;
}

/// All that a race of a ball bearing can have.
RaceErrors everything() {
  RaceErrors e = wave(1.5e-6, 11.0, 0.4);
  e.curvature_factor = {0.004, 5.0, 0.7};
  return e;
}

/// Eight balls without cage, thrust alone.
bearing::Bearing thrust_bearing(int balls = 8) {
  bearing::Bearing b = angular_contact(balls, 0.06);
  b.balls().shoulder_diameter = {};
  b.cage.reset();
  b.constraints.load = {800.0, 0.0, 0.0, 0.0, 0.0};
  b.constraints.displacement_given = {false, true, true, true, true};
  b.speed = {0.0, 300.0};
  return b;
}

scene::ScenePlan races_only(bool traction) {
  using enum Effect;
  return traction ? plan_with({RaceContact, RaceTraction}) : plan_with({RaceContact});
}

}  // namespace

TEST_CASE("wavy races: every instruction set does what dual numbers say of the normal force",
          "[unit][dynamics][imperfections]") {
  for (const std::size_t n : {std::size_t{3}, std::size_t{8}, std::size_t{19}}) {
    test::ThrustScene scene = test::thrust_scene("dyn3_40_30k_twoslope_curved", n,
                                                 tribology::make_ellipse_rule(12, 4), 1.0);
    bearing::BallGeometry balls;  // of the scene
    for (std::size_t j = 0; j < 2; ++j) {
      auto& model = scene.model[j];
      model.traction = false;
      RaceErrors errors = everything();
      contact::WavyGroove wavy;
      wavy.form = contact::make_race_error_model(errors, 0.03);
      wavy.curvature_diameter = 2.0 * model.groove.ball_radius;
      wavy.normal_x = 0.6;
      wavy.normal_r = 0.8;
      wavy.varying = true;
      wavy.per_factor = 250.0;
      wavy.ratios.stiffness[1] = 0.2;
      wavy.ratios.stiffness[2] = -0.1;
      model.wavy = std::make_shared<const contact::WavyGroove>(wavy);
      RaceMotion race = scene.race[j];
      race.centre += Vec3(1e-6, 2e-6, -3e-6);
      race.axis = Vec3(1.0, 3e-5, -2e-5).normalized();
      race.z = (Vec3::UnitZ() - race.axis[2] * race.axis).normalized();
      race.turn = 1.1;
      dynamics::ConstrainedBall ball(model.groove, {model.hertz.K, model.hertz.K}, 1.0,
                                     {model.angle, model.angle});
      ball.set_wavy_grooves({&wavy, &wavy});
      for (const InstructionSet set :
           {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
        if (!dynamics::is_instruction_set_available(set)) continue;
        test::Outputs out(n);
        const auto sums =
            dynamics::evaluate_race_contacts(set, model, scene.arrays(), race, out.forces());
        double energy = 0.0, most = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
          const double s = scene.ball[2][i], c = scene.ball[3][i];
          Mat3 frame;
          frame << 1, 0, 0, 0, -s, c, 0, -c, -s;
          const auto contact = ball.contact_with(
              static_cast<int>(j), {frame * race.centre, frame * race.axis, frame * race.zero()},
              {scene.ball[0][i], scene.ball[1][i]});
          INFO("race " << j << " ball " << i << ' ' << dynamics::instruction_set_name(set));
          CHECK(out.value[6][i] == Approx(contact.load).epsilon(1e-11));
          for (int k = 0; k < 3; ++k)
            CHECK(out.value[static_cast<std::size_t>(k)][i] ==
                  Approx(contact.force[k]).margin(1e-11 * contact.load));
          energy += contact.energy;
          most = std::max(most, std::abs(contact.force[2]) / contact.load);
        }
        CHECK(sums.elastic_energy == Approx(energy).epsilon(1e-11));
        CHECK(most > 1e-4);  // it leans
      }
    }
  }
}

TEST_CASE("wavy races: stiffness and change with the race's turn are those of differences",
          "[unit][dynamics][imperfections][jacobian]") {
  const bearing::Bearing b = angular_contact();
  const contact::GrooveGeometry groove = contact::groove_geometry(b.balls());
  for (int j = 0; j < 2; ++j) {
    const contact::WavyGroove wavy = contact::make_wavy_groove(b.balls(), j, everything(), 0.436);
    dynamics::ConstrainedBall ball(groove, {9e9, 9e9}, 0.008, angle_laws(b));
    ball.set_wavy_grooves({&wavy, &wavy});
    const double depth =
        (j == 0 ? 1.0 : -1.0) * (groove.offset[static_cast<std::size_t>(j)] + 2e-5);
    Vec3 per_turn = Vec3::Zero();
    const auto contact_at = [&](const Vec3& d, double turn) {
      const Vec3 axis = Vec3(1.0, 2e-4, -3e-4).normalized();
      const Vec3 z = (Vec3::UnitZ() - axis[2] * axis).normalized();
      const RaceMotion race{Vec3::Zero(), axis, 0.0, Vec3::Zero(), Vec3::Zero(), z, turn};
      // The race moved against the ball.
      return ball.wavy_contact(
          j, {-d, axis, race.zero()},
          {depth * std::sin(0.45),
           groove.centre_radius[static_cast<std::size_t>(j)] + depth * std::cos(0.45)},
          per_turn);
    };
    const Vec3 here = Vec3::Zero();
    const auto c = contact_at(here, 0.8);
    REQUIRE(c.load > 0.0);
    const Vec3 found = per_turn;
    const auto force = [](const dynamics::GrooveContact& at) { return at.force; };
    for (int k = 0; k < 3; ++k) {
      Vec3 step = Vec3::Zero();
      step[k] = 1e-9;
      const Vec3 slope =
          (force(contact_at(here + step, 0.8)) - force(contact_at(here - step, 0.8))) / 2e-9;
      CHECK((slope + c.stiffness.col(k)).norm() < 1e-6 * c.stiffness.norm());
    }
    CHECK((c.stiffness - c.stiffness.transpose()).norm() < 1e-9 * c.stiffness.norm());
    const Vec3 turning =
        (force(contact_at(here, 0.8 + 1e-6)) - force(contact_at(here, 0.8 - 1e-6))) / 2e-6;
    CHECK((turning - found).norm() < 1e-6 * turning.norm());
  }
}

TEST_CASE("wavy races: amplitudes of zero change no bit", "[unit][dynamics][imperfections]") {
  bearing::Bearing b = angular_contact();
  System perfect = make_system(b, full_plan());
  for (RaceErrors& errors : b.imperfections.race) {
    errors = wave(0.0, 7.0, 0.3);
    errors.curvature_factor = {0.0, 2.0, 1.0};
  }
  System wavy = make_system(b, full_plan());
  CHECK(run(perfect, perfect.initial_state(), 1e-4, 1e-6).y ==
        run(wavy, wavy.initial_state(), 1e-4, 1e-6).y);
}

TEST_CASE("wavy races: the right-hand side allocates nothing",
          "[unit][dynamics][imperfections][alloc]") {
  bearing::Bearing b = angular_contact();
  b.imperfections.race = {everything(), everything()};
  System system = make_system(b, full_plan());
  const std::vector<double> y = system.initial_state();
  std::vector<double> dydt(y.size());
  system.set_start(0.0, y);
  system.rhs(0.0, y.data(), dydt.data());
  const auto before = test::allocation_count();
  system.rhs(1e-7, y.data(), dydt.data());
  CHECK(test::allocation_count() == before);
}

TEST_CASE("wavy races: work of the drive, heat and stored energy balance ever better",
          "[physics][dynamics][imperfections][energy]") {
  bearing::Bearing b = thrust_bearing();
  b.constraints.load = {800.0, 0.0, 300.0, 0.0, 0.0};
  b.constraints.displacement_given = {false, false, false, true, true};
  b.imperfections.race = {everything(), everything()};
  b.imperfections.race[0].roundness = RaceErrors::Roundness::Elliptical;
  b.imperfections.race[0].variation = {3e-6, -2e-6, 0.3};
  for (const bool traction : {false, true}) {
    double last = 1.0;
    for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
      System system = make_system(b, races_only(traction));
      const double end = 4e-3;
      const RunResult result = run(system, system.initial_state(), end, tolerance);
      const Snapshot s = system.snapshot(end, result.y);
      const double residual = std::abs(s.energy.residual());
      INFO((traction ? "with" : "without")
           << " friction, tolerance " << tolerance << ": " << residual << " J");
      CHECK(residual < last);
      last = residual;
    }
    CHECK(last < 1e-9);  // of 5e-3 J of elastic energy
  }
}

TEST_CASE("wavy races: at rest the forces are those of the static solution",
          "[physics][dynamics][imperfections]") {
  bearing::Bearing b = angular_contact();
  b.cage.reset();
  b.speed = {0.0, 0.0};
  for (const bool curvature : {false, true}) {
    b.imperfections.race = {wave(3e-6, 5.0, 0.2), wave(2e-6, 7.0, 1.0)};
    if (curvature)
      for (RaceErrors& errors : b.imperfections.race) errors.curvature_factor = {0.003, 4.0, 0.6};
    const auto solution = statics_of(b, b.balls().contact_angle);
    System system = make_system(b, races_only(false), solution);
    const std::vector<double> y = system.initial_state();
    system.set_start(0.0, y);
    const Snapshot s = system.snapshot(0.0, y);
    // Statics take Hertz's constant of the changed curvature at the ball's own angle, motion
    // changes that of the nominal curvature as it changes at the static angle.
    const double exact = curvature ? 3e-5 : 1e-7;
    double largest = 0.0, smallest = 1e9;
    for (std::size_t i = 0; i < s.elements.size(); ++i) {
      const double load = solution.balls[i].Q[1];
      CHECK(s.elements[i].race[1].load == Approx(load).epsilon(exact));
      CHECK(s.elements[i].race[0].load == Approx(solution.balls[i].Q[0]).epsilon(exact));
      largest = std::max(largest, load);
      smallest = std::min(smallest, load);
    }
    CHECK(largest > 1.1 * smallest);
    // The load is on the race with the sideways push of the leaning normals; what a changing
    // curvature factor adds to that statics leave out.
    const Vec3 asked(1500.0, 0.0, 500.0);
    const Vec3 carried = s.races[1].applied_force;
    CHECK((carried - asked).norm() < (curvature ? 1e-3 : 1e-7) * asked.norm());
  }
}

TEST_CASE("wavy races: a bearing turned by one pitch, or mirrored, moves likewise",
          "[physics][dynamics][imperfections][symmetry]") {
  constexpr int n = 8;
  const double pitch = 2.0 * kPi / n, end = 1.5e-3;
  bearing::Bearing b = thrust_bearing(n);
  b.constraints.load = {800.0, 100.0, 300.0, 0.0, 0.0};
  b.constraints.displacement_given = {false, false, false, true, true};
  b.imperfections.race = {wave(2e-6, 3.0, 0.4), everything()};
  bearing::Bearing turned = b, mirrored = b;
  const double c = std::cos(pitch), s = std::sin(pitch);
  turned.constraints.load = {800.0, c * 100.0 - s * 300.0, s * 100.0 + c * 300.0, 0.0, 0.0};
  for (RaceErrors& errors : turned.imperfections.race) {
    errors.variation[2] -= errors.variation[1] * pitch;
    errors.curvature_factor.phase -= errors.curvature_factor.waves * pitch;
  }
  // y -> -y: ψ -> -ψ and a sin(-nψ + p) = a sin(nψ + π - p); the shaft turns the other way.
  mirrored.constraints.load = {800.0, -100.0, 300.0, 0.0, 0.0};
  mirrored.speed = {0.0, -300.0};
  for (RaceErrors& errors : mirrored.imperfections.race) {
    errors.variation[2] = kPi - errors.variation[2];
    errors.curvature_factor.phase = kPi - errors.curvature_factor.phase;
  }
  const auto end_of = [&](const bearing::Bearing& of) {
    System system = make_system(of, races_only(true));
    return system.snapshot(end, run(system, system.initial_state(), end, 1e-9).y);
  };
  const Snapshot one = end_of(b), two = end_of(turned), three = end_of(mirrored);
  for (std::size_t i = 0; i < n; ++i) {
    const auto &p = one.elements[i], &q = two.elements[(i + 1) % n],
               &m = three.elements[(n - i) % n];
    CHECK(q.race[1].load == Approx(p.race[1].load).epsilon(1e-6));
    CHECK(m.race[1].load == Approx(p.race[1].load).epsilon(1e-6));
    CHECK(std::abs(q.r - p.r) < 1e-11);
    CHECK(std::abs(m.r - p.r) < 1e-11);
    CHECK(q.theta_dot == Approx(p.theta_dot).epsilon(1e-8));
    CHECK(m.theta_dot == Approx(-p.theta_dot).epsilon(1e-8));
  }
}

TEST_CASE("wavy races: the race's force shows the textbook orders and nothing else",
          "[physics][dynamics][imperfections][slow]") {
  using enum Effect;
  // Z balls. Inner race, n = qZ + p waves: qZ(Ω - Ω_c), of the radial force turned by p times the
  // race; outer race: qZ Ω_c. p = 0: axial force; p = ±1: radial force; other p: none.
  constexpr int Z = 8;
  constexpr double amplitude = 2e-7;
  for (const int race : {0, 1}) {
    double axial_line = 0.0;
    for (const int n : {5, 7, 8, 9, 12, 16}) {
      bearing::Bearing b = thrust_bearing(Z);
      b.imperfections.race[static_cast<std::size_t>(race)] = wave(amplitude, n);
      System system = make_system(b, plan_with({RaceContact, RaceTraction, ElementBalance}));
      const Record r = record_of(system, 4.0);
      const double passing = race == 0 ? r.cage : r.shaft - r.cage;
      const int q = (n + 2) / Z, p = n - q * Z;
      const auto axial = about_mean(r.axial);
      const auto radial = about_mean(r.radial);
      const double axial_peak = 2.0 * std::sqrt(Record::power(axial, r.step, q * Z * passing));
      const double turned = race == 0 ? 0.0 : p * r.shaft;
      // The force turns one way: of two signs the larger.
      const double radial_peak =
          std::sqrt(std::max(Record::power(radial, r.step, q * Z * passing + turned),
                             Record::power(radial, r.step, -(q * Z * passing + turned))));
      INFO("race " << race << ", " << n << " waves: axial " << axial_peak << " of "
                   << rms(axial) * std::sqrt(2.0) << " N, radial " << radial_peak << " of "
                   << rms(radial) << " N");
      if (n == Z) axial_line = axial_peak;
      if (p == 0) {
        CHECK(axial_peak > 1.0);
        CHECK(axial_peak == Approx(rms(axial) * std::sqrt(2.0)).epsilon(0.05));
        CHECK(rms(radial) < 0.02 * axial_peak);
      } else if (p == 1 || p == -1) {
        CHECK(radial_peak > 1.0);
        CHECK(radial_peak == Approx(rms(radial)).epsilon(0.05));
        CHECK(rms(axial) < 0.02 * radial_peak);
      } else if (axial_line > 0.0) {
        CHECK(rms(axial) < 0.02 * axial_line);
        CHECK(rms(radial) < 0.02 * axial_line);
      }
    }
  }
}

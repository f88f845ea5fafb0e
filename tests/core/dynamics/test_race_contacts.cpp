#include "base/errors.hpp"
#include "core/dynamics/allocation_counter.hpp"
#include "core/dynamics/thrust_scene.hpp"
#include "dynamics/race_contacts.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <vector>

using namespace adore;
using dynamics::ElementViews;
using dynamics::InstructionSet;
using dynamics::RaceContactModel;
using dynamics::RaceMotion;
using dynamics::RaceSums;
using scene::Vec3;
using test::Outputs;
using test::ThrustScene;

namespace {

constexpr InstructionSet kSets[] = {InstructionSet::Baseline, InstructionSet::Avx2,
                                    InstructionSet::Avx512};
const char* const kTwoSlopeCase = "dyn3_40_30k_twoslope_curved";
const char* const kExponentialCase = "dyn3_40_30k_exp_curved";
const char* const kFlatCase = "dyn3_40_60k_exp_flat";

ThrustScene scene_of(const char* id, std::size_t n, double spread = 1.0, bool split = false) {
  const auto rule =
      split ? tribology::make_split_ellipse_rule(20, 4) : tribology::make_ellipse_rule(12, 4);
  return test::thrust_scene(id, n, rule, spread);
}

/// A race pushed off its place and tilted, turning, moving and tilting on.
RaceMotion tilted(const RaceMotion& race) {
  RaceMotion moved = race;
  moved.centre += Vec3(1e-6, 2e-6, -3e-6);
  moved.axis = Vec3(1.0, 3e-5, -2e-5).normalized();
  moved.velocity = Vec3(2e-3, -1e-3, 3e-3);
  moved.tilt = moved.axis.cross(Vec3(0.0, 4.0, -7.0));  // 0.3 m/s at the contacts
  return moved;
}

/// The same contact by vector algebra and the scalar rule.
struct Wrench {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< on the ball about its center, base frame
  double heat = 0.0, load_slip = 0.0, load = 0.0;
};
Wrench scalar_contact(const RaceContactModel& model, const ElementViews& balls, std::size_t i,
                      const RaceMotion& race) {
  const auto state = dynamics::race_contact_state(model, balls, i, race);
  Wrench wrench;
  if (!(state.approach > 0.0)) return wrench;
  const auto t = tribology::ellipse_traction(model.law, state.ellipse, state.motion, model.rule);
  wrench.load = state.ellipse.Q;
  wrench.force = -state.ellipse.Q * state.n + t.F_c * state.c + t.F_t * state.t;
  wrench.moment = t.M_c * state.c + t.M_t * state.t + t.M_n * state.n;
  wrench.heat = t.heat;
  wrench.load_slip = t.load_slip;
  return wrench;
}

Vec3 to_base(double x, double r, double t, double s, double c) {
  return {x, -s * r - c * t, c * r - s * t};
}

}  // namespace

TEST_CASE("race contacts: every instruction set agrees with vector algebra and the scalar rule",
          "[unit]") {
  for (const char* id : {kTwoSlopeCase, kExponentialCase, kFlatCase}) {
    for (InstructionSet set : kSets) {
      if (!dynamics::is_instruction_set_available(set)) {
        WARN(dynamics::instruction_set_name(set) << " is not available here and was not compared");
        continue;
      }
      for (std::size_t n :
           {std::size_t{1}, std::size_t{3}, std::size_t{8}, std::size_t{18}, std::size_t{41}}) {
        const bool split = n % 2 == 1;
        const ThrustScene scene = scene_of(id, n, 1.0, split);
        for (std::size_t j = 0; j < 2; ++j) {
          const RaceMotion race = tilted(scene.race[j]);
          Outputs out(n);
          const RaceSums sums = dynamics::evaluate_race_contacts(
              set, scene.model[j], scene.arrays(), race, out.forces());
          RaceSums expected;
          double largest = 0.0, largest_moment = 0.0;
          for (std::size_t i = 0; i < n; ++i) {
            const Wrench one = scalar_contact(scene.model[j], scene.arrays(), i, race);
            largest = std::max(largest, one.load);
            largest_moment = std::max(largest_moment, one.moment.norm());
            const double s = scene.ball[2][i], c = scene.ball[3][i];
            const Vec3 force = to_base(out.value[0][i], out.value[1][i], out.value[2][i], s, c);
            const Vec3 moment = to_base(out.value[3][i], out.value[4][i], out.value[5][i], s, c);
            INFO(id << ' ' << dynamics::instruction_set_name(set) << " n = " << n << " race " << j
                    << " ball " << i);
            // The approach, ~3e-6 m, is a difference of lengths whose last place is 3e-18 m.
            CHECK((force - one.force).norm() < 1e-11 * one.load);
            CHECK((moment - one.moment).norm() <
                  1e-11 * one.load * scene.model[j].groove.ball_radius);
            CHECK(out.value[6][i] == Approx(one.load).epsilon(1e-11));
            CHECK(out.value[7][i] == Approx(one.heat).epsilon(1e-10));
            CHECK(out.value[8][i] == Approx(one.load_slip).epsilon(1e-10));
            expected.force -= one.force;
            const Vec3 arm =
                dynamics::race_contact_state(scene.model[j], scene.arrays(), i, race).arm;
            expected.moment -= arm.cross(one.force) + one.moment;
            expected.heat += one.heat;
            expected.load_slip += one.load_slip;
            const double delta =
                dynamics::race_contact_state(scene.model[j], scene.arrays(), i, race).approach;
            expected.elastic_energy += 0.4 * scene.model[j].hertz.K * std::pow(delta, 2.5);
          }
          const double scale = static_cast<double>(n) * largest;
          CHECK((sums.force - expected.force).norm() < 1e-11 * scale);
          CHECK((sums.moment - expected.moment).norm() < 1e-11 * scale * 0.03);
          CHECK(sums.heat == Approx(expected.heat).epsilon(1e-10));
          CHECK(sums.load_slip == Approx(expected.load_slip).epsilon(1e-10));
          CHECK(sums.elastic_energy == Approx(expected.elastic_energy).epsilon(1e-11));
        }
      }
    }
  }
}

TEST_CASE("race contacts: every instruction set finds the largest slip that a report tells",
          "[unit][step-band]") {
  for (const char* id : {kTwoSlopeCase, kExponentialCase, kFlatCase})
    for (const InstructionSet set : kSets) {
      if (!dynamics::is_instruction_set_available(set)) continue;
      for (const std::size_t n : {1U, 3U, 8U, 18U, 41U}) {
        const ThrustScene scene = scene_of(id, n, 1.0, n % 2 == 1);
        for (std::size_t j = 0; j < 2; ++j) {
          const RaceMotion race = tilted(scene.race[j]);
          RaceContactModel smooth = scene.model[j];
          smooth.traction = false;  // slip is there all the same
          std::vector<double> scratch(n), slip(n, -1.0), without(n, -1.0);
          dynamics::largest_slips(set, scene.model[j], scene.arrays(), race, scratch.data(),
                                  slip.data());
          dynamics::largest_slips(set, smooth, scene.arrays(), race, scratch.data(),
                                  without.data());
          CHECK(without == slip);
          for (std::size_t i = 0; i < n; ++i) {
            INFO(id << ' ' << dynamics::instruction_set_name(set) << " n = " << n << " race " << j
                    << " ball " << i);
            const auto told = race_contact_detail(scene.model[j], scene.arrays(), i, race);
            CHECK(told.max_slip > 0.0);
            CHECK(slip[i] == Approx(told.max_slip).epsilon(1e-10));
          }
        }
      }
    }
}

TEST_CASE("race contacts: an open contact has no slip, beside closed ones too",
          "[unit][step-band]") {
  ThrustScene scene = scene_of(kTwoSlopeCase, 5);
  scene.ball[1][2] -= 2e-5;  // off the outer race
  int open = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    std::vector<double> scratch(5), slip(5, -1.0);
    dynamics::largest_slips(dynamics::chosen_instruction_set(), scene.model[j], scene.arrays(),
                            scene.race[j], scratch.data(), slip.data());
    for (std::size_t i = 0; i < 5; ++i) {
      const auto told = race_contact_detail(scene.model[j], scene.arrays(), i, scene.race[j]);
      CHECK(slip[i] == Approx(told.max_slip).epsilon(1e-10));
      CHECK((slip[i] == 0.0) == !(told.load > 0.0));
      open += told.load > 0.0 ? 0 : 1;
    }
  }
  CHECK(open == 1);
}

TEST_CASE("race contacts: the instruction sets agree with each other to 1e-12 of the load",
          "[unit]") {
  for (const char* id : {kTwoSlopeCase, kExponentialCase}) {
    const ThrustScene scene = scene_of(id, 19, 1.0, id == kTwoSlopeCase);
    for (std::size_t j = 0; j < 2; ++j) {
      Outputs base(19);
      dynamics::evaluate_race_contacts(InstructionSet::Baseline, scene.model[j], scene.arrays(),
                                       scene.race[j], base.forces());
      for (InstructionSet set : {InstructionSet::Avx2, InstructionSet::Avx512}) {
        if (!dynamics::is_instruction_set_available(set)) continue;
        Outputs out(19);
        dynamics::evaluate_race_contacts(set, scene.model[j], scene.arrays(), scene.race[j],
                                         out.forces());
        for (std::size_t k = 0; k < 9; ++k) {
          double largest = 0.0;
          for (double v : base.value[k < 3 ? 6 : k]) largest = std::max(largest, std::abs(v));
          for (std::size_t i = 0; i < 19; ++i) {
            CHECK(std::abs(out.value[k][i] - base.value[k][i]) <= 1e-12 * largest);
          }
        }
      }
    }
  }
}

TEST_CASE("race contacts: traction takes exactly as much power as it heats", "[physics][energy]") {
  for (const char* id : {kTwoSlopeCase, kExponentialCase}) {
    const ThrustScene scene = scene_of(id, 18, 1.0, id == kTwoSlopeCase);
    for (InstructionSet set : kSets) {
      if (!dynamics::is_instruction_set_available(set)) continue;
      for (std::size_t j = 0; j < 2; ++j) {
        const RaceMotion race = tilted(scene.race[j]);
        RaceContactModel smooth = scene.model[j];
        smooth.traction = false;
        Outputs with(18), without(18);
        const RaceSums all = dynamics::evaluate_race_contacts(set, scene.model[j], scene.arrays(),
                                                              race, with.forces());
        const RaceSums normal =
            dynamics::evaluate_race_contacts(set, smooth, scene.arrays(), race, without.forces());
        CHECK(normal.heat == 0.0);
        double power = (all.force - normal.force).dot(race.velocity) +
                       (all.moment - normal.moment).dot(race.speed * race.axis + race.tilt);
        double gross = std::abs(power);
        for (std::size_t i = 0; i < 18; ++i) {
          const double velocity[6] = {
              scene.ball[4][i], scene.ball[5][i], scene.ball[1][i] * scene.ball[6][i],
              scene.ball[7][i], scene.ball[8][i], scene.ball[9][i]};
          for (std::size_t k = 0; k < 6; ++k) {
            const double part = (with.value[k][i] - without.value[k][i]) * velocity[k];
            power += part;
            gross += std::abs(part);
          }
        }
        // Forces of ~1e3 N lose 1e-13 N when the traction is recovered by a difference; speeds are
        // ~10 m/s.
        CHECK(std::abs(power + all.heat) < 1e-12 * gross + 18 * 1e3 * 1e-15 * 100.0);
        CHECK(all.heat > 0.1);
      }
    }
  }
}

TEST_CASE("race contacts: normal forces push the ball back and c points as the conventions say",
          "[physics]") {
  // A ball in the groove plane at zero contact angle, pressed against each race in turn.
  ThrustScene scene = scene_of(kTwoSlopeCase, 1, 0.0);
  for (std::size_t j = 0; j < 2; ++j) {
    const double outward = j == 0 ? 1.0 : -1.0;
    scene.race[j].centre = Vec3::Zero();
    scene.race[j].speed = 0.0;
    const auto& groove = scene.model[j].groove;
    for (auto& values : scene.ball) values[0] = 0.0;
    scene.ball[1][0] = groove.centre_radius[j] + outward * (groove.offset[j] + 3e-6);
    scene.ball[3][0] = 1.0;
    auto state = dynamics::race_contact_state(scene.model[j], scene.arrays(), 0, scene.race[j]);
    CHECK(state.approach == Approx(3e-6).epsilon(1e-9));
    CHECK((state.n - outward * Vec3::UnitZ()).norm() < 1e-15);
    CHECK((state.c - -outward * Vec3::UnitX()).norm() < 1e-15);
    CHECK((state.t - -Vec3::UnitY()).norm() < 1e-15);
    CHECK(state.c.cross(state.t).dot(state.n) == Approx(1.0).epsilon(1e-14));

    // At θ = 0 the rolling direction e_θ is -y. The race turning about +x drags the ball along
    // +e_θ.
    scene.race[j].speed = 10.0;
    Outputs out(1);
    const RaceSums sums = dynamics::evaluate_race_contacts(scene.model[j], scene.arrays(),
                                                           scene.race[j], out.forces());
    CHECK(out.value[1][0] == Approx(-outward * out.value[6][0]).epsilon(1e-12));
    CHECK(out.value[2][0] > 0.0);
    // Traction acts at the ball's far (outer) or near (inner) side: moment about e_x from r e_r ×
    // F_t e_θ.
    CHECK(out.value[3][0] * outward > 0.0);
    CHECK(sums.moment.x() < 0.0);  // the ball brakes the race
    CHECK(sums.force.z() == Approx(outward * out.value[6][0]).epsilon(1e-12));

    // A ball that slides axially is held back, one that spins about the normal is braked.
    scene.race[j].speed = 0.0;
    scene.ball[4][0] = 0.5;
    scene.ball[8][0] = 200.0;
    Outputs slide(1);
    dynamics::evaluate_race_contacts(scene.model[j], scene.arrays(), scene.race[j], slide.forces());
    CHECK(slide.value[0][0] < 0.0);
    CHECK(slide.value[4][0] < 0.0);
  }
}

TEST_CASE("race contacts: contact angles of both races are positive under thrust", "[physics]") {
  const ThrustScene scene = scene_of(kTwoSlopeCase, 1, 0.0);
  for (std::size_t j = 0; j < 2; ++j) {
    const auto detail =
        dynamics::race_contact_detail(scene.model[j], scene.arrays(), 0, scene.race[j]);
    CHECK(detail.angle > 0.2);
    CHECK(detail.angle < 0.8);
  }
}

TEST_CASE("race contacts: turning the whole scene about x turns the race loads",
          "[physics][symmetry]") {
  ThrustScene scene = scene_of(kExponentialCase, 18);
  const double turn = 0.7;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(turn, Vec3::UnitX()).toRotationMatrix();
  for (std::size_t j = 0; j < 2; ++j) {
    const RaceMotion race = tilted(scene.race[j]);
    RaceMotion turned = race;
    turned.centre = rotation * race.centre;
    turned.axis = rotation * race.axis;
    turned.velocity = rotation * race.velocity;
    turned.tilt = rotation * race.tilt;
    ThrustScene rotated = scene;
    for (std::size_t i = 0; i < 18; ++i) {
      const double theta = std::atan2(scene.ball[2][i], scene.ball[3][i]) + turn;
      rotated.ball[2][i] = std::sin(theta);
      rotated.ball[3][i] = std::cos(theta);
    }
    Outputs a(18), b(18);
    const RaceSums first =
        dynamics::evaluate_race_contacts(scene.model[j], scene.arrays(), race, a.forces());
    const RaceSums second =
        dynamics::evaluate_race_contacts(rotated.model[j], rotated.arrays(), turned, b.forces());
    CHECK((rotation * first.force - second.force).norm() < 1e-9 * first.force.norm());
    CHECK((rotation * first.moment - second.moment).norm() < 1e-9 * first.force.norm() * 0.03);
    for (std::size_t i = 0; i < 18; ++i)
      CHECK(a.value[7][i] == Approx(b.value[7][i]).epsilon(1e-9));
  }
}

TEST_CASE("race contacts: tilting race and balls together changes nothing but the frame",
          "[physics][symmetry]") {
  // One ball at θ = 0 is carried by a rotation about y, which keeps it at azimuth 0 (y = 0).
  const ThrustScene scene = [] {
    ThrustScene one = scene_of(kTwoSlopeCase, 1);
    one.ball[2][0] = 0.0;
    one.ball[3][0] = 1.0;
    return one;
  }();
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.01, Vec3::UnitY()).toRotationMatrix();
  const auto& b = scene.ball;
  for (std::size_t j = 0; j < 2; ++j) {
    ThrustScene moved = scene;
    const auto carry = [&](std::size_t x, std::size_t r, std::size_t t, double tx, double tr,
                           double tt) {
      const Vec3 v = rotation * to_base(tx, tr, tt, 0.0, 1.0);  // at θ = 0: e_r = z, e_θ = -y
      moved.ball[x][0] = v.x();
      moved.ball[r][0] = v.z();
      moved.ball[t][0] = -v.y();
    };
    const Vec3 position = rotation * Vec3(b[0][0], 0.0, b[1][0]);
    moved.ball[0][0] = position.x();
    moved.ball[1][0] = position.z();
    carry(4, 5, 6, b[4][0], b[5][0], b[1][0] * b[6][0]);
    moved.ball[6][0] /= position.z();
    carry(7, 8, 9, b[7][0], b[8][0], b[9][0]);
    RaceMotion race = scene.race[j];
    race.centre = rotation * race.centre;
    race.axis = rotation * race.axis;
    Outputs before(1), after(1);
    const RaceSums first = dynamics::evaluate_race_contacts(scene.model[j], scene.arrays(),
                                                            scene.race[j], before.forces());
    const RaceSums second =
        dynamics::evaluate_race_contacts(moved.model[j], moved.arrays(), race, after.forces());
    // Rounding of the turned positions (1e-17 m) against an approach of 1e-6 m.
    CHECK((rotation * first.force - second.force).norm() < 1e-9 * first.force.norm());
    CHECK((rotation * first.moment - second.moment).norm() < 1e-9 * first.force.norm() * 0.03);
    CHECK(before.value[7][0] == Approx(after.value[7][0]).epsilon(1e-9));
  }
}

TEST_CASE("race contacts: open contacts give exactly nothing, at any place in the vector",
          "[unit]") {
  for (InstructionSet set : kSets) {
    if (!dynamics::is_instruction_set_available(set)) continue;
    ThrustScene scene = scene_of(kTwoSlopeCase, 11);
    for (std::size_t i = 0; i < 11; ++i) {
      if (i != 4)
        scene.ball[1][i] = 0.5 * (scene.model[0].groove.centre_radius[0] + scene.ball[1][i]);
    }
    Outputs out(11);
    for (auto& v : out.value[6]) v = -1.0;
    for (auto& v : out.value[0]) v = 5.0;
    const RaceSums sums = dynamics::evaluate_race_contacts(set, scene.model[0], scene.arrays(),
                                                           scene.race[0], out.forces());
    for (std::size_t i = 0; i < 11; ++i) {
      if (i == 4) continue;
      CHECK(out.value[0][i] == 5.0);  // added to, not overwritten
      CHECK(out.value[6][i] == 0.0);
      CHECK(out.value[7][i] == 0.0);
      CHECK(dynamics::race_contact_detail(scene.model[0], scene.arrays(), i, scene.race[0]).load ==
            0.0);
    }
    CHECK(out.value[6][4] > 0.0);
    CHECK(sums.heat == out.value[7][4]);
  }
}

TEST_CASE("race contacts: nothing is written beyond the arrays and a null load-slip is left alone",
          "[unit]") {
  for (InstructionSet set : kSets) {
    if (!dynamics::is_instruction_set_available(set)) continue;
    const ThrustScene scene = scene_of(kTwoSlopeCase, 13);
    Outputs out(20);
    for (auto& values : out.value) std::fill(values.begin() + 13, values.end(), 77.0);
    dynamics::ElementForces forces = out.forces();
    forces.load_slip = nullptr;
    std::fill(out.value[8].begin(), out.value[8].end(), 77.0);
    const RaceSums sums = dynamics::evaluate_race_contacts(set, scene.model[1], scene.arrays(),
                                                           scene.race[1], forces);
    for (const auto& values : out.value) {
      CHECK(std::all_of(values.begin() + 13, values.end(), [](double v) { return v == 77.0; }));
    }
    CHECK(out.value[8][0] == 77.0);
    CHECK(sums.load_slip > 0.0);
  }
}

TEST_CASE("race contacts: the same input gives the same bytes", "[unit]") {
  const ThrustScene scene = scene_of(kExponentialCase, 18);
  Outputs a(18), b(18);
  const RaceSums first =
      dynamics::evaluate_race_contacts(scene.model[0], scene.arrays(), scene.race[0], a.forces());
  const RaceSums second =
      dynamics::evaluate_race_contacts(scene.model[0], scene.arrays(), scene.race[0], b.forces());
  for (std::size_t k = 0; k < 9; ++k) {
    CHECK(std::memcmp(a.value[k].data(), b.value[k].data(), 18 * sizeof(double)) == 0);
  }
  CHECK(first.force == second.force);
}

TEST_CASE("race contacts: the hot path allocates nothing", "[unit][alloc]") {
  const ThrustScene scene = scene_of(kTwoSlopeCase, 18);
  Outputs out(18);
  const dynamics::ElementForces forces = out.forces();
  const ElementViews balls = scene.arrays();
  const long before = test::allocation_count();
  RaceSums sums;
  for (std::size_t j = 0; j < 2; ++j) {
    sums = dynamics::evaluate_race_contacts(scene.model[j], balls, scene.race[j], forces);
  }
  CHECK(test::allocation_count() == before);
  CHECK(sums.heat > 0.0);
}

TEST_CASE("race contacts: the load has the potential 0.4 K δ^2.5", "[physics][energy]") {
  ThrustScene scene = scene_of(kTwoSlopeCase, 1, 0.0);
  RaceContactModel model = scene.model[0];
  model.traction = false;
  const double step = 1e-9;
  const auto energy = [&](double dx, double dr) {
    ThrustScene moved = scene;
    moved.ball[0][0] += dx;
    moved.ball[1][0] += dr;
    Outputs out(1);
    return dynamics::evaluate_race_contacts(model, moved.arrays(), scene.race[0], out.forces())
        .elastic_energy;
  };
  Outputs out(1);
  dynamics::evaluate_race_contacts(model, scene.arrays(), scene.race[0], out.forces());
  // Central difference: (step/δ)² ~ 1e-7.
  CHECK(out.value[0][0] ==
        Approx(-(energy(step, 0) - energy(-step, 0)) / (2 * step)).epsilon(1e-6));
  CHECK(out.value[1][0] ==
        Approx(-(energy(0, step) - energy(0, -step)) / (2 * step)).epsilon(1e-6));
}

TEST_CASE("race_contact_detail reproduces the steady states of the thrust cases", "[validation]") {
  for (const char* id :
       {"dyn3_40_10k_twoslope_curved", "dyn3_40_10k_twoslope_flat", "dyn3_40_30k_twoslope_curved",
        "dyn3_40_30k_exp_curved", "dyn3_40_60k_twoslope_curved", "dyn3_40_60k_exp_flat",
        "dyn3_218_10k_twoslope_curved"}) {
    INFO(id);
    const ThrustScene scene = scene_of(id, 1, 0.0);
    for (std::size_t j = 0; j < 2; ++j) {
      const std::string suffix = j == 0 ? "_o" : "_i";
      const auto detail =
          dynamics::race_contact_detail(scene.model[j], scene.arrays(), 0, scene.race[j], true);
      const auto state =
          dynamics::race_contact_state(scene.model[j], scene.arrays(), 0, scene.race[j]);
      const auto traction =
          tribology::ellipse_traction_converged(scene.model[j].law, state.ellipse, state.motion);
      const auto expect = [&](const char* key, double value, double scale) {
        const double wanted = scene.expected.at(key + suffix);
        INFO(key << suffix << ": " << value << " instead of " << wanted);
        // The stated tolerance of the steady states; the state itself carries 12 digits, 1e-6 of an
        // approach.
        CHECK(std::abs(value - wanted) < 1e-6 * std::max(std::abs(wanted), scale));
      };
      const double full = 0.05 * state.ellipse.Q;
      expect("Q", detail.load, 0.0);
      expect("alpha", detail.angle, 0.0);
      expect("spin_to_roll", detail.spin_to_roll, 0.0);
      expect("heat", detail.heat, 0.0);
      expect("traction_rolling", traction.F_t, full);
      expect("traction_transverse", traction.F_c, full);
      expect("moment_normal", traction.M_n, full * state.ellipse.a);
      expect("slip_centre_rolling", state.motion.u_t - state.motion.W_c * state.ellipse.h0, 1.0);
      expect("slip_centre_transverse", state.motion.u_c + state.motion.W_t * state.ellipse.h0, 1.0);
    }
  }
}

TEST_CASE(
    "measure_rule_error: the split rule of a run errs by less than half a percent of full traction",
    "[physics][convergence]") {
  for (const char* id : {"dyn3_40_10k_twoslope_curved", kTwoSlopeCase, kExponentialCase}) {
    const auto error = [&](const tribology::EllipseRule& rule, std::size_t j) {
      const ThrustScene scene = test::thrust_scene(id, 6, rule, 1.0);
      return dynamics::measure_rule_error(scene.model[j], scene.arrays(), scene.race[j]);
    };
    for (std::size_t j = 0; j < 2; ++j) {
      const auto run = error(tribology::make_split_ellipse_rule(15, 4), j);
      INFO(id << " race " << j << ": force " << run.force << ", moment " << run.moment << ", heat "
              << run.heat);
      CHECK(run.contacts == 6);
      CHECK(run.force < 5e-3);
      CHECK(run.moment < 2e-3);
      CHECK(std::abs(run.heat) < 3e-3);
      CHECK(run.force > 0.0);
      const auto fine = error(tribology::make_split_ellipse_rule(60, 24), j);
      CHECK(fine.force < 5e-4);
      CHECK(fine.force < 0.5 * run.force);
    }
  }
}

TEST_CASE("contact_edges: depth below the shoulder, mirrored on the inner race", "[unit]") {
  ThrustScene scene = scene_of(kTwoSlopeCase, 1, 0.0);
  const double angle = 0.4, a = 1e-3;
  for (std::size_t j = 0; j < 2; ++j) {
    RaceContactModel& model = scene.model[j];
    const double R = model.groove.groove_radius[j], Rc = model.groove.centre_radius[j];
    const auto edges = [&](double at) {
      return contact::contact_edges(model.groove, model.race, at, a, model.shoulder_radius);
    };
    // A shoulder exactly at the contact's end has depth 0; both signs of the angle are the same.
    const double end = j == 0 ? Rc + R * std::cos(angle + a / R) : Rc - R * std::cos(angle + a / R);
    model.shoulder_radius = end;
    CHECK(std::abs(edges(angle).shoulder_depth) < 1e-15);
    model.shoulder_radius = j == 0 ? end - 1e-4 : end + 1e-4;  // a higher shoulder
    CHECK(edges(-angle).shoulder_depth == Approx(1e-4).epsilon(1e-9));
    CHECK(edges(angle).centre_chord == Approx(R * std::sin(angle - a / R)).epsilon(1e-14));
    model.shoulder_radius = 0.0;
    CHECK(edges(angle).shoulder_depth == 0.0);
  }
}

TEST_CASE("ADORE_ISA: unknown names are refused by name, known and available ones accepted",
          "[unit]") {
  const char* old = std::getenv("ADORE_ISA");
  const std::string kept = old == nullptr ? "" : old;
  setenv("ADORE_ISA", "sse9", 1);
  CHECK_THROWS_WITH(dynamics::check_instruction_set_request(),
                    Catch::Contains("ADORE_ISA = \"sse9\""));
  setenv("ADORE_ISA", "baseline", 1);
  CHECK_NOTHROW(dynamics::check_instruction_set_request());
  unsetenv("ADORE_ISA");
  CHECK_NOTHROW(dynamics::check_instruction_set_request());
  if (old != nullptr) setenv("ADORE_ISA", kept.c_str(), 1);
  CHECK(dynamics::is_instruction_set_available(InstructionSet::Baseline));
}

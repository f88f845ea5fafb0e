#include "contact/make_angle_law.hpp"
#include "contact/wavy_groove.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "core/dynamics/thrust_scene.hpp"
#include "dynamics/race_contacts.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace adore;
using dynamics::InstructionSet;
using dynamics::RaceSums;
using scene::Vec3;
using test::Outputs;
using test::ThrustScene;

namespace {

constexpr InstructionSet kSets[] = {InstructionSet::Baseline, InstructionSet::Avx2,
                                    InstructionSet::Avx512};

/// Forces and moments go to the arrays of both races, load and heat to those of each.
std::array<dynamics::ElementForces, 2> element_force_targets(Outputs& shared,
                                                             std::array<Outputs, 2>& own,
                                                             bool load_slip) {
  std::array<dynamics::ElementForces, 2> out{shared.forces(), shared.forces()};
  for (std::size_t j = 0; j < 2; ++j) {
    out[j].load = own[j].value[6].data();
    out[j].heat = own[j].value[7].data();
    out[j].load_slip = load_slip ? own[j].value[8].data() : nullptr;
  }
  return out;
}

/// To rounding: the approach, ~3e-6 m, is a difference of lengths whose last place is 3e-18 m.
bool same(double a, double b, double scale) { return std::abs(a - b) <= 1e-11 * scale; }
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  double scale = 0.0;
  for (const double value : b) scale = std::max(scale, std::abs(value));
  bool all = a.size() == b.size();
  for (std::size_t i = 0; all && i < a.size(); ++i) all = same(a[i], b[i], scale);
  return all;
}
bool same(const Vec3& a, const Vec3& b, double scale) { return (a - b).norm() <= 1e-11 * scale; }

/// What differs between both races at once and one after the other; empty: nothing.
std::string differences(InstructionSet set, const ThrustScene& scene, bool load_slip) {
  Outputs shared(scene.n), shared_apart(scene.n);
  std::array<Outputs, 2> own{Outputs(scene.n), Outputs(scene.n)}, own_apart = own;
  for (auto* one : {&shared, &shared_apart})
    for (auto& values : one->value)
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.1 * static_cast<double>(i);
  const auto out = element_force_targets(shared, own, load_slip);
  const auto apart = element_force_targets(shared_apart, own_apart, load_slip);
  const auto sums =
      dynamics::evaluate_both_races(set, scene.model, scene.arrays(), scene.race, out);
  std::string wrong;
  for (std::size_t j = 0; j < 2; ++j) {
    const RaceSums one = dynamics::evaluate_race_contacts(set, scene.model[j], scene.arrays(),
                                                          scene.race[j], apart[j]);
    double loads = 0.0;
    for (const double load : own_apart[j].value[6]) loads += load;
    if (!same(sums[j].force, one.force, loads)) wrong += " force";
    if (!same(sums[j].moment, one.moment, 0.03 * loads)) wrong += " moment";
    if (!same(sums[j].elastic_energy, one.elastic_energy, one.elastic_energy)) wrong += " energy";
    if (!same(sums[j].heat, one.heat, one.heat)) wrong += " heat";
    if (!same(sums[j].load_slip, one.load_slip, one.load_slip)) wrong += " load_slip";
    for (std::size_t k = 6; k < 9; ++k)
      if (!same(own[j].value[k], own_apart[j].value[k])) wrong += " array " + std::to_string(k);
  }
  for (std::size_t k = 0; k < 6; ++k)
    if (!same(shared.value[k], shared_apart.value[k])) wrong += " action " + std::to_string(k);
  return wrong;
}

}  // namespace

TEST_CASE("both races at once are one after the other, to rounding", "[unit]") {
  for (const char* id :
       {"dyn3_40_30k_twoslope_curved", "dyn3_40_30k_exp_curved", "dyn3_40_60k_exp_flat"})
    for (const InstructionSet set : kSets) {
      if (!dynamics::is_instruction_set_available(set)) continue;
      for (std::size_t n = 1; n <= 20; ++n)
        for (int kind = 0; kind < 16; ++kind) {
          ThrustScene scene =
              test::thrust_scene(id, n, tribology::make_split_ellipse_rule(7, 2), 1.0);
          const bool follows = (kind & 1) != 0, tilts = (kind & 2) != 0, slip = (kind & 4) != 0,
                     traction = (kind & 8) == 0;
          for (std::size_t j = 0; j < 2; ++j) {
            scene.model[j].traction = traction;
            if (follows)
              scene.model[j].angle = contact::make_angle_law(fixture::angular_contact().balls(),
                                                             static_cast<int>(j), 1.1e11);
          }
          if (tilts) {
            scene.race[1].centre += Vec3(1e-6, 2e-6, -3e-6);
            scene.race[1].axis = Vec3(1.0, 3e-5, -2e-5).normalized();
            scene.race[1].velocity = Vec3(2e-3, -1e-3, 3e-3);
            scene.race[1].tilt = scene.race[1].axis.cross(Vec3(0.0, 4.0, -7.0));
          }
          if (n > 2) scene.ball[1][n - 2] -= 4e-5;  // clear of the outer race
          if (n > 5) scene.ball[0][n - 5] += 1e-4;
          REQUIRE(dynamics::can_share_vectors(scene.model));
          INFO(id << ' ' << dynamics::instruction_set_name(set) << " n = " << n << " kind "
                  << kind);
          CHECK(differences(set, scene, slip) == "");
        }
    }
}

TEST_CASE("scenes evaluate both races at once where nothing needs them apart", "[unit]") {
  using enum scene::Effect;
  const auto rows_of = [](const bearing::Bearing& b, scene::ScenePlan plan) {
    std::vector<std::string> out;
    for (const auto& row : fixture::make_system(b, plan).cost().rows())
      if (row.name.find("race contacts") != std::string::npos) out.push_back(row.name);
    return out;
  };
  const std::vector<std::string> both{"race contacts"},
      each{"outer race contacts", "inner race contacts"};
  const bearing::Bearing plain = fixture::angular_contact(10);
  CHECK(rows_of(plain, fixture::full_plan()) == both);
  CHECK(rows_of(plain, fixture::plan_with({RaceContact})) == both);
  scene::ScenePlan light = fixture::full_plan();
  light.effects.push_back({LightLoadBalance, "", true, "test"});
  light.light_load_ratio = 0.05;
  CHECK(rows_of(plain, light) == each);
  bearing::Bearing unequal = plain;
  unequal.imperfections.ball_diameter.assign(10, 0.0);
  unequal.imperfections.ball_diameter[3] = 1e-6;
  CHECK(rows_of(unequal, fixture::full_plan()) == each);
}

TEST_CASE("races share vectors where their balls are alike, round and dry", "[unit]") {
  const ThrustScene scene = test::thrust_scene("dyn3_40_30k_exp_curved", 4,
                                               tribology::make_split_ellipse_rule(7, 2), 1.0);
  CHECK(dynamics::can_share_vectors(scene.model));
  auto other = scene.model;
  other[1].law = tribology::TractionLaw(
      test::law_of({{"type", "two_slope"}, {"A", 0.0}, {"B", 0.05}, {"C", 0.04}, {"um", 1.0}}));
  CHECK_FALSE(dynamics::can_share_vectors(other));
  other = scene.model;
  other[0].own = std::make_shared<dynamics::UnequalBallModels>();
  CHECK_FALSE(dynamics::can_share_vectors(other));
  other = scene.model;
  other[0].traction = false;
  CHECK_FALSE(dynamics::can_share_vectors(other));
  other = scene.model;
  other[1].wavy = std::make_shared<const contact::WavyGroove>();
  CHECK_FALSE(dynamics::can_share_vectors(other));
  other = scene.model;
  other[1].angle.follows = true;
  CHECK_FALSE(dynamics::can_share_vectors(other));
  other = scene.model;
  other[1].surface = tribology::ContactSurface::FlatUndeformed;
  CHECK_FALSE(dynamics::can_share_vectors(other));
}

#pragma once

#include "base/errors.hpp"
#include "bearing/bearing.hpp"
#include "results/channels.hpp"
#include "scene/ledger_terms.hpp"
#include "scene/snapshot.hpp"
#include "support/bytes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

/// Invented but plausible input of the writers: every field has its own value, so that a mixed-up
/// column is seen.
namespace adore::testing {

/// Items of an energy ledger, as effects would make them.
namespace items {
using scene::LedgerKind, scene::LedgerTerm;
inline constexpr LedgerTerm kGravity{LedgerKind::Stored,        "gravity",    "energy in gravity",
                                     {"energy in gravity now"}, "stored now", "N"};
inline constexpr LedgerTerm kWork{LedgerKind::Work,
                                  "work",
                                  "work of the races",
                                  {"work of the outer race", "work of the inner race"},
                                  "since the start"};
inline constexpr LedgerTerm kHeat{LedgerKind::Heat,
                                  "heat",
                                  "heat at the races",
                                  {"outer race contacts", "inner race contacts"},
                                  "since the start"};
inline constexpr LedgerTerm kPocketHeat{
    LedgerKind::Heat, "pocket_heat", "heat in the pockets", {"cage pockets"}, "since the start"};
inline constexpr LedgerTerm kLandHeat{
    LedgerKind::Heat, "land_heat", "heat at the guide lands", {"guide lands"}, "since the start"};
inline constexpr const LedgerTerm* kAll[] = {&scene::terms::kStart,
                                             &scene::terms::kKinetic,
                                             &scene::terms::kElastic,
                                             &kGravity,
                                             &kWork,
                                             &kHeat,
                                             &kPocketHeat,
                                             &kLandHeat};
}  // namespace items
/// Of runs with such a ledger.
inline results::ChannelTable channel_table() { return results::ChannelTable(items::kAll); }

inline bearing::Bearing make_bearing(int balls = 3, bool with_cage = true) {
  bearing::Bearing bearing;
  bearing.run_id = "synthetic run 7";
  bearing.balls().count = balls;
  bearing.balls().diameter = 0.0127;
  bearing.balls().pitch_diameter = 0.07;
  bearing.balls().contact_angle = 0.4;
  bearing.balls().groove_factor = {0.52, 0.53};
  bearing.balls().shoulder_diameter = {0.077, 0.063};
  bearing.envelope = {0.05, 0.09, 0.0, 0.1, {0.02, 0.02}};
  bearing.element_material.name = "AISI 52100";
  bearing.element_material.hardness = 7e9;
  bearing.element_material.wear_coefficient = 1e-6;
  bearing.race_material[0] = bearing.race_material[1] = bearing.element_material;
  bearing.race_material[1].wear_coefficient = 3e-6;
  bearing.race_temperature = {300.0, 310.0};
  bearing.element_temperature = 320.0;
  bearing.cage_temperature = 330.0;
  bearing.speed = {0.0, 1000.0};
  if (with_cage) {
    bearing::Cage cage;
    cage.outer_diameter = 0.074;
    cage.inner_diameter = 0.068;
    cage.width = 0.018;
    cage.clearance_outer = 0.003;
    cage.clearance_inner = 0.005;
    cage.pocket_clearance_1 = 0.0004;
    cage.pocket_clearance_2 = 0.0005;
    cage.lands = {{bearing::GuideLand::Guide::Outer, 0.074, 0.002, -0.007, 0.0006, {}, {}},
                  {bearing::GuideLand::Guide::Outer, 0.074, 0.002, 0.007, 0.0002, {}, {}}};
    cage.material.hardness = 1e9;
    cage.material.wear_coefficient = 2e-6;
    bearing.cage = cage;
  }
  return bearing;
}

inline scene::Quat turn_about_x(double angle) {
  return {std::cos(angle / 2.0), std::sin(angle / 2.0), 0.0, 0.0};
}

inline scene::Snapshot make_snapshot(const bearing::Bearing& bearing, long step = 0) {
  scene::Snapshot snapshot;
  const double t = 1e-5 * static_cast<double>(step);
  snapshot.step = step;
  snapshot.time = t;
  snapshot.step_size = 1e-6;
  snapshot.shaft_rotation = 1000.0 * t;
  for (int j = 0; j < bearing.balls().count; ++j) {
    scene::ElementSnapshot ball;
    const double k = j + 1;
    ball.x = 1e-5 * k;
    ball.r = 0.035 + 1e-5 * k;
    ball.theta = 2.0 * std::numbers::pi * j / bearing.balls().count + 400.0 * t;
    ball.vx = 0.01 * k;
    ball.vr = -0.02 * k;
    ball.theta_dot = 400.0 + k;
    ball.ax = 3.0 * k;
    ball.ar = -4.0 * k;
    ball.theta_ddot = 5.0 * k;
    ball.omega = {-2000.0 * k, 30.0, -500.0};
    ball.oriented = j == 0;
    if (ball.oriented) {
      ball.x_axis = scene::Vec3(0.6, 0.0, 0.8);
      ball.orientation = turn_about_x(0.3);
      ball.total_rotation = -2000.0 * t;
    }
    for (std::size_t race = 0; race < 2; ++race) {
      const double f = k + 10.0 * static_cast<double>(race);
      scene::RaceContactSnapshot& contact = ball.race[race];
      contact.load = 100.0 * f;
      contact.angle = 0.1 * f;
      contact.half_major = 1e-4 * f;
      contact.half_minor = 1e-5 * f;
      contact.max_pressure = 1e9 * f;
      contact.spin_to_roll = 0.01 * f;
      contact.max_slip = 0.2 * f;
      contact.heat = 1.5 * f;
      contact.load_slip = 30.0 * f;
      contact.film = 1e-7 * f;
      contact.temperature_rise = 2.0 * f;
      contact.contact_temperature = 300.0 + f;
      contact.edge = 1e-3 * f;
    }
    if (bearing.cage) {
      const std::size_t surfaces =
          bearing.cage->pocket == bearing::PocketShape::Rectangular ? 4 : 1;
      for (std::size_t s = 0; s < surfaces; ++s) {
        const double f = k + 0.1 * static_cast<double>(s);
        ball.pocket.push_back({f, -1e-6 * f, 3.3 + 0.01 * f, 0.02 * f});
      }
      ball.pocket_to_centre = {1e-5 * k, -1e-5 * k, 2e-5 * k};
    } else {
      ball.to_next = {50.0 + k, -1e-6 * k};
    }
    snapshot.elements.push_back(ball);
  }
  if (bearing.cage) {
    scene::CageSnapshot cage;
    const double a = 450.0 * t;
    cage.position = {1e-5, -1e-4 * std::sin(a), 1e-4 * std::cos(a)};
    cage.velocity = 450.0 * scene::Vec3(0.0, -1e-4 * std::cos(a), -1e-4 * std::sin(a));
    cage.acceleration = 450.0 * 450.0 * scene::Vec3(0.0, 1e-4 * std::sin(a), -1e-4 * std::cos(a));
    cage.velocity.x() = 0.003;
    cage.orientation = turn_about_x(430.0 * t);
    cage.omega = {430.0, 1.0, 2.0};
    cage.total_rotation = 430.0 * t;
    for (std::size_t i = 0; i < bearing.cage->lands.size(); ++i)
      cage.lands.push_back({7.0 + i, 1e-5 * (i + 1.0), 0.5 + i});
    snapshot.cages.push_back(cage);
  }
  snapshot.races[1].position = {2e-5, 0.0, -1e-5};
  snapshot.races[1].omega = {1000.0, 0.0, 0.0};
  snapshot.races[1].orientation = turn_about_x(1000.0 * t);
  snapshot.races[1].total_rotation = 1000.0 * t;
  snapshot.races[1].applied_force = {1000.0, 0.0, -500.0};
  snapshot.races[1].applied_moment = {-0.1, 0.2, 0.3};
  snapshot.races[0].applied_force = {-1000.0, 0.0, 500.0};
  snapshot.races[0].applied_moment = {0.15, -0.25, -0.35};
  snapshot.power.total_loss = 55.0;
  for (int race = 0; race < 2; ++race) {
    snapshot.power.qv_element1[race] = (10.0 + race) * t;
    snapshot.power.qv_race[race] = (100.0 + race) * t;
  }
  snapshot.power.qv_cage = 5.0 * t;
  using namespace scene::terms;
  snapshot.energy.add(kStart, 5.5);
  snapshot.energy.add(kKinetic, 1.0);
  snapshot.energy.add(kElastic, 2.0);
  snapshot.energy.add(items::kGravity, 3.0);
  snapshot.energy.add(items::kWork, 0.25, 0);
  snapshot.energy.add(items::kWork, 0.5, 1);
  snapshot.energy.add(items::kHeat, 20.0 * t, 0, 20.0);
  snapshot.energy.add(items::kHeat, 30.0 * t, 1, 30.0);
  snapshot.energy.add(items::kPocketHeat, 3.0 * t, 0, 3.0);
  snapshot.energy.add(items::kLandHeat, 2.0 * t, 0, 2.0);
  snapshot.max_quaternion_error = 1e-16;
  return snapshot;
}

/// Lines without their ends.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What an InputError says, or "no error".
inline std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A folder of its own that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "adore_results_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string read_bytes(const std::filesystem::path& path) { return test::bytes_of(path); }
inline void write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace adore::testing

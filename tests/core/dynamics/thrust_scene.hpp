#pragma once

#include "dynamics/race_contacts.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"
#include "tribology/traction_curve.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

/// A ball bearing of the thrust reference cases at its steady state, for tests and benchmarks of
/// the race contacts. With spread > 0 the balls differ: approach, slip and spin vary around the
/// circle.
namespace adore::test {

struct ThrustScene {
  std::array<dynamics::RaceContactModel, 2> model;
  std::array<dynamics::RaceMotion, 2> race;
  nlohmann::json expected;  ///< steady state of the reference case
  std::size_t n = 0;
  std::array<std::vector<double>, 10> ball;

  [[nodiscard]] dynamics::ElementViews arrays() const {
    return {n,
            ball[0].data(),
            ball[1].data(),
            ball[2].data(),
            ball[3].data(),
            ball[4].data(),
            ball[5].data(),
            ball[6].data(),
            ball[7].data(),
            ball[8].data(),
            ball[9].data()};
  }
};

/// Results of one race, zeroed.
struct Outputs {
  std::array<std::vector<double>, 9> value;
  explicit Outputs(std::size_t n) {
    for (auto& v : value) v.assign(n, 0.0);
  }
  dynamics::ElementForces forces() {
    return {value[0].data(), value[1].data(), value[2].data(), value[3].data(), value[4].data(),
            value[5].data(), value[6].data(), value[7].data(), value[8].data()};
  }
};

inline bearing::TractionCurve law_of(const nlohmann::json& law) {
  if (law.at("type") == "two_slope") {
    return tribology::traction_curve(0, {law.at("A"), law.at("B"), law.at("C"), law.at("um")});
  }
  return tribology::traction_curve(-1, {law.at("A"), law.at("B"), law.at("C"), law.at("D")});
}

inline tribology::ContactSurface surface_of(const std::string& name) {
  using enum tribology::ContactSurface;
  if (name == "curved_edge") return CurvedEdge;
  if (name == "flat_undeformed") return FlatUndeformed;
  throw std::invalid_argument("unexpected contact surface " + name);
}

inline ThrustScene thrust_scene(const std::string& id, std::size_t n,
                                const tribology::EllipseRule& rule, double spread) {
  // Read once: without optimization it takes a hundredth of a second.
  static const nlohmann::json all = nlohmann::json::parse(
      test::bytes_of(test::source_dir() / "tests/reference/dynamics_ball_thrust.json"));
  for (const nlohmann::json& one : all.at("cases")) {
    if (one.at("id") != id) continue;
    const nlohmann::json &in = one.at("inputs"), &bearing = in.at("bearing"),
                         &derived = in.at("derived");
    ThrustScene scene;
    scene.expected = one.at("expected").at("steady_state");
    const double diameter = bearing.at("D");
    for (std::size_t j = 0; j < 2; ++j) {
      const bool outer = j == 0;
      dynamics::RaceContactModel& model = scene.model[j];
      model.race = outer ? bearing::kOuter : bearing::kInner;
      model.groove.ball_radius = 0.5 * diameter;
      const std::array<double, 2> factor{bearing.at("fo"), bearing.at("fi")};
      const std::array<double, 2> centre{derived.at("Rc_outer"), derived.at("Rc_inner")};
      for (std::size_t i = 0; i < 2; ++i) {
        model.groove.groove_radius[i] = factor[i] * diameter;
        model.groove.offset[i] = (factor[i] - 0.5) * diameter;
        model.groove.centre_radius[i] = centre[i];
      }
      model.hertz.K = derived.at(outer ? "K_o" : "K_i");
      model.hertz.a_hat = derived.at(outer ? "a_over_Q13_o" : "a_over_Q13_i");
      model.hertz.b_hat = derived.at(outer ? "b_over_Q13_o" : "b_over_Q13_i");
      model.hertz.kappa = model.hertz.a_hat / model.hertz.b_hat;
      model.law = law_of(in.at("traction_law"));
      model.surface = surface_of(in.at("contact_surface"));
      model.rule = rule;
      const double x =
          in.at("static").at(outer ? "outer_groove_centre_x" : "inner_groove_centre_x");
      scene.race[j] = {scene::Vec3(x, 0, 0), scene::Vec3::UnitX(),
                       in.at(outer ? "outer_speed_rad_s" : "inner_speed_rad_s").get<double>()};
    }
    scene.n = n;
    for (auto& values : scene.ball) values.resize(n);
    const nlohmann::json& steady = scene.expected;
    for (std::size_t i = 0; i < n; ++i) {
      const double theta =
          0.3 + 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      const double wave = spread * std::cos(theta), other = spread * std::sin(2.0 * theta);
      scene.ball[0][i] = steady.at("x").get<double>() + 1e-6 * wave;
      scene.ball[1][i] = steady.at("r").get<double>() + 2e-6 * other;
      scene.ball[2][i] = std::sin(theta);
      scene.ball[3][i] = std::cos(theta);
      scene.ball[4][i] = 1e-3 * other;
      scene.ball[5][i] = 2e-3 * wave;
      scene.ball[6][i] = steady.at("orbital_speed").get<double>() * (1.0 + 1e-3 * wave);
      scene.ball[7][i] = steady.at("omega_x").get<double>() * (1.0 + 3e-3 * other);
      scene.ball[8][i] = steady.at("omega_r").get<double>() * (1.0 + 0.1 * wave);
      scene.ball[9][i] = steady.at("omega_theta").get<double>() + 3.0 * other;
    }
    return scene;
  }
  throw std::invalid_argument("no reference case " + id);
}

}  // namespace adore::test

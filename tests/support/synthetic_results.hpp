#pragma once

#include "results/sol_file.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <string>

/// Plausible results of a 12-ball bearing at 10 000 rpm over three revolutions, made from closed
/// formulas: the apps' tests need numbers that look real, not a solver.
namespace adore::test {

struct SyntheticRun {
  int steps = 1500;
  int balls = 12;
  double revolutions = 3.0;
  double shaft = 10000.0 / 60.0;     // [rev/s]
  double pitch_radius = 0.0325;      // [m]
  double ball_radius = 0.005;        // [m]
  double cage_ratio = 0.43;          // cage speed over shaft speed
  double clearance = 150e-6;         // guide land, radial [m]
  double pocket_clearance = 300e-6;  // diametral [m]

  [[nodiscard]] double end_time() const { return revolutions / shaft; }
  [[nodiscard]] double time(int i) const { return end_time() * i / (steps - 1); }
};

inline results::SolHeader synthetic_header(results::SolKind kind, const SyntheticRun& run) {
  results::SolHeader h;
  h.version = "Adore0.9.0";
  h.run_id = "synthetic 12-ball bearing";
  h.elements = run.balls;
  h.per_segment = run.balls;
  h.segments = 1;
  using results::SolKind;
  h.units = {
      "rpm/s", "m/s^2", "rpm", "m/s", "deg", "m", "N", "W", kind == SolKind::Race ? "N.m" : "K",
      ""};
  switch (kind) {
    case SolKind::Element:
      h.title = "Rolling Element No. 1$", h.value_count = 33, h.index = 1;
      break;
    case SolKind::Cage:
      h.title = "Cage$", h.value_count = 24 + 4 * run.balls, h.index = run.balls + 1;
      break;
    case SolKind::Race:
      h.title = "Inner Race$", h.value_count = 24, h.index = run.balls + 3;
      break;
    default:
      h.title = "Power Dissipation and Life$", h.value_count = 26;
      h.units = {"W", "hr", "N.m", "m^3/s", "K", "s", "rev", "", "", ""};
  }
  return h;
}

inline double turn_limited(double degrees) { return std::remainder(degrees, 360.0); }

inline std::vector<double> synthetic_values(results::SolKind kind, const SyntheticRun& run,
                                            double t) {
  const double w = 2 * std::numbers::pi * run.shaft, phase = run.cage_ratio * w * t;
  const double rpm = run.shaft * 60, ripple = std::sin(w * t), fast = std::sin(17.3 * w * t);
  using results::SolKind;
  if (kind == SolKind::Element) {
    const double out = 420 + 160 * std::cos(phase) + 6 * fast,
                 in = 360 + 150 * std::cos(phase) + 6 * fast;
    return {2.1e4 * fast,
            35 * fast,
            4 * ripple,
            run.cage_ratio * rpm + 12 * std::sin(phase),
            2e-4 * fast,
            5e-5 * ripple,
            std::fmod(phase * 180 / std::numbers::pi, 360.0),
            run.pitch_radius + 4e-7 * std::cos(phase),
            2.2e-5 + 3e-6 * ripple,
            turn_limited(25 * std::sin(phase)),
            turn_limited(40 * std::cos(phase)),
            turn_limited(3.2 * w * t * 180 / std::numbers::pi),
            3.21 * rpm + 20 * ripple,
            178 + std::sin(phase),
            -12 + 2 * std::cos(phase),
            out,
            in,
            22.1 + std::cos(phase),
            26.4 + 1.3 * std::cos(phase),
            0.021 + 0.002 * ripple,
            0.27 + 0.02 * std::cos(phase),
            0.31 + 0.05 * std::abs(fast),
            0.92 + 0.08 * std::cos(phase),
            1.4 + 0.3 * std::cos(phase),
            4.1 + 0.9 * std::cos(phase),
            3.1e-7 + 1e-8 * ripple,
            2.6e-7 + 1e-8 * std::cos(phase),
            95 + 10 * std::cos(phase),
            240 + 30 * std::cos(phase),
            8 + std::cos(phase),
            19 + 2 * ripple,
            361 + std::cos(phase),
            372 + 2 * ripple};
  }
  const double whirl = 0.46 * w * t, radius = 0.9 - 0.5 * std::exp(-t / (0.4 * run.end_time()));
  if (kind == SolKind::Cage) {
    const double force = std::max(0.0, 14 * std::sin(whirl * 2.3));
    std::vector<double> v{0.46 + 0.02 * ripple,
                          1e-3 * fast,
                          2e-4 * ripple,
                          force,
                          run.clearance * (1 - radius),
                          turn_limited(whirl * 4),
                          0.0,
                          run.clearance * (1 - radius) + 2e-6,
                          turn_limited(whirl * 4 + 5),
                          4e3 * fast,
                          6 * fast,
                          ripple,
                          0.05 * ripple,
                          -radius * std::sin(whirl),
                          radius * std::cos(whirl),
                          std::fmod(whirl * 180 / std::numbers::pi, 360.0),
                          radius * run.clearance,
                          5e-6 * ripple,
                          0.1 * ripple,
                          0.2 * fast,
                          turn_limited(phase * 180 / std::numbers::pi),
                          run.cage_ratio,
                          0.02 * ripple,
                          0.01 * fast};
    for (int i = 0; i < run.balls; ++i) {
      const double a = phase + 2 * std::numbers::pi * i / run.balls, pull = std::sin(a);
      v.insert(v.end(),
               {std::max(0.0, 9 * pull - 3), 0.5 * run.pocket_clearance * (1 - std::abs(pull)),
                pull > 0 ? 0.0 : 180.0, 0.0});
    }
    return v;
  }
  if (kind == SolKind::Race) {
    return {rpm * 0.01 * ripple,
            1e-4 * fast,
            2e-5 * ripple,
            1500,
            20 * ripple,
            -800 + 20 * fast,
            0.0,
            0.4 * ripple,
            0.1 * fast,
            5e3 * fast,
            12 * fast,
            3 * ripple,
            1.1e-5 + 2e-7 * ripple,
            3e-6 * std::sin(w * t) + 4e-7 * fast,
            -7e-6 + 3e-6 * std::cos(w * t),
            std::fmod(w * t * 180 / std::numbers::pi, 360.0),
            7e-6,
            1.1e-5,
            0.002 * ripple,
            0.001 * fast,
            turn_limited(w * t * 180 / std::numbers::pi),
            rpm,
            0.01 * ripple,
            0.0};
  }
  return {182 + 6 * ripple + 2 * fast,
          0.21 + 0.01 * ripple,
          12400 + 600 * std::cos(w * t),
          0.31 + 0.01 * fast,
          -0.29 + 0.01 * ripple,
          0.4 * ripple,
          -0.4 * ripple,
          0.1 * fast,
          -0.1 * fast,
          3e-17 * (1 + 0.2 * std::exp(-t * 300)),
          2.1e-17,
          4.4e-17,
          8e-16 * (1 + std::exp(-t * 400)),
          366,
          361,
          368,
          355,
          310,
          316 + 2 * ripple,
          352,
          361,
          340,
          181,
          120,
          38 + ripple,
          23 + ripple};
}

inline results::SolFile synthetic_sol(results::SolKind kind, const SyntheticRun& run = {}) {
  results::SolFile file;
  file.path = kind == results::SolKind::Element ? "SOL1"
              : kind == results::SolKind::Cage  ? "SOL2"
              : kind == results::SolKind::Race  ? "SOL3"
                                                : "SOL7";
  file.kind = kind;
  file.header = synthetic_header(kind, run);
  for (int i = 0; i < run.steps; ++i) {
    results::SolStep step;
    const double t = run.time(i);
    step.step = i * 20L;
    step.time = t;
    step.revolutions = run.shaft * t;
    step.element_revolutions = run.cage_ratio * run.shaft * t;
    step.step_size = run.time(1) / 20;
    step.values = synthetic_values(kind, run, t);
    file.steps.push_back(std::move(step));
  }
  return file;
}

inline results::Sol8File synthetic_sol8(const SyntheticRun& run = {}) {
  results::Sol8File file;
  file.path = "SOL8";
  file.version = "Adore0.9.0";
  file.run_id = "synthetic 12-ball bearing";
  file.elements = run.balls;
  file.units = {"m", "rad", "N", "s", "rev", "m/s", "rpm", "K", "W", ""};
  const double inner_land = run.pitch_radius - 0.0022;
  // As the solver writes it: races at the bottom of their grooves.
  file.geometry = {run.pitch_radius + 0.0022,
                   inner_land,
                   9e-4,
                   run.clearance,
                   run.pocket_clearance,
                   0.0,
                   run.ball_radius,
                   2 * run.pitch_radius,
                   0.0420,
                   run.pitch_radius + 0.00502,
                   run.pitch_radius - 0.00501,
                   0.0225};
  const double w = 2 * std::numbers::pi * run.shaft;
  const auto limited = [](double a) { return std::remainder(a, 2 * std::numbers::pi); };
  for (int i = 0; i < run.steps; ++i) {
    results::Sol8Frame frame;
    const double t = run.time(i), phase = run.cage_ratio * w * t;
    frame.step = i * 20L;
    frame.time = t;
    frame.revolutions = run.shaft * t;
    const double whirl = 0.46 * w * t,
                 radius = 0.98 * run.clearance * (1 - 0.6 * std::exp(-6 * t / run.end_time()));
    frame.cage.position = {2e-6 * std::sin(w * t), -radius * std::sin(whirl),
                           radius * std::cos(whirl)};
    frame.cage.angles = {limited(phase), 1e-4 * std::sin(w * t), 1e-4 * std::cos(w * t)};
    // Inner race guided: the bore touches on the side from which the cage moved away.
    const double force =
        std::max(0.0, radius / run.clearance - 0.75) * (60 + 10 * std::sin(9.7 * w * t));
    frame.land_force = {force, 0.8 * force};
    frame.land_angle = {limited(whirl + std::numbers::pi - phase),
                        limited(whirl + std::numbers::pi - phase)};
    for (int k = 0; k < run.balls; ++k) {
      const double pocket = phase + 2 * std::numbers::pi * k / run.balls;
      const double lead = 0.5 * run.pocket_clearance * std::sin(pocket + 0.3) * 0.999;
      results::Sol8Element e;
      e.x = 2e-5;
      // The pocket goes with the cage's center.
      e.theta = limited(pocket + (lead + radius * std::sin(whirl - pocket)) / run.pitch_radius);
      e.r = run.pitch_radius;
      e.angles = {limited(-3.1 * w * t + k), 0.3, 0.0};
      e.pocket_vector = {2e-5, -lead, -radius * std::cos(pocket - whirl)};
      e.pocket_force = std::max(0.0, 12 * (std::abs(std::sin(pocket + 0.3)) - 0.8));
      e.pocket_angle = lead > 0 ? std::numbers::pi : 0.0;
      frame.elements.push_back(e);
    }
    frame.races[1].position = {1.1e-5, 3e-6 * std::sin(w * t), -7e-6};
    frame.races[1].angles = {limited(w * t), 0, 0};
    file.frames.push_back(std::move(frame));
  }
  return file;
}

}  // namespace adore::test

#include "tribology/churning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace adore::tribology {
namespace {

struct Point {
  double reynolds, coefficient;
};

constexpr std::array<Point, 12> kSphere = {{{0.1, 275.0},
                                            {1.0, 30.0},
                                            {10.0, 4.2},
                                            {1e2, 1.2},
                                            {1e3, 0.48},
                                            {1e4, 0.40},
                                            {1e5, 0.45},
                                            {2e5, 0.40},
                                            {3e5, 0.10},
                                            {4e5, 0.09},
                                            {5e5, 0.09},
                                            {1e6, 0.09}}};
constexpr std::array<Point, 10> kCylinder = {{{0.1, 60.0},
                                              {1.0, 10.0},
                                              {10.0, 3.0},
                                              {1e2, 1.5},
                                              {1e3, 1.0},
                                              {1e4, 1.1},
                                              {1e5, 1.2},
                                              {2e5, 1.2},
                                              {5e5, 0.30},
                                              {1e6, 0.35}}};

/// Log-log; Re C constant below the table, C constant above it.
double coefficient(std::span<const Point> table, double reynolds) {
  const Point& first = table.front();
  if (reynolds <= first.reynolds) return first.coefficient * first.reynolds / reynolds;
  if (reynolds >= table.back().reynolds) return table.back().coefficient;
  std::size_t i = 1;
  while (table[i].reynolds < reynolds) ++i;
  const Point &a = table[i - 1], &b = table[i];
  const double share = std::log(reynolds / a.reynolds) / std::log(b.reynolds / a.reynolds);
  return a.coefficient * std::pow(b.coefficient / a.coefficient, share);
}

Drag drag(std::span<const Point> table, const Medium& medium, double speed, double diameter,
          double area) {
  Drag out;
  out.reynolds = medium.density * std::abs(speed) * diameter / medium.viscosity;
  // Below the table the force is linear in the speed: C Re is what stays finite.
  if (out.reynolds <= table.front().reynolds) {
    out.coefficient = out.reynolds > 0.0 ? coefficient(table, out.reynolds) : 0.0;
    out.force = 0.5 * table.front().coefficient * table.front().reynolds * medium.viscosity *
                std::abs(speed) / diameter * area;
    return out;
  }
  out.coefficient = coefficient(table, out.reynolds);
  out.force = 0.5 * out.coefficient * medium.density * area * speed * speed;
  return out;
}

/// 0 below `from`, 1 above `to`, a cubic between.
double blend(double x, double from, double to) {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace

Drag sphere_drag(const Medium& medium, double speed, double diameter, double area) {
  return drag(kSphere, medium, speed, diameter, area);
}

Drag cylinder_drag(const Medium& medium, double speed, double diameter, double length) {
  return drag(kCylinder, medium, speed, diameter, diameter * length);
}

RotationDrag annulus_drag(const Medium& medium, double speed, double radius, double gap,
                          double length) {
  RotationDrag out;
  const double w = std::abs(speed);
  out.reynolds = medium.density * w * radius * gap / medium.viscosity;
  out.taylor = out.reynolds * std::sqrt(gap / radius);
  const double vortices = 1.3 * std::pow(out.taylor / 41.0, 0.539474),
               turbulence = 3.0 * std::pow(out.reynolds / 2500.0, 0.85596);
  const double with_vortices =
      1.0 + blend(out.taylor, 35.0, 45.0) * (std::max(1.0, vortices) - 1.0);
  const double with_turbulence =
      1.0 + blend(out.reynolds, 2250.0, 2750.0) * (std::max(1.0, turbulence) - 1.0);
  out.coefficient = std::max(with_vortices, with_turbulence);
  // ½ (2/Re) ρ (ω r)² = μ ω r/c
  out.torque = 2.0 * std::numbers::pi * radius * radius * length * medium.viscosity * w * radius /
               gap * out.coefficient;
  return out;
}

RotationDrag disc_drag(const Medium& medium, double speed, double radius) {
  RotationDrag out;
  const double w = std::abs(speed), r2 = radius * radius;
  out.reynolds = medium.density * w * r2 / medium.viscosity;
  if (!(out.reynolds > 0.0)) return out;
  const double laminar = 3.87 / std::sqrt(out.reynolds),
               turbulent = 0.146 / std::pow(out.reynolds, 0.2);
  const double share = blend(out.reynolds, 2.7e5, 3.3e5);
  out.coefficient = laminar + share * (turbulent - laminar);
  out.torque = 0.5 * medium.density * w * w * r2 * r2 * radius * out.coefficient;
  return out;
}

RotationDrag spin_drag(const Medium& medium, double speed, double radius) {
  RotationDrag out;
  const double w = std::abs(speed), r2 = radius * radius;
  out.reynolds = medium.density * w * r2 / medium.viscosity;
  if (!(out.reynolds > 0.0)) return out;
  constexpr double kLast = 4e4;
  const double Re = std::min(out.reynolds, kLast);
  out.coefficient = std::max(16.0 * std::numbers::pi / Re, 6.45 / std::sqrt(Re) + 32.1 / Re);
  out.torque = 0.5 * medium.density * w * w * r2 * r2 * radius * out.coefficient;
  return out;
}

double plate_friction(double reynolds) {
  if (!(reynolds > 0.0)) return 0.0;
  const double laminar = 1.328 / std::sqrt(reynolds);
  constexpr double kFirst = 1e4;
  if (reynolds < kFirst) return laminar;
  return std::max(laminar, 0.455 / std::pow(std::log10(reynolds), 2.58) - 1700.0 / reynolds);
}

}  // namespace adore::tribology

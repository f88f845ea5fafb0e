#include "thermal/convection.hpp"

#include <algorithm>
#include <cmath>

namespace adore::thermal {
namespace {

double prandtl(const ConvectionFluid& f) { return f.viscosity * f.specific_heat / f.conductivity; }

double reynolds(const ConvectionFluid& f, double diameter, double speed) {
  return f.density * std::abs(speed) * diameter / f.viscosity;
}

}  // namespace

double sphere_convection(const ConvectionFluid& f, double diameter, double speed) {
  const double Nu = 2.0 + 0.6 * std::sqrt(reynolds(f, diameter, speed)) * std::cbrt(prandtl(f));
  return Nu * f.conductivity / diameter;
}

double cylinder_convection(const ConvectionFluid& f, double diameter, double speed) {
  const double Re = reynolds(f, diameter, speed), Pr = prandtl(f);
  const double fluid = std::pow(1.0 + std::pow(0.4 / Pr, 2.0 / 3.0), -0.25),
               wake = std::pow(1.0 + std::pow(Re / 282000.0, 0.625), 0.8);
  return (0.3 + 0.62 * std::sqrt(Re) * std::cbrt(Pr) * fluid * wake) * f.conductivity / diameter;
}

double ring_convection(const ConvectionFluid& f, double diameter, double omega) {
  const double Re = reynolds(f, diameter, 0.5 * omega * diameter);
  const double Nu = std::max(0.36, 0.133 * std::pow(Re, 2.0 / 3.0) * std::cbrt(prandtl(f)));
  return Nu * f.conductivity / diameter;
}

}  // namespace adore::thermal

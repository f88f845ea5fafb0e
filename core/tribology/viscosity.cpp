#include "tribology/viscosity.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::tribology {

double Viscosity::log_at(double pressure, double temperature) const {
  return std::visit([&](const auto& law) { return law.log_viscosity(pressure, temperature); },
                    law_);
}

double Viscosity::at(double pressure, double temperature) const {
  return std::exp(log_at(pressure, temperature));
}

double Viscosity::pressure_coefficient(double temperature) const {
  return std::visit(
      [&](const auto& law) { return law.pressure_viscosity_coefficient(temperature); }, law_);
}

double Viscosity::temperature_coefficient(double pressure, double temperature) const {
  constexpr double kStep = 0.01;
  return (log_at(pressure, temperature - kStep) - log_at(pressure, temperature + kStep)) /
         (2.0 * kStep);
}

Viscosity viscosity_law(std::string_view name, const std::function<double(const char*)>& value) {
  if (name == "typeI")
    return {TypeOneViscosity{value("mu0"), value("alpha"), value("beta"), value("T0")}};
  if (name == "typeII")
    return {TypeTwoViscosity{value("mu0"), value("alpha"), value("beta"), value("T0")}};
  if (name == "roelands")
    return {RoelandsViscosity{value("muR"), value("TR"), value("Z"), value("S0")}};
  if (name == "doubleExponential")
    return {DoubleExponentialViscosity{value("c0"), value("c1"), value("c2"), value("c3"),
                                       value("p0"), value("p1"), value("p2")}};
  if (name == "expQuadratic")
    return {QuadraticExponentialViscosity{value("mu0"), value("Tr"), value("b1"), value("b2"),
                                          value("e1"), value("e0")}};
  if (name == "waltherDensity")
    return {WaltherViscosity{value("d0"), value("d1"), value("m"), value("n"), value("alpha0"),
                             value("gammaT")}};
  if (name == "yasutomiImproved")
    return {YasutomiViscosity{value("mug"), value("Tg0"), value("A1"), value("A2"), value("b1"),
                              value("b2"), value("C1"), value("C2")}};
  if (name == "hybrid")
    return {HybridViscosity{value("muA"), value("B"), value("Tinf"), value("a1"), value("q"),
                            value("CF"), value("pInf"), value("aT"), value("pInfT"), value("TR")}};
  if (name == "vogelScaling")
    return {VogelScalingViscosity{
        value("muInf"), value("BF"), value("phiInf"), value("g"),
        TaitVolume{value("K0p"), value("K00"), value("betaK"), value("aV"), value("TR")}}};
  throw InputError(fmt::format(
      "there is no viscosity law \"{}\"; the laws are typeI, typeII, roelands, doubleExponential, "
      "expQuadratic, waltherDensity, yasutomiImproved, hybrid and vogelScaling",
      name));
}

}  // namespace adore::tribology

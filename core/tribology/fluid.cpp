#include "tribology/fluid.hpp"

#include "base/errors.hpp"
#include "base/resources.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace adore::tribology {
namespace {

using Json = nlohmann::json;

struct Correlation {
  enum class Form : unsigned char { Polynomial, Exponential, IdealGas, Walther };
  Form form = Form::Polynomial;
  std::vector<double> c;
  double T0 = 0.0, S = 1.0;  // polynomials
  double p = 0.0, R = 0.0;   // ideal gas
  double A = 0.0, B = 0.0;   // Walther
  double T_min = 0.0, T_max = std::numeric_limits<double>::infinity();
  std::shared_ptr<const Correlation> density;  // Walther: turns ν into µ
  std::string provenance;

  [[nodiscard]] double operator()(double temperature) const {
    const double T = std::clamp(temperature, T_min, T_max);
    double sum = 0.0;
    for (auto i = c.rbegin(); i != c.rend(); ++i) sum = sum * (T - T0) / S + *i;
    switch (form) {
      case Form::Polynomial:
        return sum;
      case Form::Exponential:
        return std::exp(sum);
      case Form::IdealGas:
        return p / (R * T);
      case Form::Walther:
        return (std::pow(10.0, std::pow(10.0, A - B * std::log10(T))) - 0.7) * 1e-6 * (*density)(T);
    }
    return 0.0;
  }
};

Correlation parse(const Json& json) {
  static const std::map<std::string, Correlation::Form> forms = {
      {"poly", Correlation::Form::Polynomial},
      {"exp_poly", Correlation::Form::Exponential},
      {"ideal_gas", Correlation::Form::IdealGas},
      {"walther", Correlation::Form::Walther}};
  const auto form = forms.find(json.at("form").get<std::string>());
  demand(form != forms.end(), "fluids.json has a correlation of unknown form");
  Correlation out;
  out.form = form->second;
  if (json.contains("c")) out.c = json["c"].get<std::vector<double>>();
  out.T0 = json.value("T0", 0.0);
  out.S = json.value("S", 1.0);
  out.p = json.value("p", 0.0);
  out.R = json.value("R", 0.0);
  out.A = json.value("A", 0.0);
  out.B = json.value("B", 0.0);
  out.T_min = json.value("T_min", out.T_min);
  out.T_max = json.value("T_max", out.T_max);
  out.provenance = json.value("provenance", std::string());
  if (json.contains("density"))
    out.density = std::make_shared<const Correlation>(parse(json["density"]));
  return out;
}

struct Fluid {
  std::string name;
  std::array<Correlation, 4> properties;  // density, viscosity, specific heat, conductivity
};

const std::map<int, Fluid>& fluids() {
  static const std::map<int, Fluid> table = [] {
    std::map<int, Fluid> out;
    const Json json = Json::parse(resources::get("fluids.json"));
    for (const Json& entry : json.at("fluids"))
      out[entry.at("code").get<int>()] = {
          entry.at("name").get<std::string>(),
          {parse(entry.at("density")), parse(entry.at("viscosity")),
           parse(entry.at("specific_heat")), parse(entry.at("conductivity"))}};
    return out;
  }();
  return table;
}

}  // namespace

FluidProperties fluid_properties(int code, double T) {
  const auto found = fluids().find(code);
  if (found == fluids().end()) {
    std::string codes;
    for (const int valid : fluid_codes())
      codes += fmt::format("{}{}", codes.empty() ? "" : ", ", valid);
    throw InputError(fmt::format(
        "fluid code {} is not in the fluid table. The codes in the table are {}", code, codes));
  }
  if (!(T > 0.0 && std::isfinite(T)))
    throw InputError(fmt::format("the temperature of {} is {} K; it must be above 0 (absolute)",
                                 found->second.name, T));
  const auto& properties = found->second.properties;
  FluidProperties out;
  out.name = found->second.name;
  out.density = properties[0](T);
  out.viscosity = properties[1](T);
  out.specific_heat = properties[2](T);
  out.conductivity = properties[3](T);
  out.T_min = 0.0;
  out.T_max = std::numeric_limits<double>::infinity();
  static constexpr std::array kWeaker{"seen", "recalled", "estimated"};
  std::size_t rank = 0;
  for (const Correlation& p : properties) {
    out.T_min = std::max(out.T_min, p.T_min);
    out.T_max = std::min(out.T_max, p.T_max);
    for (std::size_t i = 0; i < kWeaker.size(); ++i)
      if (p.provenance == kWeaker[i]) rank = std::max(rank, i);
  }
  out.provenance = kWeaker[rank];
  out.clamped = T < out.T_min || T > out.T_max;
  return out;
}

std::vector<int> fluid_codes() {
  std::vector<int> out;
  for (const auto& [code, fluid] : fluids()) out.push_back(code);
  return out;
}

}  // namespace adore::tribology

#include "bearing/grade_oil.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::bearing {
namespace {

constexpr double kAt15 = 288.15, kAt40 = 313.15, kAt100 = 373.15;  // [K]
constexpr double kWalther = 0.7, kLeast = 2.0;                     // [mm²/s]

struct BaseOilData {
  const char* name;
  double index, density;  ///< -, [kg/m³] at 15 °C
  double s, t;            ///< pressure coefficient
  double conductivity, specific_heat;
};
/// [recalled, medium]
constexpr std::array<BaseOilData, 4> kBaseOils{
    {{"mineral oil", 95.0, 880.0, 9.904, 0.139, 0.135, 1950.0},
     {"polyalphaolefin", 140.0, 840.0, 7.382, 0.1335, 0.145, 2150.0},
     {"ester", 140.0, 950.0, 6.605, 0.136, 0.150, 1950.0},
     {"polyglycol", 200.0, 1030.0, 5.489, 0.1485, 0.165, 2000.0}}};

const BaseOilData& data_of(BaseOil base) {
  return kBaseOils.at(static_cast<std::size_t>(base) - 1);
}

/// Reference oils of ASTM D2270 with viscosity index 0 and 100: their viscosity at 40 °C for a
/// viscosity Y at 100 °C [mm²/s; recalled, checked with two published examples].
struct ReferenceOil {
  double Y, L, H;
};
constexpr std::array<ReferenceOil, 20> kReference{
    {{2, 7.9931, 6.3934},   {2.5, 11.452, 9.0629}, {3, 15.484, 12.153},   {3.8, 23.135, 17.976},
     {4.4, 30.469, 22.921}, {5, 40.231, 28.496},   {5.7, 52.632, 35.282}, {6.4, 65.163, 42.125},
     {7, 78.039, 48.569},   {7.7, 93.177, 56.165}, {9, 123.29, 71.102},   {10.5, 160.58, 88.954},
     {12, 201.86, 108.00},  {15, 296.44, 149.68},  {18, 408.63, 196.15},  {22, 585.09, 264.92},
     {28, 903.59, 380.43},  {40, 1728.9, 651.31},  {55, 3126.5, 1066.5},  {70, 4902.7, 1557.8}}};

double between(double Y, double ReferenceOil::*of) {
  if (Y > kReference.back().Y)
    return of == &ReferenceOil::L ? 0.8353 * Y * Y + 14.67 * Y - 216.0
                                  : 0.1684 * Y * Y + 11.85 * Y - 97.0;
  auto next = std::find_if(kReference.begin() + 1, kReference.end() - 1,
                           [&](const ReferenceOil& r) { return r.Y >= Y; });
  const ReferenceOil &a = *(next - 1), &b = *next;
  const double part = std::log(Y / a.Y) / std::log(b.Y / a.Y);
  return a.*of * std::pow(b.*of / (a.*of), part);
}

double walther(double nu_mm) { return std::log10(std::log10(nu_mm + kWalther)); }

/// ν at 100 °C [mm²/s] from ν at 40 °C and the index, which grows with it.
double at_100(double at_40, double index) {
  double low = kLeast, high = at_40;
  if (!(viscosity_index(at_40, low) < index))
    throw InputError(fmt::format(
        "oil of record X2: the viscosity {:.4g} mm²/s at 40 °C and the viscosity index {:g} result "
        "in less than 2 mm²/s at 100 °C, which is outside the range of ASTM D2270; give two "
        "viscosities",
        at_40, index));
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (viscosity_index(at_40, middle) < index ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double viscosity_index(double at_40, double at_100) {
  const double L = between(at_100, &ReferenceOil::L), H = between(at_100, &ReferenceOil::H);
  if (at_40 >= H) return 100.0 * (L - at_40) / (L - H);
  const double N = std::log10(H / at_40) / std::log10(at_100);
  return (std::pow(10.0, N) - 1.0) / 0.00715 + 100.0;
}

OilByGrade oil_by_grade(const OilGradeInput& given) {
  const BaseOilData& base = data_of(given.base);
  OilByGrade out;
  out.given = given;
  out.density = given.density.value_or(base.density);
  const double T1 = given.first_at.value_or(kAt40), T2 = given.second_at.value_or(kAt100);
  const auto refuse = [](const char* why) {
    throw InputError(fmt::format("oil of record X2: {}", why));
  };
  if (given.grade && given.first)
    refuse(
        "has both a grade and viscosities; give either oilGrade or the viscosities (oilVisc1, "
        "oilVisc2)");
  if (!given.grade && !given.first) refuse("has no viscosity; give oilGrade or oilVisc1");
  if (given.second && !given.first)
    refuse("has oilVisc2 without oilVisc1; give both viscosities, or give oilGrade and oilIndex");
  if (given.second && given.viscosity_index)
    refuse("has two viscosities and a viscosity index; remove oilVisc2 or oilIndex");
  double nu1 = given.grade ? *given.grade : 1e6 * *given.first, nu2 = 0.0;
  double from = T1, to = T2;
  if (given.second) {
    nu2 = 1e6 * *given.second;
    out.index_given = true;
  } else {
    if (given.first_at && std::abs(*given.first_at - kAt40) > 0.01)
      refuse("has only one viscosity, which is not at 40 °C; give a second viscosity");
    out.index_given = given.viscosity_index.has_value();
    from = kAt40;
    to = kAt100;
    nu2 = at_100(nu1, given.viscosity_index.value_or(base.index));
  }
  if (to < from) {
    std::swap(from, to);
    std::swap(nu1, nu2);
  }
  if (to - from < 10.0)
    refuse(
        "has viscosities at nearly equal temperatures. Give temperatures that differ by 10 K or "
        "more");
  if (!(nu2 < nu1))
    refuse("has a viscosity that increases with temperature; exchange the viscosities");
  if (!(nu2 >= kLeast))
    refuse("has a viscosity below 2 mm²/s, which is outside the range of Walther's law");
  out.B = (walther(nu1) - walther(nu2)) / (std::log10(to) - std::log10(from));
  out.A = walther(nu1) + out.B * std::log10(from);
  const double hot = 1e6 * out.kinematic_viscosity(kAt100);
  out.viscosity_index =
      hot >= kLeast ? viscosity_index(1e6 * out.kinematic_viscosity(kAt40), hot) : 0.0;
  return out;
}

double OilByGrade::kinematic_viscosity(double T) const {
  return 1e-6 * (std::pow(10.0, std::pow(10.0, A - B * std::log10(T))) - kWalther);
}

double OilByGrade::density_at(double T) const {
  constexpr double kFall = 0.65;  // [kg/m³/K; recalled, high]
  return density - kFall * (T - kAt15);
}

double OilByGrade::viscosity(double T) const { return density_at(T) * kinematic_viscosity(T); }

double OilByGrade::pressure_coefficient(double T) const {
  const BaseOilData& base = data_of(given.base);
  const auto estimate = [&](double at) {
    return 1e-9 * base.s * std::pow(1e6 * kinematic_viscosity(at), base.t);
  };
  const double scale =
      given.pressure_coefficient ? *given.pressure_coefficient / estimate(kAt40) : 1.0;
  return scale * estimate(T);
}

std::string OilByGrade::name() const {
  if (!given.name.empty()) return given.name;
  const char* const base = data_of(given.base).name;
  std::string out = given.grade ? fmt::format("ISO VG {} {}", *given.grade, base)
                                : fmt::format("{:.4g} mm²/s at 40 °C, {}",
                                              1e6 * kinematic_viscosity(kAt40), base);
  return given.grease ? "grease, base oil " + out : out;
}

std::string OilByGrade::estimates() const {
  std::string out;
  const auto add = [&](std::string text) { out += (out.empty() ? "" : ", ") + text; };
  if (!index_given) add(fmt::format("viscosity index {:.4g}", viscosity_index));
  if (!given.density) add(fmt::format("density {:.4g} kg/m^3 at 15 °C", density));
  if (!given.pressure_coefficient)
    add(fmt::format("pressure coefficient {:.3g} 1/Pa at 40 °C", pressure_coefficient(kAt40)));
  return out;
}

UserLubricant film_oil(const OilByGrade& oil, double T0) {
  const BaseOilData& base = data_of(oil.given.base);
  UserLubricant out;
  out.name = oil.name();
  out.T0 = T0;
  out.viscosity = oil.viscosity(T0);
  out.alpha = oil.pressure_coefficient(T0);
  // d ln μ / d(1/T) = -T² d ln μ / dT, by a central difference.
  constexpr double kStep = 0.5;  // [K]
  const double slope =
      std::log(oil.viscosity(T0 - kStep) / oil.viscosity(T0 + kStep)) / (2.0 * kStep);
  out.beta = slope * T0 * T0;
  out.conductivity = base.conductivity;
  out.density = oil.density_at(T0);
  out.specific_heat = base.specific_heat;
  out.traction_viscosity = out.viscosity;
  out.traction_alpha = out.alpha;
  out.traction_beta = slope;
  return out;
}

}  // namespace adore::bearing

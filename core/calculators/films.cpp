#include "base/errors.hpp"
#include "calculators/json_access.hpp"
#include "calculators/tribology.hpp"
#include "tribology/film_thickness.hpp"
#include "tribology/flash_strip.hpp"
#include "tribology/lubricant.hpp"
#include "tribology/lubricant_range.hpp"
#include "tribology/newton_film_walls.hpp"
#include "tribology/shear_thinning_film.hpp"
#include "tribology/starvation.hpp"
#include "tribology/thermal_reduction.hpp"
#include "tribology/viscoelastic_strip.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::calculators {
namespace {

using namespace tribology;

std::optional<Json> film_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string formula = in.at("formula");
  const FilmInlet inlet{get(in, "mu0"), get(in, "alpha"), get(in, "u"), get(in, "Eprime")};
  const auto both = [](const FilmThickness& film) {
    return Json{{"hCentral", film.central}, {"hMin", film.minimum}};
  };
  if (formula == "hamrockDowson") {
    return both(point_film(inlet, get(in, "Rx"), get(in, "load"), get(in, "k")));
  }
  if (formula == "chittenden") {
    return both(chittenden_point_film(inlet, get(in, "Re"), get(in, "Rs"), get(in, "load")));
  }
  if (formula != "line") return std::nullopt;
  const double R = get(in, "R"), load = get(in, "loadPerLength");
  const FilmThickness dowson = line_film(inlet, R, load),
                      pan = pan_hamrock_line_film(inlet, R, load);
  return Json{{"dowson_higginson_1966_min", dowson_higginson_line_film(inlet, R, load)},
              {"dowson_1968_min", dowson.minimum},
              {"dowson_toyoda_1979_central", dowson.central},
              {"pan_hamrock_1989_min", pan.minimum},
              {"pan_hamrock_1989_central", pan.central}};
}

/// `gupta` has the hard floor of the reference; the suite's own is smooth ("used").
std::optional<Json> thermal_factor_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double L = get(in, "L"), S = get(in, "S"), p = get(in, "pOverE"), floor = get(in, "floor");
  const double raw = thermal_reduction_raw(L, S, p);
  return Json{{"murchWilson", thermal_reduction_rolling(L)},
              {"wilsonSheu", thermal_reduction_sliding(L, S)},
              {"guptaRaw", raw},
              {"gupta", std::max(raw, floor)},
              {"used", thermal_reduction(L, S, p, floor)}};
}

std::optional<Json> starvation_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double psi =
      starvation_parameter(get(in, "m"), get(in, "b"), get(in, "R"), get(in, "hFlooded"));
  return Json{{"psi", psi},
              {"phiFit", starvation_factor_cut(psi)},
              {"phiIntegral", starvation_factor_integral(psi)},
              {"used", starvation_factor(psi)}};
}

Json of_lubricant(const Json& in, double p, double T) {
  constexpr int kMostCodes = 1000;
  const Lubricant& oil = lubricant(whole(in, "kTrac", 1, kMostCodes));
  return {{"mu", oil.base_viscosity(T)},
          {"alpha", oil.base_alpha(T)},
          {"dlnmudT", -oil.base_beta(T)},
          {"muTraction", oil.viscosity_under_pressure(p, T)},
          {"betaTraction", oil.beta_under_pressure(p, T)},
          {"density", oil.density.at(T)},
          {"specificHeat", oil.specific_heat.at(T)},
          {"conductivity", oil.conductivity.at(T)},
          {"name", oil.name},
          {"provenance", oil.provenance},
          {"range", extrapolation_note(pressure_range(oil.code), p)}};
}

std::optional<Json> viscosity_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double p = get(in, "p"), T = get(in, "T");
  const std::string law = in.at("law");
  if (law == "lubricant") return of_lubricant(in, p, T);
  const auto value = [&](const char* key) {
    for (const char* block : {"params", "tait"})
      if (in.contains(block) && in.at(block).contains(key)) return get(in.at(block), key);
    return get(in, key);
  };
  const Viscosity viscosity = viscosity_law(law, value);
  Json out{{"mu", viscosity.at(p, T)}};
  if (law == "vogelScaling")
    out["volumeRatio"] =
        TaitVolume{value("K0p"), value("K00"), value("betaK"), value("aV"), value("TR")}.ratio(p,
                                                                                               T);
  return out;
}

std::optional<Json> newton_film_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string law = in.at("law");
  const double U = get(in, "U"), h = get(in, "h"), K = get(in, "K");
  if (law == "exponential") {
    const FilmShear film =
        film_shear_between_walls(get(in, "mua"), get(in, "mub"), get(in, "beta"), K, h, U);
    return Json{{"tau", film.stress},
                {"dTmid", film.hottest},
                {"heat", film.stress * U},
                {"qa", film.heat_a},
                {"qb", film.heat_b}};
  }
  if (law != "reciprocal") return std::nullopt;
  const Viscosity viscosity{
      TypeTwoViscosity{get(in, "mu0"), get(in, "alpha"), get(in, "beta"), get(in, "T0")}};
  const double p = get(in, "p");
  const FilmShear film = film_shear_any_viscosity([&](double T) { return viscosity.at(p, T); },
                                                  get(in, "T1"), K, h, U);
  return Json{{"tau", film.stress}, {"dTmid", film.hottest}};
}

std::optional<Json> shear_thinning_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const ShearThinningStress stress =
      shear_thinning_stress({get(in, "h"), get(in, "mu"), get(in, "G"), get(in, "n"), get(in, "a"),
                             get(in, "beta"), get(in, "K")},
                            get(in, "U"));
  return Json{{"tauIsothermal", stress.isothermal},
              {"tauThermal", stress.thermal},
              {"dTmid", stress.hottest}};
}

std::optional<Json> strip_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string law = in.at("kind");
  if (law != "sinh" && law != "atanh") return std::nullopt;
  const ViscoElasticStrip strip{law == "sinh",    get(in, "b"),         get(in, "p0"),
                                get(in, "h"),     get(in, "rollSpeed"), get(in, "mu0"),
                                get(in, "alpha"), get(in, "lnMuCap"),   get(in, "G0"),
                                get(in, "Gp"),    get(in, "tau0"),      get(in, "tau0p")};
  constexpr int kCells = 1280;
  Json kappa = Json::array();
  for (const Json& slip : in.at("slip"))
    kappa.push_back(strip_coefficient(strip, std::abs(slip.get<double>()), kCells, true));
  return Json{{"kappa", std::move(kappa)}};
}

std::optional<Json> flash_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  FlashStrip strip;
  strip.half_length = get(in, "b");
  strip.peak_pressure = get(in, "p0");
  strip.thickness = get(in, "h");
  strip.speed_a = get(in, "ua");
  strip.speed_b = get(in, "ub");
  strip.temperature_a = get(in, "Ta0");
  strip.temperature_b = get(in, "Tb0");
  strip.viscosity = get(in, "muStar");
  strip.reference = get(in, "Tref");
  strip.alpha = get(in, "alphaStar");
  strip.beta = get(in, "betaStar");
  strip.conductivity = get(in, "K");
  strip.effusivity2_a = get(in, "kRhoCa");
  strip.effusivity2_b = get(in, "kRhoCb");
  constexpr int kCells = 400;
  const FlashResult result = flash_strip(strip, kCells);
  return Json{{"forcePerWidth", result.force},
              {"heatA", result.heat_a},
              {"heatB", result.heat_b},
              {"flashMaxA", result.flash_a},
              {"flashMaxB", result.flash_b}};
}

}  // namespace

std::vector<Adapter> film_adapters() {
  return {{"tribology_film", film_case},
          {"tribology_thermalFactor", thermal_factor_case},
          {"tribology_starvation", starvation_case},
          {"tribology_viscosity", viscosity_case},
          {"tribology_newtonFilm", newton_film_case},
          {"tribology_shearThinningFilm", shear_thinning_case},
          {"tribology_viscoelasticStrip", strip_case},
          {"tribology_flashStrip", flash_case}};
}

}  // namespace adore::calculators

#include "design/calculator_inputs.hpp"

#include "bearing/material.hpp"
#include "contact/groove.hpp"
#include "contact/roller_shape.hpp"
#include "statics/contact_films.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace adore::design {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::array<const char*, 2> kRaces{"outer race", "inner race"};

Json film_of_ball(const runs::Prepared& p, const statics::LubricantFilms& films, std::size_t k,
                  std::size_t j) {
  const statics::StaticBall& ball = p.statics.balls[k];
  if (!(ball.Q[j] > 0.0)) return nullptr;
  const double rolling =
      contact::race_curvature(p.bearing.balls(), static_cast<int>(j), std::abs(ball.alpha[j]))
          .along_minor;
  return {{"kind", "hamrock_dowson_hard_ehl"},
          {"inputs",
           {{"formula", "hamrockDowson"},
            {"mu0", films.viscosity[j]},
            {"alpha", films.alpha[j]},
            {"u", films.race[j][k].speed},
            {"Eprime", 2.0 * bearing::contact_modulus(p.bearing.element_material,
                                                      p.bearing.race_material[j])},
            {"Rx", 1.0 / rolling},
            {"load", ball.Q[j]},
            {"k", ball.a[j] / ball.b[j]}}}};
}

/// Sum of the curvatures of roller and race along the rolling direction [1/m].
double rolling_curvature(const bearing::RollerGeometry& g, std::size_t k, std::size_t j) {
  const int race = static_cast<int>(j);
  return contact::roller_race_curvature(
             g, contact::roller_profile(g, g.deviation_of(static_cast<int>(k))), race,
             g.race_profile_radius(j))
      .rolling;
}

Json film_of_roller(const runs::Prepared& p, const statics::LubricantFilms& films, std::size_t k,
                    std::size_t j) {
  const statics::RollerRaceContact& at = p.rollers->rollers[k].race[j];
  if (!(at.load > 0.0 && at.length > 0.0)) return nullptr;
  const bearing::RollerGeometry& g = *p.bearing.rollers();
  const double rolling = rolling_curvature(g, k, j);
  Json inputs{{"mu0", films.viscosity[j]},
              {"alpha", films.alpha[j]},
              {"u", films.race[j][k].speed},
              {"Eprime", 2.0 * bearing::contact_modulus(p.bearing.element_material,
                                                        p.bearing.race_material[j])}};
  if (at.slice_load.empty()) {
    inputs["formula"] = "hamrockDowson";
    inputs["Rx"] = 1.0 / rolling;
    inputs["load"] = at.load;
    inputs["k"] = at.half_width > 0.0 ? 0.5 * at.length / at.half_width : 1.0;
    return {{"kind", "hamrock_dowson_hard_ehl"}, {"inputs", inputs}};
  }
  inputs["formula"] = "line";
  inputs["R"] = 1.0 / rolling;
  inputs["loadPerLength"] = at.load / at.length;
  return {{"kind", "line_contact_load_per"}, {"inputs", inputs}};
}

Json hertz_of_ball(const runs::Prepared& p, std::size_t k, std::size_t j) {
  const statics::StaticBall& ball = p.statics.balls[k];
  if (!(ball.Q[j] > 0.0)) return nullptr;
  const double radius = 0.5 * p.bearing.balls().diameter;
  const auto sum =
      contact::race_curvature(p.bearing.balls(), static_cast<int>(j), std::abs(ball.alpha[j]));
  const auto body = [](const bearing::Material& m, double Rx, double Ry) {
    return Json{{"Rx", Rx}, {"Ry", Ry}, {"E", m.elastic_modulus}, {"nu", m.poisson_ratio}};
  };
  return {{"body1", body(p.bearing.element_material, radius, radius)},
          {"body2", body(p.bearing.race_material[j], 1.0 / (sum.along_minor - 1.0 / radius),
                         1.0 / (sum.along_major - 1.0 / radius))},
          {"load", ball.Q[j]},
          {"stress_poisson", p.bearing.race_material[j].poisson_ratio}};
}

Json line_of_roller(const runs::Prepared& p, std::size_t k, std::size_t j) {
  const statics::RollerRaceContact& at = p.rollers->rollers[k].race[j];
  if (!(at.load > 0.0 && at.length > 0.0)) return nullptr;
  const bearing::RollerGeometry& g = *p.bearing.rollers();
  const double radius = 0.5 * g.diameter;
  // Curvature of the race, < 0 of a hollow one, out of that of both bodies.
  const double race = rolling_curvature(g, k, j) - 1.0 / radius;
  const bearing::Material& roller = p.bearing.element_material;
  const bearing::Material& ring = p.bearing.race_material[j];
  return {{"load", at.load},
          {"length", at.length},
          {"body1", {{"R", radius}, {"E", roller.elastic_modulus}, {"nu", roller.poisson_ratio}}},
          {"body2", {{"R", 1.0 / race}, {"E", ring.elastic_modulus}, {"nu", ring.poisson_ratio}}},
          {"stress_poisson", ring.poisson_ratio}};
}

}  // namespace

Json calculator_inputs(const runs::Prepared& p, const std::string& calculator, int element) {
  Json whole = bearing_calculator_inputs(p, calculator);
  if (!whole.is_null()) return whole;
  const int count = p.bearing.element_count();
  if (element < 1 || element > count)
    throw InputError(
        fmt::format("there is no element {}; the bearing has elements 1 to {}", element, count));
  const auto k = static_cast<std::size_t>(element) - 1;
  Json out = Json::object();
  if (calculator == "film") {
    if (!p.bearing.lubrication)
      throw InputError(
          "the deck has no lubricant between elements and races; set kTrac to the code of a "
          "lubricant");
    const statics::LubricantFilms films = p.rollers ? statics::contact_films(p.bearing, *p.rollers)
                                                    : statics::contact_films(p.bearing, p.statics);
    for (std::size_t j = 0; j < 2; ++j)
      out[kRaces[j]] = p.rollers ? film_of_roller(p, films, k, j) : film_of_ball(p, films, k, j);
    return out;
  }
  if (calculator == "line-contact") {
    if (!p.rollers)
      throw InputError("the calculator \"line-contact\" needs the deck of a roller bearing");
    for (std::size_t j = 0; j < 2; ++j) out[kRaces[j]] = line_of_roller(p, k, j);
    return out;
  }
  if (calculator != "hertz")
    throw InputError(fmt::format(
        "the calculator \"{}\" does not accept a deck. The calculators that accept a deck are: {}",
        calculator, fmt::join(deck_calculators(), ", ")));
  if (p.rollers)
    throw InputError(
        "the calculator \"hertz\" needs the deck of a ball bearing. For a roller bearing, use the "
        "calculator \"line-contact\"");
  for (std::size_t j = 0; j < 2; ++j) out[kRaces[j]] = hertz_of_ball(p, k, j);
  return out;
}

}  // namespace adore::design

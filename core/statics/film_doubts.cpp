#include "statics/film_doubts.hpp"

#include "base/validity.hpp"
#include "statics/deck_fault.hpp"
#include "tribology/viscosity/glass.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::statics {
namespace {

constexpr const char* kRaceName[] = {"outer", "inner"};

/// Upper bound of a range of the register of validity.
double most(const char* id) { return validity::range(id).bounds.most; }

bool glass(double viscosity) {
  return !(viscosity < 0.99 * std::exp(tribology::kLogGlassViscosity));
}

[[noreturn]] void refuse(const std::string& flag, const std::string& why) {
  throw DeckFault(flag, why,
                  fmt::format("enter the operating temperatures (record 9.1.3), choose a less "
                              "viscous lubricant (kTrac), or set {} = 0",
                              flag));
}

std::string at(const std::string& oil, double temperature, const std::string& place) {
  return fmt::format("{} at {:.4g} K ({})", oil, temperature, place);
}

/// Value and bound in the unit of the range [SI here].
Finding beyond(const char* code, const char* range, std::string text, double value) {
  const double per = validity::range(range).per;
  return make_finding(code, std::move(text)).measure(value / per, most(range) / per);
}

Finding beyond_measured(const std::string& oil, double viscosity) {
  return beyond(
      "film.viscosity", "film.viscosity",
      fmt::format("{} has a calculated viscosity of {:.3g} Pa s, above the measured range (up to "
                  "about {:g} Pa s). Films, friction and heat are extrapolated",
                  oil, viscosity, most("film.viscosity")),
      viscosity);
}

}  // namespace

std::vector<Finding> film_doubts(const LubricantFilms& films, FilmUse use) {
  std::vector<Finding> out;
  if (!(films.meniscus > 0.0)) return out;
  for (std::size_t j = 0; j < 2; ++j) {
    const double ratio = films.thickest[j];
    if (use == FilmUse::Equilibrium && !(ratio > 0.0)) continue;
    const std::string race = fmt::format("{} race", kRaceName[j]);
    const std::string oil = at(films.lubricant, films.temperature[j], "inlet of the " + race);
    if (glass(films.viscosity[j]))
      refuse("kTrac", oil +
                          " is a glass (viscosity of at least 1e12 Pa s): no film forms, and the "
                          "traction is unknown");
    if (ratio > most("film.separation")) {
      const std::string why = fmt::format(
          "{} is so thick ({:.3g} Pa s) that the film thickness would be {:.2g} times the radius "
          "of the contacting bodies. The film formulas and the contact model are valid only for "
          "films much thinner than this radius",
          oil, films.viscosity[j], ratio);
      if (use != FilmUse::ThermalSteps) refuse("kTrac", why);
      out.push_back(beyond("film.separation", "film.separation",
                           why + ". The heat and all results that depend on the oil cannot be "
                                 "trusted until thermal steps have warmed the oil. Start closer to "
                                 "the expected temperatures (record 9.1.3)",
                           ratio)
                        .of(race));
    } else if (ratio > most("film.thickness"))
      out.push_back(
          beyond("film.thick", "film.thickness",
                 fmt::format("{} forms a film whose thickness is {:.2g} times the radius of the "
                             "contacting bodies, but film formulas are known only up to {:g} times "
                             "this radius. Films, lambda, friction and heat are rough estimates",
                             oil, ratio, most("film.thickness")),
                 ratio)
              .of(race));
    if (films.viscosity[j] > most("film.viscosity"))
      out.push_back(beyond_measured(oil, films.viscosity[j]).of(race));
  }
  return out;
}

std::optional<Finding> oil_flow_warning(const std::string& flag, const std::string& oil,
                                        double temperature, double viscosity,
                                        const std::string& place) {
  const std::string text = at(oil, temperature, place);
  if (glass(viscosity))
    refuse(flag, text + " is a glass (viscosity of at least 1e12 Pa s) and does not flow");
  if (!(viscosity > most("film.viscosity"))) return std::nullopt;
  return beyond_measured(text, viscosity);
}

}  // namespace adore::statics

#include "statics/film_doubts.hpp"

#include "base/validity.hpp"
#include "statics/deck_fault.hpp"
#include "tribology/viscosity/glass.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::statics {
namespace {

constexpr const char* kRace[] = {"outer", "inner"};

/// Upper bound of a range of the register of validity.
double most(const char* id) { return validity::range(id).bounds.most; }

bool glass(double viscosity) {
  return !(viscosity < 0.99 * std::exp(tribology::kLogGlassViscosity));
}

[[noreturn]] void refuse(const std::string& flag, const std::string& why) {
  throw DeckFault(flag, why,
                  fmt::format("give the temperatures that the bearing runs at (record 9.1.3), a "
                              "thinner lubricant (kTrac), or {} = 0",
                              flag));
}

std::string at(const std::string& oil, double temperature, const std::string& place) {
  return fmt::format("{} at {:.4g} K, {},", oil, temperature, place);
}

std::string beyond_measured(double viscosity) {
  return fmt::format(
      " has {:.3g} Pa s by its law, beyond what is measured (some {:g} Pa s): films, friction and "
      "heat are extrapolations",
      viscosity, most("film.viscosity"));
}

}  // namespace

std::vector<std::string> film_doubts(const LubricantFilms& films, FilmsOf use) {
  std::vector<std::string> out;
  if (!(films.meniscus > 0.0)) return out;
  for (std::size_t j = 0; j < 2; ++j) {
    const double ratio = films.thickest[j];
    if (use == FilmsOf::Equilibrium && !(ratio > 0.0)) continue;
    const std::string oil = at(films.lubricant, films.temperature[j],
                               fmt::format("the inlet of the {} race", kRace[j]));
    if (glass(films.viscosity[j]))
      refuse("kTrac",
             oil + " is a glass (1e12 Pa s): it makes no film, and its traction is unknown");
    if (ratio > most("film.separation")) {
      const std::string why = fmt::format(
          "{} is so thick ({:.3g} Pa s) that its film would be {:.2g} of the radius of the bodies "
          "that it parts: formulas of films, and the contacts themselves, end far below",
          oil, films.viscosity[j], ratio);
      if (use != FilmsOf::ThermalSteps) refuse("kTrac", why);
      out.push_back(why +
                    ". Until thermal steps have warmed it, results that depend on this oil, "
                    "its heat included, cannot be trusted. Start nearer to the expected "
                    "temperatures (record 9.1.3)");
    } else if (ratio > most("film.thickness"))
      out.push_back(fmt::format(
          "{} makes a film of {:.2g} of the radius of the bodies that it parts, where formulas of "
          "films are known up to {:g}: films, lambda, friction and heat are rough there",
          oil, ratio, most("film.thickness")));
    if (films.viscosity[j] > most("film.viscosity"))
      out.push_back(oil + beyond_measured(films.viscosity[j]));
  }
  return out;
}

std::string flow_doubt(const std::string& flag, const std::string& oil, double temperature,
                       double viscosity, const std::string& place) {
  const std::string text = at(oil, temperature, place);
  if (glass(viscosity)) refuse(flag, text + " is a glass (1e12 Pa s) and does not flow");
  return viscosity > most("film.viscosity") ? text + beyond_measured(viscosity) : std::string();
}

}  // namespace adore::statics

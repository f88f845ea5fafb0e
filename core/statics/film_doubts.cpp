#include "statics/film_doubts.hpp"

#include "base/errors.hpp"
#include "tribology/viscosity/glass.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::statics {
namespace {

constexpr const char* kRemedy =
    "give the temperatures that the bearing runs at (record 9.1.3), a thinner lubricant "
    "(record 10.0), or kTrac = 0";
constexpr const char* kRace[] = {"outer", "inner"};

}  // namespace

std::vector<std::string> film_doubts(const LubricantFilms& films) {
  std::vector<std::string> out;
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string oil = fmt::format("{} at {:.4g} K, the inlet of the {} race", films.lubricant,
                                        films.temperature[j], kRace[j]);
    if (!(films.viscosity[j] < 0.99 * std::exp(tribology::kLogGlassViscosity)))
      throw SolverError(fmt::format(
          "{}, is a glass (1e12 Pa s): it makes no film, and nothing is known of its traction; {}",
          oil, kRemedy));
    const double ratio = films.thickest[j];
    if (ratio > kNoFilmAnyMore)
      throw SolverError(fmt::format(
          "{}, is so thick ({:.3g} Pa s) that its film would be {:.2g} of the radius of the bodies "
          "that it parts: formulas of films, and the contacts themselves, end far below; {}",
          oil, films.viscosity[j], ratio, kRemedy));
    if (ratio > kThickFilm)
      out.push_back(fmt::format(
          "{}, makes a film of {:.2g} of the radius of the bodies that it parts, where formulas of "
          "films are known up to some 0.001: films, lambda, friction and heat are rough there",
          oil, ratio));
    else if (films.viscosity[j] > kThickOil)
      out.push_back(fmt::format(
          "{}, has {:.3g} Pa s by its law, beyond what is measured (some {:g} Pa s): films, "
          "friction and heat are extrapolations",
          oil, films.viscosity[j], kThickOil));
  }
  return out;
}

}  // namespace adore::statics

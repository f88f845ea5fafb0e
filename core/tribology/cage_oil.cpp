#include "tribology/cage_oil.hpp"

#include "base/errors.hpp"
#include "tribology/lubricant.hpp"

namespace adore::tribology {

double cage_film_viscosity(const bearing::Bearing& bearing, double given) {
  if (given > 0.0) return given;
  demand(bearing.lubrication.has_value(), "cage films were requested, but there is no lubricant");
  return lubricant_of(*bearing.lubrication).base_viscosity(bearing.cage_temperature);
}

}  // namespace adore::tribology

#include "setup/user_lubricant.hpp"

namespace adore::setup {

bearing::UserLubricant user_lubricant(const deck::Deck& deck) {
  bearing::UserLubricant out;
  out.name = deck.text("lubName");
  out.T0 = deck.si("refTemp");
  out.viscosity = deck.si("refVis");
  out.alpha = deck.si("prVisCoeff");
  out.beta = deck.si("tempVisCoeff");
  out.conductivity = deck.si("lubTherCond");
  out.traction_viscosity = deck.si("refTracVis");
  out.traction_alpha = deck.si("tracVisCoeff1");
  out.traction_beta = deck.si("tracVisCoeff2");
  return out;
}

}  // namespace adore::setup

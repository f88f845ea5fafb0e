#include "runs/run_scales.hpp"

#include "base/errors.hpp"
#include "runs/prepare.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace adore::runs {

RunScales run_scales(const deck::Deck& deck, const std::map<std::string, std::string>& options) {
  if (deck.integer("mode") < 0)
    throw InputError("a quasi-static deck (mode < 0) does not have a time scale");
  LoadedDeck input;
  input.path = "deck";
  input.deck = deck;
  input.deck.set("kTherm", "0");  // steps of temperature leave the scale of the start alone
  input.deck.complete();
  input.option_values = options;
  const Prepared prepared = prepare(std::move(input));
  const double speed = prepared.bearing.speed[1] - prepared.bearing.speed[0];
  return {make_system(prepared).scales().time, std::abs(speed) / (2.0 * std::numbers::pi)};
}

}  // namespace adore::runs

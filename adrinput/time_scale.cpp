#include "adrinput/time_scale.hpp"

#include <exception>
#include <memory>

namespace adore::adrinput {

void TimeScale::ask(const deck::Deck& deck, const RunOptionValues& options) {
  if (busy()) return;
  auto scales = std::make_shared<std::optional<runs::RunScales>>();
  background_task_.start(
      [deck, options, scales](const std::stop_token&) {
        try {
          *scales = runs::run_scales(deck, options);
        } catch (const std::exception&) {
          scales->reset();  // the checks report the errors of the deck
        }
      },
      [this, deck, scales] {
        if (found) found(deck, *scales);
      });
}

}  // namespace adore::adrinput

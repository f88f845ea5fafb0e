#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Load, speed, oil and temperature of a new deck, as deck variables.
namespace adore::runs {

struct OperatingPoint {
  std::optional<double> radial, axial;  ///< appLoadZ, appLoadX [N]
  std::optional<double> speed;          ///< rpm2 [rpm]
  std::optional<double> temperature;    ///< of housing, shaft, races and elements [degrees Celsius]
  std::string oil;  ///< number (kTrac) or the beginning of a name ("FVA-3"); empty: as the deck
  [[nodiscard]] bool empty() const;
};

/// Names and SI values for Deck::set_all. @throws InputError for an unknown oil, listing all
[[nodiscard]] std::vector<std::pair<std::string, std::string>> deck_assignments(
    const OperatingPoint& point);

/// The text of an SI deck with these values; remarks stay. @throws InputError
[[nodiscard]] std::string with_operating_point(const std::string& text,
                                               const OperatingPoint& point);

}  // namespace adore::runs

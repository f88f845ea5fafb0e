#pragma once

#include "runs/prepare.hpp"
#include "studies/accuracy.hpp"

/// Settings that an accuracy study tries for a deck.
namespace adore::studies {

/// The deck's own settings first; then of every method, from the tightest tolerance to the loosest,
/// with the deck's longest step and with steps as long as contact vibrations allow.
[[nodiscard]] std::vector<AccuracySetting> trial_settings(const runs::Prepared& prepared,
                                                          const std::vector<std::string>& methods,
                                                          const std::vector<double>& tolerances);
/// @pre the list is not empty
[[nodiscard]] const AccuracySetting& deck_setting(const std::vector<AccuracySetting>& settings);

/// Resolutions and simplifications of the model that this deck can choose: quadrature nodes or
/// slices, Hertz constants, force balance instead of motion.
[[nodiscard]] std::vector<AccuracySetting> trial_model_settings(const runs::Prepared& prepared);

}  // namespace adore::studies

#pragma once

#include "results/accuracy_errors.hpp"
#include "runs/deck_request.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Stored study of model errors, which a run prints as long as it belongs to the deck.
namespace adore::runs {

struct ModelVariant {
  std::string group;  ///< "damping"
  std::string name;   ///< "contactDamping = 2x"
  std::string range;  ///< of the uncertainty, with its provenance
  std::vector<std::pair<std::string, std::string>> sets, options;
};

struct ModelRow {
  ModelVariant variant;
  results::AccuracyErrors change;  ///< relative
  double heat = 0.0, life = 0.0;   ///< relative, with sign; NaN: not computed
  double seconds = 0.0;            ///< processor time
  std::string failure;             ///< empty, or why there is no result
};

struct ModelStudy {
  std::string stamp;   ///< of the deck, without numerical settings
  std::string deck;    ///< file name
  double turns = 0.0;  ///< of each run
  double seconds = 0.0;
  double heat = 0.0, life = 0.0;  ///< of the deck's own run [W, h]; NaN: not computed
  std::vector<ModelRow> rows;
  bool complete = false;
};

/// Of what is run, without tolerances, steps, output intervals and resolutions.
[[nodiscard]] std::string model_stamp(const LoadedDeck& deck);

[[nodiscard]] std::string model_table(const ModelStudy& study);
[[nodiscard]] std::string model_json(const ModelStudy& study);
/// @throws InputError when the text is not such a study
[[nodiscard]] ModelStudy read_model_study(const std::string& text, const std::string& name);

inline constexpr const char* kModelFile = "MODELS.json";
/// The study next to the deck, if it belongs to the present deck; damaged and other files count
/// as none.
[[nodiscard]] std::optional<ModelStudy> find_model_study(const LoadedDeck& deck);

}  // namespace adore::runs

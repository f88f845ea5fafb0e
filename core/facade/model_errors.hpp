#pragma once

#include "facade/accuracy.hpp"
#include "facade/prepare.hpp"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// Model errors next to numerical errors: what one choice of the model changes within its stated
/// uncertainty. Each row is the deck's run with one change, over the same span and from the same
/// kind of start; differences are those of accuracy.hpp, heat and life also with their sign. A run
/// under loads changed by 1e-6 shows what an irregular motion changes without any reason.
/// Limits: one change at a time (no interaction), the stated ranges only, a short span.
namespace adore::facade {

struct ModelVariant {
  std::string group;  ///< "damping"
  std::string name;   ///< "contactDamping = 2x"
  std::string range;  ///< of the uncertainty, with its provenance
  std::vector<std::pair<std::string, std::string>> sets, options;
};

struct ModelRow {
  ModelVariant variant;
  AccuracyErrors change;          ///< relative
  double heat = 0.0, life = 0.0;  ///< relative, with sign; NaN: not computed
  double seconds = 0.0;           ///< processor time
  std::string failure;            ///< empty, or why there is no result
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

/// Only what the deck uses: contact damping (factor 2), traction law of the oil (kTrac against
/// filmLaw = recommended) or dry race friction (factor 1.3), friction of the cage (50 %), nodes or
/// slices (twice as many), mode (the others of 0, 1, 2), thermal model (network against ladder).
[[nodiscard]] std::vector<ModelVariant> model_variants(const Prepared& prepared);

/// @param turns of each run at most; the deck's own end ends it earlier
/// @param budget processor time of all runs [s]; fewer revolutions if need be
/// @throws InputError (quasi-static deck), SolverError (the deck's own run fails)
[[nodiscard]] ModelStudy study_models(const DeckRequest& request, double turns, double budget,
                                      const std::function<void(const ModelRow&)>& row_done = {},
                                      std::stop_token stop = {});

/// Of what is run, without tolerances, steps, output intervals and resolutions.
[[nodiscard]] std::string model_stamp(const LoadedDeck& deck);

[[nodiscard]] std::string model_table(const ModelStudy& study);
[[nodiscard]] std::string model_json(const ModelStudy& study);
/// @throws InputError when the text is not such a study
[[nodiscard]] ModelStudy read_models(const std::string& text, const std::string& name);

inline constexpr const char* kModelFile = "MODELS.json";
/// The study next to the deck, if it belongs to the present deck; damaged and other files count
/// as none.
[[nodiscard]] std::optional<ModelStudy> models_beside(const LoadedDeck& deck);

}  // namespace adore::facade

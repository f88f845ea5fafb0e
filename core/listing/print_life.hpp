#pragma once

#include "life/accumulation.hpp"
#include "life/bearing_life.hpp"
#include "listing/report.hpp"

#include <nlohmann/json_fwd.hpp>

#include <limits>
#include <string>

/// Fatigue life in PRINT.txt and RUN.json. Every parameter carries the word for its origin, so that
/// what is calibrated or recalled never looks like a published constant.
namespace adore::listing {

/// "INFINITE", or seven significant digits.
[[nodiscard]] std::string format_life_value(double life);

/// Life accumulated over a dynamic run.
struct RunLife {
  life::DamageSum damage;
  long steps = 0;        ///< integration steps whose loads are in it
  long evaluations = 0;  ///< of the full life model
  double change = 0.0;   ///< StepDamageAccumulator::mean_calibration_change()
  std::size_t batches = 0;
  double revolutions_per_batch = 0.0;
  /// Standard error of the life over the life; NaN: too few batches.
  double relative_error = std::numeric_limits<double>::quiet_NaN();
  double skipped_turns = 0.0;  ///< of the shaft, before the window
  bearing::LifeModel model{};  ///< race of the summed lives
  bearing::LifeModification modification{};
  life::DamageParts slopes{1.0, 1.0, 1.0};  ///< Weibull, of the parts
};

/// Page "FATIGUE LIFE" of the quasi-static solution.
void print_life(Report& report, const life::BearingLife& life);
/// Section of the last page of a dynamic run.
void print_run_life(Report& report, const RunLife& run);

[[nodiscard]] nlohmann::ordered_json life_json(const life::BearingLife& life);
[[nodiscard]] nlohmann::ordered_json run_life_json(const RunLife& run);

/// "Gupta-Zaretsky type with STLE factors"
[[nodiscard]] std::string life_model_name(bearing::LifeModel model,
                                          bearing::LifeModification modification);
/// Words for where the constants of that life come from: "seen", "calibrated, recalled"; they go
/// with every printed life.
[[nodiscard]] std::string life_constants_origin(bearing::LifeModel model,
                                                bearing::LifeModification modification);

}  // namespace adore::listing

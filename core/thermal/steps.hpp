#pragma once

#include <optional>
#include <string>
#include <vector>

/// Thermal steps of a run: heat averaged over windows of time, and what the sequence of
/// temperatures tells. SI, kelvin.
namespace adore::thermal {

/// A window closes with the integration step that reaches aveTime; steps are not split.
class HeatWindow {
 public:
  /// @param geometry_every kGeoMod: geometry follows every so many thermal steps; 0: never
  HeatWindow(double average_time, double skip_time, int geometry_every)
      : average_time_(average_time), skip_time_(skip_time), geometry_interval_(geometry_every) {}

  struct ClosedWindow {
    int step = 0;
    double time = 0.0;          ///< of its end [s]
    double average_heat = 0.0;  ///< [W]
    bool geometry_update = false;
  };
  /// One integration step that ends at `time`, with the mean heat `power` over it.
  [[nodiscard]] std::optional<ClosedWindow> add(double time, double step, double power);

 private:
  double average_time_, skip_time_;
  int geometry_interval_;
  double energy_ = 0.0, window_time_ = 0.0;
  int steps_ = 0;
};

/// After each thermal step, in this order [choice]: a node above the limit: divergent; largest
/// change below the tolerance for so many steps in a row: stable; change growing, and not below the
/// tolerance, for so many steps in a row: divergent; else undecided.
struct ThermalStepCriteria {
  double tolerance = 0.5;  ///< [K]
  int converged = 3, divergent = 4;
  std::optional<double> limit;  ///< [K]
};
enum class StepVerdict : unsigned char { Undecided, Stable, Divergent };

struct ThermalStepAssessment {
  StepVerdict verdict = StepVerdict::Undecided;
  int step = 0;        ///< of the decision, or the last one
  std::string reason;  ///< "converged", "growth", "limit", "end"
  /// Median of the last (up to) four ratios of successive changes: R_th dQ/dT, unstable above 1.
  std::optional<double> gain;
  /// Limit of the first node after Aitken, from its last three values.
  std::optional<double> first_node_limit;
};
/// @param temperatures [step][node], from the start on; all steps of one length
[[nodiscard]] ThermalStepAssessment assess_thermal_steps(
    const std::vector<std::vector<double>>& temperatures, const ThermalStepCriteria& rules);

}  // namespace adore::thermal

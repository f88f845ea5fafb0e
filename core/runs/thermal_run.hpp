#pragma once

#include "base/finding.hpp"
#include "runs/prepare.hpp"
#include "scene/snapshot.hpp"
#include "thermal/bearing_heat.hpp"
#include "thermal/relaxation.hpp"
#include "thermal/steps.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// The thermal analysis of a run in time (kTherm = 1, mode 0 to 2): a window of aveTime closes with
/// the counted step that reaches it; the heat of the window, from the energy ledger, goes through
/// the network; oil, medium and materials follow at once, geometry at every kGeoMod-th thermal step
/// after skipTime. The network has no heat capacity: thermal steps are iterates towards a steady
/// state, not a warming-up in time. Where heat falls as the oil warms, full steps would overshoot
/// and alternate: the parts go the relaxed way (relaxation.hpp, factor 0.2 to 1), and what is shown
/// is the network's answer to the mean heat of the window, whose balance is closed at every step.
/// Windows shorter than the passing of an element see fluctuating heat: the factor then goes down
/// to 0.3 window/passing, at least 0.02, so that temperatures follow the mean of passings [choice].
namespace adore::runs {

class ThermalRun {
 public:
  /// A prepared dynamic deck with a thermal analysis.
  explicit ThermalRun(const Prepared& prepared);

  /// Begins the first window.
  void start(double time, const scene::EnergyLedger& energy);
  [[nodiscard]] bool due(double time) const noexcept;

  struct Step {
    thermal::BearingHeat heat;
    int number = 0;
    bool geometry = false;  ///< changes with this step
    thermal::ThermalStepAssessment judged;
    double passing = 0.0;  ///< of one element, at the mean orbital speed; 0: they rest [s]
    double window = 0.0;   ///< [s]
  };
  /// Closes the window at this instant. @throws SolverError where temperatures run away, or heat
  /// finds no way. Changes that grow are judged, not thrown: heat may grow for other reasons.
  /// @param contact conductances of the race contacts at the present equilibrium
  [[nodiscard]] Step close(const scene::Snapshot& at, const thermal::RaceConductance& contact);
  /// The bearing at work after the last step.
  [[nodiscard]] bearing::Bearing operating() const;

  /// Race speeds at which the rings grow from now on [rad/s].
  void set_speed(const std::array<double, 2>& speed) noexcept { as_built_bearing_.speed = speed; }

  [[nodiscard]] const scene::ThermalSnapshot& shown() const noexcept { return shown_; }
  [[nodiscard]] const thermal::BulkTemperatures& bulk() const noexcept {
    return part_temperatures_;
  }
  [[nodiscard]] int steps() const noexcept { return steps_; }
  [[nodiscard]] bool settled() const noexcept { return settled_; }
  /// Node outside the range of the network in the last step, in words; empty: none.
  [[nodiscard]] const std::string& hot() const noexcept { return overheated_node_; }
  /// The last steps are an answer to the mean heat, no longer of a cold start.
  [[nodiscard]] bool has_mean_temperatures() const noexcept;

  /// For MASTER, and back; false: there is nothing of a thermal analysis.
  void save(std::map<std::string, double>& state) const;
  /// @throws InputError naming `file` for values that no run leaves
  bool restore(const std::map<std::string, double>& state, const std::filesystem::path& file);

 private:
  [[nodiscard]] thermal::HeatSources sources(const scene::EnergyLedger& energy) const;
  void show(const thermal::BearingHeat& heat);

  bearing::Bearing as_built_bearing_;
  thermal::BulkTemperatures part_temperatures_,
      geometry_temperatures_;               ///< of the parts; of the present geometry
  double window_start_time_ = 0.0;          ///< of the window [s]
  thermal::HeatSources window_start_heat_;  ///< heat until then [J]
  int steps_ = 0;
  bool settled_ = false;
  std::string overheated_node_;
  thermal::Relaxation::Field mean_residual_{};  ///< mean residual of the last steps [K]
  thermal::Relaxation relaxation_;
  bool transient_;                            ///< heat capacities act
  double thermal_time_ratio_;                 ///< thermal over mechanical time
  std::vector<double> node_state_;            ///< of the network, in a transient [K]
  std::vector<std::vector<double>> history_;  ///< of the last steps, as far as they are judged
  scene::ThermalSnapshot shown_;
};

/// Conductances of the race contacts at the equilibrium of the present geometry and oil.
[[nodiscard]] thermal::RaceConductance race_conductance(const Prepared& prepared);

/// A prepared dynamic deck whose bearing now is `operating`: races and elements in the equilibrium
/// of this geometry. @throws SolverError when there is none, or the oil has become a glass
/// @return what is to be doubted of its films
std::vector<Finding> move_to(Prepared& prepared, bearing::Bearing operating);

}  // namespace adore::runs

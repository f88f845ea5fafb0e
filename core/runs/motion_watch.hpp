#pragma once

#include "base/finding.hpp"
#include "base/validity.hpp"
#include "bearing/bearing.hpp"
#include "life/contact_strength.hpp"
#include "results/quantities.hpp"
#include "scene/snapshot.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Limits that a motion may exceed without ending, checked at the stored steps (F118):
///   contact ellipses of balls that extend beyond the shoulder of a race,
///   race contacts under which race or element yields (life/contact_strength.hpp),
///   pockets and guide lands under which the cage yields (cageESL): c p above the elastic limit, p
///   the largest Hertz pressure of a ball in its pocket, the pressure of the mean load per length
///   of a roller at a face of its pocket, or the largest pressure of the elastic foundation of a
///   land, ends of cage segments that overlap, which nothing prevents (N106),
///   a one-piece cage whose center is further from the axis of a race than half its diametral
///   clearance to that race (cageCls1, cageCls2), where no land stops it.
/// Each is reported once, with the worst of all stored steps. Times between them are not checked.
namespace adore::runs {

class MotionLimitMonitor {
 public:
  explicit MotionLimitMonitor(const bearing::Bearing& bearing);
  void check(const scene::Snapshot& at);
  /// Empty: no limit was passed.
  [[nodiscard]] std::vector<Finding> findings(results::UnitSystem units) const;
  /// For the register of validity, range "cage.yield".
  [[nodiscard]] std::optional<validity::Finding> cage_yield_finding() const;

 private:
  struct WorstExceedance {
    double value = 0.0, time = 0.0;
    std::size_t element = 0;  ///< from 1, 0: none
    std::size_t steps = 0;    ///< in which the limit was passed
    std::string where;
  };
  void check_cage(const scene::Snapshot& at);
  void check_races(const scene::Snapshot& at);
  /// Pressure in the pocket of one element, and its von Mises stress [Pa].
  [[nodiscard]] double pocket_pressure(const scene::PocketContactSnapshot& contact) const;

  bearing::Bearing bearing_;
  life::MaxPressureContacts heaviest_contacts_{};
  std::array<double, 2> heaviest_contact_times_{};
  std::array<WorstExceedance, 2> worst_shoulder_excess_;
  WorstExceedance worst_cage_stress_, worst_segment_overlap_;
  std::array<WorstExceedance, 2>
      worst_cage_offset_;  ///< cage in a race that does not guide it, center to axis [m]
  double worst_cage_pressure_ = 0.0,
         cage_elastic_limit_ = 0.0;  ///< of the worst; of the material [Pa]
  double point_stress_ratio_ = 0.0,
         line_stress_ratio_ = 0.0;  ///< von Mises stress in the cage over pressure
  /// Of a ball in its pocket: patch over F^(2/3) [m²/N^(2/3)], and the force beyond which it no
  /// longer grows [N]; 0: none.
  double pocket_patch_factor_ = 0.0, pocket_load_cap_ = 0.0;
};

}  // namespace adore::runs

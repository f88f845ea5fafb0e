#pragma once

#include "results/batch_means.hpp"
#include "results/mean_errors.hpp"
#include "scene/snapshot.hpp"

#include <map>
#include <span>
#include <string>

/// Time averages over a whole run (printed section 4, N54): each speed over that of the inner race
/// relative to the outer.
namespace adore::results {

struct Averages {
  double time = 0.0;               ///< span of the average [s]
  double orbital_ratio = 0.0;      ///< mean orbital speed of the elements
  double cage_ratio = 0.0;         ///< cage speed about its own axis
  double whirl_ratio = 0.0;        ///< speed of the cage's mass center about the bearing axis
  double swept_whirl_ratio = 0.0;  ///< the same by the area that it sweeps, see RunAverages
  double power_loss = 0.0;         ///< [W]
  double largest_load = 0.0;  ///< mean over time of the largest contact load at each instant [N]
  double peak_load = 0.0;     ///< the largest contact load at all looks [N]
  double largest_residual = 0.0;           ///< of energy, in size, at all instants [J]
  scene::Vec3 load = scene::Vec3::Zero();  ///< of the inner race against its contacts
                                           ///< [N], base frame
};

/// Accumulates them. All but the whirl come from angles and heats that the run itself integrates,
/// so they are exact for any interval between the snapshots; the whirl angle needs at least two
/// positions per revolution of the whirl. A ratio is 0 while the races have not turned against each
/// other; before the first span ends the loss and the loads are those of the first snapshot. The
/// largest contact load is a trapezoidal mean over all its samples (snapshots, and add_loads()
/// after each integration step), and its peak is that of the samples: sampled by steps, not
/// integrated by the run. The reaction on the inner race is such a mean over the snapshots.
///
/// Two whirls, with (y, z) the cage's mass center, r its distance from the bearing axis, θ about +X
/// from Z and Ω the mean speed of the inner race relative to the outer:
///   whirl_ratio        (θ(end) - θ(start)) / ∫ dt / Ω, as the manual has it (4.1.12): windings. A
///                      path that passes the axis on its other side has one winding more or less,
///                      a step of 2π / (Ω ∫ dt) that no change of the path made.
///   swept_whirl_ratio  ∫ (y dz - z dy) / ∫ r² dt / Ω = ∫ r² θ̇ dt / ∫ r² dt / Ω: twice the area
///                      swept over the mean square of the radius. Continuous in the path, however
///                      close it passes the axis; of a circle about the axis the same as windings.
/// The second is summed over the samples of the center, areas of triangles and the square by
/// trapezoids: a circle sampled in steps of the angle φ has sin φ / φ of its whirl, 1 - φ²/6 (1e-5
/// below at 800 samples per revolution of the whirl). It is 0 for a center that never left the
/// axis.
class RunAverages {
 public:
  void add(const scene::Snapshot& snapshot);
  /// Only the cage's mass center, that of all segments together, for steps that make no snapshot
  /// [s, m].
  void add_cage_position(double time, const scene::Vec3& position);
  /// Only the contact loads, for steps that make no snapshot: of all elements at the outer and at
  /// the inner race [N].
  void add_loads(double time, std::span<const double> outer, std::span<const double> inner);
  [[nodiscard]] Averages averages() const;
  [[nodiscard]] MeanSeries series() const;
  [[nodiscard]] MeanErrors errors() const { return errors_of(series()); }

  /// For MASTER, and back. restore() leaves the object as new when the map holds no averages.
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);

 private:
  struct Totals {
    double time = 0.0, shaft = 0.0, elements = 0.0, cage = 0.0,
           heat = 0.0;                  ///< [s, rad, rad, rad, J]
    std::array<double, 2> race_heat{};  ///< [J]
  };
  static Totals totals(const scene::Snapshot& snapshot);
  void add_max_load(double time, double largest);
  template <class Self, class Visit>
  static void visit(Self& self, Visit visit);

  bool started_ = false, whirl_started_ = false;
  Totals start_, last_totals_;
  double whirl_start_angle_ = 0.0,
         whirl_angle_ = 0.0;  ///< continuous azimuth of the cage's mass center [rad]
  double power_loss_ = 0.0;   ///< of the last snapshot [W]
  bool has_last_center_ = false;
  double last_center_time_ = 0.0, last_center_y_ = 0.0,
         last_center_z_ = 0.0;  ///< of the last look [s, m]
  double swept_area_ = 0.0,
         radius_squared_integral_ = 0.0;       ///< ∫ (y dz - z dy), ∫ r² dt [m², m² s]
  scene::Vec3 force_ = scene::Vec3::Zero();    ///< on the inner race, last snapshot [N]
  scene::Vec3 impulse_ = scene::Vec3::Zero();  ///< its time integral [N s]
  double max_load_time_ = 0.0;                 ///< of the last look [s]
  double max_load_ = 0.0;                      ///< contact load then [N]
  double max_load_integral_ = 0.0;             ///< its time integral [N s]
  double peak_load_ = 0.0;                     ///< [N]
  /// Of the stored steps: shaft, elements, cage [rad], heat in all, of the outer and of the inner
  /// race [J], impulse [N s]. Of every step: impulse of the largest load. Of looks at the cage:
  /// area and square that its center sweeps.
  BatchSums<9> stored_step_sums_;
  BatchSums<1> step_sums_;
  BatchSums<2> whirl_sums_;
  bool race_heat_known_ = true;  ///< false: MASTER of an earlier release, until the next look
  double residual_ = 0.0;        ///< [J]
};

}  // namespace adore::results

#pragma once

#include "bearing/given_surface.hpp"
#include "contact/race_errors.hpp"
#include "contact/roller_race.hpp"
#include "dynamics/effect.hpp"
#include "dynamics/effects/race_account.hpp"
#include "dynamics/user_points.hpp"
#include "statics/roller_kernel.hpp"
#include "tribology/laws/rolling_resistance.hpp"
#include "tribology/traction_law.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Rollers on their races, slice by slice (contact/roller_race.hpp): surfaces, slices and constants
/// are those of the equilibrium (statics/roller_model.hpp), so that its loads are those of the
/// start. The force on a roller acts at its middle C = G - s_G a with the moment about it; about
/// the mass centre M_G = M_C + (C - G) × F. The race gets the opposite wrench.
///
/// A race with errors (contact/race_errors.hpp) is taken for each roller as it is at the azimuth ψ
/// of C in the race, which turns: U = Σ 9/19 Q δ depends on ψ too, and -∂U/∂ψ/r acts on the roller
/// at C along growing ψ, the opposite on the race. Its power is that of -dU/dt, so that the work of
/// the drive balances. Left out is the curvature of a wave under one roller.
/// Surfaces that vary across or jump over the turn are tables (setup/surface_table.hpp): slice k
/// meets a race that is farther by w_k(ψ), and ∂U/∂ψ = -Σ Q_k ∂w_k/∂ψ.
/// A roller that is out of round by h(s, ψ) = c + s t (routine ADRX5) meets a race that is nearer
/// by h: ψ is the azimuth in the roller's frame, about its axis a from its z axis, of the direction
/// d from C to the race (d = e_r outer, -e_r inner), so that the contact follows the turn of the
/// roller. With p² = a_x² + a_y² in the meridian frame (x, y, e_r), the gradient of U over position
/// and attitude acts besides [derived]:
///   on the roller  F_y = U_ψ a_x/(p² r),  M_C = U_ψ (a_x, a_y, 0)/p²,   U_ψ = -Σ Q_k ∂h_k/∂ψ,
/// the opposite on the race, whose sum about its axis is zero: a smooth race of revolution feels no
/// torque of a cam. Left out: the curvature of the lobes under the contact, h in pockets and at
/// flanges. Limit: a roller presses by less than its radius; whole numbers of waves per turn.
namespace adore::dynamics {

/// Constants of the contacts of all rollers with one race.
struct RollerRaceModel {
  bearing::Race race = bearing::kOuter;
  std::vector<contact::RollerRaceSlices> slices;          ///< one for all, or one by roller
  std::optional<contact::WavyRace> wavy;                  ///< errors of the race
  std::shared_ptr<const bearing::SurfaceSeries> surface;  ///< a table in their place; else null
  std::vector<std::optional<contact::WavyRace>> lobes;    ///< by roller, out of round; empty: none
  double mass_offset = 0.0;                               ///< s_G [m]
  double load_limit = 0.0;                                ///< [N]
  bool traction = true;
  tribology::TractionLaw law;
  std::string approximation_note;        ///< of its films, as SceneEffect::approximation_note
  tribology::RollingResistance rolling;  ///< of the oil, where the scene has it

  /// Is the rolling resistance of the oil that of the films of the traction?
  [[nodiscard]] bool rolling_uses_traction_film() const { return traction && law.has_film(); }
  [[nodiscard]] const contact::RollerRaceSlices& of(std::size_t roller) const {
    return slices[slices.size() == 1 ? 0 : roller];
  }
};

/// Both races. @throws InputError when the bearing makes no model
[[nodiscard]] std::array<RollerRaceModel, 2> roller_race_models(const SceneBuilder& scene);

/// Largest dQ/dδ under a load [N/m].
[[nodiscard]] double line_stiffness(const RollerRaceModel& model, double load) noexcept;

/// All rollers as the kernels of one race read them.
class RollersOnRace {
 public:
  RollersOnRace(const RollerRaceModel& model, std::size_t rollers);
  /// Poses of this evaluation, and the race as each roller meets it.
  void place(const Evaluation& e) noexcept;
  /// Adds force and moment of a kernel on roller i to it, and what is opposite to the race.
  void apply_roller_action(Evaluation& e, std::size_t i, const double (&force)[3],
                           const double (&moment)[3]) const noexcept;

  [[nodiscard]] std::size_t count() const noexcept { return poses_.size(); }
  [[nodiscard]] bool are_rollers_identical() const noexcept { return views_.size() == 1; }
  [[nodiscard]] const contact::RaceSlicesView* views() const noexcept { return views_.data(); }
  [[nodiscard]] const std::vector<contact::RollerPose>& poses() const noexcept { return poses_; }
  /// Of roller i.
  [[nodiscard]] const contact::RaceSlicesView& view(std::size_t i) const noexcept {
    return views_[are_rollers_identical() ? 0 : i];
  }
  /// Largest slip speed of each roller's slices that press, of the poses placed last [m/s]: of
  /// kernels without traction, which do not form it.
  void largest_slips(double* slip) const noexcept;
  /// By roller where the race has errors, else null.
  [[nodiscard]] const contact::RaceAzimuthSlope* slopes() const noexcept {
    return slopes_.empty() ? nullptr : slopes_.data();
  }
  /// By roller where rollers are out of round, else null.
  [[nodiscard]] const contact::RaceAzimuthSlope* lobe_slopes() const noexcept {
    return lobe_slopes_.empty() ? nullptr : lobe_slopes_.data();
  }
  /// Axis of each roller in its meridian frame, where rollers are out of round.
  [[nodiscard]] const std::vector<Vec3>& axes() const noexcept { return axes_; }

 private:
  void form_race(const RaceBody& race) noexcept;
  void fill_radius_table(const RaceBody& race) noexcept;
  void form_lobes(const Evaluation& e) noexcept;

  const RollerRaceModel& model_;
  bool reads_spin_;  ///< a film does, and a routine of the user may
  contact::RacePose race_pose_;
  std::vector<contact::RaceSlicesView> views_;
  std::vector<contact::RollerPose> poses_;
  std::vector<contact::MeridianRotation> turns_;
  std::vector<contact::RaceAzimuthSlope> slopes_, lobe_slopes_;
  std::vector<Vec3> axes_;
  const bearing::SurfaceTable* table_ = nullptr;
  std::vector<double> radius_,
      approach_slopes_;  ///< of tables: slices of one roller after the other
};

/// The lobe of one roller as an error of race j, by the roller's azimuth.
[[nodiscard]] contact::WavyRace lobe_as_race_error(const bearing::SurfaceSeries& lobe,
                                                   std::size_t j, const contact::RaceSurface& race,
                                                   double race_radius, double crown_radius);
/// Azimuth in the roller's frame of the direction to race j. @param axes its body axes and `up` the
/// unit vector from the race axis to it, both in one frame
[[nodiscard]] contact::AzimuthDirection<double> azimuth_in_roller(const Mat3& axes, const Vec3& up,
                                                                  std::size_t j) noexcept;

/// Everything a report wants of the contacts with one race (roller_race_report.cpp). Contact angle
/// of the resultant as for balls (race_contacts.hpp); spin_to_roll of the slice with the largest
/// pressure; heat is the right-hand side's.
class RollerRaceReport {
 public:
  /// @param rollers as the right-hand side places them; both outlive this
  RollerRaceReport(const RollerRaceModel& model, const RollersOnRace& rollers);
  /// Contact of roller i in the state evaluated last. @param out as constructed, but its rows by
  /// slice may have memory
  void fill(const Evaluation& e, std::size_t i, RaceContactSnapshot& out);

 private:
  const RollerRaceModel& model_;
  const RollersOnRace& rollers_;
  statics::RollerReportKernel kernel_;
  std::vector<double> rows_;  ///< by slice, one quantity after another
};

class RollerRaceBlock final : public EffectBlock {
 public:
  /// @param load_slip it is wanted: by the wear integrals, or by elements in balance
  /// @param rolls with the rolling resistance of the oil, of the same films
  /// @param fastest statics::RollerKernelAction::fastest of each roller, of the evaluation made
  /// last
  RollerRaceBlock(const RollerRaceModel& model, RollersOnRace& rollers, bool load_slip, bool rolls,
                  RaceContactTotals& sums, std::vector<double>& fastest);
  void apply(Evaluation& e) noexcept override;

 private:
  void add_race_error_forces() noexcept;
  /// Adds the force and moment of lobes of rollers to the actions (F_y and M_C above).
  void add_lobe_forces() noexcept;

  const RollerRaceModel& model_;
  bool load_slip_;
  std::vector<double>& fastest_;
  RaceContactTotals& sums_;
  statics::RollerKernel kernel_;
  RollersOnRace& rollers_;
  std::vector<statics::RollerKernelAction> actions_, lobe_actions_;
  std::vector<statics::RollerResistanceLoad> rolling_actions_;  ///< with rolling resistance
  std::optional<SliceScratch> user_scratch_;                    ///< of a law of the user
};

/// Rolling resistance of the same contacts (rolling_resistance.cpp) where the traction has no film.
class RollerRaceRolling final : public EffectBlock {
 public:
  /// @param sums its `rolling` is the sum
  RollerRaceRolling(const RollerRaceModel& model, std::size_t rollers, RaceContactTotals& sums);
  void apply(Evaluation& e) noexcept override;

 private:
  const RollerRaceModel& model_;
  RaceContactTotals& sums_;
  statics::RollingResistanceKernel kernel_;
  RollersOnRace rollers_;
  std::vector<statics::RollerResistanceLoad> actions_;
};

}  // namespace adore::dynamics

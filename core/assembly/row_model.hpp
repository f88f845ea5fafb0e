#pragma once

#include "runs/prepare.hpp"
#include "statics/ball_model.hpp"
#include "statics/race_equilibrium.hpp"
#include "statics/roller_model.hpp"

#include <array>
#include <variant>

/// One row of a set: its elements in equilibrium between an outer race that is held and an inner
/// race at a given displacement. SI, frame of the row's deck.
namespace adore::assembly {

using statics::Mat5;
using statics::Vec5;

/// State of a row whose deck gives the laws. `Mounted`: clearance and contact angle in operation
/// (fits, temperatures, growth of rings), but at rest, without friction and gravity, so that an
/// element without preload has no load. `Unmounted`: the same as built, at room temperature: the
/// state in which makers measure preload.
enum class RowCondition : unsigned char { Operation, Mounted, Unmounted };

/// The row at one displacement of its inner race.
struct RowState {
  Vec5 own = Vec5::Zero();        ///< displacement of the inner race [m, rad]
  Vec5 load = Vec5::Zero();       ///< of the shaft on the inner race [N, N m]
  Mat5 stiffness = Mat5::Zero();  ///< d load / d own
  double largest = 0.0;           ///< largest contact load [N]
  double inner_load = 0.0;        ///< largest contact load at the inner race [N]
  int loaded = 0;                 ///< elements with load at the inner race
  std::array<double, 2> angle{};  ///< load-weighted mean contact angle; NaN: no load [rad]
  double pressure = 0.0;          ///< largest Hertz pressure [Pa]
  double shift = 0.0;             ///< along X by elastic spacers [m]
};

class RowModel {
 public:
  /// @throws InputError for a geometry that is not a bearing
  RowModel(const runs::Prepared& prepared, RowCondition condition);

  /// @throws SolverError where an element has no equilibrium
  [[nodiscard]] RowState at(const Vec5& own) const;
  /// Axial displacement of the row alone under a force along +x, all else held [m].
  /// @throws SolverError
  [[nodiscard]] double under_thrust(double force) const;

  [[nodiscard]] statics::RaceScales scales() const;
  /// Of one contact under that load [N/m].
  [[nodiscard]] double reference_stiffness(double load) const;
  /// x of the inner race's reference point at zero displacement [m].
  [[nodiscard]] double inner_reference_x() const;
  /// Friction enters the equilibrium: it is exact to about 1e-6 of the loads only.
  [[nodiscard]] bool has_friction() const noexcept { return includes_friction_; }
  /// The same row with the equilibrium without friction, which takes a tenth of the time.
  [[nodiscard]] RowModel without_friction() const;
  [[nodiscard]] bool rollers() const noexcept { return bearing_.rollers() != nullptr; }
  [[nodiscard]] double inner_width() const { return bearing_.envelope.race_width[1]; }

 private:
  bearing::Bearing bearing_;
  statics::BallStaticsOptions ball_options_;
  statics::RollerOptions roller_options_;
  std::variant<statics::BallModel, statics::RollerModel> model_;
  bool includes_friction_ = false;
};

}  // namespace adore::assembly

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Which steps a method may take without letting contact vibrations grow. An explicit method (and a
/// backward difference of high order) multiplies the amplitude of a vibration by a factor per step
/// that depends on step × frequency alone. Above 1 it grows from rounding to the size at which the
/// error control sees it: with the usual tolerances that is some percent of the contact loads, and
/// of nothing that the run prints.
namespace adore::runs {

/// A range of angular frequencies at which the bearing's contacts vibrate.
struct VibrationBand {
  std::string name;                    ///< "along the contact normals"
  double lowest = 0.0, highest = 0.0;  ///< [rad/s], > 0
  double damping = 0.0;                ///< ratio to the critical one; 0: undamped
};

struct StepRequest {
  std::string method;                   ///< name of the integrator
  double minimum = 0.0, maximum = 0.0;  ///< limits of the deck [s]; equal: constant step
  double turn = 0.0;  ///< time over which growth is counted, if kCountedPeriods are longer [s]
  std::vector<VibrationBand> bands;
};

enum class StepAction : unsigned char { Kept, Shortened, Lengthened, OrderHeld, Refused };

struct StepLimits {
  StepAction action = StepAction::Kept;
  double minimum = 0.0, maximum = 0.0;  ///< in force [s]
  int highest_order = 0;                ///< of a method that changes its order; 0: its own limit
  double growth_asked =
      1.0;  ///< over the counted time, of the vibration that grows most with the deck's limits
  double growth = 1.0;     ///< and with those in force
  double frequency = 0.0;  ///< of the vibration that grows most with the deck's limits [rad/s]
  std::string vibration;   ///< name of its band
};

/// No vibration may grow by more than this factor per revolution.
inline constexpr double kGrowthPerTurn = 1.01;
/// Growth is counted over a revolution, but over no more than this many periods of the highest
/// frequency: a revolution has no upper bound (1e-4 rpm: 7 days, 2e9 periods), and growth by 1 % in
/// 1e5 periods needs 3e8 periods from rounding (1e-16) to 1 % of a contact load, longer than any
/// run. Below it rounding of the amplification (1e-16 per step) stays below 1e-3 of the limit.
inline constexpr double kCountedPeriods = 1e5;
/// A method that needs steps shorter than this over the highest frequency (600 per period) is
/// rejected.
inline constexpr double kMinPhase = 0.01;

/// The nearest limits at which no vibration grows by more than kGrowthPerTurn:
///   amplification per step |R(hω)|, integrators/stability.hpp, over all ω of the bands and all h
///   that the limits allow; growth per revolution = |R|^(turn/h).
/// A variable step may take any size below its longest, so the longest is lowered until every
/// shorter step is acceptable; a constant step, or one with a lower limit, moves to the nearest
/// acceptable size, up or down: some methods damp in a band only. CVODE is limited to the order
/// that allows the longest steps. A band of damped vibrations is one band more, for its largest
/// damping ratio: its real part must be in the method's region, too. Limits: linear vibrations of
/// the quasi-static solution's stiffness; contacts that open and close are covered by the error
/// control and the judgment of the energy.
[[nodiscard]] StepLimits stable_step_limits(const StepRequest& request);

/// One sentence of what was done and why. `time_scale` [s]: unit of the deck's step sizes.
[[nodiscard]] std::string step_limits_text(const StepRequest& request, const StepLimits& limits,
                                           double time_scale);

/// Methods that keep the deck's limits as they are, in the order of stepper_names().
[[nodiscard]] std::vector<std::string> find_stable_methods(StepRequest request);

}  // namespace adore::runs

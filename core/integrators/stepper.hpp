#pragma once

#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// One interface for every integrator. This folder is independent of bearings: it solves y' = f(t,
/// y).
namespace adore::integrators {

enum class EvalStatus : unsigned char {
  Ok,
  Retry,  ///< the point is outside the model's validity: try a smaller step
  Fail    ///< no step size helps: stop
};

/// Which right-hand side: the whole, or the part that implicit-explicit methods take implicitly.
enum class RhsPart : unsigned char { Whole, Stiff };

/// The right-hand side. Implemented by dynamics; one instance is used by one stepper at a time.
class OdeSystem {
 public:
  virtual ~OdeSystem() = default;
  /// Number of components of y, quadratures included.
  [[nodiscard]] virtual int size() const noexcept = 0;
  /// Components [0, controlled_size) enter the error norm; the rest are quadratures (y_q' = g(t,
  /// y_controlled)), integrated with the same formula and never controlling the step.
  [[nodiscard]] virtual int controlled_size() const noexcept = 0;
  /// Scale of each controlled component: error is |e_i| / |scale_i|, to be held below tol. A scale
  /// is a magnitude: its sign does not count. None is 0.
  [[nodiscard]] virtual std::span<const double> scales() const noexcept = 0;
  /// Writes dydt[0..size). No allocation, no throw.
  virtual EvalStatus rhs(double t, const double* y, double* dydt) noexcept = 0;
  /// Can the right-hand side be split for implicit-explicit methods? Then rhs = rhs_stiff + rest,
  /// where rhs_stiff holds what limits an explicit step (normal contact forces) and is the part
  /// that arkode-imex takes implicitly. Without a split arkode-imex refuses to start, because it
  /// would be another method under its name.
  [[nodiscard]] virtual bool has_stiff_part() const noexcept { return false; }
  /// Writes the stiff part alone, dydt[0..size). The rest is formed as rhs - rhs_stiff, so both
  /// always add up.
  virtual EvalStatus rhs_stiff(double t, const double* y, double* dydt) noexcept {
    (void)t, (void)y, (void)dydt;
    return EvalStatus::Fail;
  }
  /// Coupling of components, for the Jacobian of implicit methods: block number 0, 1, ... of each
  /// controlled component, or -1 for the border. No rate of one block depends on a component of
  /// another block; blocks and border may depend on each other. Empty: everything couples. Constant
  /// after start().
  [[nodiscard]] virtual std::span<const int> blocks() const noexcept { return {}; }
  /// Do blocks form a ring, in which the rates of each also depend on the components of the one
  /// before and the one after it (the last and the first are neighbors)? Constant after start().
  [[nodiscard]] virtual bool blocks_form_ring() const noexcept { return false; }
  /// The rates of `part`, and the contribution of each block to each rate of the border:
  ///   shares[block * border size + k] for the k-th border component, such that
  ///   rate = (part independent of blocks) + Σ shares.
  /// Also in a ring the share of a block depends only on that block and the border.
  /// Called only if there are blocks and a border; in this default the border's rates do
  /// not depend on blocks at all.
  virtual EvalStatus rhs_with_contributions(RhsPart part, double t, const double* y, double* dydt,
                                            double* shares) noexcept;
  /// Called on every accepted state (normalises quaternions). True when that changes its rates.
  virtual bool project(double t, double* y) noexcept {
    (void)t, (void)y;
    return false;
  }
  /// Longest step from time t [s] that still resolves prescribed motion: the guard for y' = f(t),
  /// whose error an embedded high-order pair may not see. A step that starts at t never exceeds it
  /// (but never goes below StepControl::minimum), so it must also stop short of the next event,
  /// e.g. a pulse that begins later. Infinity when nothing is prescribed.
  [[nodiscard]] virtual double step_guard(double t) const noexcept;
  /// Quantities that the exact solution conserves, at the point of the last rhs() of the whole.
  struct Kept {
    double value = 0.0;
    double scale = 0.0;     ///< one step may change it by tol * scale; 0: nothing is watched
    double rounding = 0.0;  ///< changes below this mean nothing
  };
  [[nodiscard]] virtual Kept kept() noexcept { return {}; }
  /// Name of a component for diagnoses, e.g. "element[3].r [m]".
  [[nodiscard]] virtual std::string component_name(int index) const;
};

struct StepControl {
  double initial = 0.0;     ///< first trial step [s]; 0: chosen by the stepper
  double minimum = 0.0;     ///< a step of this size is accepted with any error, and counted
  double maximum = 0.0;     ///< [s], > 0; equal to minimum: constant step
  double tolerance = 1e-6;  ///< bound on max_i |e_i| / |scale_i| per step
  int highest_order = 0;    ///< methods of variable order (CVODE) go no higher; 0: their own limit
};

/// Data of one accepted step.
struct StepInfo {
  double t = 0.0;       ///< time reached
  double h = 0.0;       ///< step size used
  double h_next = 0.0;  ///< proposed next step
  double error = 0.0;   ///< error norm divided by tolerance (<= 1 unless at_minimum); 0 where the
                        ///< method forms no estimate (ARKODE holding a constant step)
  bool at_minimum = false;  ///< accepted because h = minimum
};

struct Counters {
  long steps = 0, rejected = 0, evaluations = 0, at_minimum = 0, restarts = 0, jacobians = 0,
       nonlinear_iterations = 0;
  /// Of the rejected ones, those within the tolerance that lost too much of OdeSystem::kept().
  long repeated_for_energy = 0;
};

/// Memory of a method in addition to time and state, by name.
using Memory = std::map<std::string, double>;

/// The stepper cannot continue. The text names time, step size and the worst component.
class StepFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Name as of the command line ("rkf5", "pece8", "cvode-bdf", ...).
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// Order of the propagated solution (highest order for variable-order methods).
  [[nodiscard]] virtual int order() const noexcept = 0;
  /// Can this method keep h fixed (minimum = maximum)? If not, a deck with a constant step is
  /// rejected with the method's name.
  [[nodiscard]] virtual bool can_hold_constant_step() const noexcept = 0;
  /// Takes the system and the start state. `system` must outlive the stepper. May be called again
  /// (restart).
  /// @throws StepFailure when the right-hand side fails at the start, or the method cannot do what
  /// `control` or `system` asks; std::invalid_argument when `control` or `system` contradict
  /// themselves.
  virtual void start(OdeSystem& system, double t0, std::span<const double> y0,
                     const StepControl& control) = 0;
  /// Data that a continued run needs for resume(): always "next step" [s].
  [[nodiscard]] virtual Memory memory() const = 0;
  /// As start(), from time, state and memory() of an earlier run by the same method. Continues bit
  /// for bit as without a break, unless loses() is not empty; with a right-hand side that
  /// has changed since, starts with the next step. @throws as start(), and std::out_of_range when
  /// the memory is not of this method.
  virtual void resume(OdeSystem& system, double t0, std::span<const double> y0,
                      const StepControl& control, const Memory& memory) = 0;
  /// Data that memory() cannot store, as a clause; empty when it stores all.
  [[nodiscard]] virtual std::string_view loses() const noexcept { return {}; }
  /// One accepted step, never beyond t_stop (the last step is shortened to hit it exactly, or
  /// stretched by at most one part in a million).
  /// @throws StepFailure, and std::invalid_argument when t_stop does not lie after time()
  virtual StepInfo step(double t_stop) = 0;
  [[nodiscard]] virtual double time() const noexcept = 0;
  /// Current state, size() values; valid until the next step.
  [[nodiscard]] virtual std::span<const double> state() const noexcept = 0;
  /// Derivative at the current state, size() values.
  [[nodiscard]] virtual std::span<const double> derivative() const noexcept = 0;
  [[nodiscard]] virtual const Counters& counters() const noexcept = 0;
};

/// All names in a fixed order: rkf1..rkf7, pece1..pece8, cvode-adams, cvode-bdf, arkode-erk,
/// arkode-dirk, arkode-imex, rk4.
std::span<const std::string_view> stepper_names();

/// @throws std::invalid_argument naming the valid names.
std::unique_ptr<Stepper> make_stepper(std::string_view name);

/// Name for the deck's intMet (1-7, 11-18; extensions 21, 22, 31-33, 41); empty for any other
/// code.
std::string_view name_of_int_met(int int_met) noexcept;

}  // namespace adore::integrators

#pragma once

#include "dynamics/evaluation.hpp"
#include "dynamics/force_pass.hpp"
#include "dynamics/prescribed_races.hpp"
#include "dynamics/system.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Interface of an effect or a body of a scene for its System: it declares its states,
/// integrals and blocks once, and then starts, stores, reports and describes itself. System
/// uses only this interface; effect_catalogue.hpp has one line for each effect.
namespace adore::dynamics {

/// One virtual call per block, none per contact. Blocks of effects that are off are never made.
class EffectBlock {
 public:
  virtual ~EffectBlock() = default;
  /// Adds this effect's share to `e`. No allocation.
  virtual void apply(Evaluation& e) noexcept = 0;
  /// False: it acts on cage and races alone (force_pass.hpp).
  [[nodiscard]] virtual bool acts_on_elements() const noexcept { return true; }
};

/// When a block acts; within a phase in the order of declaration.
enum class Phase : unsigned char {
  Races,       ///< motion of the races: prescribed ones from Evaluation::t alone, integrated ones
               ///< from the state; independent of elements, cannot fail
  Kinematics,  ///< poses and velocities of elements and other bodies from the state
  Force,       ///< forces and moments on bodies
  Motion,      ///< rates of the bodies' states
  Account      ///< sums for integrals and ledgers
};

/// Entry of the cost ledger for the bodies' blocks.
inline constexpr std::string_view kMotionCost = "kinematics and equations of motion";

/// Owner of state components that meet every element: the border of the arrow (System::coupling).
inline constexpr int kBorder = -1;

/// Momentum that bodies carry, about the base origin, base frame.
struct Momenta {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  ///< [N s, N m s]
  double linear_size = 0.0, angular_size = 0.0;        ///< Σ over bodies of the sizes
  void add(const Vec3& p, const Vec3& L) noexcept {
    linear += p;
    angular += L;
    linear_size += p.norm();
    angular_size += L.norm();
  }
};

/// A body of the border: turns what elements do to it into its rates.
class BorderBody {
 public:
  virtual ~BorderBody() = default;
  /// Adds to `row`, one value for each state component of this body, what a contact of element i
  /// adds to the rates of this body; force and moment (about the element's center) are those on the
  /// element [N, N m], base frame.
  virtual void add_rate_contribution(const Evaluation& e, std::size_t i, const Vec3& force,
                                     const Vec3& moment, double* row) const noexcept = 0;
};

/// Contacts of elements not with races: estimates for elements in balance (held_elements.hpp).
class NonRaceContacts {
 public:
  virtual ~NonRaceContacts() = default;
  /// Adds -∂F/∂(place) of its normal forces on element i, (x, r, θ) directions [N/m].
  virtual void resist(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept = 0;
  /// Adds the friction force on element i over the slip speed, (x, r) directions [N s/m]. The force
  /// blocks have just been applied.
  virtual void damp(const Evaluation& e, std::size_t i, Eigen::Matrix2d& damping) noexcept {
    return (void)e, (void)i, (void)damping;
  }
};

/// Bodies that a block couples with the elements: its forces and moments on an element act on that
/// element's partner with the opposite sign. A block that couples an element with two bodies is
/// declared as two.
/// Prescribed partners, and partners outside the scene, count as none.
class CoupledBodies {
 public:
  CoupledBodies() = default;  ///< with none
  /// All elements with one body.
  CoupledBodies(BodyId body) : partners_(1, body) {}  // NOLINT(google-explicit-constructor)
  /// Each element with its own.
  explicit CoupledBodies(std::vector<BodyId> of_element) : partners_(std::move(of_element)) {}
  [[nodiscard]] const BodyId* of(std::size_t element) const {
    if (partners_.empty()) return nullptr;
    return partners_.size() == 1 ? partners_.data() : &partners_.at(element);
  }

 private:
  std::vector<BodyId> partners_;
};

/// Requests of an effect to the whole system between two steps.
class BetweenStepsAccess {
 public:
  virtual ~BetweenStepsAccess() = default;
  /// @throws SolverError when the state is not valid
  virtual const Evaluation& evaluate(double t, std::span<const double> y) = 0;
  [[nodiscard]] virtual bool is_valid(double t, std::span<const double> y) noexcept = 0;
  // Of the state evaluated last.
  [[nodiscard]] virtual double stored_energy() const = 0;  ///< [J]
  [[nodiscard]] virtual Momenta momenta() const = 0;
  [[nodiscard]] virtual const Scales& run_scales() const noexcept = 0;
};

class SceneBuilder;

/// One effect or body. Everything but declare() may be left out.
class SceneEffect {
 public:
  virtual ~SceneEffect() = default;
  /// Names states, integrals and blocks. Called once, in the order of the catalogue.
  /// @throws InternalError when the plan asks for what the bearing does not have
  virtual void declare(SceneBuilder& scene) = 0;
  /// Fills its components of the start state (0 until then).
  virtual void start(std::span<double> y) const { (void)y; }
  /// Takes its memory in addition to y from a start state.
  virtual void resume(std::span<const double> y) { (void)y; }
  /// Adds what it makes of the races at time t (prescribed_races.hpp).
  virtual void prescribe(double t, PrescribedRaces& races) const { (void)t, (void)races; }
  /// Continues a run in which races were prescribed as `before`; now they are as `now`.
  virtual void go_on(const PrescribedRaces& before, const PrescribedRaces& now,
                     std::span<double> y) {
    (void)before, (void)now, (void)y;
  }
  /// Speed that steps must resolve now [m/s]: the rolling speed at which the film of a contact
  /// breaks down, of contacts that slide and roll more slowly than `near` [m/s]; the smallest.
  /// Infinite: none. Of the state evaluated last.
  [[nodiscard]] virtual double speed_to_resolve(const Evaluation& e, double near) const {
    return (void)e, (void)near, std::numeric_limits<double>::infinity();
  }
  /// Largest dQ/dδ of its contacts at a load of 1e-3 `force` [N/m]; 0: it has none.
  [[nodiscard]] virtual double stiffness(double force) const { return (void)force, 0.0; }

  // For the last evaluated state.
  /// Clause with the reason why the state is not valid; empty: not because of this effect.
  [[nodiscard]] virtual std::string why_invalid(const Evaluation& e) const { return (void)e, ""; }
  /// Adds the energy that it stores in addition to Evaluation::elastic.
  virtual void store(const Evaluation& e, EnergyLedger& energy) const { (void)e, (void)energy; }
  virtual void carry(const Evaluation& e, Momenta& momenta) const { (void)e, (void)momenta; }
  virtual void report(const Evaluation& e, Snapshot& snapshot) const { (void)e, (void)snapshot; }
  /// Adds what its contacts did, from what the evaluation left: the state that was evaluated
  /// (Evaluation::y, elements) may be gone. No allocation but the first time.
  virtual void look(const Evaluation& e, Look& out) const { (void)e, (void)out; }
  /// Replacement of an integral that is too expensive, with its error; empty: none.
  [[nodiscard]] virtual std::string approximation_note() const { return {}; }
  /// Adds its contacts to System::quadrature_error.
  virtual void add_quadrature_error(const Evaluation& e, scene::QuadratureError& error) const {
    (void)e, (void)error;
  }

  /// One of its blocks moves races in addition to their spin (then they do work without friction).
  [[nodiscard]] virtual bool moves_races() const noexcept { return false; }

  /// Longest step from time t that resolves what it prescribes [s] (System::longest_step).
  [[nodiscard]] virtual double longest_step(double t) const {
    return (void)t, std::numeric_limits<double>::infinity();
  }

  /// Changes of the model that may happen between steps only; true when y changed.
  virtual bool between_steps(double t, std::span<double> y, BetweenStepsAccess& scene) {
    return (void)t, (void)y, (void)scene, false;
  }
  /// The fast part of the motion alone (System::rhs_stiff): all `size` rates. One effect of a
  /// scene may have it.
  [[nodiscard]] virtual bool has_stiff_part() const noexcept { return false; }
  virtual bool stiff_part(const Evaluation& e, const double* y, double* dydt, int size) noexcept {
    return (void)e, (void)y, (void)dydt, (void)size, false;
  }
};

/// Parts of a System.
struct Assembly {
  struct Integral {
    int* index;
    std::string name, unit;
    const double* rate;
    int count;
  };
  struct EnergyItem {
    const LedgerTerm* term;
    int race, integral;
    const double* rate;
  };
  struct MomentumItem {
    const LedgerTerm* term;
    bool angular;
    int integral;
  };
  struct Block {
    Phase phase;
    std::unique_ptr<EffectBlock> block;
    int entry;  ///< of the cost ledger
    CoupledBodies partners;
  };
  /// A body in the border of the arrow.
  struct Border {
    BodyId id;
    const BorderBody* body;
    Slice rows;  ///< its state components
  };

  std::vector<std::unique_ptr<SceneEffect>> effects;
  StateLayout layout;
  std::vector<std::pair<Slice, ScaleKind>> kinds;
  std::vector<Slice> quaternions;
  std::vector<int> owner;  ///< of each controlled component: element or kBorder
  std::vector<Integral> integrals;
  std::vector<EnergyItem> energy;
  std::vector<MomentumItem> momentum;
  bool wants_momentum = false;
  bool neighbours_meet = false;
  std::vector<Block> blocks;
  std::vector<Border> border;
  std::vector<NonRaceContacts*> supports;
  CostLedger cost;
};

/// Input of SceneEffect::declare().
class SceneBuilder {
 public:
  const bearing::Bearing& bearing;
  const ScenePlan& plan;
  const statics::StaticSolution& statics;
  const std::array<double, 2>& fixed_angle;
  const SystemOptions& options;
  const RollerStaticResult* rollers;  ///< start positions of rollers; null: balls
  Evaluation& e;                      ///< the blocks' working memory, there as long as the System

  /// Controlled components "<name>[k] [unit]" of one element, or of kBorder.
  Slice state(std::string name, std::string_view unit, int count, ScaleKind kind, int element);
  /// One component for each element.
  Slice add_element_states(std::string name, std::string_view unit, ScaleKind kind);
  /// Four components that are kept at unit length.
  Slice quaternion(std::string name, int element);

  /// Time integrals of *rate, *(rate + 1) ...; null: they change between steps only. `index` of the
  /// first component is known once all effects have declared themselves.
  void integral(int& index, std::string name, std::string_view unit, const double* rate,
                int count = 1);
  /// An integral that is an item of the energy ledger [J].
  void energy(std::string name, const LedgerTerm& term, const double* rate, int race = 0);
  void energy(int& index, std::string name, const LedgerTerm& term, const double* rate,
              int race = 0);
  /// Three integrals that are an item of the ledger of linear or angular momentum.
  enum class Momentum : unsigned char { Linear, Angular };
  void momentum(int& index, std::string name, Momentum which, const LedgerTerm& term,
                const double* rate);
  /// A momentum ledger is shown.
  void want_momentum_ledger() { out_.wants_momentum = true; }

  /// @param cost where the cost ledger books it
  /// @param partners bodies that it couples elements with; {}: none
  template <class Block, class... Arguments>
  void block(Phase phase, std::string_view cost, CoupledBodies partners, Arguments&&... arguments) {
    add_block(phase, std::make_unique<Block>(std::forward<Arguments>(arguments)...), cost,
              std::move(partners));
  }
  /// A body whose states `rows` (owner kBorder, together) meet elements.
  void add_border_body(BodyId id, const BorderBody& body, Slice rows);

  /// Each element acts on the one before and after it in the ring (a bearing without cage).
  void neighbours_meet() { out_.neighbours_meet = true; }

  /// Does an effect of the scene move the races?
  [[nodiscard]] bool races_move() const;

  /// Elements touch this; it outlives the System.
  void supports(NonRaceContacts& support) { out_.supports.push_back(&support); }
  /// Every force of the scene once more, for effects that need them ahead.
  [[nodiscard]] ForcePass force_pass(bool elements_alone) const noexcept {
    return {out_, elements_alone};
  }

  /// An effect of the scene, declared before when the catalogue has it before; null: there is none.
  template <class E>
  [[nodiscard]] E* find() const {
    for (const auto& effect : out_.effects)
      if (auto* found = dynamic_cast<E*>(effect.get())) return found;
    return nullptr;
  }

  SceneBuilder(const bearing::Bearing& bearing_, const ScenePlan& plan_,
               const statics::StaticSolution& statics_, const std::array<double, 2>& fixed_angle_,
               const SystemOptions& options_, const RollerStaticResult* rollers_, Evaluation& e_,
               Assembly& out)
      : bearing(bearing_),
        plan(plan_),
        statics(statics_),
        fixed_angle(fixed_angle_),
        options(options_),
        rollers(rollers_),
        e(e_),
        out_(out) {}

 private:
  void add_block(Phase phase, std::unique_ptr<EffectBlock> block, std::string_view cost,
                 CoupledBodies partners);
  Assembly& out_;
};

/// For effects that read their own components back.
[[nodiscard]] inline double integral_at(const Evaluation& e, int index) noexcept {
  return index < 0 ? 0.0 : e.y[index];
}

}  // namespace adore::dynamics

#pragma once

#include "dynamics/balanced_race.hpp"
#include "dynamics/constrained_element.hpp"
#include "dynamics/force_pass.hpp"
#include "dynamics/held_contacts.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

/// Light-load balance in a run (record 2.1 qFac): elements whose inertia in x and r is left out.
///
/// A held element keeps x, r, θ, θ̇, its attitude and its spin as state; m r² θ̇ changes by r F_θ as
/// always. Instead of ẍ and r̈ its x and r follow the balance
///   G = (F_x, F_r + m r θ̇²) = 0,   F of all forces: races with friction, pocket, gravity,
/// by first-order motion  (ẋ, ṙ) = w + (A + C)⁻¹ G(w),  where
///   w = B⁻¹ (∂G/∂t along θ, L, the attitude and the races): rates of the balance of race normals,
///   B = -∂G/∂(x, r) of the normal forces at fixed L,  A = 2 √(m B),
///   C = Q κ/u along the contact, summed over the contacts (friction force over slip speed).
/// B and C are those of the element by itself, whatever it touches standing or moving as it does
/// (NonRaceContacts): neighbors of a bearing without cage act on G alone. The balance G = 0 does
/// not know A, B and C, so that it is met exactly; the way there stays a decay, because A + C,
/// symmetric and positive, is no less than what it stands for: two neighbors press with a
/// stiffness of [B -B; -B B] <= 2 diag(B, B), and rub with [C -C; -C C] <= 2 diag(C, C), of which
/// 2C is taken. A departure from balance decays like that of a critically damped element without
/// inertia, at half its natural frequency: not faster than the element itself would move, and
/// without vibration; where friction is stronger than that, friction alone sets the rates. B⁻¹ is
/// taken as Newton's step from B (B² + f²)⁻¹, f = kSoft m θ̇²: an element without contact keeps
/// finite rates, and (f/B)⁴ is far below rounding under load. An
/// element nears its balance no faster than by free fall from rest through
/// QuasiStaticContacts::max_free_displacement(). Without `axial` (kDOF 1 to 4, all rollers but
/// tapered ones) only r is in balance. Nothing balances a cylindrical roller along its axis:
/// between its flanges it flies, and strikes them with its momentum, which is most of their heat
/// where races carry nothing. A barrel turns about the center of its groove: x and tilt are one
/// motion, whose inertia is that of x (m R² against the 80 times smaller moment of inertia of the
/// NU22208's); left without it, friction would be as much stiffer. Tilt, skew and spin of rollers
/// stay dynamic: held or not, they turn by Euler's equations, but with `aligned` (qFac, manual
/// record 2.1: "no misalignment or skew"): a held roller has its axis at a = (cos γ, -sin γ, 0) on
/// (e_x, e_r, e_θ), γ the axis angle of tapered rollers, and ω = θ̇ e_x + s a. What aligns it is a
/// moment N without part along a:
///   ω̇ = θ̈ e_x + ṡ a,  ṡ = a·ω̇_free - θ̈ cos γ,  N = I (ω̇ - ω̇_free)   [derived]
/// N·ω and N go to the ledgers as taken, the turn into line when the roller becomes held to the
/// switches. An unbalanced tapered roller is not aligned.
///
/// w needs no friction; G(w) is formed by a first pass over the force blocks of the scene
/// (force_pass.hpp), so that whatever acts takes part, and the second pass then forms every slip
/// with (ẋ, ṙ) itself. Hence the right-hand side is a pure function of (t, y) and the set of held
/// elements, and the energy that the motion takes is exactly ∫ G·(ẋ, ṙ) dt, an item of the ledger.
/// The kinetic energy ½m(ẋ² + ṙ²) is left out of the stored energy; ẋ and ṙ of held elements stand
/// in the state as zero.
///
/// An element whose mass center is beside its reference point P (element_masses.hpp) is held at P
/// (constrained_element.hpp): G are the components along x and r of what holds it, with sign, so
/// that its unbalance m ω × (ω × c) is a load of the balance. Its kinetic energy and momentum are
/// those of the mass center, whose velocity is r θ̇ e_θ + ω × c; the ledger takes F·u + m ṙ θ̇ (r θ̇
/// + (ω × c)_θ), u = (ẋ, ṙ) [derived], which is G·u without c.
///
/// Modes 1 and 2 hold all elements. In mode 2 the inner race follows its own balance by the same
/// kind of motion (balanced_race.hpp), and w holds what its velocity does to the elements.
///
/// Limits: the way to balance sees of an unbalanced element ω × (ω × c), not ω̇ × c; w leaves out
/// the cage, neighbors, gravity and races that tilt in time; a held element follows those, and
/// changes of friction, within its natural time √(m/B): microseconds along the contact normal, up
/// to milliseconds across an outer groove at low speed. C leaves out friction of rollers on
/// flanges, in pockets and on neighbors.
namespace adore::dynamics {

inline constexpr double kSoft = 1.0;  ///< softest stiffness that rates come from, over m θ̇²

class QuasiStaticElements {
 public:
  struct Scene {
    ElementMasses masses;
    bool axial = true;                   ///< x is in balance; false: it stays as dynamic as it is
    BalancedRace* race = nullptr;        ///< an inner race in balance (mode 2)
    ElementConstraints suppressed = {};  ///< additional constraints of kDOF, of off-center elements
    bool aligned = false;                ///< rollers are held in line with their nominal axis
    double axis_angle = 0.0;             ///< γ of that axis [rad]
  };
  QuasiStaticElements(const Scene& scene, const ElementSlices& slices,
                      std::unique_ptr<QuasiStaticContacts> contacts, ForcePass pass);

  void set(std::size_t i, bool held);
  [[nodiscard]] bool is_quasi_static(std::size_t i) const noexcept {
    return quasi_static_flags_[i] != 0;
  }
  [[nodiscard]] const std::vector<std::size_t>& quasi_static_indices() const noexcept {
    return quasi_static_indices_;
  }

  /// Velocities of element i whose inertia is left out [m/s].
  [[nodiscard]] Vec2 left_out(std::size_t i) const noexcept {
    return {scene_.axial ? x_dot_[i] : 0.0, r_dot_[i]};
  }
  /// (ẋ, ṙ) of any element at the state evaluated last, and G of a held one [N].
  [[nodiscard]] Vec2 rate(std::size_t i) const noexcept { return {x_dot_[i], r_dot_[i]}; }
  [[nodiscard]] Vec2 residual(std::size_t i) const noexcept { return residual_[i]; }

  /// The place where element i would stand in balance with the normal forces of the races and all
  /// that acts besides them at the state evaluated last (`force` on x and r, [N]). L is kept.
  [[nodiscard]] QuasiStaticPosition balanced(const Evaluation& e, std::size_t i,
                                             const Vec2& force) const {
    return contacts_->balanced(e, i, force);
  }
  /// Axis a of an aligned roller on (e_x, e_r, e_θ).
  [[nodiscard]] Vec3 aligned_axis() const noexcept {
    return {std::cos(scene_.axis_angle), -std::sin(scene_.axis_angle), 0.0};
  }
  [[nodiscard]] bool aligns(std::size_t i) const noexcept {
    return scene_.aligned && !(scene_.masses[i].has_eccentric_mass && scene_.axis_angle != 0.0);
  }
  /// Normal forces of the races on (x, r) of element i [N].
  [[nodiscard]] Vec2 normal_force(const Evaluation& e, std::size_t i) const noexcept {
    return contacts_->normal_force(e, i);
  }

  /// Load of the excluded inertia at this evaluation; moment about the base origin.
  struct Account {
    double power = 0.0;                                ///< [W]
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< [N, N m]
  };
  [[nodiscard]] const Account& account() const noexcept { return account_; }

  /// Gives held elements the rates (ẋ, ṙ) that all slips are formed with. After the kinematics,
  /// before every force.
  void form_rates(Evaluation& e) noexcept;
  /// Replaces ẍ and r̈ of held elements by zero and books what their inertia would take. After the
  /// equations of motion of the elements.
  void remove_inertia(Evaluation& e) noexcept;

 private:
  struct Estimate {
    Mat2 damping, inverse;  ///< A and B⁻¹
    Vec2 per_orbit;         ///< ∂G/∂L
  };
  /// All forces at the rates that the evaluation's elements have.
  struct Forces {
    Vec3 force;         ///< [N]
    double race_theta;  ///< of the races alone along e_θ [N]
    Mat2 friction;      ///< C
  };
  void estimate(const Evaluation& e, std::size_t k) noexcept;
  void predict_rates(const Evaluation& e, std::size_t k) noexcept;
  /// Velocity of an inner race in balance with what the elements do at their first rates, and what
  /// the elements' rates get from it.
  void move_race(Evaluation& e) noexcept;
  void follow_race(const Evaluation& e, const Vec3& velocity) noexcept;
  /// Of the inner race, base axes: force of the elements [N], friction force over slip speed [N
  /// s/m].
  struct RaceForces {
    Vec3 force = Vec3::Zero();
    Mat3 friction = Mat3::Zero();
  };
  RaceForces form_forces(Evaluation& e) noexcept;
  void pull(const Evaluation& e, std::size_t k) noexcept;
  void constrain_eccentric_element(Evaluation& e, std::size_t i) noexcept;
  void align(Evaluation& e, std::size_t i) noexcept;

  Scene scene_;
  ElementSlices slices_;
  std::unique_ptr<QuasiStaticContacts> contacts_;
  ForcePass pass_;
  std::vector<unsigned char> quasi_static_flags_;
  std::vector<std::size_t> quasi_static_indices_;  ///< held elements, increasing
  std::vector<double> x_dot_, r_dot_;              ///< of all elements
  std::vector<Vec2> residual_;
  Account account_;
  // One value per held element.
  std::vector<ContactLinearization> springs_;
  std::vector<Forces> forces_;
  std::vector<Estimate> estimate_;
};

/// An effect that holds elements, for effects that must know it (SceneBuilder::find).
class QuasiStaticEffect {
 public:
  virtual ~QuasiStaticEffect() = default;
  [[nodiscard]] virtual bool is_quasi_static(std::size_t i) const noexcept = 0;
  /// x is in balance, too.
  [[nodiscard]] virtual bool is_x_quasi_static() const noexcept = 0;
};

}  // namespace adore::dynamics

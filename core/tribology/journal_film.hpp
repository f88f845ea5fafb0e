#pragma once

/// Cage on a guide land as a short journal bearing: film c (1 + ε cos θ), θ in the sense of
/// positive rotation from the widest gap; the journal (inner surface) is displaced towards θ = π,
/// unit vector d. Pressures below 0 are cut (Guembel). Ocvirk & DuBois 1953, derived anew. SI.
///   p(θ) = μ L³ (½ ε ω̄ sin θ - ε' cos θ)/(c² (1 + ε cos θ)³),  ω̄ = ω_journal + ω_bearing - 2 φ',
/// positive on one half circle from θ1 = atan2(2 ε', ε ω̄). On the journal: F_r along d (negative
/// pushes back), F_t along t = d turned by +90°. Limits: L/D < 0.5, laminar, ε < 1.
namespace adore::tribology {

struct JournalFilm {
  double viscosity = 0.0, radius = 0.0, length = 0.0, clearance = 0.0;  ///< c radial [m]
};

struct JournalMotion {
  double eccentricity = 0.0;                  ///< ε, 0 <= ε < 1
  double journal = 0.0, bearing = 0.0;        ///< ω [rad/s]
  double attitude_rate = 0.0, squeeze = 0.0;  ///< φ' [rad/s], ε' [1/s]
};

struct JournalForce {
  double radial = 0.0, tangential = 0.0;  ///< F_r, F_t on the journal [N]
  /// Couette torque 2π μ R³ L (ω_j - ω_b)/(c √(1 - ε²)) of a full film, with the share that
  /// balances the moment of the force about one point [N m].
  double torque_journal = 0.0, torque_bearing = 0.0;
};

[[nodiscard]] JournalForce journal_force(const JournalFilm& film, const JournalMotion& motion);

}  // namespace adore::tribology

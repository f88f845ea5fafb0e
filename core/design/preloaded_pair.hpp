#pragma once

#include "statics/race_result.hpp"

#include <functional>

/// A preloaded back-to-back (or face-to-face) pair from its two single rows, without a solver for
/// pairs. SI.
///
/// Rows a and b are mirror images, rings and spacers are rigid, and the preload P pushes each inner
/// ring by δ(P) against its own row. The shaft carries both inner rings: a displacement u along the
/// axis changes δ_a by +u and δ_b by -u, so that with k = dF/dδ of the single rows at the preload
///   k_axial = k_a + k_b,   k_radial = k_a,zz + k_b,zz   [derived]
/// The mirror turns the sign of the coupling of tilt and radial displacement, which cancels for a
/// load in the middle of the pair; tilts are held. Grinding the spacer by
///   Δ = [δ_a(P2) - δ_a(P1)] + [δ_b(P2) - δ_b(P1)]   [derived]
/// raises the preload from P1 to P2. An external axial force F unloads row b when u = δ(P):
///   F = P_a(2 δ(P)) of identical rows   [derived]
/// (2^1.5 P = 2.83 P for δ ~ F^(2/3); more where the contact angle grows).
/// Limits: elastic seats, thermal growth and the deflection of spacers are left out.
namespace adore::design {

struct PairStiffness {
  double axial = 0.0, radial = 0.0;  ///< [N/m]
};

/// @param a @param b single rows at the preload, as if each were pushed to +x
[[nodiscard]] PairStiffness pair_stiffness(const statics::RaceResult& a,
                                           const statics::RaceResult& b) noexcept;

/// Single row: state under an axial force [N] to +x.
using RowUnderThrust = std::function<statics::RaceResult(double force)>;

/// Δ of the spacers of a pair of identical rows from one preload to another [m].
[[nodiscard]] double pair_offset(const RowUnderThrust& row, double from, double to);

/// F of a pair of identical rows at the preload P [N].
/// @param free displacement of the single row that just touches: δ counts from there [m]
/// @throws SolverError where the row does not settle
[[nodiscard]] double unloading_force(const RowUnderThrust& row, double preload, double free);

}  // namespace adore::design

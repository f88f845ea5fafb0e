#pragma once

#include "life/iso281.hpp"

#include <optional>
#include <span>
#include <vector>

/// ISO 16281 reference rating life: the ISO life from the loads inside the bearing, after public
/// implementations. Forces in N, lives in 1e6 revolutions, L_10r infinite without load.
namespace adore::life {

/// Source of an optional a_ISO.
struct AisoInput {
  double contamination = 0.0;  ///< e_C
  double fatigue_limit = 0.0;  ///< C_u [N]
  double kappa = 0.0;
};

struct ReferenceLife {
  double capacity_inner = 0.0, capacity_outer = 0.0;  ///< Q_ci, Q_ce [N]
  double load_inner = 0.0, load_outer = 0.0;          ///< Q_ei, Q_ee [N]
  double L10r = 0.0;
  double P_ref = 0.0;              ///< [N]
  std::optional<double> modified;  ///< L_nmr at a_1 = 1, when a condition is given
};

/// Equivalent load of a race, unloaded contacts counted: (mean Q^p)^(1/p), p = 3 or 10/3 (points),
/// 4 or 9/2 (lines), rotating or stationary.
[[nodiscard]] double equivalent_load(std::span<const double> loads, bool line, bool rotating);

/// Ball bearing. @param rating C [N], radial or axial as the geometry's type says
[[nodiscard]] ReferenceLife iso_reference_life_ball(const IsoGeometry& geometry, double rating,
                                                    std::span<const double> inner,
                                                    std::span<const double> outer,
                                                    bool inner_rotates, bool outer_rotates,
                                                    const std::optional<AisoInput>& condition);

/// Loads of a roller bearing by laminae: loads[j * laminae + k].
struct LaminaLoads {
  std::size_t laminae = 0;
  std::vector<double> inner, outer;
};
struct RollerReferenceLife : ReferenceLife {
  double lamina_capacity_inner = 0.0, lamina_capacity_outer = 0.0;  ///< q_ci, q_ce [N]
  std::vector<double> lamina_load;  ///< P_sk, dynamic equivalent load of each lamina [N]
};
/// Radial roller bearing. `edge`: stress concentration f_k of the end laminae, for contact models
/// that do not resolve the edge themselves; it depends on the number of laminae (the standard has
/// at least 30).
[[nodiscard]] RollerReferenceLife iso_reference_life_roller(
    const IsoGeometry& geometry, double rating, const LaminaLoads& loads, bool inner_rotates,
    bool outer_rotates, bool edge, const std::optional<AisoInput>& condition);

/// f_k = 1 - 0.01/ln(1.985 |(2k - n - 1)/(2n - 2)|), k = 1..n; 2.328 at both ends.
[[nodiscard]] double lamina_edge_factor(std::size_t k, std::size_t n);

}  // namespace adore::life

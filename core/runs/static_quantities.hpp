#pragma once

#include "results/key_results.hpp"
#include "runs/prepare.hpp"

#include <optional>

/// Scalar results of an equilibrium that are derived from its contacts. SI.
namespace adore::runs {

/// Largest friction force between ball and race over the load; empty without a traction law in the
/// deck.
[[nodiscard]] std::optional<double> available_friction(const deck::Deck& deck,
                                                       const bearing::Bearing& bearing);

/// - least_element_load_N: min over elements of min(Q_o, Q_i); centrifugal force loads the outer
///   race of every element, so that the inner race decides.
/// - largest_approach_m.
/// - gyroscopic_ratio (balls): max over balls and races of μ_needed/μ_available, μ_needed by
///   statics/ball_forces.hpp, of the solution by the spin rule (kAngVel).
/// - viscosity_ratio (kTrac > 0, races in relative rotation): κ = ν/ν_1, ν = η/ρ of the base oil at
///   the inlet temperature of the race where it is smaller, ν_1 by life/iso281.hpp.
void add_extremes(results::KeyResults& out, const Prepared& prepared);

/// Displacement of the inner race along its radial load while the load passes over the elements.
/// By symmetry of equal elements the load turns instead of the set: by the angle φ about x, with
/// moments, tilts and misalignment. [derived]
struct VariableCompliance {
  double difference = 0.0;  ///< u(load between two elements) - u(element under the load) [m]
  double span = 0.0;        ///< largest minus least u over one pitch, kCompliancePositions [m]
};
inline constexpr int kCompliancePositions = 12;
/// Limits: imperfections, gravity and frame motion do not turn.
/// @throws InputError without a radial load that is given as a force; SolverError
[[nodiscard]] VariableCompliance variable_compliance(const Prepared& prepared);

}  // namespace adore::runs

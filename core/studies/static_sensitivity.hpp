#pragma once

#include "studies/study.hpp"

#include <map>
#include <string>
#include <vector>

/// Derivatives of an equilibrium by the implicit function theorem.
///
/// R(q, p) is the load that the shaft side must apply to the inner race at displacement q minus the
/// applied load; R = 0 in the free directions f, and q is given in the others c. With K = ∂R/∂q,
/// the exact stiffness of the solution,
///   dq_f/dp = -K_ff⁻¹ (∂R_f/∂p + K_fc dq_c/dp),
/// and a result g(q, p) has dg/dp = d/ds g(q + s dq/dp, p + s) at s = 0. The bearing follows p with
/// all dependent quantities (fits, growth, Hertz constants, speeds); the elements are in
/// equilibrium at every held displacement. No equilibrium of the race is solved again: the partial
/// derivatives are of solutions with the race held, fourth-order differences whose error is 1e-8 or
/// less. Displacements, loads, largest contact load and pressure, stiffness; other results (life,
/// friction, fits) depend on more than the race's equilibrium and have differences only.
/// Limits: directions without stiffness have no derivative (NaN); at a contact that just opens or
/// closes the derivative is one-sided, as the differences show.
namespace adore::studies {

/// By variable: quantity name and derivative [SI over the deck's unit]. Empty for a deck in motion.
using StaticDerivatives = std::vector<std::map<std::string, double>>;

/// @throws InputError, SolverError as runs::prepare
[[nodiscard]] StaticDerivatives static_derivatives(const Study& study, std::size_t deck);

}  // namespace adore::studies

#pragma once

#include <span>

/// Weibull statistics of fatigue lives. Lives are positive, in 1e6 revolutions or any other unit;
/// infinity means no fatigue damage and is a valid life everywhere.
namespace adore::life {

/// @throws InputError unless the life is positive (10^6 revolutions, infinity included): loads and
/// factors out of all proportion give none.
void check_life(double life);

/// Life of a race from the lives L_j it would have if every contact were like contact j.
/// Rotating relative to the load (every point of the race sees every position): 1/L = mean 1/L_j.
/// Stationary (survival probabilities of the zones multiply): L^-e = mean L_j^-e.
/// The mean runs over all contacts, unloaded ones enter with infinite life. [lundberg1947]
/// @throws InputError for a life that is not positive, or no contact at all.
[[nodiscard]] double race_life(std::span<const double> lives, bool rotating, double slope);

/// Life at survival S of components that must all survive: Σ ln(1/0.9) (L/L_i)^e_i = ln(1/S), where
/// L_i are lives at 0.9. Equal slopes at S = 0.9 give the product law L^-e = Σ L_i^-e.
/// @throws InputError when a slope is not positive or S is not between 0 and 1.
[[nodiscard]] double combined_life(std::span<const double> lives, std::span<const double> slopes,
                                   double survival = 0.9);

/// L_S / L_10 = (ln(1/S)/ln(1/0.9))^(1/β), two-parameter Weibull: pessimistic beyond S = 0.99.
/// @throws InputError
[[nodiscard]] double survival_factor(double survival, double slope);

/// Hours of a life in 1e6 revolutions; infinite when the races do not turn against each other.
/// @param relative_speed |Ω_inner - Ω_outer| [rad/s]
[[nodiscard]] double life_hours(double mega_revolutions, double relative_speed);

}  // namespace adore::life

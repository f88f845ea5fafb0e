#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

/// Sample points of the unit cube, and from there to laws. Every number depends on seed, sample and
/// dimension alone, not on the order of asking, so that any worker may compute any sample.
namespace adore::studies {

enum class Sampling : unsigned char;

inline constexpr int kSobolDimensions = 21;

/// Points in (0, 1): [sample][dimension].
/// Random: independent. Latin: each dimension has one sample in each of n equal strata, at a random
/// place of it, strata shuffled. Sobol: the low-discrepancy sequence with the direction numbers of
/// Joe and Kuo (2008), shifted digit by digit by the seed, at most kSobolDimensions dimensions.
/// @throws InputError for more dimensions than Sobol has
[[nodiscard]] std::vector<std::vector<double>> unit_cube_samples(Sampling method, long samples,
                                                                 int dimensions,
                                                                 std::uint64_t seed);

/// Φ(z) of the standard normal law, and its inverse: Acklam's rational approximation and one step
/// of Halley's method, 1e-15 relative. @pre 0 < u < 1
[[nodiscard]] double normal_cdf(double z);
[[nodiscard]] double normal_quantile(double u);

/// Lower Cholesky factor L of a correlation matrix, LLᵀ = C; semi-definite matrices too.
/// @return false when C is none (an eigenvalue below -1e-10)
[[nodiscard]] bool factorize_correlation(const Eigen::MatrixXd& correlation,
                                         Eigen::MatrixXd& factor);

}  // namespace adore::studies

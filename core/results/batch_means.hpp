#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

/// Statistical error of means over a run.
///
/// A run gives sums of correlated values. They are collected in batches of equal duration. With n
/// batch sums a_b of a quantity and s_b of what it is divided by (time, shaft rotation):
///   R = Σ a / Σ s,  e_b = a_b - R s_b (mean zero),  error of R = error of the mean of e / mean of
///   s
/// (ratio estimator). The error of the mean of e is the larger of two estimates, in size of the
/// two-sided 95 % interval:
///   batch means: neighbors are joined to m = floor(sqrt(n)) long batches (at least 4), which
///   count as independent: t(m - 1) sqrt(Σ ē² / (m (m - 1))). Consistent with batches that grow
///   like sqrt(n) (J. M. Flegal, G. L. Jones: Batch means and spectral variance estimators in
///   Markov chain Monte Carlo, Ann. Statist. 38 (2010) 1034-1070; recalled, high). initial monotone
///   sequence: 2 sqrt((-γ0 + 2 Σ Γ_k) / n), Γ_k = γ_2k + γ_2k+1 the sums of pairs of
///   autocovariances of the e_b, up to the first that is not positive and none larger than the one
///   before (C. J. Geyer: Practical Markov chain Monte Carlo, Statist. Sci. 7 (1992) 473-483;
///   recalled, high). Derived for reversible chains; here an estimate that does not depend on m.
/// Limits: correlations longer than the span are not seen; a start that has not settled and slow
/// periods count as scatter. Below 8 batches the error is not computed (NaN).
///
/// Two runs from the same start (paired differences). The transient, the passage of the elements
/// and each regular whirl of the cage are the same in both: in the difference of the runs, batch by
/// batch, they cancel, and only scatter is left (common random numbers as a control variate:
/// A. M. Law: Simulation Modeling and Analysis, ch. 11; recalled, medium). With R the mean of both
/// ratios and S = Σ s of each run:
///   d_b = (a_b - R s_b) / S of the one run - the same of the other,  Σ d_b = R_1 - R_2
/// The runs are exchangeable, so that d has expectation 0, also while they still part: its squares
/// count without subtraction of a mean, and blocks of different variance may be added. With D the
/// sums of d over 8 blocks, the half-width of the interval of R_1 - R_2 is the larger of
/// t(8) sqrt(Σ D²) and of that by the initial monotone sequence of d; where p > 1/2, it is
/// t(3) ε(span), if that is smaller (derived; 3 degrees of freedom of the fit: estimated).
/// Fall of the error with the span: ε(L) = sqrt(mean of D²) / L over blocks of the span to 1/16 of
/// it, fitted as L^-p with weights m of m blocks. Independent: p = 1/2, correlated: p -> 0, bounded
/// (a whirl that keeps its phase): p -> 1. `fall` is p within kLeastFall and 1/2. `late`: variance
/// rate of the second half over the mean, 1 (stationary) to 2 (the runs have parted only there).
namespace adore::results {

/// Batches of equal duration behind a mean Σ a / Σ s.
struct RatioSeries {
  double seconds = 0.0;  ///< of a batch; 0: none
  std::vector<double> a, s;
};

/// Difference of two runs from the same start.
struct PairedScatter {
  double half_width = std::numeric_limits<double>::quiet_NaN();  ///< of 95 %, in the unit of a / s
  double fall = 0.5, late = 1.0;
};
constexpr double kLeastFall = 0.25;

/// NaN: fewer than 8 batches, or durations that are not multiples of each other.
[[nodiscard]] PairedScatter paired_scatter(const RatioSeries& one, const RatioSeries& other);

/// Half of the 95 % interval of Σ a / Σ s, in its own unit. @param a, s of equal batches
[[nodiscard]] double ratio_half_width(std::span<const double> a, std::span<const double> s);

/// Sums of K quantities in at most kMost batches of equal duration. When there are more, neighbors
/// are joined. The first batch is the largest power of two [s] within the first interval, so that
/// batches of different runs begin and end together.
template <std::size_t K>
class BatchSums {
 public:
  static constexpr std::size_t kMost = 64;
  using Sums = std::array<double, K>;

  /// Value added during an interval that ends now. A longer interval than a batch is spread
  /// evenly over them. @param seconds > 0, others are ignored
  void add(double seconds, const Sums& sums) {
    if (!(seconds > 0.0)) return;
    if (!(length_ > 0.0)) length_ = std::exp2(std::floor(std::log2(seconds)));
    double left = seconds;
    while (left > 0.0) {
      const double room = length_ - open_seconds_;
      const bool fills = left >= room * (1.0 - 1e-9);
      const double part = fills ? room : left;
      for (std::size_t k = 0; k < K; ++k) open_[k] += sums[k] * (part / seconds);
      open_seconds_ += part;
      left = fills && left <= room * (1.0 + 1e-9) ? 0.0 : left - part;
      if (fills) close();
    }
  }
  [[nodiscard]] std::size_t count() const noexcept { return batches_.size(); }
  [[nodiscard]] double batch_seconds() const noexcept { return length_; }
  [[nodiscard]] std::vector<double> series(std::size_t k) const {
    std::vector<double> out;
    for (const Sums& batch : batches_) out.push_back(batch[k]);
    return out;
  }
  /// Quantity `a` over quantity `s`.
  [[nodiscard]] RatioSeries ratio(std::size_t a, std::size_t s) const {
    return {length_, series(a), series(s)};
  }
  /// Quantity `a` over time.
  [[nodiscard]] RatioSeries rate(std::size_t a) const {
    return {length_, series(a), std::vector<double>(batches_.size(), length_)};
  }
  [[nodiscard]] double half_width(std::size_t a, std::size_t s) const {
    return ratio_half_width(series(a), series(s));
  }
  [[nodiscard]] double half_width(std::size_t a) const {
    const RatioSeries of = rate(a);
    return ratio_half_width(of.a, of.s);
  }

  /// For MASTER, and back.
  void save(std::map<std::string, double>& state, const std::string& name) const {
    if (!(length_ > 0.0)) return;
    state[name + " length"] = length_;
    state[name + " open"] = open_seconds_;
    state[name + " count"] = static_cast<double>(batches_.size());
    for (std::size_t k = 0; k < K; ++k) {
      state[key(name, kMost, k)] = open_[k];
      for (std::size_t b = 0; b < batches_.size(); ++b) state[key(name, b, k)] = batches_[b][k];
    }
  }
  void restore(const std::map<std::string, double>& state, const std::string& name) {
    *this = {};
    const auto of = [&](const std::string& at) {
      const auto found = state.find(at);
      return found == state.end() ? 0.0 : found->second;
    };
    const double count = of(name + " count");
    if (!(count >= 0.0 && count <= static_cast<double>(kMost))) return;
    length_ = of(name + " length");
    open_seconds_ = of(name + " open");
    batches_.resize(static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < K; ++k) {
      open_[k] = of(key(name, kMost, k));
      for (std::size_t b = 0; b < batches_.size(); ++b) batches_[b][k] = of(key(name, b, k));
    }
  }

 private:
  static std::string key(const std::string& name, std::size_t batch, std::size_t k) {
    return name + " " + std::to_string(batch) + " " + std::to_string(k);
  }
  void close() {
    batches_.push_back(open_);
    open_ = {};
    open_seconds_ = 0.0;
    if (batches_.size() < kMost) return;
    for (std::size_t b = 0; b < kMost / 2; ++b)
      for (std::size_t k = 0; k < K; ++k)
        batches_[b][k] = batches_[2 * b][k] + batches_[2 * b + 1][k];
    batches_.resize(kMost / 2);
    length_ *= 2.0;
  }

  double length_ = 0.0, open_seconds_ = 0.0;  ///< [s]
  Sums open_{};
  std::vector<Sums> batches_;
};

}  // namespace adore::results

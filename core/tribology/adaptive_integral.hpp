#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

/// Adaptive quadrature of several functions at once, for set-up and reports.
namespace adore::tribology {

/// ∫ f dx over pieces between known break points. In each piece x = lo + L w²(3 - 2w) clusters
/// points at both ends, so that square roots and logarithms there become smooth; then Gauss-Kronrod
/// (10, 21) [piessens1983] with bisection until the error estimate of every component is below its
/// tolerance.
template <std::size_t N>
class AdaptiveIntegral {
 public:
  using Values = std::array<double, N>;

  /// @param scale size of each component, in units of which `tolerance` is meant.
  AdaptiveIntegral(const Values& scale, double tolerance, int budget)
      : scale_(scale), tolerance_(tolerance), max_panels_(budget) {}

  template <class F>
  [[nodiscard]] Values integrate_piece(const F& f, double lo, double hi) {
    Values sum{};
    if (!(hi > lo)) return sum;
    panels_left_ = max_panels_;
    const double length = hi - lo;
    const auto clustered = [&](double w) {
      Values value = f(lo + length * w * w * (3.0 - 2.0 * w));
      for (double& component : value) component *= 6.0 * w * (1.0 - w) * length;
      return value;
    };
    refine(clustered, 0.0, 1.0, sum);
    return sum;
  }

 private:
  template <class F>
  void refine(const F& f, double lo, double hi, Values& sum) {
    constexpr std::array<double, 11> kNode{0.995657163025808080735527280689003,
                                           0.973906528517171720077964012084452,
                                           0.930157491355708226001207180059508,
                                           0.865063366688984510732096688423493,
                                           0.780817726586416897063717578345042,
                                           0.679409568299024406234327365114874,
                                           0.562757134668604683339000099272694,
                                           0.433395394129247190799265943165784,
                                           0.294392862701460198131126603103866,
                                           0.148874338981631210884826001129720,
                                           0.0};
    constexpr std::array<double, 11> kKronrod{
        0.011694638867371874278064396062192, 0.032558162307964727478818972459390,
        0.054755896574351996031381300244580, 0.075039674810919952767043140916190,
        0.093125454583697605535065465083366, 0.109387158802297641899210590325805,
        0.123491976262065851077958109585166, 0.134709217311473325928054001771707,
        0.142775938577060080797094273138717, 0.147739104901338491374841515972068,
        0.149445554002916905664936468389821};
    constexpr std::array<double, 5> kGauss{
        0.066671344308688137593568809893332, 0.149451349150580593145863397657697,
        0.219086362515982043995534934228163, 0.269266719309996355091226921569469,
        0.295524224714752870173815619188769};
    const double centre = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
    Values kronrod{}, difference{};
    const auto add = [&](const Values& value, double k, double g) {
      for (std::size_t i = 0; i < N; ++i) {
        kronrod[i] += k * value[i];
        difference[i] += (k - g) * value[i];
      }
    };
    add(f(centre), kKronrod[10], 0.0);
    for (std::size_t j = 0; j < 10; ++j) {
      const double gauss = j % 2 == 1 ? kGauss[j / 2] : 0.0;
      add(f(centre - half * kNode[j]), kKronrod[j], gauss);
      add(f(centre + half * kNode[j]), kKronrod[j], gauss);
    }
    --panels_left_;
    bool good = true;
    for (std::size_t i = 0; i < N; ++i) {
      // The Kronrod value is far better than the Gauss value that it is compared with.
      // [piessens1983]
      const double error = std::pow(200.0 * half * std::abs(difference[i]) / scale_[i], 1.5);
      good = good && !(error > tolerance_);
    }
    if (good || panels_left_ <= 0 || half < 1e-10) {
      for (std::size_t i = 0; i < N; ++i) sum[i] += half * kronrod[i];
      return;
    }
    refine(f, lo, centre, sum);
    refine(f, centre, hi, sum);
  }

  Values scale_;
  double tolerance_;
  int max_panels_;  ///< panels per piece
  int panels_left_ = 0;
};

}  // namespace adore::tribology

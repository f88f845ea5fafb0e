#pragma once

#include "tribology/laws/exponential.hpp"
#include "tribology/laws/two_slope.hpp"

namespace adore::tribology {

/// The curve of record 10.1 under a film, in either form: used only where the film breaks
/// down, so that it need not be a separate type.
struct MetalLaw {
  bool slopes = true;
  TwoSlopeLaw two_slope;
  ExponentialLaw exponential;

  MetalLaw() = default;
  MetalLaw(const TwoSlopeLaw& law) : two_slope(law) {}                      // NOLINT: it is one
  MetalLaw(const ExponentialLaw& law) : slopes(false), exponential(law) {}  // NOLINT: likewise

  template <class T>
  struct Here {
    bool slopes;
    TwoSlopeLaw::Here<T> two_slope;
    ExponentialLaw::Here<T> exponential;
    [[gnu::always_inline]] T operator()(const T& slip, const T& pressure) const {
      return slopes ? two_slope(slip, pressure) : exponential(slip, pressure);
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const ContactConditions<T>& c) const {
    return {slopes, two_slope.at(c), exponential.at(c)};
  }
  [[nodiscard]] double kink() const { return slopes ? two_slope.kink() : exponential.kink(); }
  [[nodiscard]] double start() const { return slopes ? two_slope.start() : exponential.start(); }
  [[nodiscard]] double at_rest() const {
    return slopes ? two_slope.at_rest() : exponential.at_rest();
  }
};

}  // namespace adore::tribology

#pragma once

#include "adrplot/run_motion.hpp"
#include "adrplot/spectrum.hpp"

#include <limits>
#include <string>
#include <vector>

/// Equally spaced samples of stored curves for spectra, envelope spectra and order spectra.
namespace adore::adrplot {

/// Revolutions of the part that orders refer to, at the stored times.
struct PartRotation {
  std::vector<double> turns;  ///< increasing; empty: unknown
  std::string part;           ///< "shaft", "cage", "element"
  std::string source;         ///< "bearing rotation in SOL1"
  std::string why_none;       ///< a sentence
};
[[nodiscard]] PartRotation rotation_of(const RunMotion& motion, OrderReference part);

/// Samples of which amplitude_spectrum() is the spectrum.
struct SpectrumSamples {
  signal::Samples samples;  ///< step in s, or in revolutions for orders
  double highest = std::numeric_limits<double>::infinity();  ///< the spectrum ends here
  std::string why_none = {};                                 ///< a sentence if there are no samples
};

class SpectrumSource {
 public:
  SpectrumSource(const RunMotion& motion, const SpectrumOptions& options, Domain domain);

  /// For an automatic band: the best one over all curves of a page (signal::is_better_band), so
  /// that their envelopes are comparable.
  void consider_band(const std::string& curve, const std::vector<double>& values);
  /// @param still the values are constant: their envelope is not computed
  [[nodiscard]] SpectrumSamples samples_of(const std::vector<double>& values, bool still) const;

  /// "Hz", "shaft orders"
  [[nodiscard]] std::string unit() const;
  /// Band, speed and its source, limits of orders; empty for plain spectra.
  [[nodiscard]] std::string note() const;
  /// Marks over the abscissa: their mean frequency, or their events per revolution.
  [[nodiscard]] std::vector<desktop::ChartMark> marks() const;
  [[nodiscard]] bool over_orders() const { return over_orders_; }

 private:
  [[nodiscard]] SpectrumSamples envelope_of(SpectrumSamples of) const;
  [[nodiscard]] SpectrumSamples samples_over_angle(const std::vector<double>& turns,
                                                   const std::vector<double>& values,
                                                   double highest) const;

  const RunMotion& motion_;
  Domain domain_;
  PassBand band_;
  bool automatic_band_ = false, over_orders_ = false;
  double kurtosis_ = 0.0, change_ = 0.0;
  std::string band_curve_;  ///< curve that the automatic band is selected for
  PartRotation part_rotation_;
  double min_part_speed_ = 0.0, max_part_speed_ = 0.0;  ///< of the part [rev/s]
};

}  // namespace adore::adrplot

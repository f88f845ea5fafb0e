#pragma once

#include "bearing/life_inputs.hpp"
#include "life/constants.hpp"

#include <vector>

/// Stress-capacity models: updated Lundberg-Palmgren, Gupta-Zaretsky type, Ioannides-Harris type.
///
/// One hazard law for a surface that sees equal contacts, S survival, L life [1e6 rev], u stress
/// cycles per relative ring turn:
///   ln(1/S) = K X^c z^(1-h) w l_t (u L)^e
/// X stress measure, z its depth, w half width (point: a, line: 3/4 l), l_t length of the track.
/// K is never formed (1e-97 in SI): lives are ratios to a calibration contact with life 1.
/// CALIBRATED by this project on the original theory (decision 110): not the constants that the
/// authors of the models published, which were not available.
namespace adore::life {

using bearing::LifeModel;

/// One loaded contact, or one slice of a line contact.
struct ContactPatch {
  double Q = 0.0;      ///< normal load [N]; <= 0: open
  double a = 0.0;      ///< half axis across rolling [m]; of a slice: half its length
  double b = 0.0;      ///< half axis along rolling [m]
  double p_max = 0.0;  ///< peak Hertz pressure [Pa]
};

/// Largest subsurface stresses over the peak pressure, depths over b.
struct PeakStressRatios {
  double shear_amplitude = 0.0, shear_depth = 0.0;  ///< orthogonal shear
  double max_shear = 0.0, max_shear_depth = 0.0;    ///< largest shear on the axis
  double von_mises = 0.0, von_mises_depth = 0.0;    ///< largest von Mises stress on the axis
};
/// @param k b/a, 0..1; below 1e-8 (a line contact) the limit k -> 0 @param poisson of the stressed
/// body
[[nodiscard]] PeakStressRatios peak_stress_ratios(double k, double poisson);

/// Remembers the ratios of the ellipticities seen: contacts of one race share theirs, and one costs
/// 50 µs. Keeps the last few; a ratio is rounded to a multiple of 1e-10.
class PeakStressCache {
 public:
  const PeakStressRatios& at(double k, double poisson);

 private:
  struct Entry {
    double k, poisson;
    PeakStressRatios ratios;
  };
  std::vector<Entry> entries_;
  std::size_t next_ = 0;
};

/// Loading of a surface per relative ring revolution.
struct TrackLoading {
  double length = 0.0;  ///< l_t [m]: race π d_m (1∓γ), element π D
  double cycles = 0.0;  ///< u: race Z(1±γ)/2, element d_m(1-γ²)/(2D) per race
};
/// Upper sign inner race; γ = D cos α/d_m.
[[nodiscard]] TrackLoading race_track_loading(double pitch_diameter, double gamma, int count,
                                              bool inner);
[[nodiscard]] TrackLoading element_track_loading(double pitch_diameter, double diameter,
                                                 double gamma);

/// Exponents and factor of one model on one component.
struct StressModel {
  LifeModel model = LifeModel::Updated;  ///< not Original
  bool line = false;
  double hazard_exponent = 0.0;  ///< c; Gupta-Zaretsky: its life exponent times e
  double depth_exponent = 0.0;   ///< h; 0 for Gupta-Zaretsky
  double slope = 0.0;            ///< e
  double factor = 1.0;           ///< multiplies the dynamic stress capacity p_c
  double limit = 0.0;            ///< Ioannides-Harris: fatigue limit, von Mises [Pa]
  bearing::LimitForm form = bearing::LimitForm::Peak;
};

/// One model, calibrated with its own exponents: the calibration contact keeps life 1.
class StressLife {
 public:
  /// @throws InputError when exponents or slope give no falling life (c - h + 2 <= 0, e <= 0).
  explicit StressLife(const StressModel& model);

  /// Pressure exponent n: L ~ p^-n where no limit acts: (c-h+2)/e point, (c-h+1)/e line.
  [[nodiscard]] double pressure_exponent() const noexcept { return n_; }
  /// Life [1e6 rev] of a surface whose contacts are all like this one; infinite when it is open or
  /// stays under the limit. Shear peaks are taken at the patch's own ellipticity.
  /// @param poisson of the stressed body
  [[nodiscard]] double life(const ContactPatch& patch, const TrackLoading& track, double poisson,
                            PeakStressCache& peaks) const;
  /// Dynamic stress capacity p_c: the peak pressure of life 1 at the patch's ellipticity [Pa].
  [[nodiscard]] double stress_capacity(const ContactPatch& patch, const TrackLoading& track,
                                       double poisson, PeakStressCache& peaks) const;
  [[nodiscard]] const StressModel& model() const noexcept { return model_; }

 private:
  struct StressMeasure {
    double stress = 0.0, depth = 0.0;  ///< [Pa, m]; the integral form puts its own scale in both
  };
  [[nodiscard]] StressMeasure measure(const ContactPatch& patch, double poisson, double limit,
                                      PeakStressCache& peaks) const;
  [[nodiscard]] double log_hazard(const ContactPatch& patch, const TrackLoading& track,
                                  double poisson, double limit, PeakStressCache& peaks) const;

  StressModel model_;
  double n_ = 0.0;
  double reference_ = 0.0;  ///< log_hazard of the calibration contact
};

/// A calibration contact at its Lundberg-Palmgren capacity load.
struct CalibrationState {
  ContactPatch patch;
  TrackLoading track;
  double poisson = 0.0;
};
[[nodiscard]] const CalibrationState& calibration_state(bool line);

/// The patch under another peak pressure: a point contact scales both axes, a line contact b only.
[[nodiscard]] ContactPatch scale_patch_to_pressure(const ContactPatch& patch, double pressure,
                                                   bool line);

}  // namespace adore::life

#include "life/stress_life.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "bearing/bearing.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/subsurface.hpp"
#include "life/capacity.hpp"
#include "life/depth_integral.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace adore::life {
namespace {

/// Von Mises peak over orthogonal shear peak of a line contact at ν = 0.3: turns a von Mises limit
/// into the shear limit that a line contact reaches at the same pressure (derived).
double mises_over_shear() {
  static const double ratio = [] {
    const PeakStressRatios line = peak_stress_ratios(0.0, 0.3);
    return line.von_mises / line.shear_amplitude;
  }();
  return ratio;
}

CalibrationState point_calibration() {
  const LifeConstants& c = constants();
  const CalibrationContact& r = c.point;
  const double pitch = r.diameter / r.gamma;
  const double capacity = point_capacity(
      {r.diameter, r.gamma, 1.0, r.count, true, 0.5 * r.diameter, r.conformity * r.diameter, 0.0});
  bearing::BallGeometry balls;
  balls.count = r.count;
  balls.diameter = r.diameter;
  balls.pitch_diameter = pitch;
  balls.groove_factor = {r.conformity, r.conformity};
  const double one = c.elastic_modulus / (1.0 - c.poisson_ratio * c.poisson_ratio);
  const contact::HertzConstants hertz =
      contact::hertz_constants(contact::race_curvature(balls, 1, 0.0), 0.5 * one);
  CalibrationState out;
  out.patch.Q = capacity;
  out.patch.a = hertz.a_hat * std::cbrt(capacity);
  out.patch.b = hertz.b_hat * std::cbrt(capacity);
  out.patch.p_max = 1.5 * capacity / (kPi * out.patch.a * out.patch.b);
  out.track = race_track_loading(pitch, r.gamma, r.count, true);
  out.poisson = c.poisson_ratio;
  return out;
}

CalibrationState line_calibration() {
  const LifeConstants& c = constants();
  const CalibrationContact& r = c.line;
  const double pitch = r.diameter / r.gamma;
  const double capacity =
      line_capacity({r.diameter, r.gamma, 1.0, r.count, true, 0.0, 0.0, r.length});
  const double E_star = 0.5 * c.elastic_modulus / (1.0 - c.poisson_ratio * c.poisson_ratio);
  const double radius = 0.5 * r.diameter * (1.0 - r.gamma);  // 1/R = 2/D (1 + γ/(1-γ))
  CalibrationState out;
  out.patch.Q = capacity;
  out.patch.a = 0.5 * r.length;
  out.patch.b = std::sqrt(4.0 * capacity * radius / (kPi * r.length * E_star));
  out.patch.p_max = 2.0 * capacity / (kPi * out.patch.b * r.length);
  out.track = race_track_loading(pitch, r.gamma, r.count, true);
  out.poisson = c.poisson_ratio;
  return out;
}

}  // namespace

const CalibrationState& calibration_state(bool line) {
  static const CalibrationState point = point_calibration();
  static const CalibrationState roller = line_calibration();
  return line ? roller : point;
}

PeakStressRatios peak_stress_ratios(double k, double poisson) {
  // A line contact is the long ellipse: its ratios differ from the limit by about 0.2 k.
  const contact::SubsurfaceStress s =
      contact::subsurface_stress(1.0 / std::max(k, 1e-8), 1.0, 1.0, poisson);
  return {s.orthogonal_shear, s.orthogonal_depth, s.max_shear,
          s.max_shear_depth,  s.von_mises,        s.octahedral_depth};
}

const PeakStressRatios& PeakStressCache::at(double k, double poisson) {
  // On a grid: what was asked before must not show in the answer.
  constexpr double kGrid = 1e10;
  k = std::round(k * kGrid) / kGrid;
  for (const Entry& entry : entries_)
    if (entry.k == k && entry.poisson == poisson) return entry.ratios;
  constexpr std::size_t kKept = 64;
  const Entry entry{k, poisson, peak_stress_ratios(k, poisson)};
  if (entries_.size() < kKept) return entries_.emplace_back(entry).ratios;
  Entry& slot = entries_[next_++ % kKept];
  slot = entry;
  return slot.ratios;
}

TrackLoading race_track_loading(double pitch_diameter, double gamma, int count, bool inner) {
  const double s = inner ? gamma : -gamma;
  return {kPi * pitch_diameter * (1.0 - s), 0.5 * count * (1.0 + s)};
}

TrackLoading element_track_loading(double pitch_diameter, double diameter, double gamma) {
  return {kPi * diameter, 0.5 * pitch_diameter * (1.0 - gamma * gamma) / diameter};
}

ContactPatch scale_patch_to_pressure(const ContactPatch& patch, double pressure, bool line) {
  const double r = pressure / patch.p_max;
  return {patch.Q * (line ? r * r : r * r * r), line ? patch.a : patch.a * r, patch.b * r,
          pressure};
}

StressLife::StressLife(const StressModel& model) : model_(model) {
  if (!(model.slope > 0.0))
    throw InputError(fmt::format(
        "fatigue life: the Weibull slope is {}; it must be above 0, e.g. 1.111", model.slope));
  if (!(model.factor > 0.0))
    throw InputError(fmt::format(
        "fatigue life: the factor on the dynamic stress capacity is {}; it must be above 0",
        model.factor));
  const double power = model.hazard_exponent - model.depth_exponent + (model.line ? 1.0 : 2.0);
  if (!(model.hazard_exponent > 0.0 && power > 0.0))
    throw InputError(
        fmt::format("fatigue life: the stress exponent {} and the depth exponent {} give a life "
                    "that does not decrease with load; the stress exponent must be larger than 0 "
                    "and larger than (depth exponent - {})",
                    model.hazard_exponent, model.depth_exponent, model.line ? 1 : 2));
  n_ = power / model.slope;
  const CalibrationState& at = calibration_state(model.line);
  PeakStressCache peaks;
  // The limit of the calibration stays at its value (684 MPa), independent of the limit in use.
  const double limit = model.model == LifeModel::Harris ? constants().harris_limit : 0.0;
  reference_ = log_hazard(at.patch, at.track, at.poisson, limit, peaks);
}

StressLife::StressMeasure StressLife::measure(const ContactPatch& patch, double poisson,
                                              double limit, PeakStressCache& peaks) const {
  const double k = model_.line ? 0.0 : patch.b / patch.a;
  const PeakStressRatios& r = peaks.at(k, poisson);
  switch (model_.model) {
    case LifeModel::Updated:
      return {r.shear_amplitude * patch.p_max, r.shear_depth * patch.b};
    case LifeModel::Zaretsky:
      return {r.max_shear * patch.p_max, r.max_shear_depth * patch.b};
    case LifeModel::Harris:
      return {r.von_mises * patch.p_max - limit, r.von_mises_depth * patch.b};
    case LifeModel::Original:
      break;
  }
  throw InternalError(
      "a subsurface stress was requested for the original Lundberg-Palmgren life, which does not "
      "use one");
}

double StressLife::log_hazard(const ContactPatch& patch, const TrackLoading& track, double poisson,
                              double limit, PeakStressCache& peaks) const {
  const double c = model_.hazard_exponent, h = model_.depth_exponent;
  const double width = model_.line ? 1.5 * patch.a : patch.a;  // 3/4 of the length 2a
  const double common = std::log(width * track.length) + model_.slope * std::log(track.cycles);
  if (model_.model == LifeModel::Harris && model_.form == bearing::LimitForm::Integral) {
    const double integral = depth_integral(limit / mises_over_shear() / patch.p_max, c, h);
    if (!(integral > 0.0)) return -kInfinity;
    return c * std::log(patch.p_max) + (1.0 - h) * std::log(patch.b) + std::log(integral) + common;
  }
  const StressMeasure m = measure(patch, poisson, limit, peaks);
  if (!(m.stress > 0.0)) return -kInfinity;
  if (h != 1.0 && !(m.depth > 0.0))
    throw InputError(
        fmt::format("fatigue life: with Poisson's ratio {} the largest stress of this contact is "
                    "at the surface, where a model with a depth exponent is not defined",
                    poisson));
  return c * std::log(m.stress) + (h == 1.0 ? 0.0 : (1.0 - h) * std::log(m.depth)) + common;
}

double StressLife::life(const ContactPatch& patch, const TrackLoading& track, double poisson,
                        PeakStressCache& peaks) const {
  if (!(patch.Q > 0.0)) return kInfinity;
  const double hazard = log_hazard(patch, track, poisson, model_.limit, peaks);
  return std::exp((reference_ - hazard) / model_.slope + n_ * std::log(model_.factor));
}

double StressLife::stress_capacity(const ContactPatch& patch, const TrackLoading& track,
                                   double poisson, PeakStressCache& peaks) const {
  // ln L falls steadily with ln p (from infinity where a limit acts): bisection, some 50 cheap
  // steps.
  const auto log_life = [&](double log_p) {
    return std::log(
        life(scale_patch_to_pressure(patch, std::exp(log_p), model_.line), track, poisson, peaks));
  };
  double low = std::log(1e5), high = std::log(1e12);  // L(low) > 1 > L(high) for any real bearing
  for (int n = 0; n < 200 && high - low > 1e-14 * high; ++n) {
    const double mid = 0.5 * (low + high);
    (log_life(mid) > 0.0 ? low : high) = mid;
  }
  return std::exp(0.5 * (low + high));
}

}  // namespace adore::life

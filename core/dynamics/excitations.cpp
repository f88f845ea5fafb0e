#include "dynamics/excitations.hpp"

#include <numbers>

namespace adore::dynamics {

RotatingLoad::RotatingLoad(const std::array<Vec3, 2>& static_centre,
                           const std::array<double, 2>& fraction,
                           const std::array<double, 2>& speed) noexcept
    : centre_(static_centre), speed_(speed) {
  const Vec3 deflection = static_centre[1] - static_centre[0];
  const double size = std::hypot(deflection[1], deflection[2]);
  azimuth_ = azimuth(deflection);
  radius_ = {-fraction[0] * size, fraction[1] * size};
}

PrescribedMotion RotatingLoad::at(int race, double t) const noexcept {
  const auto j = static_cast<std::size_t>(race);
  const double w = speed_[j], radius = radius_[j];
  const Vec3 direction = radial_direction(azimuth_ + w * t);
  return {centre_[j] + radius * (direction - radial_direction(azimuth_)),
          radius * w * circumferential_direction(azimuth_ + w * t), -radius * w * w * direction};
}

PrescribedMotion vibration(const Vec3& static_centre, const Vec3& amplitude, double frequency,
                           double t) noexcept {
  const double w = 2.0 * std::numbers::pi * frequency;
  const double s = std::sin(w * t), c = std::cos(w * t);
  return {static_centre + s * amplitude, w * c * amplitude, -w * w * s * amplitude};
}

PrescribedRotation ramped_rotation(double start_speed, const SpeedRamp& ramp, double t) noexcept {
  if (!(ramp.end > ramp.begin)) return {start_speed * t, start_speed, 0.0};
  const double inside = std::clamp(t, ramp.begin, ramp.end) - ramp.begin;
  const double after = std::max(0.0, t - ramp.end);
  const bool acts = t >= ramp.begin && t < ramp.end;
  return {start_speed * t + ramp.acceleration * inside * (0.5 * inside + after),
          start_speed + ramp.acceleration * inside, acts ? ramp.acceleration : 0.0};
}

PrescribedRotation varying_rotation(double start_speed, double amplitude, double frequency,
                                    double t) noexcept {
  const double w = 2.0 * std::numbers::pi * frequency;
  if (w == 0.0) return {start_speed * t, start_speed, 0.0};
  const double half = std::sin(0.5 * w * t);  // 1 - cos = 2 sin² keeps its digits at small t
  return {start_speed * t + 2.0 * amplitude / w * half * half,
          start_speed + amplitude * std::sin(w * t), amplitude * w * std::cos(w * t)};
}

RaceMotionLaws::RaceMotionLaws(const std::array<Vec3, 2>& static_centre,
                               const bearing::RaceMotions& motions)
    : centre_(static_centre), motions_(motions) {
  if (motions.rotating_load_parameters)
    rotating_load_.emplace(static_centre, motions.rotating_load_parameters->fraction,
                           motions.rotating_load_parameters->speed);
}

PrescribedMotion RaceMotionLaws::place(int race, double t) const noexcept {
  const auto j = static_cast<std::size_t>(race);
  PrescribedMotion out{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const auto add = [&out](const PrescribedMotion& motion, const Vec3& at_rest) {
    out.position += motion.position - at_rest;
    out.velocity += motion.velocity;
    out.acceleration += motion.acceleration;
  };
  if (rotating_load_) add(rotating_load_->at(race, t), centre_[j]);
  if (const auto& v = motions_.vibration[j])
    add(vibration(Vec3::Zero(), v->amplitude, v->frequency, t), Vec3::Zero());
  return out;
}

PrescribedRotation RaceMotionLaws::turn(int race, double t) const noexcept {
  const auto j = static_cast<std::size_t>(race);
  PrescribedRotation out;
  const auto add = [&out](const PrescribedRotation& turn) {
    out.angle += turn.angle;
    out.speed += turn.speed;
    out.acceleration += turn.acceleration;
  };
  if (const auto& ramp = motions_.ramp[j])
    add(ramped_rotation(0.0, {ramp->acceleration, ramp->begin, ramp->end}, t));
  if (const auto& variation = motions_.variation[j])
    add(varying_rotation(0.0, variation->amplitude, variation->frequency, t));
  return out;
}

}  // namespace adore::dynamics

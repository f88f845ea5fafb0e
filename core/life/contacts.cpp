#include "life/contacts.hpp"

#include <cmath>
#include <numbers>

namespace adore::life {
namespace {

/// Mean over the loaded contacts; the nominal angle without load.
class MeanAngle {
 public:
  void add(double load, double angle) {
    if (!(load > 0.0) || !std::isfinite(angle)) return;
    sum_ += std::abs(angle);
    ++count_;
  }
  [[nodiscard]] double value(double nominal) const { return count_ > 0 ? sum_ / count_ : nominal; }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

void set_motion(BearingContacts& out, double outer_speed, double inner_speed) {
  out.relative_speed = std::abs(inner_speed - outer_speed);
  out.race[0].rotating = outer_speed != 0.0;
  out.race[1].rotating = inner_speed != 0.0 || outer_speed == 0.0;
}

}  // namespace

LifeGeometry ball_life_geometry(const bearing::BallGeometry& balls) {
  LifeGeometry out;
  out.count = balls.count;
  out.diameter = balls.diameter;
  out.pitch_diameter = balls.pitch_diameter;
  out.nominal_angle = balls.contact_angle;
  out.profile_radius = 0.5 * balls.diameter;
  for (std::size_t i = 0; i < 2; ++i)
    out.groove_radius[i] = balls.groove_factor[i] * balls.diameter;
  return out;
}

BearingContacts life_contacts(const statics::StaticSolution& solution,
                              const bearing::Bearing& bearing) {
  BearingContacts out;
  for (std::size_t i = 0; i < 2; ++i) {
    MeanAngle angle;
    for (const statics::StaticBall& ball : solution.balls) {
      out.race[i].patches.push_back({ball.Q[i], ball.a[i], ball.b[i], ball.p_max[i]});
      angle.add(ball.Q[i], ball.alpha[i]);
    }
    out.race[i].angle = angle.value(bearing.balls.contact_angle);
  }
  set_motion(out, bearing.speed[0], bearing.speed[1]);
  return out;
}

LifeGeometry roller_life_geometry(const bearing::RollerGeometry& rollers,
                                  const statics::RollerSolution& solution) {
  LifeGeometry out;
  out.line = !solution.rollers.empty() && !solution.rollers.front().race[0].slice_load.empty();
  out.count = rollers.count;
  out.diameter = rollers.diameter;
  out.pitch_diameter = rollers.pitch_diameter;
  out.nominal_angle = rollers.axis_angle;
  out.length = rollers.contact_length();
  out.profile_radius = rollers.crown_radius;
  for (std::size_t i = 0; i < 2; ++i)
    out.groove_radius[i] = 2.0 * rollers.groove_factor[i] * rollers.crown_radius;
  return out;
}

BearingContacts life_contacts(const statics::RollerSolution& solution,
                              const bearing::Bearing& bearing) {
  BearingContacts out;
  const double width = solution.slice_width;
  for (std::size_t i = 0; i < 2; ++i) {
    MeanAngle angle;
    for (const statics::StaticRoller& roller : solution.rollers) {
      const statics::RollerRaceContact& contact = roller.race[i];
      angle.add(contact.load, contact.contact_angle);
      if (contact.slice_load.empty())
        out.race[i].patches.push_back(
            {contact.load, 0.5 * contact.length, contact.half_width, contact.peak_pressure});
      else
        out.slices = contact.slice_load.size();
      for (std::size_t k = 0; k < contact.slice_load.size(); ++k) {
        const double Q = contact.slice_load[k], p = contact.slice_pressure[k];
        const double b = Q > 0.0 ? 2.0 * Q / (std::numbers::pi * p * width) : 0.0;
        out.race[i].patches.push_back({Q, 0.5 * width, b, p});
      }
    }
    out.race[i].angle = angle.value(bearing.rollers->race_angle[i]);
  }
  set_motion(out, bearing.speed[0], bearing.speed[1]);
  return out;
}

BearingContacts life_contacts(const dynamics::Snapshot& snapshot, const bearing::Bearing& bearing) {
  BearingContacts out;
  for (std::size_t i = 0; i < 2; ++i) {
    MeanAngle angle;
    for (const dynamics::ElementSnapshot& element : snapshot.elements) {
      const dynamics::RaceContactSnapshot& c = element.race[i];
      out.race[i].patches.push_back({c.load, c.half_major, c.half_minor, c.max_pressure});
      angle.add(c.load, c.angle);
    }
    out.race[i].angle = angle.value(bearing.balls.contact_angle);
  }
  set_motion(out, snapshot.races[0].omega.x(), snapshot.races[1].omega.x());
  if (out.relative_speed > 0.0)
    for (const dynamics::ElementSnapshot& element : snapshot.elements) {
      const dynamics::Vec3 orbiting = element.omega - dynamics::Vec3(element.theta_dot, 0.0, 0.0);
      out.element_turns.push_back(orbiting.norm() / out.relative_speed);
    }
  return out;
}

}  // namespace adore::life

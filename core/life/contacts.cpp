#include "life/contacts.hpp"

#include "contact/hertz.hpp"
#include "contact/line_contact.hpp"
#include "contact/roller_shape.hpp"
#include "scene/no_film.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Patches of one roller against one race.
class RollerPatches {
 public:
  RollerPatches(const bearing::Bearing& bearing, std::size_t race, std::size_t roller)
      : E_star_(bearing::contact_modulus(bearing.element_material, bearing.race_material[race])),
        length_(bearing.rollers()->contact_length()) {
    const bearing::RollerGeometry& g = *bearing.rollers();
    curvature_ =
        contact::roller_race_curvature(g, contact::roller_profile(g, g.deviation_of(roller)),
                                       static_cast<int>(race), g.race_profile_radius(race));
  }
  /// The whole roller as a line under a uniform load.
  [[nodiscard]] ContactPatch line(double load) const {
    const contact::LinePressure at =
        contact::line_pressure(load / length_, curvature_.rolling, E_star_);
    return {load, 0.5 * length_, at.half_width, at.peak};
  }
  /// Crowns so flat that the ellipse would be a thousand rollers long count as none.
  [[nodiscard]] bool has_ellipse() const { return curvature_.along > 1e-9 * curvature_.rolling; }
  [[nodiscard]] ContactPatch ellipse(double load) const {
    if (!(load > 0.0)) return {};
    const auto [low, high] = std::minmax(curvature_.rolling, curvature_.along);
    const contact::HertzConstants h = contact::hertz_constants({low, high}, E_star_);
    ContactPatch out{load, h.a_hat * std::cbrt(load), h.b_hat * std::cbrt(load), 0.0};
    out.p_max = 1.5 * load / (std::numbers::pi * out.a * out.b);
    return out;
  }

 private:
  double E_star_, length_;
  contact::RollerRaceCurvature curvature_;
};

bool has_split_race(const bearing::Bearing& bearing) {
  return bearing.balls().shim[0] > 0.0 || bearing.balls().shim[1] > 0.0;
}

/// Halves of split races are tracks of their own: that of positive contact angles first.
void add_tracks(const ContactPatch& first, const ContactPatch& second, double angle,
                std::vector<ContactPatch>& out) {
  const bool backward = first.Q > 0.0 && angle < 0.0;
  out.push_back(backward ? second : first);
  out.push_back(backward ? first : second);
}

void set_motion(BearingContacts& out, double outer_speed, double inner_speed) {
  out.relative_speed = std::abs(inner_speed - outer_speed);
  out.race[0].rotating = outer_speed != 0.0;
  out.race[1].rotating = inner_speed != 0.0 || outer_speed == 0.0;
}

void set_films(BearingContacts& out, const statics::RaceResult& solution) {
  if (!solution.films) return;
  for (std::size_t i = 0; i < 2; ++i)
    if (const double lambda = solution.films->lambda[i]; lambda > 0.0)
      out.film_parameter[i] = lambda;
    else if (lambda == 0.0 && solution.films->meniscus <= 0.0)
      out.film_parameter[i] = scene::kNoFilmLeft;  // no oil reaches the contacts
}

/// Slices of an instant as a quasi-static solution has them.
statics::RollerSolution solution_of(const scene::Snapshot& snapshot,
                                    const bearing::Bearing& bearing) {
  statics::RollerSolution out;
  for (const scene::ElementSnapshot& element : snapshot.elements) {
    statics::StaticRoller& roller = out.rollers.emplace_back();
    for (std::size_t j = 0; j < 2; ++j) {
      const scene::RaceContactSnapshot& c = element.race[j];
      roller.race[j].load = c.load;
      roller.race[j].contact_angle = c.load > 0.0 ? c.angle : std::nan("");
      roller.race[j].slice_load = c.slice_load;
      roller.race[j].slice_pressure = c.slice_pressure;
      out.slice_width =
          bearing.rollers()->contact_length() / static_cast<double>(c.slice_load.size());
    }
  }
  return out;
}

}  // namespace

LifeGeometry ball_life_geometry(const bearing::BallGeometry& balls) {
  LifeGeometry out;
  out.count = balls.count;
  out.diameter = balls.diameter;
  out.pitch_diameter = balls.pitch_diameter;
  out.nominal_angle = balls.contact_angle;
  out.profile_radius.fill(0.5 * balls.diameter);
  for (std::size_t i = 0; i < 2; ++i)
    out.groove_radius[i] = balls.groove_factor[i] * balls.diameter;
  return out;
}

BearingContacts life_contacts(const statics::StaticSolution& solution,
                              const bearing::Bearing& bearing) {
  BearingContacts out;
  const bool split = has_split_race(bearing);
  out.slices = split ? 2 : 1;
  for (std::size_t i = 0; i < 2; ++i) {
    MeanAngle angle;
    for (const statics::StaticBall& ball : solution.balls) {
      const ContactPatch first{ball.Q[i], ball.a[i], ball.b[i], ball.p_max[i]};
      const statics::SecondContact& second = ball.second[i];
      if (split)
        add_tracks(first, {second.Q, second.a, second.b, second.p_max}, ball.alpha[i],
                   out.race[i].patches);
      else
        out.race[i].patches.push_back(first);
      angle.add(ball.Q[i], ball.alpha[i]);
      angle.add(second.Q, second.alpha);
    }
    out.race[i].angle = angle.value(bearing.balls().contact_angle);
  }
  set_motion(out, bearing.speed[0], bearing.speed[1]);
  set_films(out, solution);
  return out;
}

LifeGeometry roller_life_geometry(const bearing::RollerGeometry& rollers) {
  LifeGeometry out;
  out.line = true;
  out.count = rollers.count;
  out.diameter = rollers.diameter;
  out.pitch_diameter = rollers.pitch_diameter;
  out.nominal_angle = rollers.axis_angle;
  out.length = rollers.contact_length();
  const contact::RollerProfile profile = contact::roller_profile(rollers);
  const bool crowned = profile.kind == contact::RollerProfile::Kind::Crowned;
  for (std::size_t i = 0; i < 2; ++i) {
    out.profile_radius[i] = profile.crown_radius;
    out.groove_radius[i] = rollers.race_profile_radius(i);
    if (crowned) out.land[i] = profile.central_length;
    if (!(rollers.race_crown_radius[i] > 0.0)) continue;
    // Two crowns count as one against a straight race, with the shorter land of those that bend.
    const double own = 1.0 / profile.crown_radius, race = 1.0 / rollers.race_crown_radius[i];
    out.profile_radius[i] = 1.0 / (own + race);
    out.groove_radius[i] = std::numeric_limits<double>::infinity();
    constexpr double kHardly = 1e-3;
    if (race < kHardly * own) continue;
    const double land = rollers.race_central_length[i];
    out.land[i] = own < kHardly * race ? land : std::min(out.land[i], land);
  }
  return out;
}

BearingContacts life_contacts(const statics::RollerSolution& solution,
                              const bearing::Bearing& bearing) {
  BearingContacts out;
  const double width = solution.slice_width;
  for (std::size_t i = 0; i < 2; ++i) {
    MeanAngle angle;
    for (std::size_t number = 0; number < solution.rollers.size(); ++number) {
      const statics::RollerRaceContact& contact = solution.rollers[number].race[i];
      angle.add(contact.load, contact.contact_angle);
      const RollerPatches whole(bearing, i, number);
      if (whole.has_ellipse()) out.race[i].ellipses.push_back(whole.ellipse(contact.load));
      if (contact.slice_load.empty())
        out.race[i].patches.push_back(whole.line(contact.load));
      else
        out.slices = contact.slice_load.size();
      for (std::size_t k = 0; k < contact.slice_load.size(); ++k) {
        const double Q = contact.slice_load[k], p = contact.slice_pressure[k];
        const double b = Q > 0.0 ? 2.0 * Q / (std::numbers::pi * p * width) : 0.0;
        out.race[i].patches.push_back({Q, 0.5 * width, b, p});
      }
    }
    // A crown of infinite radius: no ellipses at all.
    if (out.race[i].ellipses.size() != solution.rollers.size()) out.race[i].ellipses.clear();
    out.race[i].angle = angle.value(bearing.rollers()->race_angle[i]);
  }
  set_motion(out, bearing.speed[0], bearing.speed[1]);
  set_films(out, solution);
  return out;
}

BearingContacts life_contacts(const scene::Snapshot& snapshot, const bearing::Bearing& bearing) {
  BearingContacts out;
  if (bearing.rollers() != nullptr) out = life_contacts(solution_of(snapshot, bearing), bearing);
  for (std::size_t i = 0; i < 2 && bearing.rollers() == nullptr; ++i) {
    MeanAngle angle;
    const bool split = has_split_race(bearing);
    out.slices = split ? 2 : 1;
    out.race[i].patches.reserve(out.slices * snapshot.elements.size());
    for (const scene::ElementSnapshot& element : snapshot.elements) {
      const scene::RaceContactSnapshot& c = element.race[i];
      const ContactPatch first{c.load, c.half_major, c.half_minor, c.max_pressure};
      angle.add(c.load, c.angle);
      if (!split) {
        out.race[i].patches.push_back(first);
        continue;
      }
      const scene::RaceContactSnapshot second =
          element.second.empty() ? scene::RaceContactSnapshot{} : element.second[i];
      add_tracks(first, {second.load, second.half_major, second.half_minor, second.max_pressure},
                 c.angle, out.race[i].patches);
      angle.add(second.load, second.angle);
    }
    out.race[i].angle = angle.value(bearing.balls().contact_angle);
  }
  set_motion(out, snapshot.races[0].omega.x(), snapshot.races[1].omega.x());
  // Λ of a race is that of its most loaded contact.
  for (std::size_t i = 0; i < 2; ++i) {
    double heaviest = 0.0;
    for (const scene::ElementSnapshot& element : snapshot.elements) {
      const scene::RaceContactSnapshot& c = element.race[i];
      if (!(c.film_parameter > 0.0) || !(c.load > heaviest)) continue;
      heaviest = c.load;
      out.film_parameter[i] = c.film_parameter;
    }
  }
  if (out.relative_speed > 0.0) out.element_turns.reserve(snapshot.elements.size());
  if (out.relative_speed > 0.0)
    for (const scene::ElementSnapshot& element : snapshot.elements) {
      const scene::Vec3 orbiting = element.omega - scene::Vec3(element.theta_dot, 0.0, 0.0);
      out.element_turns.push_back(orbiting.norm() / out.relative_speed);
    }
  return out;
}

}  // namespace adore::life

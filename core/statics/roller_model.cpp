#include "statics/roller_model.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "contact/hertz.hpp"
#include "contact/race_errors.hpp"
#include "contact/roller_shape.hpp"
#include "contact/slice_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace adore::statics {
namespace {

constexpr std::size_t kNominal =
    std::numeric_limits<std::size_t>::max();  // no roller has this number

[[noreturn]] void refuse(const std::string& what) {
  throw InputError("roller bearing equilibrium: " + what);
}

void check(const bearing::Bearing& b, const RollerOptions& options) {
  if (!b.rollers()) {
    refuse("the bearing has no rollers");
  }
  const auto& g = *b.rollers();
  if (g.count < 1) {
    refuse(fmt::format("{} rollers; there must be at least one", g.count));
  }
  if (options.slices < 1 || options.slices > 1000) {
    refuse(fmt::format("{} slices; give 1 to 1000", options.slices));
  }
  const bool barrel = g.shape == bearing::RollerShape::Arc;
  if (options.contact == RollerContact::Point && !barrel) {
    refuse(
        "point contact needs rollers whose profile is one arc over the whole length (bearing types "
        "3 and 5). Use slices (run option rollerContact=sliced)");
  }
  if (options.kinematics == RollerKinematics::Linear && b.type != bearing::Type::Cylindrical) {
    refuse("linear kinematics are available for cylindrical rollers only");
  }
  if (options.kinematics == RollerKinematics::Linear &&
      (g.race_crown_radius[0] > 0.0 || g.race_crown_radius[1] > 0.0)) {
    refuse("linear kinematics are not available for crowned raceways");
  }
  if (!(std::isfinite(b.speed[0]) && std::isfinite(b.speed[1]))) {
    refuse(fmt::format("the race speeds are {} and {} rad/s; they must be finite numbers",
                       b.speed[0], b.speed[1]));
  }
  if (!(b.element_inertia.mass > 0.0)) {
    refuse(
        fmt::format("the mass of a roller is {} kg; it must be positive", b.element_inertia.mass));
  }
  if (b.type == bearing::Type::Tapered && !g.flange[0][0] && !g.flange[1][0]) {
    refuse(
        "the tapered rollers have no flange at their large end (negative x side), so any load "
        "pushes them out. Add a rib to the inner race: kFlngInd12 = 1 and record 5F");
  }
}

contact::RollerProfile profile_of(const bearing::RollerGeometry& g, std::size_t roller) {
  contact::RollerProfile p = contact::roller_profile(g, g.deviation_of(roller));
  contact::check_roller_profile(p);
  return p;
}

/// Hertz constant of a barrel at mid contact: rolling direction 1/ρ and the race's radius over cos
/// α, along the roller the crown in the groove.
double point_constant(const RollerModel& m, std::size_t j, const contact::RollerProfile& p,
                      const contact::RaceSurface& race) {
  const auto [rolling, along] =
      contact::roller_race_curvature(m.rollers, p, static_cast<int>(j), race.groove_radius);
  if (!(along > 0.0)) {
    refuse(
        fmt::format("point contact needs a crown radius smaller than the groove radius; here the "
                    "crown radius is {:.6g} m and the groove radius {:.6g} m",
                    p.crown_radius, race.groove_radius));
  }
  const auto [low, high] = std::minmax(rolling, along);
  return contact::hertz_constants({low, high}, m.E_star[j]).K;
}

/// Both races as they are at one azimuth.
void place_races(const RollerModel& m, const bearing::Imperfections& errors, double psi,
                 RollerContactGeometry& body) {
  body.race = m.race;
  for (std::size_t j = 0; j < 2; ++j) {
    if (errors.race[j].ideal() || bearing::table_of(errors.race[j].given.get()) != nullptr) {
      continue;
    }
    const contact::RaceSurface& ideal = m.race[j];
    const contact::LocalRaceError e =
        contact::race_error_at(errors.race[j], m.rollers.race_radius(static_cast<int>(j)), psi);
    body.race[j] = contact::race_with_error(ideal, e, 2.0 * m.rollers.crown_radius,
                                            contact::nominal_groove_normal(ideal));
    if (j == bearing::kInner) {
      body.inner_slope = e.radius_slope;
    }
  }
}

RollerContactGeometry body_of(const RollerModel& m, bearing::Type type,
                              const bearing::Imperfections& errors, std::size_t roller) {
  RollerContactGeometry body;
  place_races(m, errors, m.azimuth[roller], body);
  body.profile = profile_of(m.rollers, roller);
  body.slices = contact::roller_slices(body.profile, m.slicing);
  if (m.rollers.shape == bearing::RollerShape::Logarithmic) {
    for (contact::RollerSlice& slice : body.slices) {
      slice.radius -=
          contact::logarithmic_drop(slice.s, m.rollers.length, 0.00035 * m.rollers.diameter);
    }
  }
  for (std::size_t j = 0; j < 2; ++j) {
    const bearing::SurfaceTable* const table = bearing::table_of(errors.race[j].given.get());
    if (table == nullptr) {
      continue;
    }
    if (table->across != m.slicing.count) {
      refuse("the number of slices of a race surface differs from that of the rollers");
    }
    std::vector<double> radius, rise(body.slices.size());
    for (const contact::RollerSlice& slice : body.slices) {
      radius.push_back(slice.radius);
    }
    contact::apply_table_to_slices(*table, m.azimuth[roller], radius.data(), rise.data());
    if (j == bearing::kInner) {
      body.inner_slope =
          std::accumulate(rise.begin(), rise.end(), 0.0) / static_cast<double>(rise.size());
    }
    body.on_race[j] = body.slices;
    for (std::size_t k = 0; k < radius.size(); ++k) {
      body.on_race[j][k].radius = radius[k];
    }
  }
  if (m.contact == RollerContact::Point) {
    const auto& p = body.profile;
    for (std::size_t j = 0; j < 2; ++j) {
      body.point[j].race = body.race[j];
      body.point[j].race.groove_radius -= p.crown_radius;
      body.point[j].centre = {-p.crown_radius * std::sin(p.half_angle),
                              0.5 * p.diameter - p.crown_radius * std::cos(p.half_angle)};
      body.point[j].K = point_constant(m, j, p, body.race[j]);
      body.point[j].crown_radius = p.crown_radius;
      body.point[j].groove = body.race[j];
      const contact::Slicing own = contact::slicing(p, 1);
      for (std::size_t end = 0; end < 2; ++end) {
        const double s = own.start + (end == 0 ? 0.0 : own.effective_length);
        body.point[j].ends[end] = {s, contact::roller_radius(p, s)};
      }
    }
  }
  body.flanges = flange_end_pairs(type, m.rollers, m.E_star, body.profile);
  return body;
}

void add_inertia(RollerModel& m, const bearing::Bearing& b, bool guide) {
  const auto& g = m.rollers;
  const double half = 0.5 * g.diameter * std::cos(g.axis_angle);
  m.speeds = contact::rolling_speeds({0.5 * g.pitch_diameter + half, 0.5 * g.pitch_diameter - half},
                                     g.diameter, g.axis_angle, b.speed);
  m.moving = m.speeds.orbital != 0.0 || m.frame_speed != 0.0;
  m.mass = b.element_inertia.mass;
  m.mass_offset = b.roller_mass_offset;
  const double radius = 0.5 * g.pitch_diameter - m.mass_offset * std::sin(g.axis_angle);
  contact::RollingSpeeds absolute = m.speeds;
  absolute.orbital += m.frame_speed;
  m.centrifugal = m.mass * radius * absolute.orbital * absolute.orbital;
  m.gyroscopic = contact::gyroscopic_moment(absolute, g.axis_angle, b.element_inertia.moments.x(),
                                            b.element_inertia.moments.y())
                     .y();
  const bool stopped = g.flange[0][0].has_value() || g.flange[1][0].has_value();
  if (guide && g.shape == bearing::RollerShape::Arc && g.race_angle[0] > 0.0 && !stopped) {
    const double held = m.centrifugal * std::sin(g.race_angle[0]);
    m.guide = {held * std::cos(g.race_angle[0]), -held * std::sin(g.race_angle[0])};
  }
}

}  // namespace

RollerModel make_roller_model(const bearing::Bearing& b, const RollerOptions& options) {
  check(b, options);
  RollerModel m;
  m.rollers = *b.rollers();
  const auto& g = m.rollers;
  m.contact = options.contact;
  m.linear = options.kinematics == RollerKinematics::Linear;
  m.grips = !m.linear && b.type == bearing::Type::Cylindrical;
  m.race = race_surfaces(b);
  m.slicing = contact::slicing(profile_of(g, kNominal), options.slices);
  for (std::size_t j = 0; j < 2; ++j) {
    m.E_star[j] = bearing::contact_modulus(b.element_material, b.race_material[j]);
    m.line_constant[j] =
        options.line_constant > 0.0 ? options.line_constant : contact::line_constant(m.E_star[j]);
    m.law[j] = contact::power_law(m.line_constant[j], m.slicing.effective_length);
  }
  for (int k = 0; k < g.count; ++k) {
    m.azimuth.push_back(options.first_azimuth + 2.0 * kPi * k / g.count);
  }
  const auto& errors = b.imperfections;
  const bool ideal = g.deviation.empty() && errors.race[0].ideal() && errors.race[1].ideal();
  const std::size_t bodies = ideal ? 1 : static_cast<std::size_t>(g.count);
  for (std::size_t k = 0; k < bodies; ++k) {
    m.bodies.push_back(body_of(m, b.type, errors, k));
  }
  m.race_speed = b.speed;
  m.outer_tilt = b.constraints.outer_misalignment;
  if (options.frame) {
    m.frame_speed = options.frame->speed;
    m.field = options.frame->field();
  }
  add_inertia(m, b, options.guide);
  const double length = m.slicing.effective_length;
  m.line_stiffness = std::max(m.law[0].constant, m.law[1].constant) * length;
  m.lever = 0.25 * length;
  m.longest_step = 5e-3 * g.diameter + 0.25 * std::abs(g.clearance);
  return m;
}

void add_race(const RollerModel& m, const RollerContactGeometry& body, std::size_t j, const Vec4& p,
              PairPotential& sum, std::span<SliceResult> each) {
  if (m.contact == RollerContact::Point) {
    add_point_contact(body.point[j], p, sum, each.empty() ? nullptr : each.data());
  } else if (m.linear) {
    add_slices_linear(m.slices(j, body), p, sum, each);
  } else {
    add_slices(m.slices(j, body), p, sum, each);
  }
}

void set_load_floors(RollerModel& m, double bearing_load) {
  const double position = 4e-16 * m.rollers.pitch_diameter;
  const double rounding = m.line_stiffness * std::pow(position, 10.0 / 9.0);
  m.load_floor = std::max(1e-13 * bearing_load, rounding);
  const bool guided = m.guide[0] != 0.0 || m.guide[1] != 0.0;
  m.weak_floor = guided ? std::numeric_limits<double>::infinity()
                        : std::max(1e-9 * bearing_load, m.load_floor);
}

double line_approach(const RollerModel& m, double load) {
  return std::pow(std::abs(load) / m.line_stiffness, 0.9);
}

}  // namespace adore::statics

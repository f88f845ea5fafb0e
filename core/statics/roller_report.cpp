#include "statics/roller_report.hpp"

#include "base/constants.hpp"
#include "contact/hertz.hpp"
#include "contact/roller_shape.hpp"
#include "statics/race_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::statics {
namespace {

constexpr std::array<const char*, 2> kRace{"outer", "inner"};
constexpr std::array<const char*, 2> kSide{"-x", "+x"};

/// Part of the largest pressure that a contact may carry up to an edge without a warning.
constexpr double kEdgeShare = 0.1;

/// Direction of the load on the race, as a contact angle of the azimuth plane of the base frame.
double angle_of(std::size_t j, double x, double r) {
  return j == 0 ? std::atan2(x, r) : std::atan2(-x, -r);
}

/// What the solution of a roller at rest leaves below the load that counts as nothing.
RollerRaceContact without_load(RollerRaceContact contact) {
  RollerRaceContact out;
  out.delta = contact.delta;
  out.slice_load.assign(contact.slice_load.size(), 0.0);
  out.slice_pressure.assign(contact.slice_pressure.size(), 0.0);
  return out;
}

RollerRaceContact sliced_contact(const RollerModel& m, const RollerContactGeometry& body,
                                 std::size_t j, const Vec4& p) {
  RollerRaceContact out;
  std::vector<SliceResult> slices(body.slices.size());
  PairPotential sum;
  add_race(m, body, j, p, sum, slices);
  out.delta = -std::numeric_limits<double>::infinity();
  double x = 0.0;
  double r = 0.0;
  double edge_pressure = 0.0;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const SliceResult& s = slices[k];
    double pressure = 0.0;
    out.delta = std::max(out.delta, s.delta);
    if (s.load > 0.0) {
      const double curvature = 1.0 / body.slices[k].radius + s.rolling_curvature;
      const contact::LinePressure line =
          contact::line_pressure(s.load / s.width, curvature, m.E_star[j]);
      pressure = line.peak;
      out.moment += s.load * body.slices[k].s;
      out.stiffness += s.slope;
      out.length += s.width;
      x += s.load * s.normal_x;
      r += s.load * s.normal_r;
      const bool end = k == 0 || k + 1 == slices.size();
      const bool edge_of_land = s.width < m.slicing.width * (1.0 - 1e-9);
      if (end || edge_of_land) {
        edge_pressure = std::max(edge_pressure, pressure);
      }
      if (pressure > out.peak_pressure) {
        out.peak_pressure = pressure;
        out.peak_position = body.slices[k].s;
        out.half_width = line.half_width;
      }
    }
    out.slice_load.push_back(s.load);
    out.slice_pressure.push_back(pressure);
  }
  if (std::hypot(x, r) <= 10.0 * m.load_floor) {
    return without_load(std::move(out));
  }
  out.at_edge = edge_pressure > kEdgeShare * out.peak_pressure;
  out.load = std::hypot(x, r);
  if (out.load > 0.0) {
    out.contact_angle = angle_of(j, x, r);
  }
  return out;
}

RollerRaceContact point_contact(const RollerModel& m, const RollerContactGeometry& body,
                                std::size_t j, const Vec4& p) {
  RollerRaceContact out;
  PairPotential sum;
  SliceResult at;
  add_race(m, body, j, p, sum, {&at, 1});
  out.delta = at.delta;
  if (at.load <= 10.0 * m.load_floor) {
    return out;
  }
  out.load = at.load;
  out.stiffness = at.slope;
  out.contact_angle = angle_of(j, at.normal_x, at.normal_r);
  // Contact point along the roller: where the arc's normal is that of the race.
  const double across_axis = std::sqrt(1.0 - p(2) * p(2) - p(3) * p(3));
  const double along = at.normal_x * across_axis + at.normal_r * p(2);  // n·a
  const auto& g = body.profile;
  out.peak_position = body.point[j].centre.s + g.crown_radius * along;
  out.moment = at.load * out.peak_position;
  const auto [rolling, along_roller] =
      contact::roller_race_curvature(m.rollers, g, static_cast<int>(j), body.race[j].groove_radius);
  const auto [low, high] = std::minmax(rolling, along_roller);
  const contact::HertzConstants h = contact::hertz_constants({low, high}, m.E_star[j]);
  const double root = std::cbrt(at.load);
  const double a = h.a_hat * root;
  const double b = h.b_hat * root;
  out.half_width = b;
  out.length = 2.0 * a;
  out.peak_pressure = 1.5 * at.load / (kPi * a * b);
  const double start = m.slicing.start;
  out.at_edge =
      out.peak_position - a < start || out.peak_position + a > start + m.slicing.effective_length;
  return out;
}

class Notes {
 public:
  explicit Notes(const std::vector<StaticRoller>& rollers) : rollers_(rollers) {}

  /// @return the finding; nullptr: no roller
  template <class Predicate, class... Args>
  Finding* add(const char* code, Predicate predicate, fmt::format_string<Args...> what,
               Args&&... args) {
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < rollers_.size(); ++k) {
      if (predicate(rollers_[k])) {
        numbers.push_back(k + 1);
      }
    }
    if (numbers.empty()) return nullptr;
    const std::string list = number_list(numbers, "roller");
    notes_.push_back(make_finding(
        code, fmt::format("{}: {}", list, fmt::format(what, std::forward<Args>(args)...))));
    return &notes_.back().of(list);
  }
  /// The same at a race.
  template <class Predicate, class... Args>
  Finding* add_at(std::size_t race, const char* code, Predicate predicate,
                  fmt::format_string<Args...> what, Args&&... args) {
    Finding* const out = add(code, predicate, what, std::forward<Args>(args)...);
    if (out != nullptr) out->body += fmt::format(", {} race", kRace[race]);
    return out;
  }
  std::vector<Finding> take() { return std::move(notes_); }

 private:
  const std::vector<StaticRoller>& rollers_;
  std::vector<Finding> notes_;
};

}  // namespace

StaticRoller report_roller(const RollerModel& m, const Vec5& q, const RollerState& roller) {
  StaticRoller out;
  const RollerContactGeometry& body = m.body(roller.number);
  out.azimuth = m.azimuth[roller.number];
  out.x = roller.e(0);
  out.r = 0.5 * m.rollers.pitch_diameter + roller.e(1);
  out.tilt = roller.e(2) - m.rollers.axis_angle;
  out.idle = roller.idle;
  out.follow = roller.follow;
  for (std::size_t j = 0; j < 2; ++j) {
    const Vec4 p = relative_pose(m, roller, j, q);
    out.race[j] = m.contact == RollerContact::Point ? point_contact(m, body, j, p)
                                                    : sliced_contact(m, body, j, p);
    for (const FlangeEndPair& pair : body.flanges) {
      if (pair.race != static_cast<int>(j)) {
        continue;
      }
      const FlangeContactLoad touch = flange_contact_load(pair, p);
      auto& flange = out.flange[j][static_cast<std::size_t>(pair.side)];
      flange.present = true;
      flange.load = touch.load > 10.0 * m.load_floor ? touch.load : 0.0;
      flange.gap = touch.contact.gap;
      flange.height = touch.contact.height;
      flange.radius = touch.contact.from_axis;
      flange.on_face = touch.contact.mode == contact::FlangeContact::Mode::Face;
    }
  }
  return out;
}

void fill_summary(RollerSolution& s) {
  for (const StaticRoller& roller : s.rollers) {
    for (const RollerRaceContact& c : roller.race) {
      s.max_load = std::max(s.max_load, c.load);
      s.max_stiffness = std::max(s.max_stiffness, c.stiffness);
      s.max_deflection = std::max(s.max_deflection, c.delta);
    }
  }
}

std::string unloaded_position_rule(const RollerModel& m) {
  if (!m.moving) {
    return "A roller without contact has no unique position at rest. It is placed in the middle "
           "between both races and has no load.";
  }
  std::string text =
      "A roller without contact with the inner race orbits with the other rollers and touches the "
      "outer race. ";
  if (m.grips || m.linear) {
    return text +
           "Friction prevents axial sliding, so the axial position of such a roller is nominal, or "
           "as close to nominal as flanges allow.";
  }
  if (m.rollers.shape == bearing::RollerShape::Arc && !m.rollers.has_flange(0) &&
      !m.rollers.has_flange(1)) {
    return text +
           "The contact of such a roller is in the middle of the groove. Guide ring or cage "
           "support the component of the centrifugal force along the roller axis.";
  }
  return text + "Such a roller slides axially without friction until a flange stops it.";
}

std::vector<Finding> roller_notes(const RollerModel& m, const std::vector<StaticRoller>& rollers) {
  Notes notes(rollers);
  notes.add(
      "statics.unloaded", [](const StaticRoller& r) { return r.idle; },
      "no load. The position at rest is assumed: in the middle between both races");
  notes.add(
      "statics.unloaded",
      [](const StaticRoller& r) {
        return !r.idle && r.race[0].load == 0.0 && r.race[1].load == 0.0;
      },
      "no load. The position is where the roller lost its last contact");
  notes.add(
      "statics.outer_only",
      [](const StaticRoller& r) { return r.race[0].load > 0.0 && r.race[1].load == 0.0; },
      "contact with the outer race only, because of the centrifugal force");
  for (std::size_t j = 0; j < 2; ++j) {
    notes.add_at(
        j, "statics.edge_load", [j](const StaticRoller& r) { return r.race[j].at_edge; },
        "in the contact with the {} race, the pressure at a corner of the roller or at an edge of "
        "the land is more than a tenth of the largest pressure. The edge stress exceeds the "
        "printed pressure by an unknown amount, because the slices are independent of each other",
        kRace[j]);
    for (std::size_t side = 0; side < 2; ++side) {
      notes.add_at(
          j, "statics.flange_corner",
          [j, side](const StaticRoller& r) {
            const auto& f = r.flange[j][side];
            return f.load > 0.0 && !f.on_face;
          },
          "contact with the {} flange of the {} race at the roller corner or at the flange lip, "
          "where the stress is not Hertzian",
          kSide[side], kRace[j]);
    }
  }
  if (m.contact == RollerContact::Sliced) {
    // Who asks for fewer has all of them.
    const double enough = std::min(8, m.slicing.count);
    const double shortest = enough * m.slicing.width * (1.0 - 1e-9);
    for (std::size_t j = 0; j < 2; ++j) {
      const auto few = [j, shortest](const StaticRoller& r) {
        return r.race[j].load > 0.0 && r.race[j].length < shortest && r.race[0].load > 0.0 &&
               r.race[1].load > 0.0;
      };
      Finding* const found = notes.add_at(
          j, "statics.few_slices", few,
          "fewer than {} of {} slices touch the {} race; increase the number of slices (option "
          "rollerSlices) for more accurate results",
          enough, m.slicing.count, kRace[j]);
      if (found == nullptr) continue;
      double least = enough;
      for (const StaticRoller& r : rollers)
        if (few(r)) least = std::min(least, std::round(r.race[j].length / m.slicing.width));
      found->measure(least).at_least(enough);
    }
  }
  return notes.take();
}

}  // namespace adore::statics

#include "agore/ring_profile.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace adore::agore {

double length_unit(const Animation& animation) {
  return animation.file.units[0] == "in" ? 0.0254 : 1.0;
}

double dimension_in_si(const Animation& animation, const char* name, double otherwise) {
  if (!animation.motion) return otherwise;
  const auto found = animation.motion->geometry().find(name);
  return found == animation.motion->geometry().end() || !std::isfinite(found->second)
             ? otherwise
             : found->second;
}

double dimension_in_file_unit(const Animation& animation, const char* name, double otherwise) {
  const double value = dimension_in_si(animation, name, -1.0);
  return value > 0.0 ? value / length_unit(animation) : otherwise;
}

QPointF tilted_point(double x, double r, double lean, double u, double v) {
  return {x + u * std::cos(lean) - v * std::sin(lean), r + u * std::sin(lean) + v * std::cos(lean)};
}

AxisAngles axis_angles(const results::Sol8Element& element) {
  const Vec3 axis = rotation(element.angles).col(0);
  const double sine = std::sin(element.theta), cosine = std::cos(element.theta);
  const double along = std::abs(axis.x()) > 1e-9 ? axis.x() : 1.0;
  // y = -r sin, z = r cos: outward is (-sin, cos), increasing azimuth (-cos, -sin).
  return {std::atan((-axis.y() * sine + axis.z() * cosine) / along),
          std::atan((-axis.y() * cosine - axis.z() * sine) / along)};
}

double nominal_lean(const Animation& animation) {
  if (animation.file.bearing_type == 1) return 0.0;
  return axis_angles(animation.frame(0).elements.at(0)).lean;
}

namespace {

std::vector<RingRadii> ball_ring(const Animation& animation, std::size_t race, double half,
                                 double far) {
  const auto& g = animation.file.geometry;
  const bool outer = race == 0;
  const double depth = 0.5 * g.element_radius;
  const double groove = dimension_in_file_unit(
      animation, outer ? "outer_groove_radius" : "inner_groove_radius", 1.04 * g.element_radius);
  const double centre_x =
      dimension_in_si(animation, outer ? "outer_race_centre_x" : "inner_race_centre_x") /
      length_unit(animation);
  const double centre_r =
      outer ? g.outer_race_inner_radius - groove : g.inner_race_outer_radius + groove;
  const double shoulder = outer ? dimension_in_file_unit(animation, "outer_shoulder_radius",
                                                         g.outer_race_inner_radius - depth)
                                : dimension_in_file_unit(animation, "inner_shoulder_radius",
                                                         g.inner_race_outer_radius + depth);
  const auto near = [&](double x) {
    const double inside = groove * groove - (x - centre_x) * (x - centre_x);
    const double bow = inside > 0.0 ? std::sqrt(inside) : 0.0;
    // An outer groove is cut from the shoulder outward, no deeper than the ring.
    if (outer) return std::min(far, inside > 0.0 ? std::max(shoulder, centre_r + bow) : shoulder);
    return std::max(far, inside > 0.0 ? std::min(shoulder, centre_r - bow) : shoulder);
  };
  std::vector<double> places;
  constexpr int kParts = 40;
  for (int i = 0; i <= kParts; ++i) places.push_back(half * (2.0 * i / kParts - 1.0));
  // The edges of the groove are always points of the outline.
  const double reach = groove * groove - (shoulder - centre_r) * (shoulder - centre_r);
  if (reach > 0.0)
    for (const double side : {-1.0, 1.0}) {
      const double edge = centre_x + side * std::sqrt(reach);
      if (std::abs(edge) < half) places.push_back(edge);
    }
  std::sort(places.begin(), places.end());
  std::vector<RingRadii> out;
  for (const double x : places) out.push_back({x, near(x), far});
  return out;
}

std::vector<RingRadii> roller_ring(const Animation& animation, std::size_t race, double half,
                                   double far) {
  const auto& g = animation.file.geometry;
  const RollerProfile roller = roller_profile(animation);
  const double lean = nominal_lean(animation);
  const double middle_r = 0.5 * (g.outer_race_inner_radius + g.inner_race_outer_radius);
  const double middle_x = animation.frame(0).elements.at(0).x - roller.mass_centre * std::cos(lean);
  const double up = race == 0 ? 1.0 : -1.0;
  const auto height = [&](std::size_t side) {
    if (!has_flange(animation, race, side)) return 0.0;
    return dimension_in_file_unit(
        animation,
        race == 0 ? (side == 0 ? "outer_flange_minus_x_height" : "outer_flange_plus_x_height")
                  : (side == 0 ? "inner_flange_minus_x_height" : "inner_flange_plus_x_height"),
        0.2 * roller.radius);
  };
  // Across the axis, from the roller's middle: the raceway, and beyond its ends the flanges.
  std::vector<QPointF> line;
  const auto add = [&](double u, double lower) {
    line.push_back(tilted_point(middle_x, middle_r, lean, u, up * (roller.line(u) - lower)));
  };
  const double reach = roller.crown > 0.0
                           ? 0.9 * roller.crown
                           : 2.0 * half / std::max(0.3, std::cos(lean)) + roller.half;
  constexpr int kParts = 60;
  for (int i = 0; i <= kParts; ++i) {
    const double u = reach * (2.0 * i / kParts - 1.0);
    if (std::abs(u) <= roller.half || !(height(u < 0.0 ? 0 : 1) > 0.0)) add(u, 0.0);
  }
  // A flange begins at the roller end and has constant height up to the ring face.
  for (const std::size_t side : {0U, 1U}) {
    if (!(height(side) > 0.0)) continue;
    const double end = side == 0 ? -roller.half : roller.half;
    const double lower = roller.line(end) - height(side);
    std::vector<QPointF> flange;
    for (const auto& [u, v] : {std::pair{end, roller.line(end)},
                               {1.0001 * end, lower},
                               {side == 0 ? -reach : reach, lower}})
      flange.push_back(tilted_point(middle_x, middle_r, lean, u, up * v));
    if (side == 0)
      line.insert(line.begin(), flange.rbegin(), flange.rend());
    else
      line.insert(line.end(), flange.begin(), flange.end());
  }
  // Between the ring's faces.
  const auto at = [&](double x) {
    for (std::size_t i = 1; i < line.size(); ++i)
      if ((line[i - 1].x() <= x) != (line[i].x() <= x)) {
        const double part = (x - line[i - 1].x()) / (line[i].x() - line[i - 1].x());
        return line[i - 1].y() + part * (line[i].y() - line[i - 1].y());
      }
    return x < line.front().x() ? line.front().y() : line.back().y();
  };
  // No nearer to the far side than a sliver of metal.
  const auto limited = [&](double r) { return race == 0 ? std::min(r, far) : std::max(r, far); };
  std::vector<RingRadii> out{{-half, limited(at(-half)), far}};
  for (const QPointF& p : line)
    if (std::abs(p.x()) < half) out.push_back({p.x(), limited(p.y()), far});
  out.push_back({half, limited(at(half)), far});
  return out;
}

/// Free ends of a ring next to the elements, at its -x and +x side.
std::array<double, 2> beside_elements(const Animation& animation, std::size_t race) {
  const auto& g = animation.file.geometry;
  if (animation.file.bearing_type == 1) {
    const bool outer = race == 0;
    const double groove = dimension_in_file_unit(
        animation, outer ? "outer_groove_radius" : "inner_groove_radius", 1.04 * g.element_radius);
    const double shoulder =
        outer
            ? dimension_in_file_unit(animation, "outer_shoulder_radius", g.outer_race_inner_radius)
            : dimension_in_file_unit(animation, "inner_shoulder_radius", g.inner_race_outer_radius);
    const double centre_x =
        dimension_in_si(animation, outer ? "outer_race_centre_x" : "inner_race_centre_x") /
        length_unit(animation);
    const double from_centre = outer ? shoulder - g.outer_race_inner_radius + groove
                                     : g.inner_race_outer_radius + groove - shoulder;
    const double reach = std::sqrt(std::max(groove * groove - from_centre * from_centre, 0.0));
    return {centre_x - reach, centre_x + reach};
  }
  const RollerProfile roller = roller_profile(animation);
  const double lean = nominal_lean(animation);
  const double middle = animation.frame(0).elements.at(0).x - roller.mass_centre * std::cos(lean);
  std::array<double, 2> out{middle, middle};
  for (const QPointF& p : roller.meridian())
    for (const double side : {-1.0, 1.0}) {
      const double x = tilted_point(middle, 0.0, lean, p.x(), side * p.y()).x();
      out = {std::min(out[0], x), std::max(out[1], x)};
    }
  return out;
}

/// From the land to the ring's face as high as the land.
void add_land(std::vector<RingRadii>& profile, const LandSection& land,
              const std::array<double, 2>& beside) {
  const bool plus = land.low + land.high > 0.0;
  const double edge = plus ? std::max(land.low, beside[1]) : std::min(land.high, beside[0]);
  const double face = plus ? profile.back().x : profile.front().x;
  if (plus ? !(edge < face) : !(edge > face)) return;  // no space next to the elements
  const double far = profile.front().far;
  const double near = land.race == 0 ? std::min(land.on_race, far) : std::max(land.on_race, far);
  double before = plus ? profile.front().near : profile.back().near;
  std::vector<RingRadii> out;
  for (const RingRadii& column : profile)
    if (plus ? column.x < edge : column.x > edge) {
      out.push_back(column);
      if (plus || out.size() == 1) before = column.near;
    }
  const std::vector<RingRadii> step{{edge, before, far}, {edge, near, far}, {face, near, far}};
  if (plus)
    out.insert(out.end(), step.begin(), step.end());
  else
    out.insert(out.begin(), step.rbegin(), step.rend());
  profile = std::move(out);
}

}  // namespace

std::vector<LandSection> land_sections(const Animation& animation, double clearance) {
  std::vector<LandSection> out;
  for (int i = 1; animation.motion && i <= 2; ++i) {
    const std::string name = "land" + std::to_string(i) + "_";
    const auto size = [&](const char* what) {
      return dimension_in_si(animation, (name + what).c_str()) / length_unit(animation);
    };
    const double guide = dimension_in_si(animation, (name + "guide").c_str());
    const double width = size("width"), edge = size("edge"), gap = clearance * size("clearance");
    if (!animation.land[static_cast<std::size_t>(i - 1)] || !(width > 0.0)) continue;
    if (guide != 1.0 && guide != 2.0) continue;
    const double inner = edge - std::copysign(width, edge), radius = 0.5 * size("diameter");
    out.push_back({guide == 1.0 ? 0U : 1U, std::min(edge, inner), std::max(edge, inner), radius,
                   guide == 1.0 ? radius + gap : radius - gap});
  }
  return out;
}

std::vector<RingRadii> ring_profile(const Animation& animation, std::size_t race,
                                    double clearance) {
  const auto& g = animation.file.geometry;
  const bool balls = animation.file.bearing_type == 1;
  const double far = race == 0
                         ? std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius)
                         : g.inner_race_inner_radius;
  const double half =
      0.5 *
      dimension_in_file_unit(animation, race == 0 ? "outer_race_width" : "inner_race_width",
                             balls ? 2.2 * g.element_radius : 2.6 * roller_profile(animation).half);
  std::vector<RingRadii> out =
      balls ? ball_ring(animation, race, half, far) : roller_ring(animation, race, half, far);
  for (const LandSection& land : land_sections(animation, clearance))
    if (land.race == race) add_land(out, land, beside_elements(animation, race));
  return out;
}

std::vector<QPointF> ring_outline(const std::vector<RingRadii>& profile) {
  std::vector<QPointF> out;
  for (const RingRadii& column : profile) out.emplace_back(column.x, column.near);
  for (auto column = profile.rbegin(); column != profile.rend(); ++column) {
    const bool end = column == profile.rbegin() || std::next(column) == profile.rend();
    if (end || column->far != profile.front().far) out.emplace_back(column->x, column->far);
  }
  return out;
}

double CageProfile::pocket_half_length_at(double across, std::size_t end) const {
  if (round > 0.0) return std::sqrt(std::max(round * round - across * across, 0.0));
  return hole + leaning.at(end) + flare * (across - 0.5 * (low + high));
}

std::array<double, 2> end_wall_offsets(const RollerProfile& roller, double lean) {
  std::array<double, 2> out{};
  for (const QPointF& p : roller.meridian())
    for (const double side : {-1.0, 1.0}) {
      const double u = tilted_point(0.0, 0.0, lean, p.x(), side * p.y()).x();
      double& more = out[u < 0.0 ? 0 : 1];
      more = std::max(more, std::abs(u) - roller.half);
    }
  return out;
}

std::pair<double, double> land_range_on_bar(const CageProfile& cage, double pitch_radius,
                                            const LandSection& land) {
  const double middle = 0.5 * (land.low + land.high);
  if (!(std::abs(middle) > 0.25 * (land.high - land.low))) return {land.low, land.high};
  const double way = middle < 0.0 ? -1.0 : 1.0, v = land.race == 0 ? cage.high : cage.low;
  const double u = std::min(cage.pocket_half_length_at(v, middle < 0.0 ? 0 : 1), cage.half_width);
  const double edge = tilted_point(0.0, pitch_radius, cage.lean, way * u, v).x();
  return middle < 0.0 ? std::pair{land.low, std::clamp(edge, land.low, land.high)}
                      : std::pair{std::clamp(edge, land.low, land.high), land.high};
}

CageProfile cage_profile(const Animation& animation) {
  CageProfile out;
  if (!animation.has_cage) return out;
  const auto& g = animation.file.geometry;
  const bool balls = animation.file.bearing_type == 1;
  const double cone = dimension_in_si(animation, "pocket_cone_angle");
  if (!balls) out.lean = nominal_lean(animation) < 0.0 ? -std::abs(cone) : std::abs(cone);
  out.half_width = std::max(0.5 * dimension_in_file_unit(animation, "cage_width"), 0.0);
  const double half_1 = 0.5 * g.pocket_clearance_1, half_2 = 0.5 * g.pocket_clearance_2;
  // Rollers have half of clearance I at each end (decision 213).
  out.hole = half_1 + (balls ? g.element_radius
                             : 0.5 * dimension_in_file_unit(animation, "roller_length",
                                                            2.0 * g.element_radius));
  const auto shape = balls ? static_cast<int>(dimension_in_si(animation, "pocket_code")) : 0;
  constexpr int kSphere = 1, kRectangle = 3, kCone = 4;  // kPocType of balls
  if (shape == kSphere) out.round = out.hole;
  if (shape == kRectangle) out.hole = g.element_radius + half_2;
  if (shape == kCone) {  // clearance I inside, II outside
    out.hole = g.element_radius + 0.5 * (half_1 + half_2);
    out.flare = (half_2 - half_1) / std::max(g.cage_outer_radius - g.cage_inner_radius, 1e-12);
  }
  if (!(out.half_width > 0.0)) out.half_width = 1.2 * out.hole;
  out.hole = std::min(out.hole, 0.96 * out.half_width);
  if (!balls) {
    out.leaning = end_wall_offsets(roller_profile(animation), nominal_lean(animation) - out.lean);
    for (double& more : out.leaning) more = std::min(more, 0.96 * out.half_width - out.hole);
  }
  out.low = g.cage_inner_radius - 0.5 * g.pitch_diameter;
  out.high = g.cage_outer_radius - 0.5 * g.pitch_diameter;
  return out;
}

}  // namespace adore::agore

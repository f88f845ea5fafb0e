#include "agore/scene_data.hpp"

#include "agore/race_speeds.hpp"
#include "agore/solid_model.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "base/constants.hpp"
#include "base/json_text.hpp"
#include "desktop/axis_scale.hpp"
#include "results/quantities.hpp"

#include <Eigen/Geometry>
#include <QByteArray>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace adore::agore {
namespace {

using Json = nlohmann::ordered_json;
static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

template <class Number>
std::string base64(const std::vector<Number>& values) {
  const auto bytes =
      QByteArray::fromRawData(reinterpret_cast<const char*>(values.data()),
                              static_cast<qsizetype>(values.size() * sizeof(Number)));
  return bytes.toBase64().toStdString();
}

/// A quantity of the contacts at outer and inner races.
struct SceneQuantity {
  const char *name, *channel;
  const deck::UnitPair& unit;
  bool colours;
};
constexpr deck::UnitPair kRadian{"rad", "rad", 1.0, 1.0};
constexpr std::array<SceneQuantity, 7> kQuantities{
    {{"contact load", "contact.load", results::unit::kForce, true},
     {"largest pressure", "contact.pressure", results::unit::kPressure, true},
     {"contact angle", "contact.angle", kRadian, false},
     {"semi-axis a, transverse", "contact.half_major", results::unit::kLength, false},
     {"semi-axis b, rolling", "contact.half_minor", results::unit::kLength, false},
     {"largest slip", "contact.slip", results::unit::kSpeed, true},
     {"heat", "contact.heat", results::unit::kPower, true}}};

/// Numbers of a frame: both races (place, rotation), parts of the cage and elements (place,
/// quaternion), and contacts.
std::size_t numbers_of(const Animation& animation) {
  const auto n = static_cast<std::size_t>(animation.file.elements);
  const auto parts = static_cast<std::size_t>(animation.has_cage ? animation.segments : 0);
  return 8 + 7 * parts + 7 * n + 2 * n * kQuantities.size();
}

void add(std::vector<float>& out, const Vec3& place, const Mat3& attitude) {
  const Eigen::Quaterniond q(attitude);
  for (const double v : {place.x(), place.y(), place.z(), q.w(), q.x(), q.y(), q.z()})
    out.push_back(static_cast<float>(v));
}

/// Columns: the axis of the roller, then the direction of its mark.
Mat3 attitude_of(const Animation& animation, const results::Sol8Element& e) {
  if (e.angles != std::array<double, 3>{}) return rotation(e.angles);
  if (animation.file.bearing_type == 1) return Mat3::Identity();
  const double lean = nominal_lean(animation);  // its turning was not followed
  Mat3 out;
  out.col(0) = std::cos(lean) * Vec3::UnitX() + std::sin(lean) * outward_direction(e.theta);
  out.col(2) = -std::sin(lean) * Vec3::UnitX() + std::cos(lean) * outward_direction(e.theta);
  out.col(1) = out.col(2).cross(out.col(0));
  return out;
}

void add_bodies(std::vector<float>& out, const Animation& animation, std::size_t i, double factor) {
  const auto& frame = animation.frame(i);
  const double unit = length_unit(animation);
  for (const std::size_t race : {0U, 1U}) {
    for (const double v : frame.races[race].position) out.push_back(static_cast<float>(unit * v));
    out.push_back(static_cast<float>(animation.race_angle[race][i]));
  }
  for (int part = 0; animation.has_cage && part < animation.segments; ++part) {
    const auto& at = animation.part(i, part).position;
    add(out, unit * Vec3(at[0], factor * at[1], factor * at[2]),
        cage_attitude(animation, i, part, factor));
  }
  const double aside =
      animation.file.bearing_type == 1 ? 0.0 : roller_profile(animation).mass_centre;
  for (std::size_t k = 0; k < frame.elements.size(); ++k) {
    const QPointF centre = element_centre(animation, i, factor, k);
    const Mat3 attitude = attitude_of(animation, frame.elements[k]);
    add(out, unit * (Vec3(frame.elements[k].x, centre.x(), centre.y()) - aside * attitude.col(0)),
        attitude);
  }
}

/// SI values of a channel; NaN where the run does not have it.
struct Values {
  const results::MotionChannel* channel = nullptr;
  double factor = 1.0;
  [[nodiscard]] double at(std::size_t frame, std::size_t place) const {
    return channel != nullptr && place < channel->width ? factor * channel->at(frame, place) : kNaN;
  }
};

/// Lengths of the profile of a race, in m: x, near, far.
Json ring_json(const Animation& animation, std::size_t race, double factor) {
  Json out = Json::array();
  const double unit = length_unit(animation);
  for (const RingRadii& column : ring_profile(animation, race, factor))
    out.push_back({unit * column.x, unit * column.near, unit * column.far});
  return out;
}

Json cage_json(const Animation& animation, double factor) {
  Json out = Json::array();
  if (!animation.has_cage) return out;
  const auto& g = animation.file.geometry;
  const double pitch_radius = 0.5 * g.pitch_diameter, unit = length_unit(animation);
  CageProfile profile = cage_profile(animation);
  std::vector<std::vector<float>> points(static_cast<std::size_t>(animation.segments));
  std::vector<std::vector<std::uint32_t>> corners(points.size());
  constexpr int kParts = 8;
  for (const CagePocket& pocket :
       cage_pockets(animation, g.element_radius + 0.5 * factor * g.pocket_clearance_1, profile)) {
    auto& of = points[static_cast<std::size_t>(pocket.part)];
    auto& mesh = corners[static_cast<std::size_t>(pocket.part)];
    const auto first = static_cast<std::uint32_t>(of.size() / 3);
    const std::vector<RimPoint> rim =
        pocket_rim(profile, pitch_radius, pocket.mesh, kParts, pocket.mesh.round ? kParts : 1);
    // At each point: hole and edge below, hole and edge above.
    for (const RimPoint& r : rim)
      for (const double height : {profile.low, profile.high})
        for (const auto& [angle, u] :
             {std::pair{r.hole_angle, r.hole_u}, {r.edge_angle, r.edge_u}}) {
          const QPointF p = tilted_point(0.0, pitch_radius, profile.lean, u, height);
          const Vec3 at =
              unit * (p.x() * Vec3::UnitX() + p.y() * outward_direction(pocket.azimuth + angle));
          for (const double v : {at.x(), at.y(), at.z()}) of.push_back(static_cast<float>(v));
        }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
      for (const std::uint32_t i : {a, b, c, a, c, d}) mesh.push_back(first + i);
    };
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
      const auto p = static_cast<std::uint32_t>(4 * i), q = p + 4;
      quad(p, p + 1, q + 1, q);          // below
      quad(p + 2, q + 2, q + 3, p + 3);  // above
      quad(p, q, q + 2, p + 2);          // wall of the hole
      const bool side_face = rim[i].edge_u == rim[i + 1].edge_u;
      if (side_face || pocket.open_end[rim[i].edge_angle < 0.0 ? 0 : 1])
        quad(p + 1, p + 3, q + 3, q + 1);
    }
  }
  for (std::size_t part = 0; part < points.size(); ++part)
    out.push_back({{"points", base64(points[part])}, {"corners", base64(corners[part])}});
  return out;
}

Json shapes_json(const Animation& animation, double factor, const Eye& eye) {
  const double unit = length_unit(animation), towards = viewers_azimuth(eye);
  Json out;
  out["balls"] = animation.file.bearing_type == 1;
  out["elements"] = animation.file.elements;
  out["radius"] = unit * animation.file.geometry.element_radius;
  out["reach"] = unit * solid_picture_radius(animation);
  out["open"] = {towards + kOpen, towards + 2.0 * kPi - kOpen};
  out["rings"] = {ring_json(animation, 0, factor), ring_json(animation, 1, factor)};
  Json lands = Json::array();
  for (const LandSection& land : land_sections(animation, factor))
    lands.push_back({land.race, unit * land.low, unit * land.high,
                     unit * land.on_race * (land.race == 0 ? 0.9995 : 1.0005)});
  out["lands"] = lands;
  out["cage"] = cage_json(animation, factor);
  if (animation.file.bearing_type != 1) {
    Json line = Json::array();
    for (const QPointF& p : roller_profile(animation).meridian())
      line.push_back({unit * p.x(), unit * p.y()});
    out["roller"] = line;
  }
  const auto& elements = animation.file.frames.front().elements;
  out["followed"] = std::any_of(elements.begin(), elements.end(),
                                [](const auto& e) { return e.angles != std::array<double, 3>{}; });
  return out;
}

}  // namespace

double scene_frame_bytes(const Animation& animation) {
  constexpr double kText = 4.0 / 3.0;  // base64
  return kText * (4.0 * static_cast<double>(numbers_of(animation)) + 2.0 * 8.0);
}

std::string scene_data(const Animation& animation, const ViewOptions& view,
                       std::pair<std::size_t, std::size_t> range, int every) {
  const double factor = used_exaggeration(animation, view);
  const auto n = static_cast<std::size_t>(animation.file.elements);
  Json out = shapes_json(animation, factor, Eye(view.yaw, view.elevation));
  const std::string& run = animation.file.run_id;
  out["title"] = run.empty() ? std::string("Bearing motion") : run;
  out["origin"] = fmt::format("{} · {}", speed_text(animation), animation.source);
  out["drawn"] = fmt::format(
      "{}. {}In the file, lengths are in m, forces in N, pressures in Pa.",
      animation.has_cage ? fmt::format("Radial clearances × {}", desktop::pretty_number(factor, 3))
                         : std::string("To scale"),
      every > 1 ? fmt::format("One in {} of the frames. ", every) : std::string());
  out["dark"] = view.dark;
  out["yaw"] = view.yaw;
  out["elevation"] = view.elevation;
  out["picked"] = view.element - 1;
  std::vector<double> time, revolutions;
  std::vector<float> bodies, contacts;
  std::array<Values, kQuantities.size()> values;
  Json quantities = Json::array();
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    const SceneQuantity& of = kQuantities[q];
    values[q].channel = animation.motion->channel(of.channel);
    if (values[q].channel != nullptr && values[q].channel->width == 2 * n)
      values[q].factor = values[q].channel->unit == of.unit.en ? of.unit.en_factor : 1.0;
    RunRange whole;
    if (values[q].channel != nullptr) whole = run_range(*values[q].channel);
    quantities.push_back({{"name", of.name},
                          {"unit", std::string(of.unit.si)},
                          {"colours", of.colours && whole.largest > 0.0},
                          {"lowest", 0.0},
                          {"largest", values[q].factor * whole.largest}});
  }
  out["quantities"] = quantities;
  for (std::size_t i = range.first; i <= range.second; i += static_cast<std::size_t>(every)) {
    time.push_back(animation.time[i]);
    revolutions.push_back(animation.frame(i).revolutions);
    add_bodies(bodies, animation, i, factor);
    for (std::size_t place = 0; place < 2 * n; ++place)
      for (const Values& of : values) contacts.push_back(static_cast<float>(of.at(i, place)));
  }
  out["time"] = base64(time);
  out["revolutions"] = base64(revolutions);
  out["bodies"] = base64(bodies);
  if (animation.contacts) out["contacts"] = base64(contacts);
  return dump_json(out);
}

}  // namespace adore::agore

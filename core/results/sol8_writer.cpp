#include "base/errors.hpp"
#include "base/rotation.hpp"
#include "base/version.hpp"
#include "contact/groove.hpp"
#include "results/continuation.hpp"
#include "results/fortran_format.hpp"
#include "results/motion.hpp"
#include "results/sol_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::results {
namespace {

namespace ff = fortran;
constexpr int kSol8ValuesPerLine = 13;
constexpr int kMaxSol8Elements = 88;  // 11 n + 22 must fit three columns

void append_block(std::string& out, const std::vector<double>& values) {
  if (!values.empty()) out += "  ";
  ff::append_reals(out, values, 10, 3, ff::Scale::Zero, kSol8ValuesPerLine, "\n  ");
  out += '\n';
}

std::vector<double> in_order(const Sol8Geometry& g) {
  std::vector<double> values;
  for (const Sol8GeometryField& field : kSol8Geometry) values.push_back(g.*field.value);
  return values;
}

std::vector<double> in_order(const Sol8Frame& frame) {
  std::vector<double> values;
  values.reserve(11 * frame.elements.size() + 22);
  const auto add = [&values](const auto& array) {
    values.insert(values.end(), array.begin(), array.end());
  };
  for (const Sol8Element& element : frame.elements) {
    add(std::array{element.x, element.r, element.theta});
    add(element.angles);
    add(element.pocket_vector);
    add(std::array{element.pocket_force, element.pocket_angle});
  }
  add(frame.cage.position);
  add(frame.cage.angles);
  for (std::size_t land = 0; land < 2; ++land)
    add(std::array{frame.land_force[land], frame.land_angle[land]});
  for (const Sol8Body& race : frame.races) {
    add(race.position);
    add(race.angles);
  }
  return values;
}

std::array<double, 3> to_array(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Of an attitude; that of a body which is not integrated is as it was at the start.
std::array<double, 3> angles_of(const scene::Quat& orientation) {
  if (orientation == scene::Quat{1.0, 0.0, 0.0, 0.0}) return {};
  return to_array(angles_from_quaternion(orientation));
}

Sol8Body body_of(const scene::BodySnapshot& body) {
  return {to_array(body.position), angles_of(body.orientation)};
}

void scale(Sol8Geometry& g, double length) {
  for (const Sol8GeometryField& field : kSol8Geometry) g.*field.value /= length;
}

void scale(Sol8Frame& frame, double length, double force) {
  const auto shrink = [length](std::array<double, 3>& v) {
    for (double& value : v) value /= length;
  };
  for (Sol8Element& element : frame.elements) {
    element.x /= length;
    element.r /= length;
    shrink(element.pocket_vector);
    element.pocket_force /= force;
  }
  shrink(frame.cage.position);
  for (double& value : frame.land_force) value /= force;
  for (Sol8Body& race : frame.races) shrink(race.position);
}

std::string header_text(const bearing::Bearing& bearing, UnitSystem units) {
  Sol8File file;
  file.version = std::string(kFileVersion) + bearing.user_version;
  file.run_id = bearing.run_id;
  file.bearing_type = static_cast<int>(bearing.type);
  file.elements = bearing.element_count();
  const auto slots = unit_slots(SolKind::Animation);
  for (std::size_t k = 0; k < slots.size(); ++k)
    if (slots[k] != nullptr) file.units[k] = unit_name(*slots[k], units);
  file.geometry = make_sol8_geometry(bearing);
  scale(file.geometry, to_si(1.0, unit::kLength, units));
  return format_sol8_header(file);
}

void check_allowed(const bearing::Bearing& bearing) {
  if (const auto refusal =
          sol8_refusal(bearing.element_count(), bearing.cage ? bearing.cage->segments.count : 0))
    throw InputError(*refusal);
}

}  // namespace

std::optional<std::string> sol8_refusal(int elements, int cage_segments) {
  if (elements > kMaxSol8Elements)
    return fmt::format(
        "SOL8 is not written: its format allows at most {} rolling elements, but this bearing has "
        "{}; AGORE draws the motion from RESULTS.h5",
        kMaxSol8Elements, elements);
  if (cage_segments > 1)
    return fmt::format(
        "SOL8 is not written: its format allows one cage, but this bearing has {} segments; AGORE "
        "draws their motion from RESULTS.h5",
        cage_segments);
  return std::nullopt;
}

Sol8Geometry make_sol8_geometry(const bearing::Bearing& bearing) {
  Sol8Geometry out;
  if (bearing.cage) {
    out.cage_outer_radius = bearing.cage->outer_diameter / 2.0;
    out.cage_inner_radius = bearing.cage->inner_diameter / 2.0;
    out.cage_outer_clearance = bearing.cage->clearance_outer / 2.0;
    out.cage_inner_clearance = bearing.cage->clearance_inner / 2.0;
    out.pocket_clearance_1 = bearing.cage->pocket_clearance_1;
    out.pocket_clearance_2 = bearing.cage->pocket_clearance_2;
  }
  out.element_radius = bearing.element_diameter() / 2.0;
  out.pitch_diameter = bearing.pitch_diameter();
  out.outer_race_outer_radius = bearing.envelope.outer_diameter / 2.0;
  if (bearing.rollers() != nullptr) {
    // Raceways under the middle of the rollers.
    out.outer_race_inner_radius = bearing.rollers()->race_radius(bearing::kOuter);
    out.inner_race_outer_radius = bearing.rollers()->race_radius(bearing::kInner);
  } else {
    const contact::GrooveGeometry groove = contact::groove_geometry(bearing.balls());
    out.outer_race_inner_radius = groove.centre_radius[0] + groove.groove_radius[0];
    out.inner_race_outer_radius = groove.centre_radius[1] - groove.groove_radius[1];
  }
  out.inner_race_inner_radius = bearing.envelope.bore / 2.0;
  return out;
}

Sol8Frame make_sol8_frame(const scene::Snapshot& snapshot) {
  Sol8Frame frame;
  frame.step = snapshot.step;
  frame.revolutions = snapshot.shaft_rotation / (2.0 * std::numbers::pi);
  frame.time = snapshot.time;
  frame.elements.reserve(snapshot.elements.size());
  for (const scene::ElementSnapshot& ball : snapshot.elements) {
    Sol8Element element;
    element.x = ball.x;
    element.r = ball.r;
    element.theta = wrapped(ball.theta);
    element.angles = angles_of(ball.orientation);
    element.pocket_vector = to_array(ball.pocket_to_centre);
    // A pocket with several guide surfaces shows the one that carries most, or else the nearest.
    const auto contact =
        std::max_element(ball.pocket.begin(), ball.pocket.end(), [](const auto& a, const auto& b) {
          return a.force < b.force || (a.force == b.force && a.gap > b.gap);
        });
    if (contact != ball.pocket.end()) {
      element.pocket_force = contact->force;
      element.pocket_angle = wrapped(contact->theta);
    }
    frame.elements.push_back(element);
  }
  if (!snapshot.cages.empty()) {
    const scene::CageSnapshot& cage = snapshot.cages.front();
    frame.cage = body_of(cage);
    for (std::size_t land = 0; land < std::min<std::size_t>(cage.lands.size(), 2); ++land) {
      frame.land_force[land] = cage.lands[land].force;
      frame.land_angle[land] = wrapped(cage.lands[land].angle);
    }
  }
  for (std::size_t race = 0; race < 2; ++race) frame.races[race] = body_of(snapshot.races[race]);
  return frame;
}

std::string format_sol8_header(const Sol8File& file) {
  std::string out = "  ";
  const FileVersion version = file_version(file.version);
  ff::append_text(out, version.program, 10);
  out.append(5, ' ');
  ff::append_text(out, file.run_id, 36);
  append_user_version(out, version);
  out += "\n  ";
  ff::append_integer(out, file.bearing_type, 3);
  ff::append_integer(out, file.elements, 3);
  for (const std::string& unit : file.units)
    ff::append_integer(out, static_cast<long long>(std::min<std::size_t>(unit.size(), 10)), 3);
  ff::append_integer(out, kSol8Geometry.size(), 3);
  ff::append_integer(out, 11LL * file.elements + 22, 3);
  out += "\n  ";
  for (const std::string& unit : file.units) {
    ff::append_text(out, unit, 10);
    out += "  ";
  }
  out += '\n';
  append_block(out, in_order(file.geometry));
  return out;
}

void append_sol8_frame(std::string& out, const Sol8Frame& frame) {
  out += "  ";
  ff::append_integer(out, frame.step, 16);
  ff::append_real(out, frame.revolutions, 16, 7, ff::Scale::Zero);
  ff::append_real(out, frame.time, 16, 7, ff::Scale::Zero);
  out += '\n';
  append_block(out, in_order(frame));
}

Sol8Writer Sol8Writer::create(const WritePath& place, const bearing::Bearing& bearing,
                              UnitSystem units) {
  check_allowed(bearing);
  Sol8Writer writer(GrowingFile::create(place), units);
  writer.file_.append(header_text(bearing, units));
  return writer;
}

Sol8Writer Sol8Writer::continue_after(const WritePath& place, const bearing::Bearing& bearing,
                                      UnitSystem units, long last_step) {
  check_allowed(bearing);
  return {continue_sol_file(place, header_text(bearing, units), last_step), units};
}

void Sol8Writer::check(const std::filesystem::path& path, const bearing::Bearing& bearing,
                       UnitSystem units) {
  check_allowed(bearing);
  check_sol_file(path, header_text(bearing, units));
}

void Sol8Writer::write(const scene::Snapshot& snapshot) {
  Sol8Frame frame = make_sol8_frame(snapshot);
  scale(frame, to_si(1.0, unit::kLength, units_), to_si(1.0, unit::kForce, units_));
  text_.clear();
  append_sol8_frame(text_, frame);
  file_.append(text_);
}

}  // namespace adore::results

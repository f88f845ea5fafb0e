#include "results/motion_file.hpp"

#include "base/errors.hpp"
#include "base/rotation.hpp"
#include "results/channels.hpp"
#include "results/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace adore::results {
namespace {

/// Of times in SOL8 (e16.7), with some room.
constexpr double kTimeDigits = 1e-6;

/// Is `stored` what SOL8 makes of `exact`? It keeps three digits behind 0. (e10.3), so that half of
/// the last one is 0.2 to 0.5 % of the value.
bool same_digits(double stored, double exact) {
  constexpr double kHalf = 0.51e-3;  // with a tolerance for the last bit
  return std::abs(stored - exact) <=
         kHalf * std::pow(10.0, std::floor(std::log10(std::abs(exact))) + 1.0);
}

/// The channel's unit pair; nullptr for those that only some runs have (items of the ledger).
const UnitPair* unit_of(std::string_view id) {
  for (const Channel& channel : channels())
    if (channel.id == id) return channel.unit;
  return nullptr;
}

/// Angles stay in rad, as SOL8 has them; speeds become rpm.
bool stays(const UnitPair* unit) { return unit == nullptr || unit == &unit::kAngle; }

/// A pure number has none.
std::string shown_unit(std::string_view unit) { return unit == "-" ? "" : std::string(unit); }

std::array<double, 3> angles_of(const double* quaternion) {
  const Vec3 angles =
      angles_from_quaternion({quaternion[0], quaternion[1], quaternion[2], quaternion[3]});
  return {angles[0], angles[1], angles[2]};
}

UnitSystem units_of(const Sol8File& file) {
  return file.units[0] == unit::kLength.en ? UnitSystem::English : UnitSystem::SI;
}

}  // namespace

MotionFile::MotionFile(H5Reader reader) : reader_(std::make_unique<H5Reader>(std::move(reader))) {
  times_ = reader_->read("time");
}

MotionFile MotionFile::open(const std::filesystem::path& h5, UnitSystem units,
                            std::size_t most_frames) {
  MotionFile out{H5Reader(h5)};
  out.units_ = units;
  out.file_.path = h5;
  if (out.reader_->steps() == 0)
    throw InputError(
        h5.string() +
        " does not contain a complete step yet. Continue the run until it has stored a step");
  for (const char* needed : {"element.axial_position", "element.radial_position",
                             "element.orbital_position", "race.orientation", "race.x"})
    if (!out.has(needed))
      throw InputError(
          fmt::format("{} does not contain the channel {}, so the motion cannot be displayed. The "
                      "file was written by another program, or it is damaged",
                      h5.string(), needed));
  out.read_frames(std::max<std::size_t>(most_frames, 1));
  return out;
}

std::optional<MotionFile> MotionFile::of_sol8(const Sol8File& file, std::string& why_not,
                                              std::size_t most_frames) {
  const std::filesystem::path path = file.path.parent_path() / "RESULTS.h5";
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    why_not = "there is no RESULTS.h5 in the folder of SOL8";
    return std::nullopt;
  }
  try {
    MotionFile out{H5Reader(path)};
    if (out.reader_->run_id() != file.run_id) {
      why_not = fmt::format("RESULTS.h5 in the folder of SOL8 belongs to the run '{}'",
                            out.reader_->run_id());
      return std::nullopt;
    }
    const std::vector<long> numbers = out.reader_->step_numbers();
    std::unordered_map<long, std::size_t> at;
    for (std::size_t i = 0; i < numbers.size(); ++i) at[numbers[i]] = i;
    const auto n = static_cast<std::size_t>(file.elements);
    const auto* radius = out.reader_->find("element.radial_position");
    if (radius == nullptr || radius->size() != n) {
      why_not =
          "RESULTS.h5 in the folder of SOL8 has a different number of rolling elements than SOL8";
      return std::nullopt;
    }
    const UnitSystem units = units_of(file);
    // A few frames identify a run; the last one in both files is among them.
    // RESULTS.h5 of a killed or unfinished run ends before SOL8: its available part is
    // used.
    constexpr std::size_t kLooks = 16;
    const auto held = static_cast<std::size_t>(std::find_if(file.frames.begin(), file.frames.end(),
                                                            [&](const Sol8Frame& frame) {
                                                              return !numbers.empty() &&
                                                                     frame.step > numbers.back();
                                                            }) -
                                               file.frames.begin());
    // For a run that has just begun it may contain only a few frames of SOL8.
    if (2 * held < file.frames.size()) {
      why_not = fmt::format("RESULTS.h5 in the folder of SOL8 has only {} of the {} frames in SOL8",
                            held, file.frames.size());
      return std::nullopt;
    }
    const std::size_t every = std::max<std::size_t>(1, held / kLooks);
    bool any = false;
    for (std::size_t i = 0; i < held; ++i) {
      if (i % every != 0 && i + 1 != held) continue;
      const Sol8Frame& frame = file.frames[i];
      const auto found = at.find(frame.step);
      if (found == at.end()) {
        why_not =
            fmt::format("RESULTS.h5 in the folder of SOL8 does not contain step {}", frame.step);
        return std::nullopt;
      }
      const double time = out.times_[found->second];
      const std::vector<double> radii =
          out.reader_->read("element.radial_position", found->second, 1);
      bool same = std::abs(frame.time - time) <= kTimeDigits * std::abs(time) + 1e-300;
      for (std::size_t k = 0; same && k < std::min(n, frame.elements.size()); ++k) {
        const double exact = from_si(radii[k], unit::kLength, units);
        same = same_digits(frame.elements[k].r, exact);
      }
      if (!same) {
        why_not =
            "RESULTS.h5 in the folder of SOL8 contains different numbers, so it belongs to another "
            "run";
        return std::nullopt;
      }
      any = true;
    }
    if (!any) {
      why_not = "SOL8 has no frame that is also in RESULTS.h5";
      return std::nullopt;
    }
    MotionFile whole = open(path, units, most_frames);
    whole.file_.path = file.path;
    whole.file_.note = file.note;
    whole.file_.version = file.version;
    return whole;
  } catch (const InputError& error) {
    why_not = error.what();
    return std::nullopt;
  }
}

void MotionFile::read_frames(std::size_t most_frames) {
  const std::size_t steps = reader_->steps();
  steps_per_frame_ = (steps + most_frames - 1) / most_frames;
  const auto size = [this](const char* name, double otherwise) {
    const auto found = geometry().find(name);
    return found != geometry().end() && std::isfinite(found->second) ? found->second : otherwise;
  };
  file_.version = reader_->version();
  file_.run_id = reader_->run_id();
  file_.elements = static_cast<int>(reader_->find("element.radial_position")->size());
  file_.bearing_type = static_cast<int>(std::clamp(size("bearing_type", 1.0), 1.0, 5.0));
  const auto slots = unit_slots(SolKind::Animation);
  for (std::size_t k = 0; k < slots.size(); ++k)
    if (slots[k] != nullptr) file_.units[k] = unit_name(*slots[k], units_);
  for (const Sol8GeometryField& field : kSol8Geometry)
    file_.geometry.*field.value = from_si(size(field.name, 0.0), unit::kLength, units_);

  // The last stored step is always a frame.
  const std::size_t count = (steps - 1) / steps_per_frame_ + 1;
  const auto n = static_cast<std::size_t>(file_.elements);
  const auto read = [&](const char* id, std::size_t width) {
    const H5Reader::ChannelInfo* info = reader_->find(id);
    if (info == nullptr || info->size() != width) return std::vector<double>(count * width, 0.0);
    std::vector<double> values = reader_->read(id, 0, count, steps_per_frame_);
    const UnitPair* unit = unit_of(id);
    if (!stays(unit) && unit != nullptr)
      for (double& value : values) value = from_si(value, *unit, units_);
    return values;
  };
  const std::vector<double> shaft = reader_->read("shaft_rotation", 0, count, steps_per_frame_);
  const std::vector<long> numbers = reader_->step_numbers();
  const auto* cages = reader_->find("cage.position");
  const std::size_t parts = cages == nullptr ? 0 : cages->size() / 3;
  const auto* pocket = reader_->find("pocket.force");
  const std::size_t surfaces =
      pocket == nullptr || pocket->size() < n * pocket_surfaces() ? 0 : pocket_surfaces();
  const auto* land = reader_->find("land.force");
  const std::size_t lands = land == nullptr || parts == 0 ? 0 : land->size() / parts;

  file_.frames.assign(count, {});
  for (std::size_t i = 0; i < count; ++i) {
    Sol8Frame& frame = file_.frames[i];
    frame.step = numbers[i * steps_per_frame_];
    frame.time = times_[i * steps_per_frame_];
    frame.revolutions = shaft[i] / (2.0 * std::numbers::pi);
    frame.elements.resize(n);
  }
  const auto fill = [&](const char* id, std::size_t width, auto put) {
    const std::vector<double> values = read(id, width);
    for (std::size_t i = 0; i < count; ++i) put(i, values.data() + i * width);
  };
  const auto each = [&](const char* id, std::size_t components, auto put) {
    fill(id, n * components, [&](std::size_t i, const double* v) {
      for (std::size_t k = 0; k < n; ++k) put(file_.frames[i].elements[k], v + k * components);
    });
  };
  each("element.axial_position", 1, [](Sol8Element& e, const double* v) { e.x = *v; });
  each("element.radial_position", 1, [](Sol8Element& e, const double* v) { e.r = *v; });
  each("element.orbital_position", 1,
       [](Sol8Element& e, const double* v) { e.theta = wrapped(*v); });
  if (has("element.orientation"))
    each("element.orientation", 4,
         [](Sol8Element& e, const double* v) { e.angles = angles_of(v); });
  each("element.pocket_to_centre", 3, [](Sol8Element& e, const double* v) {
    e.pocket_vector = {v[0], v[1], v[2]};
  });
  if (surfaces > 0) {
    // Of several guide surfaces the one that carries most, or else the nearest; behind the elements
    // stand the last half pockets of segments.
    const std::size_t width = pocket->size();
    const std::vector<double> force = read("pocket.force", width), gap = read("pocket.gap", width),
                              theta = read("pocket.theta", width);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < n; ++k) {
        std::size_t best = i * width + k * surfaces;
        for (std::size_t j = best + 1; j < i * width + (k + 1) * surfaces; ++j)
          if (force[j] > force[best] || (force[j] == force[best] && gap[j] < gap[best])) best = j;
        file_.frames[i].elements[k].pocket_force = force[best];
        file_.frames[i].elements[k].pocket_angle = wrapped(theta[best]);
      }
  }
  if (parts > 0) {
    const std::vector<double> position = read("cage.position", 3 * parts),
                              attitude = read("cage.orientation", 4 * parts);
    segments_.assign(parts > 1 ? count : 0, std::vector<Sol8Body>(parts));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < parts; ++k) {
        const double* p = position.data() + (i * parts + k) * 3;
        const Sol8Body body{{p[0], p[1], p[2]}, angles_of(attitude.data() + (i * parts + k) * 4)};
        if (k == 0) file_.frames[i].cage = body;
        if (parts > 1) segments_[i][k] = body;
      }
  }
  if (lands > 0) {
    const std::vector<double> force = read("land.force", parts * lands),
                              angle = read("land.angle", parts * lands);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < std::min<std::size_t>(lands, 2); ++k) {
        file_.frames[i].land_force[k] = force[i * parts * lands + k];
        file_.frames[i].land_angle[k] = wrapped(angle[i * parts * lands + k]);
      }
  }
  const char* const axes[] = {"race.x", "race.y", "race.z"};
  for (std::size_t c = 0; c < 3; ++c)
    fill(axes[c], 2, [&](std::size_t i, const double* v) {
      for (std::size_t r = 0; r < 2; ++r) file_.frames[i].races[r].position[c] = v[r];
    });
  fill("race.orientation", 8, [&](std::size_t i, const double* v) {
    for (std::size_t r = 0; r < 2; ++r) file_.frames[i].races[r].angles = angles_of(v + 4 * r);
  });
}

std::size_t MotionFile::pocket_surfaces() const {
  const H5Reader::ChannelInfo* pocket = reader_->find("pocket.force");
  return pocket == nullptr || pocket->dimensions.size() != 2 ? 0 : pocket->dimensions[1];
}

const MotionChannel* MotionFile::channel(const std::string& id) const {
  const auto kept = channel_cache_.find(id);
  if (kept != channel_cache_.end()) return &kept->second;
  const H5Reader::ChannelInfo* info = reader_->find(id);
  if (info == nullptr || info->size() == 0) return nullptr;
  MotionChannel out;
  out.width = info->size();
  out.values = reader_->read(id, 0, file_.frames.size(), steps_per_frame_);
  const UnitPair* unit = unit_of(id);
  out.unit = shown_unit(stays(unit) ? std::string_view(info->unit) : unit_name(*unit, units_));
  if (!stays(unit))
    for (double& value : out.values) value = from_si(value, *unit, units_);
  return &channel_cache_.emplace(id, std::move(out)).first->second;
}

std::vector<double> MotionFile::series(const std::string& id, std::size_t place,
                                       std::string* unit_text) const {
  const H5Reader::ChannelInfo* info = reader_->find(id);
  std::vector<double> out;
  if (id == "shaft_rotation") return reader_->read(id);
  if (info == nullptr || place >= info->size()) return out;
  const UnitPair* unit = unit_of(id);
  if (unit_text != nullptr)
    *unit_text = shown_unit(stays(unit) ? std::string_view(info->unit) : unit_name(*unit, units_));
  constexpr std::size_t kBlock = 4096;
  out.reserve(reader_->steps());
  for (std::size_t first = 0; first < reader_->steps(); first += kBlock) {
    const std::size_t count = std::min(kBlock, reader_->steps() - first);
    const std::vector<double> block = reader_->read(id, first, count);
    for (std::size_t i = 0; i < count; ++i) {
      const double value = block[i * info->size() + place];
      out.push_back(stays(unit) ? value : from_si(value, *unit, units_));
    }
  }
  return out;
}

}  // namespace adore::results

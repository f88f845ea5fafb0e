#include "results/sol_file.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "results/read_watch.hpp"
#include "results/sol_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace adore::results {
namespace {

InputFile open_file(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw InputError(
        fmt::format("{}: this is a folder; give the name of a SOL file in it", path.string()));
  reject_special_file(path);
  InputFile stream(path);
  if (!stream)
    throw InputError(fmt::format("{}: the file cannot be opened; check its name and permissions",
                                 path.string()));
  return stream;
}

void check(const SolRange& range) {
  if (range.from < 1 || range.to < range.from || range.every < 1)
    throw InputError(
        fmt::format("stored steps {} to {} with interval {}: this range is not possible. Give a "
                    "first step of 1 or more, a last step that is not smaller than the first step, "
                    "and an interval of 1 or more",
                    range.from, range.to, range.every));
}

/// Calls take(step) for every complete step of the range; returns the note. `last_step` becomes the
/// last one that was passed.
/// @throws InputError when the file ends before the range begins
template <class Take>
std::string for_each_step(SolParser& parser, const std::string& name, const SolRange& range,
                          long& last_step, Take take) {
  SolStep step;
  for (long position = 1; position <= range.to; ++position) {
    const bool kept = position >= range.from && (position - range.from) % range.every == 0;
    if (parser.next(step, kept) != BlockStatus::Complete) {
      if (position <= range.from && range.from > 1)
        throw InputError(
            fmt::format("{}: stored step {} and later steps are not available: number of stored "
                        "steps in the file: {}",
                        name, range.from, position - 1));
      return parser.note();
    }
    last_step = step.step;
    if (kept) take(step);
  }
  return {};
}

/// Hands out the values of a SOL8 step one after the other.
class Values {
 public:
  explicit Values(const std::vector<double>& values) : values_(values) {}
  double next() { return values_[at_++]; }
  template <std::size_t n>
  std::array<double, n> next_array() {
    std::array<double, n> out{};
    for (double& value : out) value = next();
    return out;
  }

 private:
  const std::vector<double>& values_;
  std::size_t at_ = 0;
};

Sol8Frame make_frame(const SolStep& step, int elements) {
  Sol8Frame frame;
  frame.step = step.step;
  frame.revolutions = step.revolutions;
  frame.time = step.time;
  Values values(step.values);
  frame.elements.resize(static_cast<std::size_t>(elements));
  for (Sol8Element& element : frame.elements) {
    element.x = values.next();
    element.r = values.next();
    element.theta = values.next();
    element.angles = values.next_array<3>();
    element.pocket_vector = values.next_array<3>();
    element.pocket_force = values.next();
    element.pocket_angle = values.next();
  }
  frame.cage.position = values.next_array<3>();
  frame.cage.angles = values.next_array<3>();
  for (std::size_t land = 0; land < 2; ++land) {
    frame.land_force[land] = values.next();
    frame.land_angle[land] = values.next();
  }
  for (Sol8Body& race : frame.races) {
    race.position = values.next_array<3>();
    race.angles = values.next_array<3>();
  }
  return frame;
}

Sol8Geometry make_geometry(const std::vector<double>& geometry) {
  Values values(geometry);
  Sol8Geometry out;
  for (const Sol8GeometryField& field : kSol8Geometry) out.*field.value = values.next();
  return out;
}

}  // namespace

FileVersion file_version(std::string_view version) {
  constexpr std::size_t kVersionFieldWidth = 10;  // columns of a version field
  const std::size_t user =
      version.size() > kVersionFieldWidth ? version.find('+') : std::string_view::npos;
  if (user == std::string_view::npos) return {version, {}};
  return {version.substr(0, user), version.substr(user)};
}

void append_user_version(std::string& line, const FileVersion& version) {
  if (version.user.empty()) return;
  const std::size_t start = line.rfind('\n') == std::string::npos ? 0 : line.rfind('\n') + 1;
  line.append(static_cast<std::size_t>(kUserVersionColumn) - 1 - (line.size() - start), ' ');
  line += version.user;
}

std::size_t SolFile::place(std::size_t column) const {
  if (columns.empty()) return column;
  const auto found = std::lower_bound(columns.begin(), columns.end(), column);
  return found != columns.end() && *found == column
             ? static_cast<std::size_t>(found - columns.begin())
             : std::string::npos;
}

namespace {

SolFile read_steps(std::istream& stream, const std::string& name, const SolRange& range,
                   const ReadWatch& watch, std::uintmax_t bytes) {
  check(range);
  SolParser parser(stream, name);
  if (parser.kind() == SolKind::Animation)
    throw InputError(
        fmt::format("{}: this is an animation file (SOL8). Draw it with `adore animate`, or give "
                    "one of SOL1-SOL7",
                    name));
  SolFile file;
  file.path = name;
  file.kind = parser.kind();
  file.header = parser.header();
  file.columns = range.columns;
  constexpr std::size_t kLook = 1000;  // steps
  file.note = for_each_step(parser, name, range, file.last_step, [&](SolStep& step) {
    if (watch && bytes > 0 && file.steps.size() % kLook == 0 &&
        !watch(static_cast<double>(parser.complete_bytes()) / static_cast<double>(bytes)))
      throw ReadStopped(fmt::format("reading {} was stopped", name));
    if (file.columns.empty()) {
      file.steps.push_back(std::move(step));
      return;
    }
    const std::vector<double> all = std::exchange(step.values, {});
    step.values.reserve(file.columns.size());
    for (const std::size_t column : file.columns)
      if (column < all.size()) step.values.push_back(all[column]);
    file.steps.push_back(std::move(step));
  });
  file.gaps = parser.gaps();
  SolStep behind;
  file.more = file.note.empty() && parser.next(behind, false) == BlockStatus::Complete;
  file.every = range.every;
  file.part = file.more || range.every > 1 || range.from > 1;
  if (watch) (void)watch(1.0);
  return file;
}

}  // namespace

SolFile read_sol(std::istream& stream, const std::string& name, const SolRange& range) {
  return read_steps(stream, name, range, {}, 0);
}

Sol8File read_sol8(std::istream& stream, const std::string& name, const SolRange& range) {
  check(range);
  SolParser parser(stream, name);
  if (parser.kind() != SolKind::Animation)
    throw InputError(
        fmt::format("{}: this is a plot file (SOL1-SOL7), not an animation file; give SOL8", name));
  Sol8File file;
  file.path = name;
  file.version = parser.header().version;
  file.run_id = parser.header().run_id;
  file.bearing_type = parser.header().bearing_type;
  file.elements = parser.header().elements;
  file.units = parser.header().units;
  file.geometry = make_geometry(parser.geometry());
  long last_step = 0;
  file.note = for_each_step(parser, name, range, last_step, [&](const SolStep& step) {
    file.frames.push_back(make_frame(step, file.elements));
  });
  file.gaps = parser.gaps();
  return file;
}

SolFile read_sol(const std::filesystem::path& path, const SolRange& range) {
  InputFile stream = open_file(path);
  return read_sol(stream, path.string(), range);
}

SolFile read_sol(const std::filesystem::path& path, const SolRange& range, const ReadWatch& watch) {
  InputFile stream = open_file(path);
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  return read_steps(stream, path.string(), range, watch, error ? 0 : bytes);
}

Sol8File read_sol8(const std::filesystem::path& path, const SolRange& range) {
  InputFile stream = open_file(path);
  return read_sol8(stream, path.string(), range);
}

long stored_steps(const std::filesystem::path& path) {
  InputFile stream = open_file(path);
  SolParser parser(stream, path.string());
  SolStep step;
  const std::uintmax_t header = parser.complete_bytes();
  if (parser.next(step, false) != BlockStatus::Complete) return 0;
  const std::uintmax_t first = parser.complete_bytes() - header;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || first == 0) return 1;
  return static_cast<long>((size - header + first / 2) / first);
}

SolKind sol_kind(const std::filesystem::path& path) {
  InputFile stream = open_file(path);
  return SolParser(stream, path.string()).kind();
}

}  // namespace adore::results

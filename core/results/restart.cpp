#include "results/restart.hpp"

#include "base/checksum.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/version.hpp"
#include "base/write_folder.hpp"
#include "results/fortran_format.hpp"
#include "results/line_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace adore::results {
namespace {

constexpr std::string_view kFinal = "FINAL", kMaster = "MASTER";
/// Format 1 had no deck, format 2 no checksum of itself, format 3 none of the other files.
constexpr int kRestartFormat = 4;
/// Far beyond any run: thirty years of simulated time, whole numbers that a double can count.
constexpr double kMaxTime = 1e9;
constexpr long kMaxSteps = 1'000'000'000'000'000;

void append_title(std::string& out, std::string_view kind) {
  out += fmt::format("{} {}: {}\n", kProgramVersion, kind,
                     kind == kFinal
                         ? "last solution vector of a run; another run can start from this state"
                         : "state and result files of a run; needed to continue the run");
  out += "SI units and radians. Do not edit: the checksum at the end detects changed lines.\n";
  out += fmt::format("format {}\n", kRestartFormat);
}

void append_state(std::string& out, const FinalState& state) {
  demand(state.components.size() == state.state.size(),
         "the number of names differs from the number of state components");
  out += fmt::format("version {}\nrun {}\n", state.version, state.run_id);
  out += fmt::format("step {}\ntime {}\nstep_size {}\nshaft_rotation {}\n", state.step, state.time,
                     state.step_size, state.shaft_rotation);
  out += fmt::format("scale_length {}\nscale_force {}\nscale_time {}\n", state.scales.length,
                     state.scales.force, state.scales.time);
  out += fmt::format("extras {}\n", state.extras.size());
  for (const auto& [name, value] : state.extras) out += fmt::format("{} {}\n", value, name);
  out += fmt::format("state {}\n", state.state.size());
  for (std::size_t i = 0; i < state.state.size(); ++i)
    out += fmt::format("{} {}\n", state.state[i], state.components[i]);
  out += fmt::format("deck {}\n", std::count(state.deck.begin(), state.deck.end(), '\n'));
  out += state.deck;
}

/// Last line, with the sum of all before.
void append_end(std::string& out) { out += fmt::format("end {:016x}\n", checksum(out)); }

void check_title(const std::filesystem::path& path, std::string_view kind, std::string_view title) {
  if (title.find(fmt::format(" {}: ", kind)) == std::string_view::npos ||
      title.find("Adore") == std::string_view::npos)
    throw InputError(fmt::format(
        "{}: this is not a {} file of this program; give the {} file of the run to start from",
        path.string(), kind, kind));
}

/// A file of another kind may be large: its first line tells before the rest is read.
std::string text_of(const std::filesystem::path& path, std::string_view kind) {
  constexpr std::size_t kTitle = 512;
  std::string title(kTitle, '\0');
  InputFile stream(path);
  stream.read(title.data(), kTitle);
  title.resize(static_cast<std::size_t>(stream.gcount()));
  if (!title.empty()) check_title(path, kind, title.substr(0, title.find('\n')));
  return read_text_file(path);
}

/// Reads "keyword value" lines in their fixed order and reports the position of errors.
class Reader {
 public:
  Reader(const std::filesystem::path& path, std::string_view kind)
      : path_(path), stream_(text_of(path, kind)), lines_(stream_) {
    check_title(path, kind, line());
    line();
    format_ = integer("format");
    if (format_ < 1 || format_ > kRestartFormat)
      throw InputError(
          fmt::format("{}: the file has format {}, but this program reads formats 1 to {}; use the "
                      "program version that wrote it",
                      path.string(), format_, kRestartFormat));
  }
  [[nodiscard]] long format() const { return format_; }
  std::string text(std::string_view keyword) {
    const std::string_view whole = line();
    if (whole.substr(0, keyword.size()) != keyword ||
        (whole.size() > keyword.size() && whole[keyword.size()] != ' '))
      fail(fmt::format("'{}' is expected here", keyword));
    return std::string(fortran::trimmed(whole.substr(keyword.size())));
  }
  long integer(std::string_view keyword) {
    const auto value = fortran::parse_integer(text(keyword));
    if (!value) fail(fmt::format("'{}' needs an integer", keyword));
    return static_cast<long>(*value);
  }
  std::size_t count(std::string_view keyword) {
    const long value = integer(keyword);
    if (value < 0 || value > 100'000'000) fail(fmt::format("{} is not a valid count", value));
    return static_cast<std::size_t>(value);
  }
  /// A finite number between the limits, which belong to it.
  double real(std::string_view keyword, double least, double most) {
    const double value = number(text(keyword));
    if (!(value >= least && value <= most))
      fail(fmt::format("{} is {}, which is not between {} and {}", keyword, value, least, most));
    return value;
  }
  /// A step number.
  long step() {
    const long value = integer("step");
    if (value < 0 || value > kMaxSteps)
      fail(fmt::format("step is {}; it must be 0 or more", value));
    return value;
  }
  /// "number name" lines.
  std::pair<double, std::string> named() {
    const std::string_view whole = line();
    const std::size_t blank = whole.find(' ');
    if (blank == std::string_view::npos) fail("this line must contain a number and a name");
    const double value = number(whole.substr(0, blank));
    if (!std::isfinite(value)) fail(fmt::format("'{}' is not finite", whole));
    return {value, std::string(whole.substr(blank + 1))};
  }
  /// As many whole lines, with their ends.
  std::string lines(std::size_t count) {
    std::string out;
    for (; count > 0; --count) out += std::string(line()) + '\n';
    return out;
  }
  void end() {
    const std::string sum = fmt::format("{:016x}", sum_);
    const std::string stored = text("end");
    if (format_ >= 3 && stored != sum)
      fail(fmt::format("the lines have the checksum {}, but the checksum in the file is {}", sum,
                       stored.empty() ? "none" : stored));
  }
  [[noreturn]] void fail(std::string_view why) const {
    throw InputError(
        fmt::format("{}:{}: the file is damaged: {}; use the file of an earlier run, or start from "
                    "the quasi-static solution (kIcOpt = 0)",
                    path_.string(), lines_.number(), why));
  }

 private:
  double number(std::string_view text) const {
    const auto value = fortran::parse_real(text);
    if (!value) fail(fmt::format("'{}' is not a number", text));
    return *value;
  }
  std::string_view line() {
    std::string_view text;
    if (!lines_.next(text)) fail("the file ends too early");
    sum_ = checksum("\n", checksum(text, sum_));
    return text;
  }
  std::filesystem::path path_;
  std::istringstream stream_;
  LineReader lines_;
  long format_ = 0;
  std::uint64_t sum_ = checksum({});  ///< of all lines so far
};

FinalState read_state(Reader& reader) {
  FinalState state;
  state.version = reader.text("version");
  state.run_id = reader.text("run");
  state.step = reader.step();
  state.time = reader.real("time", 0.0, kMaxTime);
  state.step_size = reader.real("step_size", 0.0, kMaxTime);
  state.shaft_rotation = reader.real("shaft_rotation", -1e18, 1e18);
  state.scales.length = reader.real("scale_length", 1e-12, 1e6);
  state.scales.force = reader.real("scale_force", 1e-12, 1e18);
  state.scales.time = reader.real("scale_time", 1e-15, 1e9);
  for (std::size_t left = reader.count("extras"); left > 0; --left) {
    auto [value, name] = reader.named();
    state.extras[name] = value;
  }
  for (std::size_t left = reader.count("state"); left > 0; --left) {
    auto [value, name] = reader.named();
    state.state.push_back(value);
    state.components.push_back(std::move(name));
  }
  if (reader.format() >= 2) state.deck = reader.lines(reader.count("deck"));
  return state;
}

/// "14 rolling elements and a cage"
std::string bodies_text(const std::vector<std::string>& components) {
  const auto count = [&](std::string_view stem) {
    return std::count_if(components.begin(), components.end(),
                         [&](const std::string& name) { return name.starts_with(stem); });
  };
  return fmt::format("{} rolling elements and {}", count("element.x["),
                     count("cage.position[") > 0 ? "a cage" : "no cage");
}

}  // namespace

const MasterFileEntry* MasterState::file(std::string_view role) const {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const MasterFileEntry& file) { return file.role == role; });
  return found == files.end() ? nullptr : &*found;
}

void write_final(const FinalState& state, const WritePath& place) {
  std::string out;
  append_title(out, kFinal);
  append_state(out, state);
  append_end(out);
  write_file_atomically(place, out);
}

void write_master(const MasterState& state, const WritePath& place) {
  std::string out;
  append_title(out, kMaster);
  append_state(out, state.last);
  out += fmt::format("averages {}\n", state.averages.size());
  for (const auto& [name, value] : state.averages) out += fmt::format("{} {}\n", value, name);
  out += fmt::format("files {}\n", state.files.size());
  for (const MasterFileEntry& file : state.files)
    out += fmt::format("{} {} {} {}\n", file.bytes,
                       file.sum ? fmt::format("{:016x}", *file.sum) : "-", file.role, file.name);
  append_end(out);
  write_file_atomically(place, out);
}

FinalState read_final(const std::filesystem::path& path) {
  Reader reader(path, kFinal);
  FinalState state = read_state(reader);
  reader.end();
  return state;
}

MasterState read_master(const std::filesystem::path& path) {
  Reader reader(path, kMaster);
  MasterState state;
  state.last = read_state(reader);
  for (std::size_t left = reader.count("averages"); left > 0; --left) {
    auto [value, name] = reader.named();
    state.averages[name] = value;
  }
  for (std::size_t left = reader.count("files"); left > 0; --left) {
    auto [bytes, text] = reader.named();
    std::optional<std::uint64_t> sum;
    if (reader.format() >= 4) {  // checksum, role and name
      const std::string first = text.substr(0, text.find(' '));
      std::uint64_t value = 0;
      const char* end = first.data() + first.size();
      const auto [read_to, error] = std::from_chars(first.data(), end, value, 16);
      if (error == std::errc() && read_to == end)
        sum = value;
      else if (first != "-")
        reader.fail("this line must contain a checksum");
      text.erase(0, std::min(first.size() + 1, text.size()));
    }
    const std::size_t blank = text.find(' ');
    if (blank == std::string::npos || !(bytes >= 0.0) || bytes > 9e15)
      reader.fail("this line must contain size, role and name of a file");
    state.files.push_back(
        {text.substr(0, blank), text.substr(blank + 1), static_cast<std::uintmax_t>(bytes), sum});
  }
  reader.end();
  return state;
}

void check_layout(const FinalState& state, const std::vector<std::string>& components,
                  const std::filesystem::path& path) {
  if (state.components == components) return;
  const auto [stored, wanted] = std::mismatch(state.components.begin(), state.components.end(),
                                              components.begin(), components.end());
  const auto name = [](auto at, auto end) {
    return at == end ? std::string("nothing more") : "'" + *at + "'";
  };
  throw InputError(fmt::format(
      "{}: the stored state does not match this deck. The file has {} components, but the deck "
      "needs {}. The first difference is {}, where the deck needs {}. Use the same number of "
      "elements, cage, degrees of freedom, elements with integrated orientation and qFac (on or "
      "off) as in the stored run, or start from the quasi-static solution (kIcOpt = 0)",
      path.string(), state.components.size(), components.size(),
      name(stored, state.components.end()), name(wanted, components.end())));
}

void check_bodies(const FinalState& state, const std::vector<std::string>& components,
                  const std::filesystem::path& path) {
  const std::string stored = bodies_text(state.components), wanted = bodies_text(components);
  if (stored == wanted) return;
  throw InputError(fmt::format(
      "{}: the stored state has {}, but this deck has {}. Use the FINAL file of a bearing with the "
      "same elements and cage, or start from the quasi-static solution (kIcOpt = 0)",
      path.string(), stored, wanted));
}

}  // namespace adore::results

#include "results/full_precision.hpp"

#include "base/errors.hpp"
#include "results/channels.hpp"
#include "results/results_h5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace adore::results {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// If the two sums of the revolutions of a long run differ by rounding.
constexpr double kRevolutionRounding = 1e-9;

/// Relative resolution of the (1p,e16.7) fields of SOL1-SOL7 with some room.
constexpr double kSolDigits = 1e-6;

/// RESULTS.h5 in the folder of `file` if it has the run code; otherwise nothing and the reason.
std::optional<H5Reader> open_results_of(const std::filesystem::path& file,
                                        const std::string& run_id, std::string& why_not) {
  const std::filesystem::path path = file.parent_path() / "RESULTS.h5";
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    why_not = "there is no RESULTS.h5 in the folder of the SOL file";
    return std::nullopt;
  }
  try {
    H5Reader reader(path);
    if (reader.run_id() == run_id) return reader;
    why_not = fmt::format("RESULTS.h5 in the folder of the SOL file belongs to the run '{}'",
                          reader.run_id());
  } catch (const InputError& error) {
    why_not = error.what();
  }
  return std::nullopt;
}

/// First pocket of a cage file: classic files do not store the number of its element.
void take_first_pocket(SolHeader& header, const H5Reader& reader) {
  const auto first = reader.geometry().find("first_pocket");
  if (first == reader.geometry().end() || header.segments < 2) return;
  if (first->second >= 1.0 && first->second <= header.elements)
    header.first_pocket = static_cast<int>(first->second) - 1;
}

/// Row of each step number in RESULTS.h5.
std::unordered_map<long, std::size_t> positions_of(const H5Reader& reader) {
  std::unordered_map<long, std::size_t> positions;
  const std::vector<long> numbers = reader.step_numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) positions[numbers[i]] = i;
  return positions;
}

/// Could a field of so many digits show `exact` as `shown`? Stars fit every number.
bool fits(double shown, double exact, double digits, double least) {
  if (!std::isfinite(shown) || !std::isfinite(exact)) return !std::isfinite(shown);
  return std::abs(shown - exact) <= digits * std::abs(exact) + least;
}

UnitSystem units_of(const SolFile& file, const std::vector<SolColumn>& columns) {
  for (const SolColumn& column : columns) {
    if (column.unit == nullptr || column.unit->si == column.unit->en) continue;
    const std::string shown = unit_of_column(file, column);
    if (shown == column.unit->si) return UnitSystem::SI;
    if (shown == column.unit->en) return UnitSystem::English;
  }
  return UnitSystem::SI;
}

/// Parts of a channel that are read for some columns of a file: adjacent columns share them.
struct ChannelColumns {
  const H5Reader& reader;
  const SolFile& file;
  std::vector<SolColumn> columns = sol_columns(file.header);
  UnitSystem units = units_of(file, columns);

  /// Calls use(i, place, value) for the i-th of the steps of RESULTS.h5 and the place of every
  /// column that has a channel among a step's values, in the file's units, until it returns false.
  template <class Use>
  bool each(std::size_t first, std::size_t count, std::size_t every, Use use) const {
    std::map<int, std::vector<double>> read;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const SolColumn& column = columns[c];
      const std::size_t place = file.place(c);
      if (column.channel < 0 || place == std::string::npos) continue;
      const std::string id(channels()[static_cast<std::size_t>(column.channel)].id);
      const H5Reader::ChannelInfo* info = reader.find(id);
      if (info == nullptr || column.at >= info->size()) continue;
      auto& values = read[column.channel];
      if (values.empty()) values = reader.read(id, first, count, every);
      for (std::size_t i = 0; i < count; ++i) {
        const double exact = values[i * info->size() + column.at];
        if (!use(i, place, column.unit == nullptr ? exact : from_si(exact, *column.unit, units)))
          return false;
      }
    }
    return true;
  }
};

constexpr const char* kOtherRun =
    "RESULTS.h5 in the folder of the SOL file contains different numbers, so it belongs to another "
    "run";

/// Steps of the classic file at even distances in RESULTS.h5: a part of bounded size.
struct StepBlock {
  std::size_t step = 0, count = 0;   ///< of the classic file
  std::size_t first = 0, every = 1;  ///< in RESULTS.h5
};

/// `at`: where each step stands in RESULTS.h5, or `nowhere`.
std::vector<StepBlock> blocks_of(const std::vector<std::size_t>& at, std::size_t nowhere) {
  constexpr std::size_t kMaxSteps = 2048;
  std::vector<StepBlock> out;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] == nowhere) continue;
    StepBlock* last = out.empty() || out.back().step + out.back().count != i ||
                              out.back().count == kMaxSteps || at[i] <= at[i - 1]
                          ? nullptr
                          : &out.back();
    if (last != nullptr && last->count == 1) last->every = at[i] - at[i - 1];
    if (last == nullptr || at[i] - at[i - 1] != last->every)
      out.push_back({i, 1, at[i], 1});
    else
      ++last->count;
  }
  return out;
}

/// Compares the numbers of a block, or replaces them. False when one differs.
bool use_block(SolFile& file, const H5Reader& reader, const StepBlock& block, bool replace) {
  const ChannelColumns source{reader, file};
  return source.each(block.first, block.count, block.every,
                     [&](std::size_t i, std::size_t place, double value) {
                       std::vector<double>& shown = file.steps[block.step + i].values;
                       if (place >= shown.size()) return true;
                       if (replace) shown[place] = value;
                       return replace || fits(shown[place], value, kSolDigits, 1e-30);
                     });
}

/// How far apart in RESULTS.h5 the file's steps stand: as most of them do.
std::size_t distance_of(const std::vector<StepBlock>& blocks) {
  std::map<std::size_t, std::size_t> steps;
  for (const StepBlock& block : blocks)
    if (block.count > 1) steps[block.every] += block.count - 1;
  const auto most = std::max_element(
      steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == steps.end() ? 1 : most->first;
}

/// Adds the steps of RESULTS.h5 `first`, `first` + `every`, ... (`count` of them) to the file's.
void add_steps(SolFile& file, const H5Reader& reader, const std::vector<double>& times,
               std::size_t first, std::size_t count, std::size_t every) {
  constexpr std::size_t kPiece = 2048;
  const std::vector<long> numbers = reader.step_numbers();
  const ChannelColumns source{reader, file};
  const auto element = static_cast<std::size_t>(std::max(file.header.index, 1)) - 1;
  const H5Reader::ChannelInfo* orbit =
      file.kind == SolKind::Element ? reader.find("element.orbital_position") : nullptr;
  for (std::size_t done = 0; done < count; done += kPiece) {
    const std::size_t begin = first + done * every, n = std::min(kPiece, count - done);
    const auto shaft = reader.read("shaft_rotation", begin, n, every),
               sizes = reader.read("step_size", begin, n, every);
    const auto own = orbit != nullptr && element < orbit->size()
                         ? reader.read("element.orbital_position", begin, n, every)
                         : std::vector<double>();
    const std::size_t place = file.steps.size(), width = file.steps.back().values.size();
    for (std::size_t i = 0; i < n; ++i) {
      SolStep& step = file.steps.emplace_back();
      step.step = numbers[begin + i * every];
      step.revolutions = shaft[i] / kTurn;
      if (!own.empty()) step.element_revolutions = own[i * orbit->size() + element] / kTurn;
      step.step_size = sizes[i];
      step.time = times[begin + i * every];
      step.values.assign(width, std::numeric_limits<double>::quiet_NaN());
    }
    source.each(begin, n, every, [&](std::size_t i, std::size_t at, double value) {
      std::vector<double>& values = file.steps[place + i].values;
      if (at < values.size()) values[at] = value;
      return true;
    });
  }
}

}  // namespace

FullPrecisionStatus use_full_precision(SolFile& file, std::size_t most_added) {
  FullPrecisionStatus out;
  const auto reader = open_results_of(file.path, file.header.run_id, out.why_not);
  if (!reader) return out;
  take_first_pocket(file.header, *reader);
  const std::size_t own = file.steps.size();
  try {
    const auto positions = positions_of(*reader);
    const std::vector<double> times = reader->read("time");
    std::vector<std::size_t> at(file.steps.size(), reader->steps());
    for (std::size_t i = 0; i < file.steps.size(); ++i) {
      const auto found = positions.find(file.steps[i].step);
      if (found == positions.end()) continue;
      if (!fits(file.steps[i].time, times[found->second], kSolDigits, 1e-300)) return {kOtherRun};
      at[i] = found->second;
      ++out.exact;
    }
    if (out.exact == 0)
      return {
          "RESULTS.h5 in the folder of the SOL file contains none of the steps of the SOL file"};
    out.from_start = at[out.exact - 1] < reader->steps() &&
                     std::all_of(at.begin() + static_cast<std::ptrdiff_t>(out.exact), at.end(),
                                 [&](std::size_t place) { return place == reader->steps(); });

    // Nothing is replaced before every number has been compared.
    const std::vector<StepBlock> blocks = blocks_of(at, reader->steps());
    for (const bool replace : {false, true})
      for (const StepBlock& block : blocks)
        if (!use_block(file, *reader, block, replace)) return {kOtherRun};
    const std::vector<double> shaft = reader->read("shaft_rotation");
    for (std::size_t i = 0; i < file.steps.size(); ++i) {
      if (at[i] >= reader->steps()) continue;
      SolStep& step = file.steps[i];
      step.time = times[at[i]];
      if (const double turns = shaft[at[i]] / kTurn;
          fits(step.revolutions, turns, kSolDigits, kRevolutionRounding))
        step.revolutions = turns;
    }

    const std::vector<long> numbers = reader->step_numbers();
    out.end = numbers.empty() ? 0 : numbers.back();
    const std::size_t last = at.back(), rows = reader->steps();
    // The file's end is the later one, or both have the same: an interval may have left it out.
    const long own_end = std::max(file.last_step, file.steps.back().step);
    if (most_added == 0 || last >= rows || out.end <= own_end) return out;
    const std::size_t every = distance_of(blocks);
    std::size_t first = last + every;
    while (first < rows && numbers[first] <= own_end) first += every;
    const std::size_t behind = first < rows ? (rows - 1 - first) / every + 1 : 0;
    out.added = std::min(behind, most_added);
    out.more = out.added < behind;
    add_steps(file, *reader, times, first, out.added, every);
    // The end of a run is stored at any distance.
    if (!out.more && file.steps.back().step < out.end && out.added < most_added) {
      add_steps(file, *reader, times, rows - 1, 1, 1);
      ++out.added;
    }
    return out;
  } catch (const InputError& error) {
    file.steps.resize(own);
    return {error.what()};
  }
}

namespace {

/// Takes what a row of RESULTS.h5 says of one step into the extremes of a longer time.
void widen(ColumnBand& band, std::size_t step, double low, double high) {
  double &lowest = band.low[step], &highest = band.high[step];
  lowest = std::isnan(lowest) ? low : std::min(lowest, low);
  highest = std::isnan(highest) ? high : std::max(highest, high);
}

}  // namespace

std::map<std::size_t, ColumnBand> bands_of(const SolFile& file,
                                           const std::set<std::size_t>& wanted) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t kMaxRows = 2048;
  std::map<std::size_t, ColumnBand> out;
  std::string why_not;
  const auto reader = open_results_of(file.path, file.header.run_id, why_not);
  if (!reader) return out;
  const std::vector<SolColumn> columns = sol_columns(file.header);
  const UnitSystem units = units_of(file, columns);
  struct Place {
    std::size_t column, at;
  };
  std::map<std::string, std::vector<Place>> of_channel;
  for (const std::size_t c : wanted) {
    if (c >= columns.size() || columns[c].channel < 0) continue;
    std::string id(channels()[static_cast<std::size_t>(columns[c].channel)].id);
    std::size_t at = columns[c].at;
    // The cage's columns name the first two lands of each piece separately.
    for (const auto& [name, land] : {std::pair{"cage.land1_force", 0U}, {"cage.land2_force", 1U}}) {
      if (id != name) continue;
      id = "land.force";
      const H5Reader::ChannelInfo* lands = reader->find(id);
      const std::size_t each =
          lands != nullptr && lands->dimensions.size() == 2 ? lands->dimensions[1] : 0;
      at = land < each ? at * each + land : std::numeric_limits<std::size_t>::max();
      break;
    }
    of_channel[id].push_back({c, at});
  }
  std::erase_if(of_channel, [&](const auto& one) {
    return reader->find(one.first + "_low") == nullptr ||
           reader->find(one.first + "_high") == nullptr;
  });
  if (of_channel.empty()) return out;
  // The step of the file to which each row of RESULTS.h5 belongs: the first that is not before it.
  const std::vector<long> rows = reader->step_numbers();
  std::vector<std::size_t> step_of(rows.size(), file.steps.size());
  for (std::size_t row = 0, step = 0; row < rows.size(); ++row) {
    while (step < file.steps.size() && file.steps[step].step < rows[row]) ++step;
    // The time before the first step of the file is not an interval between two steps.
    if (step < file.steps.size() && (step > 0 || file.steps[0].step == rows[row]))
      step_of[row] = step;
  }
  for (const auto& [channel, of] : of_channel) {
    const std::string low_id = channel + "_low", high_id = channel + "_high";
    const std::size_t width = reader->find(low_id)->size();
    if (reader->find(high_id)->size() != width) continue;
    for (const auto& [c, at] : of)
      if (at < width)
        out[c] = {std::vector<double>(file.steps.size(), kNone),
                  std::vector<double>(file.steps.size(), kNone)};
    for (std::size_t first = 0; first < rows.size(); first += kMaxRows) {
      const std::size_t count = std::min(kMaxRows, rows.size() - first);
      const auto used = [&](std::size_t row) { return step_of[row] < file.steps.size(); };
      bool any = false;
      for (std::size_t row = first; row < first + count; ++row) any = any || used(row);
      if (!any) continue;
      const auto low = reader->read(low_id, first, count),
                 high = reader->read(high_id, first, count);
      for (const auto& place : of) {
        const std::size_t c = place.column, at = place.at;
        if (at >= width) continue;
        const auto shown = [&](double value) {
          return columns[c].unit == nullptr ? value : from_si(value, *columns[c].unit, units);
        };
        // Slip is 0 where nothing touched all the time: no extremes of it.
        const bool slip = channel.ends_with(".slip");
        for (std::size_t i = 0; i < count; ++i)
          if (used(first + i) && !(slip && high[i * width + at] == 0.0))
            widen(out[c], step_of[first + i], shown(low[i * width + at]),
                  shown(high[i * width + at]));
      }
    }
  }
  // A step that RESULTS.h5 does not hold has none, even where rows before it do.
  std::vector<bool> held(file.steps.size(), false);
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (step_of[row] < file.steps.size() && file.steps[step_of[row]].step == rows[row])
      held[step_of[row]] = true;
  for (auto& [column, band] : out)
    for (std::size_t i = 0; i < held.size(); ++i)
      if (!held[i]) band.low[i] = band.high[i] = kNone;
  return out;
}

}  // namespace adore::results

#include "results/sol_parser.hpp"

#include "base/errors.hpp"
#include "base/own_files.hpp"
#include "results/channels.hpp"
#include "results/fortran_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace adore::results {
namespace {

namespace ff = fortran;

constexpr long long kMaxElements = 100'000;
constexpr long long kMaxValues = 1'000'000;

/// Integers in columns of one width after two blanks. Fields beyond the line's end are empty.
std::vector<std::optional<long long>> integer_fields(std::string_view line, int count, int width) {
  std::vector<std::optional<long long>> fields;
  for (int k = 0; k < count; ++k)
    fields.push_back(ff::parse_integer(ff::columns(line, 3 + k * width, 2 + (k + 1) * width)));
  return fields;
}

std::string_view without_trailing_blanks(std::string_view line) {
  const std::size_t last = line.find_last_not_of(' ');
  return last == std::string_view::npos ? std::string_view() : line.substr(0, last + 1);
}

}  // namespace

SolParser::SolParser(std::istream& stream, std::string name)
    : reader_(stream), name_(std::move(name)) {
  const std::string first(read_header_line("the version and the run code"));
  if (const AdoreFileType sort = detect_file_type(first); sort != AdoreFileType::Unknown)
    throw InputError(fmt::format("{}: this is {}, not one of SOL1-SOL8; {}", name_,
                                 describe_file_type(sort), file_type_usage_hint(sort)));
  const std::string second(read_header_line("a title or integers"));
  if (first.find('\0') != std::string::npos || second.find('\0') != std::string::npos)
    reject("it contains binary data");
  const bool titled = second.find('$') != std::string::npos;
  const auto integers = integer_fields(second, 14, 3);
  // The eleven n + 22 of the fourteenth field may have overflowed its three columns.
  const bool animated = !titled && std::all_of(integers.begin(), integers.end() - 1,
                                               [](const auto& i) { return i.has_value(); });
  read_identity(first);
  if (animated)
    read_animation_header(first, second);
  else
    read_plot_header(first, second);
  complete_bytes_ = reader_.offset();
  ends_with_newline_ = reader_.has_line_end();
}

void SolParser::reject(const std::string& why) const {
  throw InputError(fmt::format(
      "{}: this is not a SOL1-SOL8 file ({}); give a result file of a dynamic run", name_, why));
}

std::string_view SolParser::read_header_line(std::string_view what) {
  std::string_view line;
  if (reader_.next(line)) return line;
  if (reader_.is_line_too_long()) reject("it contains binary data or a line that is too long");
  reject(fmt::format("line {} of the header ({}) is missing", reader_.number() + 1, what));
}

void SolParser::read_identity(std::string_view first) {
  // a12 or a10, then five blanks and the run code; a version of at most ten characters leaves
  // columns 13-14 blank (N60).
  const bool twelve = !ff::trimmed(ff::columns(first, 13, 14)).empty();
  header_.version = ff::trimmed(ff::columns(first, 3, twelve ? 14 : 12));
  header_.run_id = ff::trimmed(ff::columns(first, twelve ? 20 : 18, 55));
  constexpr int kMaxColumns = 400;
  if (const std::string_view user =
          ff::trimmed(ff::columns(first, kUserVersionColumn, kMaxColumns));
      user.starts_with('+'))
    header_.version += user;
}

void SolParser::read_units(const std::array<int, 10>& lengths) {
  const std::string_view line = read_header_line("the units");
  for (int k = 0; k < 10; ++k) {
    const std::string_view field = ff::columns(line, 3 + 12 * k, 12 + 12 * k);
    const auto length =
        static_cast<std::size_t>(std::clamp(lengths[static_cast<std::size_t>(k)], 0, 10));
    header_.units[static_cast<std::size_t>(k)] = ff::trimmed(field.substr(0, length));
  }
}

void SolParser::read_plot_header(std::string_view, std::string_view title) {
  const std::size_t mark = title.find('$');
  header_.title = ff::trimmed(title.substr(0, mark));
  const auto integers = integer_fields(read_header_line("twenty integers"), 20, 6);
  for (int k = 0; k < 5; ++k)
    if (!integers[static_cast<std::size_t>(k)])
      reject(fmt::format("integer {} of line 3 is missing", k + 1));
  const auto integer = [&](int number) {
    return integers[static_cast<std::size_t>(number - 1)].value_or(0);
  };
  const auto check = [&](int number, long long least, long long most) {
    if (integer(number) < least || integer(number) > most)
      reject(fmt::format("integer {} of line 3 is {}, but it must be from {} to {}", number,
                         integer(number), least, most));
    return static_cast<int>(integer(number));
  };
  header_.value_count = check(1, 1, kMaxValues);
  header_.elements = check(2, 1, kMaxElements);
  header_.per_segment = check(3, 0, kMaxElements);
  header_.segments = check(4, 0, kMaxElements);
  header_.index = check(5, 0, integer(2) + integer(4) + 2);
  header_.outer_flange = integer(6) != 0;
  header_.inner_flange = integer(7) != 0;
  header_.bearing_type = integers[17] ? check(18, -1000, 1000) : 1;
  header_.pocket_type = integers[18] ? check(19, -1000, 1000) : 0;
  header_.pocket_surfaces = integers[19] ? check(20, 0, 10000) : 1;
  std::array<int, 10> lengths{};
  for (int k = 0; k < 10; ++k)
    lengths[static_cast<std::size_t>(k)] = static_cast<int>(std::clamp(integer(8 + k), 0LL, 10LL));
  read_units(lengths);
  kind_ = sol_kind_of(header_);
}

void SolParser::read_animation_header(std::string_view, std::string_view line) {
  const auto integers = integer_fields(line, 14, 3);
  const auto integer = [&](int number) {
    return static_cast<int>(integers[static_cast<std::size_t>(number - 1)].value_or(0));
  };
  kind_ = SolKind::Animation;
  header_.bearing_type = integer(1);
  header_.elements = integer(2);
  if (header_.elements < 1)
    reject(fmt::format("line 2 gives {} rolling elements", header_.elements));
  const int needed = 11 * header_.elements + 22;
  header_.value_count = integers[13] ? integer(14) : needed;
  const int geometry = integer(13);
  if (geometry < 12)
    reject(fmt::format("line 2 gives {} geometry values, but twelve are needed", geometry));
  if (header_.value_count < needed)
    reject(fmt::format("line 2 gives {} values per step, but {} rolling elements need {}",
                       header_.value_count, header_.elements, needed));
  std::array<int, 10> lengths{};
  for (int k = 0; k < 10; ++k) lengths[static_cast<std::size_t>(k)] = integer(3 + k);
  read_units(lengths);
  if (read_values(geometry, 10, 0, &geometry_) != BlockStatus::Complete)
    reject("the geometry in line 4 is missing or damaged");
}

BlockStatus SolParser::read_values(int count, int width, long step, std::vector<double>* values) {
  if (values != nullptr) {
    values->clear();
    values->reserve(static_cast<std::size_t>(std::min(count, 4096)));
  }
  int found = 0;
  while (found < count) {
    std::string_view line;
    if (!reader_.next(line))
      return reader_.is_line_too_long() ? BlockStatus::Wrong : BlockStatus::Cut;
    const bool last_line = !reader_.has_line_end();
    line = without_trailing_blanks(line);
    if (line.size() <= 2) return last_line ? BlockStatus::Cut : BlockStatus::Wrong;
    const int used = static_cast<int>(line.size()) - 2;
    if (used % width != 0) return last_line ? BlockStatus::Cut : BlockStatus::Wrong;
    const int fields = used / width;
    if (fields > count - found) return BlockStatus::Wrong;
    for (int k = 0; k < fields && values != nullptr; ++k) {
      const auto value = ff::parse_real(ff::columns(line, 3 + k * width, 2 + (k + 1) * width));
      if (!value) return BlockStatus::Wrong;
      values->push_back(*value);
      if (!std::isfinite(*value) && missing_count_++ == 0) first_missing_step_ = step;
    }
    found += fields;
  }
  return BlockStatus::Complete;
}

BlockStatus SolParser::read_step_line(SolStep& step) {
  std::string_view line;
  do {
    if (!reader_.next(line))
      return reader_.is_line_too_long() ? BlockStatus::Wrong : BlockStatus::End;
  } while (reader_.has_line_end() &&
           ff::trimmed(line).empty());  // blank lines at the end do no harm
  const bool last_line = !reader_.has_line_end();
  const int reals = kind_ == SolKind::Animation ? 2 : 4;
  if (static_cast<int>(line.size()) < 18 + 16 * reals)
    return last_line ? BlockStatus::Cut : BlockStatus::Wrong;
  const auto number = ff::parse_integer(ff::columns(line, 3, 18));
  if (!number || *number > std::numeric_limits<long>::max() / 2) return BlockStatus::Wrong;
  step.step = static_cast<long>(*number);
  std::array<double, 4> real{};
  for (int k = 0; k < reals; ++k) {
    const auto value = ff::parse_real(ff::columns(line, 19 + 16 * k, 34 + 16 * k));
    if (!value) return BlockStatus::Wrong;
    real[static_cast<std::size_t>(k)] = *value;
  }
  step.revolutions = real[0];
  if (kind_ == SolKind::Animation) {
    step.time = real[1];
  } else {
    step.element_revolutions = real[1];
    step.step_size = real[2];
    step.time = real[3];
  }
  return BlockStatus::Complete;
}

BlockStatus SolParser::next(SolStep& step, bool with_values) {
  step = {};
  BlockStatus status = read_step_line(step);
  const bool began = status == BlockStatus::Complete;
  if (began)
    status = read_values(header_.value_count, kind_ == SolKind::Animation ? 10 : 16, step.step,
                         with_values ? &step.values : nullptr);
  if (status == BlockStatus::Complete) {
    complete_bytes_ = reader_.offset();
    ends_with_newline_ = reader_.has_line_end();
    return status;
  }
  const std::string where =
      began ? fmt::format("step {}", step.step) : std::string("the first line of a step");
  if (status == BlockStatus::Cut)
    note_ = fmt::format("the file is cut off in {} (line {})", where, reader_.number());
  else if (status == BlockStatus::Wrong)
    note_ = fmt::format("the file is damaged in {} (line {}); later steps are not used", where,
                        reader_.number());
  return status;
}

std::string SolParser::gaps() const {
  if (missing_count_ == 0) return {};
  return fmt::format(
      "{} not finite (stars: the number is too wide for its field); first occurrence: step {}",
      missing_count_ == 1 ? "1 value is" : fmt::format("{} values are", missing_count_),
      first_missing_step_);
}

}  // namespace adore::results

#include "results/continuation.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "results/fortran_format.hpp"
#include "results/sol_parser.hpp"

#include <fmt/format.h>

#include <sstream>

namespace adore::results {
namespace {

constexpr std::string_view kRemedy =
    "use the values of the earlier deck, or start new files with kIcOpt = -1";

template <class T>
void compare(const std::filesystem::path& path, std::string_view what, const T& found,
             const T& expected) {
  if (found == expected) return;
  throw InputError(
      fmt::format("{}: the file that this run continues has {} = {}, but this run has {}; {}",
                  path.string(), what, found, expected, kRemedy));
}

InputFile open_existing(const std::filesystem::path& path) {
  InputFile stream(path);
  if (!stream)
    throw InputError(
        fmt::format("{}: cannot open the file that this run continues. Restore the file, or start "
                    "new files with kIcOpt = -1",
                    path.string()));
  return stream;
}

void compare_headers(const std::filesystem::path& path, const SolParser& found,
                     const std::string& expected_header) {
  std::istringstream expected_stream(expected_header);
  const SolParser expected(expected_stream, "header");
  const SolHeader& a = found.header();
  const SolHeader& b = expected.header();
  check_run_id(path, a.run_id, b.run_id);
  compare(path, "number of rolling elements", a.elements, b.elements);
  compare(path, "number of cage segments", a.segments, b.segments);
  compare(path, "body index", a.index, b.index);
  compare(path, "values per step", a.value_count, b.value_count);
  compare(path, "bearing type", a.bearing_type, b.bearing_type);
  for (std::size_t k = 0; k < a.units.size(); ++k)
    compare(path, fmt::format("unit {}", k + 1), a.units[k], b.units[k]);
}

}  // namespace

void check_run_id(const std::filesystem::path& path, const std::string& found,
                  const std::string& of_deck) {
  const std::string_view a = fortran::trimmed(found), b = fortran::trimmed(of_deck);
  if (a.substr(0, 36) == b.substr(0, 36)) return;
  throw InputError(
      fmt::format("{}: the file belongs to run '{}', but the deck has runID = '{}'. Restore the "
                  "files of this run, or start new files from FINAL with kIcOpt = -1",
                  path.string(), a, b));
}

void check_sol_file(const std::filesystem::path& path, const std::string& expected_header) {
  InputFile stream = open_existing(path);
  compare_headers(path, SolParser(stream, path.string()), expected_header);
}

std::pair<long, double> last_stored_step(const std::filesystem::path& path) {
  InputFile stream = open_existing(path);
  SolParser found(stream, path.string());
  SolStep step, last;
  while (found.next(step, false) == BlockStatus::Complete) std::swap(last, step);
  return {last.step, last.time};
}

GrowingFile continue_sol_file(const WritePath& place, const std::string& expected_header,
                              long last_step) {
  const std::filesystem::path path = place.path();
  InputFile stream = open_existing(path);
  SolParser found(stream, path.string());
  compare_headers(path, found, expected_header);
  std::uintmax_t bytes = found.complete_bytes();
  bool terminated = found.ends_with_newline();
  SolStep step;
  while (found.next(step, false) == BlockStatus::Complete && step.step <= last_step) {
    bytes = found.complete_bytes();
    terminated = found.ends_with_newline();
  }
  GrowingFile file = GrowingFile::open_for_append(place, bytes);
  if (!terminated) file.append("\n");
  return file;
}

}  // namespace adore::results

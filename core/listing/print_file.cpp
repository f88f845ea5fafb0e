#include "listing/print_file.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "listing/print_fits.hpp"
#include "listing/print_heat.hpp"
#include "results/continuation.hpp"
#include "results/fortran_format.hpp"
#include "results/line_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace adore::listing {

PrintSections select_print_sections(int kPrtOpt) {
  PrintSections out;
  out.applied = kPrtOpt >= -1;
  out.bodies = kPrtOpt >= 0;
  out.element_interval = kPrtOpt >= 1 ? kPrtOpt : 0;
  return out;
}

PrintFile PrintFile::create(const WritePath& place, std::string run_id, UnitSystem units) {
  return {GrowingFile::create(place), std::move(run_id), units};
}

void PrintFile::check(const std::filesystem::path& path, const std::string& run_id) {
  InputFile stream(path);
  if (!stream)
    throw InputError(
        fmt::format("{}: cannot open the file that this run continues. Restore the file, or start "
                    "new files with kIcOpt = -1",
                    path.string()));
  std::string_view line;
  LineReader lines(stream);
  // The heading of the first page: version in 20 columns, run code in the next 40
  // (Report::new_page), after a form feed.
  check_run_id(path, lines.next(line) ? std::string(fortran::columns(line, 22, 61)) : std::string(),
               run_id);
}

PrintFile PrintFile::continue_after(const WritePath& place, std::string run_id, UnitSystem units,
                                    std::uintmax_t bytes) {
  const std::filesystem::path path = place.path();
  check(path, run_id);
  PrintFile out(GrowingFile::open_for_append(place, bytes), std::move(run_id), units);
  // The last page is in the last bytes.
  constexpr std::uintmax_t kMost = 1 << 16;
  const std::uintmax_t size = std::min(bytes, kMost);
  InputFile stream(path);
  stream.seekg(static_cast<std::streamoff>(bytes - size));
  std::string tail(static_cast<std::size_t>(size), '\0');
  stream.read(tail.data(), static_cast<std::streamsize>(size));
  tail.resize(static_cast<std::size_t>(stream.gcount()));
  out.report_.resume(tail);
  return out;
}

std::pair<long, double> PrintFile::last_stored_step(const std::filesystem::path& path,
                                                    std::uintmax_t bytes) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size <= bytes) return {};
  // Of a long rest its end: a step of a thousand elements has less.
  constexpr std::uintmax_t kMost = 1 << 22;
  InputFile stream(path);
  stream.seekg(static_cast<std::streamoff>(size - std::min(size - bytes, kMost)));
  std::pair<long, double> out;
  long step = 0;
  std::string_view line;
  for (LineReader lines(stream); lines.next(line);) {
    // As Report::item() puts them: label from the third column, value in 16 behind the 62 of it.
    if (line.size() < 81) continue;
    const auto value = [&] {
      std::string_view text = line.substr(65, 16);
      text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
      double number = 0.0;
      std::from_chars(text.data(), text.data() + text.size(), number);
      return number;
    };
    if (line.starts_with("  Step  ")) step = static_cast<long>(value());
    if (line.starts_with("  Time  ")) out = {step, std::max(out.second, value())};
    // Files of 0.9.0 have "Its end".
    if (line.starts_with("  Step end  ") || line.starts_with("  Its end  "))
      out.second = std::max(out.second, value());
  }
  return out;
}

void PrintFile::flush() {
  std::string text = report_.take();
  constexpr std::size_t kColumn = 20;  // of the version at the head of a page
  if (!heading_version_.empty())
    for (std::size_t page = text.find('\f'); page != std::string::npos;
         page = text.find('\f', page + 1))
      if (page + 1 + kColumn <= text.size())
        text.replace(page + 1, kColumn,
                     fmt::format("{:<20}", heading_version_.substr(0, kColumn - 1)));
  file_.append(text);
}

void PrintFile::texts(std::string_view title, const std::vector<std::string>& lines, bool page) {
  if (page)
    report_.new_page(title);
  else
    report_.heading(title);
  for (const std::string& line : lines) report_.text(line);
  flush();
}

void PrintFile::front(const FrontMatter& front) {
  print_front_matter(report_, front);
  flush();
}

void PrintFile::fits(const bearing::Bearing& bearing) {
  print_fits(report_, bearing);
  flush();
}

void PrintFile::summary(const StaticSummary& summary, const bearing::Bearing& bearing,
                        const life::BearingLife& life, const std::vector<std::string>& warnings) {
  print_static_summary(report_, summary, bearing, life, warnings, summary.result.notes);
  flush();
}

void PrintFile::quasi_static(const statics::StaticSolution& solution,
                             const bearing::Bearing& bearing) {
  print_quasi_static(report_, solution, bearing);
  flush();
}

void PrintFile::quasi_static(const statics::RollerSolution& solution,
                             const bearing::Bearing& bearing) {
  print_quasi_static(report_, solution, bearing);
  flush();
}

void PrintFile::stiffness_table(const std::vector<statics::StiffnessRow>& rows, double share) {
  print_stiffness_table(report_, rows, share);
  flush();
}

void PrintFile::step(const scene::Snapshot& snapshot, const StepRecord& record,
                     const bearing::Bearing& bearing, const Averages& averages, int kPrtOpt,
                     std::optional<long> life_step) {
  print_step(report_, snapshot, record, bearing, averages, kPrtOpt, life_step, friction_);
  flush();
}

void PrintFile::friction(const statics::FrictionEstimate& friction, const std::string& element) {
  print_friction(report_, friction, element);
  flush();
}

void PrintFile::thermal(const thermal::SteadyState& steady) {
  print_steady_state(report_, steady);
  flush();
}

void PrintFile::time_line(const thermal::ThermalTransient& line) {
  print_time_line(report_, line);
  flush();
}

void PrintFile::thermal_step(const thermal::BearingHeat& heat, long step, double time,
                             bool geometry) {
  print_thermal_step(report_, heat, step, time, geometry);
  flush();
}

void PrintFile::life(const life::BearingLife& life) {
  print_life(report_, life);
  flush();
}

void PrintFile::ledgers(const RunSummary& run, const scene::ScenePlan& plan,
                        const std::optional<RunLife>& life) {
  print_ledgers(report_, run, plan, life);
  flush();
}

}  // namespace adore::listing

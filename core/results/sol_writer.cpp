#include "results/sol_writer.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"
#include "results/continuation.hpp"
#include "results/fortran_format.hpp"
#include "results/motion.hpp"

#include <fmt/format.h>

#include <fstream>
#include <numbers>

namespace adore::results {
namespace {

namespace ff = fortran;
constexpr int kValuesPerLine = 8;

std::string title_of(const SolHeader& header) {
  switch (sol_kind_of(header)) {
    case SolKind::Power:
      return "Power Dissipation and Life";
    case SolKind::Element:
      return fmt::format("Rolling Element {}", header.index);
    case SolKind::Cage:
      return header.segments == 1 ? std::string("Cage")
                                  : fmt::format("Cage Segment {}", header.index - header.elements);
    case SolKind::Race:
    case SolKind::Animation:
      break;
  }
  return header.index == header.elements + header.segments + 1 ? "Outer Race" : "Inner Race";
}

}  // namespace

std::string format_sol_header(const SolHeader& header) {
  std::string out = "  ";
  const FileVersion version = file_version(header.version);
  ff::append_text(out, version.program, 12);
  out.append(5, ' ');
  ff::append_text(out, header.run_id, 36);
  append_user_version(out, version);
  out += "\n  ";
  out += header.title;
  out += "$\n  ";
  for (int value : {header.value_count, header.elements, header.per_segment, header.segments,
                    header.index, header.outer_flange ? 1 : 0, header.inner_flange ? 1 : 0})
    ff::append_integer(out, value, 6);
  for (const std::string& unit : header.units)
    ff::append_integer(out, static_cast<long long>(std::min<std::size_t>(unit.size(), 10)), 6);
  for (int value : {header.bearing_type, header.pocket_type, header.pocket_surfaces})
    ff::append_integer(out, value, 6);
  out += "\n  ";
  for (const std::string& unit : header.units) {
    ff::append_text(out, unit, 10);
    out += "  ";
  }
  out += '\n';
  return out;
}

void append_sol_step(std::string& out, const SolStep& step) {
  out += "  ";
  ff::append_integer(out, step.step, 16);
  for (double value : {step.revolutions, step.element_revolutions, step.step_size, step.time})
    ff::append_real(out, value, 16, 7, ff::Scale::One);
  if (!step.values.empty()) out += "\n  ";
  ff::append_reals(out, step.values, 16, 7, ff::Scale::One, kValuesPerLine, "\n  ");
  out += '\n';
}

SolHeader make_sol_header(const bearing::Bearing& bearing, int index, UnitSystem units) {
  const Shape shape = shape_of(bearing);
  if (index < 0 || index > shape.elements + shape.cages + 2)
    throw InputError(
        fmt::format("kPltElemInd: there is no body {}. The bodies are numbered 1 to {} ({} rolling "
                    "elements, {}outer race, inner race)",
                    index, shape.elements + shape.cages + 2, shape.elements,
                    shape.cages > 1   ? fmt::format("{} cage segments, ", shape.cages)
                    : shape.cages > 0 ? std::string("cage, ")
                                      : std::string()));
  SolHeader header;
  header.version = std::string(kFileVersion) + bearing.user_version;
  header.run_id = bearing.run_id;
  header.elements = shape.elements;
  header.segments = shape.cages;
  header.first_pocket = shape.first_pocket;
  header.per_segment = shape.cages > 0 ? shape.elements / shape.cages : 0;
  header.index = index;
  header.bearing_type = static_cast<int>(bearing.type);
  if (const bearing::RollerGeometry* rollers = bearing.rollers()) {
    header.outer_flange = rollers->has_flange(bearing::kOuter);
    header.inner_flange = rollers->has_flange(bearing::kInner);
  }
  if (bearing.cage) header.pocket_type = bearing::pocket_code(*bearing.cage, shape.rollers);
  header.pocket_surfaces = bearing.cage ? shape.pocket_surfaces : 1;
  const SolKind kind = sol_kind_of(header);
  header.title = title_of(header);
  header.value_count = sol_value_count(kind, shape);
  const auto slots = unit_slots(kind);
  for (std::size_t k = 0; k < slots.size(); ++k)
    if (slots[k] != nullptr) header.units[k] = unit_name(*slots[k], units);
  return header;
}

SolStep make_sol_step(const SolHeader& header, const std::vector<SolColumn>& columns,
                      const StepRecord& record, UnitSystem units) {
  SolStep step;
  step.step = record.step;
  step.revolutions = record.shaft_rotation / (2.0 * std::numbers::pi);
  if (sol_kind_of(header) == SolKind::Element)
    step.element_revolutions =
        record["element.orbital_position"][static_cast<std::size_t>(header.index - 1)] /
        (2.0 * std::numbers::pi);
  step.step_size = record.step_size;
  step.time = record.time;
  step.values.reserve(columns.size());
  for (const SolColumn& column : columns) {
    demand(column.channel >= 0, "a column of a SOL file has no channel");
    step.values.push_back(from_si(
        record.values[static_cast<std::size_t>(column.channel)][column.at], *column.unit, units));
  }
  return step;
}

SolWriter::SolWriter(GrowingFile file, SolHeader header, UnitSystem units)
    : file_(std::move(file)),
      header_(std::move(header)),
      units_(units),
      columns_(sol_columns(header_)) {}

SolWriter SolWriter::create(const WritePath& place, const SolHeader& header, UnitSystem units) {
  SolWriter writer(GrowingFile::create(place), header, units);
  writer.file_.append(format_sol_header(header));
  return writer;
}

SolWriter SolWriter::continue_after(const WritePath& place, const SolHeader& header,
                                    UnitSystem units, long last_step) {
  return {continue_sol_file(place, format_sol_header(header), last_step), header, units};
}

void SolWriter::check(const std::filesystem::path& path, const SolHeader& header) {
  check_sol_file(path, format_sol_header(header));
}

void SolWriter::write(const StepRecord& record) {
  text_.clear();
  append_sol_step(text_, make_sol_step(header_, columns_, record, units_));
  file_.append(text_);
}

}  // namespace adore::results

#include "results/table.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "results/channels.hpp"
#include "results/results_h5.hpp"
#include "results/sol_parser.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::results {
namespace {

std::string kind_name(SolKind kind) {
  switch (kind) {
    case SolKind::Element:
      return "plot file of a rolling element";
    case SolKind::Cage:
      return "plot file of a cage or cage segment";
    case SolKind::Race:
      return "plot file of a race";
    case SolKind::Power:
      return "plot file of power loss and life (SOL7)";
    case SolKind::Animation:
      return "animation file (SOL8)";
  }
  return {};
}

/// Columns of one SOL8 step (outputs.md 7.2).
void add_animation_columns(std::vector<TableColumn>& columns, const SolHeader& header) {
  const std::string &length = header.units[0], &angle = header.units[1], &force = header.units[2];
  const auto add = [&](std::string id, std::string label, const std::string& unit) {
    columns.push_back({std::move(id), std::move(label), unit});
  };
  const auto body = [&](const std::string& id, const std::string& label) {
    for (const char* axis : {"x", "y", "z"}) add(id + "." + axis, label + " " + axis, length);
    for (const char* name : {"eta", "xi", "lambda"})
      add(id + "." + name, label + " angle " + name, angle);
  };
  for (int j = 1; j <= header.elements; ++j) {
    const std::string id = fmt::format("element.{}.", j), label = fmt::format("element {} ", j);
    add(id + "axial", label + "axial position", length);
    add(id + "radial", label + "radial position", length);
    add(id + "orbital", label + "orbital position", angle);
    for (const char* name : {"eta", "xi", "lambda"}) add(id + name, label + "angle " + name, angle);
    for (const char* axis : {"x", "y", "z"})
      add(id + "pocket." + axis, label + "from pocket centre " + axis, length);
    add(id + "pocket_force", label + "pocket force", force);
    add(id + "pocket_angle", label + "pocket contact angle", angle);
  }
  body("cage", "cage");
  for (int land = 1; land <= 2; ++land) {
    add(fmt::format("land.{}.force", land), fmt::format("land {} force", land), force);
    add(fmt::format("land.{}.angle", land), fmt::format("land {} contact angle", land), angle);
  }
  body("outer", "outer race");
  body("inner", "inner race");
  for (int extra = 11 * header.elements + 23; extra <= header.value_count; ++extra)
    add(fmt::format("value{}", extra), fmt::format("value {}", extra), {});
}

struct SolSource {
  explicit SolSource(const std::filesystem::path& path) : stream(path) {}
  InputFile stream;
  std::unique_ptr<SolParser> parser;
};

}  // namespace

ResultTable sol_table(const std::filesystem::path& path) {
  auto source = std::make_shared<SolSource>(path);
  if (!source->stream)
    throw InputError(fmt::format("{}: the file cannot be opened; check its name and permissions",
                                 path.string()));
  source->parser = std::make_unique<SolParser>(source->stream, path.string());
  const SolHeader& header = source->parser->header();
  const SolKind kind = source->parser->kind();
  const bool animation = kind == SolKind::Animation;

  ResultTable table;
  table.header = {{"kind", kind_name(kind)}, {"program", header.version}, {"run", header.run_id}};
  if (!animation) {
    table.header.emplace_back("title", header.title);
    table.header.emplace_back("element", std::to_string(header.index));
  }
  table.header.emplace_back("rolling elements", std::to_string(header.elements));
  table.header.emplace_back("bearing type", std::to_string(header.bearing_type));
  table.header.emplace_back("values per step", std::to_string(header.value_count));
  if (animation) {
    constexpr const char* kNames[] = {
        "cage outer radius",       "cage inner radius",       "cage outer clearance",
        "cage inner clearance",    "pocket clearance I",      "pocket clearance II",
        "element radius",          "pitch diameter",          "outer race outer radius",
        "outer race inner radius", "inner race outer radius", "inner race inner radius"};
    for (std::size_t k = 0; k < std::size(kNames); ++k)
      table.header.emplace_back(
          kNames[k], fmt::format("{} {}", source->parser->geometry()[k], header.units[0]));
  } else {
    table.header.emplace_back("cage segments", std::to_string(header.segments));
  }

  table.columns = {{"step", "step number", ""}, {"revolutions", "bearing rotation", "rev"}};
  if (!animation) {
    table.columns.push_back({"element_revolutions", "angular position of the element", "rev"});
    table.columns.push_back({"step_size", "step size", "s"});
  }
  table.columns.push_back({"time", "time", "s"});
  if (animation) {
    add_animation_columns(table.columns, header);
  } else {
    SolFile names;
    names.kind = kind;
    names.header = header;
    for (const SolColumn& column : sol_columns(header))
      table.columns.push_back({column.id, column.label, unit_of_column(names, column)});
  }
  table.next = [source, animation](std::vector<double>& row) {
    SolStep step;
    if (source->parser->next(step) != BlockStatus::Complete) return false;
    row = {static_cast<double>(step.step), step.revolutions};
    if (!animation) row.insert(row.end(), {step.element_revolutions, step.step_size});
    row.push_back(step.time);
    row.insert(row.end(), step.values.begin(), step.values.end());
    return true;
  };
  table.note = [source] {
    const std::string note = source->parser->note(), gaps = source->parser->gaps();
    return note + (note.empty() || gaps.empty() ? "" : "; ") + gaps;
  };
  return table;
}

ResultTable results_h5_table(const std::filesystem::path& path) {
  const auto reader = std::make_shared<H5Reader>(path);
  ResultTable table;
  table.header = {{"kind", "all channels (RESULTS.h5)"},
                  {"program", reader->version()},
                  {"run", reader->run_id()},
                  {"stored steps", std::to_string(reader->steps())},
                  {"units", "SI and radians"}};
  for (const auto& [name, value] : reader->geometry())
    table.header.emplace_back("geometry " + name, fmt::format("{}", value));
  table.columns = {{"step", "step number", ""},
                   {"time", "time", "s"},
                   {"step_size", "step size", "s"},
                   {"shaft_rotation", "shaft rotation", "rad"}};
  for (const H5Reader::ChannelInfo& info : reader->channels()) {
    const std::string unit = info.unit == "-" ? std::string() : info.unit;
    for (std::size_t k = 0; k < info.size(); ++k) {
      std::string at;
      for (std::size_t d = info.dimensions.size(), rest = k; d-- > 0; rest /= info.dimensions[d])
        at.insert(0, fmt::format(".{}", rest % info.dimensions[d] + 1));
      std::string where = at.empty() ? at : " " + at.substr(1);
      table.columns.push_back({info.id + at, info.label + where, unit});
    }
  }
  // A block of rows at a time, so that a long run needs no more memory than a short one.
  struct Block {
    std::size_t first = 0, rows = 0, next = 0;
    std::vector<std::vector<double>> channels;
  };
  const auto block = std::make_shared<Block>();
  table.next = [reader, block](std::vector<double>& row) {
    constexpr std::size_t kRows = 256;
    if (block->next == block->rows) {
      block->first += block->rows;
      block->rows = std::min(kRows, reader->steps() - block->first);
      block->next = 0;
      if (block->rows == 0) return false;
      block->channels.clear();
      for (const char* name : {"step", "time", "step_size", "shaft_rotation"})
        block->channels.push_back(reader->read(name, block->first, block->rows));
      for (const H5Reader::ChannelInfo& info : reader->channels())
        block->channels.push_back(reader->read(info.id, block->first, block->rows));
    }
    row.clear();
    for (const std::vector<double>& values : block->channels) {
      const std::size_t width = values.size() / block->rows;
      row.insert(row.end(), values.begin() + static_cast<std::ptrdiff_t>(block->next * width),
                 values.begin() + static_cast<std::ptrdiff_t>((block->next + 1) * width));
    }
    ++block->next;
    return true;
  };
  table.note = [] { return std::string(); };
  return table;
}

}  // namespace adore::results

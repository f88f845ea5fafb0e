#include "cli/pictures/report_run.hpp"

#include "adrplot/finding_pages.hpp"
#include "adrplot/plot_document.hpp"
#include "agore/render.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "deck/deck.hpp"
#include "desktop/chart_scene.hpp"
#include "results/key_results.hpp"
#include "results/run_findings.hpp"
#include "results/run_folder.hpp"
#include "results/static_tables.hpp"
#include "runs/deck_story.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr int kChartWidth = 1280, kChartHeight = 800;
constexpr int kPrintedWidth = 640;  ///< of a picture on the page: 170 mm at 96 dots per inch

/// The pages that a report shows by default, by the start of their titles.
constexpr std::array<std::string_view, 6> kMainPages{
    "Race interactions 1", "Race interactions 2",   "Overall power loss",
    "Load around",         "Contact loads, angles", "Contact ellipses and groove"};

std::string paragraph(std::string_view text) { return "<p>" + escape_html(text) + "</p>\n"; }

std::string number(double value) {
  if (std::isnan(value)) return "not computed";
  if (std::isinf(value)) return "infinite";
  return fmt::format("{:.5g}", value);
}

/// A number, or the word that stands for one ("infinite").
std::string number_text(const Json& value) {
  if (value.is_number()) return number(value.get<double>());
  return value.is_string() ? escape_html(value.get<std::string>()) : "not computed";
}

std::string text_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return "";
  return found->is_string() ? found->get<std::string>() : number_text(*found);
}

/// A member that is an object; empty without it.
Json object_of(const Json& run, const char* name) {
  Json out = run.value(name, Json::object());
  if (out.is_null()) return Json::object();
  if (!out.is_object())
    throw InputError(fmt::format("RUN.json is damaged: member \"{}\" is not an object", name));
  return out;
}

std::string label_of(const results::KeyResultSpec& spec, const std::string& id, bool motion) {
  if (spec.id.empty()) return escape_html(id);
  std::string label(results::label_of(spec, motion));
  if (!spec.part.empty()) label += fmt::format(", {}", spec.part);
  return escape_html(label);
}

std::string unit_of(const results::KeyResultSpec& spec) {
  if (spec.id.empty()) return "";
  return spec.unit->si == std::string_view("-") ? "" : std::string(spec.unit->si);
}

void add_results(ReportRun& run, const Json& json) {
  const Json summary = object_of(json, "summary");
  const Json means = object_of(object_of(json, "accuracy"), "means");
  const bool motion = summary.contains("revolutions");
  std::vector<std::vector<std::string>> rows;
  for (const auto& [id, value] : summary.items()) {
    const results::KeyResultSpec spec = results::find_key_result(id);
    const std::string label = label_of(spec, id, motion), unit = unit_of(spec),
                      text = number_text(value);
    const auto error = means.find(id);
    rows.push_back({label, text, error == means.end() ? "" : "± " + number_text(*error), unit});
    run.values.push_back({id, unit.empty() ? label : label + " [" + unit + "]", text});
  }
  run.parts["results"] =
      html_table({"result", "value", means.empty() ? "" : "95 % interval of the mean", "unit"},
                 rows, {false, true, true, false});
}

void add_findings(ReportRun& run, const std::vector<Finding>& findings) {
  std::string text;
  std::vector<std::vector<std::string>> rows;
  for (const Finding& each : shown_findings(findings)) {
    const std::string_view severity = severity_word(each.severity);
    const std::string limit = each.limit   ? "at most " + number(*each.limit)
                              : each.least ? "at least " + number(*each.least)
                                           : "";
    rows.push_back({fmt::format("<span class=\"{0}\">{0}</span>", severity),
                    escape_html(each.message + (each.remedy.empty() ? "" : "; " + each.remedy)),
                    each.measured ? number(*each.measured) : "", limit, escape_html(each.unit)});
  }
  run.parts["findings"] = rows.empty()
                              ? paragraph("No warnings and no notes.")
                              : html_table({"severity", "finding", "value", "limit", "unit"}, rows,
                                           {false, false, true, true, false});
}

/// The deck of the folder describes the run only if it has not changed since.
void add_deck(ReportRun& run, const fs::path& folder, const Json& json) {
  const fs::path file = folder / fs::path(text_of(json, "deck")).filename();
  std::string& text = run.parts["deck"];
  std::error_code none;
  if (!is_plain_file(file)) {
    text = paragraph(fmt::format("The folder of the run does not contain the deck {}.",
                                 file.filename().string()));
    return;
  }
  if (fs::last_write_time(file, none) > fs::last_write_time(folder / "RUN.json", none)) {
    text = paragraph(fmt::format("{} was changed after the run and is not described here.",
                                 file.filename().string()));
    return;
  }
  const deck::ReadResult read = deck::read_deck(file);
  if (!read.ok()) {
    text = paragraph(fmt::format("{} has errors.", file.filename().string()));
    return;
  }
  for (const std::string& line : runs::deck_story(read.deck)) text += paragraph(line);
}

void add_effects(ReportRun& run, const Json& json) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& effect : object_of(json, "plan").value("effects", Json::array()))
    rows.push_back({escape_html(text_of(effect, "name")), effect.value("on", false) ? "on" : "off",
                    escape_html(text_of(effect, "because"))});
  run.parts["effects"] = rows.empty() ? paragraph("The file lists no effects.")
                                      : html_table({"effect", "", "reason"}, rows);
}

/// 0 for what rounding left of a zero: below 1e-12 of the largest value of the column.
double zero_rounding_noise(const results::StaticColumn& column, std::size_t row) {
  double largest = 0.0;
  for (const double value : column.values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const double value = column.values[row];
  return std::abs(value) < 1e-12 * largest ? 0.0 : value;
}

void add_elements(ReportRun& run, const fs::path& run_json, const Json& json) {
  std::string& text = run.parts["elements"];
  if (!json.contains("quasi_static")) {
    text = paragraph("The run has no quasi-static table.");
    return;
  }
  const results::StaticTables tables = results::read_static_tables(run_json);
  const results::StaticTable* elements = tables.find("elements");
  if (elements == nullptr || elements->columns.empty()) {
    text = paragraph("The run has no table of rolling elements.");
    return;
  }
  // Five columns fit on the paper.
  constexpr std::size_t kColumns = 5;
  for (std::size_t first = 0; first < elements->columns.size(); first += kColumns) {
    const std::size_t last = std::min(first + kColumns, elements->columns.size());
    std::vector<std::string> header{"element"};
    std::vector<std::vector<std::string>> rows(elements->columns.front().values.size());
    for (std::size_t e = 0; e < rows.size(); ++e) rows[e].push_back(std::to_string(e + 1));
    for (std::size_t c = first; c < last; ++c) {
      const results::StaticColumn& column = elements->columns[c];
      const std::string_view unit = results::unit_name(*column.unit, tables.units);
      header.push_back(
          escape_html(unit == "-" ? column.name : fmt::format("{} [{}]", column.name, unit)));
      for (std::size_t e = 0; e < rows.size() && e < column.values.size(); ++e)
        rows[e].push_back(
            number(results::from_si(zero_rounding_noise(column, e), *column.unit, tables.units)));
    }
    text += html_table(header, rows, std::vector<bool>(header.size(), true));
  }
}

void add_provenance(ReportRun& run, const Json& json) {
  std::vector<std::vector<std::string>> rows;
  const auto row = [&](const char* label, const std::string& value) {
    if (!value.empty()) rows.push_back({label, escape_html(value)});
  };
  row("program", text_of(json, "program"));
  row("compiler", text_of(object_of(json, "build"), "compiler"));
  row("instruction set", text_of(object_of(json, "arithmetic"), "instruction set of the contacts"));
  row("deck", text_of(json, "deck"));
  row("checksum of deck and options", text_of(json, "request"));
  row("integrator", text_of(json, "integrator"));
  row("tolerance", text_of(json, "tolerance"));
  const Json sums = object_of(object_of(json, "measured"), "checksums");
  for (const auto& [name, sum] : sums.items())
    row("checksum", fmt::format("{}: {}", name, text_of(sum, "checksum")));
  run.parts["provenance"] = html_table({"", ""}, rows);
  rows.clear();
  for (const Json& used : json.value("defaults_used", Json::array()))
    rows.push_back({escape_html(text_of(used, "record")), escape_html(text_of(used, "variable")),
                    escape_html(text_of(used, "value") + " " + text_of(used, "unit"))});
  if (!rows.empty())
    run.parts["provenance"] += paragraph("Variables for which the run uses default values:") +
                               html_table({"record", "variable", "default"}, rows);
}

/// Adds pictures to a part of the report.
class Pictures {
 public:
  Pictures(ReportRun& run, std::size_t number, std::vector<Finding> findings)
      : run_(run), number_(number), findings_(std::move(findings)) {
    scene_.setTheme(desktop::theme(desktop::ThemeKind::Light));
    scene_.setPageSize({kChartWidth, kChartHeight});
  }

  void charts(const fs::path& file, ReportCharts which) {
    const adrplot::PlotDocument document = adrplot::open_document(file);
    const bool element = document.subject.starts_with("rolling element");
    if (which == ReportCharts::Main && element && element_shown_) return;
    element_shown_ = element_shown_ || element;
    for (std::size_t n = 0; n < document.pages.size(); ++n) {
      const std::string& title = document.pages[n].title;
      if (which == ReportCharts::Main && !is_main(title, document.subject) &&
          !warned(title, document.subject))
        continue;
      scene_.setPage(document.build(static_cast<int>(n + 1), {}));
      add("charts", scene_.image({kChartWidth, kChartHeight}),
          fmt::format("{}, {}: {}", file.filename().string(), document.subject, title));
    }
  }

  void stills(const fs::path& file) {
    agore::MotionPicture picture = agore::open_animation(file);
    if (picture.frames() == 0) return;
    const std::size_t last = picture.frames() - 1;
    for (const auto view : {agore::View::Section, agore::View::Bearing, agore::View::Cage}) {
      agore::ViewOptions options;
      options.view = view;
      options.dark = false;
      options.contacts = view == agore::View::Bearing;
      if (!agore::why_not(view, picture.animation()).empty()) continue;
      add("stills", picture.image({kChartWidth, kChartHeight}, last, options),
          fmt::format("{}, {}, last frame", file.filename().string(), agore::view_title(view)));
    }
  }

 private:
  static bool is_main(std::string_view title, std::string_view subject) {
    if (title.starts_with("Mass center whirl orbit")) return subject.starts_with("cage");
    return std::ranges::any_of(kMainPages,
                               [&](std::string_view main) { return title.starts_with(main); });
  }
  [[nodiscard]] bool warned(const std::string& title, const std::string& subject) const {
    const auto concerns = adrplot::page_concerns(title, subject);
    return std::ranges::any_of(findings_, [&](const Finding& each) {
      return each.severity != Severity::Note && concerns && concerns(each);
    });
  }
  void add(const char* part, QImage image, const std::string& caption) {
    const std::string name = fmt::format("run-{}-picture-{}", number_, run_.pictures.size() + 1);
    run_.parts[part] += fmt::format(
        "<p><img src=\"{}\" width=\"{}\" alt=\"{}\"></p>\n<p class=\"caption\">{}</p>\n", name,
        kPrintedWidth, escape_html(caption), escape_html(caption));
    run_.pictures.push_back({name, std::move(image)});
  }

  ReportRun& run_;
  std::size_t number_;
  std::vector<Finding> findings_;
  desktop::ChartScene scene_;
  bool element_shown_ = false;
};

ReportRun report_of(const fs::path& folder, const Json& json, std::size_t number,
                    ReportCharts charts) {
  ReportRun run;
  const std::string id = text_of(json, "run");
  run.name = id.empty() ? fs::weakly_canonical(folder).filename().string() : id;
  run.parts["run"] = escape_html(run.name);
  std::string status =
      text_of(json, "status") == "done"
          ? "The run is complete."
          : fmt::format("The run is {}. {}", text_of(json, "status"), text_of(json, "message"));
  if (json.contains("steps") && json["steps"] != 0)
    status += fmt::format(" Span: {} s (revolutions: {}; stored steps: {}).",
                          number_text(json.value("time [s]", Json())),
                          number_text(json.value("revolutions", Json())), text_of(json, "steps"));
  run.parts["status"] = escape_html(status);
  const std::vector<Finding> findings = results::run_findings(folder);
  add_findings(run, findings);
  add_deck(run, folder, json);
  add_results(run, json);
  add_effects(run, json);
  add_elements(run, folder / "RUN.json", json);
  add_provenance(run, json);
  run.parts["charts"] = run.parts["stills"] = "";
  Pictures pictures(run, number, findings);
  const results::PlottableFiles files = results::run_folder(folder);
  for (const fs::path& plot : files.plots) pictures.charts(plot, charts);
  if (json.contains("quasi_static")) pictures.charts(folder / "RUN.json", charts);
  if (files.animation) pictures.stills(*files.animation);
  if (run.parts["charts"].empty())
    run.parts["charts"] = paragraph("The run has no file with charts.");
  if (run.parts["stills"].empty())
    run.parts["stills"] = paragraph("The run has no animation file.");
  return run;
}

}  // namespace

std::string escape_html(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()))
      .toHtmlEscaped()
      .toStdString();
}

std::string html_table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows,
                       const std::vector<bool>& numeric) {
  if (rows.empty()) return "";
  std::string text = "<table width=\"100%\">\n<tr>";
  for (const std::string& cell : header) text += "<th>" + cell + "</th>";
  text += "</tr>\n";
  for (const auto& row : rows) {
    text += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c)
      text +=
          (c < numeric.size() && numeric[c] ? "<td class=\"number\" align=\"right\">" : "<td>") +
          row[c] + "</td>";
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

ReportRun report_run(const fs::path& folder, std::size_t number, ReportCharts charts) {
  const fs::path file = folder / "RUN.json";
  if (!is_plain_file(file))
    throw InputError(fmt::format("{} has no RUN.json; give folders of runs", folder.string()));
  const Json json = parse_json<Json>(read_text_file(file), file.string());
  if (!json.is_object() || !text_of(json, "program").starts_with("Adore"))
    throw InputError(file.string() + " is damaged, or was not written by this program");
  try {
    return report_of(folder, json, number, charts);
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string() + " is damaged: a member has the wrong type");
  }
}

}  // namespace adore::cli

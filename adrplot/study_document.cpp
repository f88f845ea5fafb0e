#include "adrplot/study_document.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "desktop/study_chart.hpp"
#include "studies/study_table_read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace adore::adrplot {

namespace fs = std::filesystem;

namespace {

std::string stem_of(const fs::path& folder) {
  return fs::absolute(folder).lexically_normal().filename().stem().string();
}

}  // namespace

bool is_study(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error))
    return is_plain_file(path / "CHARTS.json") || is_plain_file(path / "tasks.jsonl");
  return path.filename() == "CHARTS.json" || studies::is_study_table(path);
}

PlotDocument open_study(const fs::path& path) {
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  fs::path folder = is_folder ? path : path.parent_path();
  if (folder.filename().empty() && folder.has_parent_path() && is_folder)
    folder = folder.parent_path();  // "clearance.study/"
  const fs::path charts_file = folder / "CHARTS.json";
  const bool reported = is_plain_file(charts_file);
  std::vector<desktop::StudyChart> charts;
  auto table = std::make_shared<std::optional<studies::StudyTable>>();
  if (reported) {
    charts = desktop::read_study_charts(charts_file);
  } else if (!is_folder) {
    *table = studies::read_study_table(path);
    charts = desktop::parse_study_charts(studies::charts_of_table(**table), path.string());
  } else {
    throw InputError(
        fmt::format("{}: this study has no report yet; write it with `adore study report {}.json`",
                    folder.string(), (folder.parent_path() / stem_of(folder)).string()));
  }
  std::erase_if(charts, [](const desktop::StudyChart& chart) { return !chart.has_content(); });
  if (charts.empty())
    throw InputError(
        fmt::format("{}: the study has no charts, because no run has values yet", path.string()));
  PlotDocument out;
  out.path = is_folder ? charts_file : path;
  out.subject = reported ? "study " + stem_of(folder) : "table of a study";
  for (const desktop::StudyChart& chart : charts)
    out.pages.push_back({chart.title(), PageKind::Chart});
  std::vector<std::shared_ptr<const desktop::StudyChart>> shared;
  for (desktop::StudyChart& chart : charts)
    shared.push_back(std::make_shared<const desktop::StudyChart>(std::move(chart)));
  out.build = [path, shared](int number, const PageOptions&) {
    check_page_number(path, number, shared.size());
    desktop::ChartPage page;
    page.study = shared[static_cast<std::size_t>(number - 1)];
    page.title = page.study->title();
    return page;
  };
  const bool whole = is_plain_file(folder / "tasks.jsonl");
  out.about_run = [folder, table, path, whole](long run) {
    if (whole) return studies::run_text(folder, run);
    if (!*table) {
      const fs::path csv = folder / "RUNS.csv";
      *table = studies::read_study_table(is_plain_file(csv) ? csv : path);
    }
    return studies::run_text(**table, run);
  };
  out.files_of_run = [folder, whole](long run) {
    return whole ? studies::run_files_folder(folder, run) : fs::path();
  };
  return out;
}

}  // namespace adore::adrplot

#include "adrplot/accuracy_page.hpp"

#include "adrplot/plot_document.hpp"
#include "base/duration.hpp"
#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "results/growing_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace adore::adrplot {
namespace {

struct Point {
  double seconds, error;
  std::string curve;
};

std::vector<Point> points_of(const nlohmann::json& rows) {
  std::vector<Point> out;
  if (!rows.is_array()) return out;
  const auto number = [](const nlohmann::json& row, const char* key) {
    const auto found = row.find(key);
    return found != row.end() && found->is_number() ? found->get<double>() : 0.0;
  };
  for (const nlohmann::json& row : rows) {
    if (!row.is_object() || row.contains("failure")) continue;
    const double seconds = number(row, "seconds"), error = number(row, "error");
    const auto curve = row.find("curve");
    // A logarithmic axis has no place for others.
    if (seconds > 0.0 && error > 0.0 && curve != row.end() && curve->is_string())
      out.push_back({seconds, error, curve->get<std::string>()});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Point& a, const Point& b) { return a.seconds < b.seconds; });
  return out;
}

/// "1e-04, 1e-06": of the runs that have a point.
std::string tolerances_of(const nlohmann::json& rows) {
  std::set<double, std::greater<>> all;
  if (rows.is_array())
    for (const nlohmann::json& row : rows)
      if (row.is_object() && !row.contains("failure"))
        if (const auto tol = row.find("tol"); tol != row.end() && tol->is_number())
          all.insert(tol->get<double>());
  std::string out;
  for (const double tolerance : all)
    out += (out.empty() ? "" : ", ") + fmt::format("{:g}", tolerance);
  return out;
}

desktop::ChartPage page_of(const nlohmann::json& rows, const std::string& title,
                           const std::string& error_title) {
  const std::vector<Point> points = points_of(rows);
  desktop::ChartPage page;
  page.title = title;
  page.note = "A point for each run that came to its end; low and left is good.";
  if (const std::string tolerances = tolerances_of(rows); !tolerances.empty())
    page.note += fmt::format(
        " A method's points are its tolerances ({}), mostly from left to right; which is which "
        "the table of the study says.",
        tolerances);
  page.x_title = "Computing time";
  page.x_unit = "s";
  page.log_x = page.points = true;
  desktop::ChartPanel panel{error_title, "%", {}};
  panel.log = true;
  for (const Point& point : points) page.x.push_back(point.seconds);
  if (!points.empty()) {  // no point on the frame
    page.view_low = 0.7 * points.front().seconds;
    page.view_high = 1.4 * points.back().seconds;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto curve = std::find_if(panel.curves.begin(), panel.curves.end(),
                              [&](const auto& c) { return c.name == points[i].curve; });
    if (curve == panel.curves.end()) {
      desktop::ChartCurve fresh;
      fresh.name = points[i].curve;
      fresh.y.assign(points.size(), std::nan(""));
      curve = panel.curves.insert(curve, std::move(fresh));
    }
    curve->y[i] = 100.0 * points[i].error;
  }
  if (points.empty()) panel.message = "No run of the study came to its end with an error above 0.";
  page.panels.push_back(std::move(panel));
  return page;
}

}  // namespace

bool is_accuracy(const std::filesystem::path& path) {
  return path.filename().string().starts_with("ACCURACY") && path.extension() == ".json";
}

std::vector<desktop::ChartPage> accuracy_pages(const std::filesystem::path& path) {
  const auto study = parse_json(results::read_text_file(path), path.string());
  if (!study.is_object() || !study.contains("screening"))
    throw InputError(fmt::format(
        "{} is no table of `adore accuracy`; give the ACCURACY.json that it wrote", path.string()));
  const auto text = [&](const char* key, const char* otherwise) {
    const auto found = study.find(key);
    return found != study.end() && found->is_string() ? found->get<std::string>()
                                                      : std::string(otherwise);
  };
  const std::string title = text("title", "What accuracy costs"),
                    error = text("error_title", "Error");
  std::vector<desktop::ChartPage> out;
  const auto finals = study.find("finals");
  if (finals != study.end() && finals->is_array() && !finals->empty())
    out.push_back(page_of(*finals, title, error));
  // The title of the study is that of its last round.
  const auto turns = study.find("short_turns");
  const std::string first =
      turns != study.end() && turns->is_number()
          ? fmt::format("First round, {}: what accuracy costs", turns_text(turns->get<double>()))
          : "First round: what accuracy costs";
  out.push_back(page_of(study["screening"], out.empty() ? title : first, error));
  for (desktop::ChartPage& page : out) page.subtitle = run_folder(path).filename().string();
  return out;
}

}  // namespace adore::adrplot

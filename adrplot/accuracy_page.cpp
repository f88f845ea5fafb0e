#include "adrplot/accuracy_page.hpp"

#include "adrplot/plot_document.hpp"
#include "base/counted.hpp"
#include "base/duration.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

namespace adore::adrplot {
namespace {

struct Point {
  double seconds, error;
  std::string curve, name;
  bool own = false;
  bool stands_out = false;  ///< of the noise of some quantity, though below the largest one
};

double number(const nlohmann::json& of, const char* key) {
  if (!of.is_object()) return 0.0;
  const auto found = of.find(key);
  return found != of.end() && found->is_number() ? found->get<double>() : 0.0;
}

std::string word(const nlohmann::json& of, const char* key) {
  if (!of.is_object()) return {};
  const auto found = of.find(key);
  return found != of.end() && found->is_string() ? found->get<std::string>() : std::string();
}

nlohmann::json part(const nlohmann::json& of, const char* key) {
  return of.is_object() && of.contains(key) ? of[key] : nlohmann::json();
}

/// Errors up to which chance is as good a reason as the settings, by quantity: as the study itself
/// judges them.
class Chance {
 public:
  explicit Chance(double times) : times_(times) {}
  /// From runs whose loads differ by 1e-6, or from two accurate methods: the larger values.
  void add(const nlohmann::json& noise) {
    for (std::size_t q = 0; q < limits_.size(); ++q)
      limits_[q] = std::max(limits_[q], times_ * number(noise, kQuantities[q]));
  }
  [[nodiscard]] double largest() const { return *std::max_element(limits_.begin(), limits_.end()); }
  [[nodiscard]] double times() const { return times_; }  ///< part of the statistical scatter
  [[nodiscard]] bool left_behind(const nlohmann::json& errors) const {
    for (std::size_t q = 0; q < limits_.size(); ++q)
      if (number(errors, kQuantities[q]) > limits_[q]) return true;
    return false;
  }

 private:
  static constexpr std::array<const char*, 6> kQuantities{"speed", "whirl", "load",
                                                          "peak",  "heat",  "life"};
  double times_;
  std::array<double, 6> limits_{};
};

std::vector<Point> points_of(const nlohmann::json& rows, const Chance& chance) {
  std::vector<Point> out;
  if (!rows.is_array()) return out;
  for (const nlohmann::json& row : rows) {
    if (!row.is_object() || row.contains("failure")) continue;
    Point point{number(row, "seconds"),
                number(row, "error"),
                word(row, "curve"),
                word(row, "name"),
                false,
                false};
    const auto own = row.find("own"), errors = row.find("errors");
    point.own = own != row.end() && own->is_boolean() && own->get<bool>();
    point.stands_out =
        errors != row.end() && point.error <= chance.largest() && chance.left_behind(*errors);
    // A logarithmic axis cannot show others.
    if (point.seconds > 0.0 && point.error > 0.0 && !point.curve.empty())
      out.push_back(std::move(point));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Point& a, const Point& b) { return a.seconds < b.seconds; });
  return out;
}

/// Shaded band below the noise level, with a note.
void add_floor(desktop::ChartPage& page, const std::vector<Point>& points, const Chance& chance) {
  if (!(chance.largest() > 0.0) || points.empty()) return;
  const double floor = 100.0 * chance.largest();
  desktop::ChartCurve curve;
  curve.name = fmt::format("{:g} × statistical scatter", chance.times());
  curve.y.assign(page.x.size(), floor);
  curve.low.assign(page.x.size(), 0.0);
  curve.high = curve.y;
  curve.dashed = true;
  page.panels.front().curves.push_back(std::move(curve));
  page.note += fmt::format(
      " Errors below {} % (shaded) cannot be distinguished: they are within {:g} times the "
      "statistical scatter.",
      desktop::pretty_number(floor, 2), chance.times());
  const auto others = std::count_if(points.begin(), points.end(),
                                    [](const Point& point) { return point.stands_out; });
  if (others > 0)
    page.note +=
        fmt::format(" {} in the shaded area: the error of one quantity is larger than its scatter.",
                    counted(others, "point"));
}

/// Which of the points a reader looks for.
void add_marks(desktop::ChartPage& page, const std::vector<Point>& points,
               const std::string& recommended) {
  for (const Point& point : points) {
    const bool best = !recommended.empty() && point.name == recommended;
    if (best || point.own)
      page.marks.push_back({point.seconds, best && point.own ? "this deck (recommended)"
                                           : best            ? "recommended"
                                                             : "this deck"});
  }
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
                           const std::string& error_title, const Chance& chance,
                           const std::string& recommended) {
  const std::vector<Point> points = points_of(rows, chance);
  desktop::ChartPage page;
  page.title = title;
  page.note = "Each point is a completed run. The best runs are at the bottom left.";
  if (const std::string tolerances = tolerances_of(rows); !tolerances.empty())
    page.note += fmt::format(
        " Each point of a method has one tolerance ({}), usually in this order from left to right "
        "(see the study table).",
        tolerances);
  page.x_title = "Computing time";
  page.x_unit = "s";
  page.log_x = page.points = true;
  desktop::ChartPanel panel{error_title, "%", {}};
  panel.log = true;
  // No point on the frame: the abscissa reaches beyond the first and the last of them.
  constexpr double kBeyond = 1.3;
  if (!points.empty()) page.x.push_back(points.front().seconds / kBeyond);
  for (const Point& point : points) page.x.push_back(point.seconds);
  if (!points.empty()) page.x.push_back(points.back().seconds * kBeyond);
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto curve = std::find_if(panel.curves.begin(), panel.curves.end(),
                              [&](const auto& c) { return c.name == points[i].curve; });
    if (curve == panel.curves.end()) {
      desktop::ChartCurve fresh;
      fresh.name = points[i].curve;
      fresh.y.assign(page.x.size(), std::nan(""));
      curve = panel.curves.insert(curve, std::move(fresh));
    }
    curve->y[i + 1] = 100.0 * points[i].error;
  }
  if (points.empty())
    panel.message = "Nothing to draw: no completed run has an error above 0 (logarithmic axis).";
  page.panels.push_back(std::move(panel));
  add_floor(page, points, chance);
  add_marks(page, points, recommended);
  return page;
}

}  // namespace

bool is_accuracy_file(const std::filesystem::path& path) {
  return path.filename().string().starts_with("ACCURACY") && path.extension() == ".json";
}

std::vector<desktop::ChartPage> accuracy_pages(const std::filesystem::path& path) {
  const auto study = parse_json(read_text_file(path), path.string());
  if (!study.is_object() || !study.contains("screening"))
    throw InputError(fmt::format(
        "{} is not a result of `adore accuracy`; select the ACCURACY.json of an accuracy study",
        path.string()));
  const auto text = [&](const char* key, const char* otherwise) {
    const std::string found = word(study, key);
    return found.empty() ? std::string(otherwise) : found;
  };
  constexpr double kBeyondNoise = 1.5;  // for studies without this value
  const double said = number(study, "beyond_noise"), times = said > 0.0 ? said : kBeyondNoise;
  Chance brief(times), whole(times);
  brief.add(part(part(study, "short_reference"), "noise"));
  whole.add(part(part(study, "long_reference"), "noise"));
  whole.add(part(study, "irregular"));
  const nlohmann::json finals = part(study, "finals");
  const double best = study.contains("recommended") ? number(study, "recommended") : -1.0;
  const std::string recommended =
      finals.is_array() && best >= 0.0 && best < static_cast<double>(finals.size())
          ? word(finals[static_cast<std::size_t>(best)], "name")
          : std::string();
  const std::string title = text("title", "Error against computing time"),
                    error = text("error_title", "Error");
  std::vector<desktop::ChartPage> out;
  if (finals.is_array() && !finals.empty())
    out.push_back(page_of(finals, title, error, whole, recommended));
  // The title of the study is that of its last round.
  const auto turns = study.find("short_turns");
  const std::string first = turns != study.end() && turns->is_number()
                                ? fmt::format("First round, {}: error against time",
                                              revolutions_text(turns->get<double>()))
                                : "First round: error against time";
  out.push_back(
      page_of(study["screening"], out.empty() ? title : first, error, brief, recommended));
  for (desktop::ChartPage& page : out) page.subtitle = run_folder(path).filename().string();
  return out;
}

}  // namespace adore::adrplot

#include "desktop/study_chart.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/image_export.hpp"
#include "desktop/theme.hpp"

#include <QImage>
#include <QPainter>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// Content of a picture of a study, and its file. Drawing: study_paint.cpp.
namespace adore::desktop {
namespace {

using Json = nlohmann::json;

std::vector<double> numbers(const Json& json) {
  std::vector<double> out;
  for (const Json& value : json) {
    if (!value.is_number() && !value.is_null())
      throw InputError(dump_json(value).substr(0, 80) + " is not a number");
    out.push_back(value.is_number() ? value.get<double>()
                                    : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

/// Charts of an earlier release contain no runs.
template <class Value>
Value runs_of(const Json& json) {
  const auto found = json.find("runs");
  return found == json.end() ? Value() : found->get<Value>();
}

StudyChart chart_of(const Json& json) {
  const std::string kind = json.at("kind").get<std::string>();
  const auto text = [&](const char* key) { return json.value(key, std::string()); };
  StudyChart out;
  out.name = json.at("name").get<std::string>();
  if (kind == "curves") {
    BandCurves curves{text("title"),  text("x_title"), text("y_title"),
                      text("x_unit"), text("y_unit"),  {}};
    for (const Json& curve : json.at("curves")) {
      curves.curves.push_back({curve.at("name").get<std::string>(), numbers(curve.at("x")),
                               numbers(curve.at("y")), numbers(curve.at("low")),
                               numbers(curve.at("high")), runs_of<std::vector<Runs>>(curve)});
      const auto& last = curves.curves.back();
      const auto fits = [&](std::size_t n) { return n == 0 || n == last.x.size(); };
      if (last.y.size() != last.x.size() || !fits(last.low.size()) || !fits(last.high.size()) ||
          !fits(last.runs.size()))
        throw InputError("the columns of a curve have different lengths");
    }
    out.of = std::move(curves);
  } else if (kind == "heat-map") {
    HeatMap map;
    map.title = text("title");
    map.x_title = text("x_title");
    map.y_title = text("y_title");
    map.legend = text("legend");
    map.unit = text("unit");
    map.x = numbers(json.at("x"));
    map.y = numbers(json.at("y"));
    for (const Json& row : json.at("values")) map.values.push_back(numbers(row));
    map.marks = json.at("marks").get<std::vector<std::vector<std::string>>>();
    map.runs = runs_of<std::vector<std::vector<Runs>>>(json);
    const auto fits = [&](const auto& rows) {
      return rows.size() == map.y.size() &&
             std::all_of(rows.begin(), rows.end(),
                         [&](const auto& row) { return row.size() == map.x.size(); });
    };
    if (!fits(map.values) || (!map.marks.empty() && !fits(map.marks)) ||
        (!map.runs.empty() && !fits(map.runs)))
      throw InputError("the rows of a map have different lengths");
    out.of = std::move(map);
  } else if (kind == "parallel") {
    ParallelLines lines;
    lines.title = text("title");
    lines.heavy = json.at("heavy").get<int>();
    lines.axes = json.at("axes").get<std::vector<std::string>>();
    for (const Json& column : json.at("columns")) {
      const std::vector<double> values = numbers(column);
      lines.rows.resize(std::max(values.size(), lines.rows.size()));
      for (std::size_t i = 0; i < values.size(); ++i) lines.rows[i].push_back(values[i]);
    }
    lines.runs = runs_of<Runs>(json);
    for (const auto& row : lines.rows)
      if (row.size() != lines.axes.size()) throw InputError("the columns have different lengths");
    if (!lines.runs.empty() && lines.runs.size() != lines.rows.size())
      throw InputError("the number of runs differs from the number of rows");
    if (lines.heavy >= static_cast<int>(lines.rows.size())) lines.heavy = -1;
    out.of = std::move(lines);
  } else if (kind != "tornado") {
    throw InputError(
        fmt::format("the chart type \"{}\" is unknown; open the file with a newer program", kind));
  } else {
    Tornado tornado{text("title"), text("x_title"), {}};
    for (const Json& bar : json.at("bars"))
      tornado.bars.push_back({bar.at("name").get<std::string>(), bar.at("value").get<double>(),
                              bar.at("doubt").get<double>()});
    out.of = std::move(tornado);
  }
  return out;
}

bool any(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), is_drawable);
}

bool has_something(const BandCurves& data) {
  return std::any_of(data.curves.begin(), data.curves.end(),
                     [](const auto& curve) { return any(curve.y) && any(curve.x); });
}
bool has_something(const HeatMap& map) {
  return !map.x.empty() && std::any_of(map.values.begin(), map.values.end(), any);
}
bool has_something(const ParallelLines& lines) {
  return lines.axes.size() > 1 && !lines.rows.empty();
}
bool has_something(const Tornado& tornado) {
  return std::any_of(tornado.bars.begin(), tornado.bars.end(),
                     [](const Tornado::Bar& bar) { return is_drawable(bar.value); });
}

std::string csv_field(const std::string& text) {
  return text.find_first_of(",\"\n") == std::string::npos ? text : dump_json(Json(text));
}
std::string csv_field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string csv(const BandCurves& data) {
  std::string out =
      fmt::format("curve,{},{},low,high\n", csv_field(data.x_title), csv_field(data.y_title));
  for (const auto& curve : data.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      out += fmt::format("{},{},{},{},{}\n", csv_field(curve.name), csv_field(curve.x[i]),
                         csv_field(curve.y[i]), curve.low.empty() ? "" : csv_field(curve.low[i]),
                         curve.high.empty() ? "" : csv_field(curve.high[i]));
  return out;
}
std::string csv(const HeatMap& map) {
  std::string out = fmt::format("{},{},{},mark\n", csv_field(map.x_title), csv_field(map.y_title),
                                csv_field(map.legend));
  for (std::size_t j = 0; j < map.y.size(); ++j)
    for (std::size_t i = 0; i < map.x.size(); ++i)
      out += fmt::format("{},{},{},{}\n", csv_field(map.x[i]), csv_field(map.y[j]),
                         csv_field(map.values[j][i]),
                         map.marks.empty() ? "" : csv_field(map.marks[j][i]));
  return out;
}
std::string csv(const ParallelLines& lines) {
  std::string out = "run";
  for (const std::string& axis : lines.axes) out += "," + csv_field(axis);
  out += "\n";
  for (std::size_t i = 0; i < lines.rows.size(); ++i) {
    out += std::to_string(lines.runs.empty() ? static_cast<long>(i + 1) : lines.runs[i]);
    for (const double value : lines.rows[i]) out += "," + csv_field(value);
    out += "\n";
  }
  return out;
}
std::string csv(const Tornado& tornado) {
  std::string out = fmt::format("name,{},doubt\n", csv_field(tornado.x_title));
  for (const auto& bar : tornado.bars)
    out +=
        fmt::format("{},{},{}\n", csv_field(bar.name), csv_field(bar.value), csv_field(bar.doubt));
  return out;
}

}  // namespace

const std::string& StudyChart::title() const {
  return std::visit([](const auto& chart) -> const std::string& { return chart.title; }, of);
}

bool StudyChart::has_content() const {
  return std::visit([](const auto& chart) { return has_something(chart); }, of);
}

std::vector<StudyChart> read_study_charts(const std::filesystem::path& file) {
  constexpr std::size_t kLargest = std::size_t{2} << 30;
  return parse_study_charts(read_text_file(file, kLargest), file.string());
}

std::vector<StudyChart> parse_study_charts(const std::string& text, const std::string& name) {
  const Json list = parse_json(text, name);
  std::vector<StudyChart> out;
  try {
    if (!list.is_array()) throw InputError("not a list");
    for (const Json& chart : list) out.push_back(chart_of(chart));
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{} contains no charts of `adore study`", name));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} contains no charts of `adore study`: {}", name, error.what()));
  }
  return out;
}

bool save_picture(const StudyChart& chart, const WritePath& file) {
  if (!chart.has_content()) return false;
  const QSize size(1280, 800);
  QImage image(size, QImage::Format_RGB32);
  QPainter painter(&image);
  painter.fillRect(QRect(QPoint(), size), theme(ThemeKind::Light).surface);
  paint_study(chart, painter, size, theme(ThemeKind::Light));
  painter.end();
  save_image(image, file);
  return true;
}

std::string study_chart_csv(const StudyChart& chart) {
  return std::visit([](const auto& of) { return csv(of); }, chart.of);
}

}  // namespace adore::desktop

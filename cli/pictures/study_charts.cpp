#include "cli/pictures/study_charts.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/study_chart.hpp"
#include "results/growing_file.hpp"

#include <fmt/format.h>

#include <limits>

namespace adore::cli {
namespace {

using Json = nlohmann::json;

std::vector<double> numbers(const Json& json) {
  std::vector<double> out;
  for (const Json& value : json)
    out.push_back(value.is_number() ? value.get<double>()
                                    : std::numeric_limits<double>::quiet_NaN());
  return out;
}

bool draw(const Json& chart, const std::filesystem::path& file) {
  const std::string kind = chart.at("kind").get<std::string>();
  const auto text = [&](const char* key) { return chart.value(key, std::string()); };
  if (kind == "curves") {
    desktop::BandCurves out;
    out.title = text("title");
    out.x_title = text("x_title");
    out.y_title = text("y_title");
    out.x_unit = text("x_unit");
    out.y_unit = text("y_unit");
    for (const Json& curve : chart.at("curves"))
      out.curves.push_back({curve.at("name").get<std::string>(), numbers(curve.at("x")),
                            numbers(curve.at("y")), numbers(curve.at("low")),
                            numbers(curve.at("high"))});
    return save_picture(out, file);
  }
  if (kind == "heat-map") {
    desktop::HeatMap out;
    out.title = text("title");
    out.x_title = text("x_title");
    out.y_title = text("y_title");
    out.legend = text("legend");
    out.unit = text("unit");
    out.x = numbers(chart.at("x"));
    out.y = numbers(chart.at("y"));
    for (const Json& row : chart.at("values")) out.values.push_back(numbers(row));
    out.marks = chart.at("marks").get<std::vector<std::vector<std::string>>>();
    return save_picture(out, file);
  }
  if (kind == "parallel") {
    desktop::ParallelLines out;
    out.title = text("title");
    out.heavy = chart.at("heavy").get<int>();
    out.axes = chart.at("axes").get<std::vector<std::string>>();
    for (const Json& column : chart.at("columns")) {
      const std::vector<double> values = numbers(column);
      out.rows.resize(values.size());
      for (std::size_t i = 0; i < values.size(); ++i) out.rows[i].push_back(values[i]);
    }
    return save_picture(out, file);
  }
  desktop::Tornado out;
  out.title = text("title");
  out.x_title = text("x_title");
  for (const Json& bar : chart.at("bars"))
    out.bars.push_back({bar.at("name").get<std::string>(), bar.at("value").get<double>(),
                        bar.at("doubt").get<double>()});
  return save_picture(out, file);
}

}  // namespace

void draw_study(const std::filesystem::path& charts, const std::filesystem::path& folder,
                bool quiet) {
  const Json list = parse_json(results::read_text_file(charts), charts.string());
  desktop::ensure_headless_application();
  try {
    for (const Json& chart : list) {
      const std::filesystem::path file = folder / (chart.at("name").get<std::string>() + ".png");
      if (draw(chart, file) && !quiet) fmt::print("{}\n", file.string());
    }
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{} holds no charts of `adore study`", charts.string()));
  }
}

}  // namespace adore::cli

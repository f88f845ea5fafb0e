#include "adrplot/session.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/write_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace adore::adrplot {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int kVersion = 1;
constexpr auto kKey = "adrplot_session";

/// Names of the values of an enumeration, in its order.
constexpr std::array kAbscissae{"revolutions", "time", "step"};
constexpr std::array kWindows{"none", "hann", "flat top"};
constexpr std::array kScaleNames{"units", "db", "relative", "automatic"};

template <class Enum, std::size_t n>
void read_choice(const Json& json, const char* key, const std::array<const char*, n>& names,
                 Enum& out) {
  const std::string text = json.value(key, std::string());
  for (std::size_t i = 0; i < n; ++i)
    if (text == names.at(i)) out = static_cast<Enum>(i);
}

fs::path portable(const fs::path& file, const fs::path& folder) {
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path relative = whole.lexically_relative(folder);
  return relative.empty() ? whole : relative;
}

Json json_of(const SessionCurve& curve) {
  Json out{{"file", curve.file},
           {"page", curve.page},
           {"panel", curve.panel},
           {"curve", curve.curve},
           {"group", curve.group}};
  if (!curve.name.empty()) out["name"] = curve.name;
  return out;
}

SessionCurve curve_of(const Json& json) {
  return {json.at("file").get<int>(),
          json.at("page").get<int>(),
          json.at("panel").get<std::size_t>(),
          json.value("curve", std::string()),
          json.value("group", -1),
          json.value("name", std::string())};
}

Json json_of(const Session& session, const fs::path& folder) {
  Json out{{kKey, kVersion}};
  out["files"] = Json::array();
  for (const SessionFile& file : session.files) {
    Json one{{"path", portable(file.path, folder).generic_string()}};
    const results::SolRange all;
    if (file.range.from != all.from) one["from"] = file.range.from;
    if (file.range.to != all.to) one["to"] = file.range.to;
    if (file.range.every != all.every) one["every"] = file.range.every;
    out["files"].push_back(one);
  }
  out["formulas"] = Json::array();
  for (const SessionFormula& formula : session.formulas) {
    Json one{{"title", formula.title}, {"formula", formula.formula}, {"unit", formula.unit}};
    one["channels"] = Json::array();
    for (const SessionCurve& input : formula.inputs) one["channels"].push_back(json_of(input));
    out["formulas"].push_back(one);
  }
  out["charts"] = Json::array();
  for (const SessionChart& chart : session.charts) {
    Json one{{"difference", chart.how == Combine::Difference}};
    one["curves"] = Json::array();
    for (const SessionCurve& curve : chart.curves) one["curves"].push_back(json_of(curve));
    out["charts"].push_back(one);
  }
  const PageOptions& view = session.view;
  Json& shown = out["view"];
  shown = {
      {"document", session.document},
      {"page", session.page},
      {"abscissa", kAbscissae.at(static_cast<std::size_t>(view.abscissa))},
      {"domain", kDomainNames.at(static_cast<std::size_t>(view.domain))},
      {"orbit", {view.orbit.across, view.orbit.up}},
      {"window", kWindows.at(static_cast<std::size_t>(view.spectrum.window))},
      {"scale", kScaleNames.at(static_cast<std::size_t>(view.spectrum.scale))},
      {"over_speed", view.spectrum.over_speed},
      {"orders_of", kOrderReferenceNames.at(static_cast<std::size_t>(view.spectrum.orders_of))},
      {"band", {view.spectrum.band.low, view.spectrum.band.high}},
      {"spectrogram_of", view.spectrogram_of}};
  if (session.log_x) shown["log_x"] = *session.log_x;
  if (session.log_y) shown["log_y"] = *session.log_y;
  return out;
}

void read_view(const Json& view, Session& out) {
  out.document = view.value("document", 0);
  out.page = view.value("page", 1);
  read_choice(view, "abscissa", kAbscissae, out.view.abscissa);
  read_choice(view, "domain", kDomainNames, out.view.domain);
  read_choice(view, "window", kWindows, out.view.spectrum.window);
  read_choice(view, "scale", kScaleNames, out.view.spectrum.scale);
  out.view.spectrum.over_speed = view.value("over_speed", false);
  read_choice(view, "orders_of", kOrderReferenceNames, out.view.spectrum.orders_of);
  if (const Json band = view.value("band", Json::array()); band.size() == 2) {
    const PassBand read{band[0].get<double>(), band[1].get<double>()};
    if (read.low >= 0.0 && read.high > read.low) out.view.spectrum.band = read;
  }
  out.view.spectrogram_of = view.value("spectrogram_of", std::string());
  if (view.contains("log_x")) out.log_x = view.at("log_x").get<bool>();
  if (view.contains("log_y")) out.log_y = view.at("log_y").get<bool>();
  const Json orbit = view.value("orbit", Json::array());
  if (orbit.size() != 2) return;
  const int across = orbit[0].get<int>(), up = orbit[1].get<int>();
  if (across >= 0 && across < up && up < 3) out.view.orbit = {across, up};
}

}  // namespace

bool is_session(const fs::path& path) { return path.extension() == ".adrplot"; }

void save_session(const Session& session, const fs::path& path) {
  const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
  write_file_atomically(path, dump_json(json_of(session, folder), 1) + "\n");
}

Session read_session(const fs::path& path) {
  const Json json = parse_json<Json>(read_text_file(path), path.string());
  if (!json.is_object() || !json.contains(kKey))
    throw InputError(path.string() + " is not a session of AdrPlot");
  try {
    if (const int version = json.at(kKey).get<int>(); version > kVersion)
      throw InputError(fmt::format(
          "{} was written by a newer version of AdrPlot (format {}, this version reads {}). Open "
          "it with that version; the file is unchanged",
          path.string(), version, kVersion));
    Session out;
    const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
    for (const Json& file : json.value("files", Json::array())) {
      SessionFile one{folder / file.at("path").get<std::string>()};
      one.path = one.path.lexically_normal();
      one.range.from = file.value("from", one.range.from);
      one.range.to = file.value("to", one.range.to);
      one.range.every = file.value("every", one.range.every);
      out.files.push_back(std::move(one));
    }
    for (const Json& formula : json.value("formulas", Json::array())) {
      SessionFormula one{formula.at("title").get<std::string>(),
                         formula.at("formula").get<std::string>(),
                         formula.value("unit", std::string()),
                         {}};
      for (const Json& input : formula.value("channels", Json::array()))
        one.inputs.push_back(curve_of(input));
      out.formulas.push_back(std::move(one));
    }
    for (const Json& chart : json.value("charts", Json::array())) {
      SessionChart one{chart.value("difference", false) ? Combine::Difference : Combine::Overlay,
                       {}};
      for (const Json& curve : chart.value("curves", Json::array()))
        one.curves.push_back(curve_of(curve));
      out.charts.push_back(std::move(one));
    }
    if (json.contains("view")) read_view(json.at("view"), out);
    return out;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: the session is damaged ({})", path.string(), error.what()));
  }
}

}  // namespace adore::adrplot

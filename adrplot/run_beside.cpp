#include "adrplot/run_beside.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "results/channels.hpp"
#include "results/full_precision.hpp"
#include "results/growing_file.hpp"
#include "results/results_h5.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::adrplot {
namespace {

using results::H5Reader;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Rate of a continuous angle over the whole run [Hz].
double turns_per_second(double first, double last, double seconds) {
  return seconds > 0.0 ? (last - first) / kTurn / seconds : 0.0;
}

/// First and last row of a channel.
std::pair<std::vector<double>, std::vector<double>> ends(const H5Reader& reader, const char* id) {
  if (reader.find(id) == nullptr) return {};
  return {reader.read(id, 0, 1), reader.read(id, reader.steps() - 1, 1)};
}

std::vector<desktop::ChartMark> frequencies(const H5Reader& reader) {
  std::vector<desktop::ChartMark> out;
  if (reader.steps() < 2) return out;
  const std::vector<double> times = {reader.read("time", 0, 1).front(),
                                     reader.read("time", reader.steps() - 1, 1).front()};
  const double seconds = times[1] - times[0];
  const auto add = [&out](double frequency, const std::string& label) {
    if (std::isfinite(frequency) && std::abs(frequency) > 0.0)
      out.push_back({std::abs(frequency), label});
  };
  const auto race = ends(reader, "race.rotation"), orbit = ends(reader, "element.orbital_position");
  if (race.first.size() != 2 || orbit.first.empty()) return out;
  double f_race[2];
  for (std::size_t j = 0; j < 2; ++j)
    f_race[j] = turns_per_second(race.first[j], race.second[j], seconds);
  // What turns is named by itself: both races may, and their difference is no speed of a shaft.
  const double least = 1e-6 * std::max(std::abs(f_race[0]), std::abs(f_race[1]));
  if (std::abs(f_race[0]) > least && std::abs(f_race[1]) > least) {
    add(f_race[1], "inner race");
    add(f_race[0], "outer race");
  } else {
    add(f_race[1] - f_race[0], "shaft");
  }
  const auto n = static_cast<double>(orbit.first.size());
  double f_orbit = 0.0;
  for (std::size_t k = 0; k < orbit.first.size(); ++k)
    f_orbit += turns_per_second(orbit.first[k], orbit.second[k], seconds) / n;
  add(f_orbit, "FTF");
  // Mean over at most a few hundred steps: the spin hardly changes.
  constexpr std::size_t kLooks = 200;
  const std::size_t every = std::max<std::size_t>(1, reader.steps() / kLooks);
  const std::size_t looks = (reader.steps() - 1) / every + 1;
  if (reader.find("element.angular_velocity_vector") != nullptr) {
    const auto omega = reader.read("element.angular_velocity_vector", 0, looks, every);
    double spin = 0.0;
    for (std::size_t i = 0; i + 2 < omega.size(); i += 3)
      spin += std::hypot(omega[i] - kTurn * f_orbit, omega[i + 1], omega[i + 2]);
    add(3.0 * spin / static_cast<double>(omega.size()) / kTurn, "BSF");
  }
  add(n * (f_orbit - f_race[0]), "BPFO");
  add(n * (f_orbit - f_race[1]), "BPFI");
  const auto whirl = ends(reader, "cage.orbital_position");
  if (whirl.first.size() == 1)
    add(turns_per_second(whirl.first[0], whirl.second[0], seconds), "whirl");
  // Behind all first ones, which are named where there is room for few.
  const std::vector<desktop::ChartMark> first = out;
  for (int harmonic = 2; harmonic <= 3; ++harmonic)
    for (const desktop::ChartMark& mark : first)
      if (mark.label != "shaft" && mark.label != "inner race" && mark.label != "outer race")
        add(harmonic * mark.x, fmt::format("{} {}", harmonic, mark.label));
  return out;
}

/// "stored" of RUN.json.
RunFacts read_facts(const nlohmann::json& stored) {
  RunFacts out;
  if (!stored.is_object()) return out;
  const auto number = [&stored](const char* name) -> std::optional<double> {
    const auto found = stored.find(name);
    if (found == stored.end() || !found->is_number()) return std::nullopt;
    return found->get<double>();
  };
  const auto text = [&stored](const char* name) {
    const auto found = stored.find(name);
    return found != stored.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  if (const auto every = number("steps between life predictions"))
    out.life_every = static_cast<int>(std::clamp(*every, -1e9, 1e9));
  if (const std::string how = text("temperatures"); how == "given" || how == "computed")
    out.temperatures_computed = how == "computed";
  using Of = results::CageScale::Of;
  const auto length = number("cage orbit over [m]");
  for (const Of of : {Of::GuideLands, Of::Pockets, Of::UnitOfLength})
    if (length && *length > 0.0 && text("cage orbit over") == results::name_of(of))
      out.cage_scale = results::CageScale{*length, of};
  return out;
}

void read_run(const std::filesystem::path& run_json, const std::string& run_id, PageContext& out) {
  nlohmann::json run;
  try {
    run = parse_json(results::read_text_file(run_json), run_json.string());
  } catch (const InputError&) {
    return;  // none, or not ours: the page goes without it
  }
  if (!run.is_object() || run.value("run", nlohmann::json()) != run_id) return;
  out.facts = read_facts(run.value("stored", nlohmann::json()));
  const auto plan = run.find("plan");
  if (plan == run.end() || !plan->is_object()) return;
  if (const auto effects = plan->find("effects"); effects != plan->end() && effects->is_array()) {
    std::optional<bool> moves, thermal;
    for (const auto& effect : *effects) {
      if (!effect.is_object() || !effect.contains("name") || !effect.contains("on") ||
          !effect["name"].is_string() || !effect["on"].is_boolean())
        continue;
      const std::string name = effect["name"].get<std::string>();
      const bool on = effect["on"].get<bool>();
      if (name == "races that move under loads" || name == "force balance of the inner race" ||
          name == "rotating load" || name == "race vibration" || name == "varying race speed")
        moves = moves.value_or(false) || on;
      if (name == "thermal steps") thermal = on;
    }
    if (moves) out.facts.races_held = !*moves;
    if (!out.facts.temperatures_computed) out.facts.temperatures_computed = thermal;
  }
  const auto estimates = plan->find("estimates");
  if (estimates == plan->end() || !estimates->is_object()) return;
  const auto frequency = estimates->find("fastest_frequency_Hz");
  const auto contact = estimates->find("fastest_contact");
  if (frequency != estimates->end() && frequency->is_number())
    out.fastest_frequency = frequency->get<double>();
  if (contact != estimates->end() && contact->is_string())
    out.fastest_contact = contact->get<std::string>();
}

}  // namespace

std::vector<desktop::ChartMark> bearing_frequencies(const std::filesystem::path& results_h5) {
  return frequencies(H5Reader(results_h5));
}

PageContext context_of(const results::SolFile& file) {
  PageContext out;
  const std::filesystem::path folder = file.path.parent_path();
  try {
    read_run(folder / "RUN.json", file.header.run_id, out);
    std::error_code ignored;
    if (!std::filesystem::exists(folder / "RESULTS.h5", ignored)) return out;
    const H5Reader reader(folder / "RESULTS.h5");
    if (reader.run_id() != file.header.run_id) return out;
    out.frequencies = frequencies(reader);
    if (reader.geometry().contains("roller_length")) {
      auto& flanges = out.facts.flanges.emplace();
      for (const char* race : {"outer", "inner"})
        for (const auto& [end, place] : {std::pair{"minus_x", 1}, {"plus_x", 2}})
          if (reader.geometry().contains(fmt::format("{}_flange_{}_height", race, end)))
            flanges.insert(fmt::format("{}.{}", race, place));
    }
  } catch (const std::exception&) {
    // The plot file alone is enough.
  }
  return out;
}

void read_bands(const results::SolFile& file, const std::set<std::size_t>& columns,
                PageContext& out) {
  std::set<std::size_t> missing;
  const std::vector<results::SolColumn> all = results::sol_columns(file.header);
  for (const std::size_t c : columns)
    if (c < all.size() && !out.bands.contains(all[c].id)) missing.insert(c);
  if (missing.empty()) return;
  for (const std::size_t c : missing) out.bands.emplace(all[c].id, CurveBand{});
  try {
    for (auto& [column, band] : results::bands_of(file, missing))
      out.bands[all[column].id] = {std::move(band.low), std::move(band.high)};
  } catch (const std::exception&) {
    // The plot file alone is enough.
  }
}

}  // namespace adore::adrplot

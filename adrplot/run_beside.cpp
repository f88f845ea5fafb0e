#include "adrplot/run_beside.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "results/channels.hpp"
#include "results/full_precision.hpp"
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

/// Looks at a run at some hundred of its steps, the last one among them.
class Looks {
 public:
  static constexpr const char* kTime = "time";  // of every run
  explicit Looks(const H5Reader& reader) : reader_(reader) {
    constexpr std::size_t kLooks = 500;
    every_ = std::max<std::size_t>(1, (reader.steps() - 1) / kLooks);
    count_ = (reader.steps() - 1) / every_ + 1;
    last_ = (count_ - 1) * every_ + 1 < reader.steps();
  }
  /// Rows of a channel, one per sample; empty: the run has none.
  [[nodiscard]] std::vector<std::vector<double>> rows(const std::string& id) const {
    if (id != kTime && reader_.find(id) == nullptr) return {};
    std::vector<double> values = reader_.read(id, 0, count_, every_);
    if (last_) {
      const std::vector<double> end = reader_.read(id, reader_.steps() - 1, 1);
      values.insert(values.end(), end.begin(), end.end());
    }
    const std::size_t looks = count_ + (last_ ? 1 : 0), width = values.size() / looks;
    std::vector<std::vector<double>> out;
    for (std::size_t i = 0; i < looks; ++i)
      out.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(i * width),
                       values.begin() + static_cast<std::ptrdiff_t>((i + 1) * width));
    return out;
  }

 private:
  const H5Reader& reader_;
  std::size_t every_ = 1, count_ = 0;
  bool last_ = false;  ///< the last step is not a multiple of them
};

/// Rotation of elements relative to their orbit: mean of all, accumulated.
std::vector<double> spin_turns(const std::vector<std::vector<double>>& omega,
                               const std::vector<double>& times, const std::vector<double>& orbit) {
  std::vector<double> out(omega.size(), 0.0);
  const auto rate = [&](std::size_t i) {
    const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, times.size() - 1);
    const double span = times[b] - times[a];
    const double orbits = span > 0.0 ? (orbit[b] - orbit[a]) / span : 0.0;
    double spin = 0.0;
    for (std::size_t k = 0; k + 2 < omega[i].size(); k += 3)
      spin += std::hypot(omega[i][k] - kTurn * orbits, omega[i][k + 1], omega[i][k + 2]);
    return 3.0 * spin / static_cast<double>(omega[i].size()) / kTurn;
  };
  for (std::size_t i = 1; i < out.size(); ++i)
    out[i] = out[i - 1] + 0.5 * (times[i] - times[i - 1]) * (rate(i - 1) + rate(i));
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
  using Of = results::CageLengthScale::Of;
  const auto length = number("cage orbit over [m]");
  for (const Of of : {Of::GuideLands, Of::Pockets, Of::UnitOfLength})
    if (length && *length > 0.0 && text("cage orbit over") == results::name_of(of))
      out.cage_length_scale = results::CageLengthScale{*length, of};
  return out;
}

void read_run(const std::filesystem::path& run_json, const std::string& run_id, PageContext& out) {
  nlohmann::json run;
  try {
    run = parse_json(read_text_file(run_json), run_json.string());
  } catch (const InputError&) {
    return;  // missing or another file: the page is built without it
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

std::vector<MarkEventCounts> mark_event_counts(const H5Reader& reader) {
  std::vector<MarkEventCounts> out;
  if (reader.steps() < 2) return out;
  const Looks looks(reader);
  std::vector<double> times;
  for (const auto& row : looks.rows(Looks::kTime)) times.push_back(row.front());
  const auto add = [&](const std::string& label, const std::vector<double>& turns) {
    out.push_back({label, times, turns});
  };
  const auto races = looks.rows("race.rotation"), orbits = looks.rows("element.orbital_position");
  if (races.empty() || races.front().size() != 2 || orbits.empty() || orbits.front().empty())
    return out;
  const auto n = static_cast<double>(orbits.front().size());
  std::vector<double> race[2], between, orbit, past[2];
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::size_t j = 0; j < 2; ++j) race[j].push_back(races[i][j] / kTurn);
    between.push_back(race[1][i] - race[0][i]);
    double sum = 0.0;
    for (const double angle : orbits[i]) sum += angle / kTurn;
    orbit.push_back(sum / n);
    for (std::size_t j = 0; j < 2; ++j) past[j].push_back(n * (orbit[i] - race[j][i]));
  }
  // Rotating races are named separately: both may rotate, and their difference is not a shaft
  // speed.
  const double outer = std::abs(race[0].back() - race[0].front()),
               inner = std::abs(race[1].back() - race[1].front());
  const double least = 1e-6 * std::max(outer, inner);
  if (outer > least && inner > least) {
    add("inner race", race[1]);
    add("outer race", race[0]);
  } else {
    add("shaft", between);
  }
  add("FTF", orbit);
  if (const auto omega = looks.rows("element.angular_velocity_vector"); !omega.empty())
    add("BSF", spin_turns(omega, times, orbit));
  add("BPFO", past[0]);
  add("BPFI", past[1]);
  if (const auto whirl = looks.rows("cage.orbital_position");
      !whirl.empty() && whirl.front().size() == 1) {
    std::vector<double> turns;
    for (const auto& row : whirl) turns.push_back(row.front() / kTurn);
    add("whirl", turns);
  }
  // After all first ones, which are named if there is little space.
  const std::size_t first = out.size();
  for (int harmonic = 2; harmonic <= 3; ++harmonic)
    for (std::size_t i = 0; i < first; ++i) {
      if (out[i].label == "shaft" || out[i].label.ends_with(" race")) continue;
      std::vector<double> turns = out[i].turns;
      for (double& t : turns) t *= harmonic;
      add(fmt::format("{} {}", harmonic, out[i].label), turns);
    }
  return out;
}

std::vector<desktop::ChartMark> bearing_frequencies(const std::filesystem::path& results_h5) {
  return mean_marks(mark_event_counts(H5Reader(results_h5)));
}

PageContext page_context_of(const results::SolFile& file) {
  PageContext out;
  const std::filesystem::path folder = file.path.parent_path();
  try {
    read_run(folder / "RUN.json", file.header.run_id, out);
    std::error_code ignored;
    if (!std::filesystem::exists(folder / "RESULTS.h5", ignored)) return out;
    const H5Reader reader(folder / "RESULTS.h5");
    if (reader.run_id() != file.header.run_id) return out;
    out.marks = mark_event_counts(reader);
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

void read_min_max_bands(const results::SolFile& file, const std::set<std::size_t>& columns,
                        PageContext& out) {
  std::set<std::size_t> missing;
  const std::vector<results::SolColumn> all = results::sol_columns(file.header);
  for (const std::size_t c : columns)
    if (c < all.size() && !out.bands.contains(all[c].id)) missing.insert(c);
  if (missing.empty()) return;
  for (const std::size_t c : missing) out.bands.emplace(all[c].id, MinMaxBand{});
  try {
    for (auto& [column, band] : results::bands_of(file, missing))
      out.bands[all[column].id] = {std::move(band.low), std::move(band.high)};
  } catch (const std::exception&) {
    // The plot file alone is enough.
  }
}

}  // namespace adore::adrplot

#include "results/run_json.hpp"

#include "base/arithmetic.hpp"
#include "base/checksum.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/own_files.hpp"
#include "base/version.hpp"
#include "base/write_folder.hpp"
#include "results/growing_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::results {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kNoChecksum = "0000000000000000";

template <class T>
Json object_of(const std::vector<std::pair<std::string, T>>& items) {
  Json out = Json::object();
  for (const auto& [name, value] : items) out[name] = value;
  // JSON has no infinity; lives may be infinite.
  for (Json& entry : out)
    if (entry.is_number_float() && std::isinf(entry.template get<double>())) entry = "infinite";
  return out;
}

Json object_of(const KeyResults& items) {
  std::vector<std::pair<std::string, double>> values;
  for (const KeyResult& item : items) values.emplace_back(item.of.id, item.value);
  return object_of(values);
}

/// Compiler of this build: the same source may round differently elsewhere.
std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "gcc " __VERSION__;
#else
  return "unknown";
#endif
}

}  // namespace

std::vector<std::pair<std::string, double>> energy_items(const scene::EnergyLedger& energy) {
  std::vector<std::pair<std::string, double>> items;
  for (const auto& item : energy.items()) items.emplace_back(item.name(), item.value);
  items.emplace_back("residual", energy.residual());
  return items;
}

std::vector<std::pair<std::string, double>> momentum_items(const scene::MomentumLedger& m) {
  using scene::LedgerKind;
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  std::vector<std::pair<std::string, double>> items;
  const auto walk = [&items](const scene::Ledger<scene::Vec3>& ledger, const std::string& quantity,
                             const char* unit) {
    const auto add = [&](const std::string& name, const scene::Vec3& v) {
      for (int k = 0; k < 3; ++k)
        items.emplace_back(name + ", " + kAxes[k] + " [" + unit + "]", v[k]);
    };
    const auto add_kind = [&](LedgerKind kind) {
      for (const auto& item : ledger.items())
        if (item.term->kind == kind && (kind == LedgerKind::Work || !item.value.isZero(0.0)))
          add(item.name(), item.value);
    };
    add_kind(LedgerKind::Work);
    add("change of " + quantity, ledger.sum(LedgerKind::Stored) - ledger.sum(LedgerKind::Start));
    for (const LedgerKind kind : {LedgerKind::Heat, LedgerKind::Switch, LedgerKind::Taken})
      add_kind(kind);
    add("residual of " + quantity, ledger.residual());
  };
  walk(m.linear, "linear momentum", "N s");
  walk(m.angular, "angular momentum", "N m s");
  items.emplace_back("linear residual over momentum carried",
                     m.linear_size > 0.0 ? m.linear.residual().norm() / m.linear_size : 0.0);
  items.emplace_back("angular residual over momentum carried",
                     m.angular_size > 0.0 ? m.angular.residual().norm() / m.angular_size : 0.0);
  return items;
}

std::vector<std::pair<std::string, std::string>> arithmetic_items(const RunSummary& run) {
  std::vector<std::pair<std::string, std::string>> items{
      {"math functions", has_portable_math()
                             ? "built in, identical on every processor"
                             : "from the C library; results may differ between processors"}};
  if (run.integrator.empty()) return items;  // the equilibrium does not use a contact kernel
  items.emplace_back("instruction set of the contacts", run.instruction_set);
  items.emplace_back("note",
                     "Other processor instruction sets round differently. The motion amplifies "
                     "these differences to about 3e-6 of the loads after 3 revolutions. "
                     "--reproducible gives identical files on every x86-64 processor.");
  return items;
}

double energy_scale(const scene::EnergyLedger& energy) {
  using scene::LedgerKind;
  const double moved =
      std::max(std::abs(energy.sum(LedgerKind::Work)), energy.sum(LedgerKind::Heat));
  const double stored =
      std::max(std::abs(energy.sum(LedgerKind::Start)), std::abs(energy.sum(LedgerKind::Stored)));
  return moved > 0.0 ? std::max(moved, kEnergyFloor * stored) : stored;
}

double heat_scale(const scene::EnergyLedger& energy) {
  using scene::LedgerKind;
  const double heat = energy.sum(LedgerKind::Heat);
  const double stored =
      std::max(std::abs(energy.sum(LedgerKind::Start)), std::abs(energy.sum(LedgerKind::Stored)));
  return heat > 0.0 ? std::max(heat, kHeatFloor * stored) : 0.0;
}

Json run_json(const RunSummary& run) {
  Json out;
  out["program"] = kProgramVersion;
  out["format"] = 1;
  out["build"] = {{"compiler", compiler()}};
  out["arithmetic"] = object_of(arithmetic_items(run));
  out["run"] = run.run_id;
  out["deck"] = run.deck_file;
  out["request"] = run.request;
  out["status"] = run.status;
  if (!run.message.empty()) out["message"] = run.message;
  out["integrator"] = run.integrator;
  out["tolerance"] = run.tolerance;
  out["options"] = object_of(run.options);
  out["seeds"] = object_of(run.seeds);
  if (run.scales)
    out["scales"] = {{"length [m]", run.scales->length},
                     {"force [N]", run.scales->force},
                     {"time [s]", run.scales->time}};
  out["plan"] = run.plan;
  if (!run.stored.is_null()) out["stored"] = run.stored;
  if (!run.imperfections.is_null()) out["geometric imperfections"] = run.imperfections;
  if (!run.operating.is_null()) out["operating fits"] = run.operating;
  out["steps"] = run.steps;
  out["time [s]"] = run.time;
  out["revolutions"] = run.revolutions;
  out["counters"] = object_of(run.counters);
  if (run.error_sum)
    out["error estimates of the steps"] = {{"sum", *run.error_sum},
                                           {"largest", *run.error_largest}};
  if (run.load) {
    Json load = Json::object();
    load["span of the mean [s]"] = run.load->time;
    for (int k = 0; k < 3; ++k) {
      const std::string axis(1, "xyz"[k]);
      if (run.load->given[static_cast<std::size_t>(k)])
        load["asked " + axis + " [N]"] = run.load->asked[k];
      load["mean " + axis + " [N]"] = run.load->mean[k];
    }
    load["departure from the asked load"] = run.load->departure();
    out["load carried by the elements"] = load;
  }
  Json conservation = Json::object();
  if (run.energy) {
    Json items = Json::object();
    for (const auto& [name, value] : energy_items(*run.energy)) items[name + " [J]"] = value;
    const double scale = energy_scale(*run.energy);
    items["residual over energy moved"] = scale > 0.0 ? run.energy->residual() / scale : 0.0;
    if (const double heat = heat_scale(*run.energy); heat > 0.0)
      items["residual over heat"] = run.energy->residual() / heat;
    if (run.elastic && *run.elastic > 0.0)
      items["residual over elastic energy of the quasi-static solution"] =
          run.energy->residual() / *run.elastic;
    conservation["energy"] = items;
  }
  if (!run.momentum.empty()) conservation["momentum"] = object_of(run.momentum);
  if (run.max_quaternion_error)
    conservation["largest quaternion error"] = *run.max_quaternion_error;
  if (run.quadrature_error) {
    conservation["contact quadrature error"] = run.quadrature_error->force;
    conservation["race heat by the run's rule, W"] = run.quadrature_error->heat_of_rule;
    conservation["race heat by twice the nodes, W"] = run.quadrature_error->heat_of_finer;
  }
  out["conservation"] = conservation;
  out["summary"] = object_of(run.summary);
  if (!run.accuracy.is_null()) out["accuracy"] = run.accuracy;
  if (!run.quasi_static.is_null()) out["quasi_static"] = run.quasi_static;
  if (!run.thermal_network.is_null()) out["thermal_network"] = run.thermal_network;
  if (!run.life.is_null()) out["life"] = run.life;
  Json defaults = Json::array();
  for (const deck::DefaultUsed& used : run.defaults_used) {
    defaults.push_back({{"record", used.record},
                        {"variable", used.variable},
                        {"value", used.value},
                        {"unit", used.unit}});
  }
  out["defaults_used"] = defaults;
  Json idle = Json::array();
  for (const deck::NoPart& value : run.no_part)
    idle.push_back({{"record", value.record},
                    {"variable", value.variable},
                    {"value", value.value},
                    {"because", value.because}});
  out["played_no_part"] = idle;
  out["findings"] = findings_json(run.findings);
  // For one release: the same sentences as text.
  out["notes"] = Json::array();
  for (const Finding& one : shown_findings(run.findings)) out["notes"].push_back(one.text());
  if (!run.validity.is_null()) out["outside_validity"] = run.validity;
  out["files"] = run.files;

  Json cost = Json::array();
  double accounted = 0.0;
  for (const scene::CostLedger::Row& row : run.cost) {
    accounted += row.seconds;
    cost.push_back({{"name", row.name},
                    {"calls", row.calls},
                    {"seconds", row.seconds},
                    {"share", run.seconds > 0.0 ? row.seconds / run.seconds : 0.0}});
  }
  out["measured"] = {{"seconds", run.seconds}, {"accounted seconds", accounted}, {"cost", cost}};
  if (run.measured_from > 0) out["measured"]["from step"] = run.measured_from;
  for (const FileChecksum& file : run.sums)
    out["measured"]["checksums"][file.name] = {{"bytes", file.bytes},
                                               {"checksum", fmt::format("{:016x}", file.sum)}};
  out["measured"][kOwnChecksum] = std::string(kNoChecksum);
  return out;
}

RunRequestStatus read_request_status(const std::filesystem::path& path) {
  RunRequestStatus out;
  if (!is_written_by_adore(path)) return out;
  InputFile stream(path);
  // Members of the outer object stand two blanks in; those looked for come before anything long.
  std::string line;
  for (int count = 0; count < 40 && std::getline(stream, line); ++count)
    for (const auto& [name, value] :
         {std::pair{"request", &out.request}, {"status", &out.status}}) {
      const std::string start = std::string("  \"") + name + "\": \"";
      if (line.rfind(start, 0) == 0)
        *value = line.substr(start.size(), line.find('"', start.size()) - start.size());
    }
  return out;
}

nlohmann::json read_run_member(const std::filesystem::path& path, const char* name) {
  if (!is_written_by_adore(path)) return {};
  try {
    const auto run = parse_json(read_text_file(path), path.string());
    return run.is_object() ? run.value(name, nlohmann::json()) : nlohmann::json();
  } catch (const InputError&) {
    return {};
  }
}

std::string run_json_checksum(std::string text) {
  const std::string key = fmt::format("\"{}\": \"", kOwnChecksum);
  const std::size_t at = text.rfind(key);
  if (at == std::string::npos || text.size() < at + key.size() + kNoChecksum.size()) return {};
  text.replace(at + key.size(), kNoChecksum.size(), kNoChecksum);
  return fmt::format("{:016x}", checksum(text));
}

namespace {

/// @pre its own checksum is kNoChecksum
void write_with_checksum(const nlohmann::ordered_json& run, const WritePath& place) {
  std::string text = dump_json(run, 2) + "\n";
  const std::string key = fmt::format("\"{}\": \"", kOwnChecksum);
  text.replace(text.rfind(key) + key.size(), kNoChecksum.size(), run_json_checksum(text));
  write_file_atomically(place, text);
}

}  // namespace

void write_run_json(const RunSummary& run, const WritePath& place) {
  write_with_checksum(run_json(run), place);
}

void amend_run(const WriteFolder& folder, const nlohmann::ordered_json& members,
               const std::string& print) {
  const std::filesystem::path file = folder.path() / "RUN.json";
  const auto old = parse_json<nlohmann::ordered_json>(read_text_file(file), file.string());
  if (!old.is_object() || !old.contains("measured"))
    throw InputError(file.string() + " is not the RUN.json of a finished run");
  const std::filesystem::path listing = folder.path() / "PRINT.txt";
  if (!print.empty())
    GrowingFile::open_for_append(WritePath(folder, "PRINT.txt"),
                                 std::filesystem::file_size(listing))
        .append(print);
  nlohmann::ordered_json run;
  for (const auto& [name, value] : old.items()) {
    if (name == "files")  // in front of the list of files
      for (const auto& [key, member] : members.items()) run[key] = member;
    if (name == "measured" || !members.contains(name)) run[name] = value;
  }
  for (const auto& [key, member] : members.items()) run[key] = member;
  nlohmann::ordered_json& measured = run["measured"];
  if (const FileChecksum sum = file_checksum(listing); measured.contains("checksums"))
    measured["checksums"]["PRINT.txt"] = {{"bytes", sum.bytes},
                                          {"checksum", fmt::format("{:016x}", sum.sum)}};
  measured[kOwnChecksum] = std::string(kNoChecksum);
  write_with_checksum(run, WritePath(folder, "RUN.json"));
}

nlohmann::ordered_json mean_errors_json(const MeanErrors& errors) {
  nlohmann::ordered_json out{{"interval", "95 %, batch means"}};
  const auto add = [&](const char* id, double half) {
    if (std::isfinite(half)) out[id] = half;
  };
  add("mean_power_loss_W", errors.power_loss);
  add("mean_heat_outer_race_W", errors.heat_outer);
  add("mean_heat_inner_race_W", errors.heat_inner);
  add("mean_heat_elsewhere_W", errors.heat_elsewhere);
  add("mean_orbital_ratio", errors.orbital_ratio);
  add("mean_cage_ratio", errors.cage_ratio);
  add("mean_swept_whirl_ratio", errors.swept_whirl_ratio);
  add("mean_load_x_N", errors.load[0]);
  add("mean_load_y_N", errors.load[1]);
  add("mean_load_z_N", errors.load[2]);
  add("mean_largest_load_N", errors.largest_load);
  return out;
}

}  // namespace adore::results

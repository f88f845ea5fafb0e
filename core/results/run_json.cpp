#include "results/run_json.hpp"

#include "base/atomic_file.hpp"
#include "base/version.hpp"

#include <algorithm>
#include <cmath>

namespace adore::results {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json object_of(const std::vector<std::pair<std::string, T>>& items) {
  Json out = Json::object();
  for (const auto& [name, value] : items) out[name] = value;
  // JSON knows no infinity; lives may be infinite.
  for (Json& entry : out)
    if (entry.is_number_float() && std::isinf(entry.template get<double>())) entry = "infinite";
  return out;
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

std::vector<std::pair<std::string, double>> energy_items(const dynamics::EnergySnapshot& e) {
  std::vector<std::pair<std::string, double>> items{{"stored at the start", e.stored_at_start},
                                                    {"kinetic energy now", e.kinetic},
                                                    {"elastic energy now", e.elastic},
                                                    {"energy in gravity now", e.gravity},
                                                    {"work of the outer race", e.work_race[0]},
                                                    {"work of the inner race", e.work_race[1]},
                                                    {"heat, outer race contacts", e.heat_race[0]},
                                                    {"heat, inner race contacts", e.heat_race[1]},
                                                    {"heat, cage pockets", e.heat_pockets},
                                                    {"heat, guide lands", e.heat_lands}};
  if (e.light_load_balance) {
    items.emplace_back("switches of held elements", e.switches);
    items.emplace_back("taken by held elements' way to balance", e.balance);
    items.emplace_back("kinetic energy left out of held elements now", e.left_out);
  }
  items.emplace_back("residual", e.residual());
  return items;
}

std::vector<std::pair<std::string, double>> momentum_items(const dynamics::MomentumSnapshot& m) {
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  std::vector<std::pair<std::string, double>> items;
  const auto add = [&items](const std::string& name, const char* unit, const dynamics::Vec3& v) {
    for (int k = 0; k < 3; ++k)
      items.emplace_back(name + ", " + kAxes[k] + " [" + unit + "]", v[k]);
  };
  const dynamics::Vec3 linear = m.linear_residual(), angular = m.angular_residual();
  add("impulse from outside", "N s", m.impulse);
  add("change of linear momentum", "N s", m.linear - m.linear_start);
  if (!m.held.isZero(0.0)) add("linear momentum taken by held elements", "N s", m.held);
  add("residual of linear momentum", "N s", linear);
  add("angular impulse from outside", "N m s", m.angular_impulse);
  add("change of angular momentum", "N m s", m.angular - m.angular_start);
  if (!m.angular_held.isZero(0.0))
    add("angular momentum taken by held elements", "N m s", m.angular_held);
  add("residual of angular momentum", "N m s", angular);
  items.emplace_back("linear residual over momentum carried",
                     m.linear_size > 0.0 ? linear.norm() / m.linear_size : 0.0);
  items.emplace_back("angular residual over momentum carried",
                     m.angular_size > 0.0 ? angular.norm() / m.angular_size : 0.0);
  return items;
}

double energy_scale(const dynamics::EnergySnapshot& e) {
  const double moved = std::max(std::abs(e.work_race[0] + e.work_race[1]),
                                e.heat_race[0] + e.heat_race[1] + e.heat_pockets + e.heat_lands);
  return moved > 0.0
             ? moved
             : std::max(std::abs(e.stored_at_start), std::abs(e.kinetic + e.elastic + e.gravity));
}

Json run_json(const RunSummary& run) {
  Json out;
  out["program"] = kProgramVersion;
  out["format"] = 1;
  out["build"] = {{"compiler", compiler()}};
  out["run"] = run.run_id;
  out["deck"] = run.deck_file;
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
  if (!run.imperfections.is_null()) out["geometric imperfections"] = run.imperfections;
  if (!run.operating.is_null()) out["operating fits"] = run.operating;
  out["steps"] = run.steps;
  out["time [s]"] = run.time;
  out["revolutions"] = run.revolutions;
  out["counters"] = object_of(run.counters);
  Json conservation = Json::object();
  if (run.energy) {
    Json items = Json::object();
    for (const auto& [name, value] : energy_items(*run.energy)) items[name + " [J]"] = value;
    const double scale = energy_scale(*run.energy);
    items["residual over energy moved"] = scale > 0.0 ? run.energy->residual() / scale : 0.0;
    conservation["energy"] = items;
  }
  if (!run.momentum.empty()) conservation["momentum"] = object_of(run.momentum);
  if (run.max_quaternion_error)
    conservation["largest quaternion error"] = *run.max_quaternion_error;
  if (run.quadrature_error) conservation["contact quadrature error"] = *run.quadrature_error;
  out["conservation"] = conservation;
  out["summary"] = object_of(run.summary);
  if (!run.quasi_static.is_null()) out["quasi_static"] = run.quasi_static;
  if (!run.life.is_null()) out["life"] = run.life;
  Json defaults = Json::array();
  for (const deck::DefaultUsed& used : run.defaults_used) {
    defaults.push_back({{"record", used.record},
                        {"variable", used.variable},
                        {"value", used.value},
                        {"unit", used.unit}});
  }
  out["defaults_used"] = defaults;
  out["notes"] = run.notes;
  out["files"] = run.files;

  Json cost = Json::array();
  double accounted = 0.0;
  for (const dynamics::CostLedger::Row& row : run.cost) {
    accounted += row.seconds;
    cost.push_back({{"name", row.name},
                    {"calls", row.calls},
                    {"seconds", row.seconds},
                    {"share", run.seconds > 0.0 ? row.seconds / run.seconds : 0.0}});
  }
  out["measured"] = {{"seconds", run.seconds},
                     {"accounted seconds", accounted},
                     {"instruction set", run.instruction_set},
                     {"cost", cost}};
  return out;
}

void write_run_json(const RunSummary& run, const std::filesystem::path& path) {
  write_file_atomically(path,
                        run_json(run).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace adore::results

#include "runs/disk_use.hpp"

#include "base/counted.hpp"
#include "dynamics/effect_catalogue.hpp"
#include "listing/print_file.hpp"
#include "results/averages.hpp"
#include "results/channels.hpp"
#include "results/results_h5.hpp"
#include "results/sol_writer.hpp"
#include "runs/run_files.hpp"
#include "runs/thermal_run.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace adore::runs {
namespace {

/// Steps that an interval selects: the first, every n-th and the last.
double selected(double steps, int every) {
  return every > 0 ? 1.0 + std::floor(steps / every) + (std::fmod(steps, every) != 0.0 ? 1.0 : 0.0)
                   : 2.0;
}

double counted_steps(const Prepared& prepared, const scene::ScenePlan& plan, double time_scale) {
  const double most = static_cast<double>(prepared.control.max_steps);
  const double step = plan.expected_step * prepared.control.substeps;
  if (!(step > 0.0)) return most;
  return std::min(most, std::ceil(prepared.control.end_time * time_scale / step));
}

/// Bytes of one stored step of RESULTS.h5: every channel as doubles, and the five step columns.
double h5_step_bytes(const results::StepRecord& record) {
  std::size_t values = 5;
  for (const std::vector<double>& channel : record.values) values += channel.size();
  return static_cast<double>(values * sizeof(double));
}

std::string size_text(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.3g} kB", bytes / 1e3);
  return bytes < 1e9 ? fmt::format("{:.3g} MB", bytes / 1e6)
                     : fmt::format("{:.3g} GB", bytes / 1e9);
}

}  // namespace

double DiskUse::total() const {
  double sum = 0.0;
  for (const auto& [name, bytes] : files) sum += bytes;
  return sum;
}

DiskUse disk_use(const Prepared& prepared, const scene::ScenePlan& plan) {
  DiskUse out;
  if (!prepared.control.dynamic) return out;
  const setup::RunControl& control = prepared.control;
  const deck::UnitSystem units = prepared.input.deck.units();
  dynamics::System system = make_system(prepared);
  const std::vector<double> y = system.initial_state();
  scene::Snapshot snapshot = system.snapshot(0.0, y);
  if (prepared.bearing.thermal) snapshot.thermal = ThermalRun(prepared).shown();
  results::ChannelRecorder recorder(prepared.bearing, units,
                                    results::ChannelTable(dynamics::energy_terms()));
  const results::StepRecord& record = recorder.record(snapshot);

  out.steps = counted_steps(prepared, plan, system.scales().time);
  out.stored = selected(out.steps, control.plot_every);

  listing::Report report(prepared.bearing.run_id, units);
  listing::print_front_matter(report,
                              {prepared.input.deck, prepared.as_built, system.scales(), {}});
  const double front = static_cast<double>(report.take().size());
  listing::print_step(report, snapshot, record, prepared.bearing, {}, control.print_option, {},
                      race_friction_model(prepared));
  const double page = static_cast<double>(report.take().size());
  out.files.emplace_back("PRINT.txt", front + page * selected(out.steps, control.print_every));

  const auto sol_bytes = [&](int index) {
    const results::SolHeader header = results::make_sol_header(prepared.bearing, index, units);
    std::string text;
    results::append_sol_step(
        text, results::make_sol_step(header, results::sol_columns(header), record, units));
    return static_cast<double>(results::format_sol_header(header).size()) +
           out.stored * static_cast<double>(text.size());
  };
  for (std::size_t k = 0; k < control.monitored.size() && k < 6; ++k)
    out.files.emplace_back(control.sol_files[k], sol_bytes(control.monitored[k]));
  out.files.emplace_back(control.sol_files[6], sol_bytes(0));

  const double animated = control.animate ? selected(out.steps, control.animate_every) : 0.0;
  if (control.animate &&
      !results::sol8_refusal(prepared.bearing.element_count(), prepared.bearing.cage ? 1 : 0)) {
    std::string text;
    results::append_sol8_frame(text, results::make_sol8_frame(snapshot));
    out.files.emplace_back(control.sol_files[7], animated * static_cast<double>(text.size()));
  }
  if (prepared.options.results_h5) {
    // A step that both intervals select is stored once; whole blocks.
    double both = control.animate ? 2.0 : 0.0;  // first and last
    if (control.plot_every > 0 && control.animate_every > 0)
      both = selected(out.steps, std::lcm(control.plot_every, control.animate_every));
    const double all = out.stored + animated - std::min(both, animated);
    const double step = h5_step_bytes(record);
    const double block = results::H5Writer::steps_per_block(step);
    out.files.emplace_back("RESULTS.h5", block * std::ceil(all / block) * step);
  }
  return out;
}

std::string disk_use_text(const DiskUse& use) {
  if (use.files.empty()) return {};
  std::string text =
      fmt::format("\ndisk\n  about {} for {}, {:.4g} of them stored\n", size_text(use.total()),
                  counted(fmt::format("{:.4g}", use.steps), "step"), use.stored);
  for (const auto& [name, bytes] : use.files)
    text += fmt::format("  {:<24} {}\n", name, size_text(bytes));
  return text;
}

nlohmann::ordered_json disk_use_json(const DiskUse& use) {
  nlohmann::ordered_json files = nlohmann::ordered_json::object();
  for (const auto& [name, bytes] : use.files) files[name] = std::round(bytes);
  return {{"bytes", std::round(use.total())},
          {"steps", use.steps},
          {"stored_steps", use.stored},
          {"files", files}};
}

}  // namespace adore::runs

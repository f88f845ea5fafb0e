#include "facade/run_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>

#include "base/errors.hpp"
#include "base/version.hpp"
#include "results/averages.hpp"
#include "results/channels.hpp"
#include "results/restart.hpp"
#include "results/sol_writer.hpp"

namespace adore::facade {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;
using dynamics::Snapshot;

std::vector<std::string> component_names(const dynamics::System& system) {
  std::vector<std::string> out;
  for (int i = 0; i < system.layout().size(); ++i) out.push_back(system.layout().component_name(i));
  return out;
}

bool due(long step, int every) { return every > 0 && step % every == 0; }

}  // namespace

/// The open files of one run and what they need to go on.
struct RunOutputs::Impl {
  const Prepared& prepared;
  fs::path folder;
  deck::UnitSystem units;
  results::ChannelRecorder recorder;
  results::RunAverages averages;
  std::vector<results::SolWriter> elements;  ///< SOL1..SOL6
  std::optional<results::SolWriter> power;   ///< SOL7
  std::optional<results::Sol8Writer> animation;
  std::optional<Snapshot> last;              ///< last stored instant
  std::vector<double> last_y;
  RunPoint last_point;
  std::vector<fs::path> written;
  Clock::time_point checkpoint = Clock::now();

  Impl(const Prepared& p, fs::path f)
      : prepared(p), folder(std::move(f)), units(p.input.deck.units()), recorder(p.bearing, units) {}

  [[nodiscard]] fs::path path(const std::string& name) const { return folder / name; }
  [[nodiscard]] fs::path sol_path(std::size_t number) const { return folder / prepared.control.sol_files[number - 1]; }
};

RunOutputs::RunOutputs(const Prepared& prepared, const fs::path& folder) : impl_(std::make_unique<Impl>(prepared, folder)) {}
RunOutputs::~RunOutputs() = default;

}  // namespace adore::facade

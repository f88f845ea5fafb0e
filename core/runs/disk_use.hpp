#pragma once

#include "runs/prepare.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <utility>
#include <vector>

/// How large the files of a run would become.
namespace adore::runs {

struct DiskUse {
  std::vector<std::pair<std::string, double>> files;  ///< name, bytes; those that grow with the run
  double steps = 0.0;   ///< counted steps of the whole run, by the plan's estimate
  double stored = 0.0;  ///< of them stored in SOL1-SOL7
  [[nodiscard]] double total() const;
};

/// From the formats themselves: one step of each file is written to memory and multiplied by the
/// number of steps that its interval selects. Only as good as the plan's estimate of the step.
/// Empty for a quasi-static deck, whose two files stay below a megabyte.
/// @param plan with its estimates
[[nodiscard]] DiskUse disk_use(const Prepared& prepared, const scene::ScenePlan& plan);

/// Lines of `adore plan`; may be empty.
[[nodiscard]] std::string disk_use_text(const DiskUse& use);
[[nodiscard]] nlohmann::ordered_json disk_use_json(const DiskUse& use);

}  // namespace adore::runs

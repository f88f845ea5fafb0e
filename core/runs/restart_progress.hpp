#pragma once

#include "results/restart.hpp"
#include "runs/run_outputs.hpp"
#include "scene/snapshot.hpp"
#include "setup/run_control.hpp"

#include <Eigen/Core>

#include <filesystem>
#include <map>
#include <optional>
#include <string>

/// Contents of MASTER in addition to the state, for a continuation without a break: positions in
/// the files, the stepper's memory, and start values of the ledgers.
namespace adore::runs {

/// Last step in each kind of file, and of the life models; -1 before the first.
struct LastStoredSteps {
  long plotted = -1, animated = -1, printed = -1, saved = -1, lived = -1;
};

/// Start values of the ledgers of a continued run, and their residual at the continuation. They
/// continue bit by bit while the residual is that of MASTER; under other loads or speeds it jumps,
/// and they start again. "That of MASTER" allows for rounding: of the balance's largest item, since
/// another processor's vector units round otherwise and the residual is a small difference of large
/// energies (small early in a run), and 1e-9 of the exchanged energy.
struct LedgerStart {
  double stored = 0.0, residual = 0.0;                                 ///< [J]
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear;  ///< [N s, N m s]

  /// Nothing when the file is older than such entries.
  [[nodiscard]] static std::optional<LedgerStart> of(const results::MasterState& master);
  /// Is `now`, an instant that begins with this start, the one in MASTER?
  [[nodiscard]] bool is_continued_by(const scene::EnergyLedger& now) const;
  /// Replaces the start in the ledgers of an instant.
  void apply(scene::Snapshot& to) const;
};

/// @param segment step from which maxStps counts
void save_progress(std::map<std::string, double>& state, const scene::Snapshot& at,
                   const Resume& resume, const LastStoredSteps& steps, long segment,
                   const setup::RunControl& control);

/// The stepper's memory belongs to one method with its limits: under others it stays empty.
/// @param file MASTER, for messages
/// @throws InputError when what it remembers is not finite, or a step or counter impossible
[[nodiscard]] LastStoredSteps restore_progress(const results::MasterState& master,
                                               const setup::RunControl& control,
                                               const std::filesystem::path& file, StartPoint& out);

}  // namespace adore::runs

#pragma once

#include "listing/print_file.hpp"
#include "results/channels.hpp"
#include "results/restart.hpp"
#include "results/results_h5.hpp"
#include "results/sol_writer.hpp"
#include "runs/output_folder.hpp"
#include "runs/prepare.hpp"
#include "runs/restart_progress.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The growing files of one run: their names, their opening, and which step goes where.
namespace adore::runs {

/// Parameters of the friction of elements and races in this run, as effects/races.cpp takes them.
[[nodiscard]] listing::RaceFrictionModel race_friction_model(const Prepared& prepared);

class RunFiles {
 public:
  /// @pre `prepared` outlives this
  RunFiles(const Prepared& prepared, RunPlace place);

  [[nodiscard]] std::filesystem::path path(const std::string& name) const {
    return place_.path / name;
  }
  [[nodiscard]] const WriteFolder& folder() const;
  /// Place of an output file of this name.
  [[nodiscard]] WritePath place(const std::string& name) const { return {folder(), name}; }
  /// Files that this run will write and read.
  [[nodiscard]] Outputs outputs() const;
  /// Refuses to continue files of another run or layout, before any of them is touched (N3).
  void check() const;
  /// Refuses to continue files that are not as the run left them, by the checksums of MASTER.
  /// @pre check()
  void verify_checksums(const results::MasterState& master) const;
  /// Step and time [s], to the digits of the files, of the last whole record in SOL7 or SOL8 or of
  /// the last step that the listing has behind its first `print_bytes`, whichever is later; zeros
  /// when there is none.
  /// @pre check()
  [[nodiscard]] std::pair<long, double> last_stored_step(std::uintmax_t print_bytes) const;
  /// The listing alone: of a quasi-static deck.
  void open_listing();
  /// Why there is no animation although the deck asks for one; empty: there is, or none is asked.
  [[nodiscard]] std::optional<std::string> no_animation() const;
  /// All of them; continued ones behind `steps` and the listing's `print_bytes`.
  /// @param sol9_bytes likewise
  void open(bool continued, std::uintmax_t print_bytes, std::uintmax_t sol9_bytes);

  /// The files that store a step.
  struct StepTargets {
    bool plot = false, animate = false, print = false, life = false;
    [[nodiscard]] bool any() const { return plot || animate || print || life; }
  };
  /// Those whose interval the step meets, or all; the step counts as stored there. No file gets a
  /// step twice: the last step may have met an interval already.
  [[nodiscard]] StepTargets claim_targets(long step, bool always);
  /// Will RESULTS.h5 have this step, which is not yet booked? @param always in all files
  [[nodiscard]] bool will_save(long step, bool always) const;
  /// Does RESULTS.h5 get it?
  [[nodiscard]] bool saves(const StepTargets& where, long step) const {
    return all && (where.plot || where.animate) && steps.saved != step;
  }
  /// Stores an instant in SOL1-SOL8 and RESULTS.h5.
  void store(const StepTargets& where, const scene::Snapshot& at,
             const results::StepRecord& record);
  /// Steps are handed to the system many at a time, at the latest with the first one after a tenth
  /// of a second; this hands on what waits. @throws WriteError
  void flush();
  /// The run is over: RESULTS.h5 gets its final bytes from the library. RUN.json may report
  /// the end only after this, since a run that is "done" is not continued.
  /// @throws WriteError
  void close();
  /// Sizes of the files, for MASTER. @pre flush()
  [[nodiscard]] std::vector<results::MasterFileEntry> master_entries() const;

  LastStoredSteps steps;
  std::optional<listing::PrintFile> print;
  std::optional<results::H5Writer> all;      ///< RESULTS.h5
  std::optional<results::GrowingFile> user;  ///< SOL9, of user routine ADRX9
  std::vector<std::filesystem::path> written;

 private:
  [[nodiscard]] std::filesystem::path sol_path(std::size_t number) const;
  [[nodiscard]] WritePath sol_write_path(std::size_t number) const;
  [[nodiscard]] bool writes_animation() const;
  [[nodiscard]] bool writes_sol9() const;
  void flush_sol_files();  ///< SOL1 to SOL8

  const Prepared& prepared_;
  bearing::Bearing initial_bearing_;  ///< before thermal steps: RESULTS.h5 tells its geometry
  const setup::RunControl& control_;
  RunPlace place_;
  deck::UnitSystem units_;
  results::ChannelTable channels_;
  std::vector<results::SolWriter> element_writers_;  ///< SOL1..SOL6
  std::optional<results::SolWriter> sol7_writer_;    ///< SOL7
  std::optional<results::Sol8Writer> sol8_writer_;
  std::chrono::steady_clock::time_point last_flush_time_ = std::chrono::steady_clock::now();
};

/// Does an interval of steps meet this one? Never when it is 0.
[[nodiscard]] inline bool due(long step, int every) { return every > 0 && step % every == 0; }

}  // namespace adore::runs

#pragma once

#include "bearing/bearing.hpp"
#include "deck/deck.hpp"
#include "listing/print_life.hpp"
#include "listing/report.hpp"
#include "listing/static_summary.hpp"
#include "results/averages.hpp"
#include "results/channels.hpp"
#include "results/growing_file.hpp"
#include "results/run_json.hpp"
#include "scene/plan.hpp"
#include "scene/scales.hpp"
#include "scene/snapshot.hpp"
#include "statics/ball_statics.hpp"
#include "statics/friction.hpp"
#include "statics/roller_statics.hpp"
#include "statics/stiffness_table.hpp"
#include "thermal/steady_state.hpp"
#include "thermal/time_line.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// PRINT.txt (outputs.md 3): what was asked, what the bearing is, its equilibrium, the printed
/// steps, the ledgers. In the deck's units, every number with its unit. What is printed reaches the
/// file part by part.
namespace adore::listing {

/// Material of the front part.
struct FrontMatter {
  const deck::Deck& deck;
  const bearing::Bearing& bearing;
  std::optional<scene::Scales> scales;  ///< dynamic runs
  std::vector<std::pair<std::string, std::string>>
      options;  ///< named options with the values in force
};

/// Parameters of the friction of elements and races in a run.
enum class RaceFrictionModel : unsigned char {
  None,    ///< it is left out
  Curve,   ///< hypothetical traction curve: no film, no contact temperature
  OfUser,  ///< routine of the user: likewise
  Film     ///< a lubricant: 0 is a film that is not there
};

/// Which sections a step prints (kPrtOpt).
struct PrintSections {
  int element_interval = 0;  ///< 0: no section 1; n: every n-th element
  bool bodies = false, applied = false;
};
[[nodiscard]] PrintSections select_print_sections(int kPrtOpt);

class PrintFile {
 public:
  /// A new file, replacing what was there. @throws InputError
  static PrintFile create(const WritePath& place, std::string run_id, UnitSystem units);
  /// Continues a file after MASTER's length of it; checks the run code. @throws InputError
  static PrintFile continue_after(const WritePath& place, std::string run_id, UnitSystem units,
                                  std::uintmax_t bytes);

  /// The check of continue_after() alone; nothing is touched. @throws InputError
  static void check(const std::filesystem::path& path, const std::string& run_id);

  /// Step and time [s] of the last complete step within the first `bytes` of a file, or
  /// the end of a thermal step that is later; zeros when there is none.
  [[nodiscard]] static std::pair<long, double> last_stored_step(const std::filesystem::path& path,
                                                                std::uintmax_t bytes);

  /// On the headings of pages from now on, in the place of the program's version; cut at its
  /// column.
  void set_heading_version(std::string version) { heading_version_ = std::move(version); }
  /// Before steps: whether they have films, and why not.
  void set_friction_model(RaceFrictionModel friction) { friction_ = friction; }
  /// A page or part of one of texts, as user routines print them.
  void texts(std::string_view title, const std::vector<std::string>& lines, bool page);

  /// Input echo, geometry, materials, inertia, traction, initial conditions, scales, output
  /// control.
  void front(const FrontMatter& front);
  /// Operating fits, growths and clearances.
  void fits(const bearing::Bearing& bearing);
  /// The equilibrium, operating geometry and life on one page.
  void summary(const StaticSummary& summary, const bearing::Bearing& bearing,
               const life::BearingLife& life, const std::vector<std::string>& warnings);
  /// Equilibrium of elements and races.
  void quasi_static(const statics::StaticSolution& solution, const bearing::Bearing& bearing);
  void quasi_static(const statics::RollerSolution& solution, const bearing::Bearing& bearing);
  /// Friction at that equilibrium.
  void friction(const statics::FrictionEstimate& friction, const std::string& element);
  /// Temperatures that agree with it.
  void thermal(const thermal::SteadyState& steady);
  void time_line(const thermal::ThermalTransient& line);
  /// A thermal step of a run.
  void thermal_step(const thermal::BearingHeat& heat, long step, double time, bool geometry);
  /// Fatigue life at that equilibrium.
  void life(const life::BearingLife& life);
  /// Stiffness over speed (kStif); `share`: of the contact deflection, for the differences.
  void stiffness_table(const std::vector<statics::StiffnessRow>& rows, double share);
  /// One printed step: rolling elements, races and cage, applied parameters, summary, as kPrtOpt
  /// selects. `record` is the snapshot as the ChannelRecorder shows it; `life_step`: whose loads
  /// the life of the snapshot is for, when not its own.
  void step(const scene::Snapshot& snapshot, const StepRecord& record,
            const bearing::Bearing& bearing, const Averages& averages, int kPrtOpt,
            std::optional<long> life_step = {});
  /// Last page: plan, steps, conservation and cost ledgers, accuracy of the contact integrals,
  /// defaults used.
  void ledgers(const RunSummary& run, const scene::ScenePlan& plan,
               const std::optional<RunLife>& life = std::nullopt);

  [[nodiscard]] const GrowingFile& file() const noexcept { return file_; }

 private:
  PrintFile(GrowingFile file, std::string run_id, UnitSystem units)
      : file_(std::move(file)), report_(std::move(run_id), units) {}
  void flush();
  GrowingFile file_;
  Report report_;
  std::string heading_version_;  ///< empty: the program's own
  RaceFrictionModel friction_ = RaceFrictionModel::None;
};

// The parts, on any report.
void print_front_matter(Report& report, const FrontMatter& front);
void print_quasi_static(Report& report, const statics::StaticSolution& solution,
                        const bearing::Bearing& bearing);
void print_quasi_static(Report& report, const statics::RollerSolution& solution,
                        const bearing::Bearing& bearing);
/// Sizes of rollers, raceways and flanges: the part of the geometry page that balls do not have.
void print_roller_geometry(Report& report, const bearing::RollerGeometry& rollers,
                           const bearing::Envelope& envelope);
/// Common content of all quasi-static pages on the inner race: displacement and load; stiffness.
void print_race_equilibrium(Report& report, const statics::RaceResult& solution,
                            const bearing::Bearing& bearing);
void print_race_stiffness(Report& report, const statics::RaceResult& solution);
void print_stiffness_table(Report& report, const std::vector<statics::StiffnessRow>& rows,
                           double share);
void print_step(Report& report, const scene::Snapshot& snapshot, const StepRecord& record,
                const bearing::Bearing& bearing, const Averages& averages, int kPrtOpt,
                std::optional<long> life_step = {},
                RaceFrictionModel friction = RaceFrictionModel::Curve);
void print_ledgers(Report& report, const RunSummary& run, const scene::ScenePlan& plan,
                   const std::optional<RunLife>& life = std::nullopt);

}  // namespace adore::listing

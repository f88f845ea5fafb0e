#pragma once

#include "bearing/bearing.hpp"
#include "bearing/user_tables.hpp"
#include "scene/plan.hpp"
#include "scene/snapshot.hpp"
#include "scene/user_laws.hpp"
#include "user/plug_in.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// The routines of the user in one run: who is active, the lines of records 12.x, checks of every
/// answer, texts for PRINT.txt and SOL9, and the laws that the solver sees.
namespace adore::user {

struct SessionOptions {
  /// One of so many calls of routines of the right-hand side is asked twice, and compared; 0: none.
  long sample = 1024;
};

/// A hook's name, its calls and what they took, for RUN.json and the last page.
struct Use {
  int hook = 0;
  long calls = 0;
};

class Session {
 public:
  /// Calls every routine in mode ADORE_READ, in the order of their numbers.
  /// @param lines of records 12.x
  /// @throws InputError naming routine and reason, or lines that no routine has read
  Session(PlugIn plug_in, const std::vector<std::string>& lines,
          const SessionOptions& options = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] bool active(int hook) const noexcept;
  [[nodiscard]] const std::string& source() const noexcept;
  [[nodiscard]] const std::string& version() const noexcept;  ///< of the user; may be empty

  // Before the bearing is built.
  /// ADRX0. @throws InputError
  [[nodiscard]] bearing::Material material(bearing::Part part, const bearing::Material& fallback);
  /// ADRX8. @throws InputError
  void call_imperfections(bearing::UserTables& tables);
  /// ADRX5 of an element, ADRX6 of a race; mode ADORE_START comes before the first.
  /// @throws InputError
  void surface(const bearing::Bearing& bearing, bearing::UserSurface& places);
  /// ADRX5: roller k is out of round; the laws show it to the solver.
  void add_out_of_round_element(std::size_t k, std::shared_ptr<const bearing::SurfaceSeries> form);
  [[nodiscard]] bool has_out_of_round_elements() const noexcept;
  [[nodiscard]] std::span<const std::shared_ptr<const bearing::SurfaceSeries>> out_of_round()
      const noexcept;
  /// A line behind those of the routine's own documentation.
  void document(int hook, const std::string& line);

  /// Mode ADORE_START of the routines of the motion. @param traction kinds that the deck asks for
  /// @param balanced directions in which mode 2 places the inner race by its load
  /// @throws InputError
  void start(const bearing::Bearing& bearing, const std::array<bool, 5>& traction,
             const std::array<bool, 3>& balanced = {});
  /// Directions x, y, z and about them in which ADRX1 gives a load on the race at one of these
  /// times, with both races at their free places.
  [[nodiscard]] std::array<std::array<bool, 6>, 2> loads(const std::vector<double>& times);
  /// kDOF = 6.
  [[nodiscard]] const scene::SuppressedMotions& suppressed() const noexcept;
  /// Races whose accelerations ADRX1 gives.
  [[nodiscard]] const std::array<bool, 2>& drives() const noexcept;
  /// ADRX1 accelerates the base frame.
  [[nodiscard]] bool moves_frame() const noexcept;
  /// What the solver calls; as long as the session.
  [[nodiscard]] std::shared_ptr<scene::UserLaws> laws(std::shared_ptr<Session> self);

  /// Texts of the documentation calls, line by line.
  [[nodiscard]] const std::vector<std::string>& documentation() const noexcept;
  /// Mode ADORE_PRINT of all. @throws SolverError
  [[nodiscard]] std::vector<std::string> print(long step, double time);
  /// ADRX9 reads the channels of RESULTS.h5.
  [[nodiscard]] bool wants_channels() const noexcept;
  /// The channels of one step: names, values of each, all values one after the other (SI, rad).
  struct Channels {
    std::vector<const char*> name;
    std::vector<std::int32_t> size;
    std::vector<std::int64_t> first;
    std::vector<double> value;
  };
  /// Mode ADORE_STEP of all; what goes to SOL9. @throws SolverError
  [[nodiscard]] std::string step(const scene::Snapshot& snapshot, const Channels& channels = {});
  /// Mode ADORE_STEP of routines that need no snapshot. @throws SolverError
  void step(long step, double time);
  /// Text for SOL9 of the documentation call.
  [[nodiscard]] std::string take_sol9_text();

  /// Why a routine failed for good: one sentence; empty: none has.
  [[nodiscard]] const std::string& failure() const noexcept;
  /// Clause that says why routines refused states so far; empty: they did not.
  [[nodiscard]] const std::string& refusal() const noexcept;
  [[nodiscard]] std::vector<Use> uses() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace adore::user

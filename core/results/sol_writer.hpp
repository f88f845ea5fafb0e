#pragma once

#include "bearing/bearing.hpp"
#include "results/channels.hpp"
#include "results/growing_file.hpp"
#include "results/sol_file.hpp"
#include "scene/snapshot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Writers of SOL1-SOL8, to the column (outputs.md 5-7). One whole step at a time reaches the file,
/// so that it is readable at any moment. A full disk or an unwritable folder is an InputError; the
/// steps before stay.
namespace adore::results {

/// Text of the four header lines of SOL1-SOL7.
[[nodiscard]] std::string format_sol_header(const SolHeader& header);
/// Appends one stored step: the step line, then (2x,1p,8e16.7) lines (N59).
void append_sol_step(std::string& out, const SolStep& step);

/// Header of the file of one element: 1..n rolling elements, then cages, outer race, inner race; 0
/// is SOL7.
/// @throws InputError when the bearing has no such element.
[[nodiscard]] SolHeader make_sol_header(const bearing::Bearing& bearing, int index,
                                        UnitSystem units);

/// Values of one step for the file of that header, in file units.
[[nodiscard]] SolStep make_sol_step(const SolHeader& header, const std::vector<SolColumn>& columns,
                                    const StepRecord& record, UnitSystem units);

class SolWriter {
 public:
  /// A new file, replacing what was there.
  static SolWriter create(const WritePath& place, const SolHeader& header, UnitSystem units);
  /// Continues a file: checks that it belongs to the same run and layout, and truncates it to
  /// `last_step`.
  /// @throws InputError with both run codes, or the difference.
  static SolWriter continue_after(const WritePath& place, const SolHeader& header, UnitSystem units,
                                  long last_step);

  /// The checks of continue_after() alone; nothing is touched. @throws InputError
  static void check(const std::filesystem::path& path, const SolHeader& header);

  void write(const StepRecord& record);
  /// As GrowingFile's.
  void collect() noexcept { file_.collect(); }
  void flush() { file_.flush(); }
  [[nodiscard]] const GrowingFile& file() const noexcept { return file_; }

 private:
  SolWriter(GrowingFile file, SolHeader header, UnitSystem units);
  GrowingFile file_;
  SolHeader header_;
  UnitSystem units_;
  std::vector<SolColumn> columns_;
  std::string text_;
};

/// Why this bearing gets no SOL8 (N65, N66), as a sentence; empty when it gets one.
[[nodiscard]] std::optional<std::string> sol8_refusal(int elements, int cage_segments);

/// Geometry in SOL8, SI. Races are drawn at the bottom of their grooves, so that
/// balls touch the circles.
[[nodiscard]] Sol8Geometry make_sol8_geometry(const bearing::Bearing& bearing);
/// One instant, SI; angles of positions and contacts reduced to -π..π (N61).
[[nodiscard]] Sol8Frame make_sol8_frame(const scene::Snapshot& snapshot);

/// Header of SOL8 from version, run_id, bearing_type, elements, units and geometry (in file units)
/// of `file`.
[[nodiscard]] std::string format_sol8_header(const Sol8File& file);
/// Appends one frame, values in file units.
void append_sol8_frame(std::string& out, const Sol8Frame& frame);

class Sol8Writer {
 public:
  static Sol8Writer create(const WritePath& place, const bearing::Bearing& bearing,
                           UnitSystem units);
  /// As SolWriter::continue_after.
  static Sol8Writer continue_after(const WritePath& place, const bearing::Bearing& bearing,
                                   UnitSystem units, long last_step);

  static void check(const std::filesystem::path& path, const bearing::Bearing& bearing,
                    UnitSystem units);

  void write(const scene::Snapshot& snapshot);
  /// As GrowingFile's.
  void collect() noexcept { file_.collect(); }
  void flush() { file_.flush(); }
  [[nodiscard]] const GrowingFile& file() const noexcept { return file_; }

 private:
  Sol8Writer(GrowingFile file, UnitSystem units) : file_(std::move(file)), units_(units) {}
  GrowingFile file_;
  UnitSystem units_;
  std::string text_;
};

}  // namespace adore::results

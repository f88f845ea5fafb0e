#pragma once

#include "results/line_reader.hpp"
#include "results/sol_file.hpp"

#include <optional>
#include <string>

/// Step-by-step parsing of SOL1-SOL8 from any stream: under read_sol(), read_sol8(), continuation
/// and the fuzzer.
namespace adore::results {

/// A block of numbers in fixed columns, as many lines as it takes.
enum class BlockStatus : unsigned char {
  Complete,
  End,   ///< nothing more in the file
  Cut,   ///< the file ends inside
  Wrong  ///< something else stands there
};

class SolParser {
 public:
  /// Reads the header. `name` is the file's name for messages. @throws InputError when it is not a
  /// SOL1-SOL8 file.
  SolParser(std::istream& stream, std::string name);

  [[nodiscard]] SolKind kind() const noexcept { return kind_; }
  /// Of SOL1-SOL7; for SOL8 version, run_id, bearing_type, elements, units and value_count are set.
  [[nodiscard]] const SolHeader& header() const noexcept { return header_; }
  [[nodiscard]] const std::vector<double>& geometry() const noexcept {
    return geometry_;
  }  ///< SOL8 only

  /// Next stored step. `with_values` false skips its numbers (values stay empty) but still checks
  /// that all lines are there. For SOL8 only step, revolutions, time and values are set.
  BlockStatus next(SolStep& step, bool with_values = true);

  /// Why the last next() was not Complete: "cut off in step 120 (line 340)".
  [[nodiscard]] const std::string& note() const noexcept { return note_; }
  /// Empty, or the number of values so far that are stars or not finite, and the first one;
  /// they are read as NaN (stars) or unchanged.
  [[nodiscard]] std::string gaps() const;
  /// First byte after the header or the last complete step, and whether that ended with a line end.
  [[nodiscard]] std::uintmax_t complete_bytes() const noexcept { return complete_bytes_; }
  [[nodiscard]] bool ends_with_newline() const noexcept { return ends_with_newline_; }

 private:
  struct Field {
    int width, per_line;
  };
  void read_plot_header(std::string_view first, std::string_view title);
  void read_animation_header(std::string_view first, std::string_view integers);
  void read_identity(std::string_view first);
  void read_units(const std::array<int, 10>& lengths);
  std::string_view read_header_line(std::string_view what);
  [[noreturn]] void reject(const std::string& why) const;
  BlockStatus read_step_line(SolStep& step);
  /// @param step whose values they are
  BlockStatus read_values(int count, int width, long step, std::vector<double>* values);

  LineReader reader_;
  std::string name_;
  SolKind kind_ = SolKind::Element;
  SolHeader header_;
  std::vector<double> geometry_;
  std::string note_;
  long missing_count_ = 0, first_missing_step_ = 0;  ///< values, and the step of the first
  std::uintmax_t complete_bytes_ = 0;
  bool ends_with_newline_ = true;
};

/// The readers of sol_file.hpp on an open stream.
SolFile read_sol(std::istream& stream, const std::string& name, const SolRange& range);
Sol8File read_sol8(std::istream& stream, const std::string& name, const SolRange& range);

}  // namespace adore::results

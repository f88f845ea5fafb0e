#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Contents of a study as plain values: decks, variables, quantities, length of the runs.
namespace adore::studies {

/// Name and value, as `--set` and `--opt` take them.
using Settings = std::vector<std::pair<std::string, std::string>>;

enum class Kind : unsigned char {
  Sweep,        ///< grids, lists and samples of ranges: what happens
  Tolerance,    ///< Monte Carlo: percentiles of what scatter does
  CageMap,      ///< two variables, the cage's whirl over both
  Sensitivity,  ///< derivatives of every quantity over every variable
  WorstCase,    ///< search of the extreme of one quantity within ranges
  WhatIf        ///< named changes of the decks, one at a time
};
inline constexpr int kKinds = 6;
/// "sweep", "tolerance", "cage-map", "sensitivity", "worst-case", "what-if"
[[nodiscard]] std::string kind_name(Kind kind);

/// How one variable varies.
enum class Law : unsigned char {
  Values,   ///< grid or list: each value with each value of the others
  Uniform,  ///< between `a` and `b`
  Normal    ///< mean `a`, standard deviation `b`, cut at `low` and `high`
};

struct Variable {
  std::string name;                  ///< as --set writes it; "reDiaVar#": one for each element
  std::vector<std::string> targets;  ///< deck variables that take a value each: one, or the lot
  std::vector<std::string> also;     ///< deck variables that take the same value
  bool option = false;               ///< a run option (--opt), not a deck variable
  Law law = Law::Values;
  std::vector<double> values;
  double a = 0.0, b = 0.0;
  std::optional<double> low, high;
  double common = 0.0;  ///< lots: correlation of any two elements of a lot, 0 to 1
  double step = 0.0;    ///< sensitivity: difference to both sides; 0: chosen
  [[nodiscard]] bool is_group() const { return name.find('#') != std::string::npos; }
};

/// Correlation of two random variables (of their normal scores where they are not normal).
struct Correlation {
  std::string first, second;
  double value = 0.0;
};

enum class Sampling : unsigned char { Random, Latin, Sobol };

enum class Statistic : unsigned char {
  Mean,
  Rms,
  Deviation,
  Least,
  Largest,
  LargestSize,
  Span,
  Last,
  Percentile
};

/// One column of the table: a key result, a statistic of a channel, or a figure of the cage's
/// whirl.
struct Quantity {
  std::string name;     ///< of the column
  std::string channel;  ///< empty: key result or whirl figure `name`
  Statistic statistic = Statistic::Mean;
  double percent = 50.0;            ///< of Statistic::Percentile
  double from = 0.0, to = 1.0;      ///< window, shares of the run's time
  std::vector<std::size_t> places;  ///< element, race ... from 1; empty: all of them together
  std::string unit;                 ///< SI; known once the quantity is
};

struct WhatIfCase {
  std::string name;
  Settings sets, options;
};

struct Budget {
  std::optional<double> runs, hours, disk_megabytes;
};

struct Study {
  std::filesystem::path file;  ///< it was read from
  Kind kind = Kind::Sweep;
  std::vector<std::filesystem::path> decks;  ///< one, or several that are compared
  Settings sets, options;                    ///< of every run
  std::string until, integrator;             ///< empty: the deck's
  std::optional<double> tolerance;
  std::vector<Variable> variables;
  std::vector<Correlation> correlations;
  Sampling sampling = Sampling::Latin;
  long samples = 0;  ///< of the random variables
  std::uint64_t seed = 1;
  std::vector<std::uint64_t> bearing_seeds;  ///< run option `seed`, each with each point
  std::vector<Quantity> quantities;
  std::vector<double> percentiles{5.0, 50.0, 95.0};
  std::vector<WhatIfCase> cases;
  std::string objective;  ///< worst case: name of a quantity
  bool seek_largest = true;
  int rounds = 8;           ///< worst case: at most, behind the first
  bool keep_files = false;  ///< the files of every run stay
  Budget budget;

  [[nodiscard]] bool has_random_variables() const;
  /// Folder of its results: "clearance.json" -> "clearance.study" in the same folder.
  [[nodiscard]] std::filesystem::path folder() const;
};

/// @throws InputError naming file, key, value and what is valid; all mistakes of the first level
/// that has any.
[[nodiscard]] Study parse_study(const std::string& text, const std::filesystem::path& file);

/// A complete example with remarks, "sweep" ... @throws InputError naming the kinds.
[[nodiscard]] std::string example_study(const std::string& kind);

/// Elements of the deck's bearing replace the "#" of lots. @param elements nRe of the first deck
void expand_lots(Study& study, int elements);

}  // namespace adore::studies

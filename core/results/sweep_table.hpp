#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// SWEEP.csv as `adore run --set var=a:b:n` writes it, for plots.
namespace adore::results {

struct SweepColumn {
  std::string label, part;     ///< KeyResultSpec's; a column that it does not know: its heading, ""
  std::string unit;            ///< SI; empty: a pure number, or not known
  std::vector<double> values;  ///< one per run; NaN where the run gave none, or an
                               ///< infinite one
};

struct SweepTable {
  std::string variable;  ///< the deck variable that was varied
  std::string unit;      ///< of its values, the deck's; empty: a pure number
  std::vector<double> values;
  std::vector<SweepColumn> columns;  ///< key results, in the file's order
  std::size_t failed = 0;            ///< runs that ended without a result
};

/// Does the file begin with the heading of such a table?
[[nodiscard]] bool is_sweep(const std::filesystem::path& path);

/// @throws InputError when the file is not such a table.
[[nodiscard]] SweepTable read_sweep(const std::filesystem::path& path);

}  // namespace adore::results

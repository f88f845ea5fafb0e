#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Any step-by-step result file as rows of numbers: under `show` and `convert`.
namespace adore::results {

struct TableColumn {
  std::string id, label, unit;
};

struct ResultTable {
  std::vector<std::pair<std::string, std::string>> header;  ///< name and value, for `show` and JSON
  std::vector<TableColumn> columns;                         ///< step, revolutions, time ... first
  /// Hands out the next row; false at the end. Rows have columns.size() values, NaN where one is
  /// missing.
  std::function<bool(std::vector<double>& row)> next;
  /// After the last row: empty, or what is wrong with the file.
  std::function<std::string()> note;
};

[[nodiscard]] ResultTable sol_table(const std::filesystem::path& path);  ///< SOL1-SOL8
[[nodiscard]] ResultTable results_h5_table(const std::filesystem::path& path);

}  // namespace adore::results

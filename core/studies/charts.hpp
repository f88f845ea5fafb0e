#pragma once

#include "studies/study_table.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// Charts as plain data, for the picture program. Values that are not finite become null.
namespace adore::studies {

using Chart = nlohmann::ordered_json;

/// Label of a column that is a key result: the unit in its name would be next to another
/// unit on the axis ("…_Pa [GPa]"). Other columns keep their names.
[[nodiscard]] std::string words_of(const std::string& column);

struct ChartLine {
  std::string name;
  std::vector<double> x, y, low, high;
  std::vector<std::vector<long>> runs = {};  ///< behind each x
};
[[nodiscard]] Chart curves_chart(const std::string& name, const TableColumn& x,
                                 const TableColumn& y, const std::vector<ChartLine>& lines);
/// values[y][x], marks alike or empty.
[[nodiscard]] Chart heat_map(const std::string& name, const TableColumn& x, const TableColumn& y,
                             const TableColumn& of, const std::vector<double>& xs,
                             const std::vector<double>& ys,
                             const std::vector<std::vector<double>>& values,
                             const std::vector<std::vector<std::string>>& marks,
                             const std::vector<std::vector<std::vector<long>>>& runs);
/// Columns that vary. @param heavy a highlighted row; negative: none; runs: numbers of the rows
[[nodiscard]] Chart parallel_chart(const std::string& name,
                                   const std::vector<const TableColumn*>& columns, long heavy,
                                   const std::vector<long>& runs);
/// Columns that vary, for parallel_chart: as many variables as leave room for quantities in twelve
/// legible axes, then those. Quantities are never displaced by random variables.
[[nodiscard]] std::vector<const TableColumn*> parallel_chart_axes(
    const std::vector<TableColumn>& variables, const std::vector<TableColumn>& quantities);
struct Bar {
  std::string name;
  double value = 0.0, doubt = 0.0;
};
[[nodiscard]] Chart tornado(const std::string& name, const std::string& title,
                            const std::string& x_title, const std::vector<Bar>& bars);

}  // namespace adore::studies

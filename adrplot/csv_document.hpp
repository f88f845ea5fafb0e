#pragma once

#include "adrplot/plot_document.hpp"

/// Any table of numbers as CSV: measured signals, exported pages, `adore convert --to csv`.
namespace adore::adrplot {

/// Separated by commas, semicolons or tabs (the first row decides); fields may be quoted. The first
/// row is the heading "name [unit]", unless it has numbers only. Abscissa: a column named time,
/// else revolutions or rotation, else the first one. One page per column. Empty fields and texts
/// are missing values; a row of another length is left out, with a note.
/// @throws InputError for a file without two columns and two rows of numbers
[[nodiscard]] PlotDocument open_csv(const std::filesystem::path& path);

}  // namespace adore::adrplot

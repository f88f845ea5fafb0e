#pragma once

#include "adrplot/plot_document.hpp"

#include <memory>
#include <string>
#include <vector>

/// Channels computed from others: sqrt(Fy^2 + Fz^2).
namespace adore::adrplot {

/// A channel of an open file under a short name.
struct FormulaInput {
  std::string name;
  std::shared_ptr<const PlotDocument> file;
  int page = 1;
  std::size_t panel = 0;
  std::string curve;
};

struct FormulaChannel {
  std::string title, formula, unit;
  std::vector<FormulaInput> inputs;
};

/// Index of a curve of a panel by its name; the first for a name that the panel does not have.
[[nodiscard]] std::size_t curve_index(const desktop::ChartPage& page, std::size_t panel,
                                      const std::string& name);

/// The channel over the abscissa of its first input; other inputs are interpolated linearly.
/// @throws InputError for invalid formulas and inputs with another abscissa
[[nodiscard]] desktop::ChartPage formula_page(const FormulaChannel& channel,
                                              const PageOptions& options);

/// Formulas as a file with a page for each; its path is "formulas".
[[nodiscard]] PlotDocument formula_document(std::vector<FormulaChannel> channels);

}  // namespace adore::adrplot

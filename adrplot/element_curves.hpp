#pragma once

#include "adrplot/formula_document.hpp"
#include "adrplot/own_chart.hpp"

#include <optional>
#include <string>
#include <vector>

/// Curves of rolling elements in user-defined charts and formulas, which follow the element that is
/// selected in another window. No Qt.
namespace adore::adrplot {

/// Number of the rolling element of a file; 0: of another body, or of several elements.
[[nodiscard]] int element_of(const PlotDocument& file);
/// Number of the rolling element of a curve by its name, else by its file; 0: of another body.
[[nodiscard]] int element_of_curve(const PlotDocument& file, const std::string& curve);

/// The same curves of another element, from the same RESULTS.h5 or from the file of that element
/// in the same run among the `open` files. Curves of other bodies stay.
/// Nothing if the chart has curves of no or of several elements, if it already shows this element,
/// or if a curve of this element is not available.
[[nodiscard]] std::optional<UserChart> chart_of_element(
    const UserChart& chart, int number, const std::vector<const PlotDocument*>& open);
[[nodiscard]] std::optional<FormulaChannel> formula_of_element(
    const FormulaChannel& channel, int number, const std::vector<const PlotDocument*>& open);

/// Draws the curves of an element thick and shows them, on a page with curves of several elements.
/// False: another page.
bool emphasize_element(desktop::ChartPage& page, int number);

}  // namespace adore::adrplot

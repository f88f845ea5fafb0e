#pragma once

#include <cstddef>
#include <string>

/// A number as a cell of a PRINT table shows it: "%.5g", right-justified. A section of 18 balls has
/// a thousand cells, for which a general printer takes most of its time.
namespace adore::listing {

/// Appends `value` with five significant digits and without trailing zeros, behind blanks up to
/// `width` columns; "-" for NaN, 0 without a sign. A longer text is not cut.
void append_cell(std::string& line, double value, std::size_t width);

}  // namespace adore::listing

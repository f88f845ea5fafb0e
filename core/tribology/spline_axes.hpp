#pragma once

#include "tribology/laws/spline_axis.hpp"

#include <cstddef>
#include <vector>

/// Making of the splines that laws of traction read (laws/spline_axis.hpp).
namespace adore::tribology {

/// Axis of a spline through `values` values from `from` to `to`, both ends among them; its
/// coefficients are one more at each end.
[[nodiscard]] SplineAxis spline_axis(double from, double to, std::size_t values);
/// Index of value k, or `beyond` steps after it.
[[nodiscard]] double spline_abscissa(const SplineAxis& axis, std::size_t k, double beyond = 0.0);

/// Values v[first + (k + 1) stride], k = 0 ... n - 1, become the coefficients v[first + k stride],
/// k = 0 ... n + 1, of the spline through them, its third derivative continuous at the second place
/// from each end (quadratic ends: c = 3 c' - 3 c'' + c''').
void values_to_spline_coefficients(std::vector<double>& v, std::size_t first, std::size_t stride,
                                   std::size_t n);

/// One cell of a surface for single precision: its 16 powers (base/single.hpp), where one load
/// takes them.
struct alignas(64) Tile {
  float power[16];
};
using Tiles = std::vector<Tile>;

/// Of all cells of `sheets` tables of splines that follow each other, `lines` and `line`
/// coefficients along each: cell (i, j) behind (i, j - 1), that of all sheets together.
[[nodiscard]] Tiles make_tiles(const double* table, std::size_t lines, std::size_t line,
                               std::size_t sheets = 1);

}  // namespace adore::tribology

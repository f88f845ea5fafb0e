#include "tribology/spline_axes.hpp"

namespace adore::tribology {

SplineAxis spline_axis(double from, double to, std::size_t values) {
  return {static_cast<int>(values) + 2, from, static_cast<double>(values - 1) / (to - from)};
}
double spline_abscissa(const SplineAxis& axis, std::size_t k, double beyond) {
  return axis.from + (static_cast<double>(k) + beyond) / axis.inverse_step;
}

void values_to_spline_coefficients(std::vector<double>& v, std::size_t first, std::size_t stride,
                                   std::size_t n) {
  // (c[k-1] + 4 c[k] + c[k+1])/6 = v[k]. With such ends the equations of the first and last value
  // become v[0] = (6 c1 - 2 ... )/6; the ends are found from their neighbors instead: unknown
  // second differences d[k] = c[k-1] - 2 c[k] + c[k+1], c[k] = v[k] - d[k]/6, d[0] = 2 d[1] - d[2].
  std::vector<double> value(n), d(n, 0.0), upper(n, 0.0), right(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) value[k] = v[first + (k + 1) * stride];
  // d[k-1] + 4 d[k] + d[k+1] = 6 (v[k-1] - 2 v[k] + v[k+1]), 0 < k < n - 1.
  for (std::size_t k = 1; k + 1 < n; ++k) {
    double below = 1.0, middle = 4.0, above = 1.0;
    if (k == 1) middle = 6.0, above = 0.0, below = 0.0;
    if (k + 2 == n) middle = 6.0, below = 0.0, above = 0.0;
    const double b = 6.0 * (value[k - 1] - 2.0 * value[k] + value[k + 1]);
    const double pivot = middle - below * upper[k - 1];
    upper[k] = above / pivot;
    right[k] = (b - below * right[k - 1]) / pivot;
  }
  for (std::size_t k = n - 2; k >= 1; --k)
    d[k] = right[k] - upper[k] * (k + 2 < n ? d[k + 1] : 0.0);
  d[0] = 2.0 * d[1] - d[2];
  d[n - 1] = 2.0 * d[n - 2] - d[n - 3];
  std::vector<double> c(n + 2, 0.0);
  for (std::size_t k = 0; k < n; ++k) c[k + 1] = value[k] - d[k] / 6.0;
  c[0] = d[0] + 2.0 * c[1] - c[2];
  c[n + 1] = d[n - 1] + 2.0 * c[n] - c[n - 1];
  for (std::size_t k = 0; k < n + 2; ++k) v[first + k * stride] = c[k];
}

Tiles make_tiles(const double* table, std::size_t lines, std::size_t line, std::size_t sheets) {
  // Coefficients of the powers of f in the four weights of spline_axis.hpp.
  constexpr double kPower[4][4] = {{1.0 / 6.0, -0.5, 0.5, -1.0 / 6.0},
                                   {2.0 / 3.0, 0.0, -1.0, 0.5},
                                   {1.0 / 6.0, 0.5, 0.5, -0.5},
                                   {0.0, 0.0, 0.0, 1.0 / 6.0}};
  Tiles tiles;
  tiles.reserve((lines - 3) * (line - 3) * sheets);
  for (std::size_t i = 0; i + 3 < lines; ++i)
    for (std::size_t j = 0; j + 3 < line; ++j)
      for (std::size_t sheet = 0; sheet < sheets; ++sheet) {
        const double* const from = table + sheet * lines * line + i * line + j;
        Tile& tile = tiles.emplace_back();
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t l = 0; l < 4; ++l) {
            double sum = 0.0;
            for (std::size_t a = 0; a < 4; ++a)
              for (std::size_t b = 0; b < 4; ++b)
                sum += kPower[a][k] * kPower[b][l] * from[a * line + b];
            tile.power[4 * k + l] = static_cast<float>(sum);
          }
      }
  return tiles;
}

}  // namespace adore::tribology

#include "user/table.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace adore::user {

MonotoneTable::MonotoneTable(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(x_.size(), 0.0) {
  const std::size_t n = x_.size();
  std::vector<double> secant(n - 1);
  for (std::size_t k = 0; k + 1 < n; ++k) secant[k] = (y_[k + 1] - y_[k]) / (x_[k + 1] - x_[k]);
  slope_.front() = secant.front();
  slope_.back() = secant.back();
  for (std::size_t k = 1; k + 1 < n; ++k)
    slope_[k] = secant[k - 1] * secant[k] > 0.0 ? 0.5 * (secant[k - 1] + secant[k]) : 0.0;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    if (secant[k] == 0.0) {
      slope_[k] = slope_[k + 1] = 0.0;
      continue;
    }
    const double a = slope_[k] / secant[k], b = slope_[k + 1] / secant[k];
    const double length = std::hypot(a, b);
    if (length <= 3.0) continue;
    slope_[k] = 3.0 * a / length * secant[k];
    slope_[k + 1] = 3.0 * b / length * secant[k];
  }
}

double MonotoneTable::operator()(double x) const noexcept {
  if (!(x > x_.front())) return y_.front();
  if (x >= x_.back()) return y_.back();
  const auto above = std::upper_bound(x_.begin(), x_.end(), x);
  const auto k = static_cast<std::size_t>(above - x_.begin()) - 1;
  const double h = x_[k + 1] - x_[k], t = (x - x_[k]) / h, s = 1.0 - t;
  return s * s * ((1.0 + 2.0 * t) * y_[k] + t * h * slope_[k]) +
         t * t * ((1.0 + 2.0 * s) * y_[k + 1] - s * h * slope_[k + 1]);
}

MonotoneTable read_table(const std::filesystem::path& file) {
  std::vector<double> x, y;
  std::istringstream lines(read_text_file(file, kMaxHandwrittenBytes));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
    std::istringstream words(line);
    double a = 0.0, b = 0.0;
    if (line.find_first_not_of(" \r") == std::string::npos || line.front() == '#') continue;
    if (!(words >> a >> b)) {
      if (x.empty()) continue;  // a heading
      throw InputError(
          fmt::format("{}:{}: \"{}\" is not a line of two numbers", file.string(), number, line));
    }
    if (!std::isfinite(a) || !std::isfinite(b) || (!x.empty() && !(a > x.back())))
      throw InputError(
          fmt::format("{}:{}: the first column must increase, but {:g} comes after {:g}",
                      file.string(), number, a, x.empty() ? 0.0 : x.back()));
    x.push_back(a);
    y.push_back(b);
    if (x.size() > kMaxTableRows)
      throw InputError(fmt::format("{}: a table has at most {} lines. Shorten the table.",
                                   file.string(), kMaxTableRows));
  }
  if (x.size() < 2)
    throw InputError(
        fmt::format("{}: a table needs at least two lines of two numbers, such as \"0.0, 0.0\" and "
                    "\"0.5, 0.06\"",
                    file.string()));
  return {std::move(x), std::move(y)};
}

}  // namespace adore::user

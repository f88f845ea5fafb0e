#pragma once

#include <filesystem>
#include <vector>

/// Values over one variable, interpolated without overshoot: between its points the curve is
/// monotone where they are, so that a traction table gets no waves that nobody measured.
namespace adore::user {

class MonotoneTable {
 public:
  /// Cubic pieces with the slopes of Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238;
  /// beyond the ends the last value. @param x ascending, two values or more
  MonotoneTable(std::vector<double> x, std::vector<double> y);
  [[nodiscard]] double operator()(double x) const noexcept;

 private:
  std::vector<double> x_, y_, slope_;
};

/// Two columns, separated by commas, semicolons or blanks; lines that do not begin with a number
/// are skipped at the top and when they begin with #.
/// @throws InputError naming file and line
[[nodiscard]] MonotoneTable read_table(const std::filesystem::path& file);

}  // namespace adore::user

#include "adrplot/abscissa.hpp"

#include <algorithm>
#include <cmath>

namespace adore::adrplot {

std::vector<double> accumulated_revolutions(const results::SolFile& file) {
  std::vector<double> turns;
  turns.reserve(file.steps.size());
  double sum = file.steps.empty() ? 0.0 : std::abs(file.steps.front().revolutions);
  double last = file.steps.empty() ? 0.0 : file.steps.front().revolutions;
  for (const auto& step : file.steps) {
    if (std::isfinite(step.revolutions)) {
      sum += std::abs(step.revolutions - last);
      last = step.revolutions;
    }
    turns.push_back(sum);
  }
  return turns;
}

bool has_reversals(const results::SolFile& file) {
  constexpr double kLeast = 1e-3;  // turns
  double forth = 0.0, back = 0.0, last = std::nan("");
  for (const auto& step : file.steps) {
    if (!std::isfinite(step.revolutions)) continue;
    if (std::isfinite(last))
      (step.revolutions > last ? forth : back) += std::abs(step.revolutions - last);
    last = step.revolutions;
  }
  return std::min(forth, back) > kLeast;
}

void set_abscissa(desktop::ChartPage& page, const results::SolFile& file, Abscissa abscissa) {
  constexpr double kLeastTurn = 1e-9;
  if (abscissa == Abscissa::Revolutions) {
    page.x = accumulated_revolutions(file);
    page.x_title = "Bearing rotation";
    page.x_unit = "rev";
    if (page.x.size() < 2 || page.x.back() - page.x.front() > kLeastTurn) return;
    page.note += std::string(page.note.empty() ? "" : " ") +
                 "The races do not rotate relative to each other, so the abscissa is time.";
    abscissa = Abscissa::Time;
  }
  page.x.clear();
  for (const auto& step : file.steps)
    page.x.push_back(abscissa == Abscissa::Time ? step.time : static_cast<double>(step.step));
  page.x_title = abscissa == Abscissa::Time ? "Time" : "Step";
  page.x_unit = abscissa == Abscissa::Time ? "s" : "";
}

}  // namespace adore::adrplot

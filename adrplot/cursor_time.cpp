#include "adrplot/cursor_time.hpp"

#include "adrplot/own_chart.hpp"

#include <algorithm>
#include <cmath>

namespace adore::adrplot {
namespace {

/// Abscissa and times of the run, point by point; nothing: the abscissa is not one of a run.
struct Course {
  const std::vector<double>*abscissa = nullptr, *times = nullptr;
};
Course course_of(const desktop::ChartPage& page, const RunMotion& motion) {
  const bool plane = page.equal_axes;
  const std::string& title = plane ? page.along_title : page.x_title;
  const std::vector<double>& places = plane ? page.along : page.x;
  if (title == "Time") return {&places, &places};
  if (title == "Bearing rotation") return {&motion.turns, &motion.times};
  if (title == "Step" && places.size() == motion.times.size()) return {&places, &motion.times};
  return {};
}

std::optional<double> value_at(const std::vector<double>& x, const std::vector<double>& y,
                               double place) {
  if (x.empty() || x.size() != y.size() || !std::isfinite(place)) return std::nullopt;
  const double value = interpolated_values(x, y, {std::clamp(place, x.front(), x.back())}).front();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<double> time_of_cursor(const desktop::ChartPage& page, const RunMotion& motion,
                                     double abscissa) {
  const Course course = course_of(page, motion);
  return course.times ? value_at(*course.abscissa, *course.times, abscissa) : std::nullopt;
}

std::optional<double> cursor_at_time(const desktop::ChartPage& page, const RunMotion& motion,
                                     double time) {
  const Course course = course_of(page, motion);
  return course.times ? value_at(*course.times, *course.abscissa, time) : std::nullopt;
}

}  // namespace adore::adrplot

#include "contact/sliced_line.hpp"

#include "base/errors.hpp"
#include "contact/race_surface.hpp"

#include <fmt/format.h>

namespace adore::contact {

SlicedLine sliced_line(const RollerProfile& profile, int count, double line_constant,
                       double land_width, double land_offset) {
  const Slicing cut = slicing(profile, count);
  SlicedLine line;
  line.law = power_law(line_constant, cut.effective_length);
  for (int k = 0; k < count; ++k) {
    const double x = cut.centre(k);
    line.x.push_back(x);
    line.width.push_back(overlap_width(x, cut.width, land_offset, land_width));
    line.drop.push_back(profile_drop(profile, x));
  }
  return line;
}

LineResultant line_resultant(const SlicedLine& line, double delta0, double slope) noexcept {
  LineResultant sum;
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    const double x = line.x[k], delta = delta0 + slope * x - line.drop[k];
    sum.add(x, delta, slice_load(line.law, line.width[k], delta));
  }
  return sum;
}

double approach_for_load(const SlicedLine& line, double slope, double load) {
  double width = 0.0, highest = 0.0;
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    if (line.width[k] <= 0.0) continue;
    width += line.width[k];
    highest = std::max(highest, line.drop[k] - slope * line.x[k]);
  }
  if (!(load > 0.0 && width > 0.0))
    throw InputError(fmt::format(
        "sliced roller: load {} N and width on the land {} m must both be positive", load, width));
  // With every slice at least this deep the load is at least Q.
  double delta0 = highest + std::pow(load / (line.law.constant * width), 0.9);
  for (int n = 0; n < 200; ++n) {
    const LineResultant now = line_resultant(line, delta0, slope);
    const double step = (load - now.load) / now.load_by_approach;
    delta0 += step;
    if (std::abs(step) <= 1e-15 * std::abs(delta0)) return delta0;
  }
  throw SolverError(fmt::format(
      "sliced roller: the approach for a load of {} N did not converge within 200 steps", load));
}

}  // namespace adore::contact

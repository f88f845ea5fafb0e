#include "setup/surface_table.hpp"

#include "contact/groove.hpp"
#include "contact/roller_profile.hpp"
#include "contact/roller_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::setup {
namespace {

constexpr std::size_t kN = kTableAround;
constexpr double kStepPsi = 2.0 * std::numbers::pi / kTableAround;
constexpr double kRad = std::numbers::pi / 180.0;
constexpr double kStepPhi = 2.0 * kTableReach * kRad / (kTableAcross - 1);

double angle_of_row(std::size_t m) {
  return -kTableReach * kRad + static_cast<double>(m) * kStepPhi;
}

/// ∫ D Δf(t) sin(φ - t) dt from `nominal` to each angle, by trapezia; row by row in place.
void bend(std::vector<double>& rows, const std::vector<double>& angle, double nominal,
          double diameter) {
  const std::size_t many = angle.size();
  std::vector<double> c(many), s(many);
  for (std::size_t i = 0; i < kN; ++i) {
    c[0] = s[0] = 0.0;
    for (std::size_t m = 1; m < many; ++m) {
      const double a = rows[(m - 1) * kN + i], b = rows[m * kN + i];
      const double half = 0.5 * (angle[m] - angle[m - 1]);
      c[m] = c[m - 1] + half * (a * std::cos(angle[m - 1]) + b * std::cos(angle[m]));
      s[m] = s[m - 1] + half * (a * std::sin(angle[m - 1]) + b * std::sin(angle[m]));
    }
    const auto next = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        std::upper_bound(angle.begin(), angle.end(), nominal) - angle.begin(), 1,
        static_cast<std::ptrdiff_t>(many) - 1));
    const double t = (nominal - angle[next - 1]) / (angle[next] - angle[next - 1]);
    const double c0 = (1.0 - t) * c[next - 1] + t * c[next];
    const double s0 = (1.0 - t) * s[next - 1] + t * s[next];
    for (std::size_t m = 0; m < many; ++m)
      rows[m * kN + i] =
          diameter * (std::sin(angle[m]) * (c[m] - c0) - std::cos(angle[m]) * (s[m] - s0));
  }
}

std::vector<double> row_of(const std::vector<double>& rows, std::size_t m) {
  const auto first = rows.begin() + static_cast<std::ptrdiff_t>(m * kN);
  return {first, first + kTableAround};
}
void put_row(std::vector<double>& rows, std::size_t m, const std::vector<double>& row) {
  std::copy(row.begin(), row.end(), rows.begin() + static_cast<std::ptrdiff_t>(m * kN));
}

/// Rolls over every row along ψ; what `also` holds is that of the place touched.
void roll_around(std::vector<double>& rows, std::size_t m, double cost, std::vector<double>& also) {
  std::vector<std::size_t> from;
  put_row(rows, m, moreau_envelope(row_of(rows, m), cost, true, &from));
  if (also.empty()) return;
  const std::vector<double> before = row_of(also, m);
  for (std::size_t i = 0; i < kN; ++i) also[m * kN + i] = before[from[i]];
}

}  // namespace

std::vector<double> surface_table_axial_positions(const bearing::Bearing& b, std::size_t race,
                                                  int slices) {
  std::vector<double> out;
  if (const bearing::RollerGeometry* const rollers = b.rollers()) {
    const contact::Slicing slicing =
        contact::slicing(contact::roller_profile(*rollers, bearing::RollerDeviation{}), slices);
    for (int k = 0; k < slices; ++k) out.push_back(slicing.centre(k));
    return out;
  }
  const double groove = b.balls().groove_factor[race] * b.balls().diameter;
  for (std::size_t m = 0; m < kTableAcross; ++m) out.push_back(groove * std::sin(angle_of_row(m)));
  return out;
}

std::vector<double> moreau_envelope(const std::vector<double>& values, double cost, bool closed,
                                    std::vector<std::size_t>* from) {
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto reach = static_cast<std::ptrdiff_t>(
      std::min(std::ceil(std::sqrt((*high - *low) / cost)), 0.5 * static_cast<double>(n)));
  const auto at = [&](std::ptrdiff_t j) {
    return closed ? (j % n + n) % n : std::clamp<std::ptrdiff_t>(j, 0, n - 1);
  };
  const auto value = [&](std::ptrdiff_t j) { return values[static_cast<std::size_t>(at(j))]; };
  std::vector<double> out(values.size());
  if (from != nullptr) from->resize(values.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    double least = value(i);
    std::ptrdiff_t where = i;
    for (std::ptrdiff_t j = i - reach; j <= i + reach; ++j) {
      if (!closed && (j < 0 || j >= n)) continue;
      const double way = static_cast<double>(i - j), here = value(j) + cost * way * way;
      if (here < least) {
        least = here;
        where = j;
      }
    }
    // Where the surface is smooth the least is between places: of the parabola through three.
    const bool inside = closed || (where > 0 && where < n - 1);
    const double curve = value(where - 1) - 2.0 * value(where) + value(where + 1);
    if (inside && std::abs(curve) < cost) {
      const double before = static_cast<double>(i - where + 1), after = before - 2.0;
      const double slope = 0.5 * (value(where + 1) + cost * after * after - value(where - 1) -
                                  cost * before * before);
      least -= 0.5 * slope * slope / (curve + 2.0 * cost);
    }
    out[static_cast<std::size_t>(i)] = least;
    if (from != nullptr) (*from)[static_cast<std::size_t>(i)] = static_cast<std::size_t>(at(where));
  }
  return out;
}

std::vector<double> spline_coefficients(const std::vector<double>& values, bool closed) {
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  std::vector<double> out(values.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto value = [&](std::ptrdiff_t j) {
      if (closed) return values[static_cast<std::size_t>((j % n + n) % n)];
      if (j < 0) return 2.0 * values[0] - values[1];
      if (j >= n)
        return 2.0 * values[static_cast<std::size_t>(n - 1)] -
               values[static_cast<std::size_t>(n - 2)];
      return values[static_cast<std::size_t>(j)];
    };
    out[static_cast<std::size_t>(i)] = (8.0 * value(i) - value(i - 1) - value(i + 1)) / 6.0;
  }
  return out;
}

void convert_to_spline_coefficients(std::vector<double>& rows, std::size_t around, bool across) {
  const std::size_t many = rows.size() / around;
  std::vector<double> line(around);
  for (std::size_t m = 0; m < many; ++m) {
    std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(m * around), around, line.begin());
    line = spline_coefficients(line, true);
    std::copy(line.begin(), line.end(), rows.begin() + static_cast<std::ptrdiff_t>(m * around));
  }
  if (!across) return;
  line.resize(many);
  for (std::size_t i = 0; i < around; ++i) {
    for (std::size_t m = 0; m < many; ++m) line[m] = rows[m * around + i];
    const std::vector<double> column = spline_coefficients(line, false);
    for (std::size_t m = 0; m < many; ++m) rows[m * around + i] = column[m];
  }
}

bearing::SurfaceTable build_surface_table(const bearing::Bearing& b, std::size_t race,
                                          const std::vector<double>& places,
                                          const std::vector<double>& radius,
                                          const std::vector<double>& factor) {
  const double side = race == bearing::kOuter ? 1.0 : -1.0;
  const bearing::RollerGeometry* const rollers = b.rollers();
  bearing::SurfaceTable out;
  out.around = kTableAround;
  out.across = static_cast<int>(places.size());
  out.height.assign(radius.size(), 0.0);
  const double R = 0.5 * b.element_diameter();
  std::vector<double> angle;
  double nominal = 0.0, bend_diameter = 0.0, groove_radius = 0.0;
  if (rollers == nullptr) {
    out.first = angle_of_row(0);
    out.step = kStepPhi;
    for (std::size_t m = 0; m < places.size(); ++m) angle.push_back(angle_of_row(m));
    nominal = side * b.balls().contact_angle;
    bend_diameter = b.balls().diameter;
    groove_radius = b.balls().groove_factor[race] * bend_diameter;
  } else {
    groove_radius = 2.0 * rollers->groove_factor[race] * rollers->crown_radius;
    bend_diameter = 2.0 * rollers->crown_radius;
    for (const double s : places)
      angle.push_back(rollers->groove_factor[race] > 0.0 ? std::asin(s / groove_radius)
                                                         : rollers->race_angle[race]);
  }
  if (!factor.empty()) {
    out.height = factor;
    bend(out.height, angle, nominal, bend_diameter);
  }
  for (std::size_t m = 0; m < places.size(); ++m)
    for (std::size_t i = 0; i < kN; ++i)
      out.height[m * kN + i] += side * std::cos(angle[m]) * radius[m * kN + i];
  out.factor = rollers == nullptr ? factor : std::vector<double>{};
  // Rolled over by the element: along ψ, then along φ (the farness of a point is their sum).
  const contact::GrooveGeometry groove =
      rollers == nullptr ? contact::groove_geometry(b.balls()) : contact::GrooveGeometry{};
  for (std::size_t m = 0; m < places.size(); ++m) {
    const double n_e = side * std::cos(angle[m]);
    const double from_axis = rollers == nullptr ? groove.centre_radius[race] + groove_radius * n_e
                                                : rollers->race_radius(static_cast<int>(race));
    const double per_length = from_axis * kStepPsi;
    const double cost = 0.5 * per_length * per_length * (1.0 / R - n_e / from_axis);
    roll_around(out.height, m, cost, out.factor);
  }
  if (rollers == nullptr) {
    const double offset = groove_radius - R;
    const double cost = 0.5 * kStepPhi * kStepPhi * groove_radius * offset / R;
    std::vector<double> column(places.size()), also(places.size());
    std::vector<std::size_t> from;
    for (std::size_t i = 0; i < kN; ++i) {
      for (std::size_t m = 0; m < places.size(); ++m) column[m] = out.height[m * kN + i];
      const std::vector<double> rolled = moreau_envelope(column, cost, false, &from);
      for (std::size_t m = 0; m < places.size(); ++m) out.height[m * kN + i] = rolled[m];
      if (out.factor.empty()) continue;
      for (std::size_t m = 0; m < places.size(); ++m) also[m] = out.factor[from[m] * kN + i];
      for (std::size_t m = 0; m < places.size(); ++m) out.factor[m * kN + i] = also[m];
    }
  }
  convert_to_spline_coefficients(out.height, kN, rollers == nullptr);
  if (!out.factor.empty()) convert_to_spline_coefficients(out.factor, kN, true);
  return out;
}

}  // namespace adore::setup

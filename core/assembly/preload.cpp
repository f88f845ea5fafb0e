#include "assembly/preload.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace adore::assembly {
namespace {

constexpr std::array<double, 5> kNoLoad{};
/// Part of the contact load without external load that counts as none.
constexpr double kNoLoadShare = 1e-9;

/// Mean offset of the rows of one orientation.
double mean_offset(const BearingSet& set, int orientation) {
  double sum = 0.0;
  int count = 0;
  for (const BearingSetRow& row : set.rows)
    if (row.orientation == orientation) {
      sum += row.offset;
      ++count;
    }
  return sum / count;
}

/// Shaft held at u_x, no other load.
BearingSetState held_at(const BearingSet& set, double x, const Vec5& start) {
  statics::RaceLoadCase task;
  task.given[0] = true;
  Vec5 q = start;
  q(0) = x;
  return solve_bearing_set(set, task, q).state;
}

/// Sum of the displacements of single rows that share the force, less the offsets they have.
double first_guess(const BearingSet& set, double force) {
  double out = -total_offset(set);
  for (const int orientation : {1, -1}) {
    const auto count =
        std::count_if(set.rows.begin(), set.rows.end(),
                      [&](const BearingSetRow& row) { return row.orientation == orientation; });
    double sum = 0.0;
    for (const BearingSetRow& row : set.rows)
      if (row.orientation == orientation)
        sum += row.model.under_thrust(force / static_cast<double>(count));
    out += sum / static_cast<double>(count);
  }
  for (const double c : set.compliance) out += c * force;
  return out;
}

/// Secant search for the displacement that ends the last contact at the inner race of row k, on
/// (Q/Q_0)^(1/n) of the largest contact load Q, which is linear where Q ~ δ^n.
std::optional<Unloading> unloading_of(const BearingSet& set, const BearingSetState& unloaded,
                                      std::size_t k, const std::function<void()>& poll) {
  const RowState& row = unloaded.elements[k];
  if (!(row.inner_load > 0.0) || !(axial_load(row) > 0.0)) return std::nullopt;
  const double n = set.rows[k].model.rollers() ? 10.0 / 9.0 : 1.5;
  const double start = unloaded.q(0), approach = n * axial_load(row) / row.stiffness(0, 0);
  if (!(approach > 0.0) || !std::isfinite(approach)) return std::nullopt;
  BearingSetState at = unloaded;
  const auto root_at = [&](double way) {
    poll();
    at = held_at(set, start - set.rows[k].orientation * way, at.q);
    const double share = at.elements[k].inner_load / row.inner_load;
    return share > kNoLoadShare ? std::pow(share, 1.0 / n) : 0.0;
  };
  double loaded = 0.0, root = 1.0, slope = -1.0 / approach;
  double free = std::numeric_limits<double>::infinity(), next = 0.9 * approach;
  for (int count = 0; count < 80 && loaded < 20.0 * approach; ++count) {
    if (const double value = root_at(next); value > 0.0) {
      slope = std::min((value - root) / (next - loaded), -0.1 / approach);
      loaded = next;
      root = value;
    } else {
      free = next;
    }
    if (root < 1e-5 || free - loaded < 1e-7 * approach)
      return Unloading{k, at.load(0), at.q(0) - start};
    next = loaded - root / slope;
    if (!(next < free)) next = 0.5 * (loaded + free);
  }
  return std::nullopt;
}

}  // namespace

bool has_opposed_rows(const BearingSet& set) {
  return std::any_of(set.rows.begin(), set.rows.end(), [&](const BearingSetRow& row) {
    return row.orientation != set.rows.front().orientation;
  });
}

void set_offsets(BearingSet& set, const Assembly& assembly, double more) {
  const std::vector<double> shifts = spacer_shifts(assembly);
  for (std::size_t k = 0; k < set.rows.size(); ++k)
    set.rows[k].offset = assembly.rows[k].offset + set.rows[k].orientation * shifts[k] + 0.5 * more;
}

double total_offset(const BearingSet& set) { return mean_offset(set, 1) + mean_offset(set, -1); }

double preload_force(const BearingSet& set, const BearingSetState& state) {
  double out = 0.0;
  for (std::size_t k = 0; k < set.rows.size(); ++k)
    if (set.rows[k].orientation > 0) out += axial_load(state.elements[k]);
  return out;
}

double offset_for_force(BearingSet set, const Assembly& assembly, double force) {
  set_offsets(set, assembly, 0.0);
  Vec5 last = Vec5::Zero();
  const auto surplus = [&](double more) {
    set_offsets(set, assembly, more);
    const BearingSetSolution found = solve_bearing_set(set, kNoLoad, last);
    last = found.state.q;
    return preload_force(set, found.state) - force;
  };
  const auto give_up = [&] {
    throw SolverError(
        fmt::format("preload of the set: {:.4g} N cannot be reached with any offset. Check the "
                    "offsets of the rows "
                    "and the lengths of the spacers",
                    force));
  };
  const double guess = first_guess(set, force);
  double high = guess, at_high = surplus(high), low = high, at_low = at_high;
  double step = std::max(0.02 * std::abs(guess), 1e-8);
  for (int n = 0; at_high < 0.0; ++n, step *= 2.0) {
    if (n == 40) give_up();
    low = high;
    at_low = at_high;
    high += step;
    at_high = surplus(high);
  }
  step = std::max(0.02 * std::abs(guess), 1e-8);
  for (int n = 0; at_low > 0.0; ++n, step *= 2.0) {
    if (n == 40) give_up();
    high = low;
    at_high = at_low;
    low -= step;
    at_low = surplus(low);
  }
  const bool friction = std::any_of(set.rows.begin(), set.rows.end(), [](const BearingSetRow& row) {
    return row.model.has_friction();
  });
  const double accuracy = friction ? 1e-6 : 1e-9;
  // False position with halved ends (Illinois).
  int side = 0;
  for (int n = 0; n < 100; ++n) {
    if (high == low || at_high == at_low) return high;
    const double next = (low * at_high - high * at_low) / (at_high - at_low);
    const double value = surplus(next);
    if (std::abs(value) <= accuracy * force || std::abs(high - low) < 1e-15) return next;
    if (value > 0.0) {
      high = next;
      at_high = value;
      if (side > 0) at_low *= 0.5;
      side = 1;
    } else {
      low = next;
      at_low = value;
      if (side < 0) at_high *= 0.5;
      side = -1;
    }
  }
  give_up();
  return 0.0;
}

std::vector<Unloading> unloading_forces(const BearingSet& set, const BearingSetState& unloaded,
                                        const std::function<void()>& poll) {
  std::vector<Unloading> out;
  for (std::size_t k = 0; k < set.rows.size(); ++k) try {
      if (const auto one = unloading_of(set, unloaded, k, poll)) out.push_back(*one);
    } catch (const SolverError&) {  // nothing supports the shaft so far away: not computed
    }
  return out;
}

std::vector<AxialCurvePoint> axial_curve(const BearingSet& set, const BearingSetState& unloaded,
                                         const std::vector<Unloading>& unloading, int points,
                                         const std::function<void()>& poll) {
  double first = 0.0, last = 0.0;  // displacements of the nearest unloading to either side
  for (const Unloading& one : unloading) {
    double& end = one.displacement < 0.0 ? first : last;
    if (end == 0.0 || std::abs(one.displacement) < std::abs(end)) end = one.displacement;
  }
  std::vector<AxialCurvePoint> out;
  if (!(first < 0.0 && last > 0.0) || !has_opposed_rows(set)) return out;
  Vec5 near = unloaded.q;
  for (int n = 0; n < points; ++n) {
    poll();
    const double u = 1.25 * (first + (last - first) * n / (points - 1));
    const BearingSetState at = held_at(set, unloaded.q(0) + u, near);
    near = at.q;
    AxialCurvePoint point{u, at.load(0), at.stiffness(0, 0), {}};
    for (const RowState& row : at.elements) point.row_load.push_back(axial_load(row));
    out.push_back(std::move(point));
  }
  return out;
}

std::vector<PreloadPoint> preload_curve(const BearingSet& set, int points,
                                        const std::function<void()>& poll) {
  std::vector<PreloadPoint> out;
  const double now = has_opposed_rows(set) ? total_offset(set) : 0.0;
  if (!(now > 0.0)) return out;
  Vec5 near = Vec5::Zero();
  for (int n = 1; n <= points; ++n) {
    poll();
    BearingSet moved = set;
    const double offset = 1.5 * now * n / points;
    for (BearingSetRow& row : moved.rows) row.offset += 0.5 * (offset - now);
    const BearingSetState at = solve_bearing_set(moved, kNoLoad, near).state;
    near = at.q;
    out.push_back({offset, preload_force(moved, at), at.stiffness(0, 0)});
  }
  return out;
}

}  // namespace adore::assembly

#include "assembly/set_statics.hpp"

#include "base/errors.hpp"
#include "statics/race_text.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::assembly {
namespace {

using Vec3 = Eigen::Vector3d;
using Row5 = Eigen::Matrix<double, 1, 5>;

/// Axis of the shaft a = R e_x with its derivatives.
struct ShaftAxis {
  explicit ShaftAxis(const Vec5& q) {
    const double cy = std::cos(q(3)), sy = std::sin(q(3)), cz = std::cos(q(4)), sz = std::sin(q(4));
    a = {cy * cz, sz, -sy * cz};
    by_y = {-sy * cz, 0.0, -cy * cz};
    by_z = {-cy * sz, cz, sy * sz};
  }
  Vec3 a, by_y, by_z;
};

Vec5 mirror(int orientation) {
  const double s = orientation;
  return (Vec5() << s, 1.0, 1.0, s, s).finished();
}

double lever(const BearingSetRow& row) {
  return row.position + row.orientation * row.model.inner_reference_x();
}

/// Adds the moment L a × F of the forces to y and z.
Vec5 to_origin(const Vec5& load, double lever, const Vec3& a) {
  Vec5 out = load;
  out(3) += lever * (a.z() * load(0) - a.x() * load(2));
  out(4) += lever * (a.x() * load(1) - a.y() * load(0));
  return out;
}

/// One row at the displacement of the shaft.
struct Placed {
  RowState state;
  Vec5 load;      ///< at X = 0
  Mat5 by_q;      ///< d load / d q
  Vec5 by_shift;  ///< d load / d e
  double force_x = 0.0, force_by_shift = 0.0;
  Row5 force_by_q;
};

Placed place(const BearingSetRow& row, const Vec5& q, double shift) {
  const ShaftAxis axis(q);
  const double L = lever(row);
  const Vec5 D = mirror(row.orientation);
  Vec5 moved = q;
  moved.head<3>() += L * (axis.a - Vec3::UnitX());
  moved(0) += shift;
  Vec5 own = D.cwiseProduct(moved);
  own(0) += row.offset;
  Placed out;
  out.state = row.model.at(own);
  out.state.shift = shift;
  const Vec5 force = D.cwiseProduct(out.state.load);
  const Mat5 K = D.asDiagonal() * out.state.stiffness * D.asDiagonal();
  Mat5 J = Mat5::Identity();
  J.block<3, 1>(0, 3) = L * axis.by_y;
  J.block<3, 1>(0, 4) = L * axis.by_z;
  const Mat5 F_q = K * J;
  out.load = to_origin(force, L, axis.a);
  for (int k = 0; k < 5; ++k) out.by_q.col(k) = to_origin(F_q.col(k), L, axis.a);
  out.by_q.col(3) += to_origin(force, L, axis.by_y) - force;
  out.by_q.col(4) += to_origin(force, L, axis.by_z) - force;
  out.by_shift = to_origin(K.col(0), L, axis.a);
  out.force_x = force(0);
  out.force_by_shift = K(0, 0);
  out.force_by_q = F_q.row(0);
  return out;
}

bool has_friction(const BearingSet& set) {
  return std::any_of(set.rows.begin(), set.rows.end(),
                     [](const BearingSetRow& row) { return row.model.has_friction(); });
}

bool is_elastic(const BearingSet& set) {
  return std::any_of(set.compliance.begin(), set.compliance.end(),
                     [](double c) { return c > 0.0; });
}

/// Residuals of the spacers and their derivatives; unknowns are the shifts of the rows 2, 3, ...
struct Spacers {
  Eigen::VectorXd residual;
  Eigen::MatrixXd by_shift, by_q;
};

Spacers spacers(const BearingSet& set, const std::vector<Placed>& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size()) - 1;
  Spacers out{Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, 5)};
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double c = set.compliance[at];
    out.residual(k) = rows[at + 1].state.shift - rows[at].state.shift;
    out.by_shift(k, k) += 1.0;
    if (k > 0) out.by_shift(k, k - 1) -= 1.0;
    for (std::size_t j = at + 1; j < rows.size(); ++j) {
      out.residual(k) += c * rows[j].force_x;
      out.by_shift(k, static_cast<Eigen::Index>(j) - 1) += c * rows[j].force_by_shift;
      out.by_q.row(k) += c * rows[j].force_by_q;
    }
  }
  return out;
}

/// Rows at q; with elastic spacers their shifts are found by Newton steps, halved while the
/// residual grows.
bool place_all(const BearingSet& set, const Vec5& q, std::vector<double> shifts,
               std::vector<Placed>& rows, Eigen::MatrixXd& shift_by_q) {
  const auto evaluate = [&](const std::vector<double>& e) {
    std::vector<Placed> out;
    for (std::size_t k = 0; k < set.rows.size(); ++k) out.push_back(place(set.rows[k], q, e[k]));
    return out;
  };
  rows = evaluate(shifts);
  if (!is_elastic(set)) return true;
  const double accuracy = has_friction(set) ? 1e-11 : 1e-15;  // [m]
  for (int n = 0; n < 40; ++n) {
    const Spacers now = spacers(set, rows);
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(now.by_shift);
    const Eigen::VectorXd step = -lu.solve(now.residual);
    if (!step.allFinite()) return false;
    if (step.cwiseAbs().maxCoeff() < accuracy) {
      shift_by_q = -lu.solve(now.by_q);
      return true;
    }
    double t = 1.0;
    for (int half = 0; half < 20; ++half, t *= 0.5) {
      std::vector<double> trial = shifts;
      for (Eigen::Index k = 0; k < step.size(); ++k)
        trial[static_cast<std::size_t>(k) + 1] += t * step(k);
      std::vector<Placed> moved = evaluate(trial);
      if (half < 19 &&
          spacers(set, moved).residual.norm() > (1.0 - 1e-4 * t) * now.residual.norm() &&
          now.residual.norm() > accuracy)
        continue;
      shifts = std::move(trial);
      rows = std::move(moved);
      break;
    }
  }
  return false;
}

/// Start of the search with friction: the equilibrium without it, or the first guess.
Vec5 start_without_friction(const BearingSet& set, const statics::RaceLoadCase& task,
                            const Vec5& start) {
  BearingSet plain = set;
  for (BearingSetRow& row : plain.rows) row.model = row.model.without_friction();
  BearingSetState state;
  state.q = start;
  return statics::solve_race_with_fallback(plain, task, state, 1e-6).converged ? state.q : start;
}

}  // namespace

statics::RaceScales race_scales(const BearingSet& set) {
  statics::RaceScales out;
  out.lever = 0.0;
  double first = 0.0, last = 0.0, offset = 0.0;
  for (const BearingSetRow& row : set.rows) {
    const statics::RaceScales own = row.model.scales();
    out.lever = std::max(out.lever, own.lever);
    out.longest_step =
        out.longest_step > 0.0 ? std::min(out.longest_step, own.longest_step) : own.longest_step;
    out.reach = std::max(out.reach, own.reach);
    out.size = std::max(out.size, own.size);
    out.idle_load = std::max(out.idle_load, own.idle_load);
    first = std::min(first, row.position);
    last = std::max(last, row.position);
    offset = std::max(offset, std::abs(row.offset));
  }
  out.lever = std::max({out.lever, -first, last});
  out.reach += offset;
  return out;
}

double reference_stiffness(const BearingSet& set, double load) {
  double out = 0.0;
  for (const BearingSetRow& row : set.rows)
    out = std::max(out, row.model.reference_stiffness(load));
  return out;
}

bool update_race(const BearingSet& set, const Vec5& q, BearingSetState& state,
                 double /*accuracy*/) {
  std::vector<double> shifts(set.rows.size(), 0.0);
  for (std::size_t k = 0; k < state.elements.size(); ++k) shifts[k] = state.elements[k].shift;
  std::vector<Placed> rows;
  Eigen::MatrixXd shift_by_q;
  try {
    if (!place_all(set, q, std::move(shifts), rows, shift_by_q)) return false;
  } catch (const SolverError&) {  // an element of a row has no equilibrium there
    return false;
  }
  state.q = q;
  state.load.setZero();
  state.stiffness.setZero();
  state.largest_contact = 0.0;
  state.elements.clear();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    state.load += rows[k].load;
    state.stiffness += rows[k].by_q;
    if (k > 0 && shift_by_q.size() > 0)
      state.stiffness += rows[k].by_shift * shift_by_q.row(static_cast<Eigen::Index>(k) - 1);
    state.largest_contact = std::max(state.largest_contact, rows[k].state.largest);
    state.elements.push_back(std::move(rows[k].state));
  }
  return true;
}

Vec5 row_load_in_set_frame(const BearingSetRow& row, const RowState& state) {
  return mirror(row.orientation).cwiseProduct(state.load);
}

BearingSetSolution solve_bearing_set(const BearingSet& set, const statics::RaceLoadCase& task,
                                     const Vec5& start) {
  const bool friction = has_friction(set);
  const double target = friction ? 1e-7 : 1e-11;
  BearingSetSolution out;
  out.state.q = friction ? start_without_friction(set, task, start) : start;
  const statics::RaceSolveResult solve =
      statics::solve_race_with_fallback(set, task, out.state, target);
  out.iterations = solve.iterations;
  out.residual = solve.residual;
  const double enough = friction ? 1e-4 : 1e-9;
  if (!solve.converged && !(solve.residual > 0.0 && solve.residual < enough)) {
    const std::string loads = statics::load_text(task);
    if (solve.ran_away)
      throw SolverError(fmt::format(
          "equilibrium of the set: no row supports the shaft under {}; the shaft moved to x = "
          "{:.4g} m, y = {:.4g} m, z = {:.4g} m. Change the load, the preload or the arrangement",
          loads, out.state.q(0), out.state.q(1), out.state.q(2)));
    throw SolverError(fmt::format(
        "equilibrium of the set: under {} Newton's iteration {}{}. Reduce the load, or increase "
        "the preload",
        loads, statics::solve_failure_text(solve),
        solve.element_failed ? ", because an element of a row has no equilibrium" : ""));
  }
  std::array<double, 5> q{};
  for (std::size_t k = 0; k < 5; ++k) q[k] = out.state.q(static_cast<Eigen::Index>(k));
  out.notes = statics::unsupported_direction_notes(solve.held, q);
  const double k_ref = reference_stiffness(set, std::max(out.state.largest_contact, 1e-300));
  if (const auto mode = statics::unstable_mode(race_scales(set), task, out.state.stiffness, k_ref))
    out.notes.push_back(statics::instability_note(mode, {}));
  return out;
}

BearingSetSolution solve_bearing_set(const BearingSet& set, const std::array<double, 5>& load,
                                     const Vec5& start) {
  statics::RaceLoadCase task;
  for (std::size_t k = 0; k < 5; ++k) task.load(static_cast<Eigen::Index>(k)) = load[k];
  return solve_bearing_set(set, task, start);
}

}  // namespace adore::assembly

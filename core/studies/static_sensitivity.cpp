#include "studies/static_sensitivity.hpp"

#include "base/errors.hpp"
#include "runs/key_results.hpp"
#include "runs/prepare.hpp"
#include "statics/ball_friction.hpp"
#include "studies/points.hpp"
#include "studies/sensitivity.hpp"

#include <Eigen/Dense>

#include <array>
#include <limits>

namespace adore::studies {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
constexpr std::array<int, 4> kSides{-2, -1, 1, 2};

/// Of values at -2, -1, 1, 2 steps: error of fourth order.
double fourth_order(const std::array<double, 4>& f, double h) {
  return (8.0 * (f[2] - f[1]) - (f[3] - f[0])) / (12.0 * h);
}

runs::Prepared prepare_at(const Study& study, std::size_t deck, const Variable* variable,
                          double value) {
  runs::DeckRequest request;
  request.deck = study.decks.at(deck);
  request.sets = study.sets;
  request.options = study.options;
  if (variable != nullptr) {
    const auto set = [&](const std::string& name) {
      std::erase_if(request.sets, [&](const auto& old) { return old.first == name; });
      request.sets.emplace_back(name, setting_text(value));
    };
    set(variable->name);
    for (const std::string& name : variable->also) set(name);
  }
  return runs::prepare(request);
}

Vector5 vector_of(const std::array<double, 5>& values) {
  return Eigen::Map<const Vector5>(values.data());
}

/// The solution with the race held at q, put in the place of the equilibrium. @return whether all
/// elements have the laws of friction that the options ask for
bool hold(runs::Prepared& prepared, const Vector5& q) {
  bearing::Bearing held = prepared.bearing;
  held.constraints.displacement_given.fill(true);
  for (Eigen::Index k = 0; k < 5; ++k)
    held.constraints.displacement[static_cast<std::size_t>(k)] = q(k);
  if (prepared.rollers) {
    prepared.rollers = statics::solve_roller_statics(held, prepared.options.rollers);
    return prepared.rollers->friction.findings().empty();
  }
  prepared.statics = statics::solve_ball_statics(held, runs::ball_statics_options(prepared));
  return statics::solve_ball_friction_balance(held, runs::ball_statics_options(prepared),
                                              prepared.statics)
      .findings()
      .empty();
}

std::map<std::string, double> derivatives(const Study& study, std::size_t deck,
                                          const runs::Prepared& base,
                                          const Eigen::Matrix<double, 5, 5>& K,
                                          const Variable& variable, const BaseValue& at) {
  const Vector5 q = vector_of(base.race_result().displacement);
  std::vector<runs::Prepared> sides;
  std::array<std::array<double, 4>, 5> residual{}, given{};
  std::array<bool, 2> by_law{};  // solutions without and with all friction equilibria
  for (std::size_t s = 0; s < kSides.size(); ++s) {
    sides.push_back(prepare_at(study, deck, &variable, at.value + kSides[s] * at.step));
    const bearing::StaticConstraints& asked = sides.back().bearing.constraints;
    by_law[hold(sides.back(), q) ? 1 : 0] = true;
    for (std::size_t k = 0; k < 5; ++k) {
      residual[k][s] = sides.back().race_result().load[k] - asked.load[k];
      given[k][s] = asked.displacement[k];
    }
  }
  // Free directions first.
  std::vector<Eigen::Index> free, held;
  for (std::size_t k = 0; k < 5; ++k)
    (base.bearing.constraints.displacement_given[k] ? held : free)
        .push_back(static_cast<Eigen::Index>(k));
  Vector5 dq = Vector5::Zero();
  for (const Eigen::Index k : held)
    dq(k) = fourth_order(given[static_cast<std::size_t>(k)], at.step);
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd Kff(n, n);
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index row = free[static_cast<std::size_t>(i)];
    right(i) = -fourth_order(residual[static_cast<std::size_t>(row)], at.step);
    for (const Eigen::Index k : held) right(i) -= K(row, k) * dq(k);
    for (Eigen::Index j = 0; j < n; ++j) Kff(i, j) = K(row, free[static_cast<std::size_t>(j)]);
  }
  if (n > 0) {
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(Kff);
    if (!lu.isInvertible()) return {};
    const Eigen::VectorXd solved = lu.solve(right);
    for (Eigen::Index i = 0; i < n; ++i) dq(free[static_cast<std::size_t>(i)]) = solved(i);
  }
  std::map<std::string, std::array<double, 4>> along;
  for (std::size_t s = 0; s < kSides.size(); ++s) {
    by_law[hold(sides[s], q + kSides[s] * at.step * dq) ? 1 : 0] = true;
    for (const results::KeyResult& result : runs::static_results(sides[s]))
      along[std::string(result.of.id)][s] = result.value;
  }
  if (by_law[0] && by_law[1]) return {};  // solutions of other laws do not compare
  std::map<std::string, double> out;
  for (const auto& [name, values] : along) out[name] = fourth_order(values, at.step);
  return out;
}

}  // namespace

StaticDerivatives static_derivatives(const Study& study, std::size_t deck) {
  const runs::Prepared base = prepare_at(study, deck, nullptr, 0.0);
  if (base.control.dynamic) return {};
  const std::vector<BaseValue> values = base_values(study, deck);
  const Eigen::Matrix<double, 5, 5> K = base.race_result().stiffness;
  StaticDerivatives out;
  for (std::size_t v = 0; v < values.size(); ++v)
    out.push_back(derivatives(study, deck, base, K, study.variables[v], values[v]));
  return out;
}

}  // namespace adore::studies

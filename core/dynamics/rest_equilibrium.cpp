#include "dynamics/rest_equilibrium.hpp"

#include "dynamics/elements.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace adore::dynamics {
namespace {

/// Slip speeds up to which the laws of a sticking contact must reach the force that they hold
/// [m/s].
constexpr std::array kStickingSlips{1e-4, 1e-3, 1e-2, 1e-1};
/// Displacement that balanced forces leave, over the length scale; 1e-3 of the usual tolerance.
constexpr double kLeft = 1e-9;
/// Stiffness over mass below which a displacement counts as free [1/s²]: in 1 s, the acceleration
/// that kLeft allows there moves a body by 10 nm.
constexpr double kSoftest = 1e4;

/// Test of friction (rest_equilibrium.hpp): velocities after kHoldTime, with the geometry and the
/// slopes of the start.
constexpr double kHoldTime = 1.0;  ///< [s]
constexpr double kStrongFriction = 1e9;
constexpr double kMoved = 1e-6;             ///< over the length scale: the usual tolerance
constexpr double kFreeAcceleration = 1e-4;  ///< of a body that no friction holds [m/s²]

// Steps; lengths over the length scale.
constexpr double kDifference = 3e-8, kSpeedDifference = 1e-5;
constexpr double kFirstStep = 1e-3, kLongestStep = 0.05, kShortestStep = 1e-13;
constexpr double kFirstTime = 1e-6, kLongestTime = 1.0, kShortestTime = 1e-14;  ///< pseudo [s²]
/// First overlap of contacts that close in a step, in energy over the elastic energy. Contacts that
/// are closed are in the next step; open ones are not.
constexpr double kOverlap = 1e-4, kOverlapDecay = 0.9;
constexpr double kRounding = 1e-13;   ///< of the potential
constexpr int kFrictionInterval = 5;  ///< steps between two tests of friction

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// One displacement of a body: a velocity of the state.
struct Freedom {
  std::size_t velocity;  ///< index in the state
  int body;              ///< element, or -1: cage and its segments
  std::string group;
  bool of_rotation;
  double unit;        ///< of displacements [m or rad]
  bool moves = true;  ///< false: friction holds it during the search
};

class RestSearch {
 public:
  RestSearch(System& system, std::vector<double>& y);
  RestEquilibrium find(const RestSearchOptions& options);

 private:
  [[nodiscard]] bool evaluate(const std::vector<double>& y) {
    return system_.rhs(0.0, y.data(), rates_.data()) == RhsStatus::Ok;
  }
  /// Accelerations in units of the freedoms, of the last evaluation.
  [[nodiscard]] Vector accelerations() const;
  /// The same at rest in y.
  [[nodiscard]] bool accelerations_at(const std::vector<double>& y, Vector& a);
  [[nodiscard]] bool accelerations_with(const Vector& v, Vector& a);
  /// Potential of the last evaluation [J].
  [[nodiscard]] double potential() { return system_.energy_balance().balance; }
  void set_velocities(const Vector& v, std::vector<double>& y) const;
  /// y displaced by w.
  [[nodiscard]] bool displace(const std::vector<double>& y, const Vector& w,
                              std::vector<double>& out);
  /// Derivatives of the accelerations: `change` writes the state in which the given freedoms differ
  /// from the present one by one difference. Elements change together where they do not meet.
  template <class Change>
  [[nodiscard]] bool differences(double difference, Matrix& J, Change&& change);
  [[nodiscard]] bool stiffness(Matrix& J);
  [[nodiscard]] bool friction(Matrix& C);
  /// Azimuth, spin and skew of elements that their contacts hold. @return whether any was released
  bool update_sticking(bool release_only);
  [[nodiscard]] bool is_balanced(const Matrix& J, const Vector& a) const;
  [[nodiscard]] bool is_held_by_friction(const Matrix& J, const Vector& a);
  [[nodiscard]] Vector solve(const Matrix& J, const Vector& a, double inverse_time) const;
  /// One accepted step. @return false: none lowers the potential
  [[nodiscard]] bool step(const Matrix& J);

  System& system_;
  std::vector<double>& y_;
  std::vector<double> rates_, trial_, candidate_, shares_, shares_before_;
  std::vector<Freedom> all_;
  /// Rollers turn with their azimuth, which keeps their skew: indices of θ̇ and ω_x.
  std::vector<std::array<std::size_t, 2>> turn_with_orbit_;
  std::vector<int> border_rank_;  ///< of each freedom among the border components; -1: of elements
  std::size_t border_ = 0;        ///< number of border components
  std::vector<bool> sticks_;
  bool balls_;
  double time_ = kFirstTime, limit_ = kFirstStep, overlap_ = 0.0, potential_ = 0.0;
  Vector a_;  ///< accelerations at rest in y_
};

RestSearch::RestSearch(System& system, std::vector<double>& y)
    : system_(system),
      y_(y),
      rates_(y.size()),
      sticks_(static_cast<std::size_t>(system.bearing().element_count()), false),
      balls_(system.bearing().rollers() == nullptr) {
  const StateLayout& layout = system.layout();
  const std::span<const int> owner = system.coupling();
  const double length = system.scales().length;
  std::vector<int> rank;
  for (const int one : owner) rank.push_back(one < 0 ? static_cast<int>(border_++) : -1);
  for (const StateLayout::Group& group : layout.groups()) {
    if (group.slice.first >= layout.controlled_size()) break;
    if (group.unit != "m/s" && group.unit != "rad/s") continue;
    const bool of_rotation = group.unit == "rad/s";
    const double unit = !of_rotation ? length
                        : group.name == "element.theta_dot"
                            ? 2.0 * length / system.bearing().pitch_diameter()
                            : 1.0;
    for (int k = 0; k < group.slice.count; ++k) {
      const auto index = static_cast<std::size_t>(group.slice.first + k);
      all_.push_back({index, owner[index], group.name, of_rotation, unit});
      border_rank_.push_back(rank[index]);
    }
  }
  if (balls_) return;
  for (const Freedom& orbit : all_)
    for (const Freedom& spin : all_)
      if (orbit.group == "element.theta_dot" && spin.group == "element.omega_x" &&
          orbit.body == spin.body)
        turn_with_orbit_.push_back({orbit.velocity, spin.velocity});
}

Vector RestSearch::accelerations() const {
  Vector a(static_cast<Eigen::Index>(all_.size()));
  for (std::size_t k = 0; k < all_.size(); ++k)
    a[static_cast<Eigen::Index>(k)] = rates_[all_[k].velocity] / all_[k].unit;
  return a;
}

void RestSearch::set_velocities(const Vector& v, std::vector<double>& y) const {
  for (std::size_t k = 0; k < all_.size(); ++k)
    y[all_[k].velocity] = v[static_cast<Eigen::Index>(k)] * all_[k].unit;
}

bool RestSearch::accelerations_at(const std::vector<double>& y, Vector& a) {
  if (!evaluate(y)) return false;
  a = accelerations();
  return a.allFinite();
}

bool RestSearch::accelerations_with(const Vector& v, Vector& a) {
  trial_ = y_;
  set_velocities(v, trial_);
  return accelerations_at(trial_, a);
}

bool RestSearch::displace(const std::vector<double>& y, const Vector& w, std::vector<double>& out) {
  out = y;
  set_velocities(w, out);
  for (const auto& [orbit, spin] : turn_with_orbit_) out[spin] += out[orbit];
  if (!evaluate(out)) return false;
  for (const Freedom& one : all_) out[one.velocity] = rates_[one.velocity] = 0.0;
  const auto count = static_cast<std::size_t>(system_.layout().controlled_size());
  for (std::size_t i = 0; i < count; ++i) out[i] += rates_[i];
  (void)system_.project(0.0, out.data());
  return true;
}

template <class Change>
bool RestSearch::differences(double difference, Matrix& J, Change&& change) {
  const std::size_t n = all_.size(), elements = sticks_.size();
  const bool together = !system_.neighbours_meet() && border_ > 0;
  shares_.resize(elements * border_);
  shares_before_.resize(elements * border_);
  if (together && system_.rhs_with_contributions(0.0, y_.data(), rates_.data(),
                                                 shares_before_.data()) != RhsStatus::Ok)
    return false;
  J.setZero();
  for (std::size_t k = 0; k < n;) {
    const bool of_elements = all_[k].body >= 0;
    std::size_t end = k + 1;
    if (of_elements && (together || border_ == 0) && !system_.neighbours_meet())
      while (end < n && all_[end].group == all_[k].group) ++end;
    if (!change(k, end)) return false;
    const RhsStatus status =
        of_elements && together
            ? system_.rhs_with_contributions(0.0, trial_.data(), rates_.data(), shares_.data())
            : system_.rhs(0.0, trial_.data(), rates_.data());
    if (status != RhsStatus::Ok) return false;
    const Vector changed = (accelerations() - a_) / difference;
    if (end == k + 1 && !(of_elements && together)) {
      J.col(static_cast<Eigen::Index>(k)) = changed;
    } else {
      for (std::size_t row = 0; row < n; ++row)
        for (std::size_t column = k; column < end; ++column) {
          double& entry = J(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
          const int body = all_[column].body;
          if (all_[row].body == body) {
            entry = changed[static_cast<Eigen::Index>(row)];
          } else if (border_rank_[row] >= 0) {
            const std::size_t at = static_cast<std::size_t>(body) * border_ +
                                   static_cast<std::size_t>(border_rank_[row]);
            entry = (shares_[at] - shares_before_[at]) / (all_[row].unit * difference);
          }
        }
    }
    k = end;
  }
  return true;
}

bool RestSearch::stiffness(Matrix& J) {
  return differences(kDifference, J, [&](std::size_t first, std::size_t end) {
    Vector w = Vector::Zero(a_.size());
    for (std::size_t i = first; i < end; ++i) w[static_cast<Eigen::Index>(i)] = kDifference;
    return displace(y_, w, trial_);
  });
}

bool RestSearch::friction(Matrix& C) {
  const bool known = differences(kSpeedDifference, C, [&](std::size_t first, std::size_t end) {
    Vector v = Vector::Zero(a_.size());
    for (std::size_t i = first; i < end; ++i) v[static_cast<Eigen::Index>(i)] = kSpeedDifference;
    trial_ = y_;
    set_velocities(v, trial_);
    return true;
  });
  C = -C;
  return known;
}

bool RestSearch::update_sticking(bool release_only) {
  const std::size_t elements = sticks_.size();
  std::vector<std::size_t> orbit(elements, all_.size());
  for (std::size_t k = 0; k < all_.size(); ++k)
    if (all_[k].group == "element.theta_dot")
      orbit[static_cast<std::size_t>(all_[k].body)] = all_[k].velocity;
  trial_ = y_;
  if (!evaluate(trial_)) return false;
  std::vector<double> drive(elements, 0.0);
  std::vector<bool> held(elements, false), loaded(elements, false);
  for (std::size_t i = 0; i < elements; ++i) {
    drive[i] = rates_[orbit[i]];
    loaded[i] = system_.contact_loads(0)[i] > 0.0 && system_.contact_loads(1)[i] > 0.0;
  }
  const double radius = 0.5 * system_.bearing().pitch_diameter();
  for (const double slip : kStickingSlips) {
    for (std::size_t i = 0; i < elements; ++i)
      if (loaded[i]) trial_[orbit[i]] = std::copysign(slip / radius, drive[i]);
    if (!evaluate(trial_)) continue;
    for (std::size_t i = 0; i < elements; ++i)
      held[i] = held[i] || (loaded[i] && rates_[orbit[i]] * drive[i] <= 0.0);
  }
  bool released = false;
  for (std::size_t i = 0; i < elements; ++i) {
    const bool now = held[i] && (sticks_[i] || !release_only);
    released = released || (sticks_[i] && !now);
    sticks_[i] = now;
  }
  for (Freedom& one : all_) {
    const bool tangential = one.group == "element.theta_dot" || one.group == "element.omega_x" ||
                            one.group == "element.omega_r" ||
                            (balls_ && one.group == "element.omega_theta");
    one.moves = !(tangential && sticks_[static_cast<std::size_t>(one.body)]);
  }
  return released;
}

Vector RestSearch::solve(const Matrix& J, const Vector& a, double inverse_time) const {
  Matrix A = -J;
  Vector b = a;
  for (std::size_t k = 0; k < all_.size(); ++k) {
    if (all_[k].moves) continue;
    const auto i = static_cast<Eigen::Index>(k);
    A.row(i).setZero();
    A.col(i).setZero();
    b[i] = 0.0;
  }
  A.diagonal().array() += inverse_time;
  return A.partialPivLu().solve(b);
}

bool RestSearch::is_balanced(const Matrix& J, const Vector& a) const {
  const Vector left = solve(J, a, kSoftest);
  return left.allFinite() && left.lpNorm<Eigen::Infinity>() <= kLeft;
}

bool RestSearch::is_held_by_friction(const Matrix& J, const Vector& a) {
  Matrix C(J.rows(), J.cols());
  if (!friction(C)) return false;
  const auto velocities = [&](double share) {
    Matrix A = share * C - kHoldTime * J;
    A.diagonal().array() += 1.0 / kHoldTime;
    return Vector(A.partialPivLu().solve(a));
  };
  const Vector without_slip = velocities(kStrongFriction), creep = velocities(1.0);
  if (!without_slip.allFinite() || !creep.allFinite() ||
      without_slip.lpNorm<Eigen::Infinity>() * kHoldTime > kMoved ||
      creep.lpNorm<Eigen::Infinity>() * system_.scales().length > kStickingSlips.back())
    return false;
  Vector at_creep;
  if (!accelerations_with(2.0 * creep, at_creep)) return false;
  const bearing::Bearing& bearing = system_.bearing();
  const bearing::Inertia& element = bearing.element_inertia;
  const bearing::Inertia& other = bearing.cage ? bearing.cage->inertia : element;
  const double radius = 0.5 * bearing.pitch_diameter();
  std::map<int, double> power;
  for (std::size_t k = 0; k < all_.size(); ++k) {
    const Freedom& one = all_[k];
    const bearing::Inertia& body = one.body >= 0 ? element : other;
    const double inertia = one.group == "element.theta_dot" ? element.mass * radius * radius
                           : one.group == "element.omega_x" ? element.moments[0]
                           : one.of_rotation                ? body.moments.maxCoeff()
                                                            : body.mass;
    const auto i = static_cast<Eigen::Index>(k);
    power[one.body] += inertia * one.unit * one.unit * creep[i] * at_creep[i];
  }
  constexpr double kFreePower = kFreeAcceleration * kFreeAcceleration * kHoldTime;  // [W/kg]
  return std::all_of(power.begin(), power.end(), [&](const auto& one) {
    return one.second <= kFreePower * (one.first >= 0 ? element.mass : other.mass);
  });
}

bool RestSearch::step(const Matrix& J) {
  Vector next;
  for (;;) {
    // Shorter pseudo times turn the step toward the forces and leave stiff contacts balanced.
    Vector w = solve(J, a_, 1.0 / time_);
    while (!(w.lpNorm<Eigen::Infinity>() <= limit_)) {
      time_ *= 0.5;
      if (time_ < kShortestTime) return false;
      w = solve(J, a_, 1.0 / time_);
    }
    double after = std::numeric_limits<double>::infinity();
    if (displace(y_, w, candidate_) && accelerations_at(candidate_, next)) after = potential();
    const double rounding = kRounding * std::abs(potential_);
    if (after < potential_ + overlap_ - rounding ||
        (after <= potential_ + rounding && next.norm() <= a_.norm())) {
      limit_ = std::min(kLongestStep, 4.0 * limit_);
      time_ = std::min(kLongestTime, 16.0 * time_);
      overlap_ *= kOverlapDecay;
      potential_ = after;
      y_.swap(candidate_);
      a_ = next;
      return true;
    }
    limit_ = 0.3 * w.lpNorm<Eigen::Infinity>();
    if (limit_ < kShortestStep) return false;
  }
}

RestEquilibrium RestSearch::find(const RestSearchOptions& options) {
  RestEquilibrium out;
  const std::vector<double> start = y_;
  const auto n = static_cast<Eigen::Index>(all_.size());
  Matrix J(n, n);
  update_sticking(false);
  bool valid = accelerations_at(y_, a_);
  potential_ = potential();
  overlap_ = kOverlap * std::abs(potential_);
  while (valid && stiffness(J)) {
    if (is_balanced(J, a_) && !update_sticking(true)) {
      out.found = true;
      break;
    }
    if (options.friction_holds && out.steps % kFrictionInterval == 0 &&
        is_held_by_friction(J, a_)) {
      out.found = true;
      break;
    }
    if (out.steps >= options.most) break;
    ++out.steps;
    valid = step(J);
  }
  out.sticking = static_cast<std::size_t>(std::count(sticks_.begin(), sticks_.end(), true));
  if (!out.found) y_ = start;
  return out;
}

/// Whether all velocities are zero, and all positions constant.
bool is_still(System& system, const std::vector<double>& y) {
  std::vector<double> rates(y.size());
  if (system.rhs(0.0, y.data(), rates.data()) != RhsStatus::Ok) return false;
  for (const StateLayout::Group& group : system.layout().groups()) {
    if (group.slice.first >= system.layout().controlled_size()) break;
    const bool velocity = group.unit == "m/s" || group.unit == "rad/s";
    for (int k = 0; k < group.slice.count; ++k) {
      const auto i = static_cast<std::size_t>(group.slice.first + k);
      if ((velocity ? y[i] : rates[i]) != 0.0) return false;
    }
  }
  return true;
}

}  // namespace

RestEquilibrium find_rest(System& system, std::vector<double>& y,
                          const RestSearchOptions& options) {
  if (!is_still(system, y)) return {};
  return RestSearch(system, y).find(options);
}

}  // namespace adore::dynamics

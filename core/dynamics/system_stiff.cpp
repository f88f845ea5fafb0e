#include "dynamics/system_stiff.hpp"

#include "dynamics/system_impl.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

NormalContacts::NormalContacts(const std::array<RaceContactModel, 2>& contacts,
                               const BallSlices& slices, double mass)
    : contacts_(contacts), s_(slices), per_mass_(1.0 / mass) {
  for (std::size_t j = 0; j < 2; ++j) {
    contacts_[j].traction = false;
    load_limit_[j] = contact::hertz_load(contacts[j].hertz.K, contacts[j].groove.ball_radius);
  }
  for (auto* array : {&sin_, &cos_, &F_x_, &F_r_, &F_theta_, &M_, &load_, &heat_})
    array->assign(static_cast<std::size_t>(slices.x.count), 0.0);
}

bool NormalContacts::evaluate(const std::array<RaceState, 2>& races, const double* y, double* dydt,
                              int size) noexcept {
  const std::size_t n = sin_.size();
  const double* theta = y + s_.theta.first;
  const double* r = y + s_.r.first;
  bool valid = true;
  for (std::size_t i = 0; i < n; ++i) {
    sin_[i] = std::sin(theta[i]);
    cos_[i] = std::cos(theta[i]);
    valid = valid && r[i] > 0.0;
  }
  if (!valid) return false;
  const BallArrays balls{n,
                         y + s_.x.first,
                         r,
                         sin_.data(),
                         cos_.data(),
                         y + s_.x_dot.first,
                         y + s_.r_dot.first,
                         y + s_.theta_dot.first,
                         y + s_.omega_x.first,
                         y + s_.omega_r.first,
                         y + s_.omega_theta.first};
  for (auto* array : {&F_x_, &F_r_, &F_theta_}) std::fill(array->begin(), array->end(), 0.0);
  for (std::size_t j = 0; j < 2; ++j) {
    // Without traction nothing is added to the moments, so one array stands for all three.
    evaluate_race_contacts(contacts_[j], balls, races[j].motion,
                           {F_x_.data(), F_r_.data(), F_theta_.data(), M_.data(), M_.data(),
                            M_.data(), load_.data(), heat_.data(), nullptr});
    for (const double Q : load_) valid = valid && !(Q > load_limit_[j]);
  }
  std::fill(dydt, dydt + size, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    dydt[s_.x.first + i] = balls.x_dot[i];
    dydt[s_.r.first + i] = balls.r_dot[i];
    dydt[s_.theta.first + i] = balls.theta_dot[i];
    dydt[s_.x_dot.first + i] = F_x_[i] * per_mass_;
    dydt[s_.r_dot.first + i] = F_r_[i] * per_mass_;
    dydt[s_.theta_dot.first + i] = F_theta_[i] * per_mass_ / r[i];
  }
  return valid;
}

void PocketShares::resize(std::size_t balls) {
  for (auto& array : before_) array.assign(balls, 0.0);
}

void PocketShares::before(const Evaluation& e) noexcept {
  const std::array now{&e.F_x, &e.F_r, &e.F_theta, &e.M_x, &e.M_r, &e.M_theta};
  for (std::size_t k = 0; k < 6; ++k) std::copy(now[k]->begin(), now[k]->end(), before_[k].begin());
}

void PocketShares::after(const Evaluation& e, const bearing::Inertia& cage, int velocity, int omega,
                         int border, double* shares) const noexcept {
  for (std::size_t i = 0; i < e.balls.n; ++i) {
    const Vec3 force = e.to_base(i, e.F_x[i] - before_[0][i], e.F_r[i] - before_[1][i],
                                 e.F_theta[i] - before_[2][i]);
    const Vec3 moment = e.to_base(i, e.M_x[i] - before_[3][i], e.M_r[i] - before_[4][i],
                                  e.M_theta[i] - before_[5][i]);
    const Vec3 on_cage = -((e.ball_centre(i) - e.cage.position).cross(force) + moment);
    const Vec3 rates = (e.cage.to_base.transpose() * on_cage).cwiseQuotient(cage.moments);
    double* row = shares + i * static_cast<std::size_t>(border);
    for (int k = 0; k < 3; ++k) {
      row[velocity + k] -= force[k] / cage.mass;
      row[omega + k] += rates[k];
    }
  }
}

void System::Impl::set_up_coupling() {
  element_of.assign(static_cast<std::size_t>(layout.controlled_size()), -1);
  for (const Slice& slice : {ball.x, ball.r, ball.theta, ball.x_dot, ball.r_dot, ball.theta_dot,
                             ball.omega_x, ball.omega_r, ball.omega_theta})
    for (int i = 0; i < slice.count; ++i) element_of[static_cast<std::size_t>(slice.first + i)] = i;
  for (const OrientedElement& one : oriented)
    for (const Slice& slice : {one.orientation, one.rotation})
      std::fill_n(element_of.begin() + slice.first, slice.count, static_cast<int>(one.element));
  pocket_shares.resize(e.F_x.size());
}

bool System::has_stiff_part() const noexcept { return impl_->fast.has_value(); }

RhsStatus System::rhs_stiff(double, const double* y, double* dydt) noexcept {
  Impl& s = *impl_;
  if (!s.fast) return RhsStatus::Fail;
  return s.fast->evaluate(s.e.race, y, dydt, s.layout.size()) ? RhsStatus::Ok : RhsStatus::Retry;
}

std::span<const int> System::coupling() const noexcept { return impl_->element_of; }

RhsStatus System::rhs_with_shares(double t, const double* y, double* dydt,
                                  double* shares) noexcept {
  Impl& s = *impl_;
  const int first = s.cage.position.first;  // the cage's components stand together
  const int border = s.cage.rotation.first + s.cage.rotation.count - first;
  if (border > 0)
    std::fill_n(shares,
                static_cast<std::size_t>(border) * static_cast<std::size_t>(s.bearing.balls.count),
                0.0);
  s.e.begin(t, y, dydt);
  for (int k = 0; k < static_cast<int>(s.blocks.size()); ++k) {
    const bool pockets = k == s.pocket_block;
    if (pockets) s.pocket_shares.before(s.e);
    s.blocks[static_cast<std::size_t>(k)].block->apply(s.e);
    if (!s.e.valid) return RhsStatus::Retry;
    if (pockets)
      s.pocket_shares.after(s.e, s.bearing.cage->inertia, s.cage.velocity.first - first,
                            s.cage.omega.first - first, border, shares);
  }
  return RhsStatus::Ok;
}

}  // namespace adore::dynamics

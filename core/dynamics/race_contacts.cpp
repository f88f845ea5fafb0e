#include "dynamics/race_contacts.hpp"

#include "base/errors.hpp"
#include "contact/make_angle_law.hpp"
#include "contact/wavy_groove_model.hpp"
#include "dynamics/hertz_limit.hpp"
#include "dynamics/slip_kernel.hpp"
#include "dynamics/user_points.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace adore::dynamics {
namespace {

RaceKernel kernel_of(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512 && is_instruction_set_available(set)) return race_kernel_avx512;
  if (set == InstructionSet::Avx2 && is_instruction_set_available(set)) return race_kernel_avx2;
#endif
  (void)set;
  return race_kernel_baseline;
}

RacePairKernel pair_kernel_of(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512 && is_instruction_set_available(set)) return race_pair_avx512;
  if (set == InstructionSet::Avx2 && is_instruction_set_available(set)) return race_pair_avx2;
#endif
  (void)set;
  return race_pair_baseline;
}

RaceKernel rolling_kernel_of(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512 && is_instruction_set_available(set))
    return race_rolling_avx512;
  if (set == InstructionSet::Avx2 && is_instruction_set_available(set)) return race_rolling_avx2;
#endif
  (void)set;
  return race_rolling_baseline;
}

RaceSlipKernel slip_kernel_of(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512 && is_instruction_set_available(set)) return race_slip_avx512;
  if (set == InstructionSet::Avx2 && is_instruction_set_available(set)) return race_slip_avx2;
#endif
  (void)set;
  return race_slip_baseline;
}

/// Q^(1/3) = K^(1/3) √δ: times a_hat and b_hat the half axes over √δ.
double root_of(const contact::HertzConstants& hertz) { return std::cbrt(hertz.K); }

double radius_of_surface(const RaceContactModel& model) {
  const contact::GrooveGeometry& groove = model.groove;
  return tribology::is_curved(model.surface)
             ? tribology::surface_radius(groove.ball_radius,
                                         groove.groove_radius[static_cast<std::size_t>(model.race)])
             : 0.0;
}

BallConstants constants_of(const RaceContactModel& model) {
  const double root = root_of(model.hertz);
  return {model.groove.offset[static_cast<std::size_t>(model.race)],
          model.hertz.K,
          model.hertz.a_hat * root,
          model.hertz.b_hat * root,
          model.groove.ball_radius,
          radius_of_surface(model),
          model.angle,
          model.wavy ? &model.wavy->ratios : nullptr};
}

/// @param rolling of a rolling kernel
RaceKernelInput input_of(const RaceContactModel& model, const ElementViews& balls,
                         const RaceMotion& race, const ElementForces& out,
                         const tribology::RollingResistance* rolling = nullptr) noexcept {
  RaceKernelInput in;
  const auto j = static_cast<std::size_t>(model.race);
  const contact::GrooveGeometry& groove = model.groove;
  const double root_of_K = root_of(model.hertz);
  in.centre_radius = groove.centre_radius[j];
  in.offset = groove.offset[j];
  in.K = model.hertz.K;
  in.major = model.hertz.a_hat * root_of_K;
  in.minor = model.hertz.b_hat * root_of_K;
  in.follow = model.angle.follows ? &model.angle : nullptr;
  in.ball_radius = groove.ball_radius;
  in.rho = radius_of_surface(model);
  in.place = tribology::place_of(model.surface);
  in.damping = model.damping;
  in.damped = contact::is_damped(model.damping);
  in.traction = model.traction || rolling != nullptr;  // which read the ellipse
  in.rolling = rolling;
  in.law_index = model.law.index();
  in.law = model.law.address();
  in.regularization_slip_squared = model.law.regularization_slip_squared();
  in.slip_scale = model.law.slip_scale();
  in.nodes = model.rule.nodes();
  in.points = model.points ? model.points->view() : nullptr;
  for (int i = 0; i < 3; ++i) {
    in.centre[i] = race.centre[i];
    in.axis[i] = race.axis[i];
    in.velocity[i] = race.velocity[i];
    in.tilt[i] = race.tilt[i];
  }
  in.tilts = in.tilt[0] != 0.0 || in.tilt[1] != 0.0 || in.tilt[2] != 0.0;
  in.speed = race.speed;
  in.wavy = model.wavy.get();
  if (in.wavy != nullptr) {
    const Vec3 zero = race.zero();
    for (int i = 0; i < 3; ++i) in.zero[i] = zero[i];
  }
  in.own = model.own ? model.own->constants.data() : nullptr;
  in.half = model.half;
  if (model.half.is_split()) {
    const Vec3 shift = model.half.shift * race.axis, moved = race.tilt.cross(shift);
    for (int i = 0; i < 3; ++i) {
      in.centre[i] += shift[i];
      in.velocity[i] += moved[i];
    }
  }
  in.n = balls.n;
  in.x = balls.x, in.r = balls.r, in.sin_theta = balls.sin_theta, in.cos_theta = balls.cos_theta;
  in.x_dot = balls.x_dot, in.r_dot = balls.r_dot, in.theta_dot = balls.theta_dot;
  in.omega_x = balls.omega_x, in.omega_r = balls.omega_r, in.omega_theta = balls.omega_theta;
  in.F_x = out.F_x, in.F_r = out.F_r, in.F_theta = out.F_theta;
  in.M_x = out.M_x, in.M_r = out.M_r, in.M_theta = out.M_theta;
  in.load = out.load, in.heat = out.heat, in.load_slip = out.load_slip;
  return in;
}

RaceSums sums_of(const RaceKernelSums& sums) noexcept {
  RaceSums result;
  result.force = {sums.force[0], sums.force[1], sums.force[2]};
  result.moment = {sums.moment[0], sums.moment[1], sums.moment[2]};
  result.elastic_energy = sums.elastic_energy;
  result.heat = sums.heat;
  result.load_slip = sums.load_slip;
  result.damping = sums.damping;
  return result;
}

RaceSums evaluate_with(RaceKernel kernel, const RaceContactModel& model, const ElementViews& balls,
                       const RaceMotion& race, const ElementForces& out,
                       const tribology::RollingResistance* rolling = nullptr) noexcept {
  RaceSums sums = sums_of(kernel(input_of(model, balls, race, out, rolling)));
  if (model.half.is_split()) sums.moment += model.half.shift * race.axis.cross(sums.force);
  return sums;
}

std::array<RaceSums, 2> evaluate_pair_with(RacePairKernel kernel,
                                           const std::array<RaceContactModel, 2>& models,
                                           const ElementViews& balls,
                                           const std::array<RaceMotion, 2>& races,
                                           const std::array<ElementForces, 2>& out) noexcept {
  const RaceKernelInput in[2] = {input_of(models[0], balls, races[0], out[0]),
                                 input_of(models[1], balls, races[1], out[1])};
  RaceKernelSums sums[2]{};
  kernel(in, sums);
  return {sums_of(sums[0]), sums_of(sums[1])};
}

}  // namespace

Vec3 RaceMotion::zero() const noexcept {
  return std::cos(turn) * z + std::sin(turn) * axis.cross(z);
}

const RaceContactModel& RaceContactModel::of(std::size_t ball) const noexcept {
  return own ? own->model[ball] : *this;
}

void set_unequal_balls(RaceContactModel& model, const bearing::BallGeometry& balls,
                       const bearing::RaceErrors& errors, std::vector<double> growth, double angle,
                       std::size_t count) {
  if (std::all_of(growth.begin(), growth.end(), [](double one) { return one == 0.0; })) {
    if (!model.half.is_split()) return;
    growth.assign(count, 0.0);
  }
  const int race = model.race;
  const double E_star = model.effective_modulus;
  auto own = std::make_shared<UnequalBallModels>();
  for (const double more : growth) {
    RaceContactModel& one = own->model.emplace_back(model);
    if (more == 0.0) continue;
    const bearing::BallGeometry geometry = contact::geometry_with_ball_growth(balls, more);
    one.groove = contact::groove_with_ball_growth(model.groove, more);
    one.hertz = contact::hertz_constants(contact::race_curvature(geometry, race, angle), E_star);
    if (model.angle.follows) one.angle = contact::make_angle_law(geometry, race, E_star);
    if (!model.wavy) continue;
    contact::WavyGroove wavy = *model.wavy;
    wavy.ratios = contact::ratios_with_ball_growth(balls, more, race, errors, angle);
    one.wavy = std::make_shared<const contact::WavyGroove>(wavy);
  }
  for (const RaceContactModel& one : own->model) own->constants.push_back(constants_of(one));
  model.own = std::move(own);
}

double load_limit(const RaceContactModel& model) noexcept {
  if (model.own) {
    double least = std::numeric_limits<double>::infinity();
    for (const RaceContactModel& one : model.own->model) least = std::min(least, load_limit(one));
    return least;
  }
  const double radius = model.groove.ball_radius;
  const auto limit = [radius](double K, double wide) {  // wide: of a ball, at the limit, a/√δ
    const double root = radius / wide;
    return K * std::min(radius * std::sqrt(radius), root * root * root);
  };
  double least = limit(model.hertz.K, model.hertz.a_hat * std::cbrt(model.hertz.K));
  if (model.angle.follows) {
    constexpr int kAngles = 64;  // of polynomials that are nearly straight
    const double side = model.race == bearing::kOuter ? 1.0 : -1.0;
    for (int k = 0; k <= kAngles; ++k) {
      const double u = side * k / kAngles;
      least = std::min(least, limit(contact::polynomial(model.angle.K, u),
                                    contact::polynomial(model.angle.major, u)));
    }
    least *= 0.999;  // between the angles
  }
  if (model.wavy) {
    double of_waves = 1.0;
    for (int k = -8; k <= 8; ++k) {
      const double w = k / 8.0;
      const double wide = contact::polynomial(model.wavy->ratios.major, w);
      of_waves = std::min(of_waves, contact::polynomial(model.wavy->ratios.stiffness, w) /
                                        std::max(1.0, wide * wide * wide));
    }
    least *= 0.999 * of_waves;
  }
  return least;
}

bool is_hertz_valid(const RaceContactModel& model, const RaceContactState& state) noexcept {
  const double radius = model.groove.ball_radius;
  return state.approach < radius && state.ellipse.a < radius;
}

RaceSums evaluate_race_contacts(const RaceContactModel& model, const ElementViews& balls,
                                const RaceMotion& race, const ElementForces& out) noexcept {
  static const RaceKernel kernel = kernel_of(chosen_instruction_set());
  return evaluate_with(kernel, model, balls, race, out);
}

RaceSums evaluate_race_contacts(InstructionSet set, const RaceContactModel& model,
                                const ElementViews& balls, const RaceMotion& race,
                                const ElementForces& out) noexcept {
  return evaluate_with(kernel_of(set), model, balls, race, out);
}

bool can_share_vectors(const std::array<RaceContactModel, 2>& models) noexcept {
  const RaceContactModel &a = models[0], &b = models[1];
  const auto plain = [](const RaceContactModel& one) {
    return !one.own && !one.wavy && !one.law.has_film() && !one.law.is_user_law();
  };
  return plain(a) && plain(b) && a.law.index() == b.law.index() && a.traction == b.traction &&
         a.angle.follows == b.angle.follows && a.surface == b.surface &&
         contact::is_damped(a.damping) == contact::is_damped(b.damping);
}

std::array<RaceSums, 2> evaluate_both_races(const std::array<RaceContactModel, 2>& models,
                                            const ElementViews& balls,
                                            const std::array<RaceMotion, 2>& races,
                                            const std::array<ElementForces, 2>& out) noexcept {
  static const RacePairKernel kernel = pair_kernel_of(chosen_instruction_set());
  return evaluate_pair_with(kernel, models, balls, races, out);
}

std::array<RaceSums, 2> evaluate_both_races(InstructionSet set,
                                            const std::array<RaceContactModel, 2>& models,
                                            const ElementViews& balls,
                                            const std::array<RaceMotion, 2>& races,
                                            const std::array<ElementForces, 2>& out) noexcept {
  return evaluate_pair_with(pair_kernel_of(set), models, balls, races, out);
}

RaceSums evaluate_race_rolling(const RaceContactModel& model,
                               const tribology::RollingResistance& rolling,
                               const ElementViews& balls, const RaceMotion& race,
                               const ElementForces& out) noexcept {
  static const RaceKernel kernel = rolling_kernel_of(chosen_instruction_set());
  return evaluate_with(kernel, model, balls, race, out, &rolling);
}

RaceSums evaluate_race_rolling(InstructionSet set, const RaceContactModel& model,
                               const tribology::RollingResistance& rolling,
                               const ElementViews& balls, const RaceMotion& race,
                               const ElementForces& out) noexcept {
  return evaluate_with(rolling_kernel_of(set), model, balls, race, out, &rolling);
}

void largest_slips(InstructionSet set, const RaceContactModel& model, const ElementViews& balls,
                   const RaceMotion& race, double* scratch, double* slip) noexcept {
  const ElementForces out{scratch, scratch, scratch, scratch, scratch,
                          scratch, slip,    scratch, nullptr};
  RaceKernelInput in = input_of(model, balls, race, out);
  in.traction = true;  // for the ellipse
  slip_kernel_of(set)(in);
}

const char* race_contact_instruction_set() noexcept {
  return instruction_set_name(chosen_instruction_set());
}

}  // namespace adore::dynamics

#include "base/errors.hpp"
#include "dynamics/system_impl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::dynamics {
namespace {

/// Largest applied load component; of a displacement-driven bearing the largest reaction; of an
/// unloaded one the weight of an element at 9.81 m/s² (N11).
double force_scale(const bearing::Bearing& bearing, const statics::StaticSolution& statics) {
  double applied = 0.0, reaction = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!bearing.constraints.displacement_given[k])
      applied = std::max(applied, std::abs(bearing.constraints.load[k]));
    reaction = std::max(reaction, std::abs(statics.load[k]));
  }
  if (applied > 0.0) return applied;
  const double weight = bearing.ball_inertia.mass * 9.81;
  return reaction > 1e-9 * weight ? reaction : weight;
}

/// Largest dQ/dδ at the static solution; without a loaded contact that of the stiffer race at 1e-3
/// of the force scale (N7).
double stiffness_scale(const statics::StaticSolution& statics,
                       const std::array<RaceContactModel, 2>& contacts, double force) {
  if (statics.max_stiffness > 0.0) return statics.max_stiffness;
  const double K = std::max(contacts[0].hertz.K, contacts[1].hertz.K);
  return 1.5 * std::cbrt(K * K * 1e-3 * force);
}

}  // namespace

System::Impl::Impl(const bearing::Bearing& bearing_, const ScenePlan& plan,
                   const statics::StaticSolution& statics_,
                   const std::array<double, 2>& fixed_angle, const SystemOptions& options)
    : bearing(bearing_), statics(statics_), e(static_cast<std::size_t>(bearing_.balls.count)) {
  demand(bearing.balls.count >= 1, "a bearing needs at least one ball");
  demand(static_cast<int>(statics.balls.size()) == bearing.balls.count,
         "the static solution has another number of balls than the bearing");
  const Vec3& moments = bearing.ball_inertia.moments;
  demand(bearing.ball_inertia.mass > 0.0 && moments.minCoeff() > 0.0 &&
             moments.maxCoeff() - moments.minCoeff() <= 1e-9 * moments.maxCoeff(),
         "a ball needs a positive mass and three equal, positive moments of inertia");
  const bool cage_moves = plan.has(Effect::CageMotion);
  demand(!cage_moves || bearing.cage.has_value(),
         "the plan moves a cage that the bearing does not have");
  demand(cage_moves || !(plan.has(Effect::PocketContact) || plan.has(Effect::LandContact)),
         "the plan has cage contacts but no cage motion");
  demand(!cage_moves ||
             (bearing.cage->inertia.mass > 0.0 && bearing.cage->inertia.moments.minCoeff() > 0.0),
         "the cage needs a positive mass and positive moments of inertia");
  demand(options.land_slices >= 1, "a guide land needs at least one slice");

  gravity = plan.has(Effect::Gravity);
  has_race_contact = plan.has(Effect::RaceContact);
  set_up_races(fixed_angle, options, plan.has(Effect::RaceTraction));
  if (plan.has(Effect::PocketContact)) {
    std::vector<double> azimuths;
    for (const statics::StaticBall& b : statics.balls) azimuths.push_back(b.azimuth);
    pockets.emplace(bearing, azimuths);
  }
  if (plan.has(Effect::LandContact)) lands = make_lands(bearing, options.land_slices);
  set_up_state(plan);
  if (plan.has(Effect::LightLoadBalance)) {
    demand(plan.light_load_ratio > 0.0, "light-load balance needs a load ratio above 0");
    light_load_ratio = plan.light_load_ratio;
    held.emplace(
        HeldBalls::Scene{contacts, bearing.ball_inertia.mass,
                         gravity ? bearing.gravity : Vec3(Vec3::Zero()),
                         pockets ? &*pockets : nullptr,
                         plan.has(Effect::PocketTraction) ? SlipFriction(*bearing.pocket_traction)
                                                          : SlipFriction(),
                         plan.has(Effect::PocketTraction)},
        ball, static_cast<std::size_t>(bearing.balls.count));
  }
  layout.begin_quadratures();
  set_up_quadratures(plan);
  set_up_ledger_integrals(plan);
  set_up_blocks(plan);
  set_up_coupling();
  if (has_race_contact) fast.emplace(contacts, ball, bearing.ball_inertia.mass);
  rates.assign(static_cast<std::size_t>(layout.size()), 0.0);

  scales.length = 0.5 * bearing.balls.diameter;
  scales.force = force_scale(bearing, statics);
  scales.time =
      std::sqrt(bearing.ball_inertia.mass / stiffness_scale(statics, contacts, scales.force));
  apply_scales();
}

void System::Impl::set_up_races(const std::array<double, 2>& fixed_angle,
                                const SystemOptions& options, bool traction) {
  const contact::GrooveGeometry groove = contact::groove_geometry(bearing.balls);
  const tribology::EllipseRule rule =
      tribology::make_split_ellipse_rule(options.ellipse_major, options.ellipse_minor);
  const auto& misalignment = bearing.constraints.outer_misalignment;
  race_attitude[0] = quaternion_from_angles({0.0, misalignment[0], misalignment[1]});
  race_attitude[1] =
      quaternion_from_angles({0.0, statics.displacement[3], statics.displacement[4]});
  for (std::size_t j = 0; j < 2; ++j) {
    RaceContactModel& model = contacts[j];
    model.race = static_cast<bearing::Race>(j);
    model.groove = groove;
    model.effective_modulus =
        bearing::contact_modulus(bearing.ball_material, bearing.race_material[j]);
    model.hertz = contact::hertz_constants(
        contact::race_curvature(bearing.balls, static_cast<int>(j), fixed_angle[j]),
        model.effective_modulus);
    model.shoulder_radius = 0.5 * bearing.balls.shoulder_diameter[j];
    model.traction = traction;
    model.curve = bearing.race_traction;
    model.surface = options.surface;
    model.rule = rule;
    free_centre[j] = Vec3(groove.centre_x[j], 0.0, 0.0);
    RaceMotion& motion = e.race[j].motion;
    motion.centre = free_centre[j];
    motion.axis = rotation_matrix(race_attitude[j]).col(0);
    motion.speed = bearing.speed[j];
  }
  e.race[1].motion.centre +=
      Vec3(statics.displacement[0], statics.displacement[1], statics.displacement[2]);
}

Slice System::Impl::add(std::string name, std::string_view unit, int count, ScaleKind kind) {
  const Slice slice = layout.add(std::move(name), unit, count, 1.0);
  kinds_.emplace_back(slice, kind);
  return slice;
}

void System::Impl::set_up_state(const ScenePlan& plan) {
  const int n = bearing.balls.count;
  ball.x = add("element.x", "m", n, ScaleKind::Length);
  ball.r = add("element.r", "m", n, ScaleKind::Length);
  ball.theta = add("element.theta", "rad", n, ScaleKind::Angle);
  ball.x_dot = add("element.x_dot", "m/s", n, ScaleKind::Velocity);
  ball.r_dot = add("element.r_dot", "m/s", n, ScaleKind::Velocity);
  ball.theta_dot = add("element.theta_dot", "rad/s", n, ScaleKind::Rate);
  ball.omega_x = add("element.omega_x", "rad/s", n, ScaleKind::Rate);
  ball.omega_r = add("element.omega_r", "rad/s", n, ScaleKind::Rate);
  ball.omega_theta = add("element.omega_theta", "rad/s", n, ScaleKind::Rate);
  if (plan.has(Effect::ElementOrientation))
    for (const int index : plan.oriented_elements) {
      demand(index >= 0 && index < n, "the plan orients an element that does not exist");
      const std::string name = fmt::format("element{}", index + 1);
      oriented.push_back({static_cast<std::size_t>(index),
                          add(name + ".quaternion", "-", 4, ScaleKind::Angle),
                          add(name + ".rotation", "rad", 1, ScaleKind::Angle)});
    }
  if (!plan.has(Effect::CageMotion)) return;
  cage.position = add("cage.position", "m", 3, ScaleKind::Length);
  cage.velocity = add("cage.velocity", "m/s", 3, ScaleKind::Velocity);
  cage.orientation = add("cage.quaternion", "-", 4, ScaleKind::Angle);
  cage.omega = add("cage.omega", "rad/s", 3, ScaleKind::Rate);
  cage.rotation = add("cage.rotation", "rad", 1, ScaleKind::Angle);
}

void System::Impl::set_up_quadratures(const ScenePlan& plan) {
  const bool race = plan.has(Effect::RaceTraction), wear = plan.has(Effect::WearIntegrals);
  const bool pocket = plan.has(Effect::PocketTraction), land = plan.has(Effect::LandTraction);
  const auto integral = [this](int& index, std::string name, const double& rate) {
    index = layout.add(std::move(name), "J", 1, 1.0).first;
    rates_of_integrals_.push_back({index, &rate});
  };
  const std::array<std::string, 2> names{"outer race", "inner race"};
  for (std::size_t j = 0; j < 2; ++j) {
    // Without friction a body of revolution that only spins about its axis exerts no power.
    if (race || land)
      integral(integrals.work_race[j], fmt::format("{}.work", names[j]), e.race_power[j]);
    if (race) integral(integrals.heat_race[j], fmt::format("{}.heat", names[j]), e.heat_race[j]);
    if (race && wear) {
      integral(integrals.wear_race[j], fmt::format("{}.load_slip", names[j]), e.wear_race[j]);
      integral(integrals.wear_element1[j], fmt::format("{}.load_slip_element1", names[j]),
               e.wear_element1[j]);
    }
  }
  if (pocket) integral(integrals.heat_pockets, "pockets.heat", e.heat_pockets);
  if (land) integral(integrals.heat_lands, "lands.heat", e.heat_lands);
  if ((pocket || land) && wear) integral(integrals.wear_cage, "cage.load_slip", e.wear_cage);
}

void System::Impl::set_up_ledger_integrals(const ScenePlan& plan) {
  static constexpr double kNoRate = 0.0;  // changed between steps only
  const auto integrals_of = [this](int& index, std::string name, std::string_view unit,
                                   const double* from, int count) {
    index = layout.add(std::move(name), unit, count, 1.0).first;
    for (int k = 0; k < count; ++k)
      rates_of_integrals_.push_back({index + k, from == nullptr ? &kNoRate : from + k});
  };
  QuadratureIndices& q = integrals;
  if (plan.has(Effect::MomentumLedger)) {
    integrals_of(q.impulse, "external.impulse", "N s", e.external_force.data(), 3);
    integrals_of(q.angular_impulse, "external.angular_impulse", "N m s", e.external_moment.data(),
                 3);
  }
  if (!held) return;
  integrals_of(q.held_balance, "held.balance_work", "J", &e.held_power, 1);
  integrals_of(q.held_switches, "held.switch_energy", "J", nullptr, 1);
  integrals_of(q.held_impulse, "held.impulse", "N s", e.held_force.data(), 3);
  integrals_of(q.held_angular_impulse, "held.angular_impulse", "N m s", e.held_moment.data(), 3);
  integrals_of(q.held_flags, "held.element", "-", nullptr, bearing.balls.count);
}

template <class Block, class... Arguments>
void System::Impl::add_block(int entry, Arguments&&... arguments) {
  blocks.push_back({std::make_unique<Block>(std::forward<Arguments>(arguments)...), entry});
}

void System::Impl::set_up_blocks(const ScenePlan& plan) {
  const int motion = ledger.add_entry("kinematics and equations of motion");
  add_block<BallKinematics>(motion, ball);
  if (has_cage()) add_block<CageKinematics>(motion, cage);
  const int balance = held ? ledger.add_entry("light-load balance") : -1;
  if (held) add_block<HeldRates>(balance, *held);

  const bool wear = plan.has(Effect::WearIntegrals);
  if (plan.has(Effect::RaceContact))
    for (std::size_t j = 0; j < 2; ++j)
      add_block<RaceBlock>(ledger.add_entry(j == 0 ? "outer race contacts" : "inner race contacts"),
                           contacts[j], wear);
  if (pockets) {
    pocket_block = static_cast<int>(blocks.size());
    const int entry = ledger.add_entry("pocket contacts");
    if (plan.has(Effect::PocketTraction)) {
      demand(bearing.pocket_traction.has_value(), "pocket traction is on without a traction curve");
      add_block<PocketBlock<true>>(entry, *pockets, SlipFriction(*bearing.pocket_traction));
    } else {
      add_block<PocketBlock<false>>(entry, *pockets, SlipFriction());
    }
  }
  if (!lands.empty()) {
    const int entry = ledger.add_entry("land contacts");
    if (plan.has(Effect::LandTraction)) {
      demand(bearing.land_traction.has_value(), "land traction is on without a traction curve");
      add_block<LandBlock<true>>(entry, lands, SlipFriction(*bearing.land_traction));
    } else {
      add_block<LandBlock<false>>(entry, lands, SlipFriction());
    }
  }
  if (gravity) {
    const int entry = ledger.add_entry("gravity");
    add_block<BallGravity>(entry, Vec3(bearing.ball_inertia.mass * bearing.gravity));
    if (has_cage())
      add_block<CageGravity>(entry, Vec3(bearing.cage->inertia.mass * bearing.gravity));
  }

  add_block<BallMotion>(motion, ball, bearing.ball_inertia.mass, bearing.ball_inertia.moments[0]);
  if (held) add_block<HeldMotion>(balance, *held);
  if (has_cage()) add_block<CageMotion>(motion, cage, bearing.cage->inertia);
  if (!oriented.empty())
    add_block<OrientationMotion>(ledger.add_entry("orientation of elements"), oriented);
  if (plan.has(Effect::MomentumLedger))
    add_block<ExternalActions>(
        ledger.add_entry("momentum ledger"), gravity ? bearing.gravity : Vec3(Vec3::Zero()),
        bearing.ball_inertia.mass, has_cage() ? bearing.cage->inertia.mass : 0.0);
  if (!rates_of_integrals_.empty()) add_block<Quadratures>(motion, rates_of_integrals_);
}

void System::Impl::apply_scales() {
  for (const auto& [slice, kind] : kinds_) switch (kind) {
      case ScaleKind::Length:
        layout.set_scale(slice, scales.length);
        break;
      case ScaleKind::Velocity:
        layout.set_scale(slice, scales.length / scales.time);
        break;
      case ScaleKind::Angle:
        layout.set_scale(slice, 1.0);
        break;
      case ScaleKind::Rate:
        layout.set_scale(slice, 1.0 / scales.time);
        break;
    }
}

}  // namespace adore::dynamics

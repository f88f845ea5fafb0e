#include "dynamics/effects/roller_races.hpp"

#include "base/errors.hpp"
#include "contact/line_contact.hpp"
#include "contact/slice_table.hpp"
#include "dynamics/effects/contact_damping.hpp"
#include "dynamics/race_contacts.hpp"
#include "dynamics/roller_start.hpp"
#include "scene/user_laws.hpp"
#include "statics/roller_model.hpp"
#include "statics/roller_race_law.hpp"
#include "statics/start_radii.hpp"
#include "tribology/film_law.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace adore::dynamics {
namespace {

contact::RacePose pose_of(const RaceBody& race) { return {race.position, race.to_base}; }
contact::RigidMotion motion_of(const RaceBody& race) {
  return {race.position, race.velocity, race.omega};
}

/// Middle, axis and motion of a roller.
struct RollerPlace {
  Vec3 centre, axis;  ///< C [m], a
  contact::RigidMotion motion;
};
RollerPlace place_of(const Evaluation& e, std::size_t i, double mass_offset) {
  const Vec3 G = e.element_centre(i), axis = e.attitude[i].col(0);
  return {G - mass_offset * axis, axis, {G, e.element_velocity(i), e.element_omega(i)}};
}

/// ω of a roller less that of its orbit about the bearing axis, in its meridian frame.
contact::Triple<double> spin_of(const Evaluation& e, std::size_t i, const RollerPlace& roller,
                                const contact::RacePose& pose,
                                const contact::MeridianRotation& turn) {
  const Vec3 spin = pose.direction(roller.motion.omega - Vec3(e.elements.theta_dot[i], 0.0, 0.0));
  return turn.to_meridian({spin[0], spin[1], spin[2]});
}

}  // namespace

std::array<RollerRaceModel, 2> roller_race_models(const SceneBuilder& scene) {
  const statics::RollerOptions& options = scene.rollers->options;
  if (options.contact != statics::RollerContact::Sliced ||
      options.kinematics != statics::RollerKinematics::Exact)
    throw InputError(
        "the motion of rollers needs sliced contacts with exact kinematics. Point contacts and "
        "linear kinematics are available only in the quasi-static solution (mode = -1)");
  const statics::RollerModel model = statics::make_roller_model(scene.bearing, options);
  std::array<RollerRaceModel, 2> out;
  for (std::size_t j = 0; j < 2; ++j) {
    RollerRaceModel& of = out[j];
    of.race = static_cast<bearing::Race>(j);
    for (const statics::RollerContactGeometry& body : model.bodies)
      of.slices.push_back(contact::roller_race_slices(
          model.race[j], body.slices, model.slicing.width, model.law[j], model.E_star[j]));
    const contact::DampingLaw<> damping =
        race_damping(scene.plan, scene.bearing, scene.options, scene.statics, j);
    for (contact::RollerRaceSlices& one : of.slices) one.damping = damping;
    const bearing::RaceErrors& errors = scene.bearing.imperfections.race[j];
    if (bearing::table_of(errors.given.get()) != nullptr)
      of.surface = errors.given;
    else if (!errors.ideal())
      of.wavy = contact::make_wavy_race(errors, model.race[j],
                                        model.rollers.race_radius(static_cast<int>(j)),
                                        model.rollers.crown_radius);
    if (scene.options.user)
      for (const auto& lobe : scene.options.user->out_of_round) {
        of.lobes.emplace_back();
        if (lobe)
          of.lobes.back() = lobe_as_race_error(*lobe, j, model.race[j],
                                               model.rollers.race_radius(static_cast<int>(j)),
                                               model.rollers.crown_radius);
      }
    of.mass_offset = scene.bearing.roller_mass_offset;
    const double radius = 0.5 * scene.bearing.element_diameter();
    of.load_limit = contact::slice_load(model.law[j], model.slicing.effective_length, radius).load;
    of.traction = scene.plan.has(Effect::RaceTraction);
    const tribology::RaceFilmInputs surface =
        statics::roller_film_surface(scene.bearing, j, model.E_star[j], scene.options.single_films);
    if (scene.plan.has(Effect::RollingResistance))
      of.rolling = tribology::rolling_resistance(
          tribology::lubricant_of(*scene.bearing.lubrication), *scene.bearing.lubrication, surface);
    const tribology::UserTractionRoutine* routine =
        scene.options.user ? scene.options.user->traction_of(tribology::TractionKind::ElementRace)
                           : nullptr;
    of.law = routine != nullptr
                 ? tribology::TractionLaw(*routine, tribology::TractionKind::ElementRace,
                                          static_cast<int>(j))
                 : statics::roller_race_law(scene.bearing, surface);
    if (routine == nullptr && scene.bearing.lubrication)
      of.approximation_note = tribology::describe_film_evaluation(
          tribology::lubricant_of(*scene.bearing.lubrication), *scene.bearing.lubrication, surface);
  }
  return out;
}

contact::WavyRace lobe_as_race_error(const bearing::SurfaceSeries& lobe, std::size_t j,
                                     const contact::RaceSurface& race, double race_radius,
                                     double crown_radius) {
  const double sign =
      j == 0 ? -1.0 : 1.0;  // a larger roller is a smaller outer, a larger inner race
  auto as_race = std::make_shared<bearing::SurfaceSeries>(lobe);
  const double growth = statics::race_growth(race);
  for (const auto& [series, factor] :
       {std::pair{&as_race->radius, sign * growth}, {&as_race->taper, sign}}) {
    for (double& one : series->pairs) one *= factor;
    series->least *= factor;
    series->largest *= factor;
    if (j == 0) std::swap(series->least, series->largest);
  }
  bearing::RaceErrors errors;
  errors.given = std::move(as_race);
  return contact::make_wavy_race(errors, race, race_radius, crown_radius);
}

contact::AzimuthDirection<double> azimuth_in_roller(const Mat3& axes, const Vec3& up,
                                                    std::size_t j) noexcept {
  const double sign = j == 0 ? 1.0 : -1.0;
  const double y = sign * up.dot(axes.col(1)), z = sign * up.dot(axes.col(2));
  const double p = std::max(std::hypot(y, z), 1e-300);
  return {z / p, -y / p};
}

double line_stiffness(const RollerRaceModel& model, double load) noexcept {
  const contact::RollerRaceSlices& slices = model.slices.front();
  double length = 0.0;
  for (const double width : slices.width) length += width;
  const double constant = slices.law.constant * length;  // Q = constant δ^(10/9)
  return (10.0 / 9.0) * load / std::pow(load / constant, 0.9);
}

RollersOnRace::RollersOnRace(const RollerRaceModel& model, std::size_t rollers)
    : model_(model),
      reads_spin_(model.law.has_film() || model.law.is_user_law()),
      poses_(rollers),
      turns_(rollers),
      table_(bearing::table_of(model.surface.get())) {
  for (const contact::RollerRaceSlices& slices : model.slices)
    views_.push_back(contact::view_of(slices));
  if (!model.lobes.empty()) {
    lobe_slopes_.resize(rollers);
    axes_.resize(rollers, Vec3::UnitX());
  }
  if (model.wavy || table_ != nullptr) slopes_.resize(rollers);
  if (slopes_.empty() && lobe_slopes_.empty()) return;
  while (views_.size() < rollers) views_.push_back(views_.front());  // each with a race of its own
  if (table_ == nullptr) return;
  const std::size_t slices = views_.front().count;
  radius_.resize(rollers * slices);
  approach_slopes_.resize(rollers * slices);
  const double nearer = contact::nearest(*table_);
  for (std::size_t i = 0; i < rollers; ++i) {
    views_[i].radius = radius_.data() + i * slices;
    slopes_[i].rise = approach_slopes_.data() + i * slices;
    for (double& around : views_[i].around) around += nearer;
  }
}

void RollersOnRace::fill_radius_table(const RaceBody& race) noexcept {
  const double cosine = std::cos(race.turn_beyond), sine = std::sin(race.turn_beyond);
  const std::size_t slices = views_.front().count;
  for (std::size_t i = 0; i < turns_.size(); ++i) {
    const contact::AzimuthDirection<double> at =
        contact::azimuth_in_rotated_race(turns_[i], cosine, sine);
    const std::vector<double>& ideal = model_.of(i).radius;
    std::copy(ideal.begin(), ideal.end(),
              radius_.begin() + static_cast<std::ptrdiff_t>(i * slices));
    contact::apply_table_to_slices(*table_, std::atan2(at.sine, at.cosine),
                                   radius_.data() + i * slices,
                                   approach_slopes_.data() + i * slices);
  }
}

void RollersOnRace::form_race(const RaceBody& race) noexcept {
  const double cosine = std::cos(race.turn_beyond), sine = std::sin(race.turn_beyond);
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    const auto here = model_.wavy->at(contact::azimuth_in_rotated_race(turns_[i], cosine, sine));
    views_[i].race = here.surface;
    slopes_[i] = here.slope;
  }
}

void RollersOnRace::form_lobes(const Evaluation& e) noexcept {
  const auto j = static_cast<std::size_t>(model_.race);
  for (std::size_t i = 0; i < lobe_slopes_.size(); ++i) {
    if (!model_.wavy) views_[i].race = model_.of(i).race;
    if (!model_.lobes[i]) continue;
    const contact::Triple<double> of_race = turns_[i].from_meridian({0.0, 0.0, 1.0});
    const Vec3 up = race_pose_.direction_from_race({of_race.x, of_race.y, of_race.z});
    contact::WavyRace lobe = *model_.lobes[i];
    lobe.ideal = views_[i].race;
    const auto here = lobe.at(azimuth_in_roller(e.attitude[i], up, j));
    views_[i].race = here.surface;
    lobe_slopes_[i] = here.slope;
    const Vec3 axis = race_pose_.direction(e.attitude[i].col(0));
    const contact::Triple<double> a = turns_[i].to_meridian({axis[0], axis[1], axis[2]});
    axes_[i] = {a.x, a.y, a.z};
  }
}

void RollersOnRace::place(const Evaluation& e) noexcept {
  const RaceBody& race = e.race[static_cast<std::size_t>(model_.race)];
  race_pose_ = pose_of(race);
  const contact::RigidMotion motion = motion_of(race);
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const RollerPlace roller = place_of(e, i, model_.mass_offset);
    contact::RollerInMeridian in =
        contact::roller_in_meridian(race_pose_, motion, roller.centre, roller.axis, roller.motion);
    if (reads_spin_) in.roller.spin = spin_of(e, i, roller, race_pose_, in.turn);
    poses_[i] = in.roller;
    turns_[i] = in.turn;
  }
  if (table_ != nullptr)
    fill_radius_table(race);
  else if (!slopes_.empty())
    form_race(race);
  if (!lobe_slopes_.empty()) form_lobes(e);
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    contact::RollerPose& at = poses_[i];
    at.open = contact::is_certainly_open(views_[views_.size() == 1 ? 0 : i], at.x, at.r, at.axes.a);
  }
}

void RollersOnRace::apply_roller_action(Evaluation& e, std::size_t i, const double (&force_on)[3],
                                        const double (&moment_on)[3]) const noexcept {
  RaceBody& race = e.race[static_cast<std::size_t>(model_.race)];
  const contact::RollerInMeridian in{{}, turns_[i]};
  const Vec3 force = in.back(race_pose_, {force_on[0], force_on[1], force_on[2]});
  const Vec3 moment = in.back(race_pose_, {moment_on[0], moment_on[1], moment_on[2]});
  const Vec3 from_mass_centre = -model_.mass_offset * e.attitude[i].col(0);
  const Vec3 C = e.element_centre(i) + from_mass_centre;
  e.add_force(i, e.to_cylindrical(i, force));
  e.add_moment(i, e.to_cylindrical(i, moment + from_mass_centre.cross(force)));
  race.force -= force;
  race.moment -= moment + (C - race.position).cross(force);
}

void RollersOnRace::largest_slips(double* slip) const noexcept {
  for (std::size_t i = 0; i < count(); ++i)
    slip[i] =
        poses_[i].open
            ? 0.0
            : std::sqrt(contact::roller_race_sums<double>(view(i), poses_[i], [](double, double) {
                          return 0.0;
                        }).fastest);
}

RollerRaceBlock::RollerRaceBlock(const RollerRaceModel& model, RollersOnRace& rollers,
                                 bool load_slip, bool rolls, RaceContactTotals& sums,
                                 std::vector<double>& fastest)
    : model_(model),
      load_slip_(load_slip),
      fastest_(fastest),
      sums_(sums),
      kernel_(statics::roller_kernel()),
      rollers_(rollers),
      actions_(rollers.count()),
      lobe_actions_(rollers.lobe_slopes() != nullptr ? rollers.count() : 0),
      rolling_actions_(rolls ? rollers.count() : 0) {
  sums_.damping_of.assign(rollers.count(), 0.0);
  if (rolls) sums_.rolling_of.assign(rollers.count(), 0.0);
  std::size_t slices = 0;
  for (const contact::RollerRaceSlices& one : model.slices) slices = std::max(slices, one.count);
  if (model.law.is_user_law()) user_scratch_.emplace(rollers.count(), slices);
}

/// Growing ψ is -y of the meridian frame.
void RollerRaceBlock::add_race_error_forces() noexcept {
  for (std::size_t i = 0; i < actions_.size(); ++i)
    actions_[i].force[1] += actions_[i].turning / rollers_.poses()[i].r;
}

void RollerRaceBlock::add_lobe_forces() noexcept {
  kernel_({rollers_.views(), rollers_.are_rollers_identical(), rollers_.count(),
           rollers_.poses().data(), rollers_.lobe_slopes(), lobe_actions_.data(), false,
           model_.law.index(), model_.law.address(), model_.law.regularization_slip_squared(),
           nullptr, nullptr, nullptr});
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    if (!model_.lobes[i] || !(actions_[i].energy > 0.0)) continue;
    const Vec3& a = rollers_.axes()[i];
    const double turning = lobe_actions_[i].turning / (a[0] * a[0] + a[1] * a[1]);
    actions_[i].force[1] += turning * a[0] / rollers_.poses()[i].r;
    actions_[i].moment[0] += turning * a[0];
    actions_[i].moment[1] += turning * a[1];
  }
}

void RollerRaceBlock::apply(Evaluation& e) noexcept {
  const auto j = static_cast<std::size_t>(model_.race);
  rollers_.place(e);
  kernel_({rollers_.views(), rollers_.are_rollers_identical(), rollers_.count(),
           rollers_.poses().data(), rollers_.slopes(), actions_.data(), model_.traction,
           model_.law.index(), model_.law.address(), model_.law.regularization_slip_squared(),
           user_scratch_ ? user_scratch_->view() : nullptr,
           rolling_actions_.empty() ? nullptr : &model_.rolling, rolling_actions_.data()});
  if (rollers_.slopes() != nullptr) add_race_error_forces();
  if (rollers_.lobe_slopes() != nullptr) add_lobe_forces();
  sums_.heat = sums_.load_slip = sums_.damping = 0.0;
  if (!rolling_actions_.empty()) sums_.rolling = 0.0;
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const statics::RollerKernelAction& a = actions_[i];
    e.load[j][i] = a.load;
    e.heat[j][i] = a.heat;
    fastest_[i] = a.fastest;
    if (load_slip_) e.load_slip[j][i] = a.load_slip;
    e.valid = e.valid && a.load <= model_.load_limit;  // false for a NaN
    e.elastic += a.energy;
    sums_.damping += a.damping;
    sums_.damping_of[i] = a.damping;
    if (!rolling_actions_.empty()) sums_.rolling_of[i] = 0.0;
    if (!(a.energy > 0.0)) continue;
    rollers_.apply_roller_action(e, i, a.force, a.moment);
    if (!rolling_actions_.empty()) {
      rollers_.apply_roller_action(e, i, rolling_actions_[i].force, rolling_actions_[i].moment);
      sums_.rolling += rolling_actions_[i].heat;
      sums_.rolling_of[i] = rolling_actions_[i].heat;
    }
    sums_.heat += a.heat;
    sums_.load_slip += a.load_slip;
  }
  sums_.load_slip_element1 = actions_.front().load_slip;
}

RollerRaceRolling::RollerRaceRolling(const RollerRaceModel& model, std::size_t rollers,
                                     RaceContactTotals& sums)
    : model_(model),
      sums_(sums),
      kernel_(statics::rolling_resistance_kernel()),
      rollers_(model, rollers),
      actions_(rollers) {
  sums_.rolling_of.assign(rollers, 0.0);
}

void RollerRaceRolling::apply(Evaluation& e) noexcept {
  rollers_.place(e);
  kernel_({rollers_.views(), rollers_.are_rollers_identical(), rollers_.count(),
           rollers_.poses().data(), actions_.data(), &model_.rolling});
  sums_.rolling = 0.0;
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    sums_.rolling_of[i] = 0.0;
    if (rollers_.poses()[i].open) continue;
    rollers_.apply_roller_action(e, i, actions_[i].force, actions_[i].moment);
    sums_.rolling += actions_[i].heat;
    sums_.rolling_of[i] = actions_[i].heat;
  }
}

}  // namespace adore::dynamics

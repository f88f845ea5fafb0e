#include "dynamics/effects/races.hpp"

#include "base/errors.hpp"
#include "bearing/given_surface.hpp"
#include "contact/make_angle_law.hpp"
#include "contact/wavy_groove_model.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/balls.hpp"
#include "dynamics/effects/contact_damping.hpp"
#include "dynamics/effects/rigid_elements.hpp"
#include "dynamics/effects/user_motion.hpp"
#include "dynamics/hertz_limit.hpp"
#include "dynamics/rigid_body.hpp"
#include "dynamics/user_points.hpp"
#include "scene/no_film.hpp"
#include "scene/user_laws.hpp"
#include "tribology/contact_flash.hpp"
#include "tribology/film_law.hpp"
#include "tribology/largest_slip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::dynamics {
namespace {

/// On elements and cage, by the prescribed motion of each race.
constexpr LedgerTerm kWork{LedgerKind::Work,
                           "work",
                           "work of the races",
                           {"work of the outer race", "work of the inner race"},
                           "work done by the prescribed motion of the races since the start"};
constexpr LedgerTerm kHeat{LedgerKind::Heat,
                           "heat",
                           "heat at the races",
                           {"outer race contacts", "inner race contacts"},
                           "dissipated since the start"};
constexpr const LedgerTerm* kTerms[] = {&kWork, &kHeat};

/// What films of one race read. Walls have the mean bulk temperature of race and ball for the run.
tribology::RaceFilmInputs film_surface(const bearing::Bearing& bearing,
                                       const RaceContactModel& model, double contact_angle,
                                       bool single) {
  const auto j = static_cast<std::size_t>(model.race);
  tribology::RaceFilmInputs surface;
  surface.radius =
      1.0 /
      contact::race_curvature(bearing.balls(), static_cast<int>(j), contact_angle).along_minor;
  surface.modulus = 2.0 * model.effective_modulus;
  surface.wall_temperature = 0.5 * (bearing.race_temperature[j] + bearing.element_temperature);
  surface.race_speed = 0.5 * bearing.pitch_diameter() *
                       std::max(std::abs(bearing.speed[0]), std::abs(bearing.speed[1]));
  // b/p0: both go with the cube root of the load.
  surface.width_over_pressure =
      std::numbers::pi / 1.5 * model.hertz.a_hat * model.hertz.b_hat * model.hertz.b_hat;
  surface.walls = {tribology::film_wall(bearing.race_material[j]),
                   tribology::film_wall(bearing.element_material)};
  surface.single = single;
  return surface;
}

/// The deck's curve, or its lubricant's film with the curve where it breaks down.
tribology::TractionLaw race_law(const bearing::Bearing& bearing,
                                const tribology::RaceFilmInputs& surface) {
  if (!bearing.lubrication) return bearing.race_traction;
  return tribology::film_law(bearing.race_traction, tribology::lubricant_of(*bearing.lubrication),
                             *bearing.lubrication, surface);
}

/// Where the contacts of one race go, and whether they can be believed.
class RaceBooks {
 public:
  /// @param load_slip it is wanted: by the wear integrals, or by elements in balance
  RaceBooks(const RaceContactModel& model, bool load_slip, RaceContactTotals& sums)
      : model_(model), load_slip_index_(load_slip), load_limit_(load_limit(model)), sums_(sums) {}
  [[nodiscard]] ElementForces out(Evaluation& e) const noexcept {
    const auto j = static_cast<std::size_t>(model_.race);
    return element_force_targets(e.actions, e.load[j].data(), e.heat[j].data(),
                                 load_slip_index_ ? e.load_slip[j].data() : nullptr);
  }
  /// @param halves,second of a split race
  void book(Evaluation& e, const RaceSums& sums, const OtherHalfLoads* halves = nullptr,
            const RaceContactModel* second = nullptr) noexcept;

 private:
  const RaceContactModel& model_;
  bool load_slip_index_;
  double load_limit_;
  RaceContactTotals& sums_;
};

void RaceBooks::book(Evaluation& e, const RaceSums& sums, const OtherHalfLoads* halves,
                     const RaceContactModel* second) noexcept {
  const auto j = static_cast<std::size_t>(model_.race);
  RaceBody& race = e.race[j];
  race.force += sums.force;
  race.moment += sums.moment;
  e.elastic += sums.elastic_energy;
  sums_.heat = sums.heat;
  sums_.damping = sums.damping;
  sums_.load_slip = sums.load_slip;
  sums_.load_slip_element1 = e.load_slip[j][0];
  if (halves != nullptr) sums_.load_slip_element1 += halves->load_slip[0];
  // The heavier contact of a split race has at least half of its ellipse.
  const double limit = halves != nullptr ? 0.5 * load_limit_ : load_limit_;
  bool doubtful = false;
  for (const double Q : e.load[j]) doubtful = doubtful || Q > limit;
  if (!doubtful) return;
  for (std::size_t i = 0; i < e.load[j].size(); ++i) {
    if (!(e.load[j][i] > limit)) continue;
    const RaceContactModel& model =
        (halves != nullptr && halves->swapped[i] != 0 ? *second : model_).of(i);
    e.valid =
        e.valid && is_hertz_valid(model, race_contact_state(model, e.elements, i, race.motion()));
  }
}

/// A split race: one half after the other.
class SplitRaceBlock final : public EffectBlock {
 public:
  SplitRaceBlock(const RaceContactModel& first, const RaceContactModel& second, bool load_slip,
                 OtherHalfLoads& halves, RaceContactTotals& sums)
      : first_(first),
        second_half_model_(second),
        other_half_loads_(halves),
        load_slip_index_(load_slip),
        books_(first, load_slip, sums) {}
  void apply(Evaluation& e) noexcept override {
    const auto j = static_cast<std::size_t>(first_.race);
    const RaceMotion race = e.race[j].motion();
    const ElementForces out = books_.out(e);
    RaceSums sums = evaluate_race_contacts(first_, e.elements, race, out);
    const ElementForces other = element_force_targets(
        e.actions, other_half_loads_.load.data(), other_half_loads_.heat.data(),
        load_slip_index_ ? other_half_loads_.load_slip.data() : nullptr);
    const RaceSums more = evaluate_race_contacts(second_half_model_, e.elements, race, other);
    sums.force += more.force;
    sums.moment += more.moment;
    sums.elastic_energy += more.elastic_energy;
    sums.heat += more.heat;
    sums.load_slip += more.load_slip;
    sums.damping += more.damping;
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      other_half_loads_.swapped[i] = other_half_loads_.load[i] > e.load[j][i] ? 1 : 0;
      if (other_half_loads_.swapped[i] == 0) continue;
      std::swap(other_half_loads_.load[i], e.load[j][i]);
      std::swap(other_half_loads_.heat[i], e.heat[j][i]);
      std::swap(other_half_loads_.load_slip[i], e.load_slip[j][i]);
    }
    books_.book(e, sums, &other_half_loads_, &second_half_model_);
  }

 private:
  const RaceContactModel &first_, &second_half_model_;
  OtherHalfLoads& other_half_loads_;
  bool load_slip_index_;
  RaceBooks books_;
};

class RaceBlock final : public EffectBlock {
 public:
  RaceBlock(const RaceContactModel& model, bool load_slip, RaceContactTotals& sums)
      : model_(model), books_(model, load_slip, sums) {}
  void apply(Evaluation& e) noexcept override {
    const RaceMotion race = e.race[static_cast<std::size_t>(model_.race)].motion();
    books_.book(e, evaluate_race_contacts(model_, e.elements, race, books_.out(e)));
  }

 private:
  const RaceContactModel& model_;
  RaceBooks books_;
};

/// Both races at once, which no effect integrates: as two blocks, to rounding.
class BothRacesBlock final : public EffectBlock {
 public:
  BothRacesBlock(const std::array<RaceContactModel, 2>& models, bool load_slip,
                 std::array<RaceContactTotals, 2>& sums)
      : models_(models),
        books_{RaceBooks(models[0], load_slip, sums[0]), RaceBooks(models[1], load_slip, sums[1])} {
  }
  void apply(Evaluation& e) noexcept override {
    const auto sums =
        evaluate_both_races(models_, e.elements, {e.race[0].motion(), e.race[1].motion()},
                            {books_[0].out(e), books_[1].out(e)});
    for (std::size_t j = 0; j < 2; ++j) books_[j].book(e, sums[j]);
  }

 private:
  const std::array<RaceContactModel, 2>& models_;
  std::array<RaceBooks, 2> books_;
};

/// Prescribed races at their static place with their spin: what other prescribed motions add to.
class RaceSpin final : public EffectBlock {
 public:
  RaceSpin(const std::array<RaceBody, 2>& initial_races, const std::array<double, 2>& turned_before)
      : initial_races_(initial_races), prior_rotation_(turned_before) {}
  void apply(Evaluation& e) noexcept override {
    for (std::size_t j = 0; j < 2; ++j) {
      RaceBody& race = e.race[j];
      if (race.moves == Moves::Integrated) continue;
      race = initial_races_[j];
      race.angle = race.turn_beyond = race.speed * e.t + prior_rotation_[j];
    }
  }

 private:
  const std::array<RaceBody, 2>& initial_races_;
  const std::array<double, 2>& prior_rotation_;
};

/// Keeps what holds races that are prescribed.
class HoldingForces final : public EffectBlock {
 public:
  explicit HoldingForces(std::array<RaceContactTotals, 2>& account) : contact_totals_(account) {}
  void apply(Evaluation& e) noexcept override {
    for (std::size_t j = 0; j < 2; ++j)
      if (e.race[j].moves != Moves::Integrated)
        contact_totals_[j].keep(Vec3(-e.race[j].force), Vec3(-e.race[j].moment));
  }

 private:
  std::array<RaceContactTotals, 2>& contact_totals_;
};

class RacePower final : public EffectBlock {
 public:
  explicit RacePower(std::array<RaceContactTotals, 2>& account) : contact_totals_(account) {}
  void apply(Evaluation& e) noexcept override {
    // -F·v - M·ω, with ω as the kernel has it.
    for (std::size_t j = 0; j < 2; ++j) {
      const RaceBody& race = e.race[j];
      contact_totals_[j].power = -race.force.dot(race.velocity) -
                                 race.speed * race.moment.dot(race.axis()) -
                                 race.moment.dot(race.tilt);
    }
  }

 private:
  std::array<RaceContactTotals, 2>& contact_totals_;
};

}  // namespace

namespace {

/// Of each ball; null: all are round.
const std::vector<std::shared_ptr<const bearing::SurfaceSeries>>* forms_of(
    const SceneBuilder& scene) {
  return scene.options.user && !scene.options.user->out_of_round.empty()
             ? &scene.options.user->out_of_round
             : nullptr;
}

/// A groove with errors, or any under balls that are not round, with all that it reads.
std::shared_ptr<const contact::WavyGroove> wavy_groove(const SceneBuilder& scene, std::size_t j,
                                                       const bearing::RaceErrors& errors) {
  struct Kept {
    contact::WavyGroove groove;
    std::vector<std::shared_ptr<const bearing::SurfaceSeries>> given;
    std::vector<contact::SurfaceDeviationTable> of_ball;
    contact::BallFormErrors forms;
  };
  auto kept = std::make_shared<Kept>();
  kept->groove = contact::make_wavy_groove(scene.bearing.balls(), static_cast<int>(j), errors,
                                           scene.fixed_angle[j]);
  if (const auto* const forms = forms_of(scene)) {
    kept->given = *forms;
    for (const auto& one : *forms) {
      kept->of_ball.emplace_back();
      if (const bearing::SurfaceTable* const t = bearing::table_of(one.get()))
        kept->of_ball.back() = {t->height.data(), nullptr, t->around, t->across,
                                t->first,         t->step, 1.0};
    }
    demand(!scene.e.attitude.empty(), "the orientation of out-of-round balls is not computed");
    kept->forms.of_ball = kept->of_ball.data();
    kept->forms.attitude = scene.e.attitude.front().data();  // for all evaluations
    kept->groove.forms = &kept->forms;
  }
  return {kept, &kept->groove};
}

/// A race whose land is no circle pushes the cage around, and so does one in a cage that is none.
bool has_uneven_lands(const SceneBuilder& scene) {
  if (!scene.plan.has(Effect::LandContact) || !scene.bearing.cage) return false;
  const auto& lands = scene.bearing.cage->lands;
  return std::any_of(lands.begin(), lands.end(),
                     [](const bearing::GuideLand& land) { return !land.ideal(); });
}

}  // namespace

void Races::place(const SceneBuilder& scene, const std::array<double, 2>& centre_x) {
  const auto& misalignment = scene.bearing.constraints.outer_misalignment;
  const auto& displacement = scene.statics.displacement;
  initial_races_[0].set_attitude(quaternion_from_angles({0.0, misalignment[0], misalignment[1]}));
  initial_races_[1].set_attitude(quaternion_from_angles({0.0, displacement[3], displacement[4]}));
  for (std::size_t j = 0; j < 2; ++j) {
    unloaded_race_centers_[j] = Vec3(centre_x[j], 0.0, 0.0);
    RaceBody& race = initial_races_[j];
    race.position = unloaded_race_centers_[j];
    race.speed = scene.bearing.speed[j];
    race.settle();
  }
  initial_races_[1].position += Vec3(displacement[0], displacement[1], displacement[2]);
}

void Races::set_up_balls(const SceneBuilder& scene) {
  const contact::GrooveGeometry groove = contact::groove_geometry(scene.bearing.balls());
  const tribology::EllipseNodeCounts nodes{scene.options.ellipse_major,
                                           scene.options.ellipse_minor};
  const tribology::EllipseRule rule =
      scene.bearing.lubrication ? tribology::make_run_rule(nodes)
                                : tribology::make_split_ellipse_rule(nodes.major, nodes.minor);
  for (std::size_t j = 0; j < 2; ++j) {
    RaceContactModel& model = contacts_[j];
    model.race = static_cast<bearing::Race>(j);
    model.groove = groove;
    model.effective_modulus =
        bearing::contact_modulus(scene.bearing.element_material, scene.bearing.race_material[j]);
    model.hertz = contact::hertz_constants(
        contact::race_curvature(scene.bearing.balls(), static_cast<int>(j), scene.fixed_angle[j]),
        model.effective_modulus);
    const bearing::RaceErrors& errors = scene.bearing.imperfections.race[j];
    user_race_surfaces_[j] = errors.given;
    if (!errors.ideal() || forms_of(scene) != nullptr) model.wavy = wavy_groove(scene, j, errors);
    if (scene.options.moving_angle)
      model.angle = contact::make_angle_law(scene.bearing.balls(), static_cast<int>(j),
                                            model.effective_modulus);
    model.shoulder_radius = 0.5 * scene.bearing.balls().shoulder_diameter[j];
    model.damping = race_damping(scene.plan, scene.bearing, scene.options, scene.statics, j);
    model.traction = scene.plan.has(Effect::RaceTraction);
    model.surface = scene.options.surface;
    model.rule = rule;
    const tribology::RaceFilmInputs surface =
        film_surface(scene.bearing, model, scene.fixed_angle[j], scene.options.single_films);
    if (scene.plan.has(Effect::RollingResistance))
      rolling_resistance_[j] = tribology::rolling_resistance(
          tribology::lubricant_of(*scene.bearing.lubrication), *scene.bearing.lubrication, surface);
    const tribology::UserTractionRoutine* routine =
        scene.options.user ? scene.options.user->traction_of(tribology::TractionKind::ElementRace)
                           : nullptr;
    if (routine != nullptr) {
      model.law = {*routine, tribology::TractionKind::ElementRace, static_cast<int>(j)};
      model.points = std::make_shared<UserScratch>(
          static_cast<std::size_t>(scene.bearing.element_count()), rule.s.size() * rule.v.size());
    } else {
      model.law = race_law(scene.bearing, surface);
      if (j == 0 && scene.bearing.lubrication)
        approximation_note_ =
            tribology::describe_film_evaluation(tribology::lubricant_of(*scene.bearing.lubrication),
                                                *scene.bearing.lubrication, surface);
    }
    const auto count = static_cast<std::size_t>(scene.bearing.element_count());
    const auto halves =
        contact::split_race_halves(scene.bearing.balls(), groove, static_cast<int>(j));
    model.half = halves[0];
    const RaceContactModel whole = model;
    const auto& growth = scene.bearing.imperfections.ball_diameter;
    set_unequal_balls(model, scene.bearing.balls(), errors, growth, scene.fixed_angle[j], count);
    if (!model.half.is_split()) continue;
    demand(!model.wavy, "a split race cannot have geometric errors");
    second_half_model_[j] = whole;
    second_half_model_[j]->half = halves[1];
    set_unequal_balls(*second_half_model_[j], scene.bearing.balls(), errors, growth,
                      scene.fixed_angle[j], count);
    OtherHalfLoads& loads = other_half_loads_[j];
    for (auto* values : {&loads.load, &loads.heat, &loads.load_slip}) values->assign(count, 0.0);
    loads.swapped.assign(count, 0);
  }
  place(scene, groove.centre_x);
}

void Races::declare_contacts(SceneBuilder& scene) {
  const bool wear = scene.plan.has(Effect::WearIntegrals);
  const bool held =
      scene.plan.has(Effect::LightLoadBalance) || scene.plan.has(Effect::ElementBalance);
  has_contact_sums_ = contacts_[0].traction && wear && !held;
  const auto count = static_cast<std::size_t>(scene.bearing.element_count());
  if (rollers_) {
    for (std::size_t j = 0; j < 2; ++j) {
      rollers_on_race_[j].emplace((*rollers_)[j], count);
      roller_report_[j].emplace((*rollers_)[j], *rollers_on_race_[j]);
      fastest_[j].resize(count);
    }
  } else {
    kept_.size(count);
    scene.block<StoreElementStates>(Phase::Account, kMotionCost, {}, kept_);
  }
  const auto& free = scene.plan.race_motions.free;
  // A race that moves is a partner of its own.
  if (!rollers_ && !held && !free[0] && !free[1] && can_share_vectors(contacts_))
    scene.block<BothRacesBlock>(Phase::Force, "race contacts", {}, contacts_, wear,
                                contact_totals_);
  else
    for (std::size_t j = 0; j < 2; ++j) declare_contact(scene, j, wear || held);
}

void Races::declare_contact(SceneBuilder& scene, std::size_t j, bool load_slip) {
  const std::string cost = j == 0 ? "outer race contacts" : "inner race contacts";
  const BodyId race{BodyId::Kind::Race, static_cast<int>(j)};
  const bool rolls = rollers_ && scene.plan.has(Effect::RollingResistance) &&
                     (*rollers_)[j].rolling_uses_traction_film();
  if (rollers_)
    scene.block<RollerRaceBlock>(Phase::Force, rolls ? cost + ", rolling in oil" : cost, race,
                                 (*rollers_)[j], *rollers_on_race_[j], load_slip, rolls,
                                 contact_totals_[j], fastest_[j]);
  else if (second_half_model_[j])
    scene.block<SplitRaceBlock>(Phase::Force, cost, race, contacts_[j], *second_half_model_[j],
                                load_slip, other_half_loads_[j], contact_totals_[j]);
  else
    scene.block<RaceBlock>(Phase::Force, cost, race, contacts_[j], load_slip, contact_totals_[j]);
}

void Races::declare(SceneBuilder& scene) {
  if (scene.rollers != nullptr) {
    rollers_ = roller_race_models(scene);
    approximation_note_ = (*rollers_)[0].approximation_note;
    place(scene, {});  // their reference point is the middle of the bearing
  } else {
    set_up_balls(scene);
  }
  scene.e.race = initial_races_;
  scene.block<RaceSpin>(Phase::Races, kMotionCost, {}, initial_races_, prior_rotation_);
  temperature_ = scene.bearing.race_temperature;
  roughness_ = rollers_ ? scene.bearing.rollers()->roughness : scene.bearing.balls().roughness;
  material_ = {scene.bearing.race_material[0], scene.bearing.race_material[1],
               scene.bearing.element_material};
  const ScenePlan& plan = scene.plan;
  has_race_contact_ = plan.has(Effect::RaceContact);
  has_rolling_resistance_ = plan.has(Effect::RollingResistance);
  for (auto* values : {&slip_, &other_slip_, &scratch_})
    values->resize(static_cast<std::size_t>(scene.bearing.element_count()));
  const bool traction = plan.has(Effect::RaceTraction), wear = plan.has(Effect::WearIntegrals);
  // Without friction a body of revolution that only spins about its axis exerts no power.
  const auto& errors = scene.bearing.imperfections.race;
  const bool work = traction || plan.has(Effect::RollingResistance) || has_uneven_lands(scene) ||
                    !errors[0].ideal() || !errors[1].ideal() || plan.has(Effect::LandTraction) ||
                    plan.has(Effect::FlangeTraction) || plan.has(Effect::ElementDrag) ||
                    plan.has(Effect::CageDrag) || plan.has(Effect::LandFilm) ||
                    has_user_motion(plan) || scene.races_move();
  if (has_race_contact_) declare_contacts(scene);
  const std::array<std::string, 2> names{"outer race", "inner race"};
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string& name = names[j];
    RaceContactTotals& account = contact_totals_[j];
    if (work && !plan.race_motions.free[j])
      scene.energy(name + ".work", kWork, &account.power, static_cast<int>(j));
    const bool damped = rollers_ ? contact::is_damped((*rollers_)[j].slices.front().damping)
                                 : contact::is_damped(contacts_[j].damping);
    if (damped)
      scene.energy(name + ".damping", kRaceDamping, &account.damping, static_cast<int>(j));
    if (!traction) continue;
    scene.energy(name + ".heat", kHeat, &account.heat, static_cast<int>(j));
    if (!wear) continue;
    scene.integral(load_slip_index_[j], name + ".load_slip", "J", &account.load_slip);
    scene.integral(load_slip_element1_index_[j], name + ".load_slip_element1", "J",
                   &account.load_slip_element1);
  }
  scene.block<HoldingForces>(Phase::Account, kMotionCost, {}, contact_totals_);
  if (work) scene.block<RacePower>(Phase::Account, kMotionCost, {}, contact_totals_);
  if (has_race_contact_ && !rollers_ &&
      !plan.has(Effect::ElementBalance)) {  // whose balls do not vibrate
    const Balls* balls = scene.find<Balls>();
    std::vector<RaceContactModel> models(contacts_.begin(), contacts_.end());
    for (const auto& other : second_half_model_)
      if (other) models.push_back(*other);
    normal_contacts_.emplace(
        std::move(models),
        balls != nullptr ? balls->slices() : scene.find<RigidElements>()->slices(),
        ElementMasses(scene.bearing));
  }
}

std::array<std::array<contact::SplitRaceHalf, 2>, 2> Races::halves() const noexcept {
  std::array<std::array<contact::SplitRaceHalf, 2>, 2> out;
  for (std::size_t j = 0; j < 2; ++j)
    if (second_half_model_[j]) out[j] = {contacts_[j].half, second_half_model_[j]->half};
  return out;
}

const RaceContactModel& Races::model_of(std::size_t j, std::size_t i, bool other) const noexcept {
  if (!second_half_model_[j]) return contacts_[j].of(i);
  return ((other_half_loads_[j].swapped[i] != 0) != other ? *second_half_model_[j] : contacts_[j])
      .of(i);
}

void Races::prescribe(double, PrescribedRaces& races) const {
  for (std::size_t j = 0; j < 2; ++j) {
    races[j].position += initial_races_[j].position;
    races[j].attitude = initial_races_[j].attitude;
    races[j].speed += initial_races_[j].speed;
    races[j].turned_before = prior_rotation_[j];
  }
}

void Races::go_on(const PrescribedRaces& before, const PrescribedRaces& now, std::span<double>) {
  for (std::size_t j = 0; j < 2; ++j) {
    // Not what rounding leaves: runs under one speed join to the same bytes.
    const double made = now[j].angle - now[j].turned_before;
    const double beyond = before[j].angle - made;
    const bool same =
        std::abs(beyond - before[j].turned_before) <= 1e-12 * std::abs(before[j].angle);
    prior_rotation_[j] = same ? before[j].turned_before : beyond;
  }
}

double Races::stiffness(double force) const {
  if (rollers_)
    return std::max(line_stiffness((*rollers_)[0], 1e-3 * force),
                    line_stiffness((*rollers_)[1], 1e-3 * force));
  const double K = std::max(contacts_[0].hertz.K, contacts_[1].hertz.K);
  return 1.5 * std::cbrt(K * K * 1e-3 * force);
}

std::string Races::why_invalid(const Evaluation& e) const {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      double radius = 0.0;  // of a ball
      bool sunk = false, long_ellipse = false;
      if (rollers_) {
        sunk = e.load[j][i] > (*rollers_)[j].load_limit;
      } else {
        const RaceContactModel& model = model_of(j, i);
        const RaceContactState state = race_contact_state(model, e.elements, i, e.race[j].motion());
        radius = model.groove.ball_radius;
        sunk = state.approach >= radius;
        long_ellipse = state.ellipse.a >= radius;
      }
      if (sunk)
        return fmt::format(
            "element {} is pressed into the {} race by more than the element radius; reduce the "
            "largest step (stpMax)",
            i + 1, j == 0 ? "outer" : "inner");
      if (long_ellipse)
        return fmt::format(
            "the load of {:.6g} N between element {} and the {} race makes the contact ellipse too "
            "long: its semi-major axis reaches the radius of the element ({:.4g} m). The groove "
            "radius is almost equal to the element radius, so Hertz theory is not valid. Enter a "
            "larger groove factor or a smaller load. If the load is a numerical peak of the run, "
            "reduce the largest step (stpMax)",
            e.load[j][i], i + 1, j == 0 ? "outer" : "inner", radius);
    }
  return {};
}

/// Of a ball, without a second integral where the right-hand side has just taken it.
RaceContactSnapshot Races::detail(const Evaluation& e, std::size_t j, std::size_t i,
                                  bool second) const {
  const RaceContactModel& model = model_of(j, i, second);
  const RaceMotion motion = e.race[j].motion();
  const ContactSums sums =
      second ? ContactSums{other_half_loads_[j].heat[i], other_half_loads_[j].load_slip[i]}
             : ContactSums{e.heat[j][i], e.load_slip[j][i]};
  RaceContactSnapshot out = has_contact_sums_
                                ? race_contact_detail(model, e.elements, i, motion, sums)
                                : race_contact_detail(model, e.elements, i, motion);
  if (has_rolling_resistance_)
    out.rolling_heat = race_rolling_heat(model, rolling_resistance_[j],
                                         race_contact_state(model, e.elements, i, motion));
  return out;
}

void Races::complete(RaceContactSnapshot& contact, std::size_t j, bool in_oil) const {
  if (in_oil && contact.load > 0.0) {
    if (roughness_[j] > 0.0)
      contact.film_parameter = std::max(contact.least_film / roughness_[j], scene::kNoFilmLeft);
    const double area =
        (rollers_ ? 4.0 : std::numbers::pi) * contact.half_major * contact.half_minor;
    contact.temperature_rise =
        tribology::contact_flash({contact.heat, area, contact.half_minor, contact.rolling_speed},
                                 material_[j], material_[2]);
  }
  contact.contact_temperature = temperature_[j] + contact.temperature_rise;
}

void Races::report(const Evaluation& e, Snapshot& snapshot) const {
  snapshot.shaft_rotation = e.race[1].angle - e.race[0].angle;
  if (second_half_model_[0] || second_half_model_[1])
    for (scene::ElementSnapshot& element : snapshot.elements) element.second.assign(2, {});
  for (std::size_t j = 0; j < 2; ++j) {
    const RaceBody& body = e.race[j];
    RaceSnapshot& race = snapshot.races[j];
    race.position = body.position - unloaded_race_centers_[j];
    race.velocity = body.velocity;
    race.acceleration = body.acceleration;
    race.total_rotation = body.angle;
    race.orientation = body.orientation();
    race.omega = body.omega;
    race.applied_force = race.carried_force = -body.force;
    race.applied_moment = -body.moment;
    snapshot.power.integrated = load_slip_index_[j] >= 0;
    snapshot.power.qv_race[j] = integral_at(e, load_slip_index_[j]);
    snapshot.power.qv_element1[j] = integral_at(e, load_slip_element1_index_[j]);
    if (!has_race_contact_) continue;
    const bool in_oil = rollers_ ? (*rollers_)[j].traction && (*rollers_)[j].law.has_film()
                                 : contacts_[j].traction && contacts_[j].law.has_film();
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      RaceContactSnapshot& contact = snapshot.elements[i].race[j];
      if (!rollers_) {
        contact = detail(e, j, i);
      } else {
        roller_report_[j]->fill(e, i, contact);
        const RaceContactTotals& sums = contact_totals_[j];
        if (!sums.rolling_of.empty()) contact.rolling_heat = sums.rolling_of[i];
        if (!sums.damping_of.empty()) contact.damping_heat = sums.damping_of[i];
      }
      complete(contact, j, in_oil);
      if (!second_half_model_[j]) continue;
      std::vector<RaceContactSnapshot>& others = snapshot.elements[i].second;
      others[j] = detail(e, j, i, true);
      complete(others[j], j, in_oil);
      contact.rolling_heat += others[j].rolling_heat;
      contact.damping_heat += others[j].damping_heat;
    }
  }
}

double Races::speed_to_resolve(const Evaluation& e, double near) const {
  constexpr double kSpeedExponent = 0.67;  // of film thickness over rolling speed [hamrock1977]
  constexpr double kThinnest = 1e-9;       // no film is thinner than some molecules [m]
  constexpr double kSlides = 0.1;          // slip over `near`: the contact slides
  double out = std::numeric_limits<double>::infinity();
  if (!has_race_contact_) return out;
  for (std::size_t j = 0; j < 2; ++j) {
    const bool traction = rollers_ ? (*rollers_)[j].traction : contacts_[j].traction;
    const tribology::TractionLaw& law = rollers_ ? (*rollers_)[j].law : contacts_[j].law;
    if (!traction || !law.has_film()) continue;
    const double critical = std::max(law.critical_film(), kThinnest);
    const auto consider = [&](double speed, double slip, double film) {
      if (speed < near && slip > kSlides * near && film > 0.0)
        out = std::min(out, speed * std::pow(critical / film, 1.0 / kSpeedExponent));
    };
    if (rollers_) {
      for (std::size_t i = 0; i < e.elements.n; ++i) {
        RaceContactSnapshot contact;
        roller_report_[j]->fill(e, i, contact);
        if (contact.load > 0.0)
          consider(contact.rolling_speed, contact.max_slip, contact.least_film);
      }
      continue;
    }
    const ElementViews elements = kept_.elements(e);
    for (std::size_t i = 0; i < elements.n; ++i) {
      if (!(e.load[j][i] > 0.0)) continue;
      const RaceContactModel& model = model_of(j, i);
      const RaceContactState at = race_contact_state(model, elements, i, kept_.race(j));
      const double speed = std::max(std::abs(at.motion.entrainment), 1e-3 * near);
      if (!(speed < near) || !(at.approach > 0.0)) continue;
      const tribology::EllipseGeometry& ellipse = at.ellipse;
      const double pressure = 1.5 * ellipse.Q / (std::numbers::pi * ellipse.a * ellipse.b);
      const double slip = tribology::middle_slip(ellipse, at.motion);
      consider(
          speed, slip,
          law.film({ellipse.Q, pressure, ellipse.a, ellipse.b, speed, slip, at.motion.curvature})
              .thinnest);
    }
  }
  return out;
}

void Races::sample_slips(const Evaluation& e, std::size_t j) const noexcept {
  if (!has_race_contact_) return;  // stays 0
  if (!rollers_) {
    largest_slips(chosen_instruction_set(), contacts_[j], kept_.elements(e), kept_.race(j),
                  scratch_.data(), slip_.data());
    if (!second_half_model_[j]) return;
    std::vector<double>& other = other_slip_;
    largest_slips(chosen_instruction_set(), *second_half_model_[j], kept_.elements(e),
                  kept_.race(j), scratch_.data(), other.data());
    for (std::size_t i = 0; i < other.size(); ++i)
      if (other_half_loads_[j].swapped[i] != 0) slip_[i] = other[i];
    return;
  }
  if ((*rollers_)[j].traction)
    std::transform(fastest_[j].begin(), fastest_[j].end(), slip_.begin(),
                   [](double square) { return std::sqrt(square); });
  else
    rollers_on_race_[j]->largest_slips(slip_.data());
}

void Races::look(const Evaluation& e, Look& out) const {
  using enum ExtremeQuantity;
  for (const ExtremeQuantity what : {ContactLoad, ContactHeat, ContactSlip})
    out[what].resize(2 * e.load[0].size());
  for (std::size_t j = 0; j < 2; ++j) {
    sample_slips(e, j);
    for (std::size_t i = 0; i < e.load[j].size(); ++i) {
      out[ContactLoad][2 * i + j] = e.load[j][i];
      out[ContactHeat][2 * i + j] = e.heat[j][i];
      out[ContactSlip][2 * i + j] = slip_[i];
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
    for (const auto& [first, of] : {std::pair{RaceForceX, &RaceContactTotals::force},
                                    std::pair{RaceMomentX, &RaceContactTotals::moment}}) {
      std::vector<double>& both = out.values[static_cast<std::size_t>(first) + k];
      both.resize(2);
      for (std::size_t j = 0; j < 2; ++j) both[j] = (contact_totals_[j].*of)[k];
    }
}

void Races::add_quadrature_error(const Evaluation& e, scene::QuadratureError& error) const {
  if (!has_race_contact_ || rollers_) return;  // slices have no rule
  for (std::size_t j = 0; j < 2; ++j) {
    if (!contacts_[j].traction) continue;
    const tribology::EllipseRule& rule = contacts_[j].rule;
    const tribology::EllipseRule twice =
        tribology::make_split_ellipse_rule(2 * rule.major, 2 * rule.minor);
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      const RaceContactModel& model = model_of(j, i);
      const RaceContactState contact = race_contact_state(model, e.elements, i, e.race[j].motion());
      if (!(contact.ellipse.Q > 0.0)) continue;
      const auto fixed =
          tribology::ellipse_traction(model.law, contact.ellipse, contact.motion, model.rule);
      const auto exact =
          tribology::ellipse_traction(model.law, contact.ellipse, contact.motion, twice);
      if (!(exact.heat > 0.0)) continue;
      const double friction = exact.heat * contact.ellipse.Q / exact.load_slip;
      error.force = std::max(error.force,
                             std::hypot(fixed.F_c - exact.F_c, fixed.F_t - exact.F_t) / friction);
      error.heat_of_rule += fixed.heat;
      error.heat_of_finer += exact.heat;
    }
  }
}

std::unique_ptr<SceneEffect> make_races(const ScenePlan&) { return std::make_unique<Races>(); }
std::span<const LedgerTerm* const> race_terms() { return kTerms; }

}  // namespace adore::dynamics

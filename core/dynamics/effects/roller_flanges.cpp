#include "statics/roller_flanges.hpp"

#include "base/errors.hpp"
#include "contact/roller_race.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/contact_damping.hpp"
#include "dynamics/effects/gathered_traction.hpp"
#include "dynamics/effects/kept_values.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "dynamics/effects/user_forces.hpp"
#include "dynamics/roller_start.hpp"
#include "statics/roller_model.hpp"
#include "tribology/traction_law.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

/// Roller ends at the flanges of the races (contact/roller_flange.hpp), up to four: faces, ends and
/// constants of the equilibrium (statics/roller_flanges.hpp).
///
/// Normal: Q = K δ^1.5 on the roller along n at the contact point X (times the gap's steepness,
/// which is 1 but where a lip crosses a sharp corner), δ = -gap, K of the ideal roller's first
/// contact, so that the force has the potential 0.4 K δ^2.5. Friction of
/// record 10.2: slip u = v_race(X) - v_roller(X) without its part along n, Q κ(s)/s u on the
/// roller, s the rounded slip (tribology/rounded_law.hpp); the opposite of both on the race at the
/// same point of space. Heat = friction · u. With damping (contact_damping.hpp) Q of force and
/// friction is the total force. Limits: one contact of an end and a flange; spin in
/// the contact is left out.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kHeat{LedgerKind::Heat,
                           "flange_heat",
                           "heat at the flanges",
                           {"outer race flanges", "inner race flanges"},
                           "dissipated since the start"};
constexpr const LedgerTerm* kTerms[] = {&kHeat, &kFlangeDamping};

/// Contact of one roller end, base axes.
struct FlangeAction {
  contact::FlangeContact contact;  ///< in the roller's meridian frame
  Vec3 point = Vec3::Zero();
  Vec3 force = Vec3::Zero();  ///< on the roller [N]
  double load = 0.0, energy = 0.0, slip = 0.0, heat = 0.0;
  double opens = 0.0;    ///< d(gap)/dt, as the power of the force has it [m/s]
  double damping = 0.0;  ///< power that damping takes [W]

  /// dQ/dδ of the elastic load.
  [[nodiscard]] double stiffness(double elastic) const { return 1.5 * elastic / -contact.gap; }
};

/// A roller as its race sees it.
struct SeenRoller {
  contact::RacePose pose;
  contact::MeridianRotation turn;
  statics::Vec4 p = statics::Vec4::Zero();  ///< statics/slice_potential.hpp
  Vec3 axis = Vec3::UnitX();                ///< meridian frame

  [[nodiscard]] Vec3 centre() const { return {p(0), 0.0, p(1)}; }
  [[nodiscard]] Vec3 to_base(const Vec3& v) const {
    const contact::Triple<double> of_race = turn.from_meridian({v[0], v[1], v[2]});
    return pose.direction_from_race({of_race.x, of_race.y, of_race.z});
  }
};

SeenRoller seen(const Evaluation& e, std::size_t i, const RaceBody& race, double mass_offset) {
  SeenRoller out;
  out.pose = {race.position, race.to_base};
  const Vec3 a = e.attitude[i].col(0);
  const Vec3 C = out.pose.point(e.element_centre(i) - mass_offset * a);
  double r = 0.0;
  out.turn = contact::meridian_rotation(C[1], C[2], r);
  const Vec3 of_race = out.pose.direction(a);
  const contact::Triple<double> axis = out.turn.to_meridian({of_race[0], of_race[1], of_race[2]});
  out.axis = {axis.x, axis.y, axis.z};
  out.p = {C[0], r, axis.z, axis.y};
  return out;
}

/// A flat end is certainly in front of the flange face: neither face nor lip touch it. σ
/// (contact/roller_flange.hpp) changes by no more than the distance between two points, so the gap
/// of the corner is at least the smallest σ of its ring minus the corner radius. A box in (x, r)
/// bounds the ring.
bool is_in_front_of_face(const statics::FlangeEndPair& pair, const SeenRoller& roller) {
  const contact::FlangeFace& face = pair.face;
  const contact::RollerEnd& end = pair.end;
  const Vec3 out = end.sign * roller.axis;
  // Behind the ring the side of the roller must move away from the face.
  constexpr double kFacing = 0.9;
  if (!end.flat() || !(-face.m_x * out[0] > kFacing)) return false;
  constexpr double kRounding = 1e-15;  // [m]
  const double tilt = std::sqrt(out[1] * out[1] + out[2] * out[2]);
  const double y = end.ring * out[1], z = roller.p(1) + end.ring * out[2];
  const double middle = std::sqrt(y * y + z * z);
  const double r = face.m_r < 0.0 ? middle + end.ring_radius : middle - end.ring_radius;
  return face.sigma(roller.p(0) + end.ring * out[0], r) -
             std::abs(face.m_x) * end.ring_radius * tilt - end.corner_radius >
         kRounding;
}

template <class Friction>
FlangeAction act(const statics::FlangeEndPair& pair, const SeenRoller& roller, const Evaluation& e,
                 std::size_t i, const RaceBody& race, const contact::DampingLaw<>& damping,
                 const Friction& friction) {
  FlangeAction out;
  out.contact =
      contact::flange_contact_for_forces(pair.face, pair.end, roller.centre(), roller.axis);
  if (!(out.contact.gap < 0.0)) return out;
  const double gradient = contact::hertz_load(pair.K, -out.contact.gap);
  out.load = out.contact.steepness * gradient;
  out.energy = -0.4 * gradient * out.contact.gap;
  const Vec3 n = roller.to_base(out.contact.normal);
  out.point = race.position + roller.to_base(out.contact.point);
  Vec3 u = race.velocity_at(out.point) - e.element_velocity(i) -
           e.element_omega(i).cross(out.point - e.element_centre(i));
  out.opens = -u.dot(n);
  u += out.opens * n;
  if (contact::is_damped(damping)) {
    const double elastic = out.load;
    out.load = contact::damped_load(damping, elastic, out.stiffness(elastic), -out.contact.gap,
                                    -out.opens);
    out.damping = (elastic - out.load) * out.opens;
  }
  out.force = out.load * n;
  const double square = u.squaredNorm();
  out.slip = std::sqrt(square);
  if constexpr (!std::is_null_pointer_v<Friction>) {
    const double per_slip = friction_over_slip(friction, out.load, square);
    out.force += per_slip * u;
    out.heat = per_slip * square;
  }
  return out;
}

struct FlangeAccount {
  double heat = 0.0, load_slip = 0.0, damping = 0.0;  ///< now [W]
  double load_slip_element1 = 0.0;
};

class FlangeBlock final : public EffectBlock {
 public:
  FlangeBlock(const std::vector<std::vector<statics::FlangeEndPair>>& pairs, std::size_t race,
              double mass_offset, const tribology::TractionLaw* friction,
              const contact::DampingLaw<>& damping, FlangeAccount& account, LastContactValues& kept,
              LastContactValues& slip)
      : pairs_(pairs),
        race_(race),
        mass_offset_(mass_offset),
        friction_(friction),
        damping_(damping),
        account_(account),
        kept_(kept),
        slip_(slip) {}
  void apply(Evaluation& e) noexcept override {
    kept_.none();
    slip_.none();
    run_traction_passes(
        asked_, friction_, [&](const auto& law) { apply_with(law, e); }, static_cast<int>(race_));
  }

 private:
  template <class Friction>
  void apply_with(const Friction& friction, Evaluation& e) noexcept {
    RaceBody& race = e.race[race_];
    account_ = {};
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      const std::vector<statics::FlangeEndPair>& pairs = pairs_[pairs_.size() == 1 ? 0 : i];
      const SeenRoller roller = seen(e, i, race, mass_offset_);
      for (const statics::FlangeEndPair& pair : pairs) {
        if (static_cast<std::size_t>(pair.race) != race_ || pair.is_certainly_open(roller.p) ||
            is_in_front_of_face(pair, roller))
          continue;
        const FlangeAction a = act(pair, roller, e, i, race, damping_, friction);
        if (kOnlyNotes<Friction> || !(a.energy > 0.0)) continue;
        e.add_force(i, e.to_cylindrical(i, a.force));
        e.add_moment(i, e.to_cylindrical(i, (a.point - e.element_centre(i)).cross(a.force)));
        race.add_force(-a.force, a.point);
        e.elastic += a.energy;
        kept_.add(i, static_cast<std::size_t>(pair.side), a.load);
        slip_.add(i, static_cast<std::size_t>(pair.side), a.slip);
        account_.heat += a.heat;
        account_.damping += a.damping;
        account_.load_slip += a.load * a.slip;
        if (i == 0) account_.load_slip_element1 += a.load * a.slip;
      }
    }
  }

  const std::vector<std::vector<statics::FlangeEndPair>>& pairs_;
  std::size_t race_;
  double mass_offset_;
  const tribology::TractionLaw* friction_;
  contact::DampingLaw<> damping_;
  UserTractionBatch asked_;
  FlangeAccount& account_;
  LastContactValues& kept_;
  LastContactValues& slip_;
};

/// A contact that ADRX2 is asked for.
struct UserFlangeTouch {
  std::size_t roller = 0;
  int side = 0;
  FlangeAction action;
};
using UserFlangeForces = UserForces<UserFlangeTouch>;

/// ADRX2 (user_forces.hpp), of the flanges of one race.
class UserFlangeBlock final : public EffectBlock {
 public:
  UserFlangeBlock(const std::vector<std::vector<statics::FlangeEndPair>>& pairs, std::size_t race,
                  double mass_offset, const tribology::TractionLaw* friction,
                  const contact::DampingLaw<>& damping, UserFlangeForces& forces,
                  FlangeAccount& account, LastContactValues& kept)
      : pairs_(pairs),
        race_(race),
        mass_offset_(mass_offset),
        friction_(friction),
        damping_(damping),
        forces_(forces),
        account_(account),
        kept_(kept) {}
  void apply(Evaluation& e) noexcept override {
    RaceBody& race = e.race[race_];
    run_traction_passes(
        asked_, friction_, [&](const auto& law) { collect_all(law, e); }, static_cast<int>(race_));
    const bool valid =
        forces_.ask(e.t, [&](const UserFlangeTouch& touch, const UserForceDifference& by) {
          const FlangeAction& a = touch.action;
          const std::size_t i = touch.roller;
          const Vec3 force = by.ratio * a.force;
          e.add_force(i, e.to_cylindrical(i, force));
          e.add_moment(i, e.to_cylindrical(i, (a.point - e.element_centre(i)).cross(force)));
          race.add_force(-force, a.point);
          kept_.add(i, static_cast<std::size_t>(touch.side), by.force);
          account_.heat += by.ratio * a.heat + by.heat;
          account_.damping += by.damping;
          account_.load_slip += by.force * a.slip;
          if (i == 0) account_.load_slip_element1 += by.force * a.slip;
        });
    if (!valid) e.valid = false;
  }

 private:
  template <class Friction>
  void collect_all(const Friction& friction, const Evaluation& e) noexcept {
    forces_.clear();
    const RaceBody& race = e.race[race_];
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      const SeenRoller roller = seen(e, i, race, mass_offset_);
      for (const statics::FlangeEndPair& pair : pairs_[pairs_.size() == 1 ? 0 : i])
        if (static_cast<std::size_t>(pair.race) == race_ && !pair.is_certainly_open(roller.p))
          collect(friction, pair, roller, e, i, race);
    }
  }
  template <class Friction>
  void collect(const Friction& friction, const statics::FlangeEndPair& pair,
               const SeenRoller& roller, const Evaluation& e, std::size_t i,
               const RaceBody& race) noexcept {
    const FlangeAction a = act(pair, roller, e, i, race, {}, friction);
    if (!(a.load > 0.0)) return;
    forces_.collect(
        {i, static_cast<int>(pair.side), a}, i, 2 * race_ + static_cast<std::size_t>(pair.side),
        a.contact.gap, a.opens, a.load,
        damped_contact(damping_, a.load, a.stiffness(a.load), -a.contact.gap, -a.opens));
  }

  const std::vector<std::vector<statics::FlangeEndPair>>& pairs_;
  std::size_t race_;
  double mass_offset_;
  const tribology::TractionLaw* friction_;
  contact::DampingLaw<> damping_;
  UserTractionBatch asked_;
  UserFlangeForces& forces_;
  FlangeAccount& account_;
  LastContactValues& kept_;
};

class RollerFlanges final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.rollers != nullptr, "flanges need rollers");
    const statics::RollerModel model =
        statics::make_roller_model(scene.bearing, scene.rollers->options);
    for (const statics::RollerContactGeometry& body : model.bodies) pairs_.push_back(body.flanges);
    mass_offset_ = scene.bearing.roller_mass_offset;
    const bool traction = scene.plan.has(Effect::FlangeTraction);
    if (traction) {
      demand(scene.bearing.flange_traction.has_value(),
             "the flange traction is switched on, but has no traction curve");
      friction_ =
          traction_of(scene, tribology::TractionKind::RollerFlange, *scene.bearing.flange_traction);
    }
    has_friction_ = traction;
    scene::UserContactForce* const user = scene.options.user ? scene.options.user->flange : nullptr;
    for (std::size_t j = 0; j < 2; ++j) {
      for (auto* kept : {&kept_[j], &slip_[j]})
        kept->size(static_cast<std::size_t>(scene.bearing.element_count()), 2);
      if (!scene.bearing.rollers()->has_flange(static_cast<int>(j))) continue;
      const std::string name = j == 0 ? "outer race flanges" : "inner race flanges";
      // Flanges are part of the balance of tapered rollers (held_elements.hpp).
      if (!scene.plan.has(Effect::ElementBalance) || scene.bearing.type != bearing::Type::Tapered)
        damping_[j] =
            damping_law(scene, scene.bearing.element_material, scene.bearing.race_material[j],
                        scene.bearing.element_inertia.mass);
      scene.block<FlangeBlock>(Phase::Force, name, BodyId{BodyId::Kind::Race, static_cast<int>(j)},
                               pairs_, j, mass_offset_, traction ? &friction_ : nullptr,
                               damping_[j], account_[j], kept_[j], slip_[j]);
      if (user != nullptr) {
        constexpr std::size_t kFlanges = 2;  // of a race
        forces_[j].emplace(*user,
                           kFlanges * static_cast<std::size_t>(scene.bearing.element_count()));
        scene.block<UserFlangeBlock>(Phase::Force, "user routine ADRX2",
                                     BodyId{BodyId::Kind::Race, static_cast<int>(j)}, pairs_, j,
                                     mass_offset_, traction ? &friction_ : nullptr, damping_[j],
                                     *forces_[j], account_[j], kept_[j]);
      }
      if (traction || user != nullptr)
        scene.energy(name + ".heat", kHeat, &account_[j].heat, static_cast<int>(j));
      if (contact::is_damped(damping_[j]))
        scene.energy(name + ".damping", kFlangeDamping, &account_[j].damping, static_cast<int>(j));
      if (!traction) continue;
      if (!scene.plan.has(Effect::WearIntegrals)) continue;
      scene.integral(load_slip_[j], name + ".load_slip", "J", &account_[j].load_slip);
      scene.integral(load_slip_element1_[j], name + ".load_slip_element1", "J",
                     &account_[j].load_slip_element1);
    }
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    for (std::size_t j = 0; j < 2; ++j) {
      snapshot.power.qv_flange[j] = integral_at(e, load_slip_[j]);
      snapshot.power.qv_element1_flange[j] = integral_at(e, load_slip_element1_[j]);
    }
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      const std::array<SeenRoller, 2> by_race{seen(e, i, e.race[0], mass_offset_),
                                              seen(e, i, e.race[1], mass_offset_)};
      for (const statics::FlangeEndPair& pair : pairs_[pairs_.size() == 1 ? 0 : i]) {
        const auto j = static_cast<std::size_t>(pair.race);
        const RaceBody& race = e.race[j];
        const SeenRoller& roller = by_race[j];
        FlangeAction a;
        if (!pair.is_certainly_open(roller.p))
          a = has_friction_ ? friction_.visit_regularized([&](const auto& friction) {
            return act(pair, roller, e, i, race, damping_[j], friction);
          })
                            : act(pair, roller, e, i, race, damping_[j], nullptr);
        const double load = kept_[j].at[2 * i + static_cast<std::size_t>(pair.side)];
        if (a.energy > 0.0) {  // with what a routine makes of it
          if (a.load > 0.0) a.heat *= load / a.load;
          a.load = load;
        } else
          a.contact = contact::flange_contact(pair.face, pair.end, roller.centre(), roller.axis);
        snapshot.elements[i].flange[j][static_cast<std::size_t>(pair.side)] = {
            true,   a.load, a.contact.gap,   a.contact.height,
            a.slip, a.heat, a.load * a.slip, a.damping};
      }
    }
  }

  void look(const Evaluation&, Look& out) const override {
    for (const auto& [what, from] :
         {std::pair{ExtremeQuantity::FlangeForce, &kept_}, {ExtremeQuantity::FlangeSlip, &slip_}}) {
      std::vector<double>& values = out[what];
      values.resize(2 * kept_[0].at.size());
      for (std::size_t k = 0; k < values.size(); ++k)  // element, race, side
        values[k] = (*from)[k / 2 % 2].at[k / 4 * 2 + k % 2];
    }
  }

 private:
  std::vector<std::vector<statics::FlangeEndPair>> pairs_;  ///< of all rollers, or by roller
  double mass_offset_ = 0.0;                                ///< s_G [m]
  tribology::TractionLaw friction_;
  bool has_friction_ = false;
  std::array<contact::DampingLaw<>, 2> damping_;
  std::array<FlangeAccount, 2> account_;
  std::array<LastContactValues, 2> kept_, slip_;                       ///< forces, slips by race
  std::array<std::optional<UserFlangeForces>, 2> forces_;              ///< ADRX2 by race
  std::array<int, 2> load_slip_{-1, -1}, load_slip_element1_{-1, -1};  ///< in the state
};

}  // namespace

std::unique_ptr<SceneEffect> make_roller_flanges(const ScenePlan& plan) {
  if (!plan.rollers || !plan.has(Effect::FlangeContact)) return nullptr;
  return std::make_unique<RollerFlanges>();
}
std::span<const LedgerTerm* const> roller_flange_terms() { return kTerms; }

}  // namespace adore::dynamics

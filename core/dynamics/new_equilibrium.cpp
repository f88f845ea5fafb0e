#include "dynamics/new_equilibrium.hpp"

#include "base/errors.hpp"
#include "contact/groove.hpp"
#include "dynamics/elements.hpp"
#include "dynamics/state_access.hpp"
#include "statics/element_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace adore::dynamics {
namespace {

using statics::ElementPosition;
using statics::ElementPositions;
using statics::Vec5;

constexpr double kLoadMargin = 1.1;  ///< of contact loads after the change
constexpr int kHalvings = 6;         ///< of departures that raise loads
/// Floor of the elastic energy, over force scale times length scale; about 1e-4 of that of a
/// bearing under the force scale. [choice]
constexpr double kEnergyFloor = 1e-7;

std::optional<Slice> find(const StateLayout& layout, const std::string& name) {
  for (const StateLayout::Group& group : layout.groups())
    if (group.name == name) return group.slice;
  return std::nullopt;
}

/// States of a body that moves freely.
struct BodyStates {
  Slice position, velocity, attitude, omega;
};
std::optional<BodyStates> body_states(const StateLayout& layout, const std::string& name) {
  const auto position = find(layout, name + ".position"),
             velocity = find(layout, name + ".velocity"),
             attitude = find(layout, name + ".quaternion"), omega = find(layout, name + ".omega");
  if (!position || !velocity || !attitude || !omega) return std::nullopt;
  return BodyStates{*position, *velocity, *attitude, *omega};
}

/// Turn about a vector by its length.
Quat turn_by(const Vec3& vector) {
  const double angle = vector.norm();
  return angle > 0.0 ? quaternion_about(vector / angle, angle) : Quat{1.0, 0.0, 0.0, 0.0};
}

/// One scene at one instant.
class Instant {
 public:
  Instant(const EquilibriumContext& scene, double t, std::span<const double> y)
      : scene_(scene), system_(scene.system), t_(t) {
    System& system = system_;
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
      const auto slice = find(system.layout(), "element." + std::string(kQuantities[q].name));
      demand(slice.has_value(), "a bearing without rolling elements has no equilibrium");
      slices_[static_cast<Quantity>(q)] = *slice;
    }
    for (std::size_t i = 0; system.bearing().rollers() != nullptr && i < slices_.elements(); ++i)
      attitude_.push_back(
          find(system.layout(), fmt::format("element{}.quaternion", i + 1)).value());
    for (std::size_t j = 0; j < 2; ++j)
      body_[j] = body_states(system.layout(), j == 0 ? "outer race" : "inner race");
    centre_ = find(system.layout(), "inner race.centre");
    if (system.bearing().rollers() == nullptr) {
      const auto plane = contact::groove_geometry(system.bearing().balls()).centre_x;
      for (std::size_t j = 0; j < 2; ++j) free_x_[j] = plane[j];
    }
    bearing_ = system.bearing();
    find_races(y);
    bearing_.speed = {poses_[0].speed, poses_[1].speed};
  }

  [[nodiscard]] System& system() const noexcept { return system_; }
  [[nodiscard]] double time() const noexcept { return t_; }
  [[nodiscard]] const ElementSlices& slices() const noexcept { return slices_; }
  [[nodiscard]] const std::vector<Slice>& attitudes() const noexcept { return attitude_; }
  [[nodiscard]] double speed(std::size_t j) const noexcept { return poses_[j].speed; }
  [[nodiscard]] Vec3 outer_place() const noexcept { return poses_[0].displacement; }

  /// Displacement of the inner race from the outer one.
  [[nodiscard]] Vec5 race() const {
    Vec5 q;
    q.head<3>() = poses_[1].displacement - poses_[0].displacement;
    const auto tilt = tilt_of_axis(poses_[1].axis);
    q(3) = tilt[0];
    q(4) = tilt[1];
    return q;
  }
  /// Directions in which a race moves under its load, and that load.
  /// @param fields with weight and the field of a rotating base frame
  [[nodiscard]] statics::RaceLoadCase task(bool fields = true) const;
  /// Moves the free races of a state by a change of race().
  void move_race(std::span<double> y, const Vec5& change);
  [[nodiscard]] std::optional<ElementPositions> places(std::span<const double> y,
                                                       const statics::RaceLoadCase& task,
                                                       const Vec5& guess, bool conservative) const;
  /// Puts element i to x, r (middle) and tilt.
  void put(std::span<double> y, std::size_t i, const Vec3& place) const;
  /// Its position.
  [[nodiscard]] Vec3 place(std::span<const double> y, std::size_t i) const;

  /// Contact loads; false: the state is not valid.
  [[nodiscard]] bool loads(std::span<const double> y, std::vector<double>& out);
  /// Potential energy at y; nothing: it is not valid. `elastic`: its part in contacts.
  [[nodiscard]] std::optional<double> potential(std::span<const double> y, double& elastic);

 private:
  struct RacePlace {
    Vec3 displacement = Vec3::Zero();  ///< of its center from its free position [m]
    Vec3 axis = Vec3::UnitX();
    double speed = 0.0;  ///< about its axis [rad/s]
  };
  [[nodiscard]] std::array<RacePlace, 2> races_at(std::span<const double> y) const;
  void find_races(std::span<const double> y) {
    poses_ = races_at(y);
    bearing_.constraints.outer_misalignment = tilt_of_axis(poses_[0].axis);
  }
  [[nodiscard]] bool is_free(int race, std::size_t k) const;
  [[nodiscard]] double tilt_of(std::span<const double> y, std::size_t i) const;

  EquilibriumContext scene_;
  System& system_;
  double t_;
  std::array<double, 2> free_x_{};  ///< of the race centers in the unloaded bearing [m]
  std::array<RacePlace, 2> poses_;
  ElementSlices slices_;
  std::vector<Slice> attitude_;  ///< of rollers
  std::array<std::optional<BodyStates>, 2> body_;
  std::optional<Slice> centre_;
  bearing::Bearing bearing_;  ///< with the speeds and the misalignment of now
  std::vector<double> rates_;
};

/// Prescribed parts, and state.
std::array<Instant::RacePlace, 2> Instant::races_at(std::span<const double> y) const {
  const PrescribedRaces prescribed = system_.prescribed_races(t_, y);
  std::array<RacePlace, 2> out;
  for (std::size_t j = 0; j < 2; ++j) {
    RacePlace& race = out[j];
    race = {prescribed[j].position, rotation_matrix(prescribed[j].attitude).col(0),
            prescribed[j].speed};
    if (const auto& body = body_[j]) {
      const Mat3 to_base =
          rotation_matrix(normalize_quaternion(quaternion_at(y.data(), body->attitude)));
      race.displacement = vector_at(y.data(), body->position) +
                          to_base * system_.bearing().race_inertia[j].geometric_centre;
      race.axis = to_base.col(0);
      race.speed = y[static_cast<std::size_t>(body->omega.first)];
    }
    if (j == 1 && centre_)
      for (std::size_t k = 0; k < 3; ++k)
        if (is_free(1, k))
          race.displacement[static_cast<int>(k)] = y[static_cast<std::size_t>(centre_->first) + k];
    race.displacement[0] -= free_x_[j];
  }
  return out;
}

/// In the order of Vec5.
bool Instant::is_free(int race, std::size_t k) const {
  const auto j = static_cast<std::size_t>(race);
  if (race == 1 && centre_) return k < 3 && !system_.bearing().constraints.displacement_given[k];
  const auto& free = scene_.plan.race_motions.free[j];
  if (!body_[j] || !free) return false;
  return k < 3 ? !free->translation_held[k] : !free->rotation_held[k - 2];
}

statics::RaceLoadCase Instant::task(bool fields) const {
  const bearing::Bearing& b = system_.bearing();
  const bearing::RaceMotions& motions = scene_.plan.race_motions;
  statics::RaceLoadCase out;
  for (std::size_t k = 0; k < 5; ++k) {
    const bool inner = is_free(1, k), outer = is_free(0, k);
    out.given[k] = !inner && !outer;
    if (out.given[k]) continue;
    const auto row = static_cast<Eigen::Index>(k);
    if (centre_) {
      out.load(row) = b.constraints.load[k];
    } else {
      const std::size_t j = inner ? 1 : 0;
      const bearing::FreeRace& free = *motions.free[j];
      const double sign = inner ? 1.0 : -1.0;
      if (k < 3) {
        Vec3 force = free.force;
        if (fields) force += b.race_inertia[j].mass * b.gravity;
        if (fields && motions.frame) {
          const bearing::FrameMotion& frame = *motions.frame;
          force += frame.load_share[j] * b.race_inertia[j].mass * frame.speed * frame.speed *
                   frame.orbit_radius * radial_direction(frame.orbit_angle);
        }
        out.load(row) = sign * force[static_cast<int>(k)];
      } else {
        out.load(row) = sign * free.moment[static_cast<int>(k) - 2];
      }
    }
  }
  if (const auto& turning = motions.rotating_load_parameters;
      turning && !out.given[1] && !out.given[2]) {  // of the applied radial load alone
    const std::size_t j = centre_ || is_free(1, 1) ? 1 : 0;
    const Vec3 force =
        centre_ ? Vec3(0.0, b.constraints.load[1], b.constraints.load[2]) : motions.free[j]->force;
    const double turn = turning->speed[j] * t_, c = std::cos(turn) - 1.0, s = std::sin(turn);
    const double sign = centre_ || j == 1 ? 1.0 : -1.0;
    out.load(1) += sign * turning->fraction[j] * (c * force[1] - s * force[2]);
    out.load(2) += sign * turning->fraction[j] * (s * force[1] + c * force[2]);
  }
  return out;
}

void Instant::move_race(std::span<double> y, const Vec5& change) {
  const Vec3 along = change.head<3>();
  if (centre_) {
    store_at(y.data(), *centre_, Vec3(vector_at(y.data(), *centre_) + along));
  } else {
    for (std::size_t j = 0; j < 2; ++j) {
      const auto& body = body_[j];
      if (!body) continue;
      Vec3 shift = Vec3::Zero();
      const double sign = j == 1 ? 1.0 : -1.0;
      for (std::size_t k = 0; k < 3; ++k)
        if (is_free(static_cast<int>(j), k) && (j == 1 || !is_free(1, k)))
          shift[static_cast<int>(k)] = sign * along[static_cast<int>(k)];
      store_at(y.data(), body->position, Vec3(vector_at(y.data(), body->position) + shift));
      Vec3 turn = Vec3::Zero();
      for (std::size_t k = 3; k < 5; ++k)
        if (is_free(static_cast<int>(j), k) && (j == 1 || !is_free(1, k)))
          turn[static_cast<int>(k) - 2] = sign * change(static_cast<Eigen::Index>(k));
      if (turn.isZero(0.0)) continue;
      store_at(
          y.data(), body->attitude,
          normalize_quaternion(multiply(turn_by(turn), quaternion_at(y.data(), body->attitude))));
    }
  }
  find_races(y);
}

std::optional<ElementPositions> Instant::places(std::span<const double> y,
                                                const statics::RaceLoadCase& task,
                                                const Vec5& guess, bool conservative) const {
  std::vector<double> azimuth;
  for (std::size_t i = 0; i < slices_.elements(); ++i)
    azimuth.push_back(y[static_cast<std::size_t>(slices_.at(Quantity::Theta, i))]);
  const statics::ElementPositionModel model{bearing_, scene_.balls, scene_.rollers, conservative};
  try {
    auto found = statics::element_places(model, azimuth, task, guess);
    if (!found) return found;
    for (std::size_t i = 0; i < azimuth.size(); ++i) {
      ElementPosition& place = found->elements[i];
      place.x += poses_[0].displacement[0];
      place.r += poses_[0].displacement.dot(radial_direction(azimuth[i]));
    }
    return found;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

double Instant::tilt_of(std::span<const double> y, std::size_t i) const {
  const Mat3 axes = rotation_matrix(normalize_quaternion(quaternion_at(y.data(), attitude_[i])));
  const double theta = y[static_cast<std::size_t>(slices_.at(Quantity::Theta, i))];
  return std::atan2(radial_direction(theta).dot(axes.col(0)), axes(0, 0));
}

Vec3 Instant::place(std::span<const double> y, std::size_t i) const {
  const auto at = [&](Quantity q) { return y[static_cast<std::size_t>(slices_.at(q, i))]; };
  Vec3 out(at(Quantity::X), at(Quantity::R), 0.0);
  if (attitude_.empty()) return out;
  out[2] = tilt_of(y, i);
  const double offset = system_.bearing().roller_mass_offset;
  out[0] -= offset * std::cos(out[2]);
  out[1] -= offset * std::sin(out[2]);
  return out;
}

void Instant::put(std::span<double> y, std::size_t i, const Vec3& to) const {
  const auto at = [&](Quantity q) -> double& {
    return y[static_cast<std::size_t>(slices_.at(q, i))];
  };
  at(Quantity::X) = to[0];
  at(Quantity::R) = to[1];
  if (attitude_.empty()) return;
  const double turn = to[2] - tilt_of(y, i), offset = system_.bearing().roller_mass_offset;
  at(Quantity::X) += offset * std::cos(to[2]);
  at(Quantity::R) += offset * std::sin(to[2]);
  const double theta = at(Quantity::Theta);
  store_at(y.data(), attitude_[i],
           normalize_quaternion(multiply(quaternion_about(circumferential_direction(theta), turn),
                                         quaternion_at(y.data(), attitude_[i]))));
  // The spin goes with the axis.
  const double x = at(Quantity::OmegaX) - at(Quantity::ThetaDot), r = at(Quantity::OmegaR);
  at(Quantity::OmegaX) = at(Quantity::ThetaDot) + std::cos(turn) * x - std::sin(turn) * r;
  at(Quantity::OmegaR) = std::sin(turn) * x + std::cos(turn) * r;
}

bool Instant::loads(std::span<const double> y, std::vector<double>& out) {
  rates_.resize(y.size());
  if (system_.rhs(t_, y.data(), rates_.data()) != RhsStatus::Ok) return false;
  const auto outer = system_.contact_loads(0), inner = system_.contact_loads(1);
  out.resize(outer.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::max(outer[i], inner[i]);
  return true;
}

std::optional<double> Instant::potential(std::span<const double> y, double& elastic) {
  std::vector<double> unused;
  if (!loads(y, unused)) return std::nullopt;
  const System::EnergyBalance account = system_.energy_balance();
  elastic = account.elastic;
  double out = account.balance;
  // Loss of applied loads; fields are in the stored energy.
  const statics::RaceLoadCase load = task(false);
  const std::array<RacePlace, 2> at = races_at(y);
  const Vec3 q = at[1].displacement - at[0].displacement;
  const auto tilt = tilt_of_axis(at[1].axis);
  for (std::size_t k = 0; k < 5; ++k)
    if (!load.given[k])
      out -=
          load.load(static_cast<Eigen::Index>(k)) * (k < 3 ? q[static_cast<int>(k)] : tilt[k - 3]);
  return out;
}

/// Energy of the departures of y from `rest` at constant angular momentum; nothing: a state is not
/// valid. `elastic`: of the equilibrium.
std::optional<double> departure_energy(Instant& at, std::span<const double> y,
                                       const ElementPositions& rest, double& elastic) {
  double unused = 0.0;
  const std::optional<double> now = at.potential(y, unused);
  std::vector<double> still(y.begin(), y.end());
  Instant there = at;
  if (const Vec5 change = rest.race - at.race(); !change.isZero(0.0))
    there.move_race(still, change);
  for (std::size_t i = 0; i < rest.elements.size(); ++i) {
    const auto index = [&](Quantity q) { return static_cast<std::size_t>(at.slices().at(q, i)); };
    const double r = still[index(Quantity::R)];
    const ElementPosition& place = rest.elements[i];
    there.put(still, i, {place.x, place.r, place.tilt});
    const double ratio = r / still[index(Quantity::R)];
    still[index(Quantity::ThetaDot)] *= ratio * ratio;
  }
  const std::optional<double> at_rest = there.potential(still, elastic);
  if (!now || !at_rest) return std::nullopt;
  return *now - *at_rest;
}

/// Rest of the elements with the races where they are, and of the race under its loads.
struct Rest {
  ElementPositions race, elements;
};

std::optional<Rest> rest_of(const Instant& at, std::span<const double> y, bool conservative,
                            const Vec5& guess) {
  const statics::RaceLoadCase task = at.task();
  const Vec5 now = at.race();
  Vec5 start = guess;
  for (std::size_t k = 0; k < 5; ++k)
    if (task.given[k]) start(static_cast<Eigen::Index>(k)) = now(static_cast<Eigen::Index>(k));
  auto race = at.places(y, task, start, conservative);
  if (!race) return std::nullopt;
  const bool held =
      std::all_of(task.given.begin(), task.given.end(), [](bool given) { return given; });
  if (held) return Rest{*race, *race};
  statics::RaceLoadCase all;
  all.given.fill(true);
  auto elements = at.places(y, all, now, conservative);
  if (!elements) return std::nullopt;
  return Rest{*race, *elements};
}

/// Speeds of the elements and the cage where the races turn at another speed.
void change_speeds(const Instant& before, const ElementPositions& was, const Instant& after,
                   const ElementPositions& is, std::span<double> y) {
  const double old_size = std::max(std::abs(before.speed(0)), std::abs(before.speed(1)));
  const double new_size = std::max(std::abs(after.speed(0)), std::abs(after.speed(1)));
  double change = 0.0;
  for (std::size_t j = 0; j < 2; ++j)
    change = std::max(change, std::abs(after.speed(j) - before.speed(j)));
  constexpr double kSame = 1e-9;
  if (change <= kSame * std::max(old_size, new_size)) return;
  const double scale = old_size > 0.0 ? std::min(1.0, new_size / old_size) : 1.0;
  double orbit_was = 0.0, orbit_is = 0.0;
  const std::size_t n = was.elements.size();
  for (std::size_t i = 0; i < n; ++i) {
    const ElementPosition &old = was.elements[i], &now = is.elements[i];
    const auto at = [&](Quantity q) -> double& {
      return y[static_cast<std::size_t>(after.slices().at(q, i))];
    };
    const auto move = [&](Quantity q, double from, double to) {
      at(q) = to + scale * (at(q) - from);
    };
    move(Quantity::ThetaDot, old.orbital_speed, now.orbital_speed);
    move(Quantity::OmegaX, old.omega[0], now.omega[0]);
    move(Quantity::OmegaR, old.omega[1], now.omega[1]);
    move(Quantity::OmegaTheta, old.omega[2], now.omega[2]);
    orbit_was += old.orbital_speed / static_cast<double>(n);
    orbit_is += now.orbital_speed / static_cast<double>(n);
  }
  const Vec3 axis = Vec3::UnitX();
  for (const StateLayout::Group& group : after.system().layout().groups()) {
    if (!group.name.starts_with("cage") || !group.name.ends_with(".position")) continue;
    const std::string name = group.name.substr(0, group.name.size() - 9);
    const auto body = body_states(after.system().layout(), name);
    if (!body) continue;
    const Vec3 place = vector_at(y.data(), body->position);
    const Vec3 velocity = vector_at(y.data(), body->velocity);
    store_at(
        y.data(), body->velocity,
        Vec3(orbit_is * axis.cross(place) + scale * (velocity - orbit_was * axis.cross(place))));
    const Mat3 to_base =
        rotation_matrix(normalize_quaternion(quaternion_at(y.data(), body->attitude)));
    const Vec3 omega = to_base * vector_at(y.data(), body->omega);
    store_at(y.data(), body->omega,
             Vec3(to_base.transpose() * (orbit_is * axis + scale * (omega - orbit_was * axis))));
  }
}

/// Clearance after over clearance before, at most 1.
double narrowing(double before, double after) {
  return before > 0.0 && after > 0.0 ? std::min(1.0, after / before) : 1.0;
}

/// Where clearances of a one-piece cage become smaller, the cage keeps its relative position in its
/// guide lands, and the elements theirs in the pockets along the pitch circle.
void fit_cage(const EquilibriumContext& before, double t, std::span<const double> y_before,
              const EquilibriumContext& after, std::span<double> y) {
  const auto &old = before.system.bearing(), &now = after.system.bearing();
  const auto body = body_states(after.system.layout(), "cage");
  if (!body || !old.cage || !now.cage) return;
  double guide = 1.0;
  std::size_t race = 0;
  for (std::size_t i = 0; i < old.cage->lands.size() && i < now.cage->lands.size(); ++i) {
    using Guide = bearing::GuideLand::Guide;
    const bearing::GuideLand& land = now.cage->lands[i];
    if (land.guide == Guide::None) continue;
    const double one = narrowing(old.cage->lands[i].clearance, land.clearance);
    if (one < guide) race = land.guide == Guide::Outer ? 0 : 1;
    guide = std::min(guide, one);
  }
  const double pocket = narrowing(old.cage->pocket_clearance_1, now.cage->pocket_clearance_1);
  if (guide == 1.0 && pocket == 1.0) return;
  const Snapshot at = before.system.snapshot(t, y_before);
  const Mat3 to_base =
      rotation_matrix(normalize_quaternion(quaternion_at(y.data(), body->attitude)));
  const Vec3 position = vector_at(y.data(), body->position);
  Vec3 offset = position + to_base * now.cage->inertia.geometric_centre - at.races[race].position;
  offset[0] = 0.0;
  const Vec3 shift = (guide - 1.0) * offset;
  store_at(y.data(), body->position, Vec3(position + shift));
  const Instant elements(after, t, y);
  for (std::size_t i = 0; i < at.elements.size(); ++i) {
    const scene::ElementSnapshot& element = at.elements[i];
    const double ahead = -element.pocket_to_centre[1];  // y of the pocket is against the azimuth
    const double turn =
        ((pocket - 1.0) * ahead + shift.dot(circumferential_direction(element.theta))) / element.r;
    component(y, elements.slices()[Quantity::Theta], i) += turn;
    if (elements.attitudes().empty()) continue;
    const Slice& attitude = elements.attitudes()[i];
    store_at(y.data(), attitude,
             multiply(quaternion_about(Vec3::UnitX(), turn), quaternion_at(y.data(), attitude)));
  }
}

double energy_floor(const System& system) {
  return kEnergyFloor * system.scales().force * system.scales().length;
}

}  // namespace

EquilibriumChange move_to_equilibrium(const EquilibriumContext& before, double t_before,
                                      std::span<const double> y_before,
                                      const EquilibriumContext& after, double t,
                                      std::span<double> y) {
  EquilibriumChange out;
  fit_cage(before, t_before, y_before, after, y);
  Instant old(before, t_before, y_before), now(after, t, y);
  std::optional<Rest> was, is;
  for (const bool conservative : {false, true}) {
    was = rest_of(old, y_before, conservative, old.race());
    if (!was) continue;
    is = rest_of(now, y, conservative, was->race.race);
    if (is) break;
  }
  if (!was || !is) {
    out.why_not = was ? "no equilibrium of the elements was found after the change of the bearing"
                      : "no equilibrium of the elements was found before the change of the bearing";
    return out;
  }

  // The race: its departure goes along where it moved under its load before, too.
  const statics::RaceLoadCase moved_before = old.task(), moves = now.task();
  const double softer =
      is->race.stiffness.trace() > 0.0
          ? std::sqrt(std::max(was->race.stiffness.trace(), 0.0) / is->race.stiffness.trace())
          : 1.0;
  Vec5 target = is->race.race;
  for (std::size_t k = 0; k < 5; ++k)
    if (const auto row = static_cast<Eigen::Index>(k); !moves.given[k] && !moved_before.given[k])
      target(row) += std::min(1.0, softer) * (old.race()(row) - was->race.race(row));
  const Vec5 shift = target - now.race();
  out.largest_shift = shift.head<3>().norm();
  const bool conservative = false;
  if (!shift.isZero(0.0)) {
    now.move_race(y, shift);
    statics::RaceLoadCase all;
    all.given.fill(true);
    auto elements = now.places(y, all, now.race(), conservative);
    if (!elements) elements = now.places(y, all, now.race(), true);
    if (!elements) {
      out.why_not = "no equilibrium of the elements was found at the new race position";
      now.move_race(y, -shift);
      return out;
    }
    is->elements = std::move(*elements);
  }

  // The elements.
  const std::size_t n = old.slices().elements();
  std::vector<double> loads_before, loads, share(n, 1.0);
  const bool known = old.loads(y_before, loads_before);
  const bool slides = after.system.bearing().type == bearing::Type::Cylindrical;
  double largest = 0.0;
  for (const ElementPosition& place : is->elements.elements)
    largest = std::max(largest, place.load);
  const std::vector<double> start(y.begin(), y.end());
  const auto place_all = [&] {
    for (std::size_t i = 0; i < n; ++i) {
      const ElementPosition &from = was->elements.elements[i], &to = is->elements.elements[i];
      const Vec3 departure = old.place(y_before, i) - Vec3(from.x, from.r, from.tilt);
      Vec3 place = Vec3(to.x, to.r, to.tilt) + share[i] * departure;
      if (slides) place[0] = to.x + departure[0];
      for (const Quantity q : {Quantity::OmegaX, Quantity::OmegaR}) {
        const auto at = static_cast<std::size_t>(now.slices().at(q, i));
        y[at] = start[at];
      }
      if (!now.attitudes().empty())
        for (int k = 0; k < 4; ++k) {
          const auto at = static_cast<std::size_t>(now.attitudes()[i].first + k);
          y[at] = start[at];
        }
      now.put(y, i, place);
      out.largest_shift =
          std::max(out.largest_shift, Vec3(place - old.place(y_before, i)).head<2>().norm());
    }
  };
  for (int pass = 0; pass <= kHalvings; ++pass) {
    place_all();
    const bool valid = now.loads(y, loads);
    bool again = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double allowed =
          kLoadMargin * std::max(is->elements.elements[i].load, known ? loads_before[i] : 0.0) +
          1e-3 * largest;
      if (share[i] == 0.0 || (valid && loads[i] <= allowed)) continue;
      share[i] = pass + 1 >= kHalvings ? 0.0 : 0.5 * share[i];
      again = true;
    }
    if (!again) break;
  }
  change_speeds(old, was->elements, now, is->elements, y);
  out.moved = true;

  double elastic_before = 0.0, elastic_after = 0.0;
  const auto ex_before = departure_energy(old, y_before, was->race, elastic_before);
  const auto ex_after = departure_energy(now, y, is->race, elastic_after);
  out.elastic = std::max({elastic_before, elastic_after, energy_floor(after.system)});
  if (ex_before && ex_after) out.excess = std::max(0.0, *ex_after - std::max(0.0, *ex_before));
  return out;
}

EquilibriumChange assess_start_excess_energy(const EquilibriumContext& scene, double t,
                                             std::span<const double> y) {
  EquilibriumChange out;
  Instant at(scene, t, y);
  std::optional<Rest> rest;
  for (const bool conservative : {false, true})
    if (!rest) rest = rest_of(at, y, conservative, at.race());
  if (!rest) {
    out.why_not = "no equilibrium of the elements was found at the start";
    return out;
  }
  double elastic = 0.0;
  const std::optional<double> excess = departure_energy(at, y, rest->race, elastic);
  out.elastic = std::max(elastic, energy_floor(scene.system));
  if (excess)
    out.excess = std::max(0.0, *excess);
  else
    out.why_not = "the energy at the start could not be computed";
  return out;
}

void book_change(System& before, std::span<const double> y_before, System& after, double t,
                 std::span<double> y) {
  const Snapshot was = before.snapshot(t, y_before), is = after.snapshot(t, y);
  const auto jump = find(after.layout(), "thermal.jump");
  demand(jump.has_value(), "the geometry changed in a simulation with fixed geometry");
  component(y, *jump) += is.energy.sum(LedgerKind::Stored) - was.energy.sum(LedgerKind::Stored);
  const auto add = [&](const std::string& name, const Vec3& change) {
    const auto slice = find(after.layout(), name);
    if (slice) store_at(y.data(), *slice, Vec3(vector_at(y.data(), *slice) + change));
  };
  if (!was.momentum || !is.momentum) return;
  add("thermal.impulse",
      is.momentum->linear.sum(LedgerKind::Stored) - was.momentum->linear.sum(LedgerKind::Stored));
  add("thermal.angular_impulse",
      is.momentum->angular.sum(LedgerKind::Stored) - was.momentum->angular.sum(LedgerKind::Stored));
}

}  // namespace adore::dynamics

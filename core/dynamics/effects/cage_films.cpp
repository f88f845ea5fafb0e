#include "base/errors.hpp"
#include "contact/guide_land.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/pockets.hpp"
#include "tribology/cage_oil.hpp"
#include "tribology/journal_film.hpp"
#include "tribology/pocket_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// Oil films between the cage and races (kGsHydro) or balls (kPocHydro). Two effects; those in the
/// pockets of rollers are in roller_pockets.cpp.
///
/// Guide land: the short journal bearing of tribology/journal_film.hpp, one film for each land at
/// its middle plane; the cage is the journal on the outer race, the race on the inner. Force at the
/// centers of both circles, e F_t of their couple is shared by both torques, so that no momentum is
/// lost. The eccentricity of the film stops smoothly, over 5 % of the clearance, where the least
/// gap is the critical film; from there on the metal contact of effects/lands.cpp grows.
/// Attitude angle: from the line of the least gap to the film's load, tan φ = F_t/-F_r.
///
/// Pocket, at each surface nearer than pocLubFilm: wedge of the sliding surfaces, entrained with
/// half the slip, and squeeze (tribology/pocket_film.hpp), both along the normal; shear of a sphere
/// that slides past a wall, 6π μ R u (8/15 ln(R/h) + 0.9588) (Goldman, Cox & Brenner 1967), against
/// the slip in the contact point [choice]. All fade to nothing by a cubic between half of
/// pocLubFilm and itself; below the critical film they stay what they are there, and contact grows.
/// Curvature of the wall: nominal clearance I. Heat is what the actions of both films take: minus
/// their power. Decision 304.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kLandHeat{LedgerKind::Heat,
                               "land_film_heat",
                               "heat in the films at the guide lands",
                               {"films at the guide lands"},
                               "dissipated since the start"};
constexpr LedgerTerm kPocketFilmHeat{LedgerKind::Heat,
                                     "pocket_film_heat",
                                     "heat in the films in the pockets",
                                     {"films in the pockets"},
                                     "dissipated since the start"};
constexpr const LedgerTerm* kLandTerms[] = {&kLandHeat};
constexpr const LedgerTerm* kPocketTerms[] = {&kPocketFilmHeat};

/// max(x, limit), rounded by a parabola over ± width.
double smooth_max(double x, double limit, double width) noexcept {
  const double above = x - limit;
  if (above >= width) return x;
  if (above <= -width) return limit;
  return limit + (above + width) * (above + width) / (4.0 * width);
}

struct FilmLand {
  std::size_t index = 0;  ///< of the land
  std::size_t race = 0;
  bool cage_inside = true;
  double x = 0.0;        ///< middle plane in the cage frame [m]
  double largest = 0.0;  ///< eccentricity of the critical film
  tribology::JournalFilm film;
};

/// Force of one film: on the journal at its center, the opposite on the bearing at its center.
struct FilmAction {
  Vec3 force = Vec3::Zero();
  double radial = 0.0, tangential = 0.0;
  double torque_journal = 0.0, torque_bearing = 0.0;
  Vec3 cage_centre = Vec3::Zero(), race_centre = Vec3::Zero(), axis = Vec3::Zero();
};

FilmAction act(const FilmLand& land, const BodyState& cage, const RaceBody& race) noexcept {
  constexpr double kLeast = 1e-6;  // eccentricity below which its direction has no meaning
  FilmAction out;
  out.axis = race.axis();
  out.cage_centre = cage.position + land.x * cage.to_base.col(0);
  Vec3 apart = out.cage_centre - race.position;
  apart -= apart.dot(out.axis) * out.axis;
  out.race_centre = out.cage_centre - apart;
  Vec3 motion = cage.velocity_at(out.cage_centre) - race.velocity_at(out.race_centre);
  motion -= motion.dot(out.axis) * out.axis;
  const double side = land.cage_inside ? 1.0 : -1.0, c = land.film.clearance;
  apart *= side;
  motion *= side;
  const double size = apart.norm(), guarded = std::max(size, kLeast * c);
  Vec3 d = size > kLeast * c ? Vec3(apart / size)
                             : Vec3(out.axis
                                        .cross(std::abs(out.axis.y()) < 0.9 ? Vec3(Vec3::UnitY())
                                                                            : Vec3(Vec3::UnitZ()))
                                        .normalized());
  const Vec3 t = out.axis.cross(d);
  const BodyState& journal = land.cage_inside ? cage : static_cast<const BodyState&>(race);
  const BodyState& bearing = land.cage_inside ? static_cast<const BodyState&>(race) : cage;
  tribology::JournalMotion at;
  constexpr double kBlend = 0.05;
  at.eccentricity = -smooth_max(-guarded / c, -land.largest, kBlend);
  at.journal = journal.omega.dot(out.axis);
  at.bearing = bearing.omega.dot(out.axis);
  at.attitude_rate = motion.dot(t) / guarded;
  at.squeeze = motion.dot(d) / c;
  const tribology::JournalForce force = tribology::journal_force(land.film, at);
  out.radial = force.radial;
  out.tangential = force.tangential;
  out.force = force.radial * d + force.tangential * t;
  const double shear = 0.5 * (force.torque_bearing - force.torque_journal);
  const double couple = 0.5 * size * force.tangential;
  out.torque_journal = -shear - couple;
  out.torque_bearing = shear - couple;
  return out;
}

class LandFilmBlock final : public EffectBlock {
 public:
  LandFilmBlock(const std::vector<FilmLand>& lands, HeatByPart& heat)
      : lands_(lands), heat_(heat) {}
  void apply(Evaluation& e) noexcept override {
    heat_.none();
    BodyState& cage = e.segments.front();
    for (const FilmLand& land : lands_) {
      RaceBody& race = e.race[land.race];
      const FilmAction a = act(land, cage, race);
      const Vec3 on_cage = land.cage_inside ? a.force : Vec3(-a.force);
      const Vec3 cage_torque = (land.cage_inside ? a.torque_journal : a.torque_bearing) * a.axis;
      const Vec3 race_torque = (land.cage_inside ? a.torque_bearing : a.torque_journal) * a.axis;
      cage.add_force(on_cage, a.cage_centre);
      cage.moment += cage_torque;
      race.add_force(-on_cage, a.race_centre);
      race.moment += race_torque;
      heat_.add(land.index,
                -(on_cage.dot(cage.velocity_at(a.cage_centre) - race.velocity_at(a.race_centre)) +
                  cage_torque.dot(cage.omega) + race_torque.dot(race.omega)));
    }
  }

 private:
  const std::vector<FilmLand>& lands_;
  HeatByPart& heat_;
};

class LandFilm final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    const bearing::Bearing& bearing = scene.bearing;
    demand(bearing.cage_films.has_value() && bearing.cage.has_value(),
           "oil films at the cage need a cage and an oil");
    const bearing::CageFilms& films = *bearing.cage_films;
    const double viscosity = tribology::cage_film_viscosity(bearing, films.land_viscosity);
    heat_.part.assign(bearing.cage->lands.size(), 0.0);
    for (std::size_t i = 0; i < bearing.cage->lands.size(); ++i) {
      const bearing::GuideLand& guide = bearing.cage->lands[i];
      const double c = 0.5 * guide.clearance;
      if (guide.guide == bearing::GuideLand::Guide::None || !(c > 0.0) || !(guide.width > 0.0))
        continue;
      FilmLand land;
      land.index = i;
      land.cage_inside = guide.guide == bearing::GuideLand::Guide::Outer;
      land.race = land.cage_inside ? 0 : 1;
      land.x = contact::land_center_position(guide.edge, guide.width);
      land.film = {viscosity, 0.5 * guide.diameter - (land.cage_inside ? 0.0 : c), guide.width, c};
      constexpr double kTightest = 0.5;  // a clearance of a few critical films still has one
      land.largest = std::max(kTightest, 1.0 - films.critical_film / c);
      lands_.push_back(land);
    }
    scene.block<LandFilmBlock>(Phase::Force, "films of the cage", {}, lands_, heat_);
    scene.energy("land films.heat", kLandHeat, &heat_.sum);
  }
  void report(const Evaluation& e, Snapshot& snapshot) const override {
    for (const FilmLand& land : lands_) {
      if (snapshot.cages.empty() || land.index >= snapshot.cages.front().lands.size()) continue;
      const FilmAction a = act(land, e.segments.front(), e.race[land.race]);
      LandSnapshot& shown = snapshot.cages.front().lands[land.index];
      shown.film_force = a.force.norm();
      shown.heat += heat_.part[land.index];
      shown.attitude = std::atan2(a.tangential, -a.radial);
    }
  }

 private:
  std::vector<FilmLand> lands_;
  HeatByPart heat_;  ///< now
};

/// Oil of the pockets and what of their shape its films read.
struct PocketOil {
  double viscosity = 0.0, largest = 0.0, critical = 0.0;
  double around = 0.0, along = 0.0;  ///< relative curvature around and along the pocket axis [1/m]
};

/// The film between a ball and one wall.
struct PocketFilmAction {
  Vec3 m, arm, point, slip;           ///< base axes; slip with its part along m
  Vec3 force;                         ///< on the ball [N]
  double stiffness = 0.0;             ///< -∂F/∂h of wedge and squeeze [N/m]
  double squeeze = 0.0, shear = 0.0;  ///< force over closing and sliding speed [N s/m]
};

PocketFilmAction film_action(const PocketSet& set, const PocketOil& oil, const Evaluation& e,
                             std::size_t i, const contact::WallPoint& wall) noexcept {
  PocketFilmAction out;
  const BodyState& cage = set.body(e, i);
  const std::size_t ball = set.element(i);
  const double R = set.ball_radius(i);
  const double h = smooth_max(wall.gap, oil.critical, 0.5 * oil.critical);
  const double s = std::clamp(2.0 * (1.0 - wall.gap / oil.largest), 0.0, 1.0);
  const double fade = s * s * (3.0 - 2.0 * s);
  out.m = set.to_base(i, wall.m, cage.to_base);
  const Vec3& m = out.m;
  const Vec3 z = set.to_base(i, Vec3::UnitZ(), cage.to_base);
  out.arm = R * m;
  out.point = e.element_centre(ball) + out.arm;
  const Vec3 of_wall = cage.velocity_at(out.point);
  out.slip = e.element_velocity(ball) + e.element_omega(ball).cross(out.arm) - of_wall;
  const double closing = (e.element_velocity(ball) - of_wall).dot(m);  // -dh/dt
  const Vec3 sliding = out.slip - out.slip.dot(m) * m;
  const double u = sliding.norm();
  const double lengthwise = u > 0.0 ? std::pow(sliding.dot(z) / u, 2) : 1.0;
  const double k_along = lengthwise * oil.along + (1.0 - lengthwise) * oil.around;
  const double k_across = lengthwise * oil.around + (1.0 - lengthwise) * oil.along;
  const double wedge =
      tribology::point_wedge_force(oil.viscosity, 0.5 * u, 1.0 / k_along, 1.0 / k_across, h);
  const double reduced = 1.0 / std::sqrt(k_along * k_across);
  const double squeeze = tribology::sphere_squeeze_force(oil.viscosity, reduced, h, -closing);
  out.shear = fade * 6.0 * std::numbers::pi * oil.viscosity * R *
              std::max(0.0, 8.0 / 15.0 * std::log(R / h) + 0.9588);
  out.squeeze = fade * tribology::sphere_squeeze_force(oil.viscosity, reduced, h, -1.0);
  const double fade_slope = 12.0 * s * (1.0 - s) / oil.largest;
  out.stiffness = fade * (0.5 * wedge + squeeze) / h + fade_slope * (wedge + squeeze);
  out.force = -out.shear * sliding - fade * (wedge + squeeze) * m;
  return out;
}

class PocketFilmBlock final : public EffectBlock {
 public:
  PocketFilmBlock(PocketSet& set, const PocketOil& oil, HeatByPart& heat)
      : set_(set), oil_(oil), heat_(heat) {}
  void apply(Evaluation& e) noexcept override {
    heat_.none();
    set_.locate(e);
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const contact::WallPoints walls = set_.walls(i);
      for (std::size_t k = 0; k < static_cast<std::size_t>(walls.count); ++k) {
        if (!(walls.surface[k].gap < oil_.largest)) continue;
        const PocketFilmAction a = film_action(set_, oil_, e, i, walls.surface[k]);
        const std::size_t ball = set_.element(i);
        e.add_force(ball, e.to_cylindrical(ball, a.force));
        e.add_moment(ball, e.to_cylindrical(ball, a.arm.cross(a.force)));
        set_.body(e, i).add_force(-a.force, a.point);
        heat_.add(ball, -a.force.dot(a.slip));
      }
    }
  }

 private:
  PocketSet& set_;
  PocketOil oil_;
  HeatByPart& heat_;
};

class PocketFilm final : public SceneEffect, public NonRaceContacts {
 public:
  void declare(SceneBuilder& scene) override {
    const bearing::Bearing& bearing = scene.bearing;
    PocketContact* pockets = scene.find<PocketContact>();
    demand(pockets != nullptr && bearing.cage_films.has_value(),
           "pocket films need oil, and balls in cage pockets");
    const bearing::CageFilms& films = *bearing.cage_films;
    const double r = 0.5 * bearing.balls().diameter;
    const double wall = 1.0 / (r + 0.5 * std::max(bearing.cage->pocket_clearance_1, 1e-3 * r));
    const auto shape = bearing.cage->pocket;
    oil_.viscosity = tribology::cage_film_viscosity(bearing, films.pocket_viscosity);
    oil_.largest = films.largest_pocket_film;
    oil_.critical = std::min(films.critical_film, 0.25 * films.largest_pocket_film);
    oil_.around = 1.0 / r - (shape == bearing::PocketShape::Rectangular ? 0.0 : wall);
    oil_.along = 1.0 / r - (shape == bearing::PocketShape::Spherical ? wall : 0.0);
    set_ = &pockets->set();
    heat_.part.assign(static_cast<std::size_t>(bearing.element_count()), 0.0);
    scene.block<PocketFilmBlock>(Phase::Force, "films of the cage",
                                 BodyId{BodyId::Kind::Segment, 0}, *set_, oil_, heat_);
    scene.energy("pocket films.heat", kPocketFilmHeat, &heat_.sum);
    scene.supports(*this);
  }
  void report(const Evaluation&, Snapshot& snapshot) const override {
    for (std::size_t i = 0; i < heat_.part.size(); ++i)
      snapshot.elements[i].pocket_heat += heat_.part[i];
  }
  void resist(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept override {
    for_films(e, i, [&](const PocketFilmAction& a) {
      const Vec3 m = e.to_cylindrical(i, a.m);
      stiffness += a.stiffness * m * m.transpose();
    });
  }
  /// Squeeze also where the film opens and has none: its replacement may be larger.
  void damp(const Evaluation& e, std::size_t i, Eigen::Matrix2d& damping) noexcept override {
    for_films(e, i, [&](const PocketFilmAction& a) {
      const Eigen::Vector2d m = e.to_cylindrical(i, a.m).head<2>();
      damping += a.shear * Eigen::Matrix2d::Identity() + a.squeeze * m * m.transpose();
    });
  }

 private:
  template <class Visit>
  void for_films(const Evaluation& e, std::size_t i, const Visit& visit) noexcept {
    set_->locate(e, i);
    const contact::WallPoints walls = set_->walls(i);
    for (std::size_t k = 0; k < static_cast<std::size_t>(walls.count); ++k)
      if (walls.surface[k].gap < oil_.largest)
        visit(film_action(*set_, oil_, e, i, walls.surface[k]));
  }

  PocketSet* set_ = nullptr;
  PocketOil oil_;
  HeatByPart heat_;  ///< now
};

}  // namespace

std::unique_ptr<SceneEffect> make_land_film(const ScenePlan& plan) {
  if (!plan.has(Effect::LandFilm)) return nullptr;
  return std::make_unique<LandFilm>();
}
std::span<const LedgerTerm* const> land_film_terms() { return kLandTerms; }

std::unique_ptr<SceneEffect> make_pocket_film(const ScenePlan& plan) {
  if (!plan.has(Effect::PocketFilm) || plan.rollers) return nullptr;  // theirs: roller_pockets.cpp
  return std::make_unique<PocketFilm>();
}
std::span<const LedgerTerm* const> pocket_film_terms() { return kPocketTerms; }

}  // namespace adore::dynamics

#include "runs/motion_watch.hpp"

#include "base/constants.hpp"
#include "contact/ball_pocket.hpp"
#include "contact/conformal.hpp"
#include "contact/line_contact.hpp"
#include "life/stress_life.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::runs {
namespace {

constexpr std::array<const char*, 2> kRaceName{"outer", "inner"};

std::string quantity(double si, const results::UnitPair& unit, results::UnitSystem units) {
  return fmt::format("{:.4g} {}", results::from_si(si, unit, units),
                     results::unit_name(unit, units));
}

/// Of a roller at the wall of its pocket [m]: guide faces (record 7.3) may be shorter than the
/// roller; of several pairs the longest is taken to carry it.
double touching_length(const bearing::RollerGeometry& rollers, const bearing::Cage& cage) {
  double longest = 0.0;
  for (const bearing::RollerPocketFace& face : cage.pocket_faces)
    longest = std::max(longest, face.length);
  return cage.pocket_faces.empty() ? rollers.length : std::min(rollers.length, longest);
}

}  // namespace

MotionLimitMonitor::MotionLimitMonitor(const bearing::Bearing& bearing) : bearing_(bearing) {
  if (!bearing.cage) return;
  const bearing::Cage& cage = *bearing.cage;
  cage_elastic_limit_ = cage.material.elastic_strain_limit * cage.material.elastic_modulus;
  if (!(cage_elastic_limit_ > 0.0)) return;
  point_stress_ratio_ = life::peak_stress_ratios(1.0, cage.material.poisson_ratio).von_mises;
  line_stress_ratio_ = life::peak_stress_ratios(0.0, cage.material.poisson_ratio).von_mises;
  if (bearing.rollers() != nullptr) return;
  const double D = bearing.element_diameter();
  const auto [low, high] = contact::pocket_wall_limits(cage.outer_diameter, cage.inner_diameter,
                                                       bearing.pitch_diameter());
  const contact::PocketLaw law = contact::ball_pocket_law(
      bearing.element_material, cage.material, D,
      contact::wall_curvatures(contact::BallPocket{cage.pocket, D, cage.pocket_clearance_1,
                                                   cage.pocket_clearance_2, low, high}));
  pocket_patch_factor_ = kPi * law.hertz.a_hat * law.hertz.b_hat;
  pocket_load_cap_ = law.law.load_cap;
}

void MotionLimitMonitor::check(const scene::Snapshot& at) {
  const life::MaxPressureContacts now =
      life::max_pressure_contacts(at.elements, bearing_.rollers() != nullptr);
  for (std::size_t race = 0; race < 2; ++race)
    if (now[race].pressure > heaviest_contacts_[race].pressure) {
      heaviest_contacts_[race] = now[race];
      heaviest_contact_times_[race] = at.time;
    }
  if (bearing_.rollers() == nullptr)
    for (std::size_t race = 0; race < 2; ++race) {
      WorstExceedance& worst = worst_shoulder_excess_[race];
      bool passed = false;
      for (std::size_t i = 0; i < at.elements.size(); ++i) {
        const scene::RaceContactSnapshot& contact = at.elements[i].race[race];
        const double over = contact.load > 0.0 ? -contact.edge : 0.0;
        passed = passed || over > 0.0;
        if (over > worst.value) {
          worst.value = over;
          worst.time = at.time;
          worst.element = i + 1;
        }
      }
      worst.steps += passed ? 1 : 0;
    }
  if (bearing_.cage) check_cage(at);
}

double MotionLimitMonitor::pocket_pressure(const scene::PocketContactSnapshot& contact) const {
  const bearing::Cage& cage = *bearing_.cage;
  if (!(contact.force > 0.0)) return 0.0;
  if (const bearing::RollerGeometry* rollers = bearing_.rollers()) {
    const double D = bearing_.element_diameter();
    const double E_star = bearing::contact_modulus(bearing_.element_material, cage.material);
    const bool round = cage.pocket == bearing::PocketShape::Cylindrical;
    const double curvature = round ? 2.0 / D - 2.0 / (D + cage.pocket_clearance_1) : 2.0 / D;
    if (!(curvature > 0.0)) return 0.0;
    return contact::line_pressure(contact.force / touching_length(*rollers, cage), curvature,
                                  E_star)
        .peak;
  }
  const double Q =
      std::min(contact.force, pocket_load_cap_ > 0.0 ? pocket_load_cap_ : contact.force);
  const double area = pocket_patch_factor_ * std::cbrt(Q * Q);
  return std::isfinite(area) && area > 0.0 ? 1.5 * contact.force / area : 0.0;
}

void MotionLimitMonitor::check_cage(const scene::Snapshot& at) {
  const bearing::Cage& cage = *bearing_.cage;
  constexpr double kMinOverlap = 1e-12;  // ends that touch, but for rounding [m]
  bool overlap = false;
  if (at.cages.size() > 1)
    for (std::size_t k = 0; k < at.cages.size(); ++k) {
      const double depth = -at.cages[k].to_next;
      overlap = overlap || depth > kMinOverlap;
      if (depth > std::max(worst_segment_overlap_.value, kMinOverlap))
        worst_segment_overlap_ = {depth, at.time, 0, worst_segment_overlap_.steps,
                                  fmt::format("{} and {}", k + 1, (k + 1) % at.cages.size() + 1)};
    }
  worst_segment_overlap_.steps += overlap ? 1 : 0;
  check_races(at);
  if (!(cage_elastic_limit_ > 0.0)) return;
  bool passed = false;
  const auto offer = [&](double pressure, double stress_ratio, auto&& where) {
    if (!(pressure > 0.0)) return;
    const double stress = pressure * stress_ratio;
    passed = passed || stress > cage_elastic_limit_;
    if (stress <= worst_cage_stress_.value) return;
    worst_cage_stress_ = {stress, at.time, 0, worst_cage_stress_.steps, where()};
    worst_cage_pressure_ = pressure;
  };
  // The stress ratio is computed once, for the contact of largest force: all pockets are identical.
  const scene::PocketContactSnapshot* heaviest = nullptr;
  std::size_t element = 0;
  const auto take = [&](const std::vector<scene::PocketContactSnapshot>& pocket, std::size_t i) {
    for (const scene::PocketContactSnapshot& one : pocket)
      if (one.force > (heaviest == nullptr ? 0.0 : heaviest->force)) {
        heaviest = &one;
        element = i;
      }
  };
  for (std::size_t i = 0; i < at.elements.size(); ++i) take(at.elements[i].pocket, i);
  for (const scene::CageSnapshot& piece : at.cages) take(piece.last_half, at.elements.size());
  if (heaviest != nullptr)
    offer(pocket_pressure(*heaviest),
          bearing_.rollers() != nullptr ? line_stress_ratio_ : point_stress_ratio_, [&] {
            return element < at.elements.size()
                       ? fmt::format("in the pocket of element {}", element + 1)
                       : std::string("in the half pocket at the end of a cage segment");
          });
  for (const scene::CageSnapshot& piece : at.cages)
    for (std::size_t i = 0; i < piece.lands.size() && i < cage.lands.size(); ++i) {
      if (cage.lands[i].guide == bearing::GuideLand::Guide::None) continue;
      const auto race = cage.lands[i].guide == bearing::GuideLand::Guide::Outer ? 0U : 1U;
      const double E_star = bearing::contact_modulus(cage.material, bearing_.race_material[race]);
      const double foundation = 3.0 * kPi * E_star / (16.0 * 0.5 * cage.lands[i].diameter);
      offer(foundation * std::max(-piece.lands[i].gap, 0.0), line_stress_ratio_,
            [&] { return fmt::format("at guide land {}", i + 1); });
    }
  worst_cage_stress_.steps += passed ? 1 : 0;
}

void MotionLimitMonitor::check_races(const scene::Snapshot& at) {
  const bearing::Cage& cage = *bearing_.cage;
  if (at.cages.size() != 1) return;
  for (std::size_t race = 0; race < 2; ++race) {
    const auto guide =
        race == 0 ? bearing::GuideLand::Guide::Outer : bearing::GuideLand::Guide::Inner;
    const bool guided = std::any_of(cage.lands.begin(), cage.lands.end(),
                                    [&](const bearing::GuideLand& l) { return l.guide == guide; });
    const double clearance = race == 0 ? cage.clearance_outer : cage.clearance_inner;
    if (guided || !(clearance > 0.0)) continue;
    const scene::Vec3 between = at.cages.front().position - at.races[race].position;
    const double away = std::hypot(between[1], between[2]);
    WorstExceedance& worst = worst_cage_offset_[race];
    worst.steps += away > 0.5 * clearance ? 1 : 0;
    if (away > worst.value) worst = {away, at.time, 0, worst.steps, {}};
  }
}

std::vector<Finding> MotionLimitMonitor::findings(results::UnitSystem units) const {
  std::vector<Finding> out;
  const auto add = [&](std::string_view code, const std::string& text) -> Finding& {
    return out.emplace_back(make_finding(code, text));
  };
  const life::RaceStrength strength = life::contact_strength(bearing_, heaviest_contacts_);
  for (std::size_t race = 0; race < 2; ++race) {
    life::RaceStrength one{};
    one[race] = strength[race];
    for (Finding& yield : life::strength_warnings("motion.yield", bearing_, one)) {
      yield.message = fmt::format("worst stored step, t = {:.6g} s: {}",
                                  heaviest_contact_times_[race], yield.message);
      out.push_back(std::move(yield.at(heaviest_contact_times_[race])));
    }
    const WorstExceedance& over = worst_shoulder_excess_[race];
    if (over.steps > 0)
      add("motion.shoulder",
          fmt::format("in {} of the stored steps contact ellipses extend beyond the shoulder of "
                      "the {} race. The worst case is ball {} at t = {:.6g} s (by {}). The model "
                      "does not truncate the ellipse, so the computed contact loads are optimistic",
                      over.steps, kRaceName[race], over.element, over.time,
                      quantity(over.value, results::unit::kLength, units)))
          .of(fmt::format("ball {}, {} race", over.element, kRaceName[race]))
          .measure(over.value / validity::range("hertz.shoulder").per, 0.0)
          .at(over.time);
  }
  if (worst_cage_stress_.steps > 0)
    add("cage.yielding",
        fmt::format(
            "in {} of the stored steps the cage ({}) yields. The worst case is {} at t = {:.6g} "
            "s: a von Mises stress of {:.4g} MPa at a pressure of {:.4g} MPa, with an elastic "
            "limit of {:.4g} MPa (cageESL {:.4g} times the modulus). This run treats contacts as "
            "elastic",
            worst_cage_stress_.steps, bearing_.cage->material.name, worst_cage_stress_.where,
            worst_cage_stress_.time, 1e-6 * worst_cage_stress_.value, 1e-6 * worst_cage_pressure_,
            1e-6 * cage_elastic_limit_, bearing_.cage->material.elastic_strain_limit))
        .measure(worst_cage_stress_.value / cage_elastic_limit_, 1.0)
        .of("cage, " + worst_cage_stress_.where)
        .at(worst_cage_stress_.time);
  for (std::size_t race = 0; race < 2; ++race) {
    const WorstExceedance& through = worst_cage_offset_[race];
    if (through.steps == 0) continue;
    const bearing::Cage& cage = *bearing_.cage;
    add("cage.through_race",
        fmt::format(
            "in {} of the stored steps the cage passes through the {} race: its center is up to {} "
            "from the axis of the race (t = {:.6g} s), more than half the clearance ({} = {}). No "
            "land guides the cage at this race. Add a guide land (nGL, record 7.2)",
            through.steps, kRaceName[race], quantity(through.value, results::unit::kLength, units),
            through.time, race == 0 ? "cageCls1" : "cageCls2",
            quantity(race == 0 ? cage.clearance_outer : cage.clearance_inner,
                     results::unit::kLength, units)))
        .measure(through.value, 0.5 * (race == 0 ? cage.clearance_outer : cage.clearance_inner))
        .of(fmt::format("cage, {} race", kRaceName[race]))
        .at(through.time);
  }
  if (worst_segment_overlap_.steps > 0)
    add("cage.overlap",
        fmt::format("in {} of the stored steps segments of the cage overlap. The largest overlap "
                    "is between segments {}: {} at t = {:.6g} s. Contact between segments is not "
                    "modeled. Enter a wider cut (cageAngCut) or a smaller pocket clearance",
                    worst_segment_overlap_.steps, worst_segment_overlap_.where,
                    quantity(worst_segment_overlap_.value, results::unit::kLength, units),
                    worst_segment_overlap_.time))
        .measure(worst_segment_overlap_.value)
        .of("cage")
        .at(worst_segment_overlap_.time);
  return out;
}

std::optional<validity::Finding> MotionLimitMonitor::cage_yield_finding() const {
  if (worst_cage_stress_.steps == 0) return std::nullopt;
  const validity::Range& range = validity::range("cage.yield");
  return validity::Finding{&range,
                           worst_cage_stress_.value / cage_elastic_limit_,
                           range.bounds,
                           "cage, " + worst_cage_stress_.where,
                           worst_cage_stress_.time,
                           worst_cage_stress_.steps,
                           bearing_.cage->material.name};
}

}  // namespace adore::runs

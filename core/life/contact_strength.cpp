#include "life/contact_strength.hpp"

#include "life/stress_life.hpp"

#include <fmt/format.h>

namespace adore::life {
namespace {

using bearing::Bearing;
using bearing::Material;

constexpr std::array<const char*, 2> kRaceName{"outer", "inner"};

void offer(MaxPressureContact& heaviest, std::size_t index, double pressure, double ratio) {
  if (pressure > heaviest.pressure) heaviest = {static_cast<int>(index) + 1, pressure, ratio};
}

ContactStrength strength_of(const MaxPressureContact& contact, const Material& material) {
  ContactStrength out{contact.element, contact.pressure, 0.0,
                      material.elastic_strain_limit * material.elastic_modulus};
  if (contact.element > 0)
    out.von_mises =
        contact.pressure * peak_stress_ratios(contact.ratio, material.poisson_ratio).von_mises;
  return out;
}

}  // namespace

RaceStrength contact_strength(const Bearing& bearing, const MaxPressureContacts& heaviest) {
  RaceStrength out;
  for (std::size_t race = 0; race < 2; ++race)
    out[race] = {strength_of(heaviest[race], bearing.race_material[race]),
                 strength_of(heaviest[race], bearing.element_material)};
  return out;
}

RaceStrength contact_strength(const Bearing& bearing, const statics::StaticSolution& solution) {
  MaxPressureContacts heaviest;
  for (std::size_t k = 0; k < solution.balls.size(); ++k)
    for (std::size_t race = 0; race < 2; ++race) {
      const statics::StaticBall& ball = solution.balls[k];
      if (ball.Q[race] > 0.0)
        offer(heaviest[race], k, ball.p_max[race], ball.b[race] / ball.a[race]);
    }
  return contact_strength(bearing, heaviest);
}

RaceStrength contact_strength(const Bearing& bearing, const statics::RollerSolution& solution) {
  MaxPressureContacts heaviest;
  for (std::size_t k = 0; k < solution.rollers.size(); ++k)
    for (std::size_t race = 0; race < 2; ++race) {
      const statics::RollerRaceContact& c = solution.rollers[k].race[race];
      if (!(c.load > 0.0)) continue;
      const bool point = c.slice_load.empty();  // then half width and length are of an ellipse
      offer(heaviest[race], k, c.peak_pressure, point ? c.half_width / (0.5 * c.length) : 0.0);
    }
  return contact_strength(bearing, heaviest);
}

MaxPressureContacts max_pressure_contacts(std::span<const scene::ElementSnapshot> elements,
                                          bool lines) {
  MaxPressureContacts heaviest;
  for (std::size_t k = 0; k < elements.size(); ++k)
    for (std::size_t race = 0; race < 2; ++race) {
      const scene::RaceContactSnapshot& contact = elements[k].race[race];
      if (contact.load > 0.0)
        offer(heaviest[race], k, contact.max_pressure,
              lines ? 0.0 : contact.half_minor / contact.half_major);
    }
  return heaviest;
}

std::vector<Finding> strength_warnings(const char* code, const Bearing& bearing,
                                       const RaceStrength& strength) {
  const std::string element = bearing.rollers() ? "roller" : "ball";
  std::vector<Finding> out;
  for (std::size_t race = 0; race < 2; ++race)
    for (std::size_t body = 0; body < 2; ++body) {
      const ContactStrength& s = strength[race][body];
      if (!s.yields()) continue;
      const std::string race_name = fmt::format("{} race", kRaceName[race]);
      const std::string where =
          body == 0 ? "the " + race_name : fmt::format("{} {}", element, s.element);
      const Material& material = body == 0 ? bearing.race_material[race] : bearing.element_material;
      out.push_back(
          make_finding(
              code,
              fmt::format("{} ({}) yields at the contact of {} {} with the {}: the von Mises "
                          "stress is {:.4g} MPa at a pressure of {:.4g} MPa, but the elastic limit "
                          "is {:.4g} MPa (strain limit {:.4g} times the modulus). Elastic contact "
                          "loads and lives are not valid above this limit",
                          where, material.name, element, s.element, race_name, 1e-6 * s.von_mises,
                          1e-6 * s.pressure, 1e-6 * s.elastic_limit, material.elastic_strain_limit))
              .of(body == 0 ? race_name : fmt::format("{} {}, {}", element, s.element, race_name))
              .measure(s.von_mises / s.elastic_limit, 1.0));
    }
  return out;
}

}  // namespace adore::life

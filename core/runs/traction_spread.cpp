#include "runs/traction_spread.hpp"

#include "bearing/material.hpp"
#include "contact/groove.hpp"
#include "contact/roller_shape.hpp"
#include "tribology/law_spread.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::runs {
namespace {

constexpr std::array kSlipRatio{0.01, 0.1};

struct Heaviest {
  tribology::LawSpreadContact contact;
  std::size_t element = 0, race = 0;
};

Heaviest heaviest_ball(const Prepared& p) {
  Heaviest out;
  const statics::StaticSolution& solution = p.statics;
  for (std::size_t i = 0; i < solution.balls.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const statics::StaticBall& ball = solution.balls[i];
      if (!(ball.Q[j] > 0.0) || !(ball.p_max[j] > out.contact.point.peak_pressure)) continue;
      out.element = i;
      out.race = j;
      tribology::ContactConditions<double>& at = out.contact.point;
      at.load = ball.Q[j];
      at.peak_pressure = ball.p_max[j];
      at.half_major = ball.a[j];
      at.half_minor = ball.b[j];
      at.curvature =
          contact::race_curvature(p.bearing.balls(), static_cast<int>(j), std::abs(ball.alpha[j]))
              .along_minor;
      at.entrainment = solution.films ? solution.films->race[j][i].speed : 0.0;
    }
  return out;
}

Heaviest heaviest_roller(const Prepared& p) {
  Heaviest out;
  out.contact.line = true;
  const bearing::RollerGeometry& g = *p.bearing.rollers();
  const statics::RollerSolution& solution = *p.rollers;
  for (std::size_t i = 0; i < solution.rollers.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const statics::RollerRaceContact& at = solution.rollers[i].race[j];
      if (!(at.load > 0.0) || !(at.length > 0.0) ||
          !(at.peak_pressure > out.contact.point.peak_pressure))
        continue;
      out.element = i;
      out.race = j;
      tribology::ContactConditions<double>& point = out.contact.point;
      point.load = at.load / at.length;
      point.peak_pressure = at.peak_pressure;
      point.half_minor = at.half_width;
      point.curvature =
          contact::roller_race_curvature(g, contact::roller_profile(g, g.deviation_of(i)),
                                         static_cast<int>(j), g.race_profile_radius(j))
              .rolling;
      point.entrainment = solution.films ? solution.films->race[j][i].speed : 0.0;
    }
  return out;
}

}  // namespace

std::string traction_spread(const Prepared& p) {
  const auto& lubrication = p.bearing.lubrication;
  if (!lubrication || lubrication->user || !(lubrication->meniscus > 0.0)) return {};
  const tribology::Oil oil = tribology::oil_of(lubrication->code);
  if (oil.codes.size() < 2) return {};
  Heaviest at = p.rollers ? heaviest_roller(p) : heaviest_ball(p);
  const double speed = std::abs(at.contact.point.entrainment);
  if (!(at.contact.point.load > 0.0) || !(speed > 0.0)) return {};
  at.contact.modulus =
      2.0 * bearing::contact_modulus(p.bearing.element_material, p.bearing.race_material[at.race]);
  at.contact.temperature =
      0.5 * (p.bearing.race_temperature[at.race] + p.bearing.element_temperature);
  at.contact.meniscus = lubrication->meniscus;
  at.contact.stress_limit = lubrication->stress_limit;
  std::vector<double> slips;
  for (const double ratio : kSlipRatio) slips.push_back(ratio * speed);
  std::string out = fmt::format(
      "Friction coefficients of {} from its traction laws at {} {}, {} race ({:.3g} GPa, {:.4g} K, "
      "{:.3g} m/s), slip 1 % and 10 %: ",
      oil.name, p.rollers ? "roller" : "ball", at.element + 1, at.race == 0 ? "outer" : "inner",
      1e-9 * at.contact.point.peak_pressure, at.contact.temperature, speed);
  for (const tribology::LawSpreadRow& row :
       tribology::law_spread(lubrication->code, at.contact, slips))
    out += fmt::format("kTrac {}{} {:.2g} and {:.2g}, ", row.code,
                       row.recommended ? " (recommended)" : "", row.kappa[0], row.kappa[1]);
  out.resize(out.size() - 2);
  const bool other = !lubrication->recommended && lubrication->code != oil.recommended;
  return out + (other ? ". For the recommended law, set run option filmLaw = recommended."
                      : ". This run uses the recommended law.");
}

}  // namespace adore::runs

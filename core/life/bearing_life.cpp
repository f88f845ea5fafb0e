#include "life/bearing_life.hpp"

#include "base/errors.hpp"
#include "life/capacity.hpp"
#include "life/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::life {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<LifeModel, 3> kStressModels{LifeModel::Updated, LifeModel::Zaretsky,
                                                 LifeModel::Harris};
constexpr double kStaticPressure = 4.2e9;  ///< ISO 76 static rating of ball bearings [Pa]

/// Slices and races that all must survive, one slope.
double product(std::span<const double> lives, double slope) {
  const std::vector<double> slopes(lives.size(), slope);
  return combined_life(lives, slopes);
}

const ContactPatch* heaviest(const RaceContacts& race) {
  const ContactPatch* out = nullptr;
  for (const ContactPatch& patch : race.patches)
    if (patch.Q > 0.0 && (out == nullptr || patch.p_max > out->p_max)) out = &patch;
  return out;
}

/// Loads of whole elements.
std::vector<double> element_loads(const RaceContacts& race, std::size_t slices) {
  std::vector<double> out(race.patches.size() / slices, 0.0);
  for (std::size_t at = 0; at < race.patches.size(); ++at)
    out[at / slices] += std::max(race.patches[at].Q, 0.0);
  return out;
}

}  // namespace

LifeCalculator::LifeCalculator(const LifeGeometry& geometry, LifeParameters parameters)
    : geometry_(geometry), parameters_(std::move(parameters)) {
  for (std::size_t m = 0; m < kStressModels.size(); ++m)
    for (const PartParameters& part : parameters_.part) {
      StressModel model;
      model.model = kStressModels[m];
      model.line = geometry.line;
      model.slope = part.slope.value;
      // The record's exponent of Gupta-Zaretsky is one of life, the hazard law wants its own.
      model.hazard_exponent = part.model[m].stress_exponent.value *
                              (model.model == LifeModel::Zaretsky ? part.slope.value : 1.0);
      model.depth_exponent = part.model[m].depth_exponent.value;
      model.factor = part.model[m].factor.value;
      model.limit = part.fatigue_limit.value;
      model.form = parameters_.choices.limit_form;
      models_.emplace_back(model);
    }
}

double LifeCalculator::gamma(double angle) const {
  return geometry_.diameter * std::cos(angle) / geometry_.pitch_diameter;
}

double LifeCalculator::capacity(const RaceContacts& race, std::size_t index, double length) const {
  CapacityGeometry g;
  g.diameter = geometry_.diameter;
  g.gamma = gamma(race.angle);
  g.cos_alpha = std::cos(race.angle);
  g.count = geometry_.count;
  g.inner = index == bearing::kInnerRacePart;
  g.profile_radius = geometry_.profile_radius;
  g.groove_radius = geometry_.groove_radius[index];
  g.length = length;
  const double factor = parameters_.part[index].original_factor.value;
  return geometry_.line ? line_capacity(g, factor) : point_capacity(g, factor);
}

double LifeCalculator::original_race_life(const BearingContacts& contacts,
                                          std::size_t index) const {
  const RaceContacts& race = contacts.race[index];
  const double slope = parameters_.part[index].slope.value;
  std::vector<double> tracks;
  for (std::size_t k = 0; k < contacts.slices; ++k) {
    double half = 0.0;  // open slices may not say their length
    for (std::size_t at = k; at < race.patches.size(); at += contacts.slices)
      half = std::max(half, race.patches[at].a);
    if (!(half > 0.0)) continue;  // nothing loaded on this track
    // A slice carries Q_c ~ l^(7/9) of its own length: slices multiply to the whole roller's life.
    const double Q_c = capacity(race, index, 2.0 * half);
    std::vector<double> lives;
    for (std::size_t at = k; at < race.patches.size(); at += contacts.slices)
      lives.push_back(original_life(Q_c, race.patches[at].Q, geometry_.line));
    tracks.push_back(race_life(lives, race.rotating, slope));
  }
  return tracks.empty() ? kInfinity : product(tracks, slope);
}

double LifeCalculator::stress_race_life(const BearingContacts& contacts, std::size_t index,
                                        std::size_t model) {
  const RaceContacts& race = contacts.race[index];
  const PartParameters& part = parameters_.part[index];
  const StressLife& law = models_[3 * model + index];
  const Track track = race_track(geometry_.pitch_diameter, gamma(race.angle), geometry_.count,
                                 index == bearing::kInnerRacePart);
  std::vector<double> tracks;
  for (std::size_t k = 0; k < contacts.slices; ++k) {
    std::vector<double> lives;
    for (std::size_t at = k; at < race.patches.size(); at += contacts.slices)
      lives.push_back(law.life(race.patches[at], track, part.poisson_ratio, peaks_));
    tracks.push_back(race_life(lives, race.rotating, part.slope.value));
  }
  return product(tracks, part.slope.value);
}

double LifeCalculator::element_life(const BearingContacts& contacts, std::size_t model) {
  const PartParameters& part = parameters_.part[bearing::kElementPart];
  const StressLife& law = models_[3 * model + bearing::kElementPart];
  std::vector<double> tracks;  // both races, every slice: different volumes of the element
  for (const RaceContacts& race : contacts.race) {
    Track track = element_track(geometry_.pitch_diameter, geometry_.diameter, gamma(race.angle));
    const double rolling = track.cycles;
    for (std::size_t k = 0; k < contacts.slices; ++k) {
      std::vector<double> lives;
      for (std::size_t at = k; at < race.patches.size(); at += contacts.slices) {
        if (!contacts.element_turns.empty())
          track.cycles = contacts.element_turns[at / contacts.slices];
        if (!(track.cycles > 0.0)) track.cycles = rolling;
        lives.push_back(law.life(race.patches[at], track, part.poisson_ratio, peaks_));
      }
      tracks.push_back(race_life(lives, true, part.slope.value));
    }
  }
  const double one = product(tracks, part.slope.value);
  return one * std::pow(geometry_.count, -1.0 / part.slope.value);
}

ModificationFactors LifeCalculator::factors(const BearingContacts& contacts) {
  ModificationFactors out;
  const bearing::LifeChoices& choices = parameters_.choices;
  if (choices.filter) out.filter = filter_factor(*choices.filter);
  for (std::size_t i = 0; i < 3; ++i) {
    const PartParameters& part = parameters_.part[i];
    StleFactors stle{part.stle_material.value,
                     part.stle_process.value,
                     part.stle_hardness.value,
                     choices.film_parameter,
                     out.filter,
                     1.0};
    if (i != bearing::kElementPart) {
      if (choices.film_parameter)
        out.asperity[i] = asperity_hazard(*choices.film_parameter, part.asperity_slope.value,
                                          part.asperity_traction.value);
      const ContactPatch* patch = heaviest(contacts.race[i]);
      if (part.residual_stress != 0.0 && patch != nullptr) {
        const double k = geometry_.line ? 0.0 : patch->b / patch->a;
        const double shear = peaks_.at(k, part.poisson_ratio).max_shear * patch->p_max;
        const auto factor = residual_stress_factor(shear, -part.residual_stress);
        out.residual_refused[i] = !factor;
        out.residual[i] = factor.value_or(1.0);
        stle.residual = out.residual[i];
      }
    } else {
      out.asperity[i] = 0.5 * (out.asperity[0] + out.asperity[1]);
    }
    const StleResult result = stle_factor(stle);
    out.stle[i] = result.factor;
    out.film[i] = result.film;
    out.thin_film = out.thin_film || result.thin_film;
    const TallianResult tallian =
        tallian_factor({part.tallian_material.value, part.tallian_process.value,
                        part.tallian_contamination.value, out.asperity[i]},
                       part.slope.value);
    out.hazard[i] = tallian.hazard;
    out.tallian[i] = tallian.factor;
  }
  return out;
}

LifeState LifeCalculator::evaluate(const BearingContacts& contacts,
                                   const std::optional<LifeModel>& only) {
  for (const RaceContacts& race : contacts.race)
    demand(contacts.slices > 0 &&
               race.patches.size() == static_cast<std::size_t>(geometry_.count) * contacts.slices,
           "one patch per element and slice");
  LifeState out;
  out.relative_speed = contacts.relative_speed;
  out.factors = factors(contacts);
  for (std::size_t m = 0; m < kModels; ++m) {
    const auto model = static_cast<LifeModel>(m);
    if (only && *only != model) {
      for (PartLives& lives : out.model[m].modified)
        lives = {{kNone, kNone, kNone}, kNone, kNone, false};
      continue;
    }
    std::array<double, 3> basic{};
    for (std::size_t i = 0; i < 2; ++i)
      basic[i] = m == 0 ? original_race_life(contacts, i) : stress_race_life(contacts, i, m - 1);
    basic[bearing::kElementPart] = m == 0 ? kNone : element_life(contacts, m - 1);
    const std::array<std::array<double, 3>, kModifications> factor{
        std::array<double, 3>{1.0, 1.0, 1.0}, out.factors.stle, out.factors.tallian};
    for (std::size_t f = 0; f < kModifications; ++f) {
      PartLives& lives = out.model[m].modified[f];
      lives.elements_counted = counts_elements(parameters_, model);
      std::vector<double> all, slopes;
      for (std::size_t i = 0; i < 3; ++i) {
        lives.part[i] = basic[i] * factor[f][i];
        if (i == bearing::kElementPart && !lives.elements_counted) continue;
        all.push_back(lives.part[i]);
        slopes.push_back(parameters_.part[i].slope.value);
      }
      lives.L10 = combined_life(all, slopes);
      lives.L_S =
          lives.L10 * survival_factor(parameters_.survival.value, parameters_.bearing_slope.value);
    }
  }
  return out;
}

BearingLife LifeCalculator::report(const BearingContacts& contacts) {
  BearingLife out;
  out.state = evaluate(contacts);
  out.parameters = parameters_;
  out.notes = parameters_.notes;
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t i = 0; i < 3; ++i)
      out.pressure_exponent[m][i] = models_[3 * m + i].pressure_exponent();
  for (std::size_t i = 0; i < 2; ++i) {
    const RaceContacts& race = contacts.race[i];
    RaceReport& r = out.race[i];
    r.angle = race.angle;
    r.gamma = gamma(race.angle);
    r.rotating = race.rotating;
    r.Q_c = capacity(race, i, geometry_.length);
    const std::vector<double> loads = element_loads(race, contacts.slices);
    r.Q_e = equivalent_load(loads, geometry_.line, race.rotating);
    r.Q_max = *std::max_element(loads.begin(), loads.end());
    r.stress_capacity = {kNone, kNone, kNone};
    const ContactPatch* patch = heaviest(race);
    if (patch == nullptr) continue;
    r.p_max = patch->p_max;
    const double nu = parameters_.part[i].poisson_ratio;
    r.peaks = peaks_.at(geometry_.line ? 0.0 : patch->b / patch->a, nu);
    const Track track = race_track(geometry_.pitch_diameter, r.gamma, geometry_.count, i == 1);
    for (std::size_t m = 0; m < 3; ++m)
      r.stress_capacity[m] = models_[3 * m + i].stress_capacity(*patch, track, nu, peaks_);
    const std::string& name = parameters_.part[i].name;
    if (r.Q_max > r.Q_c)
      out.notes.push_back(fmt::format(
          "WARNING: {}: the largest load exceeds the load capacity; below 1e6 revolutions no model "
          "holds",
          name));
    if (r.p_max > kStaticPressure)
      out.notes.push_back(
          fmt::format("WARNING: {}: the pressure {:.3g} GPa exceeds 4.2 GPa, the static rating; "
                      "plastic deformation is not modelled",
                      name, 1e-9 * r.p_max));
    if (out.state.factors.residual_refused[i])
      out.notes.push_back(
          fmt::format("WARNING: {}: the compressive residual stress is twice the largest shear "
                      "stress or more; its factor has no meaning there and is not applied",
                      name));
  }
  if (parameters_.choices.film_parameter) {
    out.notes.push_back(fmt::format(
        "film parameter {} (run option lifeLambda) is taken at every contact; it is not computed",
        *parameters_.choices.film_parameter));
    if (out.state.factors.thin_film)
      out.notes.push_back(
          "thin film (below 1): no credit is given for material, process and hardness in the STLE "
          "factors");
  } else {
    out.notes.push_back(
        "no lubricant film is computed: the film factor is 1 and the asperity term of the "
        "Tallian-type factor is left out, as for a full film; run option lifeLambda gives a film "
        "parameter");
  }
  return out;
}

BearingLife roller_bearing_life(const bearing::Bearing& bearing, const bearing::LifeInputs& inputs,
                                const statics::RollerSolution& solution) {
  const LifeGeometry geometry = roller_life_geometry(*bearing.rollers, solution);
  LifeCalculator calculator(geometry, life_parameters(inputs, geometry.line, bearing.ball_material,
                                                      bearing.race_material));
  const BearingContacts contacts = life_contacts(solution, bearing);
  BearingLife out = calculator.report(contacts);
  out.iso = iso_report(bearing, contacts, {solution.load[0], solution.load[1], solution.load[2]},
                       out.parameters);
  if (geometry.line)
    out.notes.push_back(
        "every slice of a roller counts as a line contact of its own length, crowned rollers too; "
        "edge stresses beyond the slices' pressure are not in these lives");
  return out;
}

BearingLife ball_bearing_life(const bearing::Bearing& bearing, const bearing::LifeInputs& inputs,
                              const statics::StaticSolution& solution) {
  LifeCalculator calculator(
      ball_life_geometry(bearing.balls),
      life_parameters(inputs, false, bearing.ball_material, bearing.race_material));
  const BearingContacts contacts = life_contacts(solution, bearing);
  BearingLife out = calculator.report(contacts);
  out.iso = iso_report(bearing, contacts, {solution.load[0], solution.load[1], solution.load[2]},
                       out.parameters);
  return out;
}

}  // namespace adore::life

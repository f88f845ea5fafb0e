#include "life/bearing_life.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/validity.hpp"
#include "life/capacity.hpp"
#include "life/statistics.hpp"
#include "scene/no_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::life {
namespace {

constexpr std::array<LifeModel, 3> kStressModels{LifeModel::Updated, LifeModel::Zaretsky,
                                                 LifeModel::Harris};

/// Slices and races that all must survive, one slope.
double product(std::span<const double> lives, double slope) {
  const std::vector<double> slopes(lives.size(), slope);
  return combined_life(lives, slopes);
}

const ContactPatch* heaviest(const std::vector<ContactPatch>& patches) {
  const ContactPatch* out = nullptr;
  for (const ContactPatch& patch : patches)
    if (patch.Q > 0.0 && (out == nullptr || patch.p_max > out->p_max)) out = &patch;
  return out;
}

/// Loads of whole elements.
std::vector<double> element_loads(const std::vector<ContactPatch>& patches, std::size_t slices) {
  std::vector<double> out(patches.size() / slices, 0.0);
  for (std::size_t at = 0; at < patches.size(); ++at)
    out[at / slices] += std::max(patches[at].Q, 0.0);
  return out;
}

/// Λ of a race; of the elements the smaller of both. Empty: no film is computed.
std::optional<double> film_parameter(const BearingContacts& contacts, std::size_t part) {
  const auto& [outer, inner] = contacts.film_parameter;
  if (part != bearing::kElementPart) return contacts.film_parameter[part];
  return outer && inner ? std::min(outer, inner) : std::nullopt;
}

Finding& add_note(std::vector<Finding>& notes, const char* code, std::string text) {
  notes.push_back(make_finding(code, std::move(text)));
  return notes.back();
}

/// Point or line contact, with the reason.
void note_shapes(BearingLife& out, std::size_t slices) {
  const LifeState& state = out.state;
  bool lines = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string& name = out.parameters.part[i].name;
    const double share = state.major_axis[i] / out.effective_length;
    lines = lines || state.model[0].line[i];
    if (!(share > 0.0)) {
      add_note(out.notes, "life.line_unloaded",
               fmt::format("{}: the contacts are line contacts, because the rollers are unloaded "
                           "at this race or have no crown",
                           name))
          .of(name);
      continue;
    }
    const std::string ellipse = fmt::format(
        "{}: the calculated contact ellipse of the most loaded roller is {:.3g} times as long as "
        "the effective roller length",
        name, share);
    const auto shape = [&](const std::string& rest) {
      add_note(out.notes, "life.shape", ellipse + rest).of(name).measure(share);
    };
    switch (state.shape[i]) {
      case ContactShape::Point:
        shape(
            ". The contact is a point contact: ellipse and straight land together are shorter than "
            "the roller (rule of Harris, not verified)");
        break;
      case ContactShape::Line:
        shape(
            ". The contact is a line contact: ellipse and straight land together are longer than "
            "1.5 roller lengths, or the land is at least as long as the ellipse (rule of Harris, "
            "not verified)");
        break;
      case ContactShape::Between: {
        constexpr std::array<const char*, kModels> kNames{"LP", "updated LP", "GZ", "IH"};
        std::string points, all;
        for (std::size_t m = 0; m < kModels; ++m)
          (state.model[m].line[i] ? all : points) += fmt::format(" {},", kNames[m]);
        const auto list = [](std::string text, const char* what) {
          if (text.empty()) return text;
          text.pop_back();
          return fmt::format("{} in{}", what, text);
        };
        const std::string point = list(points, "point contact"), line = list(all, "line contact");
        shape(fmt::format(
            ". The contact is between point and line contact (rule of Harris, not verified). Each "
            "life model uses the contact type that gives the shorter life: {}{}{}",
            point, point.empty() || line.empty() ? "" : "; ", line));
        break;
      }
    }
  }
  if (lines)
    out.notes.push_back(
        slices > 1
            ? make_finding("life.line_slices",
                           "line contacts: the lives are computed from the pressures of the roller "
                           "slices. Higher stresses at edges are not included")
            : make_finding(
                  "life.line_contact",
                  "line contacts: the load is assumed to be uniform over the effective roller "
                  "length, because the solution has one ellipse per contact and no roller slices"));
}

void set_temperatures(LifeParameters& out, const bearing::Bearing& bearing) {
  out.part[bearing::kElementPart].temperature = bearing.element_temperature;
  for (std::size_t i = 0; i < 2; ++i) out.part[i].temperature = bearing.race_temperature[i];
  out.modulus_follows_temperature = bearing.mounting.material_laws;
}

}  // namespace

LifeCalculator::LifeCalculator(const LifeGeometry& geometry, LifeParameters parameters)
    : geometry_(geometry), parameters_(std::move(parameters)) {
  for (const bool line : {false, true}) {
    if (line && !geometry.line) break;
    for (std::size_t m = 0; m < kStressModels.size(); ++m)
      for (std::size_t i = 0; i < 3; ++i) {
        const PartParameters& part = parameters_.part[i];
        StressModel model;
        model.model = kStressModels[m];
        model.line = line;
        model.slope = slope(i, line);
        // The record's exponent of Gupta-Zaretsky is one of life, the hazard law wants its own.
        model.hazard_exponent = part.model[m].stress_exponent.value *
                                (model.model == LifeModel::Zaretsky ? model.slope : 1.0);
        model.depth_exponent = part.model[m].depth_exponent.value;
        model.factor = part.model[m].factor.value;
        model.limit = part.fatigue_limit.value;
        model.form = parameters_.choices.limit_form;
        models_.emplace_back(model);
      }
  }
}

double LifeCalculator::gamma(double angle) const {
  return geometry_.diameter * std::cos(angle) / geometry_.pitch_diameter;
}

LifeCalculator::Contacts LifeCalculator::contacts_by_shape(const BearingContacts& contacts,
                                                           std::size_t race, bool line) const {
  const RaceContacts& at = contacts.race[race];
  if (line || !geometry_.line) return {at.patches, contacts.slices, line};
  return {at.ellipses, 1, false};
}

const StressLife& LifeCalculator::law(std::size_t model, std::size_t part, bool line) const {
  return models_[(line ? 9 : 0) + 3 * model + part];
}

double LifeCalculator::slope(std::size_t part, bool line) const {
  const PartParameters& p = parameters_.part[part];
  return line ? p.slope.value : p.point_slope.value;
}

void LifeCalculator::set_shapes(const BearingContacts& contacts, LifeState& out) const {
  for (std::size_t i = 0; i < 2; ++i) {
    out.shape[i] = geometry_.line ? ContactShape::Line : ContactShape::Point;
    if (!geometry_.line) continue;
    for (const ContactPatch& ellipse : contacts.race[i].ellipses)
      out.major_axis[i] = std::max(out.major_axis[i], 2.0 * ellipse.a);
    if (out.major_axis[i] > 0.0)
      out.shape[i] = contact_shape(out.major_axis[i], geometry_.land[i], geometry_.length);
  }
}

double LifeCalculator::capacity(const RaceContacts& race, std::size_t index, double length,
                                bool line) const {
  CapacityGeometry g;
  g.diameter = geometry_.diameter;
  g.gamma = gamma(race.angle);
  g.cos_alpha = std::cos(race.angle);
  g.count = geometry_.count;
  g.inner = index == bearing::kInnerRacePart;
  g.profile_radius = geometry_.profile_radius[index];
  g.groove_radius = geometry_.groove_radius[index];
  g.length = length;
  const double factor = parameters_.part[index].original_factor.value;
  return line ? line_capacity(g, factor) : point_capacity(g, factor);
}

double LifeCalculator::lundberg_palmgren_race_life(const BearingContacts& contacts,
                                                   std::size_t index, bool line) const {
  const RaceContacts& race = contacts.race[index];
  const auto [patches, slices, _] = contacts_by_shape(contacts, index, line);
  const double e = slope(index, line);
  std::vector<double> tracks;
  for (std::size_t k = 0; k < slices; ++k) {
    double half = 0.0;  // open slices may not say their length
    for (std::size_t at = k; at < patches.size(); at += slices)
      half = std::max(half, patches[at].a);
    if (!(half > 0.0)) continue;  // nothing loaded on this track
    // A slice carries Q_c ~ l^(7/9) with its length: the slices multiply to the whole roller's
    // life.
    const double Q_c = capacity(race, index, 2.0 * half, line);
    std::vector<double> lives;
    lives.reserve(patches.size() / slices);
    for (std::size_t at = k; at < patches.size(); at += slices)
      lives.push_back(lundberg_palmgren_life(Q_c, patches[at].Q, line));
    tracks.push_back(race_life(lives, race.rotating, e));
  }
  return tracks.empty() ? kInfinity : product(tracks, e);
}

double LifeCalculator::stress_race_life(const BearingContacts& contacts, std::size_t index,
                                        std::size_t model, bool line) {
  const RaceContacts& race = contacts.race[index];
  const auto [patches, slices, _] = contacts_by_shape(contacts, index, line);
  const double nu = parameters_.part[index].poisson_ratio, e = slope(index, line);
  const TrackLoading track = race_track_loading(geometry_.pitch_diameter, gamma(race.angle),
                                                geometry_.count, index == bearing::kInnerRacePart);
  std::vector<double> tracks;
  for (std::size_t k = 0; k < slices; ++k) {
    std::vector<double> lives;
    lives.reserve(patches.size() / slices);
    for (std::size_t at = k; at < patches.size(); at += slices)
      lives.push_back(law(model, index, line).life(patches[at], track, nu, peak_stress_cache_));
    tracks.push_back(race_life(lives, race.rotating, e));
  }
  return product(tracks, e);
}

double LifeCalculator::race_life_for_shape(const BearingContacts& contacts, std::size_t race,
                                           std::size_t model, ContactShape shape, bool& line) {
  const auto life = [&](bool as_line) {
    return model == 0 ? lundberg_palmgren_race_life(contacts, race, as_line)
                      : stress_race_life(contacts, race, model - 1, as_line);
  };
  line = shape != ContactShape::Point;
  const double first = life(line);
  if (shape != ContactShape::Between) return first;
  const double point = life(false);
  line = first <= point;
  return std::min(first, point);
}

double LifeCalculator::element_life(const BearingContacts& contacts, std::size_t model,
                                    const std::array<bool, 2>& line) {
  const PartParameters& part = parameters_.part[bearing::kElementPart];
  const double e = slope(bearing::kElementPart, line[0] && line[1]);
  std::array<std::vector<double>, 2> tracks;  // by race: every slice another volume
  for (std::size_t race = 0; race < 2; ++race) {
    TrackLoading track = element_track_loading(geometry_.pitch_diameter, geometry_.diameter,
                                               gamma(contacts.race[race].angle));
    const double rolling = track.cycles;
    const auto [patches, slices, _] = contacts_by_shape(contacts, race, line[race]);
    for (std::size_t k = 0; k < slices; ++k) {
      std::vector<double> lives;
      for (std::size_t at = k; at < patches.size(); at += slices) {
        if (!contacts.element_turns.empty()) track.cycles = contacts.element_turns[at / slices];
        if (!(track.cycles > 0.0)) track.cycles = rolling;
        lives.push_back(law(model, bearing::kElementPart, line[race])
                            .life(patches[at], track, part.poisson_ratio, peak_stress_cache_));
      }
      tracks[race].push_back(race_life(lives, true, e));
    }
  }
  std::vector<double> volumes;
  if (parameters_.choices.shared_track) {
    // Both races stress the same volume: their damages add, slice by slice where both have slices.
    if (tracks[0].size() != tracks[1].size())
      for (std::vector<double>& race : tracks) race = {product(race, e)};
    for (std::size_t k = 0; k < tracks[0].size(); ++k)
      volumes.push_back(1.0 / (1.0 / tracks[0][k] + 1.0 / tracks[1][k]));
  } else {
    for (const std::vector<double>& race : tracks)
      volumes.insert(volumes.end(), race.begin(), race.end());
  }
  return product(volumes, e) * std::pow(geometry_.count, -1.0 / e);
}

ModificationFactors LifeCalculator::factors(const BearingContacts& contacts,
                                            const std::array<bool, 2>& line) {
  ModificationFactors out;
  const bearing::LifeChoices& choices = parameters_.choices;
  if (choices.filter) out.filter = filter_factor(*choices.filter);
  for (std::size_t i = 0; i < 3; ++i) {
    const PartParameters& part = parameters_.part[i];
    out.film_parameter[i] =
        choices.film_parameter ? choices.film_parameter : film_parameter(contacts, i);
    StleFactors stle{part.stle_material.value,
                     part.stle_process.value,
                     part.stle_hardness.value,
                     out.film_parameter[i],
                     out.filter,
                     1.0};
    if (i != bearing::kElementPart) {
      if (out.film_parameter[i])
        out.asperity[i] = asperity_hazard(*out.film_parameter[i], part.asperity_slope.value,
                                          part.asperity_traction.value);
      const ContactPatch* patch = heaviest(contacts_by_shape(contacts, i, line[i]).patches);
      if (part.residual_stress != 0.0 && patch != nullptr) {
        const double k = line[i] ? 0.0 : patch->b / patch->a;
        const double shear = peak_stress_cache_.at(k, part.poisson_ratio).max_shear * patch->p_max;
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
                       slope(i, i == bearing::kElementPart ? line[0] && line[1] : line[i]));
    out.hazard[i] = tallian.hazard;
    out.tallian[i] = tallian.factor;
  }
  return out;
}

LifeState LifeCalculator::evaluate(const BearingContacts& contacts,
                                   const std::optional<LifeModel>& only) {
  for (const RaceContacts& race : contacts.race) {
    const auto count = static_cast<std::size_t>(geometry_.count);
    demand(contacts.slices > 0 && race.patches.size() == count * contacts.slices,
           "the number of contact patches differs from the number of rolling elements times the "
           "number of slices");
    demand(race.ellipses.empty() || race.ellipses.size() == count,
           "the number of contact ellipses differs from the number of rollers");
  }
  LifeState out;
  set_shapes(contacts, out);
  std::array<double, 2> original{};
  for (std::size_t i = 0; i < 2; ++i) {
    bool& line = out.model[0].line[i];
    line = out.shape[i] != ContactShape::Point;
    // Only the shape is needed for another model; it is known except in between.
    if (!only || *only == LifeModel::Original || out.shape[i] == ContactShape::Between)
      original[i] = race_life_for_shape(contacts, i, 0, out.shape[i], line);
  }
  out.relative_speed = contacts.relative_speed;
  out.factors = factors(contacts, out.model[0].line);
  for (std::size_t m = 0; m < kModels; ++m) {
    const auto model = static_cast<LifeModel>(m);
    if (only && *only != model) {
      for (PartLives& lives : out.model[m].modified)
        lives = {{kNaN, kNaN, kNaN}, kNaN, kNaN, false};
      continue;
    }
    std::array<bool, 2>& line = out.model[m].line;
    std::array<double, 3> basic{original[0], original[1], kNaN};
    if (m > 0) {
      for (std::size_t i = 0; i < 2; ++i)
        basic[i] = race_life_for_shape(contacts, i, m, out.shape[i], line[i]);
      basic[bearing::kElementPart] = element_life(contacts, m - 1, line);
    }
    const bool lines = line[0] && line[1];
    const double bearing_slope =
        (lines ? parameters_.bearing_slope : parameters_.point_bearing_slope).value;
    const std::array<std::array<double, 3>, kModifications> factor{
        std::array<double, 3>{1.0, 1.0, 1.0}, out.factors.stle, out.factors.tallian};
    for (std::size_t f = 0; f < kModifications; ++f) {
      PartLives& lives = out.model[m].modified[f];
      lives.elements_counted = includes_element_life(parameters_, model);
      std::vector<double> all, slopes;
      for (std::size_t i = 0; i < 3; ++i) {
        lives.part[i] = basic[i] * factor[f][i];
        if (i == bearing::kElementPart && !lives.elements_counted) continue;
        all.push_back(lives.part[i]);
        slopes.push_back(slope(i, i == bearing::kElementPart ? lines : line[i]));
      }
      lives.L10 = combined_life(all, slopes);
      lives.L_S = lives.L10 * survival_factor(parameters_.survival.value, bearing_slope);
    }
  }
  return out;
}

BearingLife LifeCalculator::report(const BearingContacts& contacts) {
  BearingLife out;
  out.state = evaluate(contacts);
  out.parameters = parameters_;
  out.notes = parameters_.notes;
  if (geometry_.line) out.effective_length = geometry_.length;
  const std::array<bool, 2>& by_original = out.state.model[0].line;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool line =
        i == bearing::kElementPart ? by_original[0] && by_original[1] : by_original[i];
    for (std::size_t m = 0; m < 3; ++m)
      out.pressure_exponent[m][i] = law(m, i, line).pressure_exponent();
    // The printed values are the used ones.
    if (!line) out.parameters.part[i].slope = parameters_.part[i].point_slope;
  }
  if (!(by_original[0] && by_original[1]))
    out.parameters.bearing_slope = parameters_.point_bearing_slope;
  for (std::size_t i = 0; i < 2; ++i) {
    const RaceContacts& race = contacts.race[i];
    RaceReport& r = out.race[i];
    r.line = by_original[i];
    r.major_axis = out.state.major_axis[i] > 0.0 ? out.state.major_axis[i] : kNaN;
    const Contacts used = contacts_by_shape(contacts, i, r.line);
    r.angle = race.angle;
    r.gamma = gamma(race.angle);
    r.rotating = race.rotating;
    r.Q_c = capacity(race, i, geometry_.length, r.line);
    const std::vector<double> loads = element_loads(used.patches, used.slices);
    r.Q_e = equivalent_load(loads, r.line, race.rotating);
    r.Q_max = *std::max_element(loads.begin(), loads.end());
    r.stress_capacity = {kNaN, kNaN, kNaN};
    const ContactPatch* patch = heaviest(used.patches);
    if (patch == nullptr) continue;
    r.p_max = patch->p_max;
    const double nu = parameters_.part[i].poisson_ratio;
    r.peaks = peak_stress_cache_.at(r.line ? 0.0 : patch->b / patch->a, nu);
    const TrackLoading track =
        race_track_loading(geometry_.pitch_diameter, r.gamma, geometry_.count, i == 1);
    for (std::size_t m = 0; m < 3; ++m)
      r.stress_capacity[m] =
          law(m, i, r.line).stress_capacity(*patch, track, nu, peak_stress_cache_);
    const std::string& name = parameters_.part[i].name;
    if (r.Q_max > r.Q_c)
      add_note(
          out.notes, "life.load",
          fmt::format(
              "WARNING: {}: the largest contact load exceeds the load capacity. The life models "
              "are not valid for such loads, which give contact lives below 1e6 revolutions",
              name))
          .of(name)
          .measure(r.Q_max, r.Q_c);
    if (const validity::Range& range = validity::range("life.pressure");
        !range.bounds.contains(r.p_max))
      add_note(
          out.notes, "life.pressure",
          fmt::format("WARNING: {}: the contact pressure of {:.3g} GPa exceeds 4.2 GPa, the "
                      "pressure that defines the static rating. Plastic deformation is not modeled",
                      name, 1e-9 * r.p_max))
          .of(name)
          .measure(r.p_max / range.per, range.bounds.most / range.per);
    if (out.state.factors.residual_refused[i])
      add_note(out.notes, "life.residual_stress",
               fmt::format("WARNING: {}: the compressive residual stress is at least twice the "
                           "largest shear stress, so the residual-stress life factor is not valid "
                           "and is not applied",
                           name))
          .of(name)
          .measure(-1e-6 * parameters_.part[i].residual_stress,
                   2e-6 * r.peaks.max_shear * patch->p_max);
  }
  const auto& films = out.state.factors.film_parameter;
  if (parameters_.choices.film_parameter) {
    add_note(out.notes, "life.film_given",
             fmt::format("film parameter {} (run option lifeLambda) is used at every contact "
                         "instead of the computed value",
                         *parameters_.choices.film_parameter))
        .measure(*parameters_.choices.film_parameter);
  } else if (films[0] || films[1]) {
    for (std::size_t i = 0; i < 2; ++i)
      if (films[i] && *films[i] <= scene::kNoFilmLeft)
        add_note(out.notes, "life.no_film_left",
                 fmt::format("{}: there is no film at the most loaded contact; the film factor for "
                             "the smallest tabulated film parameter is used",
                             parameters_.part[i].name))
            .of(parameters_.part[i].name);
      else if (films[i])
        add_note(out.notes, "life.film_computed",
                 fmt::format("{}: film parameter {:.3g}, computed for the most loaded contact with "
                             "the lubricant of the deck",
                             parameters_.part[i].name, *films[i]))
            .of(parameters_.part[i].name)
            .measure(*films[i]);
  } else {
    add_note(out.notes, "life.no_film",
             "no lubricant film is computed, so the lives assume a full film: the film factor is "
             "1, and the Tallian-type factor has no asperity term. To assume another film "
             "parameter, set the run option lifeLambda");
  }
  if (out.state.factors.thin_film) {
    double least = 1.0;
    for (const std::optional<double>& film : films)
      if (film) least = std::min(least, *film);
    add_note(out.notes, "life.thin_film",
             "thin film (film parameter below 1): the product of the STLE factors for material, "
             "process and hardness is limited to 1")
        .measure(least)
        .at_least(1.0);
  }
  return out;
}

BearingLife roller_bearing_life(const bearing::Bearing& bearing, const bearing::LifeInputs& inputs,
                                const statics::RollerSolution& solution) {
  LifeCalculator calculator(
      roller_life_geometry(*bearing.rollers()),
      life_parameters(inputs, true, bearing.element_material, bearing.race_material));
  const BearingContacts contacts = life_contacts(solution, bearing);
  BearingLife out = calculator.report(contacts);
  out.iso = iso_report(bearing, contacts, {solution.load[0], solution.load[1], solution.load[2]},
                       out.parameters);
  note_shapes(out, contacts.slices);
  set_temperatures(out.parameters, bearing);
  return out;
}

BearingLife ball_bearing_life(const bearing::Bearing& bearing, const bearing::LifeInputs& inputs,
                              const statics::StaticSolution& solution) {
  LifeCalculator calculator(
      ball_life_geometry(bearing.balls()),
      life_parameters(inputs, false, bearing.element_material, bearing.race_material));
  const BearingContacts contacts = life_contacts(solution, bearing);
  BearingLife out = calculator.report(contacts);
  out.iso = iso_report(bearing, contacts, {solution.load[0], solution.load[1], solution.load[2]},
                       out.parameters);
  set_temperatures(out.parameters, bearing);
  return out;
}

}  // namespace adore::life

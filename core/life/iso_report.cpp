#include "base/constants.hpp"
#include "life/bearing_life.hpp"
#include "life/constants.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

/// ISO companions of a bearing, from the model's geometry and loads.
namespace adore::life {
namespace {

/// As it is made, which is what the standards rate: growths in operation would put a bearing of 15
/// or 20 degrees below the limit of its table.
struct Nominal {
  double diameter, pitch_diameter, contact_angle;  ///< [m, rad]
  std::array<double, 2> groove_factor;
};
Nominal nominal(const bearing::Bearing& bearing) {
  const bearing::BallGeometry& balls = bearing.balls();
  if (!bearing.operating || !(bearing.operating->pitch_free > 0.0))
    return {balls.diameter, balls.pitch_diameter, balls.contact_angle, balls.groove_factor};
  const bearing::OperatingFits& at = *bearing.operating;
  Nominal out{balls.diameter - at.element_growth, at.pitch_free, at.free.contact_angle, {}};
  for (const std::size_t j : {0UL, 1UL}) {  // grooves grow by the strain of their race
    const double strain = at.raceway[j].thermal / at.raceway_radius[j];
    out.groove_factor[j] =
        balls.groove_factor[j] * balls.diameter / (out.diameter * (1.0 + strain));
  }
  return out;
}

/// Tables of the standard hold for grooves up to 0.52 (inner) and 0.53 (outer); wider grooves rate
/// by their own.
IsoGeometry iso_geometry_of_balls(const bearing::Bearing& bearing, std::vector<Finding>& notes) {
  const LifeConstants& c = constants();
  const bearing::BallGeometry& balls = bearing.balls();
  const Nominal made = nominal(bearing);
  IsoGeometry out;
  out.element_diameter = 1e3 * made.diameter;
  out.pitch_diameter = 1e3 * made.pitch_diameter;
  out.count = balls.count;
  const double degrees = made.contact_angle / kDegree;
  out.contact_angle = degrees < 15.0 - 1e-9 ? 0.0 : made.contact_angle;
  out.type = degrees > 45.0 + 1e-9 ? IsoType::ThrustBall : IsoType::RadialBall;
  const bool thrust = out.type == IsoType::ThrustBall;
  const double table = thrust ? c.table_conformity_thrust : c.table_conformity_radial;
  const auto conformity = [&](std::size_t race, double limit) {
    return made.groove_factor[race] <= (thrust ? table : limit) + 1e-9 ? table
                                                                       : made.groove_factor[race];
  };
  out.conformity_inner = conformity(1, 0.52);
  out.conformity_outer = conformity(0, 0.53);
  out.rating_factor =
      c.rating_factor.at(thrust ? "thrust ball" : "radial and angular contact ball");
  if (degrees > 0.0 && out.contact_angle == 0.0)
    notes.push_back(
        make_finding("life.iso",
                     fmt::format("ISO: a bearing with a free contact angle of {:.3g} deg is rated "
                                 "as a deep-groove bearing (angle 0)",
                                 degrees))
            .measure("contact angle", degrees, "deg")
            .at_least(15.0));
  else if (degrees > 15.0 + 1e-9 && degrees < 20.0 - 1e-9)
    notes.push_back(
        make_finding(
            "life.iso",
            fmt::format("ISO: the factors X, Y and e for a contact angle of {:.3g} deg are "
                        "interpolated between the values of the standard for 15 and 20 deg",
                        degrees))
            .measure("contact angle", degrees, "deg"));
  const auto replaced = [&](const char* race, double own, double rated, double limit) {
    if (std::abs(own - rated) > 1e-9)
      notes.push_back(
          make_finding("life.iso",
                       fmt::format("ISO: the groove factor of the {} race is {:g}, but the rating "
                                   "uses {:g}, on which the tables of the standard are based. The "
                                   "tables are valid for groove factors up to {:g}",
                                   race, own, rated, limit))
              .of(fmt::format("{} race", race))
              .measure("groove factor", own, "", limit));
  };
  replaced("outer", made.groove_factor[0], out.conformity_outer, thrust ? table : 0.53);
  replaced("inner", made.groove_factor[1], out.conformity_inner, thrust ? table : 0.52);
  return out;
}

/// Rollers: length without corners, angle of the row.
IsoGeometry iso_geometry(const bearing::Bearing& bearing) {
  const bearing::RollerGeometry& rollers = *bearing.rollers();
  IsoGeometry out;
  out.element_diameter = 1e3 * rollers.diameter;
  out.length = 1e3 * rollers.contact_length();
  out.pitch_diameter = 1e3 * rollers.pitch_diameter;
  out.count = rollers.count;
  // The standard's angle of tapered bearings is that of the cup.
  out.contact_angle = rollers.race_angle[bearing::kOuter];
  out.type =
      out.contact_angle > 45.0 * kDegree + 1e-9 ? IsoType::ThrustRoller : IsoType::RadialRoller;
  const bool thrust = out.type == IsoType::ThrustRoller;
  const char* name = thrust ? "thrust tapered" : "cylindrical, tapered, machined needle";
  if (bearing.type == bearing::Type::Spherical)
    name = thrust ? "thrust spherical" : "spherical roller";
  out.rating_factor = constants().rating_factor.at(name);
  return out;
}

/// By the maker's C0, e, X and Y where they are given. The tables of deep-groove bearings ask for
/// f0 Fa/C0: the maker's C0 there means another axial load with the estimated one.
std::optional<EquivalentLoad> equivalent_load(const IsoReport& r) {
  const bool scaled = r.maker.C0 && r.C0_estimate;
  std::optional<EquivalentLoad> out = iso_equivalent_load(
      r.geometry, r.radial, scaled ? r.axial * *r.C0_estimate / *r.C0 : r.axial);
  if (!out || !(scaled || r.maker.e || r.maker.X || r.maker.Y)) return out;
  out->e = r.maker.e.value_or(out->e);
  out->X = r.maker.X.value_or(out->X);
  out->Y = r.maker.Y.value_or(out->Y);
  const bool thrust =
      r.geometry.type == IsoType::ThrustBall || r.geometry.type == IsoType::ThrustRoller;
  out->P = thrust                        ? r.axial
           : r.axial > out->e * r.radial ? out->X * r.radial + out->Y * r.axial
                                         : r.radial;
  return out;
}

/// Viscosity of the oil at the bearing's temperature, the required one and their ratio κ.
void add_viscosity(IsoReport& out, const bearing::Bearing& bearing, const BearingContacts& contacts,
                   const std::optional<bearing::OilByGrade>& oil) {
  if (!oil) return;
  out.oil = oil->name();
  const double races = 0.5 * (bearing.race_temperature[0] + bearing.race_temperature[1]);
  out.oil_temperature = oil->given.bearing_temperature.value_or(races);
  constexpr double kOther = 5.0;  // [K]
  if (std::abs(out.oil_temperature - races) > kOther)
    out.notes.push_back(
        make_finding(
            "life.iso",
            fmt::format("ISO: the viscosity ratio is computed at {:.4g} K (oilTemp), but films and "
                        "clearance are computed at the temperatures of the races (mean {:.4g} K)",
                        out.oil_temperature, races))
            .measure("temperature of the oil", out.oil_temperature, "K"));
  if (!(out.oil_temperature > 0.0)) return;
  out.viscosity = oil->kinematic_viscosity(out.oil_temperature);
  if (const std::string estimates = oil->estimates(); !estimates.empty())
    out.notes.push_back(make_finding(
        "fluid.certainty", fmt::format("oil of record X2, estimated values: {}", estimates)));
  const double rpm = contacts.relative_speed * 30.0 / std::numbers::pi;
  if (!(rpm > 0.0)) return;
  out.required_viscosity = 1e-6 * iso_reference_viscosity(rpm, out.geometry.pitch_diameter);
  if (out.kappa) return;
  out.kappa = *out.viscosity / *out.required_viscosity;
  out.kappa_origin = "oil";
}

/// ISO 16281 life from the loads of the contacts.
ReferenceLife reference_life(const IsoReport& report, const bearing::Bearing& bearing,
                             const BearingContacts& contacts,
                             const std::optional<AisoInput>& condition) {
  std::vector<double> inner, outer;
  const std::size_t tracks = bearing.rollers() ? 1 : contacts.slices;
  const auto loads_of = [&](std::size_t race, std::vector<double>& loads) {
    const std::vector<ContactPatch>& patches = contacts.race[race].patches;
    for (std::size_t at = 0; at < patches.size(); at += tracks)
      loads.push_back(tracks == 1 ? patches[at].Q
                                  : equivalent_split_race_load(patches[at].Q, patches[at + 1].Q));
  };
  loads_of(0, outer);
  loads_of(1, inner);
  const bool inner_rotates = contacts.race[1].rotating, outer_rotates = contacts.race[0].rotating;
  if (!bearing.rollers())
    return iso_reference_life_ball(report.geometry, report.C, inner, outer, inner_rotates,
                                   outer_rotates, condition);
  return iso_reference_life_roller(report.geometry, report.C, {contacts.slices, inner, outer},
                                   inner_rotates, outer_rotates, true, condition);
}

}  // namespace

IsoReport iso_report(const bearing::Bearing& bearing, const BearingContacts& contacts,
                     const std::array<double, 3>& load, const LifeParameters& parameters) {
  IsoReport out;
  out.geometry =
      bearing.rollers() ? iso_geometry(bearing) : iso_geometry_of_balls(bearing, out.notes);
  out.maker = parameters.choices.ratings;
  out.C_estimate = iso_dynamic_rating(out.geometry);
  out.C0_estimate = iso_static_rating(out.geometry);
  out.C = out.maker.C.value_or(out.C_estimate);
  out.C0 = out.maker.C0 ? out.maker.C0 : out.C0_estimate;
  out.axial = std::abs(load[0]);
  out.radial = std::hypot(load[1], load[2]);
  // Loads below rounding of the equilibrium are none.
  constexpr double kNoise = 1e-6;
  const double total = std::hypot(out.axial, out.radial);
  if (out.axial < kNoise * total) out.axial = 0.0;
  if (out.radial < kNoise * total) out.radial = 0.0;
  out.equivalent = equivalent_load(out);
  // The factors in use: the tables' hold above e only.
  if (out.equivalent && out.axial <= out.equivalent->e * out.radial) {
    out.equivalent->X = 1.0;
    out.equivalent->Y = 0.0;
  }
  if (!out.equivalent)
    out.notes.push_back(
        make_finding("life.iso",
                     "ISO: the factors X and Y for a thrust bearing under radial load are not "
                     "available, so the equivalent load is not computed"));
  const double p = iso_load_exponent(out.geometry.type);
  if (out.equivalent && out.equivalent->P > 0.0) {
    out.L10 = std::pow(out.C / out.equivalent->P, p);
    if (out.C0 && out.equivalent->P > std::min(0.5 * out.C, *out.C0))
      out.notes.push_back(
          make_finding("life.iso",
                       "ISO: the equivalent load is above half the dynamic rating or above the "
                       "static rating, so the ISO life is not valid")
              .measure("equivalent load", out.equivalent->P, "N", std::min(0.5 * out.C, *out.C0)));
  }
  out.a1 = iso_reliability_factor(parameters.survival.value);
  const bearing::Material& race = bearing.race_material[bearing::kInner];
  if (out.geometry.type == IsoType::RadialBall)
    out.C_u_estimate =
        iso_fatigue_limit_ball(out.geometry, race.elastic_modulus, race.poisson_ratio);
  else if (out.geometry.type == IsoType::RadialRoller && out.C0)
    out.C_u_estimate =
        iso_fatigue_limit_simple(out.geometry.type, *out.C0, out.geometry.pitch_diameter);
  out.C_u = out.maker.C_u ? out.maker.C_u : out.C_u_estimate;
  out.kappa = parameters.choices.viscosity_ratio;
  out.kappa_origin = out.kappa ? "option" : "";
  add_viscosity(out, bearing, contacts, parameters.choices.oil);
  out.contamination = parameters.choices.contamination;
  std::optional<double> film = parameters.choices.film_parameter;
  if (!film && contacts.film_parameter[0] && contacts.film_parameter[1])
    film = std::min(*contacts.film_parameter[0], *contacts.film_parameter[1]);
  if (!out.kappa && film) {
    out.kappa = std::pow(*film, 1.3);
    out.kappa_origin = "film";
  }
  std::optional<AisoInput> condition;
  if (out.kappa && out.contamination && out.C_u)
    condition = AisoInput{*out.contamination, *out.C_u, *out.kappa};
  else if (out.geometry.type != IsoType::ThrustRoller)
    out.notes.push_back(make_finding(
        "life.iso",
        "ISO: the life factor a_ISO needs the viscosity ratio and the contamination factor, which "
        "are not in the deck. Set the run options isoKappa (or lifeLambda) and isoContamination"));
  if (condition && out.L10) {
    const AisoResult a =
        iso_life_factor(out.geometry.type, condition->kappa,
                        condition->contamination * condition->fatigue_limit / out.equivalent->P);
    out.a_iso = a.value;
    out.outside = a.outside;
    out.L_nm = out.a1 * a.value * *out.L10;
  }
  if (out.geometry.type == IsoType::ThrustRoller) {
    out.notes.push_back(make_finding(
        "life.iso",
        "ISO: the static rating and the ISO 16281 formulas for thrust roller bearings (angle above "
        "45 deg) are not available, so Cu, aISO and L10r are not computed. C and L10 are those of "
        "ISO 281 for a pure axial load"));
    return out;
  }
  if (bearing.rollers() && contacts.slices < 2) {
    out.notes.push_back(make_finding(
        "life.iso",
        "ISO 16281: not computed, because it needs roller slices and this solution has one ellipse "
        "per contact"));
    return out;
  }
  out.reference = reference_life(out, bearing, contacts, condition);
  if (out.reference->modified) out.L_nmr = out.a1 * *out.reference->modified;
  return out;
}

}  // namespace adore::life

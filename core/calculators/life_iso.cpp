#include "calculators/json_access.hpp"
#include "calculators/life.hpp"
#include "life/constants.hpp"
#include "life/iso16281.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace adore::calculators {
namespace {

using life::IsoGeometry;
using life::IsoType;

std::optional<IsoType> iso_type(const std::string& name) {
  if (name == "radial_ball" || name == "angular_contact_ball") return IsoType::RadialBall;
  if (name == "thrust_ball") return IsoType::ThrustBall;
  if (name == "radial_roller") return IsoType::RadialRoller;
  if (name == "thrust_roller") return IsoType::ThrustRoller;
  return std::nullopt;
}

IsoGeometry iso_geometry(const Json& in) {
  IsoGeometry g;
  g.type = iso_type(in.value("bearing", "radial_ball")).value_or(IsoType::RadialBall);
  g.element_diameter = in.value("Dw", in.value("Dwe", 0.0));
  g.length = in.value("Lwe", 0.0);
  g.pitch_diameter = in.value("Dpw", 0.0);
  g.count = whole_or(in, "Z", 0, 0, kMostElements);
  if (g.count > 0 && g.element_diameter > 0.0 && g.pitch_diameter > 0.0)
    require_elements_fit(g.count, g.element_diameter, g.pitch_diameter);
  g.rows = whole_or(in, "i", 1, 1, 100);
  g.contact_angle = in.value("alpha_deg", 0.0) * kDegree;
  const life::LifeConstants& c = life::constants();
  const double table =
      g.type == IsoType::ThrustBall ? c.table_conformity_thrust : c.table_conformity_radial;
  g.conformity_inner = in.value("f_inner", table);
  g.conformity_outer = in.value("f_outer", table);
  g.rating_factor = in.value("bm", 1.0);
  return g;
}

/// Tables of the standard: f_c or f_0 at one γ.
std::optional<Json> table_case(const Json& in) {
  const std::string table = in.at("table");
  const double gamma = get(in, "gamma");
  if (table == "f0")
    return Json{{"f0", life::iso_static_factor_from_pressure(gamma)},
                {"f0_table", life::iso_static_factor(gamma)}};
  IsoGeometry g;
  if (table == "fc_radial_ball")
    g.type = IsoType::RadialBall;
  else if (table == "fc_radial_roller")
    g.type = IsoType::RadialRoller;
  else if (table == "fc_thrust_ball_90")
    g.type = IsoType::ThrustBall;
  else
    return std::nullopt;
  g.element_diameter = 10.0;
  g.length = 10.0;
  g.pitch_diameter = g.element_diameter / gamma;
  g.count = 10;
  if (g.type == IsoType::ThrustBall) {
    g.contact_angle = 90.0 * kDegree;
    g.conformity_inner = g.conformity_outer = life::constants().table_conformity_thrust;
  }
  return Json{{"fc", life::iso_fc(g)}};
}

/// X and Y of the table act above Fa/Fr = e only; below, P = Fr. P = X_applied Fr + Y_applied Fa.
void add_applied_factors(Json& out, double Fr, double Fa) {
  const bool radial = Fa <= get(out, "e") * Fr;
  out["X_applied"] = radial ? 1.0 : get(out, "X");
  out["Y_applied"] = radial ? 0.0 : get(out, "Y");
}

std::optional<Json> equivalent_case(const Json& in) {
  IsoGeometry g = iso_geometry(in);
  constexpr double kTableFrom = 20.0 * kDegree;  // below, e and Y follow from f0 Fa/C0
  require(g.type != IsoType::RadialBall || g.contact_angle >= kTableFrom - 1e-9 || g.count > 0,
          "Dw, Dpw and Z are missing. A ball bearing with a contact angle below 20 degrees needs "
          "them for the factors X and Y. Enter all three");
  const auto load = life::iso_equivalent_load(g, get(in, "Fr"), get(in, "Fa"));
  require(load.has_value(),
          "Fr must be 0: this type of thrust bearing cannot support a radial load. Enter Fr = 0");
  Json out{{"P", load->P}, {"X", load->X}, {"Y", load->Y}, {"e", load->e}};
  add_applied_factors(out, get(in, "Fr"), get(in, "Fa"));
  // The rows of 5 and 10 degrees are not held (iso281.hpp).
  if (const double angle = in.value("alpha_deg", 0.0);
      g.type == IsoType::RadialBall && angle > 0.0 && angle < 15.0 - 1e-9)
    out["rated_at_deg"] = 0.0;
  return out;
}

/// The case gives the static rating, from which the deep-groove factors follow.
std::optional<Json> deep_groove_case(const Json& in) {
  const IsoGeometry g = iso_geometry(in);
  const double f0 = life::iso_static_factor(life::iso_gamma(g));
  // The library uses the rating of its formula; the case's rating scales the axial load.
  const double own = *life::iso_static_rating(g), given = get(in, "C0");
  const double Fr = get(in, "Fr"), Fa = get(in, "Fa");
  const auto load = life::iso_equivalent_load(g, Fr, Fa * own / given);
  const bool radial = Fa <= load->e * Fr;
  Json out{{"f0", f0},
           {"X", load->X},
           {"Y", load->Y},
           {"e", load->e},
           {"P", radial ? Fr : load->X * Fr + load->Y * Fa}};
  add_applied_factors(out, Fr, Fa);
  return out;
}

Json rating(const Json& in) {
  const IsoGeometry g = iso_geometry(in);
  const double C = life::iso_dynamic_rating(g);
  Json out{{"C", C}, {"fc", life::iso_fc(g)}};
  const auto C0 = life::iso_static_rating(g);
  out["C0"] = C0 ? Json(*C0) : Json(nullptr);
  if (in.contains("P"))
    out["L10_at_P"] = std::pow(C / get(in, "P"), life::iso_load_exponent(g.type));
  return out;
}

std::optional<Json> iso281_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("table")) return table_case(in);
  if (in.contains("eC_Cu_over_P")) {
    const auto type = iso_type(in.at("kind"));
    if (!type) return std::nullopt;
    const auto a = life::iso_life_factor(*type, get(in, "kappa"), get(in, "eC_Cu_over_P"));
    return Json{{"aISO", a.value}, {"outside", a.outside}};
  }
  if (in.contains("code"))
    return Json{{"eC", life::iso_contamination(in["code"].get<std::string>(), get(in, "kappa"),
                                               get(in, "Dpw"))}};
  if (in.contains("n_rpm"))
    return Json{{"nu1", life::iso_reference_viscosity(get(in, "n_rpm"), get(in, "Dpw"))}};
  if (in.contains("S")) return Json{{"a1", life::iso_reliability_factor(get(in, "S"))}};
  if (in.contains("sigma_Hu")) {
    const IsoGeometry g = iso_geometry(in);
    return Json{
        {"Cu_simple", life::iso_fatigue_limit_simple(g.type, get(in, "C0"), g.pitch_diameter)},
        {"Cu", life::iso_fatigue_limit_ball(g, 1e6 * get(in, "E"), get(in, "nu"),
                                            1e6 * get(in, "sigma_Hu"))}};
  }
  if (in.contains("Fr")) return in.contains("C0") ? deep_groove_case(in) : equivalent_case(in);
  if (in.contains("Dw") || in.contains("Dwe")) return rating(in);
  return std::nullopt;
}

IsoGeometry reference_geometry(const Json& in, IsoType type) {
  IsoGeometry g;
  g.type = type;
  // γ = D_w cos α / D_pw on a pitch of one.
  g.contact_angle = in.value("alpha_deg", 0.0) * kDegree;
  g.pitch_diameter = 1.0;
  g.element_diameter = get(in, "gamma") / std::cos(g.contact_angle);
  g.length = 1.0;
  g.count = whole(in, "Z", 1, kMostElements);
  g.conformity_inner = in.value("f_inner", 0.52);
  g.conformity_outer = in.value("f_outer", 0.52);
  return g;
}

std::optional<life::AisoInput> condition(const Json& in) {
  if (!in.contains("eC")) return std::nullopt;
  return life::AisoInput{get(in, "eC"), get(in, "Cu"), get(in, "kappa")};
}

Json roller_reference(const Json& in) {
  const IsoGeometry g = reference_geometry(in, IsoType::RadialRoller);
  life::LaminaLoads loads;
  loads.laminae = static_cast<std::size_t>(whole(in, "ns", 1, kMostSlices));
  const std::size_t weights = in.at("lamina_weights").size();
  require(weights == loads.laminae,
          fmt::format("lamina_weights has {}, but ns = {}. Enter one weight for each lamina.",
                      counted(weights, "weight"), loads.laminae));
  for (const Json& Q : in.at("Q_roller"))
    for (const Json& weight : in.at("lamina_weights"))
      loads.inner.push_back(Q.get<double>() * weight.get<double>());
  loads.outer = loads.inner;
  const double C = get(in, "C");
  const auto with = life::iso_reference_life_roller(g, C, loads, true, false, true, condition(in));
  const auto without = life::iso_reference_life_roller(g, C, loads, true, false, false, {});
  return {{"Qci", with.capacity_inner},
          {"Qce", with.capacity_outer},
          {"qci", with.lamina_capacity_inner},
          {"qce", with.lamina_capacity_outer},
          {"L10r", life_to_json(with.L10r)},
          {"Pref", with.P_ref},
          {"Lnmr", with.modified ? life_to_json(*with.modified) : Json(nullptr)},
          {"P_lamina_first", with.lamina_load.front()},
          {"P_lamina_last", with.lamina_load.back()},
          {"L10r_without_edge_factor", life_to_json(without.L10r)},
          {"edge_first", life::lamina_edge_factor(1, loads.laminae)},
          {"edge_second", life::lamina_edge_factor(2, loads.laminae)}};
}

Json ball_reference(const Json& in) {
  const IsoGeometry g = reference_geometry(in, IsoType::RadialBall);
  std::vector<double> inner, outer;
  if (in.contains("Qi")) {
    inner = lives_from_json(in["Qi"]);
    outer = lives_from_json(in.at("Qe"));
  } else {  // half a circle loaded with Q_max cos^1.5, Q_max = 1
    for (int j = 0; j < g.count; ++j) {
      const double c = std::cos(2.0 * kPi * j / g.count);
      inner.push_back(c > 0.0 ? std::pow(c, 1.5) : 0.0);
    }
    outer = inner;
  }
  const auto r =
      life::iso_reference_life_ball(g, get(in, "C"), inner, outer, true, false, condition(in));
  Json out{{"Qci", r.capacity_inner}, {"Qce", r.capacity_outer},      {"Qei", r.load_inner},
           {"Qee", r.load_outer},     {"L10r", life_to_json(r.L10r)}, {"Pref", r.P_ref}};
  if (r.modified) {
    out["Lnmr_S90"] = life_to_json(*r.modified);
    out["aISO_kappa1"] = *r.modified / r.L10r;
  }
  if (in.contains("Fr")) out["Pref_over_Fr"] = r.P_ref / get(in, "Fr");
  return out;
}

std::optional<Json> iso16281_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("Q_roller")) return roller_reference(in);
  return ball_reference(in);
}

}  // namespace

std::vector<Adapter> iso_life_adapters() {
  return {{"life_iso281", iso281_case}, {"life_iso16281", iso16281_case}};
}

}  // namespace adore::calculators

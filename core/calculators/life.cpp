#include "calculators/life.hpp"

#include "calculators/json_access.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/subsurface.hpp"
#include "life/accumulation.hpp"
#include "life/bearing_life.hpp"
#include "life/capacity.hpp"
#include "life/depth_integral.hpp"
#include "life/statistics.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace adore::calculators {

Json life_to_json(double value) {
  if (std::isnan(value)) return nullptr;
  return std::isfinite(value) ? Json(value) : Json("inf");
}

double life_from_json(const Json& value) {
  return value.is_string() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

std::vector<double> lives_from_json(const Json& list) {
  std::vector<double> out;
  for (const Json& entry : list) out.push_back(life_from_json(entry));
  return out;
}

namespace {

using life::CapacityGeometry;
using life::ContactPatch;
using life::LifeModel;

// ---- life_lp_capacity (mm)

std::optional<Json> capacity_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  constexpr double kPound = 4.4482216152605, kInch = 25.4;
  if (in.contains("A")) return Json{{"A_lbf_in", get(in, "A") * std::pow(kInch, 1.8) / kPound}};
  if (in.contains("B"))
    return Json{{"B_lbf_in", get(in, "B") * std::pow(kInch, 50.0 / 27.0) / kPound}};
  CapacityGeometry g;
  g.diameter = 1e-3 * get(in, "D");
  g.cos_alpha = std::cos(in.value("alpha_deg", 0.0) * kDegree);
  g.gamma = in.contains("gamma") ? get(in, "gamma")
                                 : 1e-3 * get(in, "D") * g.cos_alpha / (1e-3 * get(in, "dm"));
  g.count = whole(in, "Z", 1, kMostElements);
  if (in.contains("dm")) require_elements_fit(g.count, get(in, "D"), get(in, "dm"));
  const double fco = in.value("fco", 1.0);
  const double factor = in.value("lam", 1.0) * fco;
  const bool line = in.contains("l");
  if (line) g.length = 1e-3 * get(in, "l");
  g.profile_radius = 0.5 * g.diameter;
  g.groove_radius = in.value("f", 1.0) * g.diameter;
  Json out{{"gamma", g.gamma}};
  for (const bool inner : {true, false}) {
    g.inner = inner;
    out[inner ? "Qc_inner" : "Qc_outer"] =
        line ? life::line_capacity(g, factor) : life::point_capacity(g, factor);
  }
  g.inner = true;
  const double plain = line ? life::line_capacity(g) : life::point_capacity(g);
  out["life_ratio"] = life::lundberg_palmgren_life(plain * fco, 0.5 * plain, line) /
                      life::lundberg_palmgren_life(plain, 0.5 * plain, line);
  return out;
}

// ---- life_race_bearing

std::optional<Json> race_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("L_contacts")) {
    const std::vector<double> lives = lives_from_json(in["L_contacts"]);
    const double e = get(in, "e");
    return Json{{"rotating", life_to_json(life::race_life(lives, true, e))},
                {"stationary", life_to_json(life::race_life(lives, false, e))}};
  }
  if (in.contains("lives"))
    return Json{
        {"L", life_to_json(life::combined_life(lives_from_json(in["lives"]),
                                               lives_from_json(in.at("slopes")), get(in, "S")))}};
  if (in.contains("slope"))
    return Json{{"factor", life::survival_factor(get(in, "S"), get(in, "slope"))}};
  if (!in.contains("Q")) return std::nullopt;
  const bool line = in.at("contact") == "line";
  const double e = get(in, "e");
  const std::vector<double> Q = lives_from_json(in["Q"]);
  Json out;
  std::array<double, 2> lives{};
  for (const bool inner : {true, false}) {
    const std::string side = inner ? "inner" : "outer";
    const bool rotating = in.at(side + "_rotates").get<bool>();
    const double Q_c = get(in, ("Qc_" + side).c_str());
    std::vector<double> contacts;
    for (const double load : Q) contacts.push_back(life::lundberg_palmgren_life(Q_c, load, line));
    const double L = life::race_life(contacts, rotating, e);
    lives[inner ? 1 : 0] = L;
    out["Qe_" + side] = life::equivalent_load(Q, line, rotating);
    out["L_" + side] = life_to_json(L);
  }
  const double L10 = life::combined_life(lives, std::array{e, e});
  out["L10"] = life_to_json(L10);
  out["L10_hours_6000rpm"] = life_to_json(life::life_hours(L10, 6000.0 * kRpm));
  return out;
}

// ---- life_stress_models

struct Geometry {
  life::LifeGeometry life;
  std::array<double, 2> conformity{};  ///< outer, inner
  double alpha = 0.0;
};

Geometry geometry(const Json& geo) {
  Geometry out;
  out.life.line = geo.contains("l");
  out.life.count = whole(geo, "Z", 1, kMostElements);
  out.life.diameter = get(geo, "D");
  out.life.pitch_diameter = get(geo, "dm");
  require_elements_fit(out.life.count, out.life.diameter, out.life.pitch_diameter);
  out.alpha = geo.value("alpha", 0.0) * kDegree;
  out.life.nominal_angle = out.alpha;
  out.life.length = geo.value("l", 0.0);
  out.life.profile_radius.fill(0.5 * out.life.diameter);
  out.conformity = {geo.value("f_outer", 0.0), geo.value("f_inner", 0.0)};
  for (std::size_t i = 0; i < 2; ++i)
    out.life.groove_radius[i] = out.conformity[i] * out.life.diameter;
  return out;
}

/// Hertz contact of one element under a load; race 0 outer, 1 inner.
ContactPatch hertz_patch(const Geometry& g, int race, double Q, double E_star) {
  ContactPatch out;
  out.Q = Q;
  if (!(Q > 0.0)) return out;
  if (g.life.line) {
    const double gamma = g.life.diameter * std::cos(g.alpha) / g.life.pitch_diameter;
    const double R = 0.5 * g.life.diameter * (race == 1 ? 1.0 - gamma : 1.0 + gamma);
    out.a = 0.5 * g.life.length;
    out.b = std::sqrt(4.0 * Q * R / (kPi * g.life.length * E_star));
    out.p_max = 2.0 * Q / (kPi * out.b * g.life.length);
    return out;
  }
  bearing::BallGeometry balls;
  balls.count = g.life.count;
  balls.diameter = g.life.diameter;
  balls.pitch_diameter = g.life.pitch_diameter;
  balls.groove_factor = g.conformity;
  const auto h = contact::hertz_constants(contact::race_curvature(balls, race, g.alpha), E_star);
  out.a = h.a_hat * std::cbrt(Q);
  out.b = h.b_hat * std::cbrt(Q);
  out.p_max = 1.5 * Q / (kPi * out.a * out.b);
  return out;
}

bearing::LifeInputs model_inputs(const Json& in) {
  bearing::LifeInputs out;
  const Json user = in.value("user", Json::object());
  const auto given = [&](const char* key) -> std::optional<double> {
    if (!user.contains(key)) return std::nullopt;
    return get(user, key);
  };
  for (bearing::LifeComponentInput& part : out.part) {
    for (bearing::LifeModelInput* model : {&part.updated, &part.zaretsky, &part.harris}) {
      model->factor = given("factor");
      model->stress_exponent = given("c");
      model->depth_exponent = given("h");
    }
    part.weibull_slope = given("e");
  }
  if (in.value("include_elements", false)) out.choices.elements = bearing::ElementLife::All;
  return out;
}

std::optional<Json> bearing_case(const Json& in) {
  const Geometry g = geometry(in.at("geo"));
  const double E_star = in.value("Estar", life::constants().elastic_modulus / 1.82);
  life::BearingContacts contacts;
  const bool inner_rotates = in.value("inner_rotates", true);
  for (int race = 0; race < 2; ++race) {
    life::RaceContacts& out = contacts.race[static_cast<std::size_t>(race)];
    const char* name = race == 1 ? "Qi" : "Qo";
    for (const double Q : lives_from_json(in.at(name)))
      out.patches.push_back(hertz_patch(g, race, Q, E_star));
    require(out.patches.size() == static_cast<std::size_t>(g.life.count) * contacts.slices,
            fmt::format("{} has {}, but Z = {}. Enter one load for each rolling element.", name,
                        counted(out.patches.size(), "load"), g.life.count));
    out.angle = g.alpha;
    out.rotating = (race == 1) == inner_rotates;
  }
  bearing::Material steel;
  steel.code = 100;
  steel.elastic_modulus = life::constants().elastic_modulus;
  steel.poisson_ratio = 0.3;
  bearing::Material ball = steel;
  if (in.contains("E_ball")) {
    ball.code = 150;
    ball.elastic_modulus = get(in, "E_ball");
    ball.poisson_ratio = get(in, "nu_ball");
  }
  bearing::LifeInputs inputs = model_inputs(in);
  if (in.contains("limit"))
    inputs.limit_factor = get(in, "limit") / life::fatigue_limit_of_code(100)->value;
  life::LifeCalculator calculator(g.life,
                                  life::life_parameters(inputs, g.life.line, ball, {steel, steel}));
  const life::BearingLife result = calculator.report(contacts);
  const std::string name = in.value("model", std::string("LP"));
  const LifeModel model = name == "LP"    ? LifeModel::Original
                          : name == "LPU" ? LifeModel::Updated
                          : name == "GZ"  ? LifeModel::Zaretsky
                                          : LifeModel::Harris;
  const life::PartLives& lives = result.state.of(model, life::LifeModification::None);
  const double slope = result.parameters.part[2].slope.value;
  Json out{{"outer", life_to_json(lives.part[0])},
           {"inner", life_to_json(lives.part[1])},
           {"elements", life_to_json(lives.part[2])},
           {"one_element", life_to_json(lives.part[2] * std::pow(g.life.count, 1.0 / slope))},
           {"bearing", life_to_json(lives.L10)}};
  if (model == LifeModel::Original) return out;
  for (std::size_t i = 0; i < 2; ++i) {
    const life::RaceReport& race = result.race[i];
    const std::string side = i == 1 ? "inner" : "outer";
    const double p_c = race.stress_capacity[static_cast<std::size_t>(model) - 1];
    out["stress_capacity_" + side] = life_to_json(p_c);
    out["Q_at_capacity_" + side] =
        life_to_json(race.Q_max * std::pow(p_c / race.p_max, g.life.line ? 2.0 : 3.0));
  }
  return out;
}

std::optional<Json> stress_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("Qi")) return bearing_case(in);
  if (in.contains("limit_shear")) {
    const double ratio = get(in, "limit_shear") / get(in, "p0");
    const double c = get(in, "c"), h = get(in, "h");
    return Json{{"ratio", life::depth_integral(ratio, c, h) / life::depth_integral(0.0, c, h)}};
  }
  if (in.contains("geo")) {
    const ContactPatch patch = hertz_patch(geometry(in["geo"]), in.at("race") == "inner" ? 1 : 0,
                                           get(in, "Q"), get(in, "Estar"));
    return Json{{"a", patch.a}, {"b", patch.b}, {"p0", patch.p_max}, {"k", patch.b / patch.a}};
  }
  const double k = get(in, "k"), nu = get(in, "nu");
  if (in.contains("z_over_b")) {
    const contact::AxisStress s = contact::axis_stress(1.0 / k, 1.0, 1.0, nu, get(in, "z_over_b"));
    return Json{{"sx", s.minor}, {"sy", s.major}, {"sz", s.depth}};
  }
  const life::PeakStressRatios r = life::peak_stress_ratios(k, nu);
  // t of the closed form, from its depth: z0/b = 1/((t+1) sqrt(2t-1)) and τ0 = sqrt(2t-1)/(2t(t+1))
  // give τ0/z0 = (2t-1)/(2t).
  const double t = 0.5 / (1.0 - r.shear_amplitude / r.shear_depth);
  return Json{{"t", t},
              {"tau0", r.shear_amplitude},
              {"z0", r.shear_depth},
              {"tau_max", r.max_shear},
              {"z_tau", r.max_shear_depth},
              {"vm_max", r.von_mises},
              {"z_vm", r.von_mises_depth}};
}

// ---- life_identities

/// A model with the published exponents on the calibration contact.
life::StressLife published(const std::string& name, bool line) {
  const life::LifeConstants& c = life::constants();
  life::StressModel m;
  m.line = line;
  m.slope = line ? c.line_slope.value : c.point_slope.value;
  m.model = name == "LPU"  ? LifeModel::Updated
            : name == "GZ" ? LifeModel::Zaretsky
                           : LifeModel::Harris;
  const bool zaretsky = m.model == LifeModel::Zaretsky;
  m.hazard_exponent = zaretsky ? c.zaretsky_exponent.value * m.slope : c.stress_exponent.value;
  m.depth_exponent = zaretsky ? 0.0 : c.depth_exponent.value;
  m.limit = m.model == LifeModel::Harris ? c.harris_limit : 0.0;
  return life::StressLife(m);
}

double scaled_ratio(const Json& in) {
  const std::string model = in.at("model"), contact = in.at("contact"), scaled = in.at("scaled");
  const double factor = get(in, "factor");
  const bool line = contact == "line";
  if (model == "LP")
    return life::lundberg_palmgren_life(1.0, factor, line) /
           life::lundberg_palmgren_life(1.0, 1.0, line);
  if (model == "ISO281")
    return std::pow(factor,
                    -life::iso_load_exponent(contact == "ball" ? life::IsoType::RadialBall
                                                               : life::IsoType::RadialRoller));
  const life::CalibrationState& at = life::calibration_state(line);
  double pressure = at.patch.p_max;
  ContactPatch patch = at.patch;
  if (scaled == "stress") {
    patch = life::scale_patch_to_pressure(patch, pressure * factor, line);
  } else if (scaled == "load") {
    patch = life::scale_patch_to_pressure(
        patch, pressure * std::pow(factor, line ? 0.5 : 1.0 / 3.0), line);
  } else {  // the same load on stiffer bodies: p ~ E^(2/3), a, b ~ E^(-1/3); line p ~ √E, b ~ 1/√E
    pressure *= std::pow(factor, line ? 0.5 : 2.0 / 3.0);
    const double size = std::pow(factor, line ? -0.5 : -1.0 / 3.0);
    patch = {patch.Q, line ? patch.a : patch.a * size, patch.b * size, pressure};
  }
  const life::StressLife law = published(model, line);
  life::PeakStressCache peaks;
  return law.life(patch, at.track, at.poisson, peaks) /
         law.life(at.patch, at.track, at.poisson, peaks);
}

std::optional<Json> identity_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("scaled")) return Json{{"life_ratio", scaled_ratio(in)}};
  CapacityGeometry g{0.01, 0.15, 1.0, 10, true, 0.005, 0.0052, 0.0};
  if (in.contains("f_from")) {
    g.groove_radius = get(in, "f_to") * g.diameter;
    const double to = life::point_capacity(g);
    g.groove_radius = get(in, "f_from") * g.diameter;
    return Json{
        {"life_ratio", life::lundberg_palmgren_life(to, 1.0, false) /
                           life::lundberg_palmgren_life(life::point_capacity(g), 1.0, false)}};
  }
  if (in.contains("same_conformity")) {
    g.gamma = get(in, "gamma");
    const double inner = life::point_capacity(g);
    g.inner = false;
    return Json{{"capacity_ratio", life::point_capacity(g) / inner}};
  }
  if (in.contains("L_race")) {
    const double L = get(in, "L_race"), e = get(in, "e");
    return Json{{"L10", life::combined_life(std::array{L, L}, std::array{e, e})}};
  }
  if (in.contains("geo")) {
    const Geometry geo = geometry(in["geo"]);
    const life::LifeConstants& c = life::constants();
    const double E_star = 0.5 * c.elastic_modulus / (1.0 - c.poisson_ratio * c.poisson_ratio);
    const bool inner = in.at("race") == "inner";
    const ContactPatch patch = hertz_patch(geo, inner ? 1 : 0, get(in, "Q"), E_star);
    const double gamma = geo.life.diameter * std::cos(geo.alpha) / geo.life.pitch_diameter;
    life::PeakStressCache peaks;
    const double L =
        published(in.at("model"), geo.life.line)
            .life(patch,
                  life::race_track_loading(geo.life.pitch_diameter, gamma, geo.life.count, inner),
                  0.3, peaks);
    return Json{{"L", L}, {"p0", patch.p_max}};
  }
  if (!in.contains("Q")) return std::nullopt;
  const std::vector<double> Q = lives_from_json(in["Q"]);
  return Json{{"Qe_rotating", life::equivalent_load(Q, false, true)},
              {"Qe_stationary", life::equivalent_load(Q, false, false)}};
}

// ---- life_factors

std::optional<Json> factor_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const life::LifeConstants& c = life::constants();
  if (in.contains("material")) {
    const auto material = c.stle_material.find(in["material"].get<std::string>());
    const auto process = c.stle_process.find(in.at("process").get<std::string>());
    if (material == c.stle_material.end() || process == c.stle_process.end()) return std::nullopt;
    const life::StleResult r =
        life::stle_factor({material->second, process->second, life::hardness_factor(get(in, "Rc")),
                           get(in, "lam"), 1.0, 1.0});
    return Json{{"LF_material", material->second},
                {"LF_process", process->second},
                {"LF_film", r.film},
                {"thin_film", r.thin_film},
                {"LF", r.factor}};
  }
  if (in.contains("facMat")) {
    const double asperity =
        life::asperity_hazard(get(in, "lam"), get(in, "slope_rad"), get(in, "aspTrac"));
    const life::TallianResult r = life::tallian_factor(
        {get(in, "facMat"), get(in, "facProc"), get(in, "facCont"), asperity}, get(in, "e"));
    return Json{{"phi_asp", asperity}, {"phi", r.hazard}, {"life_factor", r.factor}};
  }
  if (in.contains("tau_max")) {
    const auto factor =
        life::residual_stress_factor(get(in, "tau_max"), get(in, "residual"), get(in, "n"));
    return factor ? Json{{"LF", *factor}} : Json{{"LF", nullptr}};
  }
  if (in.contains("lives")) {
    std::vector<double> basic, modified, slopes;
    for (const auto& [part, value] : in["lives"].items()) {
      basic.push_back(life_from_json(value));
      modified.push_back(basic.back() * get(in.at("factors"), part.c_str()));
      slopes.push_back(get(in, "e"));
    }
    return Json{{"basic", life_to_json(life::combined_life(basic, slopes))},
                {"modified", life_to_json(life::combined_life(modified, slopes))}};
  }
  if (in.contains("Rc")) return Json{{"LF", life::hardness_factor(get(in, "Rc"))}};
  if (in.contains("lam")) return Json{{"LF", life::film_factor(get(in, "lam"))}};
  if (in.contains("filter")) return Json{{"LF", life::filter_factor(get(in, "filter"))}};
  return std::nullopt;
}

// ---- life_accumulation

std::optional<Json> accumulation_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  life::DamageSum sum;
  const std::vector<double> inner = lives_from_json(in.at("L_inner")),
                            outer = lives_from_json(in.at("L_outer"));
  for (std::size_t m = 0; m < inner.size(); ++m)
    sum.add(in.at("dt_s").at(m).get<double>(),
            life::damage_rate(in.at("n_rpm").at(m).get<double>() * kRpm,
                              {outer.at(m), inner[m], std::numeric_limits<double>::infinity()}));
  life::DamageParts e{};
  e.fill(get(in, "e"));
  return Json{{"hours", life_to_json(sum.life_hours(e))},
              {"L_mrev", life_to_json(sum.life_mega_revolutions(e))},
              {"damage_outer", sum.damage()[0]},
              {"damage_inner", sum.damage()[1]},
              {"revolutions", sum.revolutions()}};
}

}  // namespace

std::vector<Adapter> life_adapters() {
  std::vector<Adapter> all{
      {"life_lp_capacity", capacity_case}, {"life_race_bearing", race_case},
      {"life_stress_models", stress_case}, {"life_identities", identity_case},
      {"life_factors", factor_case},       {"life_accumulation", accumulation_case}};
  for (Adapter& adapter : iso_life_adapters()) all.push_back(std::move(adapter));
  return all;
}

}  // namespace adore::calculators

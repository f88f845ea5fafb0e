#include "calculators/traction.hpp"

#include "base/errors.hpp"
#include "calculators/json_access.hpp"
#include "tribology/ellipse_traction.hpp"
#include "tribology/newton_film.hpp"
#include "tribology/traction_curve.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace adore::calculators {
namespace {

using bearing::TractionCurve;
using tribology::EllipseGeometry;
using tribology::EllipseKinematics;
using tribology::EllipseTraction;

std::array<double, 4> four_values(const Json& tc) {
  return {tc.at(0), tc.at(1), tc.at(2), tc.at(3)};
}

/// κ is odd in the slip there; the keys A, B, C (and D) are the coefficients of the law.
std::optional<Json> hypothetical_traction(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  TractionCurve curve;
  try {
    curve = tribology::traction_curve(in.at("type"), four_values(in.at("tc")));
  } catch (const InputError& refusal) {
    return Json{{"error", "no_solution"}, {"message", refusal.what()}};
  }
  Json result{{"A", curve.A}, {"B", curve.B}, {"C", curve.C}};
  if (curve.form == TractionCurve::Form::Exponential) result["D"] = curve.D;
  result["kappaAtZeroPlus"] = tribology::traction_coefficient(curve, 0.0);
  result["kappa"] = Json::array();
  for (const double slip : in.at("slip")) {
    const double kappa = tribology::traction_coefficient(curve, std::abs(slip));
    require(kappa >= 0.0, fmt::format("the traction coefficient is negative ({:.4g}) at a slip of "
                                      "{} m/s. Change the constants \"tc\".",
                                      kappa, slip));
    result["kappa"].push_back(std::copysign(kappa, slip));
  }
  return result;
}

/// Laws of tribology_hertzTraction; nullopt for a kind that is not known.
std::optional<tribology::TractionFunction> pressure_law(const Json& law) {
  const std::string kind = law.at("kind");
  if (kind == "newtonianThermal") {
    const tribology::NewtonFilm film{get(law, "h"), get(law, "muStar"), get(law, "alphaStar"),
                                     get(law, "betaStar"), get(law, "K")};
    return tribology::TractionFunction{[film](double slip, double pressure) {
                                         return tribology::film_shear_stress(film, slip, pressure) /
                                                pressure;
                                       },
                                       0.0};
  }
  TractionCurve curve;
  if (kind == "constant") {
    curve = tribology::traction_curve(2, {get(law, "kappa"), get(law, "kappa"), 0.0, 0.0});
  } else if (kind == "hypothetical") {
    curve = tribology::traction_curve(law.at("type"), four_values(law.at("tc")));
  } else {
    return std::nullopt;
  }
  return tribology::TractionFunction{
      [curve](double slip, double) { return tribology::traction_coefficient(curve, slip); },
      curve.form == TractionCurve::Form::TwoSlope ? curve.u0 : 0.0};
}

/// Zeros of c0 + c1 y + c2 y² with |y| < limit, ascending.
std::vector<double> zeros_inside(double c0, double c1, double c2, double limit) {
  std::vector<double> zeros;
  const double discriminant = c1 * c1 - 4.0 * c2 * c0;
  if (discriminant < 0.0) return zeros;
  const double q = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
  for (const double zero : {c2 != 0.0 ? q / c2 : HUGE_VAL, q != 0.0 ? c0 / q : HUGE_VAL}) {
    if (std::abs(zero) < limit) zeros.push_back(zero);
  }
  std::sort(zeros.begin(), zeros.end());
  return zeros;
}

/// x is the minor axis there, y the major one: t = x, c = y, so W_n = -spin and Mz = η f_c - ξ f_t
/// = -M_n. `model: strips` has u_x = Σ slipPoly·yⁱ and no u_y: the limit b -> 0 at constant load,
/// with the quadratic term as rolling on a surface of large radius ρ (slip W_c ξ²/(2ρ)).
std::optional<Json> hertz_traction(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string model = in.value("model", std::string("ellipse"));
  const auto law = pressure_law(in.at("law"));
  if (!law || (model != "ellipse" && model != "strips")) return std::nullopt;
  EllipseGeometry ellipse;
  ellipse.a = get(in, "a");
  ellipse.b = get(in, "b");
  ellipse.Q = 2.0 / 3.0 * std::numbers::pi * ellipse.a * ellipse.b * get(in, "p0");
  EllipseKinematics motion;
  Json result;
  if (model == "strips") {
    const Json& poly = in.at("slipPoly");
    if (poly.size() != 3 || in.at("law").at("kind") == "newtonianThermal") return std::nullopt;
    constexpr double kSlender = 1e-6, kFlatness = 1e6;  // b/a and ρ/a
    ellipse.b = kSlender * ellipse.a;
    ellipse.rho = kFlatness * ellipse.a;
    motion = {0.0, poly[0], 2.0 * ellipse.rho * poly[2].get<double>(), 0.0, poly[1]};
    result["zeros"] = zeros_inside(poly[0], poly[1], poly[2], ellipse.a);
  } else {
    motion = {in.at("slip0").at(1), in.at("slip0").at(0), 0.0, 0.0, -get(in, "spin")};
  }
  const EllipseTraction traction = tribology::ellipse_traction_converged(*law, ellipse, motion);
  result["Fx"] = traction.F_t;
  result["Fy"] = traction.F_c;
  result["Mz"] = -traction.M_n;
  result["heat"] = traction.heat;
  return result;
}

std::optional<Json> contact_traction(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const Json& rotation = in.at("W");
  const EllipseGeometry ellipse{get(in, "Q"), get(in, "a"), get(in, "b"),
                                in.at("rho").is_null() ? 0.0 : get(in, "rho"), get(in, "h0")};
  const EllipseKinematics motion{get(in, "u0_c"), get(in, "u0_t"), rotation.at(0), rotation.at(1),
                                 rotation.at(2)};
  const EllipseTraction traction =
      tribology::ellipse_traction_converged(traction_law(in.at("law")), ellipse, motion);
  Json result{{"F_c", traction.F_c}, {"F_t", traction.F_t}, {"M_c", traction.M_c},
              {"M_t", traction.M_t}, {"M_n", traction.M_n}, {"heat", traction.heat}};
  result["closed_form"] = result;  // the closed forms are of these same quantities
  return result;
}

}  // namespace

std::vector<Adapter> traction_adapters() {
  return {{"tribology_hypotheticalTraction", hypothetical_traction},
          {"tribology_hertzTraction", hertz_traction},
          {"dynamics_contact_traction", contact_traction}};
}

}  // namespace adore::calculators

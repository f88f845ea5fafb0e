#include "bearing/ring_tolerance.hpp"
#include "calculators/json_access.hpp"
#include "calculators/ratings.hpp"
#include "calculators/thermal.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace adore::calculators {
namespace {

using bearing::Interference;
using bearing::RingTolerance;
using bearing::SizeLimits;

// ---- rating_size_limits

std::optional<Json> size_limits_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("ring_class")) {
    const bearing::RingToleranceClass ring =
        bearing::ring_class(in.at("ring_class").get<std::string>());
    const RingTolerance bore = bearing::bore_tolerance(ring, get(in, "bore"));
    const RingTolerance outside = bearing::outside_diameter_tolerance(ring, get(in, "od"));
    return Json{{"bore_lower", bore.limits.lower},
                {"bore_upper", bore.limits.upper},
                {"od_lower", outside.limits.lower},
                {"od_upper", outside.limits.upper},
                {"provenance", bore.seen && outside.seen ? "seen" : "recalled"}};
  }
  const std::string code = in.at("tolerance");
  const SizeLimits limits = bearing::size_limits(code, get(in, "nominal"));
  return Json{{"lower", limits.lower},
              {"upper", limits.upper},
              {"tolerance_width", limits.width()},
              {"largest", get(in, "nominal") + limits.upper},
              {"smallest", get(in, "nominal") + limits.lower},
              {"provenance",
               "computed with the formulas of ISO 286-1 (tolerance grades: from a public source; "
               "fundamental deviations: not verified); printed tables can differ by 1 um"}};
}

// ---- rating_bearing_fit

/// Interferences of the outer [0] and the inner ring [1].
struct Fits {
  std::array<Interference, 2> ring;
  bool seen = true;
};

Interference without(Interference fit, double smoothing) {
  for (double* one : {&fit.least, &fit.mean, &fit.most, &fit.probable_least, &fit.probable_most})
    *one -= smoothing;
  return fit;
}

Fits fits_of(const Json& in) {
  const bearing::RingToleranceClass ring =
      bearing::ring_class(in.value("ring_class", std::string("Normal")));
  const double bore = get(in, "bore"), od = get(in, "od");
  require(od > bore, "od (outside diameter) must be larger than bore. Enter both in meters.");
  const RingTolerance inner = bearing::bore_tolerance(ring, bore);
  const RingTolerance outer = bearing::outside_diameter_tolerance(ring, od);
  Fits out;
  out.seen = inner.seen && outer.seen;
  out.ring[1] =
      without(bearing::interference(bearing::size_limits(in.at("shaft").get<std::string>(), bore),
                                    inner.limits),
              in.value("smoothing_shaft", 0.0));
  out.ring[0] =
      without(bearing::interference(outer.limits,
                                    bearing::size_limits(in.at("housing").get<std::string>(), od)),
              in.value("smoothing_housing", 0.0));
  return out;
}

Json fit_json(const Interference& fit) {
  return {{"least", fit.least},
          {"mean", fit.mean},
          {"most", fit.most},
          {"probable_least", fit.probable_least},
          {"probable_most", fit.probable_most}};
}

/// The inputs of calculator "clearance": values that are not given are those of steel at rest and
/// at room temperature.
Json assembly_inputs(const Json& in) {
  constexpr double kRoom = 293.15;
  const double room = in.value("room_temp", kRoom);
  const Json steel{{"E", 2.08e11}, {"nu", 0.3}, {"rho", 7800.0}, {"cte", 1.17e-5}};
  Json out{{"shaft_id", 0.0},          {"rpm1", 0.0}, {"rpm2", 0.0},
           {"room_temp", room},        {"f1", 0.52},  {"f2", 0.52},
           {"free_contact_angle", 0.0}};
  for (const char* part : {"housing", "shaft", "outer", "inner", "re"}) {
    out["temps"][part] = room;
    out["materials"][part] = steel;
  }
  Json given = in;
  for (const char* own : {"ring_class", "shaft", "housing", "smoothing_shaft", "smoothing_housing",
                          "clearance_least", "clearance_most"})
    given.erase(own);
  out.merge_patch(given);
  return out;
}

/// Clearances after mounting for fits and a free clearance.
struct Clearance {
  double mounted = 0.0, operating = 0.0;
  Json all;
};

Clearance mounted(const Json& assembly, double outer_fit, double inner_fit, double free) {
  Json in = assembly;
  in["fit1"] = outer_fit;
  in["fit2"] = inner_fit;
  in["free_clearance"] = free;
  Clearance out;
  for (const Adapter& adapter : thermal_adapters())
    if (adapter.family == "thermal_clearance")
      out.all = adapter.run(Json{{"kind", "assembly"}, {"inputs", in}}).value();
  out.mounted = get(out.all, "mounted_clearance_room");
  out.operating = get(out.all, "operating_diametral_clearance");
  return out;
}

std::optional<Json> bearing_fit_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const Fits fits = fits_of(in);
  const auto& [outer, inner] = fits.ring;
  Json out{{"shaft_fit", fit_json(inner)},
           {"housing_fit", fit_json(outer)},
           {"provenance", fits.seen ? "ring tolerances: from a public source; ISO 286 tolerances: "
                                      "computed with the formulas of the standard"
                                    : "ring tolerances: not verified; ISO 286 "
                                      "tolerances: computed with the formulas of the standard"}};
  if (!in.contains("type")) return out;
  const double low = get(in, "clearance_least"), high = get(in, "clearance_most");
  require(
      high >= low,
      "clearance_most must not be smaller than clearance_least. Enter a larger clearance_most.");
  const Json assembly = assembly_inputs(in);
  const double mean = 0.5 * (low + high);
  const Clearance middle = mounted(assembly, outer.mean, inner.mean, mean);
  const Clearance least = mounted(assembly, outer.most, inner.most, low);
  const Clearance most = mounted(assembly, outer.least, inner.least, high);
  // Independent deviations about the mean: half ranges of each, added as squares.
  const auto half = [&](const Clearance& a, const Clearance& b, double Clearance::*of) {
    return 0.5 * (a.*of - b.*of);
  };
  const Clearance inner_low = mounted(assembly, outer.mean, inner.probable_least, mean),
                  inner_high = mounted(assembly, outer.mean, inner.probable_most, mean),
                  outer_low = mounted(assembly, outer.probable_least, inner.mean, mean),
                  outer_high = mounted(assembly, outer.probable_most, inner.mean, mean);
  const auto add = [&](const char* name, double Clearance::*of) {
    const double spread = std::sqrt(std::pow(0.5 * (high - low), 2.0) +
                                    std::pow(half(inner_low, inner_high, of), 2.0) +
                                    std::pow(half(outer_low, outer_high, of), 2.0));
    out[name] = {{"least", least.*of},
                 {"mean", middle.*of},
                 {"most", most.*of},
                 {"probable_least", middle.*of - spread},
                 {"probable_most", middle.*of + spread}};
  };
  add("mounted_clearance", &Clearance::mounted);
  add("operating_clearance", &Clearance::operating);
  out["preload_possible"] = least.operating < 0.0;
  for (const char* name :
       {"mounted_pressure_inner", "mounted_pressure_outer", "operating_free_contact_angle_deg"})
    if (middle.all.contains(name)) out[name] = middle.all.at(name);
  return out;
}

}  // namespace

std::vector<Adapter> size_limit_adapters() {
  return {{"rating_size_limits", size_limits_case}, {"rating_bearing_fit", bearing_fit_case}};
}

}  // namespace adore::calculators

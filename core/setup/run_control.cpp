#include "setup/run_control.hpp"

#include "integrators/stepper.hpp"
#include "setup/option_choices.hpp"
#include "setup/race_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>

namespace adore::setup {

RunControl build_run_control(const deck::Deck& deck) {
  RunControl out;
  out.dynamic = deck.integer("mode") >= 0;
  if (const long long points = deck.integer("kStif"); points > 0) {
    out.stiffness = {static_cast<int>(points),
                     deck.si("pctDisp"),
                     {deck.si("rpmRange11"), deck.si("rpmRange12")},
                     {}};
    const deck::ReportOnly quiet(deck, points == 1);  // no last one
    out.stiffness->last = {deck.si("rpmRange21"), deck.si("rpmRange22")};
  }
  if (!out.dynamic) return out;

  // The plan takes them over after the list of values that play no part is made.
  (void)build_race_motions(deck);
  (void)deck.integer("kDOF");

  out.print_option = static_cast<int>(deck.integer("kPrtOpt"));
  out.print_every = static_cast<int>(deck.integer("kPrtFreq"));
  out.plot_every = static_cast<int>(deck.integer("kPltFreq"));
  out.animate_every = static_cast<int>(deck.integer("kAGraf"));
  out.animate = out.animate_every > 0;
  out.life_every = static_cast<int>(deck.integer("kLifeFreq"));
  const long long start = deck.integer("kIcOpt");
  out.start = start == 0  ? StartState::Statics
              : start < 0 ? StartState::FromFinal
                          : StartState::Continue;
  out.max_steps = static_cast<long>(deck.integer("maxStps"));
  out.substeps = static_cast<int>(std::max(deck.integer("nStps"), 1LL));  // N8
  const int code = static_cast<int>(deck.integer("intMet"));
  out.integrator = integrators::name_of_int_met(code);
  if (out.integrator.empty())
    throw InputError({deck.issue(Severity::Error, "intMet", "is not the code of an integrator",
                                 "use 1 to 7 (Runge-Kutta-Fehlberg), 11 to 18 "
                                 "(predictor-corrector), 21, 22 (CVODE), 31 to 33 (ARKODE) or 41 "
                                 "(rk4)")});
  out.step_initial = deck.si("stpInit");
  out.step_minimum = deck.si("stpMin");
  out.step_maximum = deck.si("stpMax");
  out.end_time = deck.si("fTime");
  out.tolerance = deck.si("tol");
  const bool all_balanced = deck.integer("mode") > 0;
  {
    const deck::ReportOnly quiet(deck, all_balanced);
    out.light_load_ratio = all_balanced ? 0.0 : std::max(deck.real("qFac"), 0.0);
  }
  const int count = static_cast<int>(deck.integer("kNumPltElem"));
  for (int i = 1; i <= count; ++i)
    out.monitored.push_back(static_cast<int>(deck.integer("kPltElemInd", i)));
  if (deck.has_record("2.3")) {
    out.master_file = deck.text("masName");
    out.final_file = deck.text("finName");
    for (std::size_t i = 0; i < out.sol_files.size(); ++i) {
      const bool written = i < 6 ? i < out.monitored.size() : i == 6 || out.animate;
      const deck::ReportOnly quiet(deck, !written);
      out.sol_files[i] = deck.text(fmt::format("pltNames{}", i + 1));
    }
  }
  return out;
}

namespace {

/// One option: how it is shown and how a text sets it.
struct Option {
  OptionInfo info;
  std::function<bool(RunOptions&, std::string_view)> set;  ///< false: the text is not a valid value
};

template <class T>
bool parse(std::string_view text, T& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size();
}

bool parse_count(std::string_view text, int& out, int low, int high) {
  int value = 0;
  if (!parse(text, value) || value < low || value > high) return false;
  out = value;
  return true;
}

constexpr std::pair<std::string_view, tribology::ContactSurface> kSurfaces[] = {
    {"curved_edge", tribology::ContactSurface::CurvedEdge},
    {"curved_half", tribology::ContactSurface::CurvedHalf},
    {"curved_undeformed", tribology::ContactSurface::CurvedUndeformed},
    {"flat_undeformed", tribology::ContactSurface::FlatUndeformed},
    {"flat_half", tribology::ContactSurface::FlatHalf},
    {"flat_edge", tribology::ContactSurface::FlatEdge}};

constexpr std::pair<std::string_view, bearing::LifeModel> kLifeModels[] = {
    {"lp", bearing::LifeModel::Original},
    {"lpu", bearing::LifeModel::Updated},
    {"gz", bearing::LifeModel::Zaretsky},
    {"ih", bearing::LifeModel::Harris}};
constexpr std::pair<std::string_view, bearing::LifeModification> kLifeModifications[] = {
    {"", bearing::LifeModification::None},
    {"-stle", bearing::LifeModification::Stle},
    {"-tallian", bearing::LifeModification::Tallian}};

bool parse_stored_life(bearing::LifeChoices& life, std::string_view text) {
  for (const auto& [model, model_code] : kLifeModels)
    for (const auto& [suffix, suffix_code] : kLifeModifications)
      if (text == std::string(model) + std::string(suffix)) {
        life.stored_model = model_code;
        life.stored_modification = suffix_code;
        return true;
      }
  return false;
}

/// "a, b" -> a and b.
std::vector<std::string> names_of(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::string_view name = text.substr(0, comma);
    while (name.starts_with(' ')) name.remove_prefix(1);
    while (name.ends_with(' ')) name.remove_suffix(1);
    if (!name.empty()) out.emplace_back(name);
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return out;
}

/// A number above 0 (up to `most`), or "none".
bool parse_optional(std::string_view text, std::optional<double>& out, double most) {
  if (text == "none") {
    out.reset();
    return true;
  }
  double value = 0.0;
  if (!parse(text, value) || !(value > 0.0 && value <= most)) return false;
  out = value;
  return true;
}

/// A number from `least` to `most`, or "auto".
bool parse_automatic(std::string_view text, std::optional<double>& out, double least, double most) {
  if (text == "auto") {
    out.reset();
    return true;
  }
  double value = 0.0;
  if (!parse(text, value) || !(value >= least && value <= most)) return false;
  out = value;
  return true;
}

/// Laws of the quasi-static solution.
void add_static_options(std::vector<Option>& table) {
  table.push_back({{"ballFriction", "balance",
                    "ball speeds in mode -1, at the start of a motion and in thermal analyses: "
                    "\"balance\" (spin and orbit from friction equilibrium) or \"spin-rule\" "
                    "(kAngVel gives the spin axis)"},
                   [](RunOptions& o, std::string_view v) {
                     if (v != "spin-rule" && v != "balance") return false;
                     o.rollers.ball_balance = v == "balance";
                     return true;
                   }});
  table.push_back({{"rollerFriction", "balance",
                    "roller speeds and skew in mode -1, at the start of a motion and in thermal "
                    "analyses: \"balance\" (skew, spin, orbit and loads from friction equilibrium) "
                    "or \"none\" (no skew, pure rolling)"},
                   [](RunOptions& o, std::string_view v) {
                     if (v != "none" && v != "balance") return false;
                     o.rollers.friction_balance = v == "balance";
                     return true;
                   }});
}

/// Thermal analysis (kTherm): model and surroundings.
void add_thermal_options(std::vector<Option>& table) {
  table.push_back({{"thermalModel", "network",
                    "model of a thermal analysis (kTherm): \"network\" (closed heat balance; each "
                    "ring has a separate temperature) or \"ladder\" (one base temperature, contact "
                    "heat split into halves, raceways as warm as the rolling elements)"},
                   [](RunOptions& o, std::string_view v) {
                     if (v != "network" && v != "ladder") return false;
                     o.thermal_model = v == "network" ? bearing::ThermalModel::Network
                                                      : bearing::ThermalModel::Ladder;
                     return true;
                   }});
  table.push_back({{"thermalBase", "deck",
                    "fixed temperatures of the thermal network: \"deck\" (baseTemp at the location "
                    "that kBaseTemp gives) or \"none\" (only the ambient and coolant temperatures; "
                    "baseTemp is the coolant inlet temperature)"},
                   [](RunOptions& o, std::string_view v) {
                     if (v != "deck" && v != "none") return false;
                     o.thermal_base = v == "deck";
                     return true;
                   }});
  table.push_back(
      {{"thermalTransient", "off",
        "heat capacities of the thermal network: \"off\" (each thermal step of a motion sets the "
        "steady-state temperatures) or \"on\" (temperatures change with time). With \"on\", "
        "thermalAcceleration makes the temperature changes of a motion faster, and mode -1 "
        "computes the temperatures over time, from record 9.1.3 to the steady state or to seizure"},
       [](RunOptions& o, std::string_view v) {
         if (v != "on" && v != "off") return false;
         o.thermal_transient = v == "on";
         return true;
       }});
  table.push_back({{"thermalAcceleration", "1",
                    "thermal time divided by the time of the motion, for thermalTransient=on, 1 to "
                    "1000000000. With 1000, a run of 0.1 s shows 100 s of warm-up"},
                   [](RunOptions& o, std::string_view v) {
                     constexpr double kMaxAcceleration = 1e9;
                     return parse(v, o.thermal_acceleration) && o.thermal_acceleration >= 1.0 &&
                            o.thermal_acceleration <= kMaxAcceleration;
                   }});
  constexpr double kMinTemperature = 1.0, kMaxTemperature = 1000.0, kMaxConductance = 1e6;
  const auto add = [&](const char* name, const char* meaning, double least, double most,
                       std::optional<double>& (*place)(bearing::Surroundings&)) {
    table.push_back({{name, "auto", meaning}, [=](RunOptions& o, std::string_view v) {
                       return parse_automatic(v, place(o.surroundings), least, most);
                     }});
  };
  using bearing::Surroundings;
  add("ambientTemperature",
      "temperature around housing and shaft in the thermal network [K], 1 to 1000, or \"auto\" "
      "(roomTemp)",
      kMinTemperature, kMaxTemperature,
      [](Surroundings& o) -> std::optional<double>& { return o.ambient; });
  add("housingCooling",
      "thermal conductance from the outside of the housing to ambient [W/K], 0 to 1000000, or "
      "\"auto\" (from the ISO 15312 reference heat flow of the seats; 0 if the coolant is a "
      "liquefied gas or kBaseTemp is 4 or 5)",
      0.0, kMaxConductance,
      [](Surroundings& o) -> std::optional<double>& { return o.conductance[0]; });
  add("shaftCooling",
      "thermal conductance from the shaft at the inner race to ambient [W/K], 0 to 1000000, or "
      "\"auto\" (same rule as for housingCooling)",
      0.0, kMaxConductance,
      [](Surroundings& o) -> std::optional<double>& { return o.conductance[1]; });
  add("coolantInlet",
      "coolant inlet temperature [K], 1 to 1000, or \"auto\" (baseTemp). This option is used if "
      "baseTemp is the temperature of a race, the housing or the shaft (kBaseTemp 0, 1, 4, 5)",
      kMinTemperature, kMaxTemperature,
      [](Surroundings& o) -> std::optional<double>& { return o.coolant_inlet; });
}

/// Fatigue life: what no record of the deck holds.
void add_life_options(std::vector<Option>& table) {
  const auto add = [&](const char* name, const char* value, const char* meaning,
                       std::function<bool(bearing::LifeChoices&, std::string_view)> set) {
    table.push_back({{name, value, meaning},
                     [set](RunOptions& o, std::string_view v) { return set(o.life, v); }});
  };
  add("sol7Life", "lp",
      "life model in SOL7, terminal output and sweeps: \"lp\" (original Lundberg-Palmgren), or one "
      "of three models that this program calibrated against \"lp\": \"lpu\" (updated "
      "Lundberg-Palmgren), \"gz\" (Gupta-Zaretsky) or \"ih\" (Ioannides-Harris). Append \"-stle\" "
      "or \"-tallian\" to include the STLE or Tallian-type life factors",
      parse_stored_life);
  add("lifeElements", "gz",
      "life models whose bearing life includes the rolling elements: \"gz\" (Gupta-Zaretsky, "
      "except for ceramic elements), \"all\" (updated Lundberg-Palmgren, Gupta-Zaretsky and "
      "Ioannides-Harris) or \"none\"",
      [](bearing::LifeChoices& o, std::string_view v) {
        using bearing::ElementLife;
        if (v != "gz" && v != "all" && v != "none") return false;
        o.elements = v == "gz"    ? ElementLife::Zaretsky
                     : v == "all" ? ElementLife::All
                                  : ElementLife::None;
        return true;
      });
  add("lifeElementTracks", "separate",
      "stressed volume of a rolling element: \"separate\" (each race stresses a different volume) "
      "or \"shared\" (both races stress the same volume, as in rollers)",
      [](bearing::LifeChoices& o, std::string_view v) {
        if (v != "separate" && v != "shared") return false;
        o.shared_track = v == "shared";
        return true;
      });
  add("lifeLimitForm", "peak",
      "stress criterion of the Ioannides-Harris life: \"peak\" (largest von Mises stress minus the "
      "stress limit) or \"integral\" (orthogonal shear stress above its limit, integrated over "
      "depth)",
      [](bearing::LifeChoices& o, std::string_view v) {
        if (v != "peak" && v != "integral") return false;
        o.limit_form = v == "peak" ? bearing::LimitForm::Peak : bearing::LimitForm::Integral;
        return true;
      });
  add("lifeLambda", "none",
      "film parameter (film thickness divided by roughness) for the life factors if no film is "
      "computed: above 0 and at most 1000, or \"none\"",
      [](bearing::LifeChoices& o, std::string_view v) {
        return parse_optional(v, o.film_parameter, 1e3);
      });
  add("lifeFilter", "none",
      "filter rating in µm at a beta ratio of 200, for the STLE life factor: above 0 and at most "
      "1000, or \"none\"",
      [](bearing::LifeChoices& o, std::string_view v) { return parse_optional(v, o.filter, 1e3); });
  add("lifeSkip", "0",
      "number of shaft revolutions at the start of the run that are excluded from the life of the "
      "run, 0 or more",
      [](bearing::LifeChoices& o, std::string_view v) {
        return parse(v, o.skip_turns) && o.skip_turns >= 0.0;
      });
  add("isoKappa", "none", "viscosity ratio of ISO 281: above 0 and at most 1000, or \"none\"",
      [](bearing::LifeChoices& o, std::string_view v) {
        return parse_optional(v, o.viscosity_ratio, 1e3);
      });
  add("isoContamination", "none",
      "contamination factor e_C of ISO 281: above 0 and at most 1, or \"none\"",
      [](bearing::LifeChoices& o, std::string_view v) {
        return parse_optional(v, o.contamination, 1.0);
      });
}

const std::vector<Option>& options() {
  static const std::vector<Option> table = [] {
    const RunOptions defaults;
    std::vector<Option> all{
        {{"ellipseMajor", fmt::format("{}", defaults.system.ellipse_major),
          "number of quadrature nodes along the major axis of the contact ellipse, 10 to 100, "
          "rounded up to a multiple of 5. If neither ellipseMajor nor ellipseMinor is given, balls "
          "in oil use 12 x 4 nodes (major x minor axis), or 16 x 2 nodes for kTrac 8 and 12"},
         [](RunOptions& o, std::string_view v) {
           return parse_count(v, o.system.ellipse_major, 10, 100);
         }},
        {{"ellipseMinor", fmt::format("{}", defaults.system.ellipse_minor),
          "number of quadrature nodes along the minor axis of the contact ellipse, 1 to 64. The "
          "default is 4 if the traction of the film depends on pressure (kTrac 1 to 7, 10, 11, 13 "
          "to 20)"},
         [](RunOptions& o, std::string_view v) {
           return parse_count(v, o.system.ellipse_minor, 1, 64);
         }},
        {{"contactSurface", "curved_edge",
          "surface on which the slip in contact ellipses is computed. A curved surface includes "
          "Heathcote slip; a flat surface does not. The surface goes through the ends of the major "
          "axis (\"curved_edge\", \"flat_edge\"), is at half the approach (\"curved_half\", "
          "\"flat_half\") or is on the undeformed ball (\"curved_undeformed\", "
          "\"flat_undeformed\")"},
         [](RunOptions& o, std::string_view v) {
           for (const auto& [name, surface] : kSurfaces)
             if (name == v) return o.system.surface = surface, true;
           return false;
         }},
        {{"hertzConstants", "moving",
          "Hertz constants of balls in motion: \"moving\" (for the present contact angle) or "
          "\"frozen\" (for the mean contact angle of the equilibrium; the run is slightly faster "
          "than with \"moving\")"},
         [](RunOptions& o, std::string_view v) {
           if (v != "moving" && v != "frozen") return false;
           o.system.moving_angle = v == "moving";
           return true;
         }},
        {{"startAtRest", "on",
          "start of a motion without speeds: \"on\" (the cage and the elements without load start "
          "at "
          "their rest positions; record 9.6 is not used) or \"off\" (as in a motion with speeds: "
          "the cage falls from its position of record 9.6)"},
         [](RunOptions&, std::string_view v) { return v == "on" || v == "off"; }},
        {{"contactDamping", "material",
          "energy loss of all normal contacts: \"material\" (loss factors and impact losses of the "
          "materials, squeeze of the oil film); a factor on the losses of \"material\" (0.01x to "
          "100x, such as 2x); the impact loss alpha of all material pairs in s/m (at most 100); or "
          "0 (elastic contacts for conservation studies; contact vibrations do not decay). An "
          "element that hits a race at a small speed v rebounds at about (1 - alpha v) v. Dry "
          "steel has an alpha of 0.08 to 0.32"},
         [](RunOptions& o, std::string_view v) {
           o.system.damping.impact_loss = 0.0;
           o.system.damping.factor = 1.0;
           std::erase(o.effects_off, kContactDamping);
           if (v == "material") return true;
           double value = 0.0;
           if (v.ends_with('x'))
             return parse(v.substr(0, v.size() - 1), o.system.damping.factor) &&
                    o.system.damping.factor >= 0.01 && o.system.damping.factor <= 100.0;
           if (!parse(v, value) || !(value >= 0.0 && value <= 100.0)) return false;
           o.system.damping.impact_loss = value;
           if (value == 0.0) o.effects_off.emplace_back(kContactDamping);
           return true;
         }},
        {{"filmStress", "surface",
          "computation of the film shear stress for kTrac 8 and 11 to 20: \"surface\" "
          "(interpolated; the tolerance of the run sets the error) or \"direct\" (integrated at "
          "every evaluation). Compared with \"surface\", \"direct\" is thousands of times slower "
          "for kTrac 8 and 12, and two to three times slower for the other codes"},
         [](RunOptions& o, std::string_view v) {
           if (v != "surface" && v != "direct") return false;
           o.direct_strips = v == "direct";
           return true;
         }},
        {{"filmLaw", "code",
          "traction law of oil films: \"code\" (the law of kTrac) or \"recommended\" (the law that "
          "lubricants.json recommends for the same oil; kTrac still gives the film thickness)"},
         [](RunOptions& o, std::string_view v) {
           if (v != "code" && v != "recommended") return false;
           o.recommended_law = v == "recommended";
           return true;
         }},
        {{"filmStressLimit", "on",
          "limiting shear stress of oil films between elements and races, as a fraction of the "
          "pressure for each lubricant (lubricants.json): \"on\", or \"off\" (classic laws, with "
          "friction coefficients far above 0.1 beyond 1 GPa). With \"off\", kTrac 8 and 12 keep "
          "their limit, and the run displays a warning"},
         [](RunOptions& o, std::string_view v) {
           if (v != "on" && v != "off") return false;
           o.stress_limit = v == "on";
           return true;
         }},
        {{"lubStressLimit", "none",
          "limiting shear stress divided by pressure for the user-defined lubricant (kTrac 9) at "
          "40 °C: 0.001 to 1, or \"none\" (0.07 is assumed)"},
         [](RunOptions& o, std::string_view v) {
           return parse_optional(v, o.user_limit, 1.0) && o.user_limit.value_or(1.0) >= 1e-3;
         }},
        {{"lubStressSoftening", fmt::format("{:g}", defaults.user_softening),
          "relative decrease of lubStressLimit per kelvin, 0 to 0.1 [1/K]"},
         [](RunOptions& o, std::string_view v) {
           return parse(v, o.user_softening) && o.user_softening >= 0.0 && o.user_softening <= 0.1;
         }},
        {{"filmPrecision", "single",
          "floating-point precision of oil films between elements and races (not for kTrac 12 with "
          "iTherm): \"single\" (relative error of traction 3e-5) or \"double\". With \"single\", "
          "the precision is still double if tol is below 1e-6, the integrator is implicit or "
          "elements are quasi-static"},
         [](RunOptions& o, std::string_view v) {
           if (v != "single" && v != "double") return false;
           o.single_films = v == "single";
           return true;
         }},
        {{"landSlices", fmt::format("{}", defaults.system.land_slices),
          "number of slices along each cage guide land, 1 to 99"},
         [](RunOptions& o, std::string_view v) {
           return parse_count(v, o.system.land_slices, 1, 99);
         }},
        {{"rollerSlices", fmt::format("{}", defaults.rollers.slices),
          "number of slices along each roller, 1 to 999"},
         [](RunOptions& o, std::string_view v) {
           return parse_count(v, o.rollers.slices, 1, 999);
         }},
        {{"rollerContact", "sliced",
          "contact model of roller and race: \"sliced\", or \"point\" (one Hertz ellipse; barrel "
          "rollers only)"},
         [](RunOptions& o, std::string_view v) {
           if (v != "sliced" && v != "point") return false;
           o.rollers.contact =
               v == "point" ? statics::RollerContact::Point : statics::RollerContact::Sliced;
           return true;
         }},
        {{"checkpointSeconds", fmt::format("{}", defaults.checkpoint_seconds),
          "computing time between two updates of the files FINAL and MASTER [s], above 0"},
         [](RunOptions& o, std::string_view v) {
           return parse(v, o.checkpoint_seconds) && o.checkpoint_seconds > 0.0;
         }},
        {{"resultsH5", "1", "write RESULTS.h5: 1 (yes) or 0 (no)"},
         [](RunOptions& o, std::string_view v) {
           int value = 0;
           if (!parse_count(v, value, 0, 1)) return false;
           o.results_h5 = value == 1;
           return true;
         }},
        {{"seed", fmt::format("{}", defaults.seed),
          "seed of the random imperfections of rolling elements (kReGeoImp 1), a whole number from "
          "0 to 9223372036854775807; the same seed gives the same bearing"},
         [](RunOptions& o, std::string_view v) {
           std::int64_t value = 0;
           if (!parse(v, value) || value < 0) return false;
           o.seed = static_cast<std::uint64_t>(value);
           return true;
         }},
        {{"effectsOff", "",
          "effects to switch off: names from `adore plan`, separated by commas, such as "
          "\"gravity,momentum ledger\""},
         [](RunOptions& o, std::string_view v) {
           const bool elastic = std::count(o.effects_off.begin(), o.effects_off.end(),
                                           kContactDamping) > 0;  // by contactDamping = 0
           o.effects_off = names_of(v);
           if (elastic) o.effects_off.emplace_back(kContactDamping);
           return true;
         }},
        {{"userProcess", "0",
          "run the plug-in of --user in a separate process, so that a crash or endless loop of the "
          "plug-in ends the run properly: 1 (yes) or 0 (no)"},
         [](RunOptions& o, std::string_view v) {
           int value = 0;
           if (!parse_count(v, value, 0, 1)) return false;
           o.user_process = value == 1;
           return true;
         }},
        {{"userTimeout", fmt::format("{}", defaults.user_timeout),
          "time limit for each call of a plug-in in a separate process [s], above 0 and below "
          "1000000"},
         [](RunOptions& o, std::string_view v) {
           return parse(v, o.user_timeout) && o.user_timeout > 0.0 && o.user_timeout < 1e6;
         }},
        {{"userSample", fmt::format("{}", defaults.user_sample),
          "interval n of a check of user routines, 1 to 1000000000, or 0 for no check: every n-th "
          "call of a routine in a motion is repeated. The run stops if the repeated call gives a "
          "different result"},
         [](RunOptions& o, std::string_view v) {
           return parse_count(v, o.user_sample, 0, 1'000'000'000);
         }},
        {{"centrifugalGrowth", "1",
          "operating fits and clearances include the centrifugal growth of rings, shaft, housing "
          "and cage: 1 (yes) or 0 (no)"},
         [](RunOptions& o, std::string_view v) {
           int value = 0;
           if (!parse_count(v, value, 0, 1)) return false;
           o.centrifugal_growth = value == 1;
           return true;
         }},
    };
    add_static_options(all);
    add_thermal_options(all);
    add_life_options(all);
    return all;
  }();
  return table;
}

}  // namespace

std::vector<std::string> option_choices(std::string_view name) {
  std::vector<std::string> out;
  if (name == "contactSurface")
    for (const auto& [word, surface] : kSurfaces) out.emplace_back(word);
  if (name == "sol7Life")
    for (const auto& [suffix, suffix_code] : kLifeModifications)
      for (const auto& [model, model_code] : kLifeModels)
        out.push_back(std::string(model) + std::string(suffix));
  if (name == "contactDamping") return {"material"};  // or a number
  if (name == "hertzConstants") return {"moving", "frozen"};
  if (name == "rollerContact") return {"sliced", "point"};
  for (const char* on_or_off : {"resultsH5", "centrifugalGrowth", "userProcess"})
    if (name == on_or_off) return {"1", "0"};
  if (name == "filmStress") return {"surface", "direct"};
  if (name == "thermalBase") return {"deck", "none"};
  if (name == "thermalTransient") return {"off", "on"};
  if (name == "startAtRest") return {"on", "off"};
  if (name == "ballFriction") return {"balance", "spin-rule"};
  if (name == "rollerFriction") return {"balance", "none"};
  if (name == "thermalModel") return {"network", "ladder"};
  for (const char* open : {"ambientTemperature", "housingCooling", "shaftCooling", "coolantInlet"})
    if (name == open) return {"auto"};
  if (name == "filmPrecision") return {"single", "double"};
  if (name == "filmLaw") return {"code", "recommended"};
  if (name == "filmStressLimit") return {"on", "off"};
  if (name == "lifeElements") return {"gz", "all", "none"};
  if (name == "lifeElementTracks") return {"separate", "shared"};
  if (name == "lifeLimitForm") return {"peak", "integral"};
  for (const char* open :
       {"lifeLambda", "lifeFilter", "isoKappa", "isoContamination", "lubStressLimit"})
    if (name == open) return {"none"};
  return out;
}

std::vector<OptionInfo> run_option_list() {
  std::vector<OptionInfo> out;
  for (const Option& option : options()) out.push_back(option.info);
  return out;
}

RunOptions build_run_options(const std::map<std::string, std::string>& values) {
  RunOptions out;
  out.rollers.ball_balance = out.rollers.friction_balance = true;
  for (const auto& [name, value] : values) {
    const auto found = std::find_if(options().begin(), options().end(),
                                    [&](const Option& o) { return o.info.name == name; });
    if (found == options().end()) {
      std::string names;
      for (const Option& option : options())
        names += (names.empty() ? "" : ", ") + option.info.name;
      throw InputError(
          fmt::format("there is no run option named \"{}\"; the options are {}", name, names));
    }
    if (!found->set(out, value))
      throw InputError(
          fmt::format("run option {} = {} is not valid: {}", name, value, found->info.meaning));
  }
  return out;
}

}  // namespace adore::setup

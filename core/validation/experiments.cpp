#include "validation/experiments.hpp"

#include "assembly/duplex_pair.hpp"
#include "base/errors.hpp"
#include "base/resources.hpp"
#include "runs/prepare.hpp"
#include "tribology/contact_film.hpp"
#include "tribology/film_thickness.hpp"
#include "tribology/law_spread.hpp"
#include "validation/catalogue_torque.hpp"
#include "validation/motion_friction.hpp"
#include "validation/run_down.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace adore::validation {
namespace {

double mean_of_balls(const runs::Prepared& p, double (*of)(const statics::StaticBall&)) {
  double sum = 0.0;
  for (const statics::StaticBall& ball : p.statics.balls) sum += of(ball);
  return sum / static_cast<double>(std::max<std::size_t>(p.statics.balls.size(), 1));
}

const statics::FrictionEstimate& friction(const runs::Prepared& p) {
  if (!p.friction)
    throw InputError("the friction of the quasi-static solution is not computed for this deck");
  return *p.friction;
}

/// Torque of one cause [N m].
double torque_of(const runs::Prepared& p, double (*power)(const statics::FrictionEstimate&)) {
  const statics::FrictionEstimate& f = friction(p);
  return f.speed > 0.0 ? power(f) / f.speed : 0.0;
}

/// L10r for the rating that the source used: Q_ci and Q_ce are proportional to C, the life to C³.
double reference_life(const runs::Prepared& p, double rating) {
  if (!p.life.iso || !p.life.iso->reference)
    throw InputError("the life by ISO 16281 is not computed for this deck");
  const double ratio = rating > 0.0 ? rating / p.life.iso->C : 1.0;
  return p.life.iso->reference->L10r * ratio * ratio * ratio;
}

double relative_speed(const runs::Prepared& p) {
  const double out = std::abs(p.bearing.speed[1] - p.bearing.speed[0]);
  if (!(out > 0.0)) throw InputError("the races do not rotate relative to each other");
  return out;
}

/// Mean orbital speed of the elements over that of the shaft, outer race at rest, without slip.
double orbit_ratio(const runs::Prepared& p) {
  const double orbit =
      p.rollers ? p.rollers->orbital_speed
                : mean_of_balls(p, [](const statics::StaticBall& b) { return b.orbital_speed; });
  return std::abs(orbit) / relative_speed(p);
}

const life::IsoReport& iso(const runs::Prepared& p) {
  if (!p.life.iso) throw InputError("ISO 281 and ISO 76 do not cover this bearing");
  return *p.life.iso;
}

/// T_in + Q/(ρ c W) [K].
double outlet_temperature(const runs::Prepared& p, double heat) {
  if (!p.thermal || !p.thermal->heat.coolant) throw InputError("the deck has no coolant flow");
  const thermal::Coolant& coolant = *p.thermal->heat.coolant;
  return p.bearing.thermal->base_temperature + heat / (coolant.mass_flow * coolant.specific_heat);
}

struct Quantity {
  std::string_view name, label;
  double (*of)(const runs::Prepared&);  ///< SI
};

constexpr Quantity kQuantities[] = {
    {"outer_contact_angle", "outer contact angle",
     [](const runs::Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.alpha[0]; });
     }},
    {"inner_contact_angle", "inner contact angle",
     [](const runs::Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.alpha[1]; });
     }},
    {"outer_load", "outer contact load",
     [](const runs::Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.Q[0]; });
     }},
    {"inner_load", "inner contact load",
     [](const runs::Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.Q[1]; });
     }},
    {"centrifugal_force", "centrifugal force of a ball",
     [](const runs::Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.centrifugal_force; });
     }},
    {"outer_pressure", "largest outer pressure",
     [](const runs::Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.p_max[0]; });
     }},
    {"inner_pressure", "largest inner pressure",
     [](const runs::Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.p_max[1]; });
     }},
    {"displacement_axial", "axial displacement",
     [](const runs::Prepared& p) { return std::abs(p.race_result().displacement[0]); }},
    {"displacement_radial", "radial displacement",
     [](const runs::Prepared& p) { return std::abs(p.race_result().displacement[2]); }},
    {"power_loss", "power loss", [](const runs::Prepared& p) { return friction(p).power(); }},
    {"friction_torque", "friction torque",
     [](const runs::Prepared& p) { return friction(p).torque(); }},
    {"rolling_torque", "torque: rolling",
     [](const runs::Prepared& p) {
       return torque_of(p, [](const statics::FrictionEstimate& f) {
         return f.of_race(0).rolling + f.of_race(1).rolling;
       });
     }},
    {"sliding_torque", "torque: sliding and spin",
     [](const runs::Prepared& p) {
       return torque_of(p, [](const statics::FrictionEstimate& f) {
         const statics::FrictionOfContact outer = f.of_race(0), inner = f.of_race(1);
         return outer.sliding + outer.spin + inner.sliding + inner.spin;
       });
     }},
    {"rib_torque", "torque: rib",
     [](const runs::Prepared& p) {
       return torque_of(
           p, [](const statics::FrictionEstimate& f) { return f.flange[0] + f.flange[1]; });
     }},
    {"cage_torque", "torque: drag of the cage",
     [](const runs::Prepared& p) {
       return torque_of(p, [](const statics::FrictionEstimate& f) { return f.cage_drag; });
     }},
    {"drag_torque", "torque: drag of elements",
     [](const runs::Prepared& p) {
       return torque_of(p, [](const statics::FrictionEstimate& f) { return f.element_drag; });
     }},
    {"outlet_temperature", "oil outlet temperature",
     [](const runs::Prepared& p) { return outlet_temperature(p, friction(p).power()); }},
    {"rolling_power", "power loss: rolling",
     [](const runs::Prepared& p) {
       return friction(p).of_race(0).rolling + friction(p).of_race(1).rolling;
     }},
    {"drag_power", "power loss: drag of the medium",
     [](const runs::Prepared& p) { return friction(p).drag(); }},
    {"orbit_ratio", "cage speed / shaft speed", orbit_ratio},
    {"cage_excess", "cage speed / epicyclic speed - 1",
     [](const runs::Prepared& p) {
       const bearing::BallGeometry& balls = p.bearing.balls();
       return orbit_ratio(p) / (0.5 * (1.0 - balls.diameter / balls.pitch_diameter)) - 1.0;
     }},
    {"outer_pass", "BPFO / shaft",
     [](const runs::Prepared& p) {
       return static_cast<double>(p.bearing.element_count()) * orbit_ratio(p);
     }},
    {"inner_pass", "BPFI / shaft",
     [](const runs::Prepared& p) {
       return static_cast<double>(p.bearing.element_count()) * (1.0 - orbit_ratio(p));
     }},
    {"pass_sum", "(BPFO + BPFI) / shaft",
     [](const runs::Prepared& p) {
       const double z = static_cast<double>(p.bearing.element_count());
       return z * orbit_ratio(p) + z * (1.0 - orbit_ratio(p));
     }},
    {"dynamic_rating", "dynamic rating C", [](const runs::Prepared& p) { return iso(p).C; }},
    {"static_rating", "static rating C0",
     [](const runs::Prepared& p) {
       if (!iso(p).C0) throw InputError("ISO 76 gives no static load rating for this bearing");
       return *iso(p).C0;
     }},
    {"iso_life", "L10 of ISO 281",
     [](const runs::Prepared& p) {
       if (!iso(p).L10) throw InputError("ISO 281 gives no life for this bearing");
       const double turns = 1e6 * *iso(p).L10;
       return turns * 2.0 * std::numbers::pi / relative_speed(p);
     }},
    {"largest_pressure", "largest contact pressure",
     [](const runs::Prepared& p) {
       double out = 0.0;
       for (const statics::StaticBall& ball : p.statics.balls)
         for (const double pressure : ball.p_max)
           if (std::isfinite(pressure)) out = std::max(out, pressure);
       return out;
     }},
    {"rib_load", "load of a roller end on the rib",
     [](const runs::Prepared& p) {
       if (!p.rollers) throw InputError("only rollers have ribs");
       double sum = 0.0;
       for (const statics::StaticRoller& roller : p.rollers->rollers)
         for (const auto& race : roller.flange)
           for (const statics::RollerFlangeContact& flange : race) sum += flange.load;
       return sum / static_cast<double>(p.rollers->rollers.size());
     }},
    {"pair_axial_stiffness", "axial stiffness of the pair",
     [](const runs::Prepared& p) {
       return assembly::duplex_pair(p, p.race_result().load[0]).axial;
     }},
    {"pair_radial_stiffness", "radial stiffness of the pair",
     [](const runs::Prepared& p) {
       return assembly::duplex_pair(p, p.race_result().load[0]).radial;
     }},
};

constexpr std::string_view kLife = "reference_life";

struct RunDownQuantity {
  std::string_view name, label;
  double (*of)(const RunDown&);  ///< SI
};
constexpr RunDownQuantity kRunDown[] = {
    {"run_down_exponent", "exponent n of -dw/dt = K w^n",
     [](const RunDown& r) { return r.exponent; }},
    {"run_down_time", "run-down time", [](const RunDown& r) { return r.time; }},
    {"run_down_rolling", "run-down heat: rolling", [](const RunDown& r) { return r.rolling; }},
    {"run_down_residual", "energy residual", [](const RunDown& r) { return r.energy_residual; }},
};
const RunDownQuantity* run_down_quantity(std::string_view name) {
  for (const RunDownQuantity& one : kRunDown)
    if (one.name == name) return &one;
  return nullptr;
}

struct MotionQuantity {
  std::string_view name, label;
  double (*of)(const MotionRunResults&, const runs::Prepared& equilibrium);  ///< SI
};
/// Over that of elements that roll without slip at a contact angle of 0, less 1.
double excess(double cage_ratio, const runs::Prepared& p) {
  const bearing::BallGeometry& balls = p.bearing.balls();
  return cage_ratio / (0.5 * (1.0 - balls.diameter / balls.pitch_diameter)) - 1.0;
}

constexpr MotionQuantity kMotion[] = {
    {"motion_torque", "friction torque in motion",
     [](const MotionRunResults& f, const runs::Prepared&) { return f.friction.total(); }},
    {"motion_rolling", "motion torque: rolling",
     [](const MotionRunResults& f, const runs::Prepared&) { return f.friction.rolling; }},
    {"motion_races", "motion torque: sliding at races",
     [](const MotionRunResults& f, const runs::Prepared&) { return f.friction.races; }},
    {"motion_rib", "motion torque: rib",
     [](const MotionRunResults& f, const runs::Prepared&) { return f.friction.ribs; }},
    {"motion_cage", "motion torque: cage",
     [](const MotionRunResults& f, const runs::Prepared&) { return f.friction.cage; }},
    {"motion_residual", "energy residual",
     [](const MotionRunResults& f, const runs::Prepared&) { return f.friction.energy_residual; }},
    {"motion_cage_excess", "cage speed / epicyclic speed - 1",
     [](const MotionRunResults& f, const runs::Prepared& p) { return excess(f.cage_ratio, p); }},
    {"motion_outer_pass", "BPFO / shaft",
     [](const MotionRunResults& f, const runs::Prepared& p) {
       return static_cast<double>(p.bearing.element_count()) * f.cage_ratio;
     }},
    {"motion_inner_pass", "BPFI / shaft",
     [](const MotionRunResults& f, const runs::Prepared& p) {
       return static_cast<double>(p.bearing.element_count()) * (1.0 - f.cage_ratio);
     }},
    {"motion_cage_slip", "cage slip from the equilibrium",
     [](const MotionRunResults& f, const runs::Prepared& p) {
       return 1.0 - f.cage_ratio / orbit_ratio(p);
     }},
    {"motion_axial_line", "axial force at Z f_cage",
     [](const MotionRunResults& f, const runs::Prepared&) { return f.axial_line; }},
    {"motion_radial_line", "radial force at Z f_cage",
     [](const MotionRunResults& f, const runs::Prepared&) { return f.radial_line; }},
    {"motion_line_contrast", "log10(axial / radial force at Z f_cage)",
     [](const MotionRunResults& f, const runs::Prepared&) {
       return std::log10(f.axial_line / f.radial_line);
     }},
};
const MotionQuantity* motion_quantity(std::string_view name) {
  for (const MotionQuantity& one : kMotion)
    if (one.name == name) return &one;
  return nullptr;
}

struct Unit {
  std::string_view name;
  double per_si;
  double shift = 0.0;  ///< added after scaling
};
constexpr double kPoundForce = 4.4482216152605, kInch = 0.0254;
constexpr Unit kUnits[] = {{"deg", 180.0 / std::numbers::pi},
                           {"N", 1.0},
                           {"kN", 1e-3},
                           {"lbf", 1.0 / kPoundForce},
                           {"psi", kInch* kInch / kPoundForce},
                           {"GPa", 1e-9},
                           {"um", 1e6},
                           {"mm", 1e3},
                           {"N/um", 1e-6},
                           {"W", 1.0},
                           {"N.m", 1.0},
                           {"N.mm", 1e3},
                           {"Mrev", 1.0},
                           {"h", 1.0 / 3600.0},
                           {"s", 1.0},
                           {"K", 1.0},
                           {"C", 1.0, -273.15},
                           {"%", 100.0},
                           {"-", 1.0}};

double in_unit(double si, std::string_view unit) {
  for (const Unit& one : kUnits)
    if (one.name == unit) return si * one.per_si + one.shift;
  throw InputError(fmt::format("experiments.json: unit \"{}\" is unknown", unit));
}

runs::DeckRequest request_of(const std::string& deck, const DeckSets& sets) {
  // "decks/angular-218": an example; else a deck of the experiments.
  const std::string name =
      deck.find('/') != std::string::npos ? deck + ".txt" : "experiments/" + deck + ".txt";
  runs::DeckRequest out;
  for (const resources::Resource& one : resources::all())
    if (one.name == name) out.text = std::string(one.data);
  if (!out.text) throw InputError(fmt::format("experiments.json: there is no deck {}", name));
  out.in_memory = true;
  out.deck = deck + ".txt";
  out.sets = sets;
  return out;
}

/// Sets of a run and more of the same names, which win.
DeckSets with(DeckSets sets, const DeckSets& more) {
  for (const auto& [name, value] : more) {
    const auto same = std::find_if(sets.begin(), sets.end(),
                                   [&name = name](const auto& one) { return one.first == name; });
    if (same == sets.end())
      sets.emplace_back(name, value);
    else
      same->second = value;
  }
  return sets;
}

/// Largest friction coefficient between two cylindrical discs over pressure and slip, by the law of
/// one kTrac. SI: b = 4 R p0/E', load per length π b p0/2.
double largest_coefficient(const TwinDiscData& discs) {
  const double E = 2.26e11;
  constexpr std::array kSlipRatio{0.003, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3};
  std::vector<double> slips;
  for (const double ratio : kSlipRatio) slips.push_back(ratio * discs.speed);
  double out = 0.0;
  for (const double pressure : discs.pressure) {
    tribology::LawSpreadContact contact;
    contact.line = true;
    contact.modulus = E;
    contact.temperature = discs.temperature;
    contact.meniscus = 10.0;
    contact.point.peak_pressure = pressure;
    contact.point.half_minor = 4.0 * discs.radius * pressure / E;
    contact.point.load = 0.5 * std::numbers::pi * contact.point.half_minor * pressure;
    contact.point.entrainment = discs.speed;
    contact.point.curvature = 1.0 / discs.radius;
    for (const tribology::LawSpreadRow& row : tribology::law_spread(discs.law, contact, slips))
      if (row.code == discs.law)
        out = std::max(out, *std::max_element(row.kappa.begin(), row.kappa.end()));
  }
  return out;
}

/// Minimum film of the shipped film law over the isothermal formula of Hamrock and Dowson.
double film_over_hamrock(const FilmData& data) {
  constexpr double kModulus = 2.26e11;
  const tribology::FilmInlet inlet{data.viscosity, data.alpha, data.speed, kModulus};
  tribology::InletOil oil;
  oil.viscosity = data.viscosity;
  oil.alpha = data.alpha;
  oil.beta = 0.03;
  oil.conductivity = 0.14;
  oil.meniscus = 1000.0;
  tribology::LubricatedContact contact;
  contact.load = data.load;
  contact.radius = data.radius;
  contact.k = data.k;
  contact.half_width = 1e-4;
  contact.peak_pressure = 1e9;
  contact.speed = data.speed;
  contact.modulus = kModulus;
  return tribology::contact_film(oil, contact).minimum /
         tribology::point_film(inlet, data.radius, data.load, data.k).minimum;
}

/// Results of one run, each computed once and only when a row needs it.
class RunFigures {
 public:
  explicit RunFigures(const RunData& run) : run_(run), sets_(run.set) {
    if (run.oil_share) add_oil_share();
  }

  /// SI.
  double of(const RowData& row) {
    const std::string& name = row.of;
    if (name == "largest_coefficient") return largest_coefficient(demand_part(run_.discs, "discs"));
    if (name == "film_over_hamrock") return film_over_hamrock(demand_part(run_.film, "film"));
    if (const RunDownQuantity* in_time = run_down_quantity(name)) return in_time->of(down());
    if (const MotionQuantity* moving = motion_quantity(name))
      return moving->of(motion(), *equilibrium_of_motion_);
    if (name == "exponent") return exponent(row);
    if (name == "spread") return spread(row);
    if (name == "torque_less_rib") {
      runs::DeckRequest rib = request_of(run_.deck, with(sets_, run_.subtract));
      rib.options = run_.options;
      return value("friction_torque", prepared()) - value("rib_torque", runs::prepare(rib));
    }
    if (name == "fitting_rolling") return fitting_rolling(row);
    if (name == "pair_offset")
      return assembly::duplex_pair(prepared(), thrust()).offset -
             assembly::duplex_pair(prepared(), demand_part(row.from, "from")).offset;
    if (name == "unloading_force")
      return demand_part(assembly::duplex_unloading_force(prepared(), thrust()), "unloading force");
    if (name == kLife) return reference_life(prepared(), row.rating);
    return value(name, prepared());
  }

  [[nodiscard]] const std::optional<runs::Prepared>& solved() const noexcept { return prepared_; }

  static double value(std::string_view name, const runs::Prepared& prepared) {
    for (const Quantity& one : kQuantities)
      if (one.name == name) return one.of(prepared);
    throw InputError(fmt::format("experiments.json: quantity \"{}\" is unknown", name));
  }

 private:
  template <class T>
  static const T& demand_part(const std::optional<T>& part, const char* name) {
    if (!part) throw InputError(fmt::format("experiments.json: the row needs \"{}\"", name));
    return *part;
  }

  const runs::Prepared& prepared() {
    if (!prepared_) {
      runs::DeckRequest request = request_of(run_.deck, sets_);
      request.options = run_.options;
      prepared_ = runs::prepare(request);
    }
    return *prepared_;
  }
  double thrust() { return prepared().race_result().load[0]; }

  void add_oil_share() {
    const deck::Deck deck = runs::load_deck(request_of(run_.deck, sets_)).deck;
    const double flow = deck.si("cFlowRate") * 6e7;  // cm³/min
    const double dm = deck.si("pitchDia") * 1e3, n = deck.si("rpm2") * 30.0 / std::numbers::pi;
    const double p = run_.oil_share->p;
    const double share = run_.oil_share->c * std::pow(flow, 0.37) * std::pow(dm, -0.7) *
                         std::pow(n * dm, -p) * std::pow(1.3e6, p - 1.0);
    sets_.emplace_back("denRatio", fmt::format("{:.6e}", share));
  }

  /// A quantity of equilibria over the values of a variable.
  std::vector<double> over(const std::string& quantity, const std::vector<double>& values) {
    std::vector<double> out;
    const std::string& variable = demand_part(run_.over, "over").variable;
    for (const double one : values)
      out.push_back(
          value(quantity, runs::prepare(request_of(
                              run_.deck, with(sets_, {{variable, fmt::format("{:.10e}", one)}})))));
    return out;
  }

  /// n of y ~ xⁿ by least squares in logarithms.
  double exponent(const RowData& row) {
    const std::vector<double>& x = demand_part(run_.over, "over").values;
    std::vector<double> y = over(row.quantity, x);
    if (row.reference) {
      const double base = over(row.quantity, {*row.reference}).front();
      for (double& one : y) one -= base;
    }
    return fit_power_exponent(x, y);
  }
  double spread(const RowData& row) {
    const std::vector<double> y = over(row.quantity, demand_part(run_.over, "over").values);
    const auto [least, most] = std::minmax_element(y.begin(), y.end());
    return (*most - *least) / std::abs(0.5 * (*most + *least));
  }

  /// Share of the flooded rolling resistance with which the heat would be the measured one.
  double fitting_rolling(const RowData& row) {
    const double rolling = value("rolling_power", prepared());
    return 1.0 - (friction(prepared()).power() - demand_part(row.reference, "reference")) / rolling;
  }

  const RunDown& down() {
    if (down_) return *down_;
    const RunDownData& data = demand_part(run_.run_down, "run_down");
    std::vector<TorqueAtSpeed> at;
    for (const double rpm : demand_part(run_.over, "over").values) {
      const runs::Prepared still = runs::prepare(
          request_of(run_.deck, with(sets_, {{"rpm2", fmt::format("{:.10e}", rpm)}})));
      at.push_back({rpm * std::numbers::pi / 30.0, friction(still).torque()});
    }
    down_ = run_down(request_of(data.deck, with(sets_, data.set)), at, data.inertia);
    return *down_;
  }

  const MotionRunResults& motion() {
    if (motion_) return *motion_;
    const MotionData& data = demand_part(run_.motion, "motion");
    const runs::DeckRequest moving =
        request_of(data.deck.empty() ? run_.deck : data.deck, with(sets_, data.set));
    equilibrium_of_motion_ = runs::prepare(moving);
    motion_ = evaluate_motion_run(moving, data.until);
    return *motion_;
  }

  const RunData& run_;
  DeckSets sets_;
  std::optional<runs::Prepared> prepared_, equilibrium_of_motion_;
  std::optional<RunDown> down_;
  std::optional<MotionRunResults> motion_;
};

std::string label_of(const RowData& row) {
  static const std::map<std::string_view, std::string_view> kLabels{
      {"largest_coefficient", "largest friction coefficient"},
      {"film_over_hamrock", "minimum film / Hamrock-Dowson film"},
      {"exponent", "exponent"},
      {"spread", "spread"},
      {"torque_less_rib", "torque minus the computed rib"},
      {"fitting_rolling", "fitted share of flooded rolling"},
      {"pair_offset", "offset of the spacers"},
      {"unloading_force", "unloading force"},
      {kLife, "L10r of ISO 16281"}};
  if (!row.what.empty()) return row.what;
  if (const auto found = kLabels.find(row.of); found != kLabels.end())
    return std::string(found->second);
  if (const RunDownQuantity* in_time = run_down_quantity(row.of))
    return std::string(in_time->label);
  if (const MotionQuantity* moving = motion_quantity(row.of)) return std::string(moving->label);
  for (const Quantity& one : kQuantities)
    if (one.name == row.of) return std::string(one.label);
  throw InputError(fmt::format("experiments.json: quantity \"{}\" is unknown", row.of));
}

/// T_out of the run with the source's heat, or ours where it is not printed.
void check_energy(const RunData& run, const RunFigures& figures, Experiment& out) {
  if (!figures.solved() || !figures.solved()->thermal || !figures.solved()->thermal->heat.coolant)
    return;
  const runs::Prepared& prepared = *figures.solved();
  double heat = friction(prepared).power();
  bool theirs = false;
  for (const RowData& row : run.rows)
    if (row.of == "power_loss" && row.theirs) {
      heat = *row.theirs;
      theirs = true;
    }
  ExperimentRow line;
  line.condition = run.condition;
  line.what = fmt::format("oil outlet temperature, {} heat", theirs ? "published" : "computed");
  line.unit = "C";
  line.kind = "part";
  const double outlet = outlet_temperature(prepared, heat);
  line.ours = in_unit(outlet, "C");
  std::optional<double> ring;
  if (run.hottest_ring) ring = run.hottest_ring->temperature;
  const std::string verdict = energy_verdict(outlet, ring);
  line.certainty =
      ring ? fmt::format("derived; hottest ring {:.4g} C, {}{}{}", *ring - 273.15,
                         run.hottest_ring->certainty, verdict.empty() ? "" : ": ", verdict)
           : "derived; plausibility not checked, because the source gives no ring temperature";
  if (!verdict.empty())
    out.inputs.push_back(fmt::format(
        "{}: {}: the oil outlet temperature would be {:.4g} C, but the hottest ring has {:.4g} C",
        run.condition, verdict, outlet - 273.15, *ring - 273.15));
  out.rows.push_back(std::move(line));
}

void add_run(const RunData& run, Experiment& out) {
  const auto name_deck = [&out](const std::string& name) {
    if (!name.empty() && std::find(out.decks.begin(), out.decks.end(), name) == out.decks.end())
      out.decks.push_back(name);
  };
  name_deck(run.deck);
  if (run.motion) name_deck(run.motion->deck);
  if (run.run_down) name_deck(run.run_down->deck);
  RunFigures figures(run);
  for (const RowData& row : run.rows) {
    ExperimentRow line;
    line.condition = run.condition;
    line.what = label_of(row);
    line.unit = row.unit;
    line.kind = row.kind;
    line.type = row.type;
    line.certainty = row.certainty;
    line.theirs = row.theirs;
    line.theirs_to = row.theirs_to;
    line.their_sign = row.their_sign;
    try {
      line.ours = in_unit(figures.of(row), row.unit);
      if (!std::isfinite(*line.ours)) {
        line.ours.reset();
        line.failed = "the result is not a finite number";
      }
    } catch (const InputError& error) {
      line.failed = error.what();
    } catch (const SolverError& error) {
      line.failed = error.what();
    }
    out.rows.push_back(std::move(line));
  }
  check_energy(run, figures, out);
}

/// Points of the catalogue formula as rows.
void add_catalogue(const std::string& file, Experiment& out) {
  const std::string name = "experiments/" + file;
  int speed = 0, load = 0;
  for (const TorqueTable& table : compute_torque_tables(resources::get(name))) {
    speed += table.above_speed;
    load += table.below_load;
    for (const TorqueLine& one : table.lines) {
      ExperimentRow line;
      line.condition = fmt::format("{}, {}, C/{:g}, {:g} rpm", table.bearing, table.oil,
                                   one.load_ratio, one.rpm);
      line.what = "friction torque";
      line.unit = "N.mm";
      line.kind = "prediction";
      line.certainty = "model: equations from publications, constants not verified";
      line.model = true;
      constexpr double kMilli = 1e3;
      line.failed = one.failed;
      if (one.failed.empty()) line.ours = kMilli * one.total();
      line.theirs = kMilli * one.catalogue();
      out.rows.push_back(std::move(line));
    }
  }
  out.assumed.push_back(fmt::format(
      "omitted operating points: {} above the limiting speed, {} below the minimum load", speed,
      load));
}

}  // namespace

std::optional<double> ExperimentRow::deviation() const {
  if (!ours || !theirs || type != RowType::Value) return std::nullopt;
  double nearest = *theirs;
  if (theirs_to) {
    if (*ours >= *theirs && *ours <= *theirs_to) return 0.0;
    nearest = *ours < *theirs ? *theirs : *theirs_to;
  }
  return *ours / nearest - 1.0;
}

std::optional<bool> ExperimentRow::agrees() const {
  if (!ours || type == RowType::Value) return std::nullopt;
  if (type == RowType::Bound) return theirs ? std::optional(*ours <= *theirs) : std::nullopt;
  const std::string_view sign = std::abs(*ours) < kFlatSign ? "0" : *ours > 0.0 ? "+" : "-";
  return sign == their_sign;
}

std::string energy_verdict(double outlet, const std::optional<double>& ring) {
  if (!ring || outlet <= *ring) return {};
  return outlet > *ring + kImpossible ? "inputs impossible" : "inputs doubtful";
}

Experiment run_experiment(const ExperimentData& data) {
  Experiment out;
  out.id = data.id;
  out.source = data.source;
  out.about = data.about;
  out.open = data.open;
  out.assumed = data.assumed;
  out.parameters = data.parameters;
  for (const RunData& run : data.runs) add_run(run, out);
  if (!data.table.empty()) add_catalogue(data.table, out);
  for (const NotComputed& one : data.not_computed) {
    ExperimentRow line;
    line.condition = one.condition;
    line.what = one.what;
    line.unit = one.unit;
    line.kind = "prediction";
    line.certainty = one.certainty;
    line.their_text = one.theirs;
    line.failed = "not computed: " + one.reason;
    out.rows.push_back(std::move(line));
  }
  return out;
}

std::vector<ExperimentData> embedded_experiments() {
  return read_experiments(resources::get("experiments/experiments.json"), "experiments.json");
}

std::vector<Experiment> run_experiments(std::string_view only,
                                        const std::function<void(const std::string&)>& progress) {
  std::vector<Experiment> out;
  std::string ids;
  for (const ExperimentData& data : embedded_experiments()) {
    ids += (ids.empty() ? "" : ", ") + data.id;
    if (!only.empty() && only != data.id) continue;
    if (progress) progress(data.id);
    out.push_back(run_experiment(data));
  }
  if (out.empty())
    throw InputError(fmt::format("there is no experiment \"{}\"; choose one of {}", only, ids));
  return out;
}

}  // namespace adore::validation

#include "facade/experiments.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "base/resources.hpp"
#include "facade/motion_friction.hpp"
#include "facade/prepare.hpp"
#include "facade/run_down.hpp"
#include "tribology/law_spread.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace adore::facade {
namespace {

using Json = nlohmann::json;

double mean_of_balls(const Prepared& p, double (*of)(const statics::StaticBall&)) {
  double sum = 0.0;
  for (const statics::StaticBall& ball : p.statics.balls) sum += of(ball);
  return sum / static_cast<double>(std::max<std::size_t>(p.statics.balls.size(), 1));
}

const statics::FrictionEstimate& friction(const Prepared& p) {
  if (!p.friction) throw InputError("the deck has no friction of an equilibrium");
  return *p.friction;
}

/// Torque of one cause [N m].
double torque_of(const Prepared& p, double (*power)(const statics::FrictionEstimate&)) {
  const statics::FrictionEstimate& f = friction(p);
  return f.speed > 0.0 ? power(f) / f.speed : 0.0;
}

/// L10r for the rating that the source used: Q_ci and Q_ce are proportional to C, the life to C³.
double reference_life(const Prepared& p, double rating) {
  if (!p.life.iso || !p.life.iso->reference) throw InputError("there is no life by ISO 16281");
  const double ratio = rating > 0.0 ? rating / p.life.iso->C : 1.0;
  return p.life.iso->reference->L10r * ratio * ratio * ratio;
}

struct Quantity {
  std::string_view name, label;
  double (*of)(const Prepared&);  ///< SI
};

constexpr Quantity kQuantities[] = {
    {"outer_contact_angle", "outer contact angle",
     [](const Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.alpha[0]; });
     }},
    {"inner_contact_angle", "inner contact angle",
     [](const Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.alpha[1]; });
     }},
    {"outer_load", "outer contact load",
     [](const Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.Q[0]; });
     }},
    {"inner_load", "inner contact load",
     [](const Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.Q[1]; });
     }},
    {"centrifugal_force", "centrifugal force of a ball",
     [](const Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.centrifugal_force; });
     }},
    {"outer_pressure", "largest outer pressure",
     [](const Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.p_max[0]; });
     }},
    {"inner_pressure", "largest inner pressure",
     [](const Prepared& p) {
       return mean_of_balls(p, [](const statics::StaticBall& b) { return b.p_max[1]; });
     }},
    {"displacement_axial", "axial displacement",
     [](const Prepared& p) { return std::abs(p.race_result().displacement[0]); }},
    {"displacement_radial", "radial displacement",
     [](const Prepared& p) { return std::abs(p.race_result().displacement[2]); }},
    {"power_loss", "power loss", [](const Prepared& p) { return friction(p).power(); }},
    {"friction_torque", "friction torque", [](const Prepared& p) { return friction(p).torque(); }},
    {"rolling_torque", "of it rolling",
     [](const Prepared& p) {
       return torque_of(p, [](const statics::FrictionEstimate& f) {
         return f.of_race(0).rolling + f.of_race(1).rolling;
       });
     }},
    {"sliding_torque", "of it sliding and spin",
     [](const Prepared& p) {
       return torque_of(p, [](const statics::FrictionEstimate& f) {
         const statics::FrictionOfContact outer = f.of_race(0), inner = f.of_race(1);
         return outer.sliding + outer.spin + inner.sliding + inner.spin;
       });
     }},
    {"rib_torque", "of it the rib",
     [](const Prepared& p) {
       return torque_of(
           p, [](const statics::FrictionEstimate& f) { return f.flange[0] + f.flange[1]; });
     }},
    {"cage_torque", "of it drag of the cage",
     [](const Prepared& p) {
       return torque_of(p, [](const statics::FrictionEstimate& f) { return f.cage_drag; });
     }},
    {"drag_torque", "of it drag of elements",
     [](const Prepared& p) {
       return torque_of(p, [](const statics::FrictionEstimate& f) { return f.element_drag; });
     }},
};

constexpr std::string_view kExponent = "torque_exponent", kLife = "reference_life";

struct RunDownQuantity {
  std::string_view name, label;
  double (*of)(const RunDown&);  ///< SI
};
constexpr RunDownQuantity kRunDown[] = {
    {"run_down_exponent", "exponent n of -dw/dt = K w^n",
     [](const RunDown& r) { return r.exponent; }},
    {"run_down_time", "run-down time", [](const RunDown& r) { return r.time; }},
    {"run_down_rolling", "of its heat by rolling resistance",
     [](const RunDown& r) { return r.rolling; }},
    {"run_down_residual", "energy without account",
     [](const RunDown& r) { return r.energy_residual; }},
};
const RunDownQuantity* run_down_quantity(std::string_view name) {
  for (const RunDownQuantity& one : kRunDown)
    if (one.name == name) return &one;
  return nullptr;
}

struct MotionQuantity {
  std::string_view name, label;
  double (*of)(const MotionFriction&);  ///< SI
};
constexpr MotionQuantity kMotion[] = {
    {"motion_torque", "friction torque in motion",
     [](const MotionFriction& f) { return f.total(); }},
    {"motion_rolling", "of it rolling", [](const MotionFriction& f) { return f.rolling; }},
    {"motion_races", "of it sliding at the races", [](const MotionFriction& f) { return f.races; }},
    {"motion_rib", "of it the rib", [](const MotionFriction& f) { return f.ribs; }},
    {"motion_cage", "of it the cage", [](const MotionFriction& f) { return f.cage; }},
    {"motion_residual", "energy without account",
     [](const MotionFriction& f) { return f.energy_residual; }},
};
const MotionQuantity* motion_quantity(std::string_view name) {
  for (const MotionQuantity& one : kMotion)
    if (one.name == name) return &one;
  return nullptr;
}

struct Unit {
  std::string_view name;
  double per_si;
};
constexpr double kPoundForce = 4.4482216152605, kInch = 0.0254;
constexpr Unit kUnits[] = {{"deg", 180.0 / std::numbers::pi},
                           {"N", 1.0},
                           {"lbf", 1.0 / kPoundForce},
                           {"psi", kInch* kInch / kPoundForce},
                           {"um", 1e6},
                           {"W", 1.0},
                           {"N.m", 1.0},
                           {"N.mm", 1e3},
                           {"Mrev", 1.0},
                           {"s", 1.0},
                           {"-", 1.0}};

double per_si(std::string_view unit) {
  for (const Unit& one : kUnits)
    if (one.name == unit) return one.per_si;
  throw InternalError(fmt::format("experiments.json: no unit \"{}\"", unit));
}

/// "1000.0" for a deck: a real needs its point.
std::string deck_number(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return dump_json(value);
}

DeckRequest request_of(const std::string& deck, const Json& sets) {
  DeckRequest out;
  out.text = std::string(resources::get(fmt::format("experiments/{}.txt", deck)));
  for (const auto& [name, value] : sets.items()) out.sets.emplace_back(name, deck_number(value));
  return out;
}

constexpr double kRpm = std::numbers::pi / 30.0;

/// Friction of the equilibria of a deck at several speeds of its inner race [rpm].
std::vector<TorqueAtSpeed> torques_of(const std::string& deck, Json sets, const Json& speeds) {
  std::vector<TorqueAtSpeed> out;
  for (const Json& speed : speeds) {
    sets["rpm2"] = speed;
    const Prepared prepared = prepare(request_of(deck, sets));
    const statics::FrictionEstimate& f = friction(prepared);
    out.push_back({speed.get<double>() * kRpm, f.torque()});
  }
  return out;
}

/// n of T = K ωⁿ by least squares in logarithms.
double torque_exponent(const std::string& deck, const Json& sets, const Json& speeds) {
  std::vector<double> speed, torque;
  for (const TorqueAtSpeed& at : torques_of(deck, sets, speeds)) {
    speed.push_back(at.speed);
    torque.push_back(at.total);
  }
  return power_of(speed, torque);
}

/// In time: the deck "run_down" with the inertia and the sets beside it, and the friction of
/// equilibria of the run's own deck.
RunDown run_down_of(const std::string& deck, const Json& sets, const Json& run) {
  const Json& motion = run.at("run_down");
  DeckRequest moving = request_of(motion.at("deck"), sets);
  moving.in_memory = true;
  moving.deck = motion.at("deck").get<std::string>() + ".txt";
  const Json more = motion.value("set", Json::object());
  for (const auto& [name, value] : more.items()) moving.sets.emplace_back(name, deck_number(value));
  return run_down(moving, torques_of(deck, sets, run.at("speeds")),
                  motion.at("inertia").get<double>());
}

/// In time: the deck "motion" with the sets of the run and its own.
MotionFriction motion_of(const Json& sets, const Json& motion) {
  DeckRequest moving = request_of(motion.at("deck"), sets);
  moving.in_memory = true;
  moving.deck = motion.at("deck").get<std::string>() + ".txt";
  return motion_friction(moving, motion.at("until"));
}

constexpr std::string_view kLargestCoefficient = "largest_coefficient";

/// Largest friction coefficient between two cylindrical discs over pressure and slip, by the law of
/// one kTrac. SI: b = 4 R p0/E', load per length π b p0/2.
double largest_coefficient(const Json& discs) {
  const int code = discs.at("kTrac");
  const double R = discs.at("radius"), E = 2.26e11, speed = discs.at("speed");
  constexpr std::array kSlipRatio{0.003, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3};
  std::vector<double> slips;
  for (const double ratio : kSlipRatio) slips.push_back(ratio * speed);
  double out = 0.0;
  for (const double pressure : discs.at("pressure").get<std::vector<double>>()) {
    tribology::SpreadContact contact;
    contact.line = true;
    contact.modulus = E;
    contact.temperature = discs.at("T");
    contact.meniscus = 10.0;
    contact.point.peak_pressure = pressure;
    contact.point.half_minor = 4.0 * R * pressure / E;
    contact.point.load = 0.5 * std::numbers::pi * contact.point.half_minor * pressure;
    contact.point.entrainment = speed;
    contact.point.curvature = 1.0 / R;
    for (const tribology::SpreadRow& row : tribology::law_spread(code, contact, slips))
      if (row.code == code)
        out = std::max(out, *std::max_element(row.kappa.begin(), row.kappa.end()));
  }
  return out;
}

std::string label_of(std::string_view name) {
  if (name == kLargestCoefficient) return "largest friction coefficient";
  if (name == kExponent) return "exponent n of T = K w^n";
  if (name == kLife) return "L10r of ISO 16281";
  if (const RunDownQuantity* in_time = run_down_quantity(name)) return std::string(in_time->label);
  if (const MotionQuantity* in_motion = motion_quantity(name)) return std::string(in_motion->label);
  for (const Quantity& one : kQuantities)
    if (one.name == name) return std::string(one.label);
  throw InternalError(fmt::format("experiments.json: no quantity \"{}\"", name));
}

double value_of(const std::string& name, const Prepared& prepared, const Json& row) {
  if (name == kLife) return reference_life(prepared, row.value("rating", 0.0));
  for (const Quantity& one : kQuantities)
    if (one.name == name) return one.of(prepared);
  throw InternalError(fmt::format("experiments.json: no quantity \"{}\"", name));
}

ExperimentRow row_of(const Json& run, const Json& row) {
  ExperimentRow out;
  out.condition = run.value("condition", "");
  out.what = row.value("what", label_of(row.at("of").get<std::string>()));
  out.unit = row.at("unit");
  out.kind = row.value("kind", run.value("kind", "prediction"));
  out.certainty = row.value("certainty", run.value("certainty", ""));
  if (row.contains("theirs")) {
    const Json& theirs = row.at("theirs");
    out.theirs = theirs.is_array() ? theirs.at(0).get<double>() : theirs.get<double>();
    if (theirs.is_array()) out.theirs_to = theirs.at(1).get<double>();
  }
  return out;
}

void add_run(const Json& run, Experiment& out) {
  if (run.contains("discs")) {
    for (const Json& row : run.at("rows")) {
      ExperimentRow line = row_of(run, row);
      line.ours = largest_coefficient(run.at("discs")) * per_si(line.unit);
      out.rows.push_back(std::move(line));
    }
    return;
  }
  const std::string deck = run.at("deck");
  const auto name_deck = [&out](const std::string& name) {
    if (std::find(out.decks.begin(), out.decks.end(), name) == out.decks.end())
      out.decks.push_back(name);
  };
  name_deck(deck);
  for (const char* in_time : {"run_down", "motion"})
    if (run.contains(in_time)) name_deck(run.at(in_time).at("deck"));
  const Json sets = run.value("set", Json::object());
  std::optional<Prepared> prepared;
  std::optional<RunDown> down;
  std::optional<MotionFriction> motion;
  const auto once = [&]() -> const Prepared& {
    if (!prepared) prepared = prepare(request_of(deck, sets));
    return *prepared;
  };
  for (const Json& row : run.at("rows")) {
    ExperimentRow line = row_of(run, row);
    try {
      const std::string name = row.at("of");
      double value = 0.0;
      if (const RunDownQuantity* in_time = run_down_quantity(name)) {
        if (!down) down = run_down_of(deck, sets, run);
        value = in_time->of(*down);
      } else if (const MotionQuantity* in_motion = motion_quantity(name)) {
        if (!motion) motion = motion_of(sets, run.at("motion"));
        value = in_motion->of(*motion);
      } else {
        value = name == kExponent ? torque_exponent(deck, sets, run.at("speeds"))
                                  : value_of(name, once(), row);
      }
      line.ours = value * per_si(line.unit);
    } catch (const InputError& error) {
      line.failed = error.what();
    } catch (const SolverError& error) {
      line.failed = error.what();
    }
    out.rows.push_back(std::move(line));
  }
}

Experiment read_experiment(const Json& from) {
  Experiment out;
  out.id = from.at("id");
  out.source = from.at("source");
  out.about = from.at("about");
  out.open = from.value("open", "");
  for (const Json& text : from.value("assumed", Json::array())) out.assumed.push_back(text);
  for (const Json& p : from.value("parameters", Json::array()))
    out.parameters.push_back(
        {p.at("name"), p.at("meaning"), p.at("value"), p.at("low"), p.at("high")});
  return out;
}

std::string figure(const std::optional<double>& value) {
  return value ? fmt::format("{:.5g}", *value) : "-";
}

std::string theirs_text(const ExperimentRow& row) {
  if (!row.theirs) return row.kind == "part" ? "-" : "kept aside";
  if (row.theirs_to) return fmt::format("{:.5g} to {:.5g}", *row.theirs, *row.theirs_to);
  return (row.kind == "bound" ? "<= " : "") + fmt::format("{:.5g}", *row.theirs);
}

std::string deviation_text(const ExperimentRow& row) {
  if (const std::optional<double> d = row.deviation()) return fmt::format("{:+.1f} %", 100.0 * *d);
  if (row.kind == "bound" && row.ours && row.theirs)
    return *row.ours <= *row.theirs ? "within" : "beyond";
  return "-";
}

}  // namespace

std::optional<double> ExperimentRow::deviation() const {
  if (!ours || !theirs || kind == "bound") return std::nullopt;
  double nearest = *theirs;
  if (theirs_to) {
    if (*ours >= *theirs && *ours <= *theirs_to) return 0.0;
    nearest = *ours < *theirs ? *theirs : *theirs_to;
  }
  return *ours / nearest - 1.0;
}

std::vector<Experiment> run_experiments(std::string_view only,
                                        const std::function<void(const std::string&)>& progress) {
  const Json all = parse_json(resources::get("experiments/experiments.json"), "experiments.json");
  std::vector<Experiment> out;
  std::string ids;
  for (const Json& from : all.at("experiments")) {
    Experiment one = read_experiment(from);
    ids += (ids.empty() ? "" : ", ") + one.id;
    if (!only.empty() && only != one.id) continue;
    if (progress) progress(one.id);
    for (const Json& run : from.value("runs", Json::array())) add_run(run, one);
    out.push_back(std::move(one));
  }
  if (out.empty())
    throw InputError(fmt::format("there is no experiment \"{}\"; give one of {}", only, ids));
  return out;
}

std::string experiments_text(const std::vector<Experiment>& experiments) {
  std::string out;
  for (const Experiment& one : experiments) {
    out += fmt::format("\n{}: {}\n  {}\n", one.id, one.source, one.about);
    for (const std::string& text : one.assumed) out += fmt::format("  assumed: {}\n", text);
    for (const ExperimentParameter& p : one.parameters)
      out += fmt::format("  parameter {} = {:.4g} (bounds {:g} to {:g}): {}\n", p.name, p.value,
                         p.low, p.high, p.meaning);
    if (!one.rows.empty())
      out += fmt::format("  {:<24} {:<30} {:>11} {:>20} {:<5} {:>9}  {:<12} {}\n", "condition",
                         "what", "ours", "theirs", "unit", "deviation", "kind", "certainty");
    for (const ExperimentRow& row : one.rows) {
      out += fmt::format("  {:<24} {:<30} {:>11} {:>20} {:<5} {:>9}  {:<12} {}\n", row.condition,
                         row.what, figure(row.ours), theirs_text(row), row.unit,
                         deviation_text(row), row.kind, row.certainty);
      if (!row.failed.empty()) out += fmt::format("    {}\n", row.failed);
    }
    if (!one.open.empty()) out += fmt::format("  open: {}\n", one.open);
  }
  return out;
}

std::string experiments_markdown(const std::vector<Experiment>& experiments) {
  std::string out =
      "# Published experiments\n\n"
      "Written by `adore validate --experiments --markdown`; the decks and what the sources say "
      "are "
      "in `resources/experiments`. A\n*calibration* row was used to fit the parameters named with "
      "it, a *prediction* row was not. Figures of the sources are second hand where\ntheir "
      "certainty says so. A miss is printed as it is.\n";
  for (const Experiment& one : experiments) {
    out += fmt::format("\n## {}\n\n{}. {}\n", one.id, one.source, one.about);
    if (!one.decks.empty()) {
      out += "\nDecks:";
      for (const std::string& deck : one.decks)
        out += fmt::format(" [`{}.txt`](../experiments/{}.txt)", deck, deck);
      out += "\n";
    }
    if (!one.parameters.empty()) {
      out += "\n| parameter | value | bounds | meaning |\n|---|---|---|---|\n";
      for (const ExperimentParameter& p : one.parameters)
        out += fmt::format("| {} | {:.4g} | {:g} to {:g} | {} |\n", p.name, p.value, p.low, p.high,
                           p.meaning);
    }
    if (!one.assumed.empty()) out += "\nAssumed where the source is silent:\n\n";
    for (const std::string& text : one.assumed) out += fmt::format("- {}\n", text);
    if (!one.rows.empty())
      out +=
          "\n| condition | what | ours | theirs | unit | deviation | kind | certainty of theirs |\n"
          "|---|---|---|---|---|---|---|---|\n";
    for (const ExperimentRow& row : one.rows)
      out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.condition, row.what,
                         row.failed.empty() ? figure(row.ours) : row.failed, theirs_text(row),
                         row.unit, deviation_text(row), row.kind, row.certainty);
    if (!one.open.empty()) out += fmt::format("\nOpen: {}\n", one.open);
  }
  return out;
}

nlohmann::ordered_json experiments_json(const std::vector<Experiment>& experiments) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  };
  for (const Experiment& one : experiments) {
    nlohmann::ordered_json entry{{"id", one.id},
                                 {"source", one.source},
                                 {"about", one.about},
                                 {"assumed", one.assumed},
                                 {"parameters", Json::array()},
                                 {"decks", one.decks},
                                 {"rows", Json::array()},
                                 {"open", one.open}};
    for (const ExperimentParameter& p : one.parameters)
      entry["parameters"].push_back({{"name", p.name},
                                     {"value", p.value},
                                     {"low", p.low},
                                     {"high", p.high},
                                     {"meaning", p.meaning}});
    for (const ExperimentRow& row : one.rows)
      entry["rows"].push_back({{"condition", row.condition},
                               {"what", row.what},
                               {"unit", row.unit},
                               {"ours", number(row.ours)},
                               {"theirs", number(row.theirs)},
                               {"theirs_to", number(row.theirs_to)},
                               {"deviation", number(row.deviation())},
                               {"kind", row.kind},
                               {"certainty", row.certainty},
                               {"failed", row.failed}});
    out.push_back(std::move(entry));
  }
  return out;
}

}  // namespace adore::facade

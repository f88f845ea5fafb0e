#include "runs/static_plan.hpp"

#include "base/counted.hpp"
#include "setup/unused_values.hpp"
#include "statics/ball_friction.hpp"
#include "statics/roller_friction.hpp"

#include <fmt/format.h>

#include <numbers>

namespace adore::runs {
namespace {

using bearing::Bearing;
using deck::Deck;

/// Effects have numbers in dynamic plans only; here all belong to the contacts.
constexpr auto kContacts = scene::Effect::RaceContact;

class Entries {
 public:
  explicit Entries(scene::ScenePlan& plan) : plan_(plan) {}
  void add(std::string name, bool on, std::string because) {
    plan_.effects.push_back({kContacts, std::move(name), on, std::move(because)});
  }

 private:
  scene::ScenePlan& plan_;
};

std::string given(const Deck& deck, const char* name) {
  return fmt::format("{} = {}", name, deck.integer(name));
}

double rpm(double speed) { return speed * 30.0 / std::numbers::pi; }

std::string append_item(const std::string& list, const std::string& more) {
  return list.empty() ? more : list + ", " + more;
}

void add_contact_model(Entries& out, const Prepared& p) {
  const Deck& deck = p.input.deck;
  const Bearing& b = p.bearing;
  if (!b.rollers()) {
    out.add("ball / race contact", true,
            "kBrg = 1: elliptical Hertz contact with the curvatures at the angle of each contact");
    const char* rule = b.spin_rule == bearing::SpinRule::MinimumHeat   ? "least frictional heat"
                       : b.spin_rule == bearing::SpinRule::RaceControl ? "race control"
                                                                       : "specified angle";
    out.add("ball speeds", true,
            statics::has_friction_balance(b, ball_statics_options(p))
                ? fmt::format("friction equilibrium (ballFriction); balls without a friction "
                              "equilibrium: {}, spin axis from {}",
                              given(deck, "kAngVel"), rule)
                : fmt::format("{}: pure rolling at both contact centers, spin axis from {}",
                              given(deck, "kAngVel"), rule));
    for (std::size_t j = 0; j < 2; ++j)
      if (b.balls().shim[j] > 0.0)
        out.add(j == 0 ? "split outer race" : "split inner race", true,
                fmt::format("shimThickness{} = {:g}: contact with each half", j + 1,
                            deck.real(j == 0 ? "shimThickness1" : "shimThickness2")));
    return;
  }
  const bool sliced = p.options.rollers.contact == statics::RollerContact::Sliced;
  out.add("roller / race contact", true,
          sliced
              ? fmt::format(
                    "{}: crowned profile in {} slices (run options rollerContact, rollerSlices)",
                    given(deck, "kBrg"), p.options.rollers.slices)
              : fmt::format("{}: one elliptical Hertz contact per race (run option rollerContact)",
                            given(deck, "kBrg")));
  out.add("roller speeds", true,
          statics::has_friction_balance(b, p.options.rollers)
              ? "friction equilibrium with skew (rollerFriction); rollers without a friction "
                "equilibrium: pure rolling at nominal geometry, zero skew"
              : "pure rolling at nominal geometry, zero skew");
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t side = 0; side < 2; ++side) {
      const std::string name = fmt::format("kFlngInd{}{}", side + 1, j + 1);
      out.add(fmt::format("{} flange, {} end", j == 0 ? "outer" : "inner", side == 0 ? "-x" : "+x"),
              b.rollers()->flange[j][side].has_value(), given(deck, name.c_str()));
    }
}

void add_operating_effects(Entries& out, const Prepared& p) {
  const Deck& deck = p.input.deck;
  const Bearing& b = p.bearing;
  const bool turning = b.speed[0] != 0.0 || b.speed[1] != 0.0;
  const std::string speeds =
      fmt::format("rpm1 = {:g}, rpm2 = {:g}", rpm(b.speed[0]), rpm(b.speed[1]));
  out.add("centrifugal, gyroscopic loads", turning, speeds);
  if (const auto& frame = p.options.rollers.frame)
    out.add("rotating base frame", true,
            fmt::format("kRotFrame = 1: {:g} rpm on a radius of {:g} m", rpm(frame->speed),
                        frame->orbit_radius));
  const bearing::Mounting& m = p.as_built.mounting;
  const bool fits = m.fit[0] > 0.0 || m.fit[1] > 0.0;
  out.add("fits of the races", fits,
          fmt::format("raceFit1 = {:g}, raceFit2 = {:g}", deck.real("raceFit1"),
                      deck.real("raceFit2")));
  bool warm = false;
  for (const double T : {b.race_temperature[0], b.race_temperature[1], b.element_temperature,
                         b.cage_temperature, m.housing_temperature, m.shaft_temperature})
    warm = warm || T != b.room_temperature;
  out.add("thermal growth", warm,
          warm ? "temperatures of record 9.1.3 differ from roomTemp" : "all parts at roomTemp");
  out.add("centrifugal growth", turning && m.centrifugal_growth,
          m.centrifugal_growth ? speeds : "run option centrifugalGrowth = 0");
  out.add("properties follow temperature", m.material_laws,
          m.material_laws ? "kMatPropMod = 1" : "kMatPropMod is not 1");
  out.add("element imperfections", b.imperfections.elements != bearing::ElementErrorSource::None,
          given(deck, "kReGeoImp"));
  for (std::size_t j = 0; j < 2; ++j)
    out.add(j == 0 ? "outer race imperfections" : "inner race imperfections",
            b.imperfections.race_given[j], given(deck, j == 0 ? "kRaceGeoImp1" : "kRaceGeoImp2"));
  const auto& outer = b.constraints.outer_misalignment;
  out.add("misaligned outer race", outer[0] != 0.0 || outer[1] != 0.0,
          fmt::format("appMis11 = {:g}, appMis21 = {:g}", deck.real("appMis11"),
                      deck.real("appMis21")));
}

void add_results(Entries& out, const Prepared& p) {
  const Deck& deck = p.input.deck;
  const auto& stiffness = p.control.stiffness;
  out.add(
      "stiffness over speed", stiffness.has_value(),
      stiffness
          ? fmt::format("kStif = {}: {}{}", stiffness->points, counted(stiffness->points, "speed"),
                        stiffness->share > 0.0
                            ? fmt::format(", also by finite differences (pctDisp = {:g} %)",
                                          100.0 * stiffness->share)
                            : std::string())
          : given(deck, "kStif"));
  out.add("fatigue life", true,
          fmt::format("{}: original and updated Lundberg-Palmgren, Gupta-Zaretsky, "
                      "Ioannides-Harris, each with STLE and Tallian factors; ISO 281 and 16281",
                      given(deck, "kLifeCons")));
  out.add("cage", false,
          "mode = -1 computes only the cage clearances (nCseg = " +
              std::to_string(deck.integer("nCseg")) + ")");
  out.add("friction torque", true,
          statics::has_friction_balance(p.bearing, p.options.rollers)
              ? "rollers in friction equilibrium, with the friction laws of the simulated motion; "
                "cage friction is not included"
          : p.bearing.rollers() ? "estimated from the speeds and loads of the equilibrium, which "
                                  "does not include friction"
          : statics::has_friction_balance(p.bearing, ball_statics_options(p))
              ? "balls in friction equilibrium, with the friction laws of the simulated motion; "
                "cage friction is not included"
              : "estimated from speeds and loads of the equilibrium (kAngVel); cage friction is "
                "not included");
  out.add("thermal steady state", p.thermal.has_value(),
          p.thermal ? fmt::format("kTherm = 1, kCoolant = {}, {}", p.as_built.thermal->coolant,
                                  given(deck, "kBaseTemp"))
                    : std::string("kTherm = 0: temperatures of record 9.1.3"));
  out.add("gravity, cage forces", false, "mode = -1: not included in the equilibrium");
  for (const deck::NoPart& value : p.no_part)
    if (setup::requests_effect(value))
      out.add(fmt::format("{} = {}", value.variable, value.value), false, value.because);
}

}  // namespace

scene::ScenePlan static_plan(const Prepared& prepared) {
  scene::ScenePlan plan;
  const Bearing& b = prepared.bearing;
  const int n = b.element_count();
  plan.bodies.push_back(
      {fmt::format("{} ({})", b.rollers() ? "rollers" : "balls", n),
       b.rollers() ? "x, r, tilt in equilibrium: 3 each" : "x, r in equilibrium: 2 each",
       (b.rollers() ? 3 : 2) * n});
  plan.bodies.push_back({"outer race", fmt::format("fixed, speed {:g} rpm", rpm(b.speed[0])), 0});
  static constexpr std::array<const char*, 5> kNames{"x", "y", "z", "about y", "about z"};
  std::string found, held;
  int unknowns = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    const bool fixed = b.constraints.displacement_given[k];
    (fixed ? held : found) = append_item(
        fixed ? held : found, fmt::format("{} (kFS{} = {})", kNames[k], k + 1, fixed ? 1 : 0));
    unknowns += fixed ? 0 : 1;
  }
  const std::string inner = fmt::format("speed {:g} rpm", rpm(b.speed[1]));
  plan.bodies.push_back({"inner race",
                         found.empty() ? inner : fmt::format("unknown: {}; {}", found, inner),
                         unknowns});
  if (!held.empty()) plan.bodies.push_back({"inner race, given", held, 0});
  for (const scene::BodyEntry& body : plan.bodies) plan.unknowns += body.unknowns;
  Entries entries(plan);
  add_contact_model(entries, prepared);
  add_operating_effects(entries, prepared);
  add_results(entries, prepared);
  return plan;
}

std::string static_cost_text(const Prepared& prepared) {
  const statics::RaceResult& solution = prepared.race_result();
  std::string out =
      fmt::format("\ncost\n  equilibrium              {:.3g} ms, {}\n",
                  1e3 * prepared.solve_seconds, counted(solution.iterations, "iteration"));
  if (!prepared.stiffness.empty())
    out +=
        fmt::format("  stiffness over speed     {:.3g} ms for {}\n",
                    1e3 * prepared.stiffness_seconds, counted(prepared.stiffness.size(), "speed"));
  return out;
}

}  // namespace adore::runs

#pragma once

#include "bearing/race_motion.hpp"

#include <string>
#include <vector>

/// Content of a run, decided before it starts. Made by setup/ from the deck; a plain
/// value.
namespace adore::scene {

enum class Effect : unsigned char {
  RaceContact,        ///< element / race normal force
  RaceTraction,       ///< traction over the contact ellipse
  RollingResistance,  ///< of the oil in the inlets of the same contacts (kTrac > 0)
  FlangeContact,      ///< roller end / race flange
  FlangeTraction,
  PocketContact,  ///< element / cage pocket
  PocketTraction,
  ElementContact,  ///< element / element, without cage
  ElementTraction,
  LandContact,  ///< cage / race guide lands
  LandTraction,
  Gravity,
  CageMotion,          ///< six degrees of freedom of the cage
  ElementOrientation,  ///< quaternions of the elements listed in oriented_elements
  WearIntegrals,       ///< quadratures of load x slip
  MomentumLedger,      ///< quadratures of external force and moment
  LightLoadBalance,    ///< lightly loaded elements stand in force balance (qFac)
  RaceExcitation,      ///< races move by laws of the time: ScenePlan::race_motions
  FreeRaces,           ///< races move under loads: ScenePlan::race_motions
  TurningFrame,        ///< the base frame turns: ScenePlan::race_motions
  SuppressedMotions,   ///< accelerations that are zero: ScenePlan::suppressed
  ElementBalance,      ///< all elements stand in force balance (modes 1 and 2)
  RaceBalance,         ///< the inner race is in force balance (mode 2)
  ElementDrag,         ///< the medium drags on elements (kChrn)
  CageDrag,            ///< and on the cage
  PocketFilm,          ///< oil films in the pockets (kPocHydro)
  LandFilm,            ///< and at the guide lands (kGsHydro)
  ThermalSteps,        ///< temperatures and geometry change between steps (kTherm)
  ContactDamping       ///< material damping of contacts (run option contactDamping)
};

/// Accelerations that are zero (kDOF, reading N9): their velocities keep the values of the start.
struct SuppressedMotions {
  bool element_axial = false, element_tilt = false;  ///< along x; rotation about y and z
  bool element_all = false;                          ///< all six
  bool cage_axial = false, cage_tilt = false;
  [[nodiscard]] bool of_elements() const noexcept {
    return element_axial || element_tilt || element_all;
  }
  [[nodiscard]] bool of_cage() const noexcept { return cage_axial || cage_tilt; }
  [[nodiscard]] bool any() const noexcept { return of_elements() || of_cage(); }
};

struct EffectEntry {
  Effect effect;
  std::string name;  ///< "pocket traction"
  bool on = false;
  std::string because;  ///< the deck switch that decides, e.g. "nCseg = 1", "gravityVec = 0"
};

struct BodyEntry {
  std::string name;     ///< "balls (12)", "cage", "outer race"
  std::string degrees;  ///< "x, r, θ, ω (6 each)", "prescribed: speed 0 rpm"
  int unknowns = 0;     ///< state components
};

struct ScenePlan {
  std::vector<BodyEntry> bodies;
  std::vector<EffectEntry> effects;
  bool rollers = false;                ///< the elements are rollers
  bool rigid_balls = false;            ///< balls whose inertia is not that of a sphere
  std::vector<int> oriented_elements;  ///< 0-based elements whose orientation is integrated
  double light_load_ratio = 0.0;  ///< qFac: with LightLoadBalance, load over the force scale at or
                                  ///< below which an element is held
  bearing::RaceMotions race_motions;  ///< motion of the races beyond their constant spin; each
                                      ///< entry switches on its effect
  SuppressedMotions suppressed;
  bool user_frame = false;  ///< routine ADRX1 accelerates the base frame
  int unknowns = 0;         ///< controlled state components
  int quadratures = 0;
  // Estimates, filled once the static solution is known.
  double fastest_frequency = 0.0;  ///< [Hz]
  std::string fastest_contact;     ///< "element 4 / inner race"
  double expected_step = 0.0;      ///< [s]
  double steps_per_revolution = 0.0;
  double seconds_per_revolution = 0.0;  ///< of computing, estimated from a few timed evaluations

  [[nodiscard]] bool has(Effect effect) const {
    for (const EffectEntry& entry : effects)
      if (entry.effect == effect) return entry.on;
    return false;
  }
};

}  // namespace adore::scene

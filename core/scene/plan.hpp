#pragma once

#include "bearing/race_motion.hpp"

#include <string>
#include <vector>

/// What a run will simulate, decided before anything runs. Made by setup/ from the deck; a plain
/// value.
namespace adore::scene {

enum class Effect : unsigned char {
  RaceContact,    ///< element / race normal force
  RaceTraction,   ///< traction over the contact ellipse
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
  LightLoadBalance     ///< lightly loaded elements stand in force balance (qFac)
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
  std::vector<int> oriented_elements;  ///< 0-based elements whose orientation is integrated
  double light_load_ratio = 0.0;  ///< qFac: with LightLoadBalance, load over the force scale at or
                                  ///< below which an element is held
  bearing::RaceMotions race_motions;  ///< how races move beside their constant spin; each entry
                                      ///< switches on its effect
  int unknowns = 0;                   ///< controlled state components
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

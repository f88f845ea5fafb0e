#include "dynamics/effect_catalogue.hpp"

#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/user_motion.hpp"
#include "scene/ledger_terms.hpp"

#include <algorithm>

namespace adore::dynamics {
namespace {

constexpr EffectCatalogEntry kCatalogue[] = {
    {"balls", "-", "balls with six degrees of freedom each", make_balls, nullptr},
    {"rigid elements", "kBrg, kReIP",
     "bodies with six degrees of freedom and an orientation: rollers, and balls with unequal "
     "moments of inertia or an offset mass center",
     make_rigid_elements, nullptr},
    {"ball orientation", "kPltElemInd, kPrtOpt, kAGraf", "quaternions of the displayed balls",
     make_ball_orientation, nullptr},
    {"races", "kTracType", "race bodies; contact and traction between elements and races",
     make_races, race_terms},
    {"contact damping", "run option contactDamping",
     "material damping of contacts (Hunt and Crossley)", make_contact_damping,
     contact_damping_terms},
    {"rolling resistance", "kTrac",
     "moment of the oil pressure in the contact inlets at both races", make_rolling_resistance,
     rolling_resistance_terms},
    {"race excitations", "kVarLoad, kVarSpeed",
     "rotating load, vibration, speed ramp and speed variation of races", make_race_excitations,
     nullptr},
    {"cage pockets", "nCseg, kCPTracType", "contact and traction between balls and cage",
     make_pocket_contact, pocket_terms},
    {"roller flanges", "kFlngInd11-22, kRFTracType",
     "contact and traction between roller ends and flanges", make_roller_flanges,
     roller_flange_terms},
    {"roller pockets", "nCseg, kPocType, kCPTracType",
     "contact and traction between rollers and cage", make_roller_pockets, nullptr},
    {"contacts between balls", "nCseg, kRRTracType",
     "contact and traction between neighboring balls in a bearing without cage",
     make_element_contact, element_contact_terms},
    {"contacts between rollers", "nCseg, kRRTracType",
     "contact (computed in slices) and traction between neighboring rollers in a bearing without "
     "cage",
     make_roller_neighbours, nullptr},
    {"guide lands", "nGL, kCRTracType", "contact and traction between cage and races",
     make_land_contact, land_terms},
    {"guide-land films", "kGsHydro", "oil films between cage and races", make_land_film,
     land_film_terms},
    {"pocket films", "kPocHydro, pocLubFilm", "oil films between elements and cage",
     make_pocket_film, pocket_film_terms},
    {"element drag", "kChrn", "drag and churning of elements in the medium that fills the bearing",
     make_element_drag, element_drag_terms},
    {"cage drag", "kChrn", "drag and churning of the cage in the medium that fills the bearing",
     make_cage_drag, cage_drag_terms},
    {"cage", "nCseg",
     "the cage as one body with six degrees of freedom, or one such body for each segment",
     make_cage, cage_terms},
    {"user motion", "routine ADRX1",
     "loads on races, motion of races and motion of the base frame, as given by a user routine",
     make_user_motion, user_motion_terms},
    {"free races", "kDCR", "races that move under loads", make_free_races, free_race_terms},
    {"gravity", "gravityVec", "weight of elements, cage and races that are free to move",
     make_gravity, gravity_terms},
    {"rotating base frame", "kRotFrame", "transport and Coriolis forces", make_turning_frame,
     rotating_frame_ledger_terms},
    {"momentum ledger", "-", "external loads on elements and cage, for the momentum balance",
     make_momentum_ledger, nullptr},
    {"race balance", "mode", "force balance of the inner race", make_race_balance, nullptr},
    {"suppressed motions", "kDOF", "element accelerations that are set to zero",
     make_suppressed_accelerations, suppressed_acceleration_terms},
    {"light-load balance", "qFac, mode",
     "force balance of lightly loaded elements (qFac) or all elements (mode = 1, 2)",
     make_light_load_balance, light_load_terms},
    {"thermal steps", "kTherm", "updates of temperatures and geometry between time steps",
     make_thermal_steps, thermal_step_terms},
};

}  // namespace

std::span<const EffectCatalogEntry> effect_catalogue() { return kCatalogue; }

std::vector<const LedgerTerm*> energy_terms() {
  std::vector<const LedgerTerm*> all{&terms::kStart, &terms::kKinetic, &terms::kElastic};
  for (const EffectCatalogEntry& line : kCatalogue)
    if (line.terms != nullptr)
      for (const LedgerTerm* term : line.terms()) all.push_back(term);
  std::stable_sort(all.begin(), all.end(),
                   [](const LedgerTerm* a, const LedgerTerm* b) { return a->kind < b->kind; });
  return all;
}

}  // namespace adore::dynamics

#include "dynamics/effect_catalogue.hpp"

#include "dynamics/effect_makers.hpp"
#include "scene/ledger_terms.hpp"

#include <algorithm>

namespace adore::dynamics {
namespace {

constexpr CatalogueLine kCatalogue[] = {
    {"balls", "-", "bodies with six degrees of freedom each", make_balls, nullptr},
    {"ball orientation", "kPltElemInd, kPrtOpt, kAGraf", "quaternions of the balls that are shown",
     make_ball_orientation, nullptr},
    {"races", "kTracType", "bodies, contact and traction with the balls", make_races, race_terms},
    {"race excitations", "-", "rotating load, vibration, speed ramp and variation",
     make_race_excitations, nullptr},
    {"cage pockets", "nCseg, kCPTracType", "contact and traction of balls and cage",
     make_pocket_contact, pocket_terms},
    {"contacts between elements", "nCseg, kRRTracType",
     "contact and traction of neighbours in a bearing without cage", make_element_contact,
     element_contact_terms},
    {"guide lands", "nGL, kCRTracType", "contact and traction of cage and races", make_land_contact,
     land_terms},
    {"cage", "nCseg", "body with six degrees of freedom", make_cage, nullptr},
    {"free races", "-", "races that move under loads", make_free_races, free_race_terms},
    {"gravity", "gravityVec", "weight of balls, cage and free races", make_gravity, gravity_terms},
    {"turning base frame", "-", "transport and Coriolis forces", make_turning_frame,
     turning_frame_terms},
    {"momentum ledger", "-", "what acts from outside on balls and cage", make_momentum_ledger,
     nullptr},
    {"light-load balance", "qFac", "lightly loaded balls stand in force balance",
     make_light_load_balance, light_load_terms},
};

}  // namespace

std::span<const CatalogueLine> effect_catalogue() { return kCatalogue; }

std::vector<const LedgerTerm*> energy_terms() {
  std::vector<const LedgerTerm*> all{&terms::kStart, &terms::kKinetic, &terms::kElastic};
  for (const CatalogueLine& line : kCatalogue)
    if (line.terms != nullptr)
      for (const LedgerTerm* term : line.terms()) all.push_back(term);
  std::stable_sort(all.begin(), all.end(),
                   [](const LedgerTerm* a, const LedgerTerm* b) { return a->kind < b->kind; });
  return all;
}

}  // namespace adore::dynamics

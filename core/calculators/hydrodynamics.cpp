#include "base/errors.hpp"
#include "calculators/json_access.hpp"
#include "calculators/tribology.hpp"
#include "tribology/churning.hpp"
#include "tribology/journal_film.hpp"
#include "tribology/pocket_film.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace adore::calculators {
namespace {

using namespace tribology;

std::optional<Json> journal_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const JournalForce force =
      journal_force({get(in, "mu"), get(in, "R"), get(in, "L"), get(in, "c")},
                    {get(in, "eps"), get(in, "omegaJournal"), get(in, "omegaBearing"),
                     get(in, "attitudeRate"), get(in, "epsRate")});
  return Json{{"Fr", force.radial},
              {"Ft", force.tangential},
              {"W", std::hypot(force.radial, force.tangential)},
              {"torqueJournal", force.torque_journal},
              {"torqueBearing", force.torque_bearing}};
}

std::optional<Json> pocket_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  return Json{{"wedgeLoad", point_wedge_force(get(in, "mu"), get(in, "u"), get(in, "Rx"),
                                              get(in, "Ry"), get(in, "h"))},
              {"squeezeForce",
               sphere_squeeze_force(get(in, "mu"), get(in, "R"), get(in, "h"), get(in, "hRate"))}};
}

std::optional<Json> churning_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string body = in.value("kind", kind_of(the_case));
  const Medium medium{get(in, "rho"), get(in, "mu")};
  const auto of = [](const Drag& drag) {
    return Json{{"Re", drag.reynolds}, {"Cd", drag.coefficient}, {"force", drag.force}};
  };
  if (body == "ball") {
    return of(sphere_drag(medium, get(in, "V"), get(in, "D"), get(in, "area")));
  }
  if (body == "roller") {
    return of(cylinder_drag(medium, get(in, "V"), get(in, "D"), get(in, "length")));
  }
  if (body == "annulus") {
    const RotationDrag drag =
        annulus_drag(medium, get(in, "omega"), get(in, "r"), get(in, "c"), get(in, "length"));
    return Json{{"Re", drag.reynolds},
                {"Ta", drag.taylor},
                {"ratio", drag.coefficient},
                {"torque", drag.torque}};
  }
  if (body != "disc" && body != "spin") return std::nullopt;
  const RotationDrag drag = body == "disc" ? disc_drag(medium, get(in, "omega"), get(in, "r"))
                                           : spin_drag(medium, get(in, "omega"), get(in, "r"));
  return Json{{"Re", drag.reynolds}, {"Cm", drag.coefficient}, {"torque", drag.torque}};
}

}  // namespace

std::vector<Adapter> hydrodynamic_adapters() {
  return {{"tribology_journalBearing", journal_case},
          {"tribology_pocketFilm", pocket_case},
          {"tribology_churning", churning_case}};
}

}  // namespace adore::calculators

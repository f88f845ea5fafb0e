#include "facade/reference/adapters.hpp"

#include "facade/reference/cases_cage.hpp"
#include "facade/reference/cases_dynamics.hpp"
#include "facade/reference/cases_life.hpp"
#include "facade/reference/cases_motion.hpp"
#include "facade/reference/cases_roller_static.hpp"
#include "facade/reference/cases_rollers.hpp"
#include "facade/reference/cases_static.hpp"
#include "facade/reference/cases_thermal.hpp"
#include "facade/reference/cases_traction.hpp"

namespace adore::facade::reference {

std::vector<Adapter> all_adapters() {
  std::vector<Adapter> all;
  const auto add = [&](std::vector<Adapter> some) {
    for (Adapter& adapter : some) all.push_back(std::move(adapter));
  };
  add(cage_adapters());
  add(motion_adapters());
  add(dynamics_adapters());
  add(static_adapters());
  add(roller_static_adapters());
  add(roller_slice_adapters());
  add(roller_part_adapters());
  add(thermal_adapters());
  add(traction_adapters());
  add(life_adapters());
  return all;
}

}  // namespace adore::facade::reference

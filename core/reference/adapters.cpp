#include "reference/adapters.hpp"

#include "calculators/adapters.hpp"
#include "reference/cases_dynamics.hpp"
#include "reference/cases_motion.hpp"

namespace adore::reference {

std::vector<Adapter> all_adapters() {
  std::vector<Adapter> all = component_adapters();
  for (std::vector<Adapter> some : {motion_adapters(), dynamics_adapters()})
    for (Adapter& adapter : some) all.push_back(std::move(adapter));
  return all;
}

}  // namespace adore::reference

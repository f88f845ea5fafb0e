#include "facade/reference/adapters.hpp"

#include "facade/reference/cases_cage.hpp"
#include "facade/reference/cases_dynamics.hpp"
#include "facade/reference/cases_motion.hpp"
#if __has_include("facade/reference/cases_static.hpp")
#include "facade/reference/cases_static.hpp"
#define ADORE_STATIC_CASES
#endif
#if __has_include("facade/reference/cases_traction.hpp")
#include "facade/reference/cases_traction.hpp"
#define ADORE_TRACTION_CASES
#endif

namespace adore::facade::reference {

std::vector<Adapter> all_adapters() {
  std::vector<Adapter> all;
  const auto add = [&](std::vector<Adapter> some) {
    for (Adapter& adapter : some) all.push_back(std::move(adapter));
  };
  add(cage_adapters());
  add(motion_adapters());
  add(dynamics_adapters());
#ifdef ADORE_STATIC_CASES
  add(static_adapters());
#endif
#ifdef ADORE_TRACTION_CASES
  add(traction_adapters());
#endif
  return all;
}

}  // namespace adore::facade::reference

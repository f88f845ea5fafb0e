#include "calculators/adapters.hpp"

#include "calculators/cage.hpp"
#include "calculators/life.hpp"
#include "calculators/lubricant_curves.hpp"
#include "calculators/ratings.hpp"
#include "calculators/rigid_body.hpp"
#include "calculators/roller_static.hpp"
#include "calculators/rollers.hpp"
#include "calculators/static.hpp"
#include "calculators/thermal.hpp"
#include "calculators/traction.hpp"
#include "calculators/tribology.hpp"

namespace adore::calculators {

std::vector<Adapter> component_adapters() {
  std::vector<Adapter> all;
  const auto add = [&](std::vector<Adapter> some) {
    for (Adapter& adapter : some) all.push_back(std::move(adapter));
  };
  add(cage_adapters());
  add(rigid_body_adapters());
  add(static_adapters());
  add(roller_static_adapters());
  add(roller_slice_adapters());
  add(roller_part_adapters());
  add(thermal_adapters());
  add(network_adapters());
  add(traction_adapters());
  add(film_adapters());
  add(lubricant_adapters());
  add(hydrodynamic_adapters());
  add(life_adapters());
  add(rating_adapters());
  add(size_limit_adapters());
  return all;
}

}  // namespace adore::calculators

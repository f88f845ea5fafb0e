#include "facade/motion_friction.hpp"

#include "base/errors.hpp"
#include "facade/passing_folder.hpp"
#include "facade/run.hpp"
#include "results/h5_reader.hpp"

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace adore::facade {
namespace {

struct Item {
  std::string_view channel;
  double MotionFriction::*part;
};
constexpr Item kItems[] = {
    {"energy.rolling_heat", &MotionFriction::rolling},
    {"energy.heat", &MotionFriction::races},
    {"energy.flange_heat", &MotionFriction::ribs},
    {"energy.pocket_heat", &MotionFriction::cage},
    {"energy.pocket_film_heat", &MotionFriction::cage},
    {"energy.land_heat", &MotionFriction::cage},
    {"energy.land_film_heat", &MotionFriction::cage},
    {"energy.element_drag", &MotionFriction::drag},
    {"energy.cage_drag", &MotionFriction::drag},
    {"energy.element_heat", &MotionFriction::other},
    {"energy.contact_damping", &MotionFriction::races},
    {"energy.flange_damping", &MotionFriction::ribs},
    {"energy.pocket_damping", &MotionFriction::cage},
    {"energy.land_damping", &MotionFriction::cage},
    {"energy.element_damping", &MotionFriction::other},
};

/// Of a step, all races.
double at_step(const results::H5Reader& file, const results::H5Reader::ChannelInfo& channel,
               std::size_t step) {
  double sum = 0.0;
  for (const double one : file.read(channel.id, step, 1)) sum += one;
  return sum;
}

}  // namespace

MotionFriction motion_friction(const DeckRequest& moving, const std::string& until) {
  const PassingFolder folder;
  RunRequest request;
  static_cast<DeckRequest&>(request) = moving;
  request.out = folder.path() / "run";
  request.until = until;
  const RunOutcome outcome = run(request);
  if (outcome.status != RunStatus::Done) throw SolverError(outcome.message);
  const results::H5Reader file(*request.out / "RESULTS.h5");
  if (file.steps() < 4) throw InputError("the run stores too few steps to find its friction");
  const std::size_t last = file.steps() - 1, first = last / 2;
  const std::vector<double> rotation = file.read("shaft_rotation");
  const double turned = std::abs(rotation[last] - rotation[first]);  // races against each other
  if (!(turned > 0.0)) throw InputError("the races do not turn against each other");
  MotionFriction out;
  for (const Item& item : kItems)
    if (const auto* channel = file.find(item.channel))
      out.*item.part += (at_step(file, *channel, last) - at_step(file, *channel, first)) / turned;
  out.energy_residual = std::abs(outcome.energy_residual) / outcome.energy_scale;
  return out;
}

}  // namespace adore::facade

#include "validation/motion_friction.hpp"

#include "base/errors.hpp"
#include "results/h5_reader.hpp"
#include "runs/run.hpp"
#include "runs/temporary_folder.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <vector>

namespace adore::validation {
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

/// Amplitude at Z times the cage's angle: the phase is read off the cage itself, so that a cage
/// whose speed drifts does not smear the line. Steps may be unequal (trapezia).
double line_amplitude(const std::vector<double>& force, const std::vector<double>& phase,
                      const std::vector<double>& time) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double periods = std::floor((phase.back() - phase.front()) / kTurn);
  if (periods < 1.0) throw InputError("the run is shorter than one period of the spectral line");
  double sine = 0.0, cosine = 0.0, mean = 0.0, span = 0.0;
  std::size_t end = 1;
  while (end + 1 < phase.size() && phase[end] - phase.front() < kTurn * periods) ++end;
  for (std::size_t n = 1; n <= end; ++n) {
    const double dt = time[n] - time[n - 1];
    mean += 0.5 * dt * (force[n] + force[n - 1]);
    span += dt;
  }
  mean /= span;
  for (std::size_t n = 1; n <= end; ++n) {
    const double half = 0.5 * (time[n] - time[n - 1]);
    for (const std::size_t at : {n - 1, n}) {
      sine += half * (force[at] - mean) * std::sin(phase[at]);
      cosine += half * (force[at] - mean) * std::cos(phase[at]);
    }
  }
  return 2.0 * std::hypot(sine, cosine) / span;
}

/// Values of one body from the step `first` on.
std::vector<double> column(const results::H5Reader& file, std::string_view id, std::size_t body,
                           std::size_t first) {
  const auto* const channel = file.find(id);
  if (channel == nullptr) return {};
  const std::size_t width = channel->size();
  const std::vector<double> all = file.read(id, first, file.steps() - first);
  std::vector<double> out;
  for (std::size_t n = body; n < all.size(); n += width) out.push_back(all[n]);
  return out;
}

void add_motion(const results::H5Reader& file, std::size_t first, double turned,
                MotionRunResults& out) {
  std::vector<double> phase = column(file, "cage.rotation", 0, first);
  if (phase.empty()) return;
  out.cage_ratio = std::abs(phase.back() - phase.front()) / turned;
  const double elements = file.geometry().at("elements");
  for (double& one : phase) one = std::abs(one) * elements;
  const std::vector<double> time = file.read("time", first, file.steps() - first);
  const std::vector<double> x = column(file, "race.applied_force_x", 1, first);
  const std::vector<double> y = column(file, "race.applied_force_y", 1, first);
  const std::vector<double> z = column(file, "race.applied_force_z", 1, first);
  if (x.empty() || y.empty() || z.empty() || phase.back() - phase.front() < 7.0) return;
  out.axial_line = line_amplitude(x, phase, time);
  out.radial_line = std::hypot(line_amplitude(y, phase, time), line_amplitude(z, phase, time));
}

}  // namespace

MotionRunResults evaluate_motion_run(const runs::DeckRequest& moving, const std::string& until) {
  const runs::TemporaryFolder folder;
  runs::RunRequest request;
  static_cast<runs::DeckRequest&>(request) = moving;
  request.out = folder.path() / "run";
  request.until = until;
  const runs::RunOutcome outcome = runs::run(request);
  if (outcome.status != runs::RunStatus::Done) throw SolverError(outcome.message);
  const results::H5Reader file(*request.out / "RESULTS.h5");
  if (file.steps() < 4) throw InputError("the run stores too few steps to compute its friction");
  const std::size_t last = file.steps() - 1, first = last / 2;
  const std::vector<double> rotation = file.read("shaft_rotation");
  const double turned = std::abs(rotation[last] - rotation[first]);  // races against each other
  if (!(turned > 0.0)) throw InputError("the races do not rotate relative to each other");
  MotionRunResults out;
  for (const Item& item : kItems)
    if (const auto* channel = file.find(item.channel))
      out.friction.*item.part +=
          (at_step(file, *channel, last) - at_step(file, *channel, first)) / turned;
  out.friction.energy_residual = std::abs(outcome.energy_residual) / outcome.energy_scale;
  add_motion(file, first, turned, out);
  return out;
}

}  // namespace adore::validation

#include "dynamics/effects/roller_races.hpp"
#include "dynamics/race_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace adore::dynamics {
namespace {

statics::RollerReportKernel kernel_of(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512) return statics::roller_report_avx512;
  if (set == InstructionSet::Avx2) return statics::roller_report_avx2;
#endif
  (void)set;
  return statics::roller_report_baseline;
}

/// Quantities of statics::RollerSliceRows. The first two are read of all slices, the others only
/// where a slice carries load.
constexpr std::size_t kRows = 10, kReadRows = 2;

statics::RollerSliceRows rows_in(double* memory, std::size_t slices) {
  std::fill_n(memory, kReadRows * slices, 0.0);
  statics::RollerSliceRows out{};
  for (double** row : {&out.load, &out.peak, &out.width, &out.half_width, &out.curvature, &out.slip,
                       &out.speed, &out.n[0], &out.n[1], &out.n[2]}) {
    *row = memory;
    memory += slices;
  }
  return out;
}

/// The slice with the largest pressure; of slices that differ by rounding, the one nearest to
/// mid-length, so that the place on an even contact does not depend on the rounding.
std::size_t peak_of(const contact::RollerRaceSlices& slices, const double* pressure) {
  constexpr double kRounding = 1e-9;
  std::array<double, 4> tops{};  // side by side: each maximum waits for the one before
  for (std::size_t k = 0; k < slices.count; ++k) tops[k % 4] = std::max(tops[k % 4], pressure[k]);
  const double largest = *std::max_element(tops.begin(), tops.end());
  std::size_t peak = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < slices.count; ++k) {
    if (pressure[k] < (1.0 - kRounding) * largest || std::abs(slices.s[k]) >= nearest) continue;
    peak = k;
    nearest = std::abs(slices.s[k]);
  }
  return peak;
}

void fill_contact(const RollerRaceModel& model, const contact::RollerPose& at,
                  const contact::RollerRaceSlices& slices, const statics::RollerSliceRows& row,
                  RaceContactSnapshot& out) {
  const bool film = model.traction && model.law.has_film();
  const std::size_t peak = peak_of(slices, row.peak);
  double load = 0.0, load_slip = 0.0, half_major = 0.0, max_slip = 0.0;
  double normal_x = 0.0, normal_r = 0.0, least_film = std::numeric_limits<double>::infinity();
  double* const slice_load = out.slice_load.data();
  double* const slice_pressure = out.slice_pressure.data();
  for (std::size_t k = 0; k < slices.count; ++k) {
    const double Q = row.load[k];
    if (!(Q > 0.0)) continue;
    slice_load[k] = Q;
    slice_pressure[k] = row.peak[k];
    // Slip is kinematics and is told without traction, too.
    max_slip = std::max(max_slip, row.slip[k]);
    load += Q;
    if (model.traction) load_slip += Q * row.slip[k];
    half_major += 0.5 * row.width[k];
    if (film) {
      const tribology::LocalFilm<double> here =
          model.law.film({Q / row.width[k], row.peak[k], 0.0, row.half_width[k], row.speed[k],
                          row.slip[k], row.curvature[k]});
      least_film = std::min(least_film, here.thinnest);
      if (k == peak) {
        out.film = here.thickness;
        out.rolling_speed = std::abs(row.speed[k]);
      }
    }
    normal_x += Q * row.n[0][k];
    normal_r += Q * row.n[2][k];
    if (k != peak) continue;
    out.max_pressure = row.peak[k];
    out.half_minor = row.half_width[k];
    out.peak_position = slices.s[k];
    // Rolling about c = (-n_z, 0, n_x), as for balls.
    const contact::Triple<double> n{row.n[0][k], row.n[1][k], row.n[2][k]};
    const double rolling = -at.omega.x * n.z + at.omega.z * n.x;
    out.spin_to_roll = rolling != 0.0 ? contact::dot(at.omega, n) / rolling : 0.0;
  }
  out.load = load;
  out.load_slip = load_slip;
  out.half_major = half_major;
  out.max_slip = max_slip;
  if (!(load > 0.0)) return;
  if (film) out.least_film = least_film;
  out.angle = model.race == bearing::kOuter ? std::atan2(normal_x, normal_r)
                                            : std::atan2(-normal_x, -normal_r);
}

}  // namespace

RollerRaceReport::RollerRaceReport(const RollerRaceModel& model, const RollersOnRace& rollers)
    : model_(model), rollers_(rollers), kernel_(kernel_of(chosen_instruction_set())) {
  std::size_t slices = 0;
  for (std::size_t i = 0; i < rollers.count(); ++i)
    slices = std::max(slices, rollers.view(i).count);
  rows_.resize(kRows * slices);
}

void RollerRaceReport::fill(const Evaluation& e, std::size_t i, RaceContactSnapshot& out) {
  const contact::RollerPose& at = rollers_.poses()[i];
  const contact::RollerRaceSlices& slices = model_.of(i);
  out.slice_load.assign(slices.count, 0.0);
  out.slice_pressure.assign(slices.count, 0.0);
  const auto j = static_cast<std::size_t>(model_.race);
  out.heat = e.heat[j][i];
  if (!(e.load[j][i] > 0.0)) return;  // as the right-hand side found; an open pose has no load
  const contact::RaceSlicesView& view = rollers_.view(i);
  const statics::RollerSliceRows rows = rows_in(rows_.data(), view.count);
  kernel_({&view, &at, rollers_.slopes() ? rollers_.slopes() + i : nullptr, rows});
  fill_contact(model_, at, slices, rows, out);
}

}  // namespace adore::dynamics

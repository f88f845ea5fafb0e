#pragma once

#include "results/averages.hpp"
#include "results/key_results.hpp"
#include "results/mean_load.hpp"
#include "runs/prepare.hpp"
#include "scene/snapshot.hpp"

#include <array>

/// Fills in the key results of a run.
namespace adore::runs {

using results::KeyResults;

/// Of a quasi-static solution: displacements, loads, largest contact, stiffness.
[[nodiscard]] KeyResults static_results(const Prepared& prepared);

/// The same with all other scalar results of an equilibrium: extremes, heat, fits, lives.
[[nodiscard]] KeyResults equilibrium_results(const Prepared& prepared);

/// Of the contacts with the outer and the inner race, mean over a run [W].
[[nodiscard]] std::array<double, 2> mean_race_heat(const scene::Snapshot& last,
                                                   const results::Averages& averages);

/// Of a dynamic run: the last stored instant, and means over the run.
[[nodiscard]] KeyResults dynamic_results(const scene::Snapshot& last,
                                         const results::Averages& averages,
                                         const results::MeanLoad& carried);

/// Clearance, contact angle and pressures of the fits under way.
void add_heat(KeyResults& out, const Prepared& prepared);
void add_fits(KeyResults& out, const bearing::OperatingFits& fits);

/// Life of the bearing by the original theory, and by the model that run option sol7Life asks for
/// if that is another one [hr]: life_lp_hours, life_gz_stle_hours.
void add_lives(KeyResults& out, const life::BearingLife& life);
/// By ISO 281 and ISO/TS 16281, and the viscosity ratio of an oil by grade.
void add_iso_lives(KeyResults& out, const life::BearingLife& life);

/// Elastic energy of the contacts in the quasi-static solution that the run starts from [J].
[[nodiscard]] double static_elastic_energy(const Prepared& prepared);

}  // namespace adore::runs

#pragma once

#include "facade/prepare.hpp"
#include "results/averages.hpp"
#include "results/mean_load.hpp"
#include "scene/snapshot.hpp"

#include <string>
#include <utility>
#include <vector>

/// The figures by which a run is judged and compared: the summary of RUN.json and the columns of a
/// sweep.
namespace adore::facade {

/// Name with its unit, and value, in the order in which they are shown.
using KeyResults = std::vector<std::pair<std::string, double>>;

/// Of a quasi-static solution: displacements, loads, largest contact, stiffness.
[[nodiscard]] KeyResults static_results(const Prepared& prepared);

/// Of a dynamic run: the last stored instant, and means over the run.
[[nodiscard]] KeyResults dynamic_results(const scene::Snapshot& last,
                                         const results::Averages& averages,
                                         const results::MeanLoad& carried);

/// Life of the bearing by the original theory, and by the model that run option sol7Life asks for
/// if that is another one [hr]: life_lp_hours, life_gz_stle_hours.
void add_lives(KeyResults& out, const life::BearingLife& life);

/// Elastic energy of the contacts in the quasi-static solution that the run starts from [J].
[[nodiscard]] double static_elastic(const Prepared& prepared);

}  // namespace adore::facade

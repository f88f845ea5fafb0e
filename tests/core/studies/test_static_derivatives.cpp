#include "deck/templates.hpp"
#include "studies/campaign.hpp"
#include "studies/job.hpp"
#include "studies/sensitivity.hpp"
#include "studies/static_sensitivity.hpp"
#include "studies/study_folder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

using namespace adore::studies;
namespace fs = std::filesystem;

namespace {

struct Agreement {
  int compared = 0;
  double worst =
      0.0;  ///< |exact - difference| over the larger of them, less the difference's doubt
  std::string where;
};

/// Derivatives by implicit differentiation against fourth-order differences of whole runs.
/// @param sets beside mode -1
Agreement agreement(const std::string& deck, const std::string& variables, double doubts,
                    const std::string& sets = "", const std::string& options = "") {
  const fs::path root = fs::temp_directory_path() / ("adore-test-derivatives-" + deck);
  fs::remove_all(root);
  fs::create_directories(root);
  std::ofstream(root / "DATA.txt") << adore::deck::template_text(deck);
  std::ofstream(root / "s.json") << R"({"adore_study": 1, "kind": "sensitivity", "deck": "DATA.txt",
    "set": {"mode": -1)" << sets << R"(}, "options": {)"
                                 << options << R"(}, "variables": [)" << variables
                                 << R"(], "quantities": ["displacement_x_m",
    "displacement_z_m", "stiffness_x_N_per_m", "largest_contact_load_N", "largest_pressure_Pa"]})";
  const Study study = open_study(root / "s.json");
  const fs::path folder = study.folder();
  const Job job = prepare_job(study, open_study_folder(folder));
  std::vector<Record> records;
  for (const Task& task : make_tasks(job, sensitivity_points(study), 1)) {
    records.push_back(run_task(job, task, folder, {}).value());
    INFO(deck << " run " << task.number << ": " << records.back().message);
    REQUIRE(records.back().exit_code == 0);
  }
  const StaticDerivatives exact = static_derivatives(study, 0);
  const std::vector<BaseValue> bases = base_values(study, 0);
  REQUIRE(exact.size() == study.variables.size());
  Agreement out;
  for (std::size_t v = 0; v < study.variables.size(); ++v)
    for (std::size_t q = 0; q < study.quantities.size(); ++q) {
      const auto found = exact[v].find(study.quantities[q].name);
      if (found == exact[v].end() || std::isnan(found->second)) continue;
      std::vector<double> f;
      for (std::size_t k = 0; k < 4; ++k) f.push_back(records[1 + 4 * v + k].values[q]);
      const Derivative by = difference(f, bases[v].step);
      // A derivative that is nothing beside the quantity's own size over the variable's.
      const double size = std::max(
          {std::abs(found->second), std::abs(by.value),
           1e-6 * std::abs(records[0].values[q] / std::max(std::abs(bases[v].value), 1e-12))});
      const double gap =
          std::max(std::abs(found->second - by.value) - doubts * by.doubt, 0.0) / size;
      ++out.compared;
      UNSCOPED_INFO(deck << " d " << study.quantities[q].name << " / d " << study.variables[v].name
                         << ": exact " << found->second << ", by difference " << by.value << " +- "
                         << by.doubt << ", apart " << gap);
      if (gap > out.worst) {
        out.worst = gap;
        out.where = study.quantities[q].name + " over " + study.variables[v].name;
      }
    }
  fs::remove_all(root);
  return out;
}

}  // namespace

TEST_CASE("static sensitivity: exact derivatives = differences of whole runs", "[unit][studies]") {
  // Balls by the spin rule have no friction in their equilibrium: 4e-8 measured. Those in balance
  // of friction do, and kinks of the traction curve within their ellipses: 2e-6 measured.
  constexpr const char* kOfBalls =
      R"({"name": "appLoadX", "step": 10}, {"name": "appLoadZ", "step": 5},
      {"name": "freeConAng", "step": 0.05}, {"name": "raceCurFac1", "step": 0.0001}, {"name": "rpm2", "step": 50})";
  for (const bool balanced : {false, true}) {
    const Agreement ball =
        balanced ? agreement("ball", kOfBalls, 0.0, "", R"("ballFriction": "balance")")
                 : agreement("ball", kOfBalls, 0.0, "", R"("ballFriction": "spin-rule")");
    INFO(balanced << " " << ball.where << " " << ball.worst);
    CHECK(ball.compared >= 20);
    CHECK(ball.worst < (balanced ? 1e-5 : 1e-6));
  }
  // Slices of rollers come into contact one by one: over the load the tapered bearing's
  // displacement has kinks within the steps; differences are 2e-3 apart and say 5e-4 of doubt.
  for (const char* deck : {"cylindrical", "tapered"}) {
    const Agreement roller =
        agreement(deck, R"({"name": "appLoadZ", "step": 10}, {"name": "rpm2", "step": 20})", 4.0);
    INFO(deck << ": " << roller.where << " " << roller.worst);
    CHECK(roller.compared >= 4);
    CHECK(roller.worst < 1e-5);
  }
}

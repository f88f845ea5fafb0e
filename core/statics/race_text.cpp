#include "statics/race_text.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::statics {

RaceLoadCase race_load_case(const bearing::StaticConstraints& constraints) {
  RaceLoadCase task;
  task.given = constraints.displacement_given;
  for (std::size_t k = 0; k < 5; ++k) {
    if (!std::isfinite(constraints.load[k]) || !std::isfinite(constraints.displacement[k])) {
      throw InputError(fmt::format(
          "bearing equilibrium: the load {} or the displacement {} {} is not a finite number",
          constraints.load[k], constraints.displacement[k], kDirection[k]));
    }
    task.load(static_cast<Eigen::Index>(k)) = constraints.load[k];
  }
  return task;
}

std::string load_text(const RaceLoadCase& task) {
  std::string text;
  for (std::size_t k = 0; k < 5; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (!task.given[k] && task.load(i) != 0.0) {
      text += fmt::format("{}{:.6g} {} {}", text.empty() ? "" : ", ", task.load(i),
                          k < 3 ? "N" : "N m", kDirection[k]);
    }
  }
  return text.empty() ? "no load" : text;
}

std::string solve_failure_text(const RaceSolveResult& solve) {
  return solve.iterations == 0
             ? "could not start"
             : fmt::format("stopped with a force residual of {:.2g} times the load after {}",
                           solve.residual, counted(solve.iterations, "step"));
}

std::vector<Finding> unsupported_direction_notes(const std::vector<int>& held,
                                                 const std::array<double, 5>& displacement) {
  std::vector<Finding> notes;
  for (const int k : held) {
    const auto i = static_cast<std::size_t>(k);
    const char* const unit = k < 3 ? "m" : "rad";
    notes.push_back(
        make_finding("statics.held", fmt::format("the inner race has no load and no support {}: "
                                                 "the displacement remains at {:.6g} {}",
                                                 kDirection[i], displacement[i], unit))
            .of("inner race")
            .measure(fmt::format("displacement {}", kDirection[i]), displacement[i], unit));
  }
  return notes;
}

std::string number_list(const std::vector<std::size_t>& numbers, const std::string& one) {
  std::string text;
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t last = k;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
      ++last;
    }
    text += fmt::format("{}{}", text.empty() ? "" : ", ", numbers[k]);
    if (last > k) {
      text += fmt::format("-{}", numbers[last]);
    }
    k = last + 1;
  }
  return fmt::format("{}{} {}", one, numbers.size() == 1 ? "" : "s", text);
}

}  // namespace adore::statics

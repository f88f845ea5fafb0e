#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "statics/race_equilibrium.hpp"

#include <array>
#include <string>
#include <vector>

/// What the ball and the roller solution say alike, in words and numbers.
namespace adore::statics {

/// Freedoms of the inner race, in their order.
inline constexpr std::array<const char*, 5> kDirection{"along x", "along y", "along z", "about y",
                                                       "about z"};

/// The task that a bearing's constraints set. @throws InputError for a number that is not finite.
[[nodiscard]] RaceLoadCase race_load_case(const bearing::StaticConstraints& constraints);

/// "500 N along x, 20 N m about y", or "no load".
[[nodiscard]] std::string load_text(const RaceLoadCase& task);
/// How far an iteration came that found nothing: "could not begin", since an element that fails at
/// the first guess leaves no residual to speak of, or "stopped with a residual of 0.1 of the load
/// after 7 steps".
[[nodiscard]] std::string solve_failure_text(const RaceSolveResult& solve);

/// Findings statics.held: directions without load and support.
[[nodiscard]] std::vector<Finding> unsupported_direction_notes(
    const std::vector<int>& held, const std::array<double, 5>& displacement);

/// "balls 1-4, 7" of the numbers 1, 2, 3, 4, 7; `one` is the word for a single element.
[[nodiscard]] std::string number_list(const std::vector<std::size_t>& numbers,
                                      const std::string& one);

}  // namespace adore::statics

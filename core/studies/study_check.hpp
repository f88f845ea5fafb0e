#pragma once

#include "studies/points.hpp"

#include <vector>

/// Errors of a study that are found before any computation.
namespace adore::studies {

/// make_points(), of a worst-case search its first round.
[[nodiscard]] std::vector<Point> initial_points(const Study& study);

/// Reads each deck as it is, and puts the sets of its first, middle and last run into it, as far as
/// names, values and ranges of variables go; run options and quantities that such a run cannot have
/// alike. Milliseconds.
/// Without points the decks alone.
/// @throws InputError for a deck that is not there or not valid, and when a run that is tried first
/// is the same for all of them: refused.
void check_decks(const Study& study, const std::vector<Point>& points);

/// "clearance.json: variables[2].normal = ...", "clearance.toml, line 9: variables[2].normal = ..."
/// -> "variables[2].normal": the key in a sentence of
/// parse_study(); empty without a key.
[[nodiscard]] std::string key_in_message(const std::string& sentence, const std::string& file);

}  // namespace adore::studies

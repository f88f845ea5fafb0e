#pragma once

#include <string>

namespace adore {

/// A time that a person waits [s]: "4.2 s", "3 min 05 s", "2 h 07 min"; "unknown" when it is
/// negative, not finite or longer than 40 days.
std::string duration_text(double seconds);

/// "1 revolution", "0.48 revolutions": a span of a motion, four digits.
std::string revolutions_text(double turns);

}  // namespace adore

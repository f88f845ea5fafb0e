#pragma once

#include <string>

namespace adore::adrinput {

/// Translates a message: commands of the window instead of options of the command line.
[[nodiscard]] std::string in_window_words(std::string sentence);

}  // namespace adore::adrinput

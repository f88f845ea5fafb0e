#pragma once

#include <string>

namespace adore::adrinput {

/// A sentence of the program with what the window offers in place of options of the command line.
[[nodiscard]] std::string in_window_words(std::string sentence);

}  // namespace adore::adrinput

#pragma once

#include <string>

namespace adore::adrinput {

/// Translates a message: commands of the window instead of options of the command line.
[[nodiscard]] std::string replace_cli_terms(std::string sentence);

}  // namespace adore::adrinput

#pragma once

#include "studies/study_text.hpp"

/// The one place that knows the TOML library.
namespace adore::studies {

/// @throws InputError "a.toml, line 3: ..." for text that is no TOML.
[[nodiscard]] StudyText parse_toml(const std::string& text, const std::string& name);

}  // namespace adore::studies

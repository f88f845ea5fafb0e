#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Run options as choices, for forms.
namespace adore::setup {

/// Name of the effect that the run option contactDamping = 0 leaves out of the plan.
inline constexpr const char* kContactDamping = "contact damping";

/// Words that a run option takes, in the order of its meaning; "1" and "0" of a switch. Empty for
/// an option that takes numbers only; one with "none", "auto" or a single word takes numbers, too.
[[nodiscard]] std::vector<std::string> option_choices(std::string_view name);

}  // namespace adore::setup

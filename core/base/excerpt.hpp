#pragma once

#include <string>
#include <string_view>

namespace adore {

/// A text as a message quotes it: whole when it has at most 200 bytes, else its first 80 and how
/// many it has; never cut within a UTF-8 character. A damaged file's line can have megabytes, and
/// every window that lays out such a message would do so again at each change.
[[nodiscard]] std::string excerpt(std::string_view text);

}  // namespace adore

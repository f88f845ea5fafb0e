#include "base/json_text.hpp"

#include "base/own_files.hpp"

#include <algorithm>

namespace adore::detail {

std::string json_problem(std::string_view text, std::string_view what) {
  const AdoreFileType sort = detect_file_type(text.substr(0, kFileTypeBytes));
  if (const std::string_view name = describe_file_type(sort);
      !name.empty() && sort != AdoreFileType::Json && sort != AdoreFileType::RunJson)
    return "is " + std::string(name) + ", not JSON; " + std::string(file_type_usage_hint(sort));
  constexpr std::size_t kLongest = 200;
  // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
  if (const std::size_t bracket = what.find("] "); what.substr(0, 1) == "[")
    what.remove_prefix(std::min(bracket == std::string_view::npos ? 0 : bracket + 2, what.size()));
  std::string out = "is not valid JSON: ";
  for (const char c : what.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte > 0x7e ? '?' : c;
  }
  return what.size() > kLongest ? out + " ..." : out;
}

}  // namespace adore::detail

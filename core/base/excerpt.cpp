#include "base/excerpt.hpp"

#include <fmt/format.h>

namespace adore {
namespace {

constexpr std::size_t kWhole = 200;  // bytes
constexpr std::size_t kStart = 80;   // bytes

bool continues_a_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

std::string excerpt(std::string_view text) {
  if (text.size() <= kWhole) return std::string(text);
  std::size_t end = kStart;
  // Four bytes at most: invalid UTF-8 is cut anywhere.
  for (int i = 0; i < 4 && continues_a_character(text[end]); ++i) --end;
  return fmt::format("{}… ({} bytes)", text.substr(0, end), text.size());
}

}  // namespace adore

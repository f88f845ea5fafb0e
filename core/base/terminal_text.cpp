#include "base/terminal_text.hpp"

#include <algorithm>

namespace adore {
namespace {

/// Bytes of the UTF-8 sequence at the start of the text; 0: none.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : byte(0) >= 0xc2 ? 2 : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0U) != 0x80U) return 0;
  return length;
}

bool is_harmless(unsigned char c) { return (c >= 0x20 && c < 0x7f) || c == '\n' || c == '\t'; }

}  // namespace

std::string escape_for_terminal(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (is_harmless(c) || (c == '\r' && i + 1 < text.size() && text[i + 1] == '\n')) {
      out += text[i++];
    } else if (c < 0x20) {
      out += fmt::format("\\x{:02x}", c);
      ++i;
    } else if (const std::size_t length = c < 0x80 ? 0 : sequence_length(text.substr(i));
               length > 0) {
      const bool control =
          length == 2 && c == 0xc2 && static_cast<unsigned char>(text[i + 1]) < 0xa0;
      out += control ? std::string_view("\xef\xbf\xbd") : text.substr(i, length);
      i += length;
    } else {
      // Latin-1 letters of a name stay, so that a printed path is the path; what an 8-bit terminal
      // obeys does not.
      out += c >= 0xa0 ? std::string(1, text[i]) : std::string("\xef\xbf\xbd");
      ++i;
    }
  }
  return out;
}

void print_text(std::FILE* stream, std::string_view text) {
  const bool clean = std::all_of(text.begin(), text.end(),
                                 [](char c) { return is_harmless(static_cast<unsigned char>(c)); });
  if (clean) {
    std::fwrite(text.data(), 1, text.size(), stream);  // close_output() reports errors
    return;
  }
  const std::string shown = escape_for_terminal(text);
  std::fwrite(shown.data(), 1, shown.size(), stream);
}

}  // namespace adore

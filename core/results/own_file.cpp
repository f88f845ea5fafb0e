#include "results/own_file.hpp"

#include <fstream>
#include <string>
#include <string_view>

namespace adore::results {
namespace {

std::string first_bytes(const std::filesystem::path& path, std::size_t most) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(most, '\0');
  if (stream) stream.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(stream.gcount() > 0 ? static_cast<std::size_t>(stream.gcount()) : 0);
  return bytes;
}

bool is_version_at(std::string_view text, std::size_t at) {
  return text.size() > at && text[at] >= '0' && text[at] <= '9';
}

}  // namespace

bool is_own_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  // The attributes of RESULTS.h5 stand behind its first groups.
  const std::string bytes = first_bytes(path, 1 << 18);
  const std::string_view all(bytes), line = all.substr(0, all.find('\n'));
  const auto begins = [&](std::string_view part) { return all.substr(0, part.size()) == part; };
  if (begins("\fAdore ")) return is_version_at(all, 7);  // PRINT.txt
  if (begins("  Adore")) return is_version_at(all, 7);   // SOL1-SOL8
  if (begins("Adore ") && is_version_at(all, 6))
    return line.find(" FINAL: ") != std::string_view::npos ||
           line.find(" MASTER: ") != std::string_view::npos;
  if (begins("{")) return all.substr(0, 64).find("\"program\": \"Adore ") != std::string_view::npos;
  if (begins("\x89HDF\r\n\x1a\n")) return all.find("Adore ") != std::string_view::npos;
  return line.find(",exit,") != std::string_view::npos && line.size() >= 8 &&
         line.substr(line.size() - 8) == ",message";  // SWEEP.csv
}

}  // namespace adore::results

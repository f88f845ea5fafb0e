#include "base/own_files.hpp"

#include "base/input_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>

namespace adore {
namespace {

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// The second line of SOL8: nothing but integers.
bool only_integers(std::string_view line) {
  return !line.empty() && std::all_of(line.begin(), line.end(), [](char c) {
    return c == ' ' || c == '-' || c == '*' || c == '\r' || (c >= '0' && c <= '9');
  });
}

/// Does the text begin with a name and a digit behind it?
bool has_version_after(std::string_view text, std::string_view name) {
  return text.starts_with(name) && text.size() > name.size() && text[name.size()] >= '0' &&
         text[name.size()] <= '9';
}

/// Empty when it is not a plain file, or cannot be read.
std::string first_bytes(const std::filesystem::path& path, std::size_t most) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  InputFile stream(path);
  std::string bytes(most, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return bytes;
}

/// A text in single quotes that begins like a record's label.
bool starts_with_label(std::string_view text) {
  if (text.size() < 5 || text[0] != '\'') return false;
  const auto lower = [&](std::size_t i) {
    return std::tolower(static_cast<unsigned char>(text[i]));
  };
  return lower(1) == 'r' && lower(2) == 'e' && lower(3) == 'c';
}

}  // namespace

AdoreFileType detect_file_type(std::string_view bytes) {
  if (bytes.starts_with("\x89HDF")) return AdoreFileType::ResultsH5;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  const std::string_view rest = bytes.substr(std::min(line.size() + 1, bytes.size()));
  const std::string_view second = rest.substr(0, rest.find('\n'));
  if (!bytes.empty() && bytes[0] == '\f' && has(line, "Adore")) return AdoreFileType::Listing;
  if (has(line, "Adore") && has(line, " FINAL: ")) return AdoreFileType::Final;
  if (has(line, "Adore") && has(line, " MASTER: ")) return AdoreFileType::Master;
  if (line.starts_with("  Adore") || line.starts_with("  ADORE")) {
    if (has(second, "$")) return AdoreFileType::Plot;
    if (only_integers(second)) return AdoreFileType::Animation;
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return AdoreFileType::Unknown;
  if (bytes[first] == '{')
    return has(bytes, "\"program\": \"Adore") ? AdoreFileType::RunJson : AdoreFileType::Json;
  if (bytes[first] == '[') return AdoreFileType::Json;
  if (has(line, ",exit,") && has(line, ",message")) return AdoreFileType::SweepTable;
  return starts_with_label(bytes.substr(first)) ? AdoreFileType::Deck : AdoreFileType::Unknown;
}

AdoreFileType read_file_type(const std::filesystem::path& path) {
  return detect_file_type(first_bytes(path, kFileTypeBytes));
}

bool is_written_by_adore(const std::filesystem::path& path) {
  // The attributes of RESULTS.h5 stand behind its first groups.
  const std::string bytes = first_bytes(path, std::size_t{1} << 18);
  const std::string_view all(bytes), line = all.substr(0, all.find('\n'));
  switch (detect_file_type(all.substr(0, kFileTypeBytes))) {
    case AdoreFileType::Listing:
      return has_version_after(all, "\fAdore ");
    case AdoreFileType::Plot:
    case AdoreFileType::Animation:
    case AdoreFileType::Unknown:  // cut within its first lines
      return has_version_after(all, "  Adore");
    case AdoreFileType::Final:
    case AdoreFileType::Master:
      return has_version_after(all, "Adore ");
    case AdoreFileType::RunJson:
      return all.starts_with("{") && has(all.substr(0, 64), "\"program\": \"Adore ");
    case AdoreFileType::ResultsH5:
      return has(all, "Adore ");
    case AdoreFileType::SweepTable:
      return line.ends_with(",message");
    case AdoreFileType::Deck:
    case AdoreFileType::Json:
      break;
  }
  return false;
}

std::string_view describe_file_type(AdoreFileType sort) {
  switch (sort) {
    case AdoreFileType::Deck:
      return "a deck";
    case AdoreFileType::Listing:
      return "a listing (PRINT.txt of a run)";
    case AdoreFileType::Plot:
      return "a file of plotted channels (SOL1-SOL7 of a run)";
    case AdoreFileType::Animation:
      return "an animation file (SOL8 of a run)";
    case AdoreFileType::Final:
      return "the final state of a run (file FINAL)";
    case AdoreFileType::Master:
      return "the bookkeeping of a run (MASTER)";
    case AdoreFileType::RunJson:
      return "the summary of a run (RUN.json)";
    case AdoreFileType::ResultsH5:
      return "an HDF5 file (RESULTS.h5 of a run)";
    case AdoreFileType::SweepTable:
      return "the table of a sweep (SWEEP.csv)";
    case AdoreFileType::Json:
      return "a JSON file";
    case AdoreFileType::Unknown:
      break;
  }
  return {};
}

std::string_view file_type_usage_hint(AdoreFileType sort) {
  switch (sort) {
    case AdoreFileType::Deck:
      return "`adore check` and `adore run` read this file";
    case AdoreFileType::Listing:
      return "read this file with a text viewer such as `less`";
    case AdoreFileType::Plot:
      return "`adore plot`, `adore show` and `adore convert` read this file";
    case AdoreFileType::Animation:
      return "`adore animate`, `adore show` and `adore convert` read this file";
    case AdoreFileType::Final:
    case AdoreFileType::Master:
    case AdoreFileType::RunJson:
    case AdoreFileType::ResultsH5:
      return "`adore show` and `adore convert` read this file";
    case AdoreFileType::SweepTable:
      return "`adore plot` draws this file";
    case AdoreFileType::Json:
      return "`adore calc` and `adore validate` read JSON files";
    case AdoreFileType::Unknown:
      break;
  }
  return {};
}

}  // namespace adore

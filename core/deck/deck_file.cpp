#include "base/input_file.hpp"
#include "base/own_files.hpp"
#include "deck/deck.hpp"
#include "deck/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>

namespace adore::deck {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestDeck = std::size_t{16} * 1024 * 1024;
constexpr long kMaxLines = 200'000;  ///< a deck has about a hundred, tables of user routines more

/// A file with control characters is not text; a file with so many lines is not a deck.
std::optional<Issue> find_no_deck(std::string_view text, const std::string& file_name) {
  const auto count = [&](char c) { return std::count(text.begin(), text.end(), c); };
  if (const auto lines = std::max(count('\n'), count('\r')); lines > kMaxLines) {
    Issue issue;
    issue.file = file_name;
    issue.message = fmt::format("the file has {} lines and is not a data deck", lines);
    issue.remedy = fmt::format("give the deck (DATA.txt); a deck has at most {} lines", kMaxLines);
    return issue;
  }
  int line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    const auto byte = static_cast<unsigned char>(c);
    const bool blank = c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
    if (blank || (byte >= 0x20 && byte != 0x7f)) continue;
    Issue issue;
    issue.file = file_name;
    issue.line = line;
    issue.message =
        fmt::format("this is not a text file (this line contains the control character {})", byte);
    issue.remedy = "give a data deck in plain text (ASCII or UTF-8)";
    return issue;
  }
  return std::nullopt;
}

[[noreturn]] void fail(const fs::path& path, std::string message, std::string remedy) {
  Issue issue;
  issue.file = path.string();
  issue.message = std::move(message);
  issue.remedy = std::move(remedy);
  throw InputError({issue});
}

std::string read_text(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    fail(path, "there is no such file", "check the name, or write a deck with `adore new ball`");
  if (fs::is_directory(status))
    fail(path, "this is a folder, not a data deck",
         "give the name of the deck in this folder, such as DATA.txt");
  InputFile in(path);
  if (!in) fail(path, "the file cannot be opened", "check its permissions");
  std::string text;
  std::string block(1 << 16, '\0');
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(in.gcount()));
    if (text.size() > kLargestDeck)
      fail(path, "the file is larger than 16 MiB and is not a data deck",
           "give the deck (DATA.txt), not an output file");
  }
  if (in.bad()) fail(path, "the file cannot be read to its end", "check the disk");
  return text;
}

}  // namespace

std::string_view without_marks(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  constexpr char kEndOfFile = 0x1a;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  while (text.ends_with(kEndOfFile)) text.remove_suffix(1);
  return text;
}

ReadResult read_deck_text(std::string_view text, std::string file_name) {
  text = without_marks(text);
  if (std::optional<Issue> wrong = find_no_deck(text, file_name)) {
    ReadResult result;
    result.deck.file = std::move(file_name);
    result.issues.push_back(std::move(*wrong));
    return result;
  }
  return read_deck_records(text, std::move(file_name));
}

ReadResult read_deck(const fs::path& path) {
  const std::string text = read_text(path);
  const AdoreFileType sort = detect_file_type(std::string_view(text).substr(0, kFileTypeBytes));
  if (sort != AdoreFileType::Unknown && sort != AdoreFileType::Deck)
    fail(path, fmt::format("this is {}, not a deck", describe_file_type(sort)),
         fmt::format("give the deck, such as DATA.txt; {}", file_type_usage_hint(sort)));
  if (std::optional<Issue> wrong = find_no_deck(without_marks(text), path.string()))
    throw InputError({*wrong});
  return read_deck_text(text, path.string());
}

}  // namespace adore::deck

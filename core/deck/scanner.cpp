#include "deck/scanner.hpp"

#include <algorithm>
#include <charconv>

namespace adore::deck {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::string_view kWordEnd = " \t\v\f,/";
/// Far above what any record takes, and so many may be added up.
constexpr long long kMaxRepeats = 1'000'000'000'000'000;

}  // namespace

bool is_blank_line(std::string_view line) {
  return line.find_first_not_of(kBlanks) == std::string_view::npos;
}

Scanner::Scanner(std::string_view text) {
  lacks_final_newline_ = !text.empty() && text.back() != '\n' && text.back() != '\r';
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    const bool crlf = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (crlf ? 2 : 1));
  }
  lines_ = std::make_shared<const std::vector<std::string_view>>(std::move(lines));
}

bool Scanner::is_at_unterminated_end() const {
  return lacks_final_newline_ && read_position_.line + 1 == lines().size() &&
         read_position_.column == lines().back().size();
}

bool Scanner::skip_to_record_start() {
  if (read_position_.column > 0) go_to_line(read_position_.line + 1);
  while (read_position_.line < lines().size() && is_blank_line(lines()[read_position_.line]))
    ++read_position_.line;
  read_position_.column = 0;
  read_position_.after_value = false;
  return read_position_.line < lines().size();
}

std::string_view Scanner::rest_of_line() const {
  if (read_position_.line >= lines().size()) return {};
  return lines()[read_position_.line].substr(
      std::min(read_position_.column, lines()[read_position_.line].size()));
}

bool Scanner::skip_blanks() {
  while (read_position_.line < lines().size()) {
    const std::size_t next =
        lines()[read_position_.line].find_first_not_of(kBlanks, read_position_.column);
    if (next != std::string_view::npos) {
      read_position_.column = next;
      return true;
    }
    ++read_position_.line;
    read_position_.column = 0;
  }
  return false;
}

Token Scanner::next() {
  Token token;
  if (!skip_blanks()) return token;
  if (read_position_.after_value && lines()[read_position_.line][read_position_.column] == ',') {
    ++read_position_.column;
    read_position_.after_value = false;
    if (!skip_blanks()) return token;
  }
  const std::string_view line = lines()[read_position_.line];
  const char first = line[read_position_.column];
  token.line = static_cast<int>(read_position_.line) + 1;
  token.first_in_line = is_blank_line(line.substr(0, read_position_.column));
  if (first == ',') {  // nothing before this separator
    ++read_position_.column;
    token.kind = Token::Kind::Null;
    return token;
  }
  if (first == '/') {
    ++read_position_.column;
    token.kind = Token::Kind::Slash;
    return token;
  }
  read_position_.after_value = true;
  if (first == '\'' || first == '"')
    scan_quoted(token);
  else
    scan_word(token);
  return token;
}

void Scanner::scan_quoted(Token& token) {
  const std::string_view line = lines()[read_position_.line];
  const char quote = line[read_position_.column++];
  token.kind = Token::Kind::Quoted;
  for (;; ++read_position_.column) {
    if (read_position_.column >= line.size()) {
      token.unterminated = true;
      return;
    }
    if (line[read_position_.column] != quote) {
      token.text += line[read_position_.column];
    } else if (read_position_.column + 1 < line.size() &&
               line[read_position_.column + 1] == quote) {
      token.text += quote;
      ++read_position_.column;
    } else {
      break;
    }
  }
  ++read_position_.column;
  token.joined = read_position_.column < line.size() &&
                 kWordEnd.find(line[read_position_.column]) == std::string_view::npos;
}

void Scanner::scan_word(Token& token) {
  const std::string_view line = lines()[read_position_.line];
  std::string_view word = line.substr(read_position_.column);
  const std::size_t digits = std::min(word.find_first_not_of("0123456789"), word.size());
  if (digits > 0 && digits < word.size() && word[digits] == '*') {
    const auto [end, error] = std::from_chars(word.data(), word.data() + digits, token.repeat);
    token.repeat = error == std::errc() ? std::min(token.repeat, kMaxRepeats) : kMaxRepeats;
    const std::string_view value = word.substr(digits + 1);
    if (value.empty() || kWordEnd.find(value[0]) != std::string_view::npos) {  // r* : nulls
      token.kind = Token::Kind::Null;
      read_position_.column += digits + 1;
      return;
    }
    read_position_.column += digits + 1;
    if (value[0] == '\'' || value[0] == '"') return scan_quoted(token);
    word = value;
  }
  token.kind = Token::Kind::Word;
  token.text = word.substr(0, word.find_first_of(kWordEnd));
  read_position_.column += token.text.size();
}

}  // namespace adore::deck

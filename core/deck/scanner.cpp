#include "deck/scanner.hpp"

#include <algorithm>
#include <charconv>

namespace adore::deck {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::string_view kWordEnd = " \t\v\f,/";
/// Far above what any record takes, and so many may be added up.
constexpr long long kMostRepeats = 1'000'000'000'000'000;

}  // namespace

bool is_blank_line(std::string_view line) {
  return line.find_first_not_of(kBlanks) == std::string_view::npos;
}

Scanner::Scanner(std::string_view text) {
  bare_end_ = !text.empty() && text.back() != '\n' && text.back() != '\r';
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

bool Scanner::at_bare_end() const {
  return bare_end_ && at_.line + 1 == lines().size() && at_.column == lines().back().size();
}

bool Scanner::start_record() {
  if (at_.column > 0) go_to_line(at_.line + 1);
  while (at_.line < lines().size() && is_blank_line(lines()[at_.line])) ++at_.line;
  at_.column = 0;
  at_.after_value = false;
  return at_.line < lines().size();
}

std::string_view Scanner::rest_of_line() const {
  if (at_.line >= lines().size()) return {};
  return lines()[at_.line].substr(std::min(at_.column, lines()[at_.line].size()));
}

bool Scanner::skip_blanks() {
  while (at_.line < lines().size()) {
    const std::size_t next = lines()[at_.line].find_first_not_of(kBlanks, at_.column);
    if (next != std::string_view::npos) {
      at_.column = next;
      return true;
    }
    ++at_.line;
    at_.column = 0;
  }
  return false;
}

Token Scanner::next() {
  Token token;
  if (!skip_blanks()) return token;
  if (at_.after_value && lines()[at_.line][at_.column] == ',') {
    ++at_.column;
    at_.after_value = false;
    if (!skip_blanks()) return token;
  }
  const std::string_view line = lines()[at_.line];
  const char first = line[at_.column];
  token.line = static_cast<int>(at_.line) + 1;
  token.first_in_line = is_blank_line(line.substr(0, at_.column));
  if (first == ',') {  // nothing before this separator
    ++at_.column;
    token.kind = Token::Kind::Null;
    return token;
  }
  if (first == '/') {
    ++at_.column;
    token.kind = Token::Kind::Slash;
    return token;
  }
  at_.after_value = true;
  if (first == '\'' || first == '"')
    scan_quoted(token);
  else
    scan_word(token);
  return token;
}

void Scanner::scan_quoted(Token& token) {
  const std::string_view line = lines()[at_.line];
  const char quote = line[at_.column++];
  token.kind = Token::Kind::Quoted;
  for (;; ++at_.column) {
    if (at_.column >= line.size()) {
      token.unterminated = true;
      return;
    }
    if (line[at_.column] != quote) {
      token.text += line[at_.column];
    } else if (at_.column + 1 < line.size() && line[at_.column + 1] == quote) {
      token.text += quote;
      ++at_.column;
    } else {
      break;
    }
  }
  ++at_.column;
  token.joined =
      at_.column < line.size() && kWordEnd.find(line[at_.column]) == std::string_view::npos;
}

void Scanner::scan_word(Token& token) {
  const std::string_view line = lines()[at_.line];
  std::string_view word = line.substr(at_.column);
  const std::size_t digits = std::min(word.find_first_not_of("0123456789"), word.size());
  if (digits > 0 && digits < word.size() && word[digits] == '*') {
    const auto [end, error] = std::from_chars(word.data(), word.data() + digits, token.repeat);
    token.repeat = error == std::errc() ? std::min(token.repeat, kMostRepeats) : kMostRepeats;
    const std::string_view value = word.substr(digits + 1);
    if (value.empty() || kWordEnd.find(value[0]) != std::string_view::npos) {  // r* : nulls
      token.kind = Token::Kind::Null;
      at_.column += digits + 1;
      return;
    }
    at_.column += digits + 1;
    if (value[0] == '\'' || value[0] == '"') return scan_quoted(token);
    word = value;
  }
  token.kind = Token::Kind::Word;
  token.text = word.substr(0, word.find_first_of(kWordEnd));
  at_.column += token.text.size();
}

}  // namespace adore::deck

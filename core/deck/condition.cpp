#include "deck/condition.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

namespace adore::deck {
namespace {

/// Recursive descent over: or := and ("||" and)*; and := test ("&&" test)*; test := "(" or ")" |
/// "true" | term (comparison term | "in" "(" integer ("," integer)* ")"); term := integer | name |
/// max(name) | user().
class ConditionParser {
 public:
  ConditionParser(std::string_view text, const ConditionScope& scope)
      : text_(text), scope_(scope) {}

  bool parse() {
    const bool value = parse_or();
    if (!rest().empty()) fail("text after the end");
    return value;
  }

 private:
  [[noreturn]] void fail(std::string_view why) const {
    throw InternalError(fmt::format("condition '{}': {} at column {}", text_, why, at_ + 1));
  }

  std::string_view rest() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return text_.substr(at_);
  }

  bool accept(std::string_view symbol) {
    if (!rest().starts_with(symbol)) return false;
    at_ += symbol.size();
    return true;
  }

  void expect(std::string_view symbol) {
    if (!accept(symbol)) fail(fmt::format("'{}' expected", symbol));
  }

  std::string_view accept_word() {
    const std::string_view text = rest();
    const auto end = std::find_if(text.begin(), text.end(),
                                  [](unsigned char c) { return !std::isalnum(c) && c != '_'; });
    const auto length = static_cast<std::size_t>(end - text.begin());
    if (length == 0 || std::isdigit(static_cast<unsigned char>(text[0]))) return {};
    at_ += length;
    return text.substr(0, length);
  }

  bool accept_integer(long long& value) {
    const std::string_view text = rest();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return false;
    at_ += static_cast<std::size_t>(end - text.data());
    return true;
  }

  bool parse_or() {
    bool value = parse_and();
    while (accept("||"))
      value = parse_and() || value;  // both sides are parsed, so that errors are found
    return value;
  }

  bool parse_and() {
    bool value = parse_test();
    while (accept("&&")) value = parse_test() && value;
    return value;
  }

  bool parse_test() {
    if (accept("(")) {
      const bool value = parse_or();
      expect(")");
      return value;
    }
    const std::size_t start = at_;
    if (accept_word() == "true") return true;
    at_ = start;
    return parse_comparison(parse_term());
  }

  bool parse_comparison(long long left) {
    if (accept("==")) return left == parse_term();
    if (accept("!=")) return left != parse_term();
    if (accept("<=")) return left <= parse_term();
    if (accept(">=")) return left >= parse_term();
    if (accept("<")) return left < parse_term();
    if (accept(">")) return left > parse_term();
    if (accept_word() == "in") return parse_list(left);
    fail("comparison expected");
  }

  bool parse_list(long long left) {
    expect("(");
    bool found = false;
    do {
      long long item = 0;
      if (!accept_integer(item)) fail("integer expected");
      found = found || item == left;
    } while (accept(","));
    expect(")");
    return found;
  }

  long long parse_term() {
    long long value = 0;
    if (accept_integer(value)) return value;
    const std::string_view word = accept_word();
    if (word.empty()) fail("integer or name expected");
    if (word == "user") {
      expect("(");
      expect(")");
      return scope_.user_lines;
    }
    if (word == "max") {
      expect("(");
      const std::string_view name = accept_word();
      if (name.empty()) fail("array name expected");
      expect(")");
      const std::vector<long long> items = scope_.array(name);
      return items.empty() ? 0 : *std::max_element(items.begin(), items.end());
    }
    return scope_.integer(word);
  }

  std::string_view text_;
  const ConditionScope& scope_;
  std::size_t at_ = 0;
};

}  // namespace

bool evaluate(std::string_view condition, const ConditionScope& scope) {
  return ConditionParser(condition, scope).parse();
}

std::vector<std::string_view> variable_names_in(std::string_view condition) {
  std::vector<std::string_view> names;
  std::size_t at = 0;
  while (at < condition.size()) {
    const auto is_word = [&](std::size_t i) {
      return i < condition.size() &&
             (std::isalnum(static_cast<unsigned char>(condition[i])) != 0 || condition[i] == '_');
    };
    if (!is_word(at)) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (is_word(end)) ++end;
    const std::string_view word = condition.substr(at, end - at);
    const bool number = std::isdigit(static_cast<unsigned char>(word[0])) != 0;
    if (!number && word != "in" && word != "true" && word != "max" && word != "user" &&
        std::find(names.begin(), names.end(), word) == names.end())
      names.push_back(word);
    at = end;
  }
  return names;
}

}  // namespace adore::deck

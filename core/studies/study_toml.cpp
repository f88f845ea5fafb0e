#include "studies/study_toml.hpp"

#include "base/errors.hpp"
#include "base/input_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

// The library is header-only; nobody else includes it.
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 1
#include <toml++/toml.h>

namespace adore::studies {
namespace {

using Json = nlohmann::ordered_json;

class Reader {
 public:
  Reader(StudyText& out, const std::string& name) : out_(out), name_(name) {}

  /// @param where path of keys; each value keeps its own, so a long one costs its length per value
  Json value(const toml::node& node, const std::string& where) {
    if (where.size() > kMaxKeyPathBytes)
      throw InputError(
          fmt::format("{}, line {}: the names of nested keys have more than {} bytes. "
                      "Use shorter names.",
                      name_, node.source().begin.line, kMaxKeyPathBytes));
    if (!where.empty()) out_.lines.emplace(where, static_cast<int>(node.source().begin.line));
    if (const toml::table* table = node.as_table()) return object(*table, where);
    if (const toml::array* array = node.as_array()) {
      Json list = Json::array();
      for (const toml::node& item : *array)
        list.push_back(value(item, fmt::format("{}[{}]", where, list.size() + 1)));
      return list;
    }
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* whole = node.as_integer()) return whole->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* truth = node.as_boolean()) return truth->get();
    std::ostringstream date;  // no key accepts one: the checker reports it
    date << toml::node_view<const toml::node>(node);
    return date.str();
  }

  /// The library keeps keys by name; a study's have the order of the file.
  Json object(const toml::table& table, const std::string& where) {
    std::vector<std::pair<const toml::key*, const toml::node*>> rows;
    for (auto&& [key, node] : table) rows.emplace_back(&key, &node);
    std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
      const auto &x = a.first->source().begin, &y = b.first->source().begin;
      return std::pair(x.line, x.column) < std::pair(y.line, y.column);
    });
    Json out = Json::object();
    for (const auto& [key, node] : rows) {
      const std::string name(key->str());
      const std::string at = where.empty() ? name : where + "." + name;
      out_.lines.emplace(at, static_cast<int>(key->source().begin.line));
      out[name] = value(*node, at);
    }
    return out;
  }

 private:
  StudyText& out_;
  const std::string& name_;
};

/// Lines of comments become the remark of the key of the first level that follows them.
void keep_comments(const std::string& text, StudyText& out) {
  std::map<int, std::string> keys;
  for (const auto& [name, line] : out.lines)
    if (name.find_first_of(".[") == std::string::npos) keys.emplace(line, name);
  std::map<std::string, Json> remarks;
  std::vector<std::string> waiting;
  std::istringstream lines(text);
  int number = 0, kept = 0, all = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (const auto key = keys.find(number); key != keys.end() && !waiting.empty()) {
      kept += static_cast<int>(waiting.size());
      remarks[key->second] = waiting.size() == 1 ? Json(waiting.front()) : Json(waiting);
      waiting.clear();
    }
    const std::size_t hash = line.find('#');
    if (hash == std::string::npos) continue;
    const bool alone = line.find_first_not_of(" \t") == hash;
    // A # inside a string is not a comment: names of lots have one.
    if (!alone && std::count(line.begin(), line.begin() + static_cast<long>(hash), '"') % 2 == 1 &&
        std::count(line.begin() + static_cast<long>(hash), line.end(), '#') == 1)
      continue;
    ++all;
    if (!alone) continue;
    std::string words = line.substr(hash + 1);
    if (words.starts_with(' ')) words.erase(0, 1);
    if (words.ends_with('\r')) words.pop_back();
    waiting.push_back(std::move(words));
  }
  out.loose_comments = kept < all;
  Json with = Json::object();
  for (const auto& [key, value] : out.json.items()) {
    if (const auto remark = remarks.find(key); remark != remarks.end())
      with["// " + key] = remark->second;
    with[key] = value;
  }
  out.json = std::move(with);
}

/// Upper bound of the nesting of a TOML text, found without recursion: the library limits lists and
/// inline tables, but not the parts of dotted keys and headers, and recurses over both.
class NestingScan {
 public:
  explicit NestingScan(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  /// First line that is nested deeper than kMaxNesting; 0: none.
  int first_line_too_deep() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_string(c);
        continue;
      }
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
        continue;
      }
      ++at_;
      step(c);
      if (depth_ > kMaxNesting) return line_;
    }
    return 0;
  }

 private:
  void step(char c) {
    switch (c) {
      case '\n':
        ++line_;
        line_start_ = true;
        in_header_ = false;
        depth_ = base();
        return;
      case '[':
      case '{':
        if (open_.empty() && line_start_) {  // [header]: its parts count from the top
          in_header_ = true;
          section_ = depth_ = 1;
        } else if (!in_header_) {
          open_.push_back(++depth_);
        }
        break;
      case ']':
      case '}':
        if (!open_.empty()) open_.pop_back();
        break;
      case ',':
        depth_ = base();
        break;
      case '.':  // a number has at most one
        ++depth_;
        if (in_header_) section_ = depth_;
        break;
      case ' ':
      case '\t':
      case '\r':
        return;
      default:
        break;
    }
    line_start_ = false;
  }

  [[nodiscard]] int base() const { return open_.empty() ? section_ : open_.back(); }

  void skip_string(char quote) {
    line_start_ = false;
    const std::string_view rest = text_.substr(at_);
    const bool long_one = rest.size() >= 3 && rest[1] == quote && rest[2] == quote;
    at_ += long_one ? 3 : 1;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') {
        if (!long_one) return;  // not TOML: the library reports it
        ++line_;
      } else if (c == '\\' && quote == '"') {
        if (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
      } else if (c == quote) {
        if (!long_one) {
          ++at_;
          return;
        }
        std::size_t end = at_;
        while (end < text_.size() && text_[end] == quote) ++end;
        if (end - at_ >= 3) {  // up to two quotes may belong to the text
          at_ = std::min(end, at_ + 5);
          return;
        }
        at_ = end - 1;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, depth_ = 0, section_ = 0;
  bool line_start_ = true, in_header_ = false;
  std::vector<int> open_;  ///< depth inside each open bracket
};

toml::table parse(const std::string& text, const std::string& name) {
  if (const int line = NestingScan(text).first_line_too_deep(); line > 0)
    throw InputError(fmt::format(
        "{}, line {}: keys and lists are nested more than {} levels deep. Use fewer levels.", name,
        line, kMaxNesting));
  toml::parse_result result = toml::parse(text, name);
  if (!result) {
    const auto& error = result.error();
    throw InputError(fmt::format("{}, line {}: this is not valid TOML: {}", name,
                                 error.source().begin.line, error.description()));
  }
  return std::move(result).table();
}

class Places {
 public:
  explicit Places(const std::string& text) : text_(text) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') lines_.push_back(i + 1);
  }

  TomlNode of(const toml::node& node) const {
    TomlNode out;
    out.begin = byte(node.source().begin);
    out.end = byte(node.source().end);
    if (const toml::table* table = node.as_table()) {
      out.value = Json::object();
      out.simple = table->is_inline();
      out.lines = !out.simple && out.begin < text_.size() && text_[out.begin] == '[';
      out.keys_begin = std::min(text_.find('\n', out.begin), text_.size() - 1) + 1;
      for (auto&& [key, child] : *table) {
        TomlNode place = of(child);
        place.key_begin = byte(key.source().begin);
        out.value[std::string(key.str())] = place.value;
        out.keys.emplace(std::string(key.str()), std::move(place));
      }
    } else if (const toml::array* array = node.as_array()) {
      out.value = Json::array();
      for (const toml::node& item : *array) {
        out.items.push_back(of(item));
        out.value.push_back(out.items.back().value);
        const toml::table* row = item.as_table();
        out.simple = out.simple && (row == nullptr || row->is_inline());
      }
    } else {
      StudyText nowhere;
      const std::string nameless;
      out.value = Reader(nowhere, nameless).value(node, "");
    }
    return out;
  }

 private:
  /// Columns count letters, not bytes.
  std::size_t byte(const toml::source_position& at) const {
    if (at.line == 0 || at.line > lines_.size()) return text_.size();
    std::size_t out = lines_[at.line - 1];
    for (auto letters = at.column; letters > 1 && out < text_.size(); --letters)
      for (++out; out < text_.size() && (static_cast<unsigned char>(text_[out]) & 0xc0) == 0x80;)
        ++out;
    return out;
  }
  const std::string& text_;
  std::vector<std::size_t> lines_{0};
};

}  // namespace

TomlNode parse_toml_nodes(const std::string& text, const std::string& name) {
  TomlNode root = Places(text).of(parse(text, name));
  root.lines = true;
  root.simple = false;
  root.keys_begin = 0;
  return root;
}

StudyText parse_toml(const std::string& text, const std::string& name) {
  const toml::table table = parse(text, name);
  StudyText out;
  Reader reader(out, name);
  out.json = reader.object(table, "");
  keep_comments(text, out);
  return out;
}

}  // namespace adore::studies

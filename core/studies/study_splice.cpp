#include "studies/study_splice.hpp"

#include "base/errors.hpp"
#include "studies/study_text.hpp"
#include "studies/study_toml.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace adore::studies {
namespace {

using PlainJson = nlohmann::json;  // sorted keys: their order does not matter
using OrderedJson = nlohmann::ordered_json;

PlainJson bare(const PlainJson& value) {
  if (value.is_array()) {
    PlainJson out = PlainJson::array();
    for (const PlainJson& item : value) out.push_back(bare(item));
    return out;
  }
  if (!value.is_object()) return value;
  PlainJson out = PlainJson::object();
  for (const auto& [key, item] : value.items())
    if (!item.is_null() && !key.starts_with("//")) out[key] = bare(item);
  return out;
}

bool same(const PlainJson& there, const OrderedJson& value) {
  return there == bare(PlainJson(value));
}

/// A change of the text between two bytes.
struct Splice {
  std::size_t begin = 0, end = 0;
  std::string text;
};

class Splicer {
 public:
  explicit Splicer(const std::string& text) : text_(text) {}

  /// Nothing: it cannot be done so.
  std::optional<std::string> spliced(const TomlNode& root, const OrderedJson& values) {
    if (!table(root, values)) return {};
    std::stable_sort(splices_.begin(), splices_.end(),
                     [](const Splice& a, const Splice& b) { return a.begin < b.begin; });
    std::string out;
    std::size_t at = 0;
    for (const Splice& splice : splices_) {
      if (splice.begin < at) return {};  // one inside another
      out.append(text_, at, splice.begin - at);
      out += splice.text;
      at = splice.end;
    }
    return out.append(text_, at);
  }

 private:
  bool change(const TomlNode& place, const OrderedJson& value) {
    if (same(place.value, value)) return true;
    const std::size_t known = splices_.size();
    if (place.value.is_array() && value.is_array() && array(place, value)) return true;
    if (place.value.is_object() && value.is_object() && table(place, value)) return true;
    splices_.resize(known);
    if (place.simple) splices_.push_back({place.begin, place.end, toml_text(value)});
    return place.simple;
  }

  /// Existing keys are changed; a table with one key per line gains and loses keys.
  bool table(const TomlNode& place, const OrderedJson& value) {
    bool done = true;
    std::size_t last = place.keys_begin;  // possible position of a new key
    for (const auto& [key, child] : place.keys) {
      const auto now = value.find(key);
      if (now != value.end() && !now->is_null())
        done = done && change(child, *now);
      else if (place.lines && child.simple)
        splices_.push_back(line_of(child));
      else
        done = false;
      if (child.simple) last = std::max(last, line_end(child.end));
    }
    std::string fresh;
    for (const auto& [key, item] : value.items())
      if (!item.is_null() && !key.starts_with("//") && !place.keys.contains(key))
        fresh += toml_line(key, item);
    if (!fresh.empty() && !place.lines) done = false;
    if (!fresh.empty() && done) {
      if (last > 0 && text_[last - 1] != '\n') fresh.insert(0, "\n");
      splices_.push_back({last, last, fresh});
    }
    return done;
  }

  bool array(const TomlNode& place, const OrderedJson& value) {
    const std::size_t old = place.items.size(), now = value.size();
    if (old == now) {
      bool done = true;
      for (std::size_t i = 0; i < old && done; ++i) done = change(place.items[i], value[i]);
      return done;
    }
    // One item less, or more at the end; other lists are written anew.
    if (!place.simple || old == 0 || now == 0) return false;
    if (old == now + 1) {
      std::size_t gone = 0;
      while (gone < now && same(place.items[gone].value, value[gone])) ++gone;
      for (std::size_t i = gone; i < now; ++i)
        if (!same(place.items[i + 1].value, value[i])) return false;
      splices_.push_back(item_of(place.items[gone]));
      return true;
    }
    if (now != old + 1) return false;
    for (std::size_t i = 0; i < old; ++i)
      if (!same(place.items[i].value, value[i])) return false;
    append(place.items.back(), toml_text(value[old]));
    return true;
  }

  void append(const TomlNode& last, const std::string& item) {
    std::size_t at = blanks(last.end);
    const bool comma = at < text_.size() && text_[at] == ',';
    if (comma) at = blanks(at + 1);
    const bool own_line =
        at < text_.size() && (text_[at] == '#' || text_[at] == '\n' || text_[at] == '\r');
    if (!own_line) {
      splices_.push_back({last.end, last.end, ", " + item});
      return;
    }
    if (!comma) splices_.push_back({last.end, last.end, ","});
    const std::size_t start = line_begin(last.begin);
    const std::size_t indent = text_.find_first_not_of(" \t", start) - start;
    const std::size_t end = line_end(last.end);
    splices_.push_back({end, end, text_.substr(start, indent) + item + "\n"});
  }

  /// An item with its comma, and its whole line when nothing but a comment stands behind it.
  Splice item_of(const TomlNode& item) const {
    std::size_t end = blanks(item.end);
    if (end < text_.size() && text_[end] == ',') end = blanks(end + 1);
    const std::size_t begin = line_begin(item.begin);
    const bool alone = text_.find_first_not_of(" \t", begin) == item.begin;
    const bool last =
        end >= text_.size() || text_[end] == '\n' || text_[end] == '\r' || text_[end] == '#';
    if (alone && last) return {begin, line_end(end), ""};
    return {item.begin, end, ""};
  }

  /// Key, value and the comment behind it.
  Splice line_of(const TomlNode& place) const {
    return {line_begin(place.key_begin), line_end(place.end), ""};
  }

  std::size_t blanks(std::size_t at) const {
    return std::min(text_.find_first_not_of(" \t", at), text_.size());
  }
  std::size_t line_begin(std::size_t at) const {
    const std::size_t before = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
    return before == std::string::npos ? 0 : before + 1;
  }
  /// Behind the line break.
  std::size_t line_end(std::size_t at) const {
    const std::size_t end = text_.find('\n', at);
    return end == std::string::npos ? text_.size() : end + 1;
  }

  const std::string& text_;
  std::vector<Splice> splices_;
};

}  // namespace

EditedText edited_study_text(const std::string& text, const nlohmann::ordered_json& values,
                             const std::filesystem::path& file) {
  const PlainJson wanted = bare(PlainJson(values));
  if (is_toml(file)) {
    try {
      const TomlNode root = parse_toml_nodes(text, file.string());
      std::optional<std::string> spliced = Splicer(text).spliced(root, values);
      if (spliced && bare(PlainJson(read_study_text(*spliced, file).json)) == wanted)
        return {std::move(*spliced), false};
    } catch (const InputError&) {
      // Written anew.
    }
  }
  return {write_study_text(values, is_toml(file)), true};
}

}  // namespace adore::studies

#include "studies/study_text.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "studies/study_toml.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::studies {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kWidth = 100;

std::string quoted(const std::string& text) { return dump_json(Json(text)); }

/// "mode" stands as it is in TOML, "cageGsCls[1]" in quotes.
std::string toml_key(const std::string& key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return (std::isalnum(c) != 0 && c < 0x80) || c == '_' || c == '-';
  });
  return bare ? key : quoted(key);
}

/// TOML knows no "1e-7" without digits before the exponent's sign being fine, and no null.
std::string scalar(const Json& value) {
  return value.is_string() ? quoted(value.get<std::string>()) : dump_json(value);
}

class JsonStudyWriter {
 public:
  explicit JsonStudyWriter(bool toml) : toml_(toml) {}

  std::string flat(const Json& value) const {
    std::string out;
    if (value.is_object()) {
      for (const auto& [key, item] : value.items()) {
        if (toml_ && item.is_null()) continue;
        out += fmt::format("{}{}{}{}", out.empty() ? "" : ", ", toml_ ? toml_key(key) : quoted(key),
                           toml_ ? " = " : ": ", flat(item));
      }
      return "{" + out + "}";
    }
    if (value.is_array()) {
      for (const Json& item : value) out += (out.empty() ? "" : ", ") + flat(item);
      return "[" + out + "]";
    }
    return scalar(value);
  }

  /// An array whose rows are lists or objects has a line for each of them.
  std::string value(const Json& value) const {
    const std::string line = flat(value);
    const bool rows = value.is_array() && !value.empty() &&
                      std::any_of(value.begin(), value.end(), [](const Json& item) {
                        return item.is_structured() || item.is_string();
                      });
    if (!rows || (line.size() < kWidth - 20 && !value.front().is_object())) return line;
    std::string out = "[\n";
    for (std::size_t i = 0; i < value.size(); ++i)
      out += "  " + flat(value[i]) + (i + 1 < value.size() ? ",\n" : "\n");
    return out + "]";
  }

  std::string file(const Json& json) const {
    std::string out;
    bool first = true;
    for (const auto& [key, item] : json.items()) {
      const bool remark = key.starts_with("//");
      if (toml_) {
        if (remark && !first) out += "\n";
        if (remark)
          out += comment(item);
        else if (!item.is_null())
          out += toml_key(key) + " = " + value(item) + "\n";
      } else {
        if (!first) out += remark ? ",\n\n" : ",\n";
        out += "  " + quoted(key) + ": " + indented(value(item));
      }
      first = false;
    }
    return toml_ ? out : "{\n" + out + "\n}\n";
  }

 private:
  static std::string indented(const std::string& text) {
    std::string out;
    for (const char c : text) {
      out += c;
      if (c == '\n') out += "  ";
    }
    return out;
  }
  static std::string comment(const Json& remark) {
    std::string out;
    const auto line = [&](const Json& text) {
      std::string words = text.is_string() ? text.get<std::string>() : dump_json(text);
      for (char& c : words)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
      out += "# " + words + "\n";
    };
    if (remark.is_array())
      for (const Json& item : remark) line(item);
    else
      line(remark);
    return out;
  }
  bool toml_;
};

}  // namespace

bool is_toml(const std::filesystem::path& file) { return file.extension() == ".toml"; }

StudyText read_study_text(const std::string& text, const std::filesystem::path& file) {
  if (is_toml(file)) return parse_toml(text, file.string());
  StudyText out;
  out.json = parse_json<Json>(text, file.string());
  return out;
}

std::string toml_text(const Json& value) { return JsonStudyWriter(true).value(value); }

std::string toml_line(const std::string& key, const Json& value) {
  return toml_key(key) + " = " + toml_text(value) + "\n";
}

std::string write_study_text(const Json& json, bool toml) {
  return JsonStudyWriter(toml).file(json);
}

}  // namespace adore::studies

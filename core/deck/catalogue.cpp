#include "deck/catalogue.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "base/resources.hpp"
#include "deck/catalogue_parts.hpp"
#include "deck/number.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

/// Meaning of designations.
namespace adore::deck {
namespace {

using Json = nlohmann::json;

/// Prefix before the digits of the bore, and the table of its dimensions. "NU" stands for the
/// designs NU, N, NJ and NUP, whose flanges differ.
struct Series {
  std::string_view prefix;
  BearingType type;
  std::string_view dimensions;     ///< key of the table
  double least = 0.0, most = 1e9;  ///< bores that are made [mm]
};
constexpr std::array<Series, 25> kSeries = {{{"60", BearingType::DeepGroove, "10"},
                                             {"62", BearingType::DeepGroove, "02"},
                                             {"63", BearingType::DeepGroove, "03"},
                                             {"618", BearingType::DeepGroove, "18"},
                                             {"619", BearingType::DeepGroove, "19"},
                                             {"160", BearingType::DeepGroove, "00"},
                                             {"70", BearingType::AngularContact, "10", 10.0},
                                             {"72", BearingType::AngularContact, "02", 10.0},
                                             {"73", BearingType::AngularContact, "03", 10.0},
                                             {"719", BearingType::AngularContact, "19"},
                                             {"NU10", BearingType::Cylindrical, "10", 17.0},
                                             {"NU2", BearingType::Cylindrical, "02", 17.0},
                                             {"NU22", BearingType::Cylindrical, "22", 17.0},
                                             {"NU3", BearingType::Cylindrical, "03", 17.0},
                                             {"NU23", BearingType::Cylindrical, "23", 20.0},
                                             {"302", BearingType::Tapered, "302"},
                                             {"303", BearingType::Tapered, "303"},
                                             {"313", BearingType::Tapered, "313"},
                                             {"320", BearingType::Tapered, "320"},
                                             {"322", BearingType::Tapered, "322"},
                                             {"323", BearingType::Tapered, "323"},
                                             {"222", BearingType::Spherical, "22", 25.0},
                                             {"223", BearingType::Spherical, "23", 40.0},
                                             {"230", BearingType::Spherical, "30"},
                                             {"231", BearingType::Spherical, "31"}}};

/// Designs of cylindrical roller bearings.
constexpr std::array<std::string_view, 4> kDesigns = {"NUP", "NU", "NJ", "N"};

/// "05" for 25 mm.
std::string bore_code(double bore) {
  constexpr std::array<std::pair<double, std::string_view>, 4> kSmallBores = {
      {{10.0, "00"}, {12.0, "01"}, {15.0, "02"}, {17.0, "03"}}};
  for (const auto& [size, code] : kSmallBores)
    if (size == bore) return std::string(code);
  if (bore < 10.0) return fmt::format("{}", static_cast<int>(std::lround(bore)));
  return fmt::format("{:02d}", static_cast<int>(std::lround(bore / 5.0)));
}

const Json& rows_of(const Series& series) {
  return series.type == BearingType::Tapered
             ? catalogue_table()["tapered"][std::string(series.dimensions)]
             : catalogue_table()["series"][std::string(series.dimensions)];
}

bool offered(const Series& series, double bore) {
  return bore >= series.least && bore <= series.most;
}

/// Upper case letters and digits only, and what follows the number apart.
std::string squeezed(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '.' && c != '_')
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

std::string what_there_is() {
  return "give a designation such as 6205, 7208 B, NU209, 30208 or 22210, with a bore up to "
         "300 mm. The series are 60xx, 62xx, 63xx, 160xx, 618xx, 619xx (deep groove); 70xx, 72xx, "
         "73xx, "
         "719xx with the suffix C, AC or B (angular contact); 10xx, 2xx, 22xx, 3xx, 23xx with the "
         "prefix NU, N, NJ or NUP (cylindrical); 302xx, 303xx, 313xx, 320xx, 322xx, 323xx "
         "(tapered); 222xx, 223xx, 230xx, 231xx (spherical). Or give the type (deep-groove, "
         "angular-contact, cylindrical, tapered, spherical) and the size in millimeters, such as "
         "'deep-groove 25x52x15'. Or give the name of a test rig, such as CWRU-6205-DE. `adore new "
         "--list` lists all designations";
}

[[noreturn]] void fail(std::string_view designation, const std::string& why) {
  Issue issue;
  issue.value = designation;
  issue.message = why;
  issue.remedy = what_there_is();
  throw InputError({std::move(issue)});
}

/// Without the signs between suffixes at its ends.
std::string trimmed(const std::string& suffix) {
  const std::size_t first = suffix.find_first_not_of("-/,");
  return first == std::string::npos
             ? ""
             : suffix.substr(first, suffix.find_last_not_of("-/,") - first + 1);
}

/// Takes the angle out of a suffix: C 15, AC 25, B 40 degrees, which is that without one.
void take_angle(CatalogueBearing& bearing, std::string& suffix, std::string_view designation) {
  constexpr std::array<std::pair<std::string_view, double>, 3> kAngles = {
      {{"AC", 25.0}, {"C", 15.0}, {"B", 40.0}}};
  bearing.angle = 40.0;
  suffix = trimmed(suffix);
  const auto given = std::find_if(kAngles.begin(), kAngles.end(),
                                  [&](const auto& one) { return suffix.starts_with(one.first); });
  bearing.angle_given = given != kAngles.end();
  if (bearing.angle_given) {
    bearing.angle = given->second;
    suffix.erase(0, given->first.size());
  } else if (!suffix.empty() && std::isalpha(static_cast<unsigned char>(suffix[0])) != 0) {
    fail(designation, "has an unknown suffix for the contact angle");
  }
  bearing.designation += bearing.angle == 15.0 ? " C" : bearing.angle == 25.0 ? " AC" : " B";
}

/// "NJ" of "NJ209"; empty: not a cylindrical roller bearing.
std::string_view design_of(std::string_view text) {
  for (const std::string_view design : kDesigns)
    if (text.starts_with(design) && text.size() > design.size() &&
        std::isdigit(static_cast<unsigned char>(text[design.size()])) != 0)
      return design;
  return {};
}

/// "SKF " of "SKF 6205": a word of letters before a blank and a digit or NU; empty without one.
std::string makers_name(std::string_view designation) {
  const std::size_t blank = designation.find(' ', designation.find_first_not_of(' '));
  if (blank == std::string_view::npos) return "";
  const std::string word = squeezed(designation.substr(0, blank));
  const std::string rest = squeezed(designation.substr(blank));
  const bool letters = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalpha(c) != 0;
  });
  const bool number = !rest.empty() && (std::isdigit(static_cast<unsigned char>(rest[0])) != 0 ||
                                        !design_of(rest).empty());
  const bool design =
      std::find(kDesigns.begin(), kDesigns.end(), std::string_view(word)) != kDesigns.end();
  return letters && number && !design ? std::string(designation.substr(0, blank)) : "";
}

/// "25x52x15" and more: millimeters between x.
std::optional<std::vector<double>> sizes_in(std::string_view text) {
  std::vector<double> out;
  std::string rest(text);
  for (std::size_t at = rest.find("\u00d7"); at != std::string::npos; at = rest.find("\u00d7"))
    rest.replace(at, 2, "X");
  std::size_t from = 0;
  while (from <= rest.size()) {
    const std::size_t end = std::min(rest.find_first_of("Xx", from), rest.size());
    std::string number = rest.substr(from, end - from);
    std::replace(number.begin(), number.end(), ',', '.');
    number.erase(0, number.find_first_not_of(' '));
    number.erase(number.find_last_not_of(' ') + 1);
    if (parse_real(number, out.emplace_back())) return std::nullopt;
    from = end + 1;
  }
  return out;
}

std::optional<CatalogueBearing> find_by_size(std::string_view designation) {
  const std::size_t digit = designation.find_first_of("0123456789");
  if (digit == std::string_view::npos) return std::nullopt;
  std::string word;
  for (const char c : designation.substr(0, digit))
    if (c != ' ') word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto type = std::find_if(kTypes.begin(), kTypes.end(),
                                 [&](const BearingTypeInfo& info) { return info.word == word; });
  if (type == kTypes.end()) return std::nullopt;
  const auto sizes = sizes_in(designation.substr(digit));
  if (!sizes || sizes->size() != 3)
    fail(designation,
         "is not a bearing size: it must have the form bore x outside diameter x width, in "
         "millimeters");
  CatalogueBearing out;
  out.type = type->type;
  out.designation =
      fmt::format("{} {:g}x{:g}x{:g}", type->word, (*sizes)[0], (*sizes)[1], (*sizes)[2]);
  out.envelope = {(*sizes)[0] * kMm, (*sizes)[1] * kMm, (*sizes)[2] * kMm, (*sizes)[2] * kMm};
  out.angle = default_contact_angle(out.type, out.envelope);
  if (!(out.envelope.bore > 0.0) || !(out.envelope.outside > out.envelope.bore) ||
      !(out.envelope.width > 0.0) || out.envelope.outside > 10.0 || out.envelope.width > 5.0)
    fail(designation,
         "is not a bearing size: the bore must be above 0 and below the outside diameter, the "
         "outside diameter at most 10 m, and the width above 0 and at most 5 m");
  return out;
}

/// "K", "EK", "CCK/W33", "E1-XL-K", "K30": of roller bearings the bore is a cone.
bool says_tapered_bore(BearingType type, const std::string& suffix) {
  if (type != BearingType::Spherical && type != BearingType::Cylindrical) return false;
  for (std::size_t at = suffix.find('K'); at != std::string::npos; at = suffix.find('K', at + 1)) {
    const std::string_view rest = std::string_view(suffix).substr(at + 1);
    if (rest.empty() || std::isalpha(static_cast<unsigned char>(rest[0])) == 0) return true;
  }
  return false;
}

/// A clearance group anywhere in a suffix ("-2RSC3", "ECP/C3"), removed from it.
std::string take_group(std::string& suffix) {
  for (const std::string_view group : kGroups) {
    const std::size_t at = suffix.find(group);
    if (at == std::string::npos) continue;
    const std::size_t after = at + group.size();
    if (after < suffix.size() && std::isdigit(static_cast<unsigned char>(suffix[after])) != 0)
      continue;
    suffix.erase(at, group.size());
    return std::string(group);
  }
  return "";
}

/// resources/test_rigs.json
const Json& rig_table() {
  static const Json json = parse_json(resources::get("test_rigs.json"), "test_rigs.json");
  return json;
}

std::optional<CatalogueBearing> find_rig(std::string_view name) {
  const std::string wanted = squeezed(name);
  for (const Json& rig : rig_table()["rigs"]) {
    const auto& text = rig["name"].get_ref<const std::string&>();
    if (squeezed(text) != wanted) continue;
    const auto length = [&](const char* key) { return rig[key].get<double>() * kMm; };
    CatalogueBearing out;
    out.designation = text;
    out.type = parse_bearing_type(rig["type"].get<std::string>());
    out.envelope = {length("bore"), length("outside"), length("width"), length("width")};
    out.angle = rig["angle"].get<double>();
    out.angle_given = true;
    out.rig = true;
    out.known.count = rig["count"].get<long long>();
    out.known.diameter = length("diameter");
    out.known.pitch = length("pitch");
    out.known.groove_outer = rig.value("groove_outer", 0.0);
    out.known.groove_inner = rig.value("groove_inner", 0.0);
    out.known.source =
        fmt::format("{} ({}); assumed: {}", rig["source"].get<std::string>(),
                    rig["certainty"].get<std::string>(), rig["assumed"].get<std::string>());
    return out;
  }
  return std::nullopt;
}

/// Digits of the bore at the start: two, or one of deep groove bearings below 10 mm.
std::string bore_digits(const Series& series, std::string_view rest) {
  const auto digit = [&](std::size_t at) {
    return at < rest.size() && std::isdigit(static_cast<unsigned char>(rest[at])) != 0;
  };
  if (digit(0) && digit(1) && !digit(2)) return std::string(rest.substr(0, 2));
  if (series.type == BearingType::DeepGroove && digit(0) && !digit(1))
    return std::string(rest.substr(0, 1));
  return "";
}

}  // namespace

CatalogueBearing find_bearing(std::string_view designation) {
  if (std::optional<CatalogueBearing> rig = find_rig(designation)) return *rig;
  if (std::optional<CatalogueBearing> sized = find_by_size(designation)) return *sized;
  const std::string maker = makers_name(designation);
  std::string text = squeezed(designation.substr(maker.size()));
  const std::string design(design_of(text));
  if (!design.empty()) text.replace(0, design.size(), "NU");
  for (const Series& series : kSeries) {
    if (!text.starts_with(series.prefix)) continue;
    const std::string_view rest = std::string_view(text).substr(series.prefix.size());
    const std::string digits = bore_digits(series, rest);
    if (digits.empty()) continue;
    for (const Json& row : rows_of(series)) {
      const double bore = row[0].get<double>();
      if (!offered(series, bore) || bore_code(bore) != digits) continue;
      CatalogueBearing out;
      out.type = series.type;
      out.standard = true;
      out.envelope = {bore * kMm, row[1].get<double>() * kMm, row[2].get<double>() * kMm,
                      row[2].get<double>() * kMm};
      out.designation = std::string(series.prefix) + bore_code(bore);
      if (!design.empty()) {
        out.designation.replace(0, 2, design);
        out.design = design;
      }
      std::string suffix(rest.substr(digits.size()));
      // First: the "C3" of "7208 C3" is not an angle.
      std::string group = take_group(suffix);
      if (series.type == BearingType::AngularContact) take_angle(out, suffix, designation);
      if (has_clearance_group(out.type, group))
        out.clearance = std::move(group);
      else
        suffix += group;
      out.tapered_bore = says_tapered_bore(out.type, suffix);
      out.left_out =
          maker + (maker.empty() || trimmed(suffix).empty() ? "" : " ") + trimmed(suffix);
      if (series.type == BearingType::Tapered) {
        out.envelope.width = row[3].get<double>() * kMm;
        out.envelope.cup_width = row[4].get<double>() * kMm;
        out.angle = row[5].get<double>();
        out.angle_given = true;
        return out;
      }
      if (series.type != BearingType::AngularContact)
        out.angle = default_contact_angle(series.type, out.envelope);
      return out;
    }
    fail(designation,
         "is not in the catalogue: unknown bore number in series " + std::string(series.prefix));
  }
  fail(designation, "is not in the catalogue");
}

std::vector<std::string> catalogue_designations() {
  std::vector<std::string> out;
  for (const Series& series : kSeries)
    for (const Json& row : rows_of(series))
      if (offered(series, row[0].get<double>())) {
        const std::string name = std::string(series.prefix) + bore_code(row[0].get<double>());
        if (series.type == BearingType::Cylindrical)
          for (const char* design : {"NU", "N", "NJ", "NUP"})
            out.push_back(design + name.substr(2));
        else if (series.type != BearingType::AngularContact)
          out.push_back(name);
        else
          for (const char* angle : {" C", " AC", " B"}) out.push_back(name + angle);
      }
  return out;
}

std::vector<std::string> test_rig_names() {
  std::vector<std::string> out;
  for (const Json& rig : rig_table()["rigs"]) out.push_back(rig["name"].get<std::string>());
  return out;
}

std::vector<CatalogueBearing> catalogue_list(double bore_mm, std::string_view type) {
  const std::optional<BearingType> wanted =
      type.empty() ? std::nullopt : std::optional<BearingType>(parse_bearing_type(type));
  std::vector<std::string> names = catalogue_designations();
  for (std::string& rig : test_rig_names()) names.push_back(std::move(rig));
  std::vector<CatalogueBearing> out;
  for (const std::string& name : names) {
    CatalogueBearing one = find_bearing(name);
    if (wanted && one.type != *wanted) continue;
    constexpr double kSame = 0.5 * kMm;
    if (bore_mm > 0.0 && std::abs(one.envelope.bore - bore_mm * kMm) > kSame) continue;
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace adore::deck

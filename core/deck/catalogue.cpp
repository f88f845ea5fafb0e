#include "deck/catalogue.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "base/resources.hpp"
#include "deck/keep_text.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"
#include "deck/remarks.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

namespace adore::deck {
namespace {

using Json = nlohmann::json;

const Json& table() {
  static const Json json = parse_json(resources::get("catalogue.json"), "catalogue.json");
  return json;
}

constexpr double kMm = 1e-3, kMicron = 1e-6, kDegree = std::numbers::pi / 180.0;

struct TypeInfo {
  BearingType type;
  std::string_view word;  ///< before bore x outside x width
  std::string_view name;  ///< in sentences
  std::string_view template_name;
};
constexpr std::array<TypeInfo, 5> kTypes = {{
    {BearingType::DeepGroove, "deep-groove", "deep groove ball bearing", "deep-groove-6205"},
    {BearingType::AngularContact, "angular-contact", "angular contact ball bearing", "angular-218"},
    {BearingType::Cylindrical, "cylindrical", "cylindrical roller bearing", "cylindrical-nu209"},
    {BearingType::Tapered, "tapered", "tapered roller bearing", "tapered-30208"},
    {BearingType::Spherical, "spherical", "spherical roller bearing", "spherical-22210"},
}};

const TypeInfo& info_of(BearingType type) {
  return *std::find_if(kTypes.begin(), kTypes.end(),
                       [&](const TypeInfo& info) { return info.type == type; });
}

/// What stands before the two digits of the bore, and where its dimensions are.
struct Series {
  std::string_view prefix;
  BearingType type;
  std::string_view dimensions;  ///< key of the table
};
constexpr std::array<Series, 11> kSeries = {{{"60", BearingType::DeepGroove, "10"},
                                             {"62", BearingType::DeepGroove, "02"},
                                             {"63", BearingType::DeepGroove, "03"},
                                             {"70", BearingType::AngularContact, "10"},
                                             {"72", BearingType::AngularContact, "02"},
                                             {"73", BearingType::AngularContact, "03"},
                                             {"NU10", BearingType::Cylindrical, "10"},
                                             {"NU2", BearingType::Cylindrical, "02"},
                                             {"NU3", BearingType::Cylindrical, "03"},
                                             {"302", BearingType::Tapered, "302"},
                                             {"222", BearingType::Spherical, "22"}}};
/// Rollers of small bearings are left to their makers.
constexpr double kSmallestCylindrical = 17.0;

/// "05" for 25 mm.
std::string bore_code(double bore) {
  constexpr std::array<std::pair<double, std::string_view>, 4> kSmall = {
      {{10.0, "00"}, {12.0, "01"}, {15.0, "02"}, {17.0, "03"}}};
  for (const auto& [size, code] : kSmall)
    if (size == bore) return std::string(code);
  return fmt::format("{:02d}", static_cast<int>(std::lround(bore / 5.0)));
}

const Json& rows_of(const Series& series) {
  return series.type == BearingType::Tapered ? table()["tapered"][std::string(series.dimensions)]
                                             : table()["series"][std::string(series.dimensions)];
}

bool offered(const Series& series, double bore) {
  return series.type != BearingType::Cylindrical || bore >= kSmallestCylindrical;
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
  return "give 60xx, 62xx, 63xx (deep groove), 70xx, 72xx, 73xx (angular contact; C, AC or B), "
         "NU10xx, NU2xx, NU3xx, 302xx or 222xx with a bore up to 100 mm, such as 6205, 7208 B, "
         "NU209, 30208 or 22210, or type (deep-groove, angular-contact, cylindrical, tapered, "
         "spherical) and outside in millimetres, such as 'deep-groove 25x52x15'";
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
    fail(designation, "has a suffix that says no contact angle known here");
  }
  bearing.designation += bearing.angle == 15.0 ? " C" : bearing.angle == 25.0 ? " AC" : " B";
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
                                        rest.starts_with("NU"));
  return letters && number && !word.starts_with("NU") ? std::string(designation.substr(0, blank))
                                                      : "";
}

/// "25x52x15" and more: millimetres between x.
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

/// Contact angle that a type has by habit [deg].
double usual_angle(BearingType type, const Envelope& envelope) {
  switch (type) {
    case BearingType::AngularContact:
      return 40.0;
    case BearingType::Tapered:
      return 14.0361;             // of most sizes of the series 302
    case BearingType::Spherical:  // rows a little less than half the width apart
      return std::atan(0.245 * envelope.width / (0.25 * (envelope.bore + envelope.outside))) /
             kDegree;
    default:
      return 0.0;
  }
}

std::optional<CatalogueBearing> find_by_size(std::string_view designation) {
  const std::size_t digit = designation.find_first_of("0123456789");
  if (digit == std::string_view::npos) return std::nullopt;
  std::string word;
  for (const char c : designation.substr(0, digit))
    if (c != ' ') word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto type = std::find_if(kTypes.begin(), kTypes.end(),
                                 [&](const TypeInfo& info) { return info.word == word; });
  if (type == kTypes.end()) return std::nullopt;
  const auto sizes = sizes_in(designation.substr(digit));
  if (!sizes || sizes->size() != 3)
    fail(designation, "is no outside of a bearing: bore x outside diameter x width in millimetres");
  CatalogueBearing out;
  out.type = type->type;
  out.designation =
      fmt::format("{} {:g}x{:g}x{:g}", type->word, (*sizes)[0], (*sizes)[1], (*sizes)[2]);
  out.envelope = {(*sizes)[0] * kMm, (*sizes)[1] * kMm, (*sizes)[2] * kMm, (*sizes)[2] * kMm};
  out.angle = usual_angle(out.type, out.envelope);
  if (!(out.envelope.bore > 0.0) || !(out.envelope.outside > out.envelope.bore) ||
      !(out.envelope.width > 0.0) || out.envelope.outside > 10.0 || out.envelope.width > 5.0)
    fail(designation,
         "is no outside of a bearing: the bore must be above 0 and below the outside diameter");
  return out;
}

double nearest(double value, double step) {
  return std::max(step, std::round(value / step) * step);
}

constexpr std::array<std::string_view, 5> kGroups = {"C2", "CN", "C3", "C4", "C5"};

/// Key of the table; empty: no group of radial clearance.
std::string_view clearance_kind(BearingType type) {
  switch (type) {
    case BearingType::DeepGroove:
      return "ball";
    case BearingType::Cylindrical:
      return "cylindrical";
    case BearingType::Spherical:
      return "spherical";
    default:
      return "";
  }
}

bool has_group(BearingType type, std::string_view group) {
  const std::string_view kind = clearance_kind(type);
  const auto at = std::find(kGroups.begin(), kGroups.end(), group);
  return !kind.empty() && at != kGroups.end() &&
         static_cast<std::size_t>(at - kGroups.begin()) + 2 <
             table()["clearance"][std::string(kind)][0].size();
}

/// Middle of a clearance group [m]; beyond the table in proportion to its last row.
double middle_clearance(BearingType type, std::string_view group, double bore) {
  if (!has_group(type, group))
    throw InputError(
        fmt::format("there is no clearance group {} of a {}", group, info_of(type).name));
  const Json& rows = table()["clearance"][std::string(clearance_kind(type))];
  const auto column = static_cast<std::size_t>(
      2 + (std::find(kGroups.begin(), kGroups.end(), group) - kGroups.begin()));
  const auto middle = [&](const Json& row) {
    return 0.5 * (row[column][0].get<double>() + row[column][1].get<double>()) * kMicron;
  };
  const double size = bore / kMm;
  for (const Json& row : rows)
    if (size <= row[1].get<double>()) return middle(row);
  return middle(rows.back()) * size / rows.back()[1].get<double>();
}

std::string clearance_reason(std::string_view group) {
  return fmt::format("middle of {} (ISO 5753-1)", group);
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

/// A clearance group that stands anywhere in a suffix ("-2RSC3", "ECP/C3"), taken out of it.
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

class Sets {
 public:
  void real(std::string_view name, double value) {
    list_.emplace_back(name, fmt::format("{}", value));
  }
  /// A length, to a tenth of a micrometre.
  void length(std::string_view name, double value) { real(name, std::round(value * 1e7) / 1e7); }
  void whole(std::string_view name, long long value) {
    list_.emplace_back(name, fmt::format("{}", value));
  }
  std::vector<std::pair<std::string, std::string>> take() { return std::move(list_); }

 private:
  std::vector<std::pair<std::string, std::string>> list_;
};

/// Elements side by side on the pitch circle when `share` of the circle is theirs.
long long elements_that_fit(double diameter, double pitch, double share) {
  return static_cast<long long>(
      std::floor(share * std::numbers::pi / std::asin(diameter / pitch) + 1e-9));
}

InnerGeometry balls(BearingType type, const Envelope& e, double angle, std::string_view group) {
  constexpr double kInch32 = 0.0254 / 32.0, kSection = 0.30, kShoulder = 0.54;
  const double pitch = 0.5 * (e.bore + e.outside);
  const double ball = nearest(kSection * (e.outside - e.bore), kInch32);
  const bool deep = type == BearingType::DeepGroove;
  // A deep groove bearing is filled through the gap of rings laid against each other: its balls
  // cover 195 degrees then. A split cage leaves a tenth of the circle in the other type.
  constexpr double kFilled = 195.0 / 2.0;
  const long long count =
      deep ? static_cast<long long>(std::floor(kFilled * kDegree / std::asin(ball / pitch))) + 1
           : elements_that_fit(ball, pitch, 0.9);
  Sets sets;
  sets.whole("nRe", count);
  sets.real("bReDia", ball);
  sets.length("pitchDia", pitch);
  sets.real("freeConAng", deep ? 0.0 : angle);
  sets.length("freeIntCls", deep ? middle_clearance(type, group, e.bore) : 0.0);
  sets.real("raceCurFac1", deep ? 0.525 : 0.5232);
  sets.real("raceCurFac2", deep ? 0.515 : 0.5232);
  sets.length("shoulderDia1", pitch + kShoulder * ball);
  sets.length("shoulderDia2", pitch - kShoulder * ball);
  return {
      sets.take(),
      fmt::format(
          "D = 0.30 (OD - bore) to 1/32 in, {}, f and shoulders as in the {} example{}",
          deep ? "as many balls as eccentric filling allows" : "balls over 0.9 of the pitch circle",
          deep ? "6205" : "218", deep ? ", clearance: " + clearance_reason(group) : "")};
}

InnerGeometry cylinders(const Envelope& e, std::string_view group) {
  const double pitch = 0.5 * (e.bore + e.outside);
  const double roller = nearest(0.25 * (e.outside - e.bore), 0.5 * kMm);
  const double length = std::min(roller, nearest(0.6 * e.width, 0.5 * kMm));
  Sets sets;
  sets.whole("nRe", elements_that_fit(roller, pitch, 0.7));
  sets.length("bReDia", roller);
  sets.real("bReCrn", std::round(200.0 * length * 1e3) / 1e3);
  sets.length("bReLen", length);
  sets.length("bReCenLen", 0.6 * length);
  sets.length("bReCorRad1", 0.02 * roller);
  sets.length("bReCorRad2", 0.02 * roller);
  sets.length("pitchDia", pitch);
  sets.length("freeIntCls", middle_clearance(BearingType::Cylindrical, group, e.bore));
  sets.length("raceLandLmt1", length);
  sets.length("raceLandLmt2", 1.2 * length);
  sets.length("flngHt11", 0.2 * roller);
  sets.length("flngHt21", 0.2 * roller);
  return {
      sets.take(),
      "D = L = 0.25 (OD - bore), rollers over 0.7 of the pitch circle as in the textbooks' 209; "
      "crown and flanges typical, play: " +
          clearance_reason(group)};
}

InnerGeometry cones(const Envelope& e, double cup) {
  const double pitch = 0.5 * (e.bore + e.outside);
  const double roller = nearest(0.245 * (e.outside - e.bore), 0.1 * kMm);
  const double length = nearest(0.75 * e.width, 0.5 * kMm);
  // Both cones share their apex: D / dm = sin h / sin m with m = cup - h, h half the taper.
  const double ratio = roller / pitch, alpha = cup * kDegree;
  const double half = std::atan2(ratio * std::sin(alpha), 1.0 + ratio * std::cos(alpha));
  const double to_apex = 0.5 * pitch / std::sin(alpha - half);
  Sets sets;
  sets.whole("nRe", elements_that_fit(roller, pitch, 0.9));
  sets.length("bReDia", roller);
  sets.real("bReCrn", std::round(8.0 * std::pow(length / 0.0135, 2) * 100.0) / 100.0);
  sets.length("bReLen", length);
  sets.length("bReCenLen", length * 2.0 / 3.0);
  sets.length("bReEndRad1", std::round(0.76 * to_apex * 1e3) / 1e3);
  sets.length("bReEndRad2", std::round(0.76 * to_apex * 1e3) / 1e3);
  sets.length("bReCorRad1", 0.04 * roller);
  sets.length("bReCorRad2", 0.04 * roller);
  sets.real("raceTaper1", cup);
  sets.real("raceTaper2", std::round((cup - 2.0 * half / kDegree) * 1e4) / 1e4);
  sets.length("raceLandLmt1", length);
  sets.length("raceLandLmt2", length);
  sets.length("flngHt12", 0.255 * roller);
  return {
      sets.take(),
      "D = 0.245 (OD - bore), L = 0.75 of the cone width, rollers over 0.9 of the pitch circle; "
      "the cone angle follows from the cup's, crown and rib typical"};
}

InnerGeometry barrels(const Envelope& e, double angle, std::string_view group) {
  const double pitch = 0.502 * (e.bore + e.outside);
  const double roller = nearest(0.275 * (e.outside - e.bore), 0.1 * kMm);
  const double sphere =
      0.5 * pitch / std::cos(angle * kDegree) + 0.5 * roller;  // of the outer race
  Sets sets;
  sets.whole("nRe", elements_that_fit(roller, pitch, 0.87));
  sets.length("bReDia", roller);
  sets.length("bReCrn", 0.961 * sphere);
  sets.length("bReLen", nearest(0.413 * e.width, 0.1 * kMm));
  sets.length("bReCorRad1", 0.036 * roller);
  sets.length("bReCorRad2", 0.036 * roller);
  sets.length("pitchDia", pitch);
  sets.length("freeIntCls", middle_clearance(BearingType::Spherical, group, e.bore));
  sets.real("raceCurFac1", 0.5133);
  sets.real("raceCurFac2", 0.5133);
  sets.real("freeConAng", std::round(angle * 100.0) / 100.0);
  return {sets.take(),
          "D = 0.275 (OD - bore), L = 0.413 of the width, rollers over 0.87 of the pitch circle, "
          "angle from the distance of the rows; play: " +
              clearance_reason(group)};
}

/// Record 7.1 in proportion to the cage of the example of the type: diameters about the pitch
/// circle, width with the elements, plays with their diameter. Estimates, as all of the inside.
void propose_cage(std::string_view example_name, const Envelope& e, double diameter, double length,
                  double cone_angle, Sets& sets) {
  const Deck example = new_deck(example_name);
  const auto of = [&](std::string_view name) { return example.real(name); };
  const bool balls = !example.has("bReLen");
  const double pitch = 0.5 * (e.bore + e.outside),
               pitch_there = 0.5 * (of("brgBore") + of("brgOD"));
  const double size = diameter / of("bReDia");
  for (const char* name : {"cageDia1", "cageDia2"})
    sets.length(name, pitch + (of(name) - pitch_there) * size);
  sets.length("cageWidth", of("cageWidth") * (balls ? size : length / of("bReLen")));
  for (const char* name : {"cageCls1", "cageCls2", "bPocCls1", "bPocCls2"})
    sets.length(name, of(name) * size);
  sets.real("cageConeAng", cone_angle);
}

double real(const std::string& text) {
  double value = 0.0;
  demand(!parse_real(text, value), "what was proposed is a number");
  return value;
}

double number(const InnerGeometry& inner, std::string_view name) {
  for (const auto& [variable, value] : inner.sets)
    if (variable == name) return real(value);
  return 0.0;
}

/// Capacity in proportion to that of other bearings of its type: the exponents of ISO 281.
double capacity(BearingType type, const InnerGeometry& inner) {
  const double count = number(inner, "nRe"), diameter = number(inner, "bReDia");
  const bool ball = type == BearingType::DeepGroove || type == BearingType::AngularContact;
  return ball ? std::pow(count, 2.0 / 3.0) * std::pow(diameter, 1.8)
              : std::pow(count, 3.0 / 4.0) * std::pow(number(inner, "bReLen"), 7.0 / 9.0) *
                    std::pow(diameter, 29.0 / 27.0);
}

double two_digits(double value) {
  if (value == 0.0) return 0.0;
  const double scale = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
  return std::round(value / scale) * scale;
}

std::string read(const Deck& deck, std::string_view name) {
  return fmt::format("{}", deck.real(name));
}

/// Boundary, inside, load and speed of the deck of a type.
std::vector<std::pair<std::string, std::string>> changes(const CatalogueBearing& bearing,
                                                         const InnerGeometry& inner,
                                                         const Deck& example) {
  const Envelope& e = bearing.envelope;
  auto sets = inner.sets;
  const auto set = [&](const char* name, double value) {
    sets.emplace_back(name, fmt::format("{}", std::round(value * 1e7) / 1e7));
  };
  sets.emplace_back("runID", bearing.designation);
  const bool row = bearing.type == BearingType::Spherical;
  set("brgBore", e.bore);
  set("brgOD", e.outside);
  set("hsngOD", e.outside + std::max(0.028, 0.35 * e.outside));
  set("raceWidth1", row ? 0.5 * e.width : e.cup_width);
  set("raceWidth2", row ? 0.5 * e.width : e.width);
  InnerGeometry there;  // the example's own elements
  there.sets = {{"nRe", fmt::format("{}", example.integer("nRe"))},
                {"bReDia", read(example, "bReDia")}};
  if (example.has("bReLen")) there.sets.emplace_back("bReLen", read(example, "bReLen"));
  const double load = capacity(bearing.type, inner) / capacity(bearing.type, there);
  for (const char* name : {"appLoadX", "appLoadY", "appLoadZ"})
    if (example.has(name) && example.real(name) != 0.0)
      set(name, two_digits(example.real(name) * load));
  const double size = (example.real("brgBore") + example.real("brgOD")) / (e.bore + e.outside);
  set("rpm2", two_digits(example.real("rpm2") * size));
  return sets;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out{""};
  for (const char c : text)
    if (c == '\n')
      out.emplace_back();
    else
      out.back() += c;
  if (out.back().empty()) out.pop_back();
  return out;
}

}  // namespace

CatalogueBearing find_bearing(std::string_view designation) {
  if (std::optional<CatalogueBearing> sized = find_by_size(designation)) return *sized;
  const std::string maker = makers_name(designation);
  const std::string text = squeezed(designation.substr(maker.size()));
  for (const Series& series : kSeries) {
    if (!text.starts_with(series.prefix)) continue;
    const std::string_view rest = std::string_view(text).substr(series.prefix.size());
    if (rest.size() < 2 || std::isdigit(static_cast<unsigned char>(rest[0])) == 0 ||
        std::isdigit(static_cast<unsigned char>(rest[1])) == 0)
      continue;
    if (rest.size() > 2 && std::isdigit(static_cast<unsigned char>(rest[2])) != 0) continue;
    for (const Json& row : rows_of(series)) {
      const double bore = row[0].get<double>();
      if (!offered(series, bore) || bore_code(bore) != rest.substr(0, 2)) continue;
      CatalogueBearing out;
      out.type = series.type;
      out.envelope = {bore * kMm, row[1].get<double>() * kMm, row[2].get<double>() * kMm,
                      row[2].get<double>() * kMm};
      out.designation = std::string(series.prefix) + bore_code(bore);
      std::string suffix(rest.substr(2));
      // First: the "C3" of "7208 C3" is no angle.
      std::string group = take_group(suffix);
      if (series.type == BearingType::AngularContact) take_angle(out, suffix, designation);
      if (has_group(out.type, group))
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
        out.angle = usual_angle(series.type, out.envelope);
      return out;
    }
    fail(designation, "is no size of the series " + std::string(series.prefix) + " known here");
  }
  fail(designation, "is not in the catalogue");
}

std::vector<std::string> catalogue_designations() {
  std::vector<std::string> out;
  for (const Series& series : kSeries)
    for (const Json& row : rows_of(series))
      if (offered(series, row[0].get<double>())) {
        const std::string name = std::string(series.prefix) + bore_code(row[0].get<double>());
        if (series.type != BearingType::AngularContact)
          out.push_back(name);
        else
          for (const char* angle : {" C", " AC", " B"}) out.push_back(name + angle);
      }
  return out;
}

InnerGeometry propose_inner(BearingType type, const Envelope& envelope, double angle,
                            std::string_view group) {
  const double section = envelope.outside - envelope.bore;
  if (!(envelope.bore > 0.0 && section > 0.0 && envelope.width > 0.0))
    throw InputError(fmt::format(
        "no elements fit: bore {} m, outside diameter {} m, width {} m; the bore must be above 0 "
        "and below the outside diameter, the width above 0",
        envelope.bore, envelope.outside, envelope.width));
  switch (type) {
    case BearingType::Cylindrical:
      return cylinders(envelope, group);
    case BearingType::Tapered:
      return cones(envelope, angle > 0.0 ? angle : usual_angle(type, envelope));
    case BearingType::Spherical:
      return barrels(envelope, angle > 0.0 ? angle : usual_angle(type, envelope), group);
    default:
      return balls(type, envelope, angle > 0.0 ? angle : usual_angle(type, envelope), group);
  }
}

InnerGeometry propose_inner(const Deck& deck) {
  const long long kind = deck.integer("kBrg");
  if (kind < 1 || kind > 4)
    throw InputError(
        fmt::format("kBrg = {}: an inside is proposed for ball, cylindrical, spherical and tapered "
                    "bearings (1 to 4)",
                    kind));
  constexpr std::array<BearingType, 4> kOfCode = {BearingType::DeepGroove, BearingType::Cylindrical,
                                                  BearingType::Spherical, BearingType::Tapered};
  BearingType type = kOfCode.at(static_cast<std::size_t>(kind - 1));
  const double angle = kind == 4   ? deck.real("raceTaper1")
                       : kind == 2 ? 0.0
                                   : deck.real("freeConAng");
  if (kind == 1 && angle != 0.0) type = BearingType::AngularContact;
  Envelope envelope{deck.si("brgBore"), deck.si("brgOD"), deck.si("raceWidth2"),
                    deck.si("raceWidth1")};
  if (kind == 3) envelope.width *= 2.0;  // of both rows
  InnerGeometry out = propose_inner(type, envelope, angle);
  if (deck.integer("nCseg") == 1) {
    constexpr std::array<std::string_view, 4> kExamples = {"ball", "cylindrical", "spherical",
                                                           "tapered"};
    const double cone =
        kind == 4 ? 0.5 * (number(out, "raceTaper1") + number(out, "raceTaper2")) : 0.0;
    Sets cage;
    propose_cage(kExamples.at(static_cast<std::size_t>(kind - 1)), envelope, number(out, "bReDia"),
                 number(out, "bReLen"), cone, cage);
    for (auto& set : cage.take()) out.sets.push_back(std::move(set));
    out.reasons += "; cage (record 7.1) in proportion to that of the example of this type";
  }
  std::erase_if(out.sets, [&](const auto& set) { return !deck.has(set.first); });
  if (deck.units() == UnitSystem::SI) return out;
  for (auto& [name, value] : out.sets) {
    const VariableRef ref = find_present(deck, name);
    if (ref.spec().type == VarType::Real)
      value = fmt::format(
          "{}", convert_value(real(value), ref.spec().unit, UnitSystem::SI, UnitSystem::English));
  }
  return out;
}

std::string catalogue_deck(const CatalogueBearing& bearing) {
  const TypeInfo& info = info_of(bearing.type);
  const std::string text(template_text(info.template_name));
  const Deck example = read_deck_text(text, "example").deck;
  const InnerGeometry inner =
      propose_inner(bearing.type, bearing.envelope, bearing.angle, bearing.clearance);
  Deck deck = example;
  deck.set_all(changes(bearing, inner, example));
  const bool standard = bearing.designation.find('x') == std::string::npos;
  const std::string outside =
      standard ? fmt::format("boundary dimensions of {}: {}", bearing.designation,
                             bearing.type == BearingType::Tapered ? "ISO 355" : "ISO 15")
               : std::string("boundary dimensions as given");
  const std::vector<std::string> lines = lines_of(with_deck(text, deck).text);
  demand(lines.size() == deck.records.size(), "an example has a record a line");
  std::string out;
  for (std::size_t r = 0; r < lines.size(); ++r) {
    const std::string& id = deck.records[r].id;
    std::string remark;
    if (id == "4")
      remark = std::string(kCatalogueOutside) + " [m]: " + outside;
    else if (id == "3.1")
      remark = "name of the run";
    else if (id == "5A" || id == "5B.1" || id == "5C" || id == "5D.1")
      remark = "ESTIMATE of the inside: " + inner.reasons;
    else if (id == "5B.2" || id == "5D.2" || id == "5F")
      remark = "ESTIMATE of the inside";
    else if (id == "9.1.1")
      remark =
          "forces on the inner race, displacements [N, m]: those of the example, by the "
          "capacity of this size; put in your own" +
          std::string(bearing.type == BearingType::Spherical
                          ? ", of one row: half of the bearing's radial load"
                          : "");
    else if (id == "9.1.2")
      remark =
          "moments, misalignments, speeds of outer and inner race [N.m, rad, rpm]: put in your own";
    if (remark.empty()) {
      out += lines[r] + "\n";
      continue;
    }
    Deck alone;
    alone.records.push_back(deck.records[r]);
    std::string line = write_deck(alone);
    line.pop_back();
    out += line + "   " + remark + "\n";
  }
  return out;
}

std::vector<std::string> catalogue_story(const CatalogueBearing& bearing) {
  const Envelope& e = bearing.envelope;
  const InnerGeometry inner = propose_inner(bearing.type, e, bearing.angle, bearing.clearance);
  std::vector<std::string> out;
  const bool standard = bearing.designation.find('x') == std::string::npos;
  out.push_back(fmt::format("{}, {}: bore {:g} mm, outside diameter {:g} mm, width {:g} mm ({}).",
                            bearing.designation, info_of(bearing.type).name, e.bore / kMm,
                            e.outside / kMm, e.width / kMm,
                            !standard                              ? "as given"
                            : bearing.type == BearingType::Tapered ? "ISO 355"
                                                                   : "ISO 15"));
  if (bearing.angle != 0.0)
    out.push_back(fmt::format(
        "{} {:.4g} degrees ({}).",
        bearing.type == BearingType::Tapered ? "Cup half angle" : "Contact angle", bearing.angle,
        bearing.type == BearingType::Tapered && bearing.angle_given ? "ISO 355"
        : bearing.angle_given                                       ? "by the designation"
        : bearing.type == BearingType::AngularContact ? "for want of a suffix; C is 15, AC 25, B 40"
                                                      : "an estimate"));
  out.push_back(
      fmt::format("Inside, an ESTIMATE, since makers do not publish it: {} elements of {:.4g} mm "
                  "on {:.4g} mm; {}.",
                  number(inner, "nRe"), number(inner, "bReDia") / kMm,
                  0.5 * (e.bore + e.outside) / kMm, inner.reasons));
  if (!bearing.left_out.empty())
    out.push_back(
        fmt::format("Not in the deck: {}. Of a designation, size, contact angle and the "
                    "clearance group of deep groove, cylindrical and spherical bearings "
                    "go into it.",
                    bearing.left_out));
  if (bearing.tapered_bore)
    out.push_back(
        fmt::format("A tapered bore (K) has clearance groups of its own, which are not known here: "
                    "the clearance is that of {} for cylindrical bores.",
                    bearing.clearance));
  if (bearing.type == BearingType::Spherical)
    out.emplace_back(
        "The deck is ONE row of the two: give it half of the bearing's radial load; the bearing's "
        "life is below that of a row.");
  out.emplace_back(
      "Load and speed are those of the example of this type, in proportion: put in your own. The "
      "deck is quasi-static (mode -1); mode 0 moves every element over time.");
  return out;
}

}  // namespace adore::deck

#include "deck/rated_bearings.hpp"

#include "base/errors.hpp"
#include "deck/catalogue_parts.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

namespace adore::deck {
namespace {

using Json = nlohmann::json;

struct TypeWords {
  RatedBearingType type;
  std::string_view word, name;
};
constexpr std::array<TypeWords, 6> kTypeWords = {
    {{RatedBearingType::FourPoint, "four-point", "four-point contact ball bearing"},
     {RatedBearingType::DoubleAngular, "double-angular", "double-row angular contact ball bearing"},
     {RatedBearingType::SelfAligning, "self-aligning", "self-aligning ball bearing"},
     {RatedBearingType::Needle, "needle", "needle roller bearing"},
     {RatedBearingType::ThrustBall, "thrust-ball", "thrust ball bearing"},
     {RatedBearingType::ThrustRoller, "thrust-roller", "thrust cylindrical roller bearing"}}};

RatedBearingType type_of(const std::string& word) {
  for (const TypeWords& one : kTypeWords)
    if (one.word == word) return one.type;
  throw InternalError("catalogue.json: a series with load ratings has an unknown bearing type: " +
                      word);
}

const Json& rows_of(const Json& series) {
  return series.contains("rows")
             ? series.at("rows")
             : catalogue_table().at("series").at(series.at("dimensions").get<std::string>());
}

bool is_offered(const Json& series, double bore) {
  constexpr double kAny = 1e9;
  return bore >= series.value("least", 10.0) && bore <= series.value("most", kAny);
}

/// "05" for 25 mm.
std::string bore_digits(double bore) {
  constexpr std::array<double, 4> kSmallBores = {10.0, 12.0, 15.0, 17.0};
  for (std::size_t k = 0; k < kSmallBores.size(); ++k)
    if (kSmallBores.at(k) == bore) return fmt::format("0{}", k);
  return fmt::format("{:02d}", static_cast<int>(std::lround(bore / 5.0)));
}

double to_step(double value, double step) {
  return std::max(step, std::round(value / step) * step);
}

long long that_fit(double diameter, double pitch, double share) {
  return static_cast<long long>(
      std::floor(share * std::numbers::pi / std::asin(diameter / pitch) + 1e-9));
}

RatedBearing bearing_of(const Json& series, const Json& row) {
  constexpr double kInch32 = 25.4 / 32.0, kHalf = 0.5;
  const double d = row.at(0), D = row.at(1), B = row.at(2), section = D - d;
  const double share = series.at("diameter_share"), fill = series.at("fill"),
               length = series.at("length_share");
  RatedBearing out;
  out.designation = series.at("prefix").get<std::string>() + bore_digits(d);
  out.type = type_of(series.at("type"));
  out.envelope = {d * kMm, D * kMm, B * kMm, B * kMm};
  out.angle = series.at("angle");
  out.source = series.at("source");
  out.rows = out.type == RatedBearingType::FourPoint ||
                     out.type == RatedBearingType::DoubleAngular ||
                     out.type == RatedBearingType::SelfAligning
                 ? 2
                 : 1;
  double pitch = 0.5 * (d + D), diameter = 0.0;
  switch (out.type) {
    case RatedBearingType::Needle:
      diameter = to_step(share * section, kHalf);
      pitch = d + 0.3 * section + diameter;  // inner ring: 0.3 of the section
      out.length = length * B * kMm;
      break;
    case RatedBearingType::ThrustRoller:
      diameter = to_step(share * B, kHalf);
      out.length = 0.5 * length * section * kMm;
      break;
    default:
      diameter = to_step(share * section, kInch32);
  }
  // Rows a quarter of the width from the middle.
  if (out.type == RatedBearingType::SelfAligning)
    out.angle = std::atan(0.25 * B / (0.5 * pitch)) / kDegree;
  out.count = that_fit(diameter, pitch, fill);
  out.diameter = diameter * kMm;
  out.pitch = pitch * kMm;
  return out;
}

std::string letters_and_digits(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

std::string_view rated_bearing_type_name(RatedBearingType type) {
  return std::find_if(kTypeWords.begin(), kTypeWords.end(),
                      [&](const TypeWords& one) { return one.type == type; })
      ->name;
}

std::vector<RatedBearing> rated_bearings() {
  std::vector<RatedBearing> out;
  for (const Json& series : catalogue_table().at("rated"))
    for (const Json& row : rows_of(series))
      if (is_offered(series, row.at(0))) out.push_back(bearing_of(series, row));
  return out;
}

std::optional<RatedBearing> find_rated_bearing(std::string_view designation) {
  const std::string text = letters_and_digits(designation);
  for (const Json& series : catalogue_table().at("rated")) {
    const auto& prefix = series.at("prefix").get_ref<const std::string&>();
    if (!text.starts_with(prefix)) continue;
    const std::string rest = text.substr(prefix.size());
    for (const Json& row : rows_of(series)) {
      const double bore = row.at(0);
      if (!is_offered(series, bore)) continue;
      const std::string digits = bore_digits(bore);
      // A further digit is of another series: 320 08 is not 32 00.
      if (rest.starts_with(digits) &&
          (rest.size() == digits.size() || std::isdigit(static_cast<unsigned char>(rest[2])) == 0))
        return bearing_of(series, row);
    }
  }
  return std::nullopt;
}

}  // namespace adore::deck

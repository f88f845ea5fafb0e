#include "adrplot/known_values.hpp"

#include "adrplot/run_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::adrplot {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfiniteLife = 9.9e30;
constexpr double kNoSpin = 1e-9;  ///< smaller spin-to-roll ratios are rounding of angles

bool zero(const std::vector<double>& values) {
  return !values.empty() &&
         std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0; });
}

const std::string kTotalHeat = "thermal.total_heat", kCoolantHeat = "thermal.coolant_heat";
constexpr std::string_view kCoolant = "thermal.coolant_";

bool is_heat(const std::string& id) { return id.starts_with("thermal.") && id.ends_with("_heat"); }

bool is_wear(const std::string& id) { return id.find("wear_rate") != std::string::npos; }

/// Does it change by more than the digits of a file do?
bool varies(const std::vector<double>& values) {
  constexpr double kDigits = 1e-6;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return low != values.end() && *high - *low > kDigits * std::max(std::abs(*low), std::abs(*high));
}

/// "element.radial_velocity", "_position" -> "element.radial_position"; others unchanged.
std::string instead(const std::string& id, std::string_view of, std::string_view other) {
  const std::size_t at = id.find(of);
  return at == std::string::npos ? id : std::string(id).replace(at, of.size(), other);
}
constexpr std::string_view kPosition = "_position", kVelocity = "_velocity",
                           kAcceleration = "_acceleration";
/// Rate of a coordinate.
bool is_rate(const std::string& id) {
  return id.find("angular") == std::string::npos &&
         (id.find(kVelocity) != std::string::npos || id.find(kAcceleration) != std::string::npos);
}
std::vector<std::string> places_of(const std::string& id) {
  const std::string velocity = instead(id, kAcceleration, kVelocity);
  return {velocity, instead(velocity, kVelocity, kPosition)};
}

const std::vector<std::string> kOrientation{"element.theta", "element.phi", "element.rotation"};
const std::string kTurning = "element.angular_velocity";

/// "contact.angle.outer" and "contact.angle" -> ".outer"
std::string behind(const std::string& id, std::string_view channel) {
  return id.substr(channel.size());
}

}  // namespace

ValidColumns::ValidColumns(const results::SolFile& file)
    : file_(file), columns_(results::sol_columns(file.header)) {
  for (std::size_t i = 0; i < columns_.size(); ++i) column_index_.emplace(columns_[i].id, i);
}

std::size_t ValidColumns::find(const std::string& id) const {
  const auto found = column_index_.find(id);
  return found == column_index_.end() ? columns_.size() : found->second;
}

std::vector<double> ValidColumns::stored(const std::string& id) const {
  const std::size_t column = find(id);
  const std::size_t index = column < columns_.size() ? file_.place(column) : std::string::npos;
  std::vector<double> out;
  out.reserve(file_.steps.size());
  for (const auto& step : file_.steps)
    out.push_back(index < step.values.size() ? step.values[index] : kNone);
  return out;
}

bool ValidColumns::is_always_zero(const std::string& id) const {
  return has(id) && zero(stored(id));
}

std::string ValidColumns::unit(const std::string& id) const {
  const std::size_t index = find(id);
  return index < columns_.size() ? results::unit_of_column(file_, columns_[index]) : "";
}

std::vector<std::string> ValidColumns::required_columns(const std::string& id) {
  for (const std::string_view channel :
       {"contact.angle.", "contact.spin_to_roll.", "contact.slip."})
    if (id.starts_with(channel)) return {"contact.load." + id.substr(channel.size())};
  for (const std::string land : {"cage.land1", "cage.land2"})
    if (id.starts_with(land + "_"))
      return {land + "_force", land + "_gap", land + "_angle", "cage.y_over_clearance",
              "cage.z_over_clearance"};
  if (id.starts_with("pocket.position.")) return {"pocket.force" + behind(id, "pocket.position")};
  if (id.starts_with("flange."))
    return {"flange.gap" + id.substr(id.find('.', std::string("flange.").size()))};
  if (is_wear(id))
    return {"power.element1_wear_rate", "race.wear_rate.outer", "race.wear_rate.inner",
            "power.cage_wear_rate"};
  if (is_rate(id)) return places_of(id);
  if (std::find(kOrientation.begin(), kOrientation.end(), id) != kOrientation.end()) {
    std::vector<std::string> out = kOrientation;
    out.push_back(kTurning);
    return out;
  }
  if (is_heat(id) || id.starts_with(kCoolant)) return {kTotalHeat, kCoolantHeat};
  return {};
}

ValidValues ValidColumns::values(const std::string& id) const {
  ValidValues out{stored(id), unit(id), {}};
  const auto nothing = [&out](std::string why) {
    std::fill(out.values.begin(), out.values.end(), kNone);
    out.why_none = std::move(why);
  };
  const auto drop = [&out](const std::vector<double>& where, auto absent) {  // is any gone now?
    bool dropped = false;
    for (std::size_t i = 0; i < std::min(where.size(), out.values.size()); ++i)
      if (absent(where[i])) {
        dropped = dropped || std::isfinite(out.values[i]);
        out.values[i] = kNone;
      }
    return dropped;
  };
  // A part of the file does not represent the whole run.
  const std::string here = file_.part ? "at these steps" : "in this run";
  const auto is_zero = [](double v) { return v == 0.0; };
  const auto is = [&id](std::string_view channel) { return id.starts_with(channel); };
  if (is("contact.film.")) {
    if (zero(out.values))
      nothing(file_.part ? "No film was computed at these steps."
                         : "No film was computed: the traction law does not use a film.");
  } else if (is("contact.temperature_rise.")) {
    if (zero(out.values)) nothing("Contact temperature rise was not computed " + here + ".");
  } else if (id == "power.churning_fraction") {
    if (zero(out.values)) nothing("Churning was not computed " + here + ".");
  } else if (is("contact.angle.") || is("contact.spin_to_roll.") || is("contact.slip.")) {
    bool open = false;
    for (const std::string_view channel : {"contact.angle", "contact.spin_to_roll", "contact.slip"})
      if (is(std::string(channel) + ".") && has("contact.load" + behind(id, channel)))
        open = drop(stored("contact.load" + behind(id, channel)), is_zero);
    const bool some = std::any_of(out.values.begin(), out.values.end(),
                                  [](double v) { return std::isfinite(v); });
    if (open && some) out.why_gaps = "no contact";
    if (open && !some)
      nothing(file_.part ? "No contact at these steps." : "No contact in this run.");
    // A roller aligned with its races turns about its axis only.
    if (is("contact.spin_to_roll.") &&
        std::any_of(out.values.begin(), out.values.end(),
                    [](double v) { return std::isfinite(v); }) &&
        std::all_of(out.values.begin(), out.values.end(),
                    [](double v) { return !(std::abs(v) > kNoSpin); }))
      nothing(fmt::format("No spin in this contact{}: the stored values are rounding errors.",
                          file_.part ? " " + here : ""));
  } else if (is("cage.land1_") || is("cage.land2_")) {
    const std::string land = id.substr(0, std::string("cage.land1").size());
    if (is_always_zero(land + "_force") && is_always_zero(land + "_gap") &&
        is_always_zero(land + "_angle"))
      nothing(fmt::format("This cage has no guide land {}.", land.back()));
    else if (id.ends_with("_angle")) {  // a cage in the middle is nowhere nearest
      const std::vector<double> y = stored("cage.y_over_clearance"),
                                z = stored("cage.z_over_clearance");
      for (std::size_t i = 0;
           i < out.values.size() && out.values[i] == 0.0 && y[i] == 0.0 && z[i] == 0.0; ++i)
        out.values[i] = kNone;
    }
  } else if (is("pocket.position.")) {
    // For a roller parallel to a wall the nearest point is determined by rounding.
    if (drop(stored("pocket.force" + behind(id, "pocket.position")), is_zero))
      out.why_gaps = "no contact";
    constexpr double kMiddle = 1e-9;  // along a roller: rounding
    for (double& v : out.values)
      if (std::abs(v) < kMiddle) v = 0.0;
    if (std::none_of(out.values.begin(), out.values.end(),
                     [](double v) { return std::isfinite(v); }))
      nothing(file_.part ? "The roller did not touch this pocket wall at these steps."
                         : "The roller did not touch this pocket wall.");
  } else if (is("flange.")) {
    const std::string where = id.substr(id.find('.', std::string("flange.").size()));
    if (is_always_zero("flange.gap" + where))
      nothing(missing_flange_reason(where, {}, file_.part));
    else if (is("flange.gap."))
      drop(stored(id), is_zero);
  } else if (id == "power.life") {
    if (zero(out.values)) nothing("No life model was active " + here + ".");
    const bool infinite = std::any_of(out.values.begin(), out.values.end(),
                                      [](double v) { return v >= kInfiniteLife; });
    drop(stored(id), [](double v) { return v == 0.0 || v >= kInfiniteLife; });
    if (infinite && std::none_of(out.values.begin(), out.values.end(),
                                 [](double v) { return std::isfinite(v); }))
      nothing(file_.part ? "The life is infinite at these steps." : "The life is infinite.");
  } else if (is_heat(id) || is(kCoolant)) {
    const bool none = is_always_zero(kTotalHeat);
    if (!none && is(kCoolant) && is_always_zero(kCoolantHeat))
      nothing("No coolant flow " + here + ": all heat flows through the races.");
    else if (is_heat(id)) {  // an average over a thermal step that has ended
      const std::vector<double> total = stored(kTotalHeat);
      for (std::size_t i = 0; i < out.values.size() && total[i] == 0.0; ++i) out.values[i] = kNone;
      if (none) nothing("No thermal step was completed " + here + ".");
    }
  } else if (is_rate(id)) {
    const auto places = places_of(id);
    if (zero(out.values) && std::any_of(places.begin(), places.end(), [&](const auto& place) {
          return has(place) && varies(stored(place));
        }))
      nothing("Not computed " + here + ": the position results from a force balance.");
  } else if (std::find(kOrientation.begin(), kOrientation.end(), id) != kOrientation.end()) {
    if (std::all_of(kOrientation.begin(), kOrientation.end(),
                    [&](const auto& angle) { return is_always_zero(angle); }) &&
        !is_always_zero(kTurning))
      nothing("The orientation was not integrated " + here + ".");
  } else if (is_wear(id)) {  // also "race.wear_rate.inner"
    bool none = true;
    for (const results::SolColumn& column : columns_)
      none = none && (!is_wear(column.id) || is_always_zero(column.id));
    if (none) nothing("Wear was not computed " + here + ", or the wear coefficients are 0.");
    for (std::size_t i = 0; i < out.values.size() && !(file_.steps[i].time > 0.0); ++i)
      out.values[i] = kNone;
  }
  return out;
}

}  // namespace adore::adrplot

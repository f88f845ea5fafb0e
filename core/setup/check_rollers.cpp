#include "setup/check_rollers.hpp"

#include "contact/roller_profile.hpp"
#include "contact/roller_shape.hpp"
#include "setup/deck_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace adore::setup {
namespace {

using bearing::RollerDeviation;
using bearing::RollerGeometry;
using contact::RollerProfile;
using deck::Deck;

bool fits(const RollerProfile& profile) {
  try {
    contact::check_roller_profile(profile);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

using Field = std::function<double&(RollerProfile&)>;

/// The value between `bad`, which does not fit, and `good`, which does, where that changes.
double limit_between(RollerProfile profile, const Field& field, double bad, double good) {
  for (int n = 0; n < 30; ++n) {  // more digits than a message shows
    const double middle = 0.5 * (bad + good);
    field(profile) = middle;
    (fits(profile) ? good : bad) = middle;
  }
  return good;
}

/// The smallest positive value above `bad` that fits.
std::optional<double> smallest_above(RollerProfile profile, const Field& field, double bad) {
  constexpr double kMinTried = 1e-9, kMaxTried = 1e8;  // m
  for (double good = std::max(2.0 * bad, kMinTried); good < kMaxTried; good *= 2.0) {
    field(profile) = good;
    if (fits(profile)) return limit_between(profile, field, 0.5 * good, good);
  }
  return std::nullopt;
}

class ShapeCheck {
 public:
  ShapeCheck(const Deck& deck, const RollerProfile& given)
      : deck_(deck), given_(given), shape_(given) {
    shape_.crown_radius = 1e10;
    shape_.corner_radius = shape_.end_radius = {};
  }

  /// Puts the given value into the shape that fits so far; takes it out again if it does not.
  void put(const std::string& variable, const char* what, const Field& field, bool more) {
    const double value = field(given_);
    const double before = std::exchange(field(shape_), value);
    if (fits(shape_)) return;
    const std::optional<double> limit =
        more ? smallest_above(shape_, field, value) : limit_between(shape_, field, value, before);
    field(shape_) = before;
    const std::string size =
        fmt::format("a roller {} in diameter and {} long", length_text(deck_, given_.diameter),
                    length_text(deck_, given_.length));
    issues_.push_back(deck_.issue(
        Severity::Error, variable, fmt::format("{} cannot have this {}", size, what),
        limit ? fmt::format("give {} than {}", more ? "more" : "less", length_text(deck_, *limit))
              : "check bReDia, bReLen and the other radii of the roller"));
  }

  /// The bare cone: does it end before its length does?
  void check_length() {
    if (fits(shape_)) return;
    const Field length = [](RollerProfile& p) -> double& { return p.length; };
    const double limit = limit_between(shape_, length, given_.length, 1e-9 * given_.length);
    issues_.push_back(
        deck_.issue(Severity::Error, "bReLen",
                    "the taper makes the roller diameter zero before the end of the roller",
                    fmt::format("give less than {}, or give cone angles with a smaller difference",
                                length_text(deck_, limit))));
    finish();
  }

  void finish() {
    if (!issues_.empty()) throw InputError(std::move(issues_));
  }

 private:
  const Deck& deck_;
  RollerProfile given_, shape_;
  std::vector<Issue> issues_;
};

/// The variable of the deviation without which the roller would be one; the diameter's if no single
/// one is to blame.
std::string culprit(const Deck& deck, const RollerGeometry& rollers, std::size_t k) {
  constexpr std::pair<double RollerDeviation::*, const char*> kParts[] = {
      {&RollerDeviation::crown_radius, "reCrnVar"},
      {&RollerDeviation::length, "reLenVar"},
      {&RollerDeviation::central_length, "reCLVar"},
      {&RollerDeviation::land_offset, "reCLOffset"}};
  for (const auto& [part, name] : kParts) {
    RollerDeviation without = rollers.deviation_of(k);
    if (!deck.has(name) || without.*part == 0.0) continue;
    without.*part = 0.0;
    if (fits(contact::roller_profile(rollers, without))) return name;
  }
  return deck.has("reDiaVar") ? "reDiaVar" : fmt::format("reDiaVar{}", k + 1);
}

}  // namespace

void check_roller_shape(const Deck& deck, const RollerGeometry& rollers) {
  ShapeCheck check(deck, contact::roller_profile(rollers));
  check.check_length();
  check.put(
      "bReCrn", "crown radius", [](RollerProfile& p) -> double& { return p.crown_radius; }, true);
  // Corners before end radii: the limit of an end depends on the corners.
  for (std::size_t end = 0; end < 2; ++end)
    check.put(
        fmt::format("bReCorRad{}", end + 1), "corner radius",
        [end](RollerProfile& p) -> double& { return p.corner_radius[end]; }, false);
  for (std::size_t end = 0; end < 2; ++end)
    check.put(
        fmt::format("bReEndRad{}", end + 1), "end radius",
        [end](RollerProfile& p) -> double& { return p.end_radius[end]; }, true);
  check.finish();
}

void check_roller_deviations(const Deck& deck, const RollerGeometry& rollers) {
  for (std::size_t k = 0; k < rollers.deviation.size(); ++k) {
    if (fits(contact::roller_profile(rollers, rollers.deviation[k]))) continue;
    throw InputError({deck.issue(
        Severity::Error, culprit(deck, rollers, k),
        fmt::format("the deviations of rolling element {} give an impossible roller shape", k + 1),
        "give smaller deviations")});
  }
}

std::vector<Issue> check_flanges(const Deck& deck) {
  constexpr double kWidePlay = 0.1;  // of the roller length: wider flanges guide nothing
  std::vector<Issue> out;
  if (!deck.has("kFlngInd11")) return out;
  const auto warn = [&](const std::string& name, std::string message, const char* remedy) {
    out.push_back(deck.issue(Severity::Warning, name, std::move(message), remedy));
  };
  const deck::ReportOnly quiet(deck);
  for (int race = 1; race <= 2; ++race) {
    bool both = true;
    for (int side = 1; side <= 2; ++side) {
      const std::string code = fmt::format("{}{}", side, race);
      const bool there = deck.integer("kFlngInd" + code) == 1;
      both = both && there;
      if (!there) continue;
      const std::string corner = fmt::format("bReCorRad{}", side);
      const double height = deck.si("flngHt" + code);
      if (height <= 0.0)
        warn("flngHt" + code, "is not a valid height: no roller end can touch this flange",
             "give the height, or remove the flange");
      else if (deck.has(corner) && height <= deck.si(corner))
        warn("flngHt" + code,
             fmt::format("is not above the corner radius {} of the roller: the corner of the "
                         "roller, not its end, touches the edge of the flange",
                         corner),
             "give a height above the corner radius, or remove the flange");
    }
    const std::string name = fmt::format("flngCls{}", race);
    if (!both) continue;
    const double play = deck.si(name);
    if (play < 0.0)
      warn(name, "is negative: the flanges of this race clamp both ends of every roller",
           "give a clearance of 0 or more");
    else if (play > kWidePlay * deck.si("bReLen"))
      warn(name,
           fmt::format("is more than {:g} times the roller length: the rollers move far off their "
                       "raceways before a flange stops them",
                       kWidePlay),
           "give the axial clearance of the rollers between the flanges (a small fraction of a "
           "millimeter)");
  }
  return out;
}

}  // namespace adore::setup

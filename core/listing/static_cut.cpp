#include "listing/static_cut.hpp"

#include "base/constants.hpp"
#include "contact/groove.hpp"
#include "contact/roller_shape.hpp"
#include "listing/print_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace adore::listing {
namespace {

using bearing::Bearing;

struct Point {
  double x = 0.0, r = 0.0;
};

/// Points of one line of the picture.
class Outline {
 public:
  void add(Point p) {
    x_.push_back(p.x);
    r_.push_back(p.r);
  }
  void add_to(StaticTables& out, const std::string& name) const {
    StaticTable& table = out.tables.emplace_back(StaticTable{name, {}});
    table.add("x", unit::kLength, x_);
    table.add("r", unit::kLength, r_);
  }

  /// Least distance of the points from a plane through p, along its unit normal m.
  [[nodiscard]] double above(Point p, Point m) const {
    double out = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < x_.size(); ++i)
      out = std::min(out, (x_[i] - p.x) * m.x + (r_[i] - p.r) * m.r);
    return out;
  }

 private:
  std::vector<double> x_, r_;
};

/// Margins of both contacts, [race][side: -x, +x].
using Margins = std::array<std::array<double, 2>, 2>;
constexpr Margins kNoMargins{std::array{kNaN, kNaN}, std::array{kNaN, kNaN}};

void add_row(StaticTables& out, std::size_t element, double azimuth,
             const std::array<double, 2>& load, const Margins& margins) {
  StaticTable& row = out.tables.emplace_back(StaticTable{"cut", {}});
  row.add("element", unit::kPure, {static_cast<double>(element + 1)});
  row.add("azimuth", unit::kAngle, {azimuth});
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race(kRaceName[j]);
    row.add(race + " load", unit::kForce, {load[j]});
    row.add(race + " -x margin", unit::kLength, {margins[j][0]});
    row.add(race + " +x margin", unit::kLength, {margins[j][1]});
  }
}

// ---- balls

/// One groove in the cut. An angle φ on it counts from its bottom towards +x; a split race has
/// another center on either side.
struct Groove {
  double sigma = 1.0;       ///< +1 outer: the bottom is outside
  double radius = 0.0;      ///< of the arc [m]
  double centre_r = 0.0;    ///< [m]
  double centre_low = 0.0;  ///< x of the center of the part towards -x [m]
  double centre_high = 0.0;
  double end = 0.0;      ///< φ of the shoulders [rad]
  bool has_end = false;  ///< the deck gives a shoulder that the arc reaches

  [[nodiscard]] double middle() const { return 0.5 * (centre_low + centre_high); }
  /// φ where the arcs of a split race meet, of the part towards +x.
  [[nodiscard]] double split() const {
    return std::asin(std::clamp((middle() - centre_high) / radius, -1.0, 1.0));
  }
  [[nodiscard]] Point at(double phi, bool high) const {
    return {(high ? centre_high : centre_low) + radius * std::sin(phi),
            centre_r + sigma * radius * std::cos(phi)};
  }
};

/// Through the contact: the groove's center is behind it on the line of contact.
Groove groove_of(const statics::StaticBall& ball, const Bearing& bearing,
                 const contact::GrooveGeometry& geometry, std::size_t j) {
  Groove out;
  out.sigma = j == 0 ? 1.0 : -1.0;
  out.radius = geometry.groove_radius[j];
  const double angle =
      std::isfinite(ball.alpha[j]) ? ball.alpha[j] : bearing.balls().contact_angle;  // unloaded
  const double behind = out.radius - geometry.ball_radius + ball.delta[j];
  const double x = ball.x - out.sigma * std::sin(angle) * behind;
  out.centre_r = ball.r - out.sigma * std::cos(angle) * behind;
  // The half in use is that of the contact; the other one's center lies a shim further that way.
  const bool contact_high = out.sigma * angle >= 0.0;
  const double shim = bearing.balls().shim[j];
  out.centre_high = contact_high ? x : x - shim;
  out.centre_low = contact_high ? x + shim : x;
  const double shoulder = 0.5 * bearing.balls().shoulder_diameter[j];
  const double cosine = out.sigma * (shoulder - geometry.centre_radius[j]) / out.radius;
  out.has_end = shoulder > 0.0 && std::abs(cosine) < 1.0;
  constexpr double kDrawn = 70.0 * kPi / 180.0;  // without a shoulder
  out.end = out.has_end ? std::acos(cosine) : kDrawn;
  return out;
}

Outline race_outline(const Groove& groove, double width) {
  constexpr int kArc = 60;
  Outline out;
  const Point low = groove.at(-groove.end, false), high = groove.at(groove.end, true);
  if (groove.has_end) out.add({std::min(groove.middle() - 0.5 * width, low.x), low.r});
  const double split = groove.split();
  for (int i = 0; i <= kArc; ++i)
    out.add(groove.at(-groove.end + (groove.end - split) * i / kArc, false));
  for (int i = 0; i <= kArc; ++i) out.add(groove.at(split + (groove.end - split) * i / kArc, true));
  if (groove.has_end) out.add({std::max(groove.middle() + 0.5 * width, high.x), high.r});
  return out;
}

template <class Element, class Load>
const Element* heaviest(const std::vector<Element>& elements, Load load) {
  const Element* out = nullptr;
  double largest = 0.0;
  for (const Element& element : elements)
    for (std::size_t j = 0; j < 2; ++j)
      if (load(element, j) > largest) {
        largest = load(element, j);
        out = &element;
      }
  return out;
}

}  // namespace

void add_radial_section(StaticTables& out, const statics::StaticSolution& solution,
                        const Bearing& bearing) {
  const statics::StaticBall* ball =
      heaviest(solution.balls, [](const auto& b, std::size_t j) { return b.Q[j]; });
  if (ball == nullptr) return;
  const contact::GrooveGeometry geometry = contact::groove_geometry(bearing.balls());
  Margins margins = kNoMargins;
  std::array<Outline, 2> races, contacts;
  for (std::size_t j = 0; j < 2; ++j) {
    const Groove groove = groove_of(*ball, bearing, geometry, j);
    races[j] = race_outline(groove, bearing.envelope.race_width[j]);
    if (!(ball->Q[j] > 0.0)) continue;
    const double middle = groove.sigma * ball->alpha[j];  // from the bottom towards +x
    const double half = std::asin(std::min(1.0, ball->a[j] / groove.radius));
    const bool high = middle >= 0.0;
    constexpr int kPoints = 24;
    for (int i = 0; i <= kPoints; ++i)
      contacts[j].add(groove.at(middle - half + 2.0 * half * i / kPoints, high));
    if (groove.has_end)
      margins[j] = {groove.radius * (groove.end + middle - half),
                    groove.radius * (groove.end - middle - half)};
  }
  add_row(out, static_cast<std::size_t>(ball - solution.balls.data()), ball->azimuth, ball->Q,
          margins);
  Outline circle;
  constexpr int kCircle = 120;
  for (int i = 0; i <= kCircle; ++i) {
    const double t = 2.0 * kPi * i / kCircle;
    circle.add({ball->x + geometry.ball_radius * std::sin(t),
                ball->r + geometry.ball_radius * std::cos(t)});
  }
  circle.add_to(out, "cut element");
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = std::string("cut ") + kRaceName[j];
    races[j].add_to(out, race + " race");
    contacts[j].add_to(out, race + " contact");
  }
}

namespace {

// ---- rollers

/// A roller at its nominal place: s along its axis, ρ across towards the outer (+1) or inner race.
class RollerCut {
 public:
  explicit RollerCut(const bearing::RollerGeometry& g, std::size_t number)
      : profile_(contact::roller_profile(g, g.deviation_of(number))),
        sine_(std::sin(g.axis_angle)),
        cosine_(std::cos(g.axis_angle)),
        middle_(0.5 * g.pitch_diameter) {}

  [[nodiscard]] Point at(double s, double across) const {
    return {s * cosine_ + across * sine_, middle_ - s * sine_ + across * cosine_};
  }
  [[nodiscard]] Point surface(double s, double sigma) const {
    return at(s, sigma * contact::roller_radius(profile_, s));
  }
  /// s where the corners begin.
  [[nodiscard]] std::array<double, 2> reach() const {
    return {-0.5 * profile_.length + profile_.corner_radius[0],
            0.5 * profile_.length - profile_.corner_radius[1]};
  }
  [[nodiscard]] Outline outline() const {
    constexpr int kPoints = 40;
    Outline out;
    const auto [low, high] = reach();
    const auto side = [&](double sigma, bool forward) {
      for (int i = 0; i <= kPoints; ++i) {
        const double share = static_cast<double>(forward ? i : kPoints - i) / kPoints;
        out.add(surface(low + (high - low) * share, sigma));
      }
    };
    const auto end = [&](std::size_t which, double from) {  // corners as chamfers, domed ends
      constexpr int kEnd = 16;
      const double sign = which == 0 ? -1.0 : 1.0, radius = profile_.end_radius[which];
      const bool flat = !(radius > 0.0) || radius > contact::kFlatEndRadius;
      const double rho =
          contact::roller_radius(profile_, which == 0 ? low : high) - profile_.corner_radius[which];
      for (int i = 0; i <= kEnd; ++i) {
        const double across = from * rho * (1.0 - 2.0 * i / kEnd);
        const double sag =
            flat ? 0.0 : across * across / (radius + std::sqrt(radius * radius - across * across));
        out.add(at(sign * (0.5 * profile_.length - sag), across));
      }
    };
    side(1.0, true);
    end(1, 1.0);
    side(-1.0, false);
    end(0, -1.0);
    out.add(surface(low, 1.0));
    return out;
  }
  [[nodiscard]] const contact::RollerProfile& profile() const { return profile_; }

 private:
  contact::RollerProfile profile_;
  double sine_, cosine_, middle_;
};

/// A raceway as points over u, the distance from the middle contact along it towards +x.
struct Raceway {
  Point origin;                ///< straight: middle contact; groove: center of the arc
  double angle = 0.0;          ///< straight: of the cone
  double groove_radius = 0.0;  ///< 0: straight
  double middle = 0.0;         ///< groove: φ of the middle contact
  double sigma = 1.0;
  double half_width = 0.0;  ///< usable, either side of the middle contact [m]

  [[nodiscard]] Point at(double u) const {
    if (groove_radius > 0.0) {
      const double phi = middle + u / groove_radius;
      return {origin.x + groove_radius * std::sin(phi),
              origin.r + sigma * groove_radius * std::cos(phi)};
    }
    return {origin.x + u * std::cos(angle), origin.r - u * std::sin(angle)};
  }
  /// u of the raceway's point nearest to p.
  [[nodiscard]] double nearest(Point p) const {
    if (groove_radius > 0.0)
      return groove_radius * (std::atan2(p.x - origin.x, sigma * (p.r - origin.r)) - middle);
    return (p.x - origin.x) * std::cos(angle) - (p.r - origin.r) * std::sin(angle);
  }
};

Raceway raceway_of(const RollerCut& roller, const Bearing& bearing, std::size_t j) {
  const bearing::RollerGeometry& g = *bearing.rollers();
  Raceway out;
  out.sigma = j == 0 ? 1.0 : -1.0;
  const double half_race = 0.5 * bearing.envelope.race_width[j];
  if (g.groove_factor[j] > 0.0) {
    const contact::RollerProfile& p = roller.profile();
    out.groove_radius = 2.0 * g.groove_factor[j] * g.crown_radius;
    out.middle = out.sigma * g.race_angle[j];
    // Center of the roller's arc, then along the line of contact to that of the groove.
    const Point arc =
        roller.at(-p.crown_radius * std::sin(p.half_angle),
                  out.sigma * (0.5 * p.diameter - p.crown_radius * std::cos(p.half_angle)));
    const double behind = out.groove_radius - p.crown_radius;
    out.origin = {arc.x - behind * std::sin(out.middle),
                  arc.r - out.sigma * behind * std::cos(out.middle)};
  } else {
    out.origin = roller.surface(0.0, out.sigma);
    out.angle = g.race_angle[j];
  }
  out.half_width = g.land_width[j] > 0.0 ? 0.5 * g.land_width[j] : half_race;
  return out;
}

/// Raceway with its flanges: two stand half their play from the roller, one alone touches it.
Outline race_outline(const Raceway& raceway, const Outline& roller,
                     const bearing::RollerGeometry& g, std::size_t j) {
  constexpr int kPoints = 60;
  std::array<double, 2> root{-raceway.half_width, raceway.half_width};
  std::array<Point, 2> tip{};
  const double c = std::cos(raceway.angle), s = std::sin(raceway.angle);
  const Point across{raceway.sigma * -s, raceway.sigma * -c};  // out of the race
  for (std::size_t side = 0; side < 2; ++side) {
    if (!g.flange[j][side]) continue;
    const bearing::Flange& flange = *g.flange[j][side];
    const double tangent = std::tan(flange.layback), cosine = std::cos(flange.layback);
    const Point inwards = side == 0 ? Point{c, -s} : Point{-c, s};  // along the raceway
    // Normal of the face towards the roller: it leans away from it.
    const Point normal{cosine * inwards.x + cosine * tangent * across.x,
                       cosine * inwards.r + cosine * tangent * across.r};
    const bool both = g.flange[j][0] && g.flange[j][1];
    const double gap =
        roller.above(raceway.at(root[side]), normal) - (both ? 0.5 * g.flange_play[j] : 0.0);
    root[side] += (side == 0 ? 1.0 : -1.0) * gap / cosine;
    const Point at = raceway.at(root[side]);
    tip[side] = {at.x + flange.height * (across.x - tangent * inwards.x),
                 at.r + flange.height * (across.r - tangent * inwards.r)};
  }
  Outline out;
  if (g.flange[j][0]) out.add(tip[0]);
  for (int i = 0; i <= kPoints; ++i)
    out.add(raceway.at(root[0] + (root[1] - root[0]) * i / kPoints));
  if (g.flange[j][1]) out.add(tip[1]);
  return out;
}

/// Along the roller from where to where it touches; low > high: nowhere.
std::array<double, 2> extent(const statics::RollerRaceContact& contact,
                             const statics::RollerSolution& solution) {
  if (contact.slice_load.empty())
    return {contact.peak_position - 0.5 * contact.length,
            contact.peak_position + 0.5 * contact.length};
  std::array<double, 2> out{1.0, -1.0};
  const double half = 0.5 * solution.slice_width;
  for (std::size_t k = 0; k < contact.slice_load.size(); ++k)
    if (contact.slice_load[k] > 0.0) {
      const double s = solution.slice_position[k];
      if (out[0] > out[1]) out[0] = s - half;
      out[1] = s + half;
    }
  return out;
}

}  // namespace

void add_radial_section(StaticTables& out, const statics::RollerSolution& solution,
                        const Bearing& bearing) {
  const statics::StaticRoller* roller =
      heaviest(solution.rollers, [](const auto& r, std::size_t j) { return r.race[j].load; });
  if (roller == nullptr) return;
  const auto number = static_cast<std::size_t>(roller - solution.rollers.data());
  const bearing::RollerGeometry& g = *bearing.rollers();
  const RollerCut cut(g, number);
  const auto reach = cut.reach();
  const Outline outline = cut.outline();
  Margins margins = kNoMargins;
  std::array<Outline, 2> races, contacts;
  for (std::size_t j = 0; j < 2; ++j) {
    const Raceway raceway = raceway_of(cut, bearing, j);
    races[j] = race_outline(raceway, outline, g, j);
    if (!(roller->race[j].load > 0.0)) continue;
    const auto [low, high] = extent(roller->race[j], solution);
    if (low > high) continue;
    const double from = raceway.nearest(cut.surface(low, raceway.sigma)),
                 to = raceway.nearest(cut.surface(high, raceway.sigma));
    constexpr int kPoints = 24;
    for (int i = 0; i <= kPoints; ++i)
      contacts[j].add(raceway.at(from + (to - from) * i / kPoints));
    // Whichever ends first: the raceway, or the roller at its corner.
    margins[j] = {std::min(raceway.half_width + from, low - reach[0]),
                  std::min(raceway.half_width - to, reach[1] - high)};
    for (double& margin : margins[j])
      if (std::abs(margin) < 1e-9) margin = 0.0;  // the last slice ends where the corner begins
  }
  add_row(out, number, roller->azimuth, {roller->race[0].load, roller->race[1].load}, margins);
  outline.add_to(out, "cut element");
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = std::string("cut ") + kRaceName[j];
    races[j].add_to(out, race + " race");
    contacts[j].add_to(out, race + " contact");
  }
}

}  // namespace adore::listing

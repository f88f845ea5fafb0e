#include "setup/user_surfaces.hpp"

#include "base/errors.hpp"
#include "contact/roller_pocket.hpp"
#include "contact/roller_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace adore::setup {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr const char* kRaceName[] = {"outer race", "inner race"};

/// Two numbers that say the same: to 1e-9 of what varies, to rounding of what does not.
bool same(double a, double b, double range) { return std::abs(a - b) <= 1e-9 * range + 1e-15; }
double largest(const std::vector<double>& values) {
  double out = 0.0;
  for (const double v : values) out = std::max(out, std::abs(v));
  return out;
}

/// Trigonometric series through every other one of 2m values around the turn, from 0 on.
struct Series {
  bearing::TurnSeries series;
  double error = 0.0;  ///< at the values between
  int waves = 0;
};
Series series_of(const std::vector<double>& values) {
  Series out;
  const std::size_t m = values.size() / 2;
  const double size = largest(values);
  if (size == 0.0) return out;
  std::vector<double> cosine(m), sine(m);
  for (std::size_t k = 0; k < m; ++k) {
    cosine[k] = std::cos(kTurn * static_cast<double>(k) / static_cast<double>(m));
    sine[k] = std::sin(kTurn * static_cast<double>(k) / static_cast<double>(m));
  }
  std::vector<double>& pairs = out.series.pairs;
  for (std::size_t n = 0; n < m / 2; ++n) {
    double c = 0.0, s = 0.0;
    for (std::size_t k = 0; k < m; ++k) {
      c += values[2 * k] * cosine[n * k % m];
      s += values[2 * k] * sine[n * k % m];
    }
    const double scale = (n == 0 ? 1.0 : 2.0) / static_cast<double>(m);
    // What rounding leaves of a wave that is not there.
    const auto kept = [&](double v) {
      return std::abs(v * scale) > 1e-14 * size ? v * scale : 0.0;
    };
    pairs.push_back(kept(c));
    pairs.push_back(kept(s));
  }
  while (!pairs.empty() && pairs.back() == 0.0 && pairs[pairs.size() - 2] == 0.0)
    pairs.resize(pairs.size() - 2);
  out.waves = static_cast<int>(pairs.size() / 2) - 1;
  out.series.least = *std::min_element(values.begin(), values.end());
  out.series.largest = *std::max_element(values.begin(), values.end());
  for (std::size_t k = 1; k < values.size(); k += 2) {
    const double psi = kTurn * static_cast<double>(k) / static_cast<double>(values.size());
    double sum = 0.0;
    for (std::size_t n = 0; 2 * n < pairs.size(); ++n) {
      const double at = static_cast<double>(n) * psi;
      sum += pairs[2 * n] * std::cos(at) + pairs[2 * n + 1] * std::sin(at);
    }
    out.error = std::max(out.error, std::abs(sum - values[k]));
  }
  return out;
}

std::string about(const UserHooks& user, int hook, const std::string& body) {
  return fmt::format("user routine ADRX{} of {}, {}: ", hook, user.source, body);
}

/// @throws InputError where the series is far from what the routine says between its places
bearing::TurnSeries taken(const UserHooks& user, int hook, const std::string& body,
                          const char* what, const char* unit, const std::vector<double>& values) {
  Series series = series_of(values);
  if (series.series.pairs.empty()) return {};
  const double range =
      std::max(series.series.largest - series.series.least, std::numeric_limits<double>::min());
  if (series.error > 0.01 * range)
    throw InputError(fmt::format(
        "{}{} jumps somewhere around the turn: 255 waves through 512 places miss it by {:.3g} {} "
        "between them, of a range of {:.3g} {}; give a surface that closes and has no steps",
        about(user, hook, body), what, series.error, unit, range, unit));
  user.document(hook, fmt::format("{}: {} of up to {} waves per turn, {:.6g} to {:.6g} {}, within "
                                  "{:.2g} {} between the places asked for",
                                  body, what, series.waves, series.series.least,
                                  series.series.largest, unit, series.error, unit));
  return std::move(series.series);
}

constexpr std::size_t kAround = 1024;  // half of them make the series

/// What a roller's radius has more over its turn, without means: c(ψ) + s t(ψ).
struct Roundness {
  std::vector<double> radius, slope;  ///< c [m], t [-], at kAround azimuths
  bool round = true;
};
Roundness roundness_of(const UserHooks& user, const bearing::Bearing& b, int element, double half) {
  bearing::UserSurface t;
  t.element = element;
  for (const double s : {-half, 0.0, half})
    for (std::size_t k = 0; k < kAround; ++k) t.place(s, kTurn * static_cast<double>(k) / kAround);
  user.surface(b, t);
  const double range = largest(t.radius);
  Roundness out;
  for (std::size_t k = 0; k < kAround; ++k) {
    for (std::size_t i = 0; i < 3; ++i)
      out.round = out.round && same(t.radius[i * kAround + k], t.radius[i * kAround], range);
    out.radius.push_back(t.radius[kAround + k]);
    out.slope.push_back((t.radius[2 * kAround + k] - t.radius[k]) / (2.0 * half));
  }
  for (std::vector<double>* values : {&out.radius, &out.slope}) {
    double mean = 0.0;
    for (const double v : *values) mean += v / kAround;
    for (double& v : *values) v -= mean;
  }
  if (std::abs(largest(out.slope)) * half < 1e-9 * range + 1e-15) out.slope.assign(kAround, 0.0);
  return out;
}

/// The mean radius over the places s, from places times azimuths, once c + s t is taken away.
std::vector<double> unturned(const UserHooks& user, const bearing::UserSurface& t,
                             std::size_t azimuths, const Roundness& shape) {
  std::vector<double> out;
  const double range = largest(t.radius);
  for (std::size_t k = 0; k < t.radius.size(); k += azimuths) {
    std::vector<double> left;
    for (std::size_t i = 0; i < azimuths; ++i) {
      const std::size_t at = i * (kAround / azimuths);
      left.push_back(t.radius[k + i] -
                     (shape.round ? 0.0 : shape.radius[at] + t.axial[k] * shape.slope[at]));
    }
    const auto [low, high] = std::minmax_element(left.begin(), left.end());
    if (*high - *low > (shape.round ? 0.0 : 0.01 * range) && !same(*low, *high, range))
      throw InputError(fmt::format(
          "{}at {:.6g} m from its middle the radius over the azimuth is {:.3g} m from a sum of "
          "f(x) + c(psi) + x t(psi); out-of-roundness may grow evenly along the axis",
          about(user, 5, fmt::format("element {}", t.element + 1)), t.axial[k], *high - *low));
    double mean = 0.0;
    for (const double v : left) mean += v / static_cast<double>(azimuths);
    out.push_back(shape.round ? left.front() : mean);
  }
  return out;
}

/// Where a roller is asked for: middles of the slices on races and in pockets, and 129 more.
std::vector<double> places_of(const bearing::RollerGeometry& rollers, std::size_t k, int slices) {
  const contact::RollerProfile profile = contact::roller_profile(rollers, rollers.deviation_of(k));
  std::vector<double> out;
  const contact::Slicing slicing = contact::slicing(profile, slices);
  for (int i = 0; i < slices; ++i) out.push_back(slicing.centre(i));
  for (const contact::RollerSlice& slice : contact::pocket_slices(profile, slices))
    out.push_back(slice.s);
  constexpr int kMore = 128;
  for (int i = 0; i <= kMore; ++i)
    out.push_back((static_cast<double>(i) / kMore - 0.5) * profile.length);
  std::sort(out.begin(), out.end());
  const double close = 1e-9 * profile.length;
  out.erase(std::unique(out.begin(), out.end(), [&](double a, double b) { return b - a < close; }),
            out.end());
  return out;
}

}  // namespace

void user_elements(const UserHooks& user, bearing::Bearing& b) {
  constexpr std::size_t kAzimuths = 8;
  const auto count = static_cast<std::size_t>(b.element_count());
  bearing::RollerGeometry* const rollers = b.rollers();
  double least = 0.0, most = 0.0;
  std::vector<bearing::RollerDeviation> deviation;
  std::vector<double> growth(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    bearing::UserSurface t;
    t.element = static_cast<int>(k);
    std::vector<double> places;
    if (rollers != nullptr) {
      places = places_of(*rollers, k, user.slices);
    } else {
      const double D = b.element_diameter();
      places = {-0.4 * D, 0.0, 0.4 * D};
    }
    for (const double s : places)
      for (std::size_t i = 0; i < kAzimuths; ++i)
        t.place(s, kTurn * static_cast<double>(i) / kAzimuths);
    user.surface(b, t);
    const Roundness shape = roundness_of(
        user, b, t.element,
        rollers != nullptr ? 0.5 * rollers->contact_length() : 0.4 * b.element_diameter());
    if (!shape.round && rollers == nullptr)
      throw InputError(fmt::format(
          "{}the radius of a ball varies over its surface by up to {:.3g} m; balls stay round: "
          "give "
          "one number for each",
          about(user, 5, fmt::format("element {}", k + 1)), 2.0 * largest(shape.radius)));
    if (!shape.round && user.points)
      throw InputError(about(user, 5, fmt::format("element {}", k + 1)) +
                       "a barrel that touches at points is round; set the run option that cuts it "
                       "into slices");
    if (!shape.round && largest(shape.slope) > 0.0 &&
        (rollers->groove_factor[0] > 0.0 || rollers->groove_factor[1] > 0.0))
      throw InputError(about(user, 5, fmt::format("element {}", k + 1)) +
                       "out-of-roundness of a barrel grows along its axis; let it depend on the "
                       "azimuth alone");
    if (!shape.round) {
      const std::string name = fmt::format("roller {}", k + 1);
      std::vector<double> angle;
      for (const double slope : shape.slope) angle.push_back(std::atan(slope));
      bearing::GivenRace form;
      form.radius = taken(user, 5, name, "radius over the azimuth", "m", shape.radius);
      form.taper = taken(user, 5, name, "taper over the azimuth", "rad", angle);
      user.out_of_round(k, std::move(form));
    }
    std::vector<double> radius = unturned(user, t, kAzimuths, shape);
    const double size = largest(radius), top = *std::max_element(radius.begin(), radius.end());
    const double bottom = *std::min_element(radius.begin(), radius.end());
    const bool even = same(top, bottom, size);
    least = std::min(least, bottom);
    most = std::max(most, top);
    const std::string body = fmt::format("element {}", k + 1);
    if (!(0.5 * b.element_diameter() + bottom > 0.0))
      throw InputError(fmt::format("{}a radius of {:.6g} m less leaves nothing of {:.6g} m",
                                   about(user, 5, body), -bottom, 0.5 * b.element_diameter()));
    if (rollers == nullptr) {
      if (!even)
        throw InputError(fmt::format(
            "{}the radius of a ball varies by {:.3g} m along the axis; balls stay round: give one "
            "number for each",
            about(user, 5, body), top - bottom));
      growth[k] = 2.0 * radius[1];
      continue;
    }
    bearing::RollerDeviation& own = deviation.emplace_back(rollers->deviation_of(k));
    own.diameter += 2.0 * top;
    if (even) continue;
    if (user.points)
      throw InputError(fmt::format(
          "{}the radius varies by {:.3g} m along a barrel that touches at points; set the run "
          "option that cuts it into slices, or give one number for each roller",
          about(user, 5, body), top - bottom));
    for (double& one : radius) one -= top;
    own.form = std::make_shared<const bearing::RollerForm>(
        bearing::RollerForm{std::move(places), std::move(radius)});
  }
  user.document(
      5, fmt::format("elements: radius {:.6g} to {:.6g} m more than the deck's", least, most));
  if (least == 0.0 && most == 0.0) return;
  if (rollers != nullptr) {
    rollers->deviation = std::move(deviation);
  } else {
    b.imperfections.ball_diameter.resize(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) b.imperfections.ball_diameter[k] += growth[k];
  }
  if (b.imperfections.elements == bearing::ElementErrors::None)
    b.imperfections.elements = bearing::ElementErrors::Listed;
}

void user_race(const UserHooks& user, std::size_t race, bearing::Bearing& b) {
  constexpr std::size_t kPlaces = kAround;
  const bearing::RollerGeometry* const rollers = b.rollers();
  const bool groove = rollers == nullptr || rollers->groove_factor[race] > 0.0;
  const double half =
      rollers != nullptr ? 0.5 * rollers->contact_length() : 0.3 * b.element_diameter();
  constexpr double kAcross[] = {-1.0, -0.5, 0.0, 0.5, 1.0};
  constexpr std::size_t kMiddle = 2, kMany = 5;
  bearing::UserSurface t;
  t.race = static_cast<int>(race);
  for (const double x : kAcross)
    for (std::size_t k = 0; k < kPlaces; ++k)
      t.place(x * half, kTurn * static_cast<double>(k) / kPlaces);
  user.surface(b, t);
  const std::string body = kRaceName[race];
  const double size = largest(t.radius);
  std::vector<double> radius(kPlaces), taper(kPlaces), factor(kPlaces);
  for (std::size_t k = 0; k < kPlaces; ++k) {
    const auto at = [&](std::size_t across) { return t.radius[across * kPlaces + k]; };
    radius[k] = at(kMiddle);
    const double slope = (at(kMany - 1) - at(0)) / (2.0 * half);
    for (std::size_t i = 0; i < kMany; ++i)
      if (!same(at(i), radius[k] + (groove ? 0.0 : slope * kAcross[i] * half), size))
        throw InputError(fmt::format(
            "{}the radius at azimuth {:.4g} rad and {:.4g} m across is {:.3g} m from that of {}; "
            "{}",
            about(user, 6, body), t.azimuth[k], t.axial[i * kPlaces + k],
            std::abs(at(i) - radius[k]), groove ? "the middle" : "a taper",
            groove ? "across a groove its curvature factor varies, and the radius not"
                   : "a straight raceway may be tapered, and its crown is record 5B's or the "
                     "rollers' own"));
    if (!groove && !same(slope * half, 0.0, size)) {
      const double cone = rollers->race_angle[race];  // R(x) falls by x tan of it
      taper[k] = cone - std::atan(std::tan(cone) - slope);
    }
    factor[k] = t.curvature_factor[kMiddle * kPlaces + k];
    if (!groove && factor[k] != 0.0)
      throw InputError(about(user, 6, body) +
                       "a straight raceway has no groove factor; leave curvature_factor at 0");
    for (std::size_t i = 0; i < kMany; ++i)
      if (!same(t.curvature_factor[i * kPlaces + k], factor[k], largest(t.curvature_factor)))
        throw InputError(about(user, 6, body) +
                         "the curvature factor varies across the groove; give one number for each "
                         "azimuth");
  }
  auto given = std::make_shared<bearing::GivenRace>();
  given->radius = taken(user, 6, body, "radius", "m", radius);
  given->taper = taken(user, 6, body, "taper", "rad", taper);
  given->curvature_factor = taken(user, 6, body, "curvature factor", "", factor);
  b.imperfections.race_given[race] = true;
  b.imperfections.race[race].given = std::move(given);
}

}  // namespace adore::setup

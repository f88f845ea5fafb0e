#include "setup/user_surfaces.hpp"

#include "base/errors.hpp"
#include "contact/race_table.hpp"
#include "contact/roller_pocket.hpp"
#include "contact/roller_shape.hpp"
#include "setup/surface_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace adore::setup {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kSeriesError = 0.01;  // of the range
constexpr double kRounding = 1e-12;    // of the largest value
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
  bearing::AzimuthSeries series;
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
bearing::AzimuthSeries taken(const UserHooks& user, int hook, const std::string& body,
                             const char* what, const char* unit,
                             const std::vector<double>& values) {
  Series series = series_of(values);
  if (series.series.pairs.empty()) return {};
  const double range =
      std::max(series.series.largest - series.series.least, std::numeric_limits<double>::min());
  if (series.error > kSeriesError * range + kRounding * largest(values))
    throw InputError(fmt::format(
        "{}{} has a step along the circumference: a series of 255 waves through 512 points "
        "differs from the values between the points by {:.3g} {}; the values have a range of "
        "{:.3g} {}. Return a closed surface without steps",
        about(user, hook, body), what, series.error, unit, range, unit));
  user.document(hook, fmt::format("{}: {} with up to {} waves per revolution, {:.6g} to {:.6g} "
                                  "{}, interpolation error {:.2g} {}",
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
          "{}at {:.6g} m from mid length, the radius around the axis differs by {:.3g} m from the "
          "form f(x) + c(psi) + x t(psi). Return an out-of-roundness that is constant or linear "
          "along the axis",
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

namespace {

constexpr std::size_t kBallAround = 512, kBallAcross = 193;  // rows from pole to pole

/// Of a table at places between its own, up to 60 degrees of latitude (beyond, azimuths mean
/// little).
double error_between(const UserHooks& user, const bearing::Bearing& b,
                     const bearing::TabulatedSurface& form, int element, double mean) {
  const bearing::SurfaceTable& of = form.table;
  const contact::SurfaceDeviationTable table{of.height.data(), nullptr, of.around, of.across,
                                             of.first,         of.step, 1.0};
  bearing::UserSurface t;
  t.element = element;
  const double R = 0.5 * b.element_diameter();
  std::vector<double> latitudes;
  for (int m = 0; m < 31; ++m) latitudes.push_back((m - 15) * 4.03 * std::numbers::pi / 180.0);
  for (const double latitude : latitudes)
    for (int i = 0; i < of.around; ++i)
      t.place(R * std::sin(latitude), kTurn * (i + 0.5) / of.around);
  user.surface(b, t);
  double out = 0.0;
  for (std::size_t k = 0; k < t.radius.size(); ++k)
    out = std::max(out,
                   std::abs(t.radius[k] - mean -
                            contact::table_value(table, table.height, t.azimuth[k],
                                                 latitudes[k / static_cast<std::size_t>(of.around)])
                                .value));
  return out;
}

/// Balls: a mean that is their diameter, and what is left as a table; nothing where it is 0.
void user_balls(const UserHooks& user, bearing::Bearing& b) {
  const auto count = static_cast<std::size_t>(b.element_count());
  const double R = 0.5 * b.element_diameter();
  const double step = std::numbers::pi / (kBallAcross - 1);
  const auto latitude = [&](double row) { return -0.5 * std::numbers::pi + row * step; };
  double least = 0.0, most = 0.0;
  std::vector<double> growth(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const std::string body = fmt::format("ball {}", k + 1);
    bearing::UserSurface t;
    const auto ask = [&](std::size_t rows, std::size_t columns) {
      t = {};
      t.element = static_cast<int>(k);
      for (std::size_t m = 0; m < kBallAcross; m += (kBallAcross - 1) / rows)
        for (std::size_t i = 0; i < columns; ++i)
          t.place(R * std::sin(latitude(static_cast<double>(m))),
                  kTurn * static_cast<double>(i) / static_cast<double>(columns));
      user.surface(b, t);
      const auto [low, high] = std::minmax_element(t.radius.begin(), t.radius.end());
      return !same(*high, *low, largest(t.radius));
    };
    const bool varies = ask(32, 64) && ask(kBallAcross - 1, kBallAround);
    const auto [low, high] = std::minmax_element(t.radius.begin(), t.radius.end());
    const double bottom = *low, top = *high, range = top - bottom;
    least = std::min(least, bottom);
    most = std::max(most, top);
    if (!(R + bottom > 0.0))
      throw InputError(
          fmt::format("{}a radius reduction of {:.6g} m exceeds the radius of {:.6g} m. Return a "
                      "smaller reduction",
                      about(user, 5, body), -bottom, R));
    if (!varies) {
      growth[k] = 2.0 * t.radius.front();
      continue;
    }
    if (top - bottom > 0.01 * R)
      throw InputError(
          fmt::format("{}the radius varies by {:.3g} m, too much for a ball of radius {:.6g} m. "
                      "Return a variation of at most 1 %",
                      about(user, 5, body), range, R));
    double mean = 0.0, weight = 0.0;  // over the sphere
    for (std::size_t m = 0; m < kBallAcross; ++m) {
      const double w = std::cos(latitude(static_cast<double>(m)));
      for (std::size_t i = 0; i < kBallAround; ++i) {
        mean += w * t.radius[m * kBallAround + i];
        weight += w;
      }
    }
    mean /= weight;
    growth[k] = 2.0 * mean;
    for (double& one : t.radius) one -= mean;
    auto form = std::make_shared<bearing::TabulatedSurface>(
        bearing::SurfaceTable{kBallAround, kBallAcross, latitude(0.0), step, t.radius, {}});
    form->radius.least = bottom;
    form->radius.largest = top;
    convert_to_spline_coefficients(form->table.height, kBallAround, true);
    const double error = error_between(user, b, *form, t.element, mean);
    if (error > kSeriesError * range)
      throw InputError(fmt::format(
          "{}the radius has steps, or more than about 60 waves per revolution: a surface through "
          "{} x {} points differs from the values between the points by {:.3g} m; the values have "
          "a range of {:.3g} m. Return a smoother surface",
          about(user, 5, body), kBallAround, kBallAcross, error, range));
    user.document(5,
                  fmt::format("{}: radius minus the radius in the deck = {:.6g} to {:.6g} m, "
                              "mean {:.6g} m; interpolation error {:.2g} m between {} x {} points",
                              body, bottom, top, mean, error, kBallAround, kBallAcross));
    user.out_of_round(k, std::move(form));
  }
  user.document(5, fmt::format("elements: radius minus the radius in the deck = {:.6g} to {:.6g} m",
                               least, most));
  if (std::all_of(growth.begin(), growth.end(), [](double one) { return one == 0.0; })) return;
  b.imperfections.ball_diameter.resize(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) b.imperfections.ball_diameter[k] += growth[k];
  if (b.imperfections.elements == bearing::ElementErrorSource::None)
    b.imperfections.elements = bearing::ElementErrorSource::Listed;
}

}  // namespace

void apply_user_element_surfaces(const UserHooks& user, bearing::Bearing& b) {
  if (b.rollers() == nullptr) return user_balls(user, b);
  constexpr std::size_t kAzimuths = 8;
  const auto count = static_cast<std::size_t>(b.element_count());
  bearing::RollerGeometry* const rollers = b.rollers();
  double least = 0.0, most = 0.0;
  std::vector<bearing::RollerDeviation> deviation;
  for (std::size_t k = 0; k < count; ++k) {
    bearing::UserSurface t;
    t.element = static_cast<int>(k);
    std::vector<double> places = places_of(*rollers, k, user.slices);
    for (const double s : places)
      for (std::size_t i = 0; i < kAzimuths; ++i)
        t.place(s, kTurn * static_cast<double>(i) / kAzimuths);
    user.surface(b, t);
    const Roundness shape = roundness_of(user, b, t.element, 0.5 * rollers->contact_length());
    if (!shape.round && user.points)
      throw InputError(
          about(user, 5, fmt::format("element {}", k + 1)) +
          "the roller is out of round, but rollerContact=point needs round rollers. Set run option "
          "rollerContact=sliced");
    if (!shape.round && largest(shape.slope) > 0.0 &&
        (rollers->groove_factor[0] > 0.0 || rollers->groove_factor[1] > 0.0))
      throw InputError(about(user, 5, fmt::format("element {}", k + 1)) +
                       "the out-of-roundness of a barrel roller must not vary along the roller "
                       "axis. Return values that depend on the azimuth only");
    if (!shape.round) {
      const std::string name = fmt::format("roller {}", k + 1);
      std::vector<double> angle;
      for (const double slope : shape.slope) angle.push_back(std::atan(slope));
      bearing::SurfaceSeries form;
      form.radius = taken(user, 5, name, "radius around the axis", "m", shape.radius);
      form.taper = taken(user, 5, name, "taper around the axis", "rad", angle);
      user.out_of_round(k, std::make_shared<const bearing::SurfaceSeries>(std::move(form)));
    }
    std::vector<double> radius = unturned(user, t, kAzimuths, shape);
    const double size = largest(radius), top = *std::max_element(radius.begin(), radius.end());
    const double bottom = *std::min_element(radius.begin(), radius.end());
    const bool even = same(top, bottom, size);
    least = std::min(least, bottom);
    most = std::max(most, top);
    const std::string body = fmt::format("element {}", k + 1);
    if (!(0.5 * b.element_diameter() + bottom > 0.0))
      throw InputError(
          fmt::format("{}a radius reduction of {:.6g} m exceeds the radius of {:.6g} m. Return a "
                      "smaller reduction",
                      about(user, 5, body), -bottom, 0.5 * b.element_diameter()));
    bearing::RollerDeviation& own = deviation.emplace_back(rollers->deviation_of(k));
    own.diameter += 2.0 * top;
    if (even) continue;
    if (user.points)
      throw InputError(fmt::format(
          "{}the radius varies by {:.3g} m along a barrel roller, which rollerContact=point does "
          "not include. Set run option rollerContact=sliced, or return one number for each roller",
          about(user, 5, body), top - bottom));
    for (double& one : radius) one -= top;
    own.form = std::make_shared<const bearing::RollerProfileDeviation>(
        bearing::RollerProfileDeviation{std::move(places), std::move(radius)});
  }
  user.document(5, fmt::format("elements: radius minus the radius in the deck = {:.6g} to {:.6g} m",
                               least, most));
  if (least == 0.0 && most == 0.0) return;
  rollers->deviation = std::move(deviation);
  if (b.imperfections.elements == bearing::ElementErrorSource::None)
    b.imperfections.elements = bearing::ElementErrorSource::Listed;
}

namespace {

/// Greatest distance of a series from values around the turn.
double distance(const bearing::AzimuthSeries& series, const std::vector<double>& values) {
  const contact::RaceFourierSeries sum{series.pairs.data(),
                                       static_cast<int>(series.pairs.size() / 2)};
  double out = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double psi = kTurn * static_cast<double>(k) / static_cast<double>(values.size());
    const double at =
        sum.count == 0 ? 0.0 : contact::sum_at(sum, std::cos(psi), std::sin(psi)).value;
    out = std::max(out, std::abs(at - values[k]));
  }
  return out;
}

/// A race over the turn alone, as series; nothing where it varies across, or jumps.
/// @param all what the routine says at all places of a table
std::shared_ptr<bearing::SurfaceSeries> race_by_series(const UserHooks& user, std::size_t race,
                                                       const bearing::Bearing& b,
                                                       const bearing::UserSurface& all) {
  constexpr std::size_t kTurnPlaces = kTableAround, kEvery = kTurnPlaces / kAround;
  const bearing::RollerGeometry* const rollers = b.rollers();
  const bool groove = rollers == nullptr || rollers->groove_factor[race] > 0.0;
  const double half =
      rollers != nullptr ? 0.5 * rollers->contact_length() : 0.3 * b.element_diameter();
  bearing::UserSurface t;
  t.race = static_cast<int>(race);
  for (const double x : {0.0, -half, half})
    for (std::size_t k = 0; k < kTurnPlaces; ++k)
      t.place(x, kTurn * static_cast<double>(k) / kTurnPlaces);
  user.surface(b, t);
  const double size = std::max(largest(t.radius), largest(all.radius));
  const double size_of_factor =
      std::max(largest(t.curvature_factor), largest(all.curvature_factor));
  std::vector<double> radius, taper, factor, every_radius, every_factor;
  for (std::size_t k = 0; k < kTurnPlaces; ++k) {
    const double middle = t.radius[k], f = t.curvature_factor[k];
    const double slope = (t.radius[2 * kTurnPlaces + k] - t.radius[kTurnPlaces + k]) / (2.0 * half);
    const auto fits = [&](const bearing::UserSurface& at, std::size_t i) {
      return same(at.radius[i], middle + (groove ? 0.0 : slope * at.axial[i]), size) &&
             same(at.curvature_factor[i], f, size_of_factor);
    };
    for (std::size_t i = k; i < t.radius.size(); i += kTurnPlaces)
      if (!fits(t, i)) return nullptr;
    for (std::size_t i = k; i < all.radius.size(); i += kTurnPlaces)
      if (!fits(all, i)) return nullptr;
    every_radius.push_back(middle);
    every_factor.push_back(f);
    if (k % kEvery != 0) continue;
    radius.push_back(middle);
    factor.push_back(f);
    taper.push_back(0.0);
    if (!groove && !same(slope * half, 0.0, size)) {
      const double cone = rollers->race_angle[race];  // R(x) falls by x tan of it
      taper.back() = cone - std::atan(std::tan(cone) - slope);
    }
  }
  for (const auto& [some, every] : {std::pair{&radius, &every_radius}, {&factor, &every_factor}}) {
    const auto [low, high] = std::minmax_element(every->begin(), every->end());
    if (distance(series_of(*some).series, *every) > kSeriesError * (*high - *low) + 1e-15)
      return nullptr;
  }
  if (const Series series = series_of(taper);
      series.error >
      kSeriesError * (series.series.largest - series.series.least) + kRounding * largest(taper))
    return nullptr;
  const std::string body = kRaceName[race];
  auto given = std::make_shared<bearing::SurfaceSeries>();
  given->radius = taken(user, 6, body, "radius", "m", radius);
  given->taper = taken(user, 6, body, "taper", "rad", taper);
  given->curvature_factor = taken(user, 6, body, "curvature factor", "", factor);
  return given;
}

void set_range(bearing::AzimuthSeries& of, const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  of.least = *low;
  of.largest = *high;
}

std::shared_ptr<bearing::SurfaceSeries> race_by_table(const UserHooks& user, std::size_t race,
                                                      const bearing::Bearing& b,
                                                      const std::vector<double>& places,
                                                      const bearing::UserSurface& t) {
  const std::string body = kRaceName[race];
  if (user.points)
    throw InputError(about(user, 6, body) +
                     "the surface varies across the raceway or has steps, which barrel rollers "
                     "with rollerContact=point do not include. Set run option "
                     "rollerContact=sliced");
  const bool curves = largest(t.curvature_factor) > 0.0;
  auto given = std::make_shared<bearing::TabulatedSurface>(build_surface_table(
      b, race, places, t.radius, curves ? t.curvature_factor : std::vector<double>{}));
  set_range(given->radius, t.radius);
  set_range(given->curvature_factor, t.curvature_factor);
  user.document(
      6,
      fmt::format(
          "{}: the raceway surface is a table of {} x {} points (circumferential x axial); radius "
          "{:.6g} to {:.6g} m{}",
          body, kTableAround, places.size(), given->radius.least, given->radius.largest,
          curves ? fmt::format(", curvature factor {:.6g} to {:.6g}", given->curvature_factor.least,
                               given->curvature_factor.largest)
                 : ""));
  return given;
}

}  // namespace

void apply_user_race_surface(const UserHooks& user, std::size_t race, bearing::Bearing& b) {
  const bearing::RollerGeometry* const rollers = b.rollers();
  const std::vector<double> places = surface_table_axial_positions(b, race, user.slices);
  bearing::UserSurface all;
  all.race = static_cast<int>(race);
  for (const double x : places)
    for (int k = 0; k < kTableAround; ++k) all.place(x, kTurn * k / kTableAround);
  user.surface(b, all);
  std::shared_ptr<bearing::SurfaceSeries> given = race_by_series(user, race, b, all);
  if (!given) given = race_by_table(user, race, b, places, all);
  const bool straight = rollers != nullptr && !(rollers->groove_factor[race] > 0.0);
  if (straight && (given->curvature_factor.least != 0.0 || given->curvature_factor.largest != 0.0))
    throw InputError(about(user, 6, kRaceName[race]) +
                     "a straight raceway has no groove factor. Leave curvature_factor at 0");
  b.imperfections.race_given[race] = true;
  b.imperfections.race[race].given = std::move(given);
}

}  // namespace adore::setup

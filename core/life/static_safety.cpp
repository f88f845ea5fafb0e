#include "life/static_safety.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "bearing/rating_data.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::life {
namespace {

constexpr const char* kPrinted =
    "seen: printed in manufacturers' catalogs, see resources/ratings.json";

/// Y0 of one row, linear between the angles of the table; "seen" at 15, 30 and 40 degrees.
double angular_factor(double degrees, bool& seen) {
  const auto& rows = bearing::rating_data("static_factors").at("angular");
  const double first = rows.front().at(0).get<double>(), last = rows.back().at(0).get<double>();
  if (degrees < first - 1e-9 || degrees > last + 1e-9)
    throw InputError(fmt::format(
        "contact angle = {:.4g} deg: outside the table of angular contact ball bearings. Enter an "
        "angle from {:g} to {:g} deg. For angles below {:g} deg, select the type \"deep_groove\".",
        degrees, first, last, first));
  seen = false;
  for (const double printed : {15.0, 30.0, 40.0}) seen = seen || std::abs(degrees - printed) < 1e-9;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double x0 = rows[k - 1].at(0).get<double>(), x1 = rows[k].at(0).get<double>();
    const double y0 = rows[k - 1].at(1).get<double>(), y1 = rows[k].at(1).get<double>();
    if (degrees <= x1 + 1e-9) return y0 + (y1 - y0) * (degrees - x0) / (x1 - x0);
  }
  return rows.back().at(1).get<double>();
}

}  // namespace

StaticLoadFactors static_factors(StaticBearingType type, double angle, int rows) {
  const bool pair = rows > 1;
  const double degrees = angle / kDegree;
  switch (type) {
    case StaticBearingType::DeepGroove:
      return {0.6, 0.5, true, kPrinted};
    case StaticBearingType::AngularContact: {
      bool seen = false;
      const double Y0 = angular_factor(degrees, seen);
      return {pair ? 1.0 : 0.5, pair ? 2.0 * Y0 : Y0, !pair,
              seen ? kPrinted
                   : "recalled: manufacturers' catalogs do not list this angle, so the value is "
                     "not verified"};
    }
    case StaticBearingType::SelfAligning: {
      if (!(degrees > 0.0 && degrees <= 45.0 + 1e-9))
        throw InputError(fmt::format(
            "contact angle = {:.4g} deg: it must be above 0 and at most 45 deg for this bearing "
            "type. Enter the contact angle (tapered bearings: half the cup angle).",
            degrees));
      const double Y0 = 0.22 / std::tan(angle);
      return {pair ? 1.0 : 0.5, pair ? 2.0 * Y0 : Y0, !pair, kPrinted};
    }
    case StaticBearingType::Cylindrical:
      return {1.0, 0.0, true, kPrinted};
    case StaticBearingType::Thrust:
      break;
  }
  if (degrees > 90.0 - 1e-9) return {0.0, 1.0, false, kPrinted};
  if (degrees <= 45.0)
    throw InputError(
        fmt::format("contact angle = {:.4g} deg: it must be above 45 deg for a thrust bearing. "
                    "Enter a larger angle, or select another bearing type.",
                    degrees));
  return {2.3 * std::tan(angle), 1.0, false, "recalled"};
}

double equivalent_static_load(const StaticLoadFactors& factors, double radial, double axial) {
  const double Fr = std::abs(radial), Fa = std::abs(axial);
  if (factors.X0 == 0.0 && Fr > 0.0)
    throw InputError(
        fmt::format("Fr = {:.4g} N: a thrust bearing with a contact angle of 90 deg cannot support "
                    "a radial load. Enter Fr = 0.",
                    Fr));
  const double P0 = factors.X0 * Fr + factors.Y0 * Fa;
  return factors.at_least_radial ? std::max(P0, Fr) : P0;
}

}  // namespace adore::life

#include "contact/roller_pocket_play.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::contact {

double roller_pocket_play(std::span<const RollerPocketFace> faces, const RollerProfile& roller) {
  double least = std::numeric_limits<double>::infinity();
  const double half = 0.5 * roller.length;
  for (const RollerPocketFace& face : faces) {
    const Mat3 to_face = passive_matrix(face.angles);
    const Vec3 normal = to_face.row(1);
    const double reach = 0.5 * face.length * std::abs(to_face(0, 0));
    const double low = std::max(face.centre[0] - reach, -half);
    const double high = std::min(face.centre[0] + reach, half);
    if (!(low <= high)) continue;
    for (const double x : {low, 0.5 * (low + high), high}) {
      const double distance = normal.dot(face.centre - Vec3(x, 0.0, 0.0));
      const double across = std::sqrt(std::max(1.0 - normal[0] * normal[0], 0.0));
      least = std::min(least, distance - roller_radius(roller, x) * across);
    }
  }
  if (!std::isfinite(least))
    throw InputError(
        "cage pocket: all guide faces are beyond the ends of the roller; change the centers "
        "bPocGsCen1 or the lengths bPocGsLen2, so that a face overlaps the roller length");
  return 2.0 * least;
}

double round_pocket_clearance(const RoundPocket& pocket, const RollerProfile& roller, double lean) {
  const Vec3 u(std::cos(lean), 0.0, std::sin(lean));
  double least = std::numeric_limits<double>::infinity();
  for (const RollerSlice& slice : pocket_slices(roller, 41))
    least = std::min(least, slice_in_round_pocket(pocket, slice.s * u, u, slice.radius).gap);
  return 2.0 * least;
}

std::vector<RollerPocketFace> widened(std::span<const RollerPocketFace> faces, double clearance) {
  std::vector<RollerPocketFace> out(faces.begin(), faces.end());
  for (RollerPocketFace& face : out) {
    const Vec3 normal = passive_matrix(face.angles).row(1);
    face.centre += 0.5 * clearance * normal;
  }
  return out;
}

}  // namespace adore::contact

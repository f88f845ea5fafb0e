#include "contact/roller_pocket.hpp"

namespace adore::contact {

std::vector<PocketFace> window_faces(double width, double z_low, double z_high,
                                     double rotation_sign, double half_angle) {
  std::vector<PocketFace> out;
  const double sine = std::sin(half_angle), cosine = std::cos(half_angle);
  for (const double side : {rotation_sign, -rotation_sign}) {
    PocketFace face;
    face.centre = {0.0, side * 0.5 * width, 0.5 * (z_low + z_high)};
    face.normal = {sine, side * cosine, 0.0};
    face.along = {cosine, -side * sine, 0.0};
    face.half_width = 0.5 * (z_high - z_low);
    out.push_back(face);
  }
  return out;
}

std::vector<PocketFace> paired_faces(std::span<const bearing::RollerPocketFace> given,
                                     double rotation_sign) {
  std::vector<PocketFace> out;
  const auto mirrored = [](const Vec3& v) { return Vec3(v[0], -v[1], v[2]); };
  for (const bearing::RollerPocketFace& one : given) {
    const Mat3 to_face = passive_matrix(one.angles);
    PocketFace face;
    face.centre = one.centre;
    face.along = to_face.row(0);
    face.normal = to_face.row(1);
    face.across = to_face.row(2);
    face.half_width = 0.5 * one.width;
    face.half_length = 0.5 * one.length;
    PocketFace mate = face;
    for (Vec3* v : {&mate.centre, &mate.along, &mate.normal, &mate.across}) *v = mirrored(*v);
    out.push_back(rotation_sign < 0.0 ? mate : face);
    out.push_back(rotation_sign < 0.0 ? face : mate);
  }
  return out;
}

std::vector<RollerSlice> pocket_slices(const RollerProfile& profile, int count) {
  std::vector<RollerSlice> out;
  for (int k = 0; k < count; ++k) {
    const double s = ((k + 0.5) / count - 0.5) * profile.length;
    out.push_back({s, roller_radius(profile, s)});
  }
  return out;
}

}  // namespace adore::contact

#include "calculators/rigid_body.hpp"

#include "calculators/json_access.hpp"

#include <nlohmann/json.hpp>

namespace adore::calculators {

dynamics::RigidBody rigid_body(const Json& in) {
  dynamics::RigidBody body;
  body.mass = get(in, "mass");
  const Vec3 I = vec3(in.at("principal_moments"));
  require(2.0 * I.maxCoeff() <= I.sum() * (1.0 + 1e-9),
          "principal_moments: the largest moment exceeds the sum of the other two, which is "
          "impossible for a rigid body. Correct the moments.");
  body.inertia = dynamics::inertia_in_geometric_axes(vec3(in.at("principal_moments")),
                                                     vec3(in.at("frame_angles_deg")) * kDegree);
  body.to_geometric_centre = vec3(in.at("mass_centre_to_geometric_centre"));
  return body;
}

namespace {

Json rigid_body_case(const Json& in) {
  const dynamics::RigidBody body = rigid_body(in);
  const Mat3 R = rotation_matrix(quaternion(in.at("quaternion_geometric_to_inertial")));
  const Vec3 omega = vec3(in.at("omega_geometric")), v = vec3(in.at("mass_centre_velocity"));
  const Vec3 force = vec3(in.at("force_inertial"));
  const Vec3 arm = body.to_geometric_centre + vec3(in.at("force_point_geometric"));
  const Vec3 moment =
      R.transpose() * vec3(in.at("moment_inertial")) + arm.cross(R.transpose() * force);
  const Vec3 a = force / body.mass, omega_rate = dynamics::euler_rate(body.inertia, omega, moment);
  return {
      {"inertia_geometric", json(body.inertia)},
      {"mass_centre_acceleration", json(a)},
      {"omega_rate_geometric", json(omega_rate)},
      {"geometric_centre_velocity", json(dynamics::geometric_centre_velocity(body, R, v, omega))},
      {"geometric_centre_acceleration",
       json(dynamics::geometric_centre_acceleration(body, R, a, omega, omega_rate))},
      {"kinetic_energy", dynamics::kinetic_energy(body, v, omega)}};
}

}  // namespace

std::vector<Adapter> rigid_body_adapters() {
  return {{"motion_frames", [](const Json& the_case) -> std::optional<Json> {
             if (kind_of(the_case) != "rigid_body") return std::nullopt;
             return rigid_body_case(the_case.at("inputs"));
           }}};
}

}  // namespace adore::calculators

#include "results/cage_whirl.hpp"

#include <cmath>

namespace adore::results {

std::string_view whirl_class_name(WhirlClass of) {
  constexpr std::array<std::string_view, 3> kNames{"resting", "whirling", "irregular"};
  return kNames.at(static_cast<std::size_t>(of));
}

Whirl classify_whirl(const std::vector<CageInstant>& instants) {
  Whirl out;
  if (instants.empty()) return out;
  const auto n = static_cast<double>(instants.size());
  double omega = 0.0, my = 0.0, mz = 0.0, angular = 0.0, square = 0.0;
  for (const CageInstant& p : instants) {
    omega += p.omega / n;
    my += p.y / n;
    mz += p.z / n;
    // y = -r sin θ, z = r cos θ: r v_t = r² θ̇ = y v_z - z v_y
    angular += p.y * p.vz - p.z * p.vy;
    square += p.y * p.y + p.z * p.z;
  }
  double moved = 0.0;
  for (const CageInstant& p : instants)
    moved += ((p.y - my) * (p.y - my) + (p.z - mz) * (p.z - mz)) / n;
  out.orbit = std::sqrt(moved);
  if (omega == 0.0 || square == 0.0) return out;
  const double whirl = angular / square;  // [rad/s]
  double left = 0.0;
  for (const CageInstant& p : instants) {
    const double r = std::hypot(p.y, p.z);
    const double tangential = r > 0.0 ? (p.y * p.vz - p.z * p.vy) / r : std::hypot(p.vy, p.vz);
    left += (tangential - r * whirl) * (tangential - r * whirl);
  }
  out.ratio = whirl / omega;
  out.deviation = std::sqrt(left / square) / std::abs(omega);
  if (out.orbit >= kRestingOrbit)
    out.of = out.deviation < kSteadyDeviation * std::abs(out.ratio) ? WhirlClass::Whirling
                                                                    : WhirlClass::Irregular;
  return out;
}

}  // namespace adore::results

#pragma once

#include "base/simd_math.hpp"
#include "contact/groove_spring.hpp"
#include "dynamics/ball_springs.hpp"

/// One ball a lane. Included by one translation unit per instruction set.
namespace adore::dynamics {
namespace {

inline void find_springs(const BallSpringsInput& in, BallSpring* out) {
  using V = SimdReal;
  using Vec = contact::Triple<V>;
  constexpr std::size_t kLanes = V::size();
  const contact::Triple<double> base_centre{in.centre[0], in.centre[1], in.centre[2]},
      base_axis{in.axis[0], in.axis[1], in.axis[2]};
  for (std::size_t first = 0; first < in.n; first += kLanes) {
    // Lanes beyond the last ball hold it once more.
    const auto read = [&](const double* from) __attribute__((always_inline)) {
      return V([&](auto lane) {
        const std::size_t k = first + lane;
        return from[in.ball[k < in.n ? k : in.n - 1]];
      });
    };
    const V sine = read(in.sin_theta), cosine = read(in.cos_theta);
    const Vec centre = contact::to_azimuth(base_centre, sine, cosine),
              axis = contact::to_azimuth(base_axis, sine, cosine);
    const Vec d{read(in.x) - centre.x, read(in.r) - centre.y, -centre.z};
    const contact::GrooveSpring<V> s =
        contact::groove_spring(d, axis, in.centre_radius, in.offset, in.K, in.follow);
    const V* const values[] = {&s.force.x, &s.force.y, &s.force.z, &s.normal.x, &s.normal.y, &s.xx,
                               &s.xy,      &s.xz,      &s.yy,      &s.yz,       &s.zz};
    constexpr std::size_t kValues = sizeof values / sizeof values[0];
    static_assert(sizeof(BallSpring) == kValues * sizeof(double));
    double rows[kValues][kLanes];
    for (std::size_t i = 0; i < kValues; ++i) values[i]->copy_to(rows[i], stdx::element_aligned);
    for (std::size_t lane = 0; lane < kLanes && first + lane < in.n; ++lane) {
      const auto of = [&](std::size_t i) { return rows[i][lane]; };
      out[first + lane] = {
          {of(0), of(1), of(2)}, {of(3), of(4)}, of(5), of(6), of(7), of(8), of(9), of(10)};
    }
  }
}

}  // namespace
}  // namespace adore::dynamics

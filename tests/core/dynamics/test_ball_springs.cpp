#include "bearing/bearing.hpp"
#include "contact/make_angle_law.hpp"
#include "dynamics/ball_springs.hpp"
#include "dynamics/constrained.hpp"
#include "dynamics/race_contacts.hpp"

#include <catch2/catch.hpp>

#include <random>
#include <vector>

/// The vector kernel of held balls against one ball by itself (constrained.hpp).
using namespace adore;
using namespace adore::dynamics;

namespace {

std::vector<std::pair<const char*, BallSpringsKernel>> kernels() {
  std::vector<std::pair<const char*, BallSpringsKernel>> out{{"baseline", ball_springs_baseline}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    out.emplace_back("avx2", ball_springs_avx2);
  if (chosen_instruction_set() == InstructionSet::Avx512)
    out.emplace_back("avx512", ball_springs_avx512);
#endif
  return out;
}

}  // namespace

TEST_CASE("springs of held balls: equal to those of each ball alone", "[unit][dynamics][held]") {
  bearing::BallGeometry balls;
  balls.diameter = 0.0127;
  balls.pitch_diameter = 0.0463;
  balls.groove_factor = {0.52, 0.515};
  balls.contact_angle = 0.4;
  contact::GrooveGeometry groove;
  groove.ball_radius = 0.00635;
  groove.groove_radius = {0.0066, 0.0065};
  groove.offset = {0.00025, 0.00015};
  groove.centre_radius = {0.0231, 0.0232};
  std::mt19937 dice(7);
  const auto in_range = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
  };
  int pressed = 0, open = 0;
  for (const auto& [name, kernel] : kernels())
    for (const bool follows : {false, true})
      for (const std::size_t n : {1U, 2U, 3U, 7U, 8U, 19U})
        for (std::size_t j = 0; j < 2; ++j) {
          std::array<contact::HertzAngleLaw, 2> law{};
          if (follows)
            for (int race = 0; race < 2; ++race)
              law[static_cast<std::size_t>(race)] = contact::make_angle_law(balls, race, 1.1e11);
          const ConstrainedBall ball(groove, {1.2e10, 1.1e10}, 0.008, law);
          const std::size_t all = n + 4;
          std::vector<double> x(all), r(all), sine(all), cosine(all), theta(all);
          std::vector<std::size_t> held;
          for (std::size_t i = 0; i < all; ++i) {
            theta[i] = in_range(0.0, 6.28);
            sine[i] = std::sin(theta[i]);
            cosine[i] = std::cos(theta[i]);
            const double angle = in_range(-0.7, 0.7);
            const double length = groove.offset[j] + in_range(-4e-6, 1.2e-5);
            const double side = j == 0 ? 1.0 : -1.0;
            x[i] = 1e-5 + length * std::sin(angle);
            r[i] = groove.centre_radius[j] + side * length * std::cos(angle);
            if (i >= 2 && held.size() < n) held.push_back(i);
          }
          const Vec3 centre(1e-5, 2e-6, -3e-6), axis = Vec3(1.0, 2e-3, -1e-3).normalized();
          BallSpringsInput in{};
          for (int i = 0; i < 3; ++i) {
            in.centre[i] = centre[i];
            in.axis[i] = axis[i];
          }
          in.centre_radius = groove.centre_radius[j];
          in.offset = groove.offset[j];
          in.K = ball.hertz_constants()[j];
          in.follow = follows ? &law[j] : nullptr;
          in.n = held.size();
          in.ball = held.data();
          in.x = x.data(), in.r = r.data(), in.sin_theta = sine.data();
          in.cos_theta = cosine.data();
          std::vector<BallSpring> found(held.size());
          kernel(in, found.data());
          for (std::size_t k = 0; k < held.size(); ++k) {
            const std::size_t i = held[k];
            const Mat3 frame = azimuth_frame(theta[i]);
            const GrooveContact one = ball.contact_with(
                static_cast<int>(j), {frame * centre, frame * axis}, Vec2(x[i], r[i]));
            const BallSpring& s = found[k];
            Mat3 stiffness;
            stiffness << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
            CAPTURE(name, follows, n, j, k, one.approach);
            // Rounding of 23 mm, 4e-18 m, over approaches of micrometres.
            const double size = one.stiffness.norm();
            CHECK((stiffness - one.stiffness).norm() <= 1e-9 * size);
            CHECK((Vec3(s.force[0], s.force[1], s.force[2]) - one.force).norm() <=
                  1e-9 * one.force.norm());
            CHECK((Vec2(s.normal[0], s.normal[1]) - one.normal.head<2>()).norm() <= 1e-12);
            (one.approach > 0.0 ? pressed : open) += 1;
          }
        }
  CHECK(pressed > 50);
  CHECK(open > 20);
}

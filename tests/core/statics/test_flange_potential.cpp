#include "contact/hertz.hpp"
#include "roller_bearings.hpp"
#include "statics/roller_flanges.hpp"
#include "statics/roller_model.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <random>

using namespace adore;
using namespace adore::statics;
using Mode = contact::FlangeContact::Mode;

namespace {

bearing::Bearing flanged(bearing::Bearing b, double height) {
  for (auto& race : b.rollers()->flange)
    for (auto& flange : race)
      if (flange) flange->height = height;
  return b;
}

}  // namespace

TEST_CASE("Flanges of every type push rollers along the gradient of their energy",
          "[physics][rollers]") {
  std::mt19937_64 engine(3);
  const auto dice = [&](double size) {
    return std::uniform_real_distribution<double>(-size, size)(engine);
  };
  std::map<Mode, int> met;
  for (const double height : {0.0014, 0.002})
    for (const auto& b : {roller_bearings::cylindrical(0.0), roller_bearings::tapered(0.0),
                          roller_bearings::spherical_tapered(0.0)}) {
      const RollerModel model = make_roller_model(flanged(b, height), {});
      REQUIRE_FALSE(model.body(0).flanges.empty());
      for (const FlangeEndPair& flange : model.body(0).flanges)
        for (int n = 0; n < 200; ++n) {
          Vec4 p(0.0, 0.5 * model.rollers.pitch_diameter + dice(2e-4),
                 -std::sin(model.rollers.axis_angle) + dice(0.01), dice(0.01));
          const auto energy = [&](const Vec4& at) {
            const double gap = flange_contact_load(flange, at).contact.gap;
            return gap < 0.0 ? 0.4 * flange.K * std::pow(-gap, 2.5) : 0.0;
          };
          // Pressed 5 µm deep along the axis.
          for (int k = 0; k < 30; ++k)
            p(0) -= (flange.side == 0 ? 1.0 : -1.0) *
                    (flange_contact_load(flange, p).contact.gap + 5e-6);
          ++met[flange_contact_load(flange, p).contact.mode];
          PairPotential sum;
          add_flange_force(flange, p, false, sum);
          REQUIRE(sum.total > 0.0);
          for (int k = 0; k < 4; ++k) {
            Vec4 step = Vec4::Zero();
            step(k) = k < 2 ? 1e-9 : 2e-7;
            const double slope = (energy(p + step) - energy(p - step)) / (2.0 * step(k));
            CAPTURE(n, k, height, p.transpose());
            CHECK(sum.gradient(k) == Approx(slope).margin(2e-4 * sum.total * (k < 2 ? 1.0 : 0.01)));
          }
        }
    }
  CHECK(met[Mode::Face] > 100);
  CHECK(met[Mode::Lip] > 100);
}

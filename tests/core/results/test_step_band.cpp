#include "results/channels.hpp"
#include "results/step_band.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace adore::results;
using adore::scene::ExtremeQuantity;
using adore::scene::Look;

namespace {

/// Two elements: outer and inner race of the first, then of the second.
Look loads(std::vector<double> values) {
  Look out;
  out[ExtremeQuantity::ContactLoad] = std::move(values);
  return out;
}

}  // namespace

TEST_CASE("step band: lowest, highest and mean value of its samples", "[unit][step-band]") {
  constexpr ExtremeQuantity kLoad = ExtremeQuantity::ContactLoad;
  StepBand band;
  CHECK(band.empty());
  band.look(loads({1.0, 3.0, 2.0, 4.0}));
  band.look(loads({5.0, 3.0, 0.0, 1.0}));
  band.look(loads({3.0, 3.0, 1.0, 1.0}));
  CHECK(band.low(kLoad, 0) == 1.0);
  CHECK(band.high(kLoad, 0) == 5.0);
  CHECK(band.mean(kLoad, 0) == 3.0);
  CHECK(band.low(kLoad, 2) == 0.0);
  CHECK(band.high(kLoad, 1) == 3.0);
  CHECK(band.low(kLoad, 1) == 3.0);
  CHECK(band.mean(kLoad, 3) == 2.0);

  std::map<std::string, double> master{{"average time", 1.0}};
  band.save(master);
  StepBand again;
  again.restore(master);
  for (StepBand* each : {&band, &again}) each->look(loads({9.0, 0.0, 9.0, 0.0}));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(again.low(kLoad, i) == band.low(kLoad, i));
    CHECK(again.high(kLoad, i) == band.high(kLoad, i));
    CHECK(again.mean(kLoad, i) == band.mean(kLoad, i));
  }
  band.clear();
  CHECK(band.empty());
  band.look(loads({7.0, 7.0, 7.0, 7.0}));
  CHECK(band.high(kLoad, 0) == 7.0);
  CHECK(band.mean(kLoad, 3) == 7.0);
  StepBand none;
  none.restore({{"average time", 1.0}});
  CHECK(none.empty());
  none.restore({{"band looks", 5.0}});  // a damaged file
  CHECK(none.empty());
}

TEST_CASE("step band: missing parts → 0, no samples → NaN", "[unit][step-band]") {
  StepBand band;
  band.look(loads({1.0, 2.0}));
  const std::vector<double> land{0.0};
  band.look(ExtremeQuantity::LandForce, land);
  band.stored();
  CHECK(band.high(ExtremeQuantity::LandForce, 0) == 0.0);
  CHECK(std::isnan(band.low(ExtremeQuantity::FlangeForce, 0)));
  CHECK(std::isnan(band.high(ExtremeQuantity::FlangeForce, 0)));
  CHECK(std::isnan(band.mean(ExtremeQuantity::ContactLoad, 2)));
  band.clear();
  band.look(ExtremeQuantity::LandForce, std::vector<double>{3.0});
  band.stored();
  CHECK(band.low(ExtremeQuantity::LandForce, 0) == 3.0);
}

TEST_CASE("step band: open contact → no influence on the extremes of its slip",
          "[unit][step-band]") {
  StepBand band;
  const auto look = [&](double slip) {
    adore::scene::Look at;
    at[ExtremeQuantity::ContactSlip] = {slip, 0.0};
    at[ExtremeQuantity::ContactLoad] = {slip > 0.0 ? 5.0 : 0.0, 0.0};
    band.look(at);
  };
  for (const double slip : {0.0, 0.3, 0.0, 0.1, 0.0}) look(slip);
  CHECK(band.low(ExtremeQuantity::ContactSlip, 0) == 0.1);
  CHECK(band.high(ExtremeQuantity::ContactSlip, 0) == 0.3);
  CHECK(band.mean(ExtremeQuantity::ContactSlip, 0) == Approx(0.2));
  CHECK(band.high(ExtremeQuantity::ContactSlip, 1) == 0.0);
  CHECK(band.low(ExtremeQuantity::ContactLoad, 0) == 0.0);  // no load is a load
  std::map<std::string, double> kept;
  band.save(kept);
  StepBand later;
  later.restore(kept);
  later.look(ExtremeQuantity::ContactSlip, std::vector<double>{0.2, 0.0});
  later.stored();
  CHECK(later.low(ExtremeQuantity::ContactSlip, 0) == 0.1);
  CHECK(later.mean(ExtremeQuantity::ContactSlip, 0) == Approx(0.2));
}

TEST_CASE("step band: equal samples → mean is that value", "[unit][step-band]") {
  StepBand band;
  for (int k = 0; k < 10; ++k) band.look(loads({0.1}));
  CHECK(band.mean(ExtremeQuantity::ContactLoad, 0) == 0.1);  // ten times 0.1 is less than 1
}

TEST_CASE("channel bands: every sampled channel has extremes and mean in its unit",
          "[unit][step-band][output]") {
  const auto all = channels();
  for (std::size_t k = 0; k < adore::scene::kExtremeQuantityCount; ++k) {
    const std::string id(channel_of(static_cast<ExtremeQuantity>(k)));
    INFO(id);
    const std::size_t at = channel_index(id);
    REQUIRE(at + 3 < all.size());
    for (const auto& [place, suffix] :
         {std::pair<std::size_t, const char*>{1, "_low"}, {2, "_high"}, {3, "_mean"}}) {
      const Channel& channel = all[at + place];
      CHECK(channel.id == id + suffix);
      CHECK(channel.unit == all[at].unit);
      CHECK(channel.per == all[at].per);
      CHECK(channel.frame == all[at].frame);
      CHECK_FALSE(channel.continuous);
      CHECK_THAT(std::string(channel.help), Catch::Contains("since the previous stored step"));
    }
  }
}

TEST_CASE("channel bands: single record → bands of zero width", "[unit][step-band][output]") {
  using namespace adore::testing;
  const adore::bearing::Bearing bearing = make_bearing();
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  const StepRecord& record = recorder.record(make_snapshot(bearing, 7));
  for (std::size_t k = 0; k < adore::scene::kExtremeQuantityCount; ++k) {
    const std::string id(channel_of(static_cast<ExtremeQuantity>(k)));
    for (const char* suffix : {"_low", "_high", "_mean"}) {
      INFO(id << suffix);
      CHECK(record[id + suffix] == record[id]);
    }
  }
}

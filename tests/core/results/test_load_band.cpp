#include "results/load_band.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace adore::results;

TEST_CASE("a load band has the lowest, highest and mean load of its looks", "[unit][load-band]") {
  LoadBand band;
  CHECK(band.empty());
  // Two elements: outer race 1, 2; inner race 3, 4, then others.
  band.look(std::vector{1.0, 2.0}, std::vector{3.0, 4.0});
  band.look(std::vector{5.0, 0.0}, std::vector{3.0, 1.0});
  band.look(std::vector{3.0, 1.0}, std::vector{3.0, 1.0});
  CHECK(band.low(0) == 1.0);
  CHECK(band.high(0) == 5.0);
  CHECK(band.mean(0) == 3.0);
  CHECK(band.low(1) == 0.0);
  CHECK(band.high(2) == 3.0);
  CHECK(band.low(2) == 3.0);
  CHECK(band.low(3) == 1.0);
  CHECK(band.mean(3) == 2.0);

  std::map<std::string, double> master{{"average time", 1.0}};
  band.save(master);
  LoadBand again;
  again.restore(master);
  for (LoadBand* each : {&band, &again}) each->look(std::vector{9.0, 9.0}, std::vector{0.0, 0.0});
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(again.low(i) == band.low(i));
    CHECK(again.high(i) == band.high(i));
    CHECK(again.mean(i) == band.mean(i));
  }
  band.clear();
  CHECK(band.empty());
  band.look(std::vector{7.0, 7.0}, std::vector{7.0, 7.0});
  CHECK(band.high(0) == 7.0);
  CHECK(band.mean(3) == 7.0);
  LoadBand none;
  none.restore({{"average time", 1.0}});
  CHECK(none.empty());
  none.restore({{"load band looks", 5.0}});  // a damaged file
  CHECK(none.empty());
}

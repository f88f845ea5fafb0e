#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>

/// The published trends of bearings in liquid oxygen, on the example deck lox-turbopump.
using namespace adore;

namespace {

double mean_power(const std::filesystem::path& folder, const char* balls, const char* thrust,
                  const char* radial) {
  deck::Deck deck = deck::new_deck("lox-turbopump");
  deck.set("kReMat", balls);
  deck.set("appLoadX", thrust);
  deck.set("appLoadZ", radial);
  std::filesystem::create_directories(folder);
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.until = "6rev";
  const runs::RunOutcome out = runs::run(request);
  INFO(out.message);
  CHECK(out.status == runs::RunStatus::Done);
  CHECK(std::abs(out.energy_residual) < 1e-4 * out.energy_scale);
  for (const results::KeyResult& one : out.summary)
    if (one.of.id == "mean_power_loss_W") return one.value;
  FAIL("the run says no mean power loss");
  return 0.0;
}

constexpr const char *kNitride = "150", *kSteel = "103";

}  // namespace

// Heat falls while thrust brings all balls to one speed, and rises with their spin under load
// (decision 337). The thrust of the least heat goes with the radial load; at 7 kN that of steel
// balls is hidden by spin, at 400 N that of nitride balls by the drag of the liquid.
TEST_CASE("liquid oxygen: hybrid bearing cooler; heat falls, then rises with thrust",
          "[physics][film]") {
  const testing::TemporaryFolder folder;
  struct Case {
    const char* radial;
    std::array<const char*, 3> thrust;
    const char* falls;  ///< of these balls
  };
  for (const Case& one : {Case{"7000.0", {"2800.0", "4900.0", "9800.0"}, kNitride},
                          Case{"400.0", {"200.0", "400.0", "6000.0"}, kSteel}}) {
    std::array<double, 3> hybrid{}, steel{};
    for (std::size_t n = 0; n < one.thrust.size(); ++n) {
      const auto of = [&](const char* balls) {
        return mean_power(folder / fmt::format("{}-{}-{}", one.radial, balls, n), balls,
                          one.thrust[n], one.radial);
      };
      hybrid[n] = of(kNitride);
      steel[n] = of(kSteel);
      CAPTURE(one.radial, one.thrust[n], hybrid[n], steel[n]);
      CHECK(hybrid[n] < 0.9 * steel[n]);
    }
    const std::array<double, 3>& heat = one.falls == kSteel ? steel : hybrid;
    CAPTURE(one.radial, one.falls, heat[0], heat[1], heat[2]);
    CHECK(heat[1] < 0.95 * heat[0]);
    CHECK(heat[2] > 1.1 * heat[1]);
  }
}

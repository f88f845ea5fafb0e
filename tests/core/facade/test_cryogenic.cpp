#include "core/facade/deck_runs.hpp"
#include "deck/templates.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>

/// The published trends of bearings in liquid oxygen, on the example deck lox-turbopump.
using namespace adore;

namespace {

double mean_power(const std::filesystem::path& folder, const char* balls, const char* thrust) {
  deck::Deck deck = deck::new_deck("lox-turbopump");
  deck.set("kReMat", balls);
  deck.set("appLoadX", thrust);
  std::filesystem::create_directories(folder);
  deck::write_deck(deck, folder / "DATA.txt");
  facade::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.until = "6rev";
  const facade::RunOutcome out = facade::run(request);
  INFO(out.message);
  CHECK(out.status == facade::RunStatus::Done);
  CHECK(std::abs(out.energy_residual) < 1e-4 * out.energy_scale);
  for (const results::KeyResult& one : out.summary)
    if (one.of.id == "mean_power_loss_W") return one.value;
  FAIL("the run says no mean power loss");
  return 0.0;
}

}  // namespace

// A radial load of 7 kN: with little thrust the balls change their contact angle and speed round
// the bearing and rub in the pockets, with much thrust they spin under load.
TEST_CASE("in liquid oxygen a hybrid bearing is cooler; heat falls, then rises with thrust",
          "[physics][film][slow]") {
  const testing::TemporaryFolder folder;
  constexpr std::array<const char*, 3> kThrust{"2800.0", "4900.0", "9800.0"};
  std::array<double, 3> hybrid{}, steel{};
  for (std::size_t n = 0; n < kThrust.size(); ++n) {
    hybrid[n] = mean_power(folder / fmt::format("hybrid{}", n), "150", kThrust[n]);
    steel[n] = mean_power(folder / fmt::format("steel{}", n), "103", kThrust[n]);
    CAPTURE(kThrust[n], hybrid[n], steel[n]);
    CHECK(hybrid[n] < 0.8 * steel[n]);
  }
  CAPTURE(hybrid[0], hybrid[1], hybrid[2]);
  CHECK(hybrid[1] < 0.95 * hybrid[0]);
  CHECK(hybrid[2] > 1.1 * hybrid[1]);
}

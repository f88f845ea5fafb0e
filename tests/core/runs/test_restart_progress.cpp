#include "runs/restart_progress.hpp"
#include "scene/ledger_terms.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace adore;
using runs::LedgerStart;

namespace {

constexpr scene::LedgerTerm kWork{scene::LedgerKind::Work, "work", "work", {"work"}, ""};

/// A bearing that turns: 50 J stored, of which nearly nothing has moved yet.
scene::EnergyLedger instant(double stored, double work) {
  scene::EnergyLedger out;
  out.add(scene::terms::kStart, 50.0);
  out.add(scene::terms::kKinetic, stored);
  out.add(kWork, work);
  return out;
}

}  // namespace

TEST_CASE("ledger of a continued run: continues despite rounding, not under other loads",
          "[unit][restart]") {
  const scene::EnergyLedger then = instant(50.0 + 1e-9, 1e-9);
  LedgerStart start;
  start.stored = 50.0;
  start.residual = then.residual();
  CHECK(start.is_continued_by(then));
  // Another processor's vector units: the last bits of what is stored, far above 1e-9 of the 1e-9 J
  // that moved.
  CHECK(start.is_continued_by(instant(50.0 + 1e-9 + 7e-15, 1e-9)));
  CHECK(start.is_continued_by(instant(50.0 + 1e-9 - 7e-15, 1e-9)));
  // Another load moves the ring by what shows.
  CHECK_FALSE(start.is_continued_by(instant(50.0 + 1e-6, 1e-9)));
  CHECK_FALSE(start.is_continued_by(instant(50.0 - 1e-6, 1e-9)));
  CHECK_FALSE(start.is_continued_by(instant(std::numeric_limits<double>::quiet_NaN(), 1e-9)));

  // Of much that moved a billionth may be lost.
  const scene::EnergyLedger later = instant(50.0, 1000.0);
  start.residual = later.residual();
  CHECK(start.is_continued_by(instant(50.0, 1000.0 + 5e-7)));
  CHECK_FALSE(start.is_continued_by(instant(50.0, 1000.0 + 5e-6)));
}

TEST_CASE("MASTER: impossible steps and counters → rejected by name", "[unit][restart]") {
  setup::RunControl control;
  control.substeps = 3;
  const auto restored = [&](const std::string& name, double value) {
    results::MasterState master;
    master.averages[name] = value;
    runs::StartPoint out;
    out.step = 7;
    return runs::restore_progress(master, control, "MASTER", out);
  };
  for (const std::string name :
       {"step from which maxStps counts", "last step in SOL1-SOL7", "last step in SOL8",
        "last step in PRINT", "last step in RESULTS", "last step of the life models"}) {
    CAPTURE(name);
    CHECK_NOTHROW(restored(name, 7.0));
    for (const double value : {-2.0, 8.0, 6.5, 1e300, -1e300})
      CHECK_THROWS_WITH(restored(name, value),
                        Catch::Matchers::Contains(name) && Catch::Matchers::Contains("to 7"));
  }
  for (const std::string name : {"counter of steps", "counter of changes of held elements",
                                 "substeps of the step under way"}) {
    CAPTURE(name);
    CHECK_NOTHROW(restored(name, 2.0));
    for (const double value : {-1.0, 0.5, 1e300})
      CHECK_THROWS_WITH(restored(name, value), Catch::Matchers::Contains(name));
  }
}

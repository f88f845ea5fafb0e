#include "facade/restart_progress.hpp"
#include "scene/ledger_terms.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace adore;
using facade::LedgerStart;

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

TEST_CASE("the ledger of a continued run goes on through rounding, and not through other loads",
          "[unit][restart]") {
  const scene::EnergyLedger then = instant(50.0 + 1e-9, 1e-9);
  LedgerStart start;
  start.stored = 50.0;
  start.residual = then.residual();
  CHECK(start.goes_on(then));
  // Another processor's vector units: the last bits of what is stored, far above 1e-9 of the 1e-9 J
  // that moved.
  CHECK(start.goes_on(instant(50.0 + 1e-9 + 7e-15, 1e-9)));
  CHECK(start.goes_on(instant(50.0 + 1e-9 - 7e-15, 1e-9)));
  // Another load moves the ring by what shows.
  CHECK_FALSE(start.goes_on(instant(50.0 + 1e-6, 1e-9)));
  CHECK_FALSE(start.goes_on(instant(50.0 - 1e-6, 1e-9)));
  CHECK_FALSE(start.goes_on(instant(std::numeric_limits<double>::quiet_NaN(), 1e-9)));

  // Of much that moved a billionth may be lost.
  const scene::EnergyLedger later = instant(50.0, 1000.0);
  start.residual = later.residual();
  CHECK(start.goes_on(instant(50.0, 1000.0 + 5e-7)));
  CHECK_FALSE(start.goes_on(instant(50.0, 1000.0 + 5e-6)));
}

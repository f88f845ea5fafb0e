#include "tribology/churning.hpp"
#include "tribology/journal_film.hpp"
#include "tribology/pocket_film.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace adore::tribology;

TEST_CASE("journal film: the quadrature meets the closed form as the squeeze vanishes",
          "[physics][hydrodynamics]") {
  const JournalFilm film{0.01, 0.04, 0.005, 1.5e-4};
  for (const double e : {0.05, 0.5, 0.9, 0.99}) {
    CAPTURE(e);
    const JournalForce closed = journal_force(film, {e, 900.0, 400.0, 0.0, 0.0}),
                       squeezed = journal_force(film, {e, 900.0, 400.0, 0.0, 1e-7});
    CHECK(squeezed.radial == Approx(closed.radial).epsilon(1e-6));
    CHECK(squeezed.tangential == Approx(closed.tangential).epsilon(1e-6));
    CHECK(closed.radial < 0.0);
    // tan φ = π √(1-ε²)/(4ε)
    CHECK(std::abs(closed.tangential / closed.radial) ==
          Approx(3.14159265358979 * std::sqrt(1.0 - e * e) / (4.0 * e)).epsilon(1e-12));
  }
}

TEST_CASE("journal film: no wedge at half the speed, a squeeze resists either way",
          "[physics][hydrodynamics]") {
  const JournalFilm film{0.01, 0.04, 0.005, 1.5e-4};
  const JournalForce whirl = journal_force(film, {0.5, 900.0, 450.0, 675.0, 0.0});
  CHECK(whirl.radial == Approx(0.0).margin(1e-12));
  CHECK(whirl.tangential == Approx(0.0).margin(1e-12));
  CHECK(journal_force(film, {0.5, 0.0, 0.0, 0.0, 50.0}).radial < 0.0);
  CHECK(journal_force(film, {0.5, 0.0, 0.0, 0.0, -50.0}).radial > 0.0);
}

TEST_CASE("drag: nothing at rest, creeping flow linear in speed, never falls with speed by a jump",
          "[physics][hydrodynamics]") {
  const Medium oil{900.0, 0.01};
  CHECK(sphere_drag(oil, 0.0, 0.01, 7.85e-5).force == 0.0);
  CHECK(disc_drag(oil, 0.0, 0.05).torque == 0.0);
  CHECK(spin_drag(oil, 0.0, 0.005).torque == 0.0);
  CHECK(annulus_drag(oil, 0.0, 0.05, 5e-4, 0.02).torque == 0.0);
  const double slow = sphere_drag(oil, 1e-7, 0.01, 7.85e-5).force;
  CHECK(sphere_drag(oil, 2e-7, 0.01, 7.85e-5).force == Approx(2.0 * slow));
  // Stokes: 3 π μ D V; the table has 27.5/Re for 24/Re.
  CHECK(slow == Approx(3.0 * 3.14159265 * 0.01 * 0.01 * 1e-7).epsilon(0.15));
  CHECK(spin_drag(oil, 1e-4, 0.005).torque ==
        Approx(8.0 * 3.14159265 * 0.01 * std::pow(0.005, 3) * 1e-4).epsilon(1e-6));
  double last = 0.0, last_spin = 0.0;
  for (double w = 1.0; w < 2e4; w *= 1.01) {
    const double torque = annulus_drag(oil, w, 0.05, 5e-4, 0.02).torque;
    const double spin = spin_drag(oil, w, 0.005).torque;
    CHECK(torque > last);
    CHECK(spin > last_spin);
    if (last > 0.0) CHECK(torque < 1.1 * last);  // blends, no steps
    last = torque;
    last_spin = spin;
  }
}

TEST_CASE("pocket film: a wedge carries more the thinner it is, a squeeze only while it closes",
          "[physics][hydrodynamics]") {
  CHECK(point_wedge_force(0.01, 5.0, 0.006, 0.006, 1e-6) >
        point_wedge_force(0.01, 5.0, 0.006, 0.006, 2e-6));
  CHECK(sphere_squeeze_force(0.01, 0.006, 1e-6, 0.01) == 0.0);
  CHECK(sphere_squeeze_force(0.01, 0.006, 1e-6, -0.01) > 0.0);
  CHECK(cylinder_squeeze_force(0.01, 0.006, 0.01, 1e-6, -0.01) >
        sphere_squeeze_force(0.01, 0.006, 1e-6, -0.01));
}

#include "core/dynamics/system_fixture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;
using bearing::PocketShape;

namespace {

constexpr std::pair<PocketShape, const char*> kShapes[] = {
    {PocketShape::Cylindrical, "cylindrical"},
    {PocketShape::Spherical, "spherical"},
    {PocketShape::Elongated, "elongated"},
    {PocketShape::Rectangular, "rectangular"},
    {PocketShape::Conical, "conical"}};

/// A cage off its center, so that several balls soon meet the walls.
bearing::Bearing rattling(PocketShape shape) {
  bearing::Bearing b = angular_contact();
  b.cage->pocket = shape;
  b.cage->pocket_clearance_2 = shape == PocketShape::Elongated ? 2e-4 : 3.2e-4;
  b.cage->start_offset = {2e-5, 1.0e-4, -1.1e-4};
  b.cage->speed_ratio = 0.97;
  b.cage->whirl_ratio = 1.5;
  return b;
}

/// All pockets shifted and tilted, the third one with its own size.
void deviate(bearing::Cage& cage) {
  cage.every_pocket.thickness = 2e-4;
  cage.every_pocket.axial = 2e-5;
  cage.every_pocket.angular = 1e-3;
  cage.every_pocket.tilt = {0.02, -0.03, 0.05};
  cage.pocket_deviation.resize(3);
  cage.pocket_deviation[2].clearance = {-5e-5, 5e-5};
  cage.pocket_deviation[2].axial = 1e-5;
}

std::vector<double> rates(const bearing::Bearing& b) {
  System system = make_system(b, full_plan());
  const std::vector<double> y = system.initial_state();
  std::vector<double> out(y.size());
  REQUIRE(system.rhs(0.0, y.data(), out.data()) == RhsStatus::Ok);
  return out;
}

struct Run {
  double residual = 0.0;  ///< largest, over the energy stored at the start
  double heat = 0.0;      ///< of the pockets [J]
};

Run run(const bearing::Bearing& b, double tolerance) {
  System system = make_system(b, full_plan());
  Adapter adapter(system);
  const std::vector<double> y0 = system.initial_state();
  system.set_start(0.0, y0);
  const auto stepper = integrators::make_stepper("rkf4");
  integrators::StepControl control;
  constexpr double kEnd = 1e-3;  // a sixth of a turn of the shaft
  control.maximum = kEnd;
  control.minimum = 1e-13;
  control.tolerance = tolerance;
  stepper->start(adapter, 0.0, y0, control);
  Run out;
  for (int k = 1; k <= 5; ++k) {
    while (stepper->time() < 0.2 * k * kEnd) stepper->step(0.2 * k * kEnd);
    const auto energy = system.snapshot(stepper->time(), stepper->state()).energy;
    out.residual =
        std::max(out.residual, std::abs(energy.residual()) / energy.sum(scene::LedgerKind::Start));
    out.heat = energy.value("pocket_heat");
  }
  return out;
}

}  // namespace

TEST_CASE("a pocket shape that is round by its clearances moves the bearing as the round one does",
          "[physics][dynamics][cage]") {
  const std::vector<double> round = rates(rattling(PocketShape::Cylindrical));
  for (const auto& [shape, clearance_2] :
       {std::pair{PocketShape::Elongated, 0.0}, {PocketShape::Conical, 3e-4}}) {
    bearing::Bearing b = rattling(shape);
    b.cage->pocket_clearance_2 = clearance_2;
    const std::vector<double> same = rates(b);
    REQUIRE(same.size() == round.size());
    double largest = 0.0, difference = 0.0;
    for (std::size_t k = 0; k < round.size(); ++k) {
      largest = std::max(largest, std::abs(round[k]));
      difference = std::max(difference, std::abs(round[k] - same[k]));
    }
    CHECK(largest > 0.0);
    CHECK(difference < 1e-9 * largest);
  }
}

TEST_CASE("pockets of every shape, with deviations and without, conserve energy and momentum",
          "[physics][dynamics][cage][energy]") {
  for (const auto& [shape, name] : kShapes)
    for (const bool deviating : {false, true}) {
      bearing::Bearing b = rattling(shape);
      if (deviating) deviate(*b.cage);
      const Run coarse = run(b, 1e-6), fine = run(b, 1e-10);
      INFO(name << (deviating ? ", deviating" : "") << ": residual " << coarse.residual << ", "
                << fine.residual << ", pocket heat " << fine.heat << " J");
      CHECK(fine.heat > 1e-4);
      CHECK(fine.residual < 1e-6);
      CHECK(fine.residual < 0.2 * coarse.residual);
    }
}

TEST_CASE("a deviation of one pocket moves the balls of that pocket only", "[physics][dynamics]") {
  const bearing::Bearing plain = rattling(PocketShape::Spherical);
  for (int what = 0; what < 5; ++what) {
    bearing::Bearing other = plain;
    other.cage->pocket_deviation.resize(1);
    bearing::PocketDeviation& first = other.cage->pocket_deviation[0];
    if (what == 0) first.clearance[0] = -1.2e-4;
    if (what == 1) first.thickness = -6e-3;
    if (what == 2) first.axial = 1.5e-4;
    if (what == 3) first.angular = 4e-3;
    if (what == 4) {  // about the pocket's own center a sphere does not feel a tilt: a face does
      other.cage->pocket = PocketShape::Conical;
      first.tilt = {0.2, 0.0, 0.0};
    }
    bearing::Bearing base = other;
    base.cage->pocket_deviation.clear();
    System changed = make_system(other, full_plan()), before = make_system(base, full_plan());
    const std::vector<double> y = before.initial_state();
    const auto now = changed.snapshot(0.0, y), was = before.snapshot(0.0, y);
    INFO("deviation " << what);
    CHECK(now.elements[0].pocket[0].gap != was.elements[0].pocket[0].gap);
    for (std::size_t i = 1; i < was.elements.size(); ++i)
      CHECK(now.elements[i].pocket[0].gap == was.elements[i].pocket[0].gap);
  }
}

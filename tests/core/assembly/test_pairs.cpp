#include "assembly/preload.hpp"
#include "base/errors.hpp"
#include "pair_folder.hpp"
#include "runs/prepare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

/// Statics of sets against single rows, closed relations and figures of makers.
using namespace adore;
using namespace adore::assembly;
using namespace adore::test;

namespace {

Assembly preloaded(const std::string& arrangement, double force, double distance = 0.04) {
  Assembly set = spaced(arrangement, distance);
  set.preload.kind = PreloadKind::Force;
  set.preload.force = force;
  return set;
}

runs::Prepared single(const std::string& deck, Sets sets) {
  runs::DeckRequest request;
  request.text = deck;
  request.deck = "single";
  request.in_memory = true;
  request.sets = std::move(sets);
  return runs::prepare(request);
}

}  // namespace

TEST_CASE("pair DB of B7012-C: stiffness and unloading force of the maker", "[physics][assembly]") {
  Sets sets = b7012c();
  sets.insert(sets.end(), {{"raceCurFac1", "0.53"}, {"raceCurFac2", "0.53"}});
  // h11 of the independent solver: E = 208 GPa, nu = 0.3, grooves 0.53, at rest.
  const std::string deck = timken_deck(sets);
  const AssemblyFolder folder(preloaded("DB", 211.0),
                              {{deck, R"({"version": 1, "matEM": "208 GPa", "matPR": 0.3})"}});
  const AssemblyResult pair = folder.solve();
  CHECK(pair.preload_unmounted == Approx(211.0).epsilon(1e-8));
  CHECK(1e-6 * result(pair.set, "stiffness_x_N_per_m") == Approx(65.85).epsilon(2e-3));
  CHECK(result(pair.set, "unloading_force_plus_N") == Approx(652.6).epsilon(2e-3));
  CHECK(result(pair.set, "unloading_force_minus_N") == Approx(-652.6).epsilon(2e-3));
  // The maker: 64.5 N/µm and 658 N.
  CHECK(1e-6 * result(pair.set, "stiffness_x_N_per_m") == Approx(64.5).epsilon(0.03));
  CHECK(result(pair.set, "unloading_force_plus_N") == Approx(658.0).epsilon(0.02));
}

TEST_CASE("pair DB: identical to two single rows at the preload", "[physics][assembly]") {
  const std::string deck = timken_deck();
  const runs::Prepared row = single(
      deck, {{"appLoadX", "560"}, {"kFS4", "1"}, {"kFS5", "1"}, {"kFS2", "1"}, {"kFS3", "1"}});
  const auto& K = row.race_result().stiffness;
  const double L = 0.04;
  const AssemblyFolder folder(preloaded("DB", 560.0, L), {{deck, ""}});
  const AssemblyResult pair = folder.solve();
  const Mat5& S = pair.loaded.state.stiffness;
  CHECK(S(0, 0) == Approx(2.0 * K(0, 0)).epsilon(1e-6));
  CHECK(S(2, 2) == Approx(2.0 * K(2, 2)).epsilon(1e-6));
  CHECK(pair.offset == Approx(2.0 * row.race_result().displacement[0]).epsilon(1e-6));
  // Tilt about y: rows are at -L/2 and L/2 plus the places of their groove centers. A turn θ moves
  // row k by -X_k θ along z and turns it by θ.
  const double x = 0.5 * L - row.bearing.balls().diameter * 0.03 * std::sin(15.0 * M_PI / 180.0);
  const double lever_force = 2.0 * x * K(2, 3) + x * x * K(2, 2);
  CHECK(S(3, 3) == Approx(2.0 * (K(3, 3) + lever_force)).epsilon(1e-3));
}

TEST_CASE("set: stiffness matrix → derivative of the load", "[unit][assembly]") {
  Assembly set = preloaded("QBT", 300.0);
  set.load = {200.0, 100.0, 900.0, 3.0, -2.0};
  set.load_position = 0.05;
  for (const bool elastic : {false, true}) {
    set.spacers.clear();
    if (elastic) set.spacers.assign(3, {0.02, 0.02, 3e8});
    const AssemblyFolder folder(set, {{timken_deck(), ""}});
    const AssemblyResult at = folder.solve();
    const Mat5& K = at.loaded.state.stiffness;
    for (int k = 0; k < 5; ++k) {
      Assembly other = set;
      const double change = k < 3 ? 0.5 : 0.02;
      other.load[static_cast<std::size_t>(k)] += change;
      // The offset of the set stays.
      other.preload = {};
      other.preload.kind = PreloadKind::Offset;
      other.preload.offset = at.offset;
      const AssemblyFolder moved(other, {{timken_deck(), ""}});
      const AssemblyResult there = moved.solve();
      const Vec5 difference = K * (there.loaded.state.q - at.loaded.state.q);
      Vec5 load = Vec5::Zero();
      load(k) = change;
      if (k == 1) load(4) = set.load_position * change;
      if (k == 2) load(3) = -set.load_position * change;
      CHECK((difference - load).norm() == Approx(0.0).margin(2e-2 * change));
    }
  }
}

TEST_CASE("set: loads of the rows → load of the set", "[physics][assembly]") {
  for (const char* arrangement : {"DB", "DF", "TBT", "QFC"}) {
    CAPTURE(arrangement);
    Assembly set = preloaded(arrangement, 400.0);
    set.load = {150.0, -300.0, 800.0, 2.0, 1.0};
    const AssemblyFolder folder(set, {{timken_deck(), ""}});
    const AssemblyResult at = folder.solve();
    Vec5 sum = Vec5::Zero();
    for (const RowResult& row : at.rows) sum += row.load;
    CHECK(sum(0) == Approx(150.0).epsilon(1e-8));
    CHECK(sum(1) == Approx(-300.0).epsilon(1e-8));
    CHECK(sum(2) == Approx(800.0).epsilon(1e-8));
    // Moments about X = 0: of the rows and of their forces, small tilts.
    double about_y = 0.0;
    for (const RowResult& row : at.rows) {
      const double reference = row.orientation * 0.03 * 0.0127 * std::sin(15.0 * M_PI / 180.0);
      about_y += row.load(3) - (row.position + reference) * row.load(2);
    }
    CHECK(about_y == Approx(2.0).margin(0.02));
  }
}

TEST_CASE("set: mirrored arrangement and load → mirrored displacement", "[unit][assembly]") {
  Assembly set = preloaded("TBT", 300.0);
  set.load = {250.0, 120.0, 700.0, 4.0, -3.0};
  const AssemblyFolder folder(set, {{timken_deck(), ""}});
  Assembly image = set;
  image.arrangement = "custom";
  image.rows[0].orientation = 1;
  image.rows[1].orientation = -1;
  image.rows[2].orientation = -1;
  image.load = {-250.0, 120.0, 700.0, -4.0, 3.0};
  const AssemblyFolder mirrored(image, {{timken_deck(), ""}});
  const Vec5 a = folder.solve().loaded.state.q, b = mirrored.solve().loaded.state.q;
  for (int k = 0; k < 5; ++k) {
    const double sign = k == 1 || k == 2 ? 1.0 : -1.0;
    CHECK(b(k) == Approx(sign * a(k)).epsilon(1e-6).margin(1e-14));
  }
}

TEST_CASE("tandem: rows share the thrust; an offset shifts the shares", "[physics][assembly]") {
  Assembly set = spaced("DT");
  set.load[0] = 1000.0;
  const AssemblyFolder folder(set, {{timken_deck(), ""}});
  const AssemblyResult equal = folder.solve();
  CHECK_FALSE(equal.opposed);
  CHECK(equal.unloading.empty());
  CHECK(axial_load(equal.rows[0].state) == Approx(500.0).epsilon(1e-8));
  CHECK(axial_load(equal.rows[1].state) == Approx(500.0).epsilon(1e-8));
  set.rows[1].offset = 2e-6;
  const AssemblyFolder ground(set, {{timken_deck(), ""}});
  const AssemblyResult uneven = ground.solve();
  CHECK(axial_load(uneven.rows[1].state) > axial_load(uneven.rows[0].state) + 50.0);
  CHECK(axial_load(uneven.rows[0].state) + axial_load(uneven.rows[1].state) ==
        Approx(1000.0).epsilon(1e-8));
}

TEST_CASE("offset from spacers, rows and preload → same preload", "[unit][assembly]") {
  const double gap = 14e-6;
  Assembly by_preload = spaced("DB"), by_rows = by_preload, by_spacers = by_preload;
  by_preload.preload.kind = PreloadKind::Offset;
  by_preload.preload.offset = gap;
  by_rows.rows[0].offset = 0.3 * gap;
  by_rows.rows[1].offset = 0.7 * gap;
  by_spacers.spacers = {{0.02, 0.02 + gap, std::numeric_limits<double>::infinity()}};
  const double force = AssemblyFolder(by_preload, {{timken_deck(), ""}}).solve().preload_unmounted;
  CHECK(force > 50.0);
  CHECK(AssemblyFolder(by_rows, {{timken_deck(), ""}}).solve().preload_unmounted ==
        Approx(force).epsilon(1e-8));
  CHECK(AssemblyFolder(by_spacers, {{timken_deck(), ""}}).solve().preload_unmounted ==
        Approx(force).epsilon(1e-8));
  // Face to face the same spacers unload.
  Assembly face = by_spacers;
  face.arrangement = "DF";
  face.rows[0].orientation = -1;
  face.rows[1].orientation = 1;
  const AssemblyResult loose = AssemblyFolder(face, {{timken_deck(), ""}}).solve();
  CHECK(loose.offset == Approx(-gap).epsilon(1e-9));
  CHECK(loose.preload_unmounted == Approx(0.0).margin(1e-6));
}

TEST_CASE("elastic spacer: in series with both rows", "[physics][assembly]") {
  Assembly set = preloaded("DB", 560.0);
  const double rigid_offset = AssemblyFolder(set, {{timken_deck(), ""}}).solve().offset;
  const double k = 2e8;
  set.spacers = {{0.02, 0.02, k}};
  const AssemblyResult soft = AssemblyFolder(set, {{timken_deck(), ""}}).solve();
  CHECK(soft.preload_unmounted == Approx(560.0).epsilon(1e-8));
  CHECK(soft.offset - rigid_offset == Approx(560.0 / k).epsilon(1e-5));
  // Row 2 hangs on the shaft by the spacer: 1/(1/k_row + 1/k).
  const double row = soft.rows[0].state.stiffness(0, 0);
  CHECK(soft.loaded.state.stiffness(0, 0) ==
        Approx(row + 1.0 / (1.0 / row + 1.0 / k)).epsilon(1e-5));
}

TEST_CASE("unloading of a pair: the other row carries the whole force", "[physics][assembly]") {
  const AssemblyResult pair = AssemblyFolder(preloaded("DB", 220.0), {{timken_deck(), ""}}).solve();
  REQUIRE(pair.unloading.size() == 2);
  REQUIRE(pair.curve.size() == static_cast<std::size_t>(kCurvePoints));
  for (const CurvePoint& point : pair.curve)
    CHECK(point.row_load[0] - point.row_load[1] == Approx(point.force).margin(1e-5));
  // Beyond the unloading force one row is left.
  CHECK(pair.curve.back().row_load[1] == Approx(0.0).margin(1e-6));
  CHECK(pair.curve.front().row_load[0] == Approx(0.0).margin(1e-6));
  CHECK(pair.unloading[1].force > 2.83 * 220.0);
  // The preload curve passes through the preload of the set.
  const PreloadPoint& last = pair.preload.back();
  CHECK(last.offset == Approx(1.5 * pair.offset));
  CHECK(last.force > 220.0 * 1.8);
  CHECK(std::is_sorted(pair.preload.begin(), pair.preload.end(),
                       [](auto& a, auto& b) { return a.force < b.force; }));
}

TEST_CASE("TIMKEN-DUPLEX as pairs: stiffness and offsets as printed", "[validation][assembly]") {
  // Timken Fafnir super precision catalog, back-to-back pairs; grooves 0.52 and 0.53 fitted to
  // 2MM210WI (experiment TIMKEN-DUPLEX). Bounds: the deviations of that table.
  struct Printed {
    const char* name;
    Sets sets;
    double from;                    ///< preload where the offset starts [N]
    double preload, axial, radial;  ///< [N, N/µm]
    double offset;                  ///< [µm]
    double share;                   ///< largest deviation of stiffness, of offset twice that
  };
  const Sets m212{
      {"bReDia", "0.015875"}, {"pitchDia", "0.085"}, {"brgBore", "0.06"}, {"brgOD", "0.11"}};
  const std::vector<Printed> rows{
      {"2MM210WI", {}, 130.0, 220.0, 64.19, 366.2, 6.35, 0.08},
      {"2MM210WI", {}, 220.0, 560.0, 95.67, 496.9, 16.76, 0.08},
      {"2MM210WI", {}, 560.0, 1220.0, 139.57, 637.9, 22.61, 0.08},
      {"3MM210WI", {{"freeConAng", "25"}}, 200.0, 490.0, 173.68, 360.1, 7.62, 0.08},
      {"3MM210WI", {{"freeConAng", "25"}}, 490.0, 1220.0, 246.43, 486.2, 13.97, 0.08},
      {"2MM212WI", m212, 330.0, 890.0, 119.11, 632.3, 22.61, 0.08}};
  for (const Printed& row : rows) {
    CAPTURE(row.name, row.preload);
    const std::string deck = timken_deck(row.sets);
    const AssemblyResult pair = AssemblyFolder(preloaded("DB", row.preload), {{deck, ""}}).solve();
    const AssemblyResult before = AssemblyFolder(preloaded("DB", row.from), {{deck, ""}}).solve();
    CHECK(1e-6 * result(pair.set, "stiffness_x_N_per_m") == Approx(row.axial).epsilon(row.share));
    CHECK(1e-6 * result(pair.set, "stiffness_z_N_per_m") == Approx(row.radial).epsilon(row.share));
    CHECK(1e6 * (pair.offset - before.offset) == Approx(row.offset).epsilon(2.0 * row.share));
  }
}

TEST_CASE("rollers: pair of tapered bearings under combined load", "[physics][assembly]") {
  const std::string deck =
      row_deck(read_text_file(source_dir() / "resources" / "decks" / "tapered.txt"), {});
  Assembly set = preloaded("DB", 2000.0, 0.06);
  set.load = {1000.0, 0.0, 4000.0, 0.0, 0.0};
  const AssemblyResult pair = AssemblyFolder(set, {{deck, ""}}).solve();
  CHECK(pair.rows[0].load(0) + pair.rows[1].load(0) == Approx(1000.0).epsilon(1e-4));
  CHECK(pair.rows[0].load(2) + pair.rows[1].load(2) == Approx(4000.0).epsilon(1e-4));
  CHECK(result(pair.set, "life_iso16281_hours") < result(pair.rows[0].of, "life_iso16281_hours"));
  CHECK(result(pair.set, "life_iso16281_hours") < result(pair.rows[1].of, "life_iso16281_hours"));
}

TEST_CASE("assembly: decks that a set cannot use → error with row and remedy", "[unit][assembly]") {
  const AssemblyFolder folder(preloaded("DB", 220.0), {{timken_deck(), ""}});
  const auto message = [&](Sets sets) {
    try {
      (void)folder.solve(std::move(sets));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message({{"mode", "0"}}).find("row 1: ") != std::string::npos);
  CHECK(message({{"noSuchVariable", "0"}}).find("noSuchVariable") != std::string::npos);
  const AssemblyFolder speeds(preloaded("DB", 220.0),
                              {{timken_deck(), ""}, {timken_deck({{"rpm2", "20"}}), ""}});
  CHECK_THROWS_WITH(speeds.solve(), Catch::Contains("row 2: the speed differs from that of row 1"));
}

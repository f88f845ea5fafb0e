#include "assembly/duplex_pair.hpp"
#include "assembly/preload.hpp"
#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "pair_folder.hpp"
#include "runs/prepare.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

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
    const AssemblyFolder folder(set, {{resting_deck(), ""}});
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
      const AssemblyFolder moved(other, {{resting_deck(), ""}});
      const AssemblyResult there = moved.solve();
      const Vec5 difference = K * (there.loaded.state.q - at.loaded.state.q);
      Vec5 load = Vec5::Zero();
      load(k) = change;
      if (k == 1) load(4) = set.load_position * change;
      if (k == 2) load(3) = -set.load_position * change;
      CHECK((difference - load).norm() == Approx(0.0).margin(2e-3 * change));
    }
  }
}

TEST_CASE("set: loads of the rows → load of the set", "[physics][assembly]") {
  for (const char* arrangement : {"DB", "DF", "TBT", "QFC"}) {
    CAPTURE(arrangement);
    Assembly set = preloaded(arrangement, 400.0);
    set.load = {150.0, -300.0, 800.0, 2.0, 1.0};
    const AssemblyFolder folder(set, {{resting_deck(), ""}});
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
  const AssemblyFolder folder(set, {{resting_deck(), ""}});
  Assembly image = set;
  image.arrangement = "custom";
  image.rows[0].orientation = 1;
  image.rows[1].orientation = -1;
  image.rows[2].orientation = -1;
  image.load = {-250.0, 120.0, 700.0, -4.0, 3.0};
  const AssemblyFolder mirrored(image, {{resting_deck(), ""}});
  const Vec5 a = folder.solve().loaded.state.q, b = mirrored.solve().loaded.state.q;
  for (int k = 0; k < 5; ++k) {
    const double sign = k == 1 || k == 2 ? 1.0 : -1.0;
    CHECK(b(k) == Approx(sign * a(k)).epsilon(1e-6).margin(1e-14));
  }
}

TEST_CASE("tandem: rows share the thrust; an offset shifts the shares", "[physics][assembly]") {
  Assembly set = spaced("DT");
  set.load[0] = 1000.0;
  const AssemblyFolder folder(set, {{resting_deck(), ""}});
  const AssemblyResult equal = folder.solve();
  CHECK_FALSE(equal.opposed);
  CHECK(equal.unloading.empty());
  CHECK(axial_load(equal.rows[0].state) == Approx(500.0).epsilon(1e-8));
  CHECK(axial_load(equal.rows[1].state) == Approx(500.0).epsilon(1e-8));
  set.rows[1].offset = 2e-6;
  const AssemblyFolder ground(set, {{resting_deck(), ""}});
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
  const double force = AssemblyFolder(by_preload, {{resting_deck(), ""}}).solve().preload_unmounted;
  CHECK(force > 50.0);
  CHECK(AssemblyFolder(by_rows, {{resting_deck(), ""}}).solve().preload_unmounted ==
        Approx(force).epsilon(1e-8));
  CHECK(AssemblyFolder(by_spacers, {{resting_deck(), ""}}).solve().preload_unmounted ==
        Approx(force).epsilon(1e-8));
  // Face to face the same spacers unload.
  Assembly face = by_spacers;
  face.arrangement = "DF";
  face.rows[0].orientation = -1;
  face.rows[1].orientation = 1;
  const AssemblyResult loose = AssemblyFolder(face, {{resting_deck(), ""}}).solve();
  CHECK(loose.offset == Approx(-gap).epsilon(1e-9));
  CHECK(loose.preload_unmounted == Approx(0.0).margin(1e-6));
}

TEST_CASE("elastic spacer: in series with both rows", "[physics][assembly]") {
  Assembly set = preloaded("DB", 560.0);
  const double rigid_offset = AssemblyFolder(set, {{resting_deck(), ""}}).solve().offset;
  const double k = 2e8;
  set.spacers = {{0.02, 0.02, k}};
  const AssemblyResult soft = AssemblyFolder(set, {{resting_deck(), ""}}).solve();
  CHECK(soft.preload_unmounted == Approx(560.0).epsilon(1e-8));
  CHECK(soft.offset - rigid_offset == Approx(560.0 / k).epsilon(1e-5));
  // The spacer connects row 2 to the shaft: 1/(1/k_row + 1/k).
  const double row = soft.rows[0].state.stiffness(0, 0);
  CHECK(soft.loaded.state.stiffness(0, 0) ==
        Approx(row + 1.0 / (1.0 / row + 1.0 / k)).epsilon(1e-5));
}

TEST_CASE("unloading of a pair: the other row carries the whole force", "[physics][assembly]") {
  const AssemblyResult pair =
      AssemblyFolder(preloaded("DB", 220.0), {{resting_deck(), ""}}).solve();
  REQUIRE(pair.unloading.size() == 2);
  REQUIRE(pair.curve.size() == static_cast<std::size_t>(kCurvePoints));
  for (const AxialCurvePoint& point : pair.curve)
    CHECK(point.row_load[0] - point.row_load[1] == Approx(point.force).margin(1e-5));
  // Beyond the unloading force one row is left.
  CHECK(pair.curve.back().row_load[1] == Approx(0.0).margin(1e-6));
  CHECK(pair.curve.front().row_load[0] == Approx(0.0).margin(1e-6));
  // A force along -X unloads row 1 (+), one along +X row 2 (-): both by the same amount, a little
  // more than 2^1.5 times the preload because the contact angle grows.
  CHECK(pair.unloading[0].row == 0);
  CHECK(pair.unloading[1].row == 1);
  CHECK(pair.unloading[0].force == Approx(-pair.unloading[1].force).epsilon(1e-6));
  CHECK(pair.unloading[1].force > 2.83 * 220.0);
  CHECK(pair.unloading[1].force < 3.2 * 220.0);
  CHECK(pair.unloading[0].displacement == Approx(-0.5 * pair.offset).epsilon(1e-5));
  // The preload curve passes through the preload of the set.
  const PreloadPoint& last = pair.preload.back();
  CHECK(last.offset == Approx(1.5 * pair.offset));
  CHECK(last.force > 220.0 * 1.8);
  CHECK(std::is_sorted(pair.preload.begin(), pair.preload.end(),
                       [](auto& a, auto& b) { return a.force < b.force; }));
}

TEST_CASE("unloading of a set of three → loads of single rows at the sum of both approaches",
          "[physics][assembly]") {
  const AssemblyResult set =
      AssemblyFolder(preloaded("TBT", 600.0), {{resting_deck(), ""}}).solve();
  REQUIRE(set.unloading.size() == 3);
  // Rows 1 and 2 (+) have 300 N each, row 3 (-) has 600 N. Where row 3 is unloaded, the shaft has
  // moved by its approach, and rows 1 and 2 have both approaches; the other way around for row 3.
  const auto approach = [](const char* thrust) {
    return single(resting_deck(), {{"appLoadX", thrust}}).race_result().displacement[0];
  };
  const std::string both = fmt::format("{:.15g}", approach("300") + approach("600"));
  const double load = single(resting_deck(), {{"appLoadX", "0"}, {"kFS1", "1"}, {"appDispX", both}})
                          .race_result()
                          .load[0];
  CHECK(set.unloading[2].force == Approx(2.0 * load).epsilon(1e-5));
  CHECK(set.unloading[0].force == Approx(-load).epsilon(1e-5));
  CHECK(set.unloading[1].force == Approx(-load).epsilon(1e-5));
}

TEST_CASE("unloading of a turning pair: the preload ends, not the contact by centrifugal force",
          "[physics][assembly]") {
  const Assembly set = preloaded("DB", 220.0);
  const auto force = [&](const char* speed) {
    const AssemblyResult pair = AssemblyFolder(set, {{timken_deck({{"rpm2", speed}}), ""}}).solve();
    return result(pair.set, "unloading_force_plus_N");
  };
  // The growth of the rings by speed changes it by 0.04 %.
  CHECK(force("300") == Approx(force("0")).epsilon(2e-3));
}

TEST_CASE("pair DB without clearance and preload → two bearings with half of the radial load",
          "[physics][assembly]") {
  Assembly set = spaced("DB");
  set.load[2] = 1600.0;
  const AssemblyResult pair = AssemblyFolder(set, {{resting_deck(), ""}}).solve();
  const runs::Prepared half =
      single(resting_deck(),
             {{"appLoadX", "0"}, {"kFS1", "1"}, {"kFS4", "1"}, {"kFS5", "1"}, {"appLoadZ", "800"}});
  CHECK(pair.loaded.state.q(2) == Approx(half.race_result().displacement[2]).epsilon(1e-6));
  CHECK(pair.rows[0].load(0) == Approx(half.race_result().load[0]).epsilon(1e-6));
  CHECK(pair.rows[1].load(0) == Approx(-half.race_result().load[0]).epsilon(1e-6));
  // Under thrust one row is alone.
  set.load = {1000.0, 0.0, 0.0, 0.0, 0.0};
  const AssemblyResult pushed = AssemblyFolder(set, {{resting_deck(), ""}}).solve();
  const runs::Prepared alone = single(resting_deck(), {{"appLoadX", "1000"}});
  CHECK(pushed.loaded.state.q(0) == Approx(alone.race_result().displacement[0]).epsilon(1e-6));
  CHECK(pushed.rows[1].state.loaded == 0);
}

TEST_CASE("TIMKEN-DUPLEX as pairs: stiffness and offsets as printed", "[validation][assembly]") {
  // Timken Fafnir super precision catalog, back-to-back pairs; grooves 0.52 and 0.53 fitted to
  // 2MM210WI (experiment TIMKEN-DUPLEX).
  const auto experiments = parse_json(
      read_text_file(source_dir() / "resources" / "experiments" / "experiments.json"), "file");
  std::size_t compared = 0;
  for (const auto& experiment : experiments.at("experiments")) {
    if (experiment.at("id") != "TIMKEN-DUPLEX") continue;
    for (const auto& run : experiment.at("runs")) {
      CAPTURE(run.at("condition").get<std::string>());
      Sets sets{{"rpm2", "0"}};
      double preload = 0.0;
      for (const auto& [name, value] : run.at("set").items())
        if (name == "appLoadX")
          preload = value.get<double>();
        else
          sets.emplace_back(name, value.dump());
      const runs::Prepared row = single(timken_deck(sets), {{"appLoadX", "100"}});
      const DuplexPair pair = duplex_pair(row, preload);
      for (const auto& figure : run.at("rows")) {
        const std::string of = figure.at("of").get<std::string>();
        const double printed = 1e6 * figure.at("theirs").get<double>();
        if (of == "pair_axial_stiffness") CHECK(pair.axial == Approx(printed).epsilon(0.04));
        if (of == "pair_radial_stiffness") CHECK(pair.radial == Approx(printed).epsilon(0.05));
        if (of == "pair_offset")
          CHECK(pair.offset - duplex_pair(row, figure.at("from").get<double>()).offset ==
                Approx(1e-12 * printed).epsilon(0.12));
        ++compared;
      }
    }
  }
  CHECK(compared > 30);
}

TEST_CASE("duplex_pair() → the set of the same rows in a folder", "[unit][assembly]") {
  const AssemblyResult folder =
      AssemblyFolder(preloaded("DB", 560.0), {{resting_deck(), ""}}).solve();
  const runs::Prepared row = single(resting_deck(), {{"appLoadX", "100"}});
  const DuplexPair pair = duplex_pair(row, 560.0);
  CHECK(pair.offset == Approx(folder.offset).epsilon(1e-8));
  CHECK(pair.axial == Approx(result(folder.set, "stiffness_x_N_per_m")).epsilon(1e-6));
  CHECK(pair.radial == Approx(result(folder.set, "stiffness_z_N_per_m")).epsilon(1e-6));
  CHECK(duplex_unloading_force(row, 560.0).value() ==
        Approx(result(folder.set, "unloading_force_plus_N")).epsilon(1e-6));
}

TEST_CASE("rollers: pair of tapered bearings under combined load", "[physics][assembly]") {
  const std::string deck =
      make_row_deck(read_text_file(source_dir() / "resources" / "decks" / "tapered.txt"), {});
  Assembly set = preloaded("DB", 2000.0, 0.06);
  set.load = {1000.0, 0.0, 4000.0, 0.0, 0.0};
  const AssemblyResult pair = AssemblyFolder(set, {{deck, ""}}).solve();
  CHECK(pair.rows[0].load(0) + pair.rows[1].load(0) == Approx(1000.0).epsilon(1e-4));
  CHECK(pair.rows[0].load(2) + pair.rows[1].load(2) == Approx(4000.0).epsilon(1e-4));
  CHECK(result(pair.set, "life_iso16281_hours") < result(pair.rows[0].of, "life_iso16281_hours"));
  CHECK(result(pair.set, "life_iso16281_hours") < result(pair.rows[1].of, "life_iso16281_hours"));
}

TEST_CASE("make_row_deck(): loads of the deck → 0, so that rows have no warning of unused loads",
          "[unit][assembly]") {
  const std::string loaded =
      read_text_file(source_dir() / "resources" / "experiments" / "timken-210.txt");
  CHECK(single(loaded, {}).input.deck.si("appLoadX") == 220.0);
  CHECK(single(make_row_deck(loaded, {}), {{"kFS1", "1"}}).input.deck.si("appLoadX") == 0.0);
  CHECK_THROWS_WITH(make_row_deck(loaded, {{"appLoadX", "5"}}),
                    Catch::Contains("loads belong to the set"));
  const auto unused = [](const AssemblyResult& result) {
    return std::any_of(result.findings.begin(), result.findings.end(), [](const Finding& one) {
      return one.text().find("is not used") != std::string::npos;
    });
  };
  const Assembly set = preloaded("DB", 220.0);
  CHECK_FALSE(unused(AssemblyFolder(set, {{make_row_deck(loaded, {}), ""}}).solve()));
  // A load that a user enters is reported.
  CHECK(unused(AssemblyFolder(set, {{loaded, ""}}).solve({{"kStif", "0"}})));
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

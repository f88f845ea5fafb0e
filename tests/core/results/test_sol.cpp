#include "base/errors.hpp"
#include "base/version.hpp"
#include "results/fortran_format.hpp"
#include "results/motion.hpp"
#include "results/sol_parser.hpp"
#include "results/sol_writer.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

#include <clocale>
#include <cstdlib>
#include <limits>
#include <locale>
#include <random>
#include <sstream>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;
namespace ff = adore::results::fortran;
using Catch::Matchers::Contains;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

std::string real(double value, int width, int digits, ff::Scale scale) {
  std::string out;
  ff::append_real(out, value, width, digits, scale);
  return out;
}
std::string one(double value) { return real(value, 16, 7, ff::Scale::One); }
std::string zero(double value) { return real(value, 16, 7, ff::Scale::Zero); }
std::string short_field(double value) { return real(value, 10, 3, ff::Scale::Zero); }
std::string integer(long long value, int width) {
  std::string out;
  ff::append_integer(out, value, width);
  return out;
}

std::string cols(const std::string& line, int first, int last) {
  return std::string(ff::columns(line, first, last));
}

}  // namespace

TEST_CASE("real field: as a Fortran program writes it", "[unit][fortran]") {
  CHECK(one(12.345678) == "   1.2345678E+01");
  CHECK(zero(12.345678) == "   0.1234568E+02");
  CHECK(one(-1.0 / 3.0) == "  -3.3333333E-01");
  CHECK(zero(-1.0 / 3.0) == "  -0.3333333E+00");
  CHECK(one(0.0) == "   0.0000000E+00");
  CHECK(zero(0.0) == "   0.0000000E+00");
  CHECK(zero(-0.0) == "   0.0000000E+00");
  CHECK(one(9.99999999) == "   1.0000000E+01");
  CHECK(zero(0.99999999) == "   0.1000000E+01");
  CHECK(short_field(-0.0123449) == "-0.123E-01");
  CHECK(short_field(1234567.0) == " 0.123E+07");
  // Three-digit exponents drop the letter.
  CHECK(one(1.5e-100) == "   1.5000000-100");
  CHECK(zero(1.5e-100) == "   0.1500000E-99");
  CHECK(zero(1.5e99) == "   0.1500000+100");
  CHECK(one(std::numeric_limits<double>::max()) == "   1.7976931+308");
  CHECK(one(std::numeric_limits<double>::denorm_min()) == "   4.9406565-324");
  CHECK(short_field(-9.9996e99) == "-0.100+101");
  // Words, stars, and the zero that may be left out.
  CHECK(one(kNan) == "             NaN");
  CHECK(one(-kInf) == "       -Infinity");
  CHECK(real(kInf, 5, 1, ff::Scale::One) == "  Inf");
  CHECK(real(1.0, 8, 3, ff::Scale::Zero) == ".100E+01");
  CHECK(real(-1.0, 9, 3, ff::Scale::Zero) == "-.100E+01");
  CHECK(real(-1.0, 8, 3, ff::Scale::Zero) == "********");
  CHECK(real(1.0, 8, 3, ff::Scale::One) == "********");
  CHECK(integer(-42, 6) == "   -42");
  CHECK(integer(1000, 3) == "***");
  std::string text;
  ff::append_text(text, "abc", 5);
  ff::append_text(text, "abcdef", 5);
  CHECK(text == "abc  abcde");
}

TEST_CASE("real field: every form reads back", "[unit][fortran]") {
  CHECK(ff::parse_real("  1.2345678E+01") == 12.345678);
  CHECK(ff::parse_real("1.2345678D+01") == 12.345678);
  CHECK(ff::parse_real("1.2345678d1") == 12.345678);
  CHECK(ff::parse_real("1.5-100") == 1.5e-100);
  CHECK(ff::parse_real("-.5+101") == -0.5e101);
  CHECK(ff::parse_real("+7") == 7.0);
  CHECK(ff::parse_real("7.") == 7.0);
  CHECK(ff::parse_real("1.0E-400") == 0.0);
  CHECK(ff::parse_real("-1.0E+400") == -kInf);
  CHECK(ff::parse_real(" Infinity") == kInf);
  CHECK(ff::parse_real("-Inf") == -kInf);
  CHECK(std::isnan(ff::parse_real("NaN").value()));
  CHECK(std::isnan(ff::parse_real("**********").value()));
  for (std::string_view wrong : {"", "   ", ".", "1.0E", "1.0E+", "1,5", "abc", "1.0.0", "--1",
                                 "1 2", "+", "1.0*", "0x10"}) {
    CAPTURE(wrong);
    CHECK_FALSE(ff::parse_real(wrong).has_value());
  }
  CHECK(ff::parse_integer("   +12") == 12);
  CHECK_FALSE(ff::parse_integer("***").has_value());
  CHECK_FALSE(ff::parse_integer("1.0").has_value());
  CHECK_FALSE(ff::parse_integer("99999999999999999999").has_value());
}

TEST_CASE("real field: written and read → loses only the hidden digits", "[unit][fortran]") {
  std::mt19937_64 random(20240607);
  std::uniform_real_distribution<double> mantissa(-10.0, 10.0);
  std::uniform_int_distribution<int> exponent(-307, 307);
  for (int i = 0; i < 20000; ++i) {
    const double value = mantissa(random) * std::pow(10.0, exponent(random));
    if (!std::isfinite(value)) continue;
    CAPTURE(value);
    for (const ff::Scale scale : {ff::Scale::One, ff::Scale::Zero}) {
      const std::string field = real(value, 16, 7, scale);
      REQUIRE(field.size() == 16);
      const double back = ff::parse_real(field).value();
      // Half a unit of the last digit shown: 1p has eight digits, without it seven.
      REQUIRE(std::abs(back - value) <=
              (scale == ff::Scale::One ? 5.1e-8 : 5.1e-7) * std::abs(value));
      REQUIRE(real(back, 16, 7, scale) == field);
    }
    const std::string narrow = short_field(value);
    REQUIRE(narrow.size() == 10);
    REQUIRE(std::abs(ff::parse_real(narrow).value() - value) <= 5.1e-3 * std::abs(value));
  }
}

TEST_CASE("theta and phi of a vector: N101", "[unit]") {
  CHECK(direction_angles(Vec3(2.0, 0.0, 0.0)).theta == 0.0);
  CHECK(direction_angles(Vec3(0.0, 0.0, 3.0)).theta == Approx(std::numbers::pi / 2));
  CHECK(direction_angles(Vec3(-1.0, 0.0, 0.0)).theta == Approx(std::numbers::pi));
  const DirectionAngles d = direction_angles(Vec3(3.0, 5.0, 4.0));
  CHECK(d.theta == Approx(std::atan2(4.0, 3.0)));
  CHECK(d.phi == Approx(std::asin(5.0 / std::sqrt(50.0))));
  CHECK(direction_angles(Vec3::Zero()).theta == 0.0);
  CHECK(direction_angles(Vec3(0.0, 1e-100, 0.0)).phi == Approx(std::numbers::pi / 2));
}

TEST_CASE("orbit motion: uniform circle → no radial motion and no angular acceleration", "[unit]") {
  const double w = 30.0, r = 2e-4, a = 2.0;
  const OrbitMotion orbit = orbit_motion(r * Vec3(0, -std::sin(a), std::cos(a)),
                                         r * w * Vec3(0, -std::cos(a), -std::sin(a)),
                                         r * w * w * Vec3(0, std::sin(a), -std::cos(a)));
  CHECK(orbit.theta == Approx(a));
  CHECK(orbit.theta_dot == Approx(w));
  // Rounding of terms of size r w² = 0.18 and r w = 0.006.
  CHECK(std::abs(orbit.r_dot) < 1e-16);
  CHECK(std::abs(orbit.r_ddot) < 1e-15);
  CHECK(std::abs(orbit.theta_ddot) < 1e-11);
  const OrbitMotion centre = orbit_motion(Vec3::Zero(), Vec3(0, 0, 2.0), Vec3(0, 0, -1.0));
  CHECK(centre.r_dot == 2.0);
  CHECK(centre.theta_dot == 0.0);
  CHECK(centre.r_ddot == Approx(-1.0));
  CHECK(orbit_motion(Vec3::Zero(), Vec3::Zero(), Vec3::Zero()).theta == 0.0);
}

TEST_CASE("SOL: header of an element file → columns of the format", "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing();
  const auto lines = lines_of(format_sol_header(make_sol_header(bearing, 2, UnitSystem::SI)));
  REQUIRE(lines.size() == 4);
  CHECK(cols(lines[0], 1, 2) == "  ");
  CHECK(cols(lines[0], 3, 14) == "Adore0.9.0  ");
  CHECK(cols(lines[0], 15, 19) == "     ");
  CHECK(cols(lines[0], 20, 34) == "synthetic run 7");
  CHECK(lines[0].size() == 55);
  CHECK(lines[1] == "  Rolling Element 2$");
  CHECK(lines[2].size() == 122);
  const std::vector<long long> expected{38, 3, 3, 1, 2, 0, 0, 5, 5, 3,
                                        3,  3, 1, 1, 1, 1, 0, 1, 0, 1};
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    CHECK(ff::parse_integer(cols(lines[2], 3 + 6 * k, 8 + 6 * k)) ==
          expected[static_cast<std::size_t>(k)]);
  }
  CHECK(lines[3].size() <= 122);
  CHECK(cols(lines[3], 3, 12) == "rpm/s     ");
  CHECK(cols(lines[3], 15, 24) == "m/s^2     ");
  CHECK(cols(lines[3], 99, 108) == "K         ");
  const auto titles = [&](int index) {
    return make_sol_header(bearing, index, UnitSystem::SI).title;
  };
  CHECK(titles(0) == "Power Dissipation and Life");
  CHECK(titles(4) == "Cage");
  CHECK(titles(5) == "Outer Race");
  CHECK(titles(6) == "Inner Race");
  CHECK_THAT(message_of([&] { (void)make_sol_header(bearing, 7, UnitSystem::SI); }),
             Contains("1 to 6"));
  const SolHeader cageless = make_sol_header(make_bearing(3, false), 4, UnitSystem::English);
  CHECK(cageless.title == "Outer Race");
  CHECK(cageless.units[8] == "lbf.in");
  CHECK(cageless.units[1] == "in/s^2");
}

TEST_CASE("SOL: step of an element file → columns of the format", "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing();
  TemporaryFolder folder;
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  SolWriter writer = SolWriter::create(folder / "SOL1", make_sol_header(bearing, 1, UnitSystem::SI),
                                       UnitSystem::SI);
  writer.write(recorder.record(make_snapshot(bearing, 12)));
  const auto lines = lines_of(read_bytes(folder / "SOL1"));
  REQUIRE(lines.size() == 4 + 1 + 5);
  CHECK(lines[4].size() == 82);
  CHECK(cols(lines[4], 3, 18) == "              12");
  CHECK(cols(lines[4], 19, 34) == one(0.12 / (2 * std::numbers::pi)));
  CHECK(cols(lines[4], 35, 50) == one(0.048 / (2 * std::numbers::pi)));
  CHECK(cols(lines[4], 51, 66) == "   1.0000000E-06");
  CHECK(cols(lines[4], 67, 82) == "   1.2000000E-04");
  for (std::size_t k = 5; k < 9; ++k) CHECK(lines[k].size() == 130);
  CHECK(lines[9].size() == 98);
  CHECK(cols(lines[5], 19, 34) == one(-4.0));  // 2 radial acceleration
  CHECK(cols(lines[5], 3, 18) ==
        one(5.0 * 30.0 / std::numbers::pi));      // 1 orbital acceleration, rpm/s
  CHECK(cols(lines[6], 115, 130) == one(100.0));  // 16 outer load
  CHECK(cols(lines[7], 3, 18) == one(1100.0));    // 17 inner load
  CHECK(cols(lines[9], 3, 18) == one(311.0));     // 33 inner race contact temperature
}

TEST_CASE("SOL1-SOL7: written files read back, in both unit systems", "[unit][sol]") {
  for (const UnitSystem units : {UnitSystem::SI, UnitSystem::English}) {
    for (const auto shape :
         {bearing::PocketShape::Cylindrical, bearing::PocketShape::Rectangular}) {
      bearing::Bearing bearing = make_bearing(5);
      bearing.cage->pocket = shape;
      for (int index = 0; index <= 8; ++index) {
        TemporaryFolder folder;
        const SolHeader header = make_sol_header(bearing, index, units);
        ChannelRecorder recorder(bearing, units, channel_table());
        std::vector<SolStep> expected;
        const std::vector<SolColumn> columns = sol_columns(header);
        REQUIRE(static_cast<int>(columns.size()) == header.value_count);
        {
          SolWriter writer = SolWriter::create(folder / "SOL", header, units);
          for (long step = 0; step < 7; ++step) {
            const StepRecord& record = recorder.record(make_snapshot(bearing, 100 * step));
            writer.write(record);
            expected.push_back(make_sol_step(header, columns, record, units));
          }
        }
        const SolFile file = read_sol(folder / "SOL", {2, 5, 3});
        CHECK(file.note.empty());
        CHECK(file.more);
        CHECK_FALSE(read_sol(folder / "SOL", {1, 7, 1}).more);
        CHECK(file.kind == sol_kind_of(header));
        CHECK(file.header.version == kFileVersion);
        CHECK(file.header.run_id == "synthetic run 7");
        CHECK(file.header.title == header.title);
        CHECK(file.header.units == header.units);
        CHECK(file.header.pocket_type == (shape == bearing::PocketShape::Rectangular ? 3 : 0));
        CHECK(file.header.pocket_surfaces == (shape == bearing::PocketShape::Rectangular ? 4 : 1));
        REQUIRE(file.steps.size() == 2);
        for (std::size_t k : {0U, 1U}) {
          const SolStep& a = file.steps[k];
          const SolStep& b = expected[1 + 3 * k];
          CHECK(a.step == b.step);
          CHECK(a.time == Approx(b.time).epsilon(1e-7));
          CHECK(a.revolutions == Approx(b.revolutions).epsilon(1e-7));
          CHECK(a.element_revolutions == Approx(b.element_revolutions).epsilon(1e-7));
          REQUIRE(a.values.size() == b.values.size());
          for (std::size_t i = 0; i < a.values.size(); ++i) {
            CAPTURE(index, i, columns[i].id);
            CHECK(a.values[i] == Approx(b.values[i]).epsilon(1e-7));  // eight digits
          }
        }
      }
    }
  }
}

TEST_CASE("SOL: values of the classic files → numbers, meanings and units of the format",
          "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing();
  const auto values = [&](int index, UnitSystem units, long step = 100) {
    ChannelRecorder recorder(bearing, units, channel_table());
    const SolHeader header = make_sol_header(bearing, index, units);
    return make_sol_step(header, sol_columns(header), recorder.record(make_snapshot(bearing, step)),
                         units)
        .values;
  };
  const double deg = 180.0 / std::numbers::pi, rpm = 30.0 / std::numbers::pi;
  const auto element = values(1, UnitSystem::SI);  // value number k stands at [k - 1]
  CHECK(element[6] == Approx(0.4 * deg));
  CHECK(element[7] == Approx(0.03501));
  CHECK(element[9] == Approx(std::atan2(0.8, 0.6) * deg));
  CHECK(element[12] == Approx(std::sqrt(2000.0 * 2000.0 + 900.0 + 250000.0) * rpm));
  CHECK(element[17] == Approx(0.1 * 1.0 * deg));
  CHECK(element[18] == Approx(0.1 * 11.0 * deg));
  CHECK(element[21] == Approx(0.2));
  CHECK(element[24] == Approx(16.5));
  CHECK(element[27] == Approx(30.0));
  const auto english = values(1, UnitSystem::English);
  CHECK(english[1] == Approx(-4.0 / 0.0254));
  CHECK(english[15] == Approx(100.0 / 4.4482216152605));
  CHECK(english[31] == Approx(301.0 * 1.8));
  CHECK(english[23] == Approx(1.5 / (4.4482216152605 * 0.0254)));

  const auto cage = values(4, UnitSystem::SI);
  REQUIRE(cage.size() == 24 + 4 * 3);
  CHECK(cage[0] == Approx(0.45));  // whirl 450 over inner race 1000 rad/s
  CHECK(cage[3] == 7.0);
  CHECK(cage[6] == 8.0);
  CHECK(cage[13] ==
        Approx(-1e-4 * std::sin(0.45) / 2e-4));  // mean radial clearance (0.3 + 0.1)/2 mm
  CHECK(cage[16] == Approx(1e-4));
  CHECK(cage[20] == Approx(0.43 * deg));
  CHECK(cage[21] == Approx(Vec3(430, 1, 2).norm() / 1000.0));
  CHECK(cage[24] == 1.0);
  CHECK(cage[28] == 2.0);  // pocket 2
  CHECK(cage[30] == Approx((3.3 + 0.02) * deg));

  const auto inner = values(6, UnitSystem::SI);
  CHECK(inner[3] == 1000.0);
  CHECK(inner[8] == 0.3);
  CHECK(inner[14] == -1e-5);
  CHECK(inner[20] == Approx(1.0 * deg));
  CHECK(inner[21] == Approx(1000.0 * rpm));

  const auto power = values(0, UnitSystem::SI);
  REQUIRE(power.size() == 17);
  CHECK(power[0] == 55.0);
  CHECK(power[3] == 0.15);
  CHECK(power[4] == -0.1);
  CHECK(power[9] ==
        Approx(1e-6 / 7e9 * 21.0));  // K/(H T) of element 1 times the integrals of both races
  CHECK(power[10] == Approx(1e-6 / 7e9 * 100.0));
  CHECK(power[11] == Approx(3e-6 / 7e9 * 101.0));
  CHECK(power[12] == Approx(2e-6 / 1e9 * 5.0));
  CHECK(power[13] == 320.0);
  CHECK(power[15] == 310.0);
  CHECK(values(0, UnitSystem::SI, 0)[9] == 0.0);  // no time, no average
}

TEST_CASE("SOL: mass center of the cage → normalized by land, pocket or unit of length",
          "[unit][sol]") {
  bearing::Bearing bearing = make_bearing();
  CHECK(cage_scale_length(*bearing.cage, 1.0) == Approx(2e-4));
  bearing.cage->lands[0].guide = bearing::GuideLand::Guide::None;
  CHECK(cage_scale_length(*bearing.cage, 1.0) == Approx(1e-4));
  bearing.cage->lands.clear();
  CHECK(cage_scale_length(*bearing.cage, 1.0) == Approx(2e-4));
  bearing.cage->pocket_clearance_1 = 0.0;
  CHECK(cage_scale_length(*bearing.cage, 0.0254) == 0.0254);
  CHECK(name_of(cage_length_scale(*bearing.cage, 1.0).of) == "unit of length");
  bearing.cage->pocket_clearance_1 = 1e-4;
  CHECK(name_of(cage_length_scale(*bearing.cage, 1.0).of) == "pockets");
  CHECK(name_of(cage_length_scale(*make_bearing().cage, 1.0).of) == "guide lands");
}

TEST_CASE("SOL: angles are continuous between records, and across a continuation", "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing();
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  // The cage whirls 450 rad/s * 4 ms = 1.8 rad between records.
  std::map<std::string, double> state;
  for (long step = 0; step <= 8; ++step) {
    if (step == 5) recorder.save(state);
    const double expected = 1.8 * static_cast<double>(step);
    CHECK(recorder.record(make_snapshot(bearing, 400 * step))["cage.orbital_position"][0] ==
          Approx(expected).margin(1e-12));
  }
  ChannelRecorder continued(bearing, UnitSystem::SI, channel_table());
  continued.restore(state);
  CHECK(continued.record(make_snapshot(bearing, 2000))["cage.orbital_position"][0] == Approx(9.0));
  ChannelRecorder fresh(bearing, UnitSystem::SI, channel_table());
  CHECK(fresh.record(make_snapshot(bearing, 2000))["cage.orbital_position"][0] ==
        Approx(9.0 - 2.0 * std::numbers::pi));
}

TEST_CASE("SOL8: columns of the format, and reads back", "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing(18);
  for (const UnitSystem units : {UnitSystem::SI, UnitSystem::English}) {
    TemporaryFolder folder;
    {
      Sol8Writer writer = Sol8Writer::create(folder / "SOL8", bearing, units);
      for (long step = 0; step < 4; ++step) writer.write(make_snapshot(bearing, 1000 * step));
    }
    const auto lines = lines_of(read_bytes(folder / "SOL8"));
    const int count = 11 * 18 + 22;
    const std::size_t per_step = 1 + (count + 12) / 13;
    REQUIRE(lines.size() == 4 + 4 * per_step);
    CHECK(cols(lines[0], 3, 12) == "Adore0.9.0");
    CHECK(cols(lines[0], 13, 17) == "     ");
    CHECK(cols(lines[0], 18, 32) == "synthetic run 7");
    CHECK(lines[1].size() == 44);
    CHECK(cols(lines[1], 3, 8) == "  1 18");
    CHECK(cols(lines[1], 39, 44) == " 12220");
    CHECK(lines[3].size() == 122);
    CHECK(lines[4].size() == 50);
    CHECK(cols(lines[4 + per_step], 3, 50) == "            1000   0.1591549E+01   0.1000000E-01");
    for (std::size_t k = 5; k < 4 + per_step - 1; ++k) CHECK(lines[k].size() == 132);
    CHECK(lines[4 + per_step - 1].size() == 2 + 10 * (count % 13));

    const Sol8File file = read_sol8(folder / "SOL8");
    const double length = units == UnitSystem::SI ? 1.0 : 0.0254,
                 force = units == UnitSystem::SI ? 1.0 : 4.4482216152605;
    CHECK(file.note.empty());
    CHECK(file.run_id == "synthetic run 7");
    CHECK(file.elements == 18);
    CHECK(file.units[0] == (units == UnitSystem::SI ? "m" : "in"));
    // e10.3 shows three digits: 0.5 % at worst.
    CHECK(file.geometry.cage_outer_radius == Approx(0.037 / length).epsilon(5e-3));
    CHECK(file.geometry.cage_outer_clearance == Approx(0.0015 / length).epsilon(5e-3));
    CHECK(file.geometry.pitch_diameter == Approx(0.07 / length).epsilon(5e-3));
    // Groove bottom: half the pitch diameter plus the ball radius and what the contact angle adds.
    CHECK(file.geometry.outer_race_inner_radius > (0.035 + 0.00635) / length);
    CHECK(file.geometry.outer_race_inner_radius < (0.035 + 0.0075) / length);
    REQUIRE(file.frames.size() == 4);
    const Sol8Frame& frame = file.frames[3];
    CHECK(frame.step == 3000);
    CHECK(frame.time == Approx(0.03));
    REQUIRE(frame.elements.size() == 18);
    CHECK(frame.elements[16].pocket_force == Approx(17.0 / force).epsilon(5e-3));
    CHECK(frame.elements[16].theta ==
          Approx(12.0 + 2 * std::numbers::pi * 16 / 18 - 6 * std::numbers::pi).epsilon(5e-3));
    CHECK(frame.elements[0].angles[0] == Approx(0.3).epsilon(5e-3));
    CHECK(frame.elements[0].pocket_angle == Approx(3.31 - 2 * std::numbers::pi).epsilon(5e-3));
    CHECK(frame.land_force[1] == Approx(8.0 / force).epsilon(5e-3));
    CHECK(frame.races[1].position[2] == Approx(-1e-5 / length).epsilon(5e-3));
    CHECK(frame.cage.angles[0] == Approx(430.0 * 0.03 - 4 * std::numbers::pi).epsilon(5e-3));
    CHECK(read_sol8(folder / "SOL8", {2, 4, 2}).frames.size() == 2);
  }
}

TEST_CASE("SOL8: more elements than the format allows → message", "[unit][sol]") {
  CHECK_FALSE(sol8_refusal(88, 1).has_value());
  CHECK_FALSE(sol8_refusal(12, 0).has_value());
  CHECK_THAT(sol8_refusal(89, 1).value(), Contains("88") && Contains("RESULTS.h5"));
  CHECK_THAT(sol8_refusal(12, 3).value(), Contains("3 segments"));
  TemporaryFolder folder;
  CHECK_THAT(
      message_of([&] { Sol8Writer::create(folder / "SOL8", make_bearing(89), UnitSystem::SI); }),
      Contains("89"));
  CHECK_FALSE(std::filesystem::exists(folder / "SOL8"));
  const bearing::Bearing many = make_bearing(88);
  Sol8Writer::create(folder / "SOL8", many, UnitSystem::SI).write(make_snapshot(many));
  CHECK(read_sol8(folder / "SOL8").frames.at(0).elements.size() == 88);
  // 200 elements are fine elsewhere.
  const bearing::Bearing huge = make_bearing(200);
  const SolHeader header = make_sol_header(huge, 201, UnitSystem::SI);
  ChannelRecorder recorder(huge, UnitSystem::SI, channel_table());
  SolWriter::create(folder / "SOL1", header, UnitSystem::SI)
      .write(recorder.record(make_snapshot(huge)));
  CHECK(read_sol(folder / "SOL1").steps.at(0).values.size() == 824);
}

TEST_CASE("SOL8: without a cage → zeros", "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing(4, false);
  TemporaryFolder folder;
  Sol8Writer::create(folder / "SOL8", bearing, UnitSystem::SI).write(make_snapshot(bearing, 3));
  const Sol8File file = read_sol8(folder / "SOL8");
  CHECK(file.geometry.cage_outer_radius == 0.0);
  CHECK(file.frames.at(0).cage.position == std::array<double, 3>{});
  CHECK(file.frames.at(0).elements.at(3).pocket_force == 0.0);
}

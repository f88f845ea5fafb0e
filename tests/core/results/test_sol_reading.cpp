#include "base/errors.hpp"
#include "base/version.hpp"
#include "results/fortran_format.hpp"
#include "results/motion.hpp"
#include "results/sol_parser.hpp"
#include "results/sol_writer.hpp"
#include "support/paths.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

#include <clocale>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>
#include <sys/resource.h>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;
namespace ff = adore::results::fortran;
using Catch::Matchers::Contains;

namespace {

std::string one(double value) {
  std::string out;
  ff::append_real(out, value, 16, 7, ff::Scale::One);
  return out;
}

}  // namespace

TEST_CASE("SOL: file cut at any byte → complete steps, or a message that it is not a SOL file",
          "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing(2);
  TemporaryFolder folder;
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  std::vector<std::size_t> ends;
  {
    SolWriter writer = SolWriter::create(
        folder / "SOL1", make_sol_header(bearing, 1, UnitSystem::SI), UnitSystem::SI);
    Sol8Writer animation = Sol8Writer::create(folder / "SOL8", bearing, UnitSystem::SI);
    for (long step = 0; step < 3; ++step) {
      writer.write(recorder.record(make_snapshot(bearing, step)));
      animation.write(make_snapshot(bearing, step));
    }
  }
  for (const std::string name : {"SOL1", "SOL8"}) {
    for (const bool crlf : {false, true}) {
      std::string text = read_bytes(folder / name);
      if (crlf) {
        std::string windows;
        for (char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
        text = windows;
      }
      std::size_t seen = 0;
      int headless = 0;
      for (std::size_t size = 0; size <= text.size(); ++size) {
        std::istringstream stream(text.substr(0, size));
        CAPTURE(name, crlf, size);
        try {
          std::size_t steps = 0;
          std::string note;
          if (name == "SOL1") {
            const SolFile file = read_sol(stream, name, {});
            steps = file.steps.size();
            note = file.note;
            for (const SolStep& step : file.steps) REQUIRE(step.values.size() == 38);
          } else {
            const Sol8File file = read_sol8(stream, name, {});
            steps = file.frames.size();
            note = file.note;
          }
          REQUIRE(steps >= seen);
          seen = steps;
          if (size == text.size()) CHECK(note.empty());
          if (!note.empty()) CHECK_THAT(note, Contains("cut off"));
        } catch (const InputError& error) {
          REQUIRE(seen == 0);
          REQUIRE_THAT(error.what(), Contains(name));
          ++headless;
        }
      }
      CHECK(seen == 3);
      CHECK(headless > 100);
    }
  }
}

TEST_CASE("SOL: files of other programs → read", "[unit][sol]") {
  TemporaryFolder folder;
  SECTION("a ball file with the listed 27 values and a twelve-column version") {
    std::string text = "  ADORE  6.7 X     old run\n  Rolling Element 1$\n  ";
    for (int value : {27, 14, 14, 1, 1, 0, 0, 5, 5, 3, 3, 3, 1, 1, 1, 1, 0, 1, 0, 1})
      ff::append_integer(text, value, 6);
    text +=
        "\n  rpm/s       m/s^2       rpm         m/s         deg         m           N           W "
        "          K\n";
    SolStep step;
    step.step = 7;
    for (int k = 1; k <= 27; ++k) step.values.push_back(k);
    append_sol_step(text, step);
    write_bytes(folder / "SOL1", text);
    const SolFile file = read_sol(folder / "SOL1");
    CHECK(file.header.version == "ADORE  6.7 X");
    CHECK(file.header.run_id == "old run");
    REQUIRE(file.steps.size() == 1);
    CHECK(file.steps[0].values[26] == 27.0);
    const auto columns = sol_columns(file.header);
    CHECK(columns[26].id == "contact.film.inner");
    CHECK(unit_of_column(file, columns[26]) == "m");
  }
  SECTION("a version of twelve columns in a SOL8 that keeps to a12") {
    Sol8File made;
    made.version = "Adore 10.20.";
    made.run_id = "x";
    made.elements = 1;
    std::string text = format_sol8_header(made);
    text.replace(0, text.find('\n'), "  Adore 10.20.     right run");
    write_bytes(folder / "SOL8", text);
    CHECK(read_sol8(folder / "SOL8").run_id == "right run");
    CHECK(sol_kind(folder / "SOL8") == SolKind::Animation);
  }
  SECTION("more values than we know, five values a line, three-digit exponents, stars") {
    std::string text = "  Other1            run\n  Rolling Element 1$\n  ";
    for (int value : {40, 2, 2, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1})
      ff::append_integer(text, value, 6);
    text +=
        "\n\n                 1   0.0000000E+00   0.0000000E+00   0.0000000E+00   0.1000000D+01\n";
    for (int k = 0; k < 40; ++k) {
      if (k % 5 == 0) text += "  ";
      text += k == 0 ? "   1.2345678-100" : k == 1 ? "****************" : one(k);
      if (k % 5 == 4) text += '\n';
    }
    write_bytes(folder / "SOL1", text);
    const SolFile file = read_sol(folder / "SOL1");
    CHECK(file.note.empty());
    REQUIRE(file.steps.size() == 1);
    CHECK(file.steps[0].time == 1.0);
    CHECK(file.steps[0].values[0] == 1.2345678e-100);
    CHECK(std::isnan(file.steps[0].values[1]));
    CHECK(file.gaps ==
          "1 value is not finite (stars: the number is too wide for its field); first occurrence: "
          "step 1");
    CHECK(file.steps[0].values[39] == 39.0);
    CHECK(sol_columns(file.header)[39].id == "value40");
    CHECK(unit_of_column(file, sol_columns(file.header)[0]).empty());
  }
  SECTION("a roller file names its flange values") {
    SolHeader header = make_sol_header(make_bearing(), 1, UnitSystem::SI);
    header.bearing_type = 2;
    header.value_count = 54;
    const auto columns = sol_columns(header);
    CHECK(columns[27].id == "flange.force.outer.1");
    CHECK(columns[38].id == "flange.heat.inner.2");
    CHECK(columns[39].id == "contact.load_slip.outer");
    CHECK(columns[45].id == "contact.rolling_heat.outer");
    CHECK(columns[49].id == "element.pocket_heat");
    CHECK(columns[53].id == "flange.damping_heat.inner.2");
  }
  SECTION("a power file with the thermal extension") {
    SolHeader header = make_sol_header(make_bearing(), 0, UnitSystem::SI);
    header.value_count = 26;
    CHECK(sol_columns(header)[22].label == "average total heat");
  }
  SECTION("a step damaged in the middle ends what is read") {
    const bearing::Bearing bearing = make_bearing(2);
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    SolWriter writer = SolWriter::create(
        folder / "SOL1", make_sol_header(bearing, 1, UnitSystem::SI), UnitSystem::SI);
    for (long step = 0; step < 3; ++step)
      writer.write(recorder.record(make_snapshot(bearing, step)));
    std::string text = read_bytes(folder / "SOL1");
    const std::size_t second = text.find("               1   ");
    text[text.find('.', second + 200)] = 'x';
    write_bytes(folder / "SOL1", text);
    const SolFile file = read_sol(folder / "SOL1");
    CHECK(file.steps.size() == 1);
    CHECK_THAT(file.note, Contains("damaged in step 1"));
  }
}

TEST_CASE("SOL: other files → message", "[unit][sol]") {
  TemporaryFolder folder;
  const auto why = [&](std::string_view bytes) {
    write_bytes(folder / "file", bytes);
    return message_of([&] { read_sol(folder / "file"); });
  };
  CHECK_THAT(why(""), Contains("missing"));
  CHECK_THAT(why("one line"), Contains("missing"));
  CHECK_THAT(why(std::string(200000, 'x')), Contains("binary"));
  CHECK_THAT(why(std::string("a\0b\n c$\n", 8)), Contains("binary"));
  CHECK_THAT(why("  v\n  t$\n      x\n\n"), Contains("integer 1"));
  CHECK_THAT(why("  v\n  t$\n     -3     1     1     1     1\n\n"),
             Contains("integer 1") && Contains("-3"));
  CHECK_THAT(why("  v\n  t$\n     33     3     3     1     9\n\n"), Contains("integer"));
  CHECK_THAT(message_of([&] { read_sol(folder / "missing"); }), Contains("cannot be opened"));
  CHECK_THAT(message_of([&] { read_sol(folder / "."); }), Contains("folder"));
  Sol8Writer::create(folder / "SOL8", make_bearing(), UnitSystem::SI);
  CHECK_THAT(message_of([&] { read_sol(folder / "SOL8"); }), Contains("animation"));
  SolWriter::create(folder / "SOL7", make_sol_header(make_bearing(), 0, UnitSystem::SI),
                    UnitSystem::SI);
  CHECK_THAT(message_of([&] { read_sol8(folder / "SOL7"); }), Contains("SOL8"));
  CHECK_THAT(message_of([&] {
               read_sol(folder / "SOL7", {0, 1, 1});
             }),
             Contains("first step of 1 or more"));
}

TEST_CASE("SOL: continued file = file written in one go", "[unit][sol]") {
  const bearing::Bearing bearing = make_bearing();
  TemporaryFolder folder;
  const SolHeader header = make_sol_header(bearing, 4, UnitSystem::SI);
  const auto write = [&](SolWriter writer, Sol8Writer animation, long from, long to) {
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    for (long step = from; step <= to; ++step) {
      writer.write(recorder.record(make_snapshot(bearing, step)));
      animation.write(make_snapshot(bearing, step));
    }
  };
  write(SolWriter::create(folder / "SOL1", header, UnitSystem::SI),
        Sol8Writer::create(folder / "SOL8", bearing, UnitSystem::SI), 0, 9);
  const std::string whole = read_bytes(folder / "SOL1"), whole8 = read_bytes(folder / "SOL8");
  // Killed in step 7, MASTER stands at step 5.
  write_bytes(folder / "SOL1", whole.substr(0, whole.size() * 7 / 10));
  write_bytes(folder / "SOL8", whole8.substr(0, whole8.size() * 8 / 10));
  write(SolWriter::continue_after(folder / "SOL1", header, UnitSystem::SI, 5),
        Sol8Writer::continue_after(folder / "SOL8", bearing, UnitSystem::SI, 5), 6, 9);
  CHECK(read_bytes(folder / "SOL1") == whole);
  CHECK(read_bytes(folder / "SOL8") == whole8);
  // A last line that lost its end is completed first.
  write_bytes(folder / "SOL1", whole.substr(0, whole.size() - 1));
  write(SolWriter::continue_after(folder / "SOL1", header, UnitSystem::SI, 9),
        Sol8Writer::continue_after(folder / "SOL8", bearing, UnitSystem::SI, 9), 10, 10);
  CHECK(read_sol(folder / "SOL1").steps.size() == 11);

  bearing::Bearing other = bearing;
  other.run_id = "another run";
  CHECK_THAT(message_of([&] {
               SolWriter::continue_after(folder / "SOL1", make_sol_header(other, 4, UnitSystem::SI),
                                         UnitSystem::SI, 5);
             }),
             Contains("synthetic run 7") && Contains("another run") && Contains("kIcOpt = -1"));
  CHECK_THAT(message_of([&] {
               SolWriter::continue_after(folder / "SOL1",
                                         make_sol_header(bearing, 4, UnitSystem::English),
                                         UnitSystem::English, 5);
             }),
             Contains("m/s^2") && Contains("in/s^2"));
  CHECK_THAT(message_of([&] {
               SolWriter::continue_after(
                   folder / "SOL1", make_sol_header(bearing, 5, UnitSystem::SI), UnitSystem::SI, 5);
             }),
             Contains("index"));
  CHECK_THAT(
      message_of([&] { SolWriter::continue_after(folder / "SOL2", header, UnitSystem::SI, 5); }),
      Contains("cannot open the file"));
  CHECK(message_of([&] { SolWriter::check(folder / "SOL1", header); }) == "no error");
  CHECK_THAT(message_of([&] {
               SolWriter::check(folder / "SOL1", make_sol_header(other, 4, UnitSystem::SI));
             }),
             Contains("another run"));
  CHECK_THAT(message_of([&] { Sol8Writer::check(folder / "SOL8", other, UnitSystem::SI); }),
             Contains("another run"));
  CHECK(read_sol(folder / "SOL1").steps.size() == 11);  // refusals cut nothing
}

TEST_CASE("SOL: folder without write permission or full disk → reported, earlier steps kept",
          "[unit][sol]") {
  TemporaryFolder folder;
  const SolHeader header = make_sol_header(make_bearing(), 0, UnitSystem::SI);
  CHECK_THAT(
      message_of([&] { SolWriter::create(folder / "no/such/SOL1", header, UnitSystem::SI); }),
      Contains("create the folder"));
  CHECK_THAT(message_of([&] { SolWriter::create("/dev/full", header, UnitSystem::SI); }),
             Contains("not a regular file"));
  {  // no room: a limit on the size of files stands for a full disk
    struct rlimit before {};
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
    const struct rlimit none { 1, before.rlim_max };
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &none) == 0);
    const std::string said =
        message_of([&] { SolWriter::create(folder / "SOL1", header, UnitSystem::SI); });
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, handler);
    CHECK_THAT(said, Contains("File too large") && Contains("disk"));
  }
  CHECK_THAT(message_of([&] { GrowingFile::open_for_append(folder / "missing", 0); }),
             Contains("cannot be written") && Contains("No such file"));
  write_bytes(folder / "short", "abc");
  CHECK_THAT(message_of([&] { GrowingFile::open_for_append(folder / "short", 10); }),
             Contains("3 bytes") && Contains("10"));
  GrowingFile file = GrowingFile::open_for_append(folder / "short", 2);
  file.append("XY");
  CHECK(file.bytes() == 4);
  CHECK(read_bytes(folder / "short") == "abXY");
}

TEST_CASE("SOL: locale with decimal comma → same bytes and values", "[unit][sol]") {
  // Whatever locale the machine has; the C++ one is made here, so the test never depends on
  // installed locales.
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const bearing::Bearing bearing = make_bearing();
  TemporaryFolder folder;
  const auto write = [&](const std::string& name) {
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    SolWriter writer = SolWriter::create(folder / name, make_sol_header(bearing, 1, UnitSystem::SI),
                                         UnitSystem::SI);
    for (long step = 0; step < 2; ++step)
      writer.write(recorder.record(make_snapshot(bearing, 123456 * step)));
    return read_sol(folder / name).steps.at(1).values;
  };
  const auto plain = write("a");
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  const auto comma = write("b");
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  CHECK(comma == plain);
  CHECK(read_bytes(folder / "a") == read_bytes(folder / "b"));
}

TEST_CASE("SOL: version of the files is that of the build", "[unit]") {
  const std::string cmake = read_bytes(adore::test::source_dir().string() + "/CMakeLists.txt");
  CHECK_THAT(cmake, Contains("project(adore VERSION " + std::string(kVersionNumber) + " "));
  CHECK(std::string(kProgramVersion) == "Adore " + std::string(kVersionNumber));
  CHECK(std::string(kFileVersion) == "Adore" + std::string(kVersionNumber));
}

#include "assembly/assembly_file.hpp"
#include "base/errors.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace adore;
using namespace adore::assembly;

namespace {

const std::string kPair = R"({"version": 1, "name": "front", "arrangement": "DB",
  "rows": [{"deck": "row-1", "position": "-9 mm", "offset": "2 µm"},
           {"deck": "b/DATA.txt", "position": 0.009}],
  "spacers": [{"inner": "20 mm", "outer": "20.005 mm", "stiffness": "800 N/um"}],
  "preload": {"class": "light", "classes": {"light": "211 N", "heavy": "1.2 kN"},
              "source": "maker's catalog", "state": "operation"},
  "load": {"x": "500 N", "z": "2 kN", "about_y": "3 N.m", "position": "-30 mm"}})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string message_of(const std::string& text) {
  try {
    (void)read_assembly(text, "ASSEMBLY.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_of(const std::string& from, const std::string& to) {
  return message_of(replaced(kPair, from, to));
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("read_assembly(): all members → SI values", "[unit][assembly]") {
  const Assembly set = read_assembly(kPair, "ASSEMBLY.json");
  CHECK(set.name == "front");
  REQUIRE(set.rows.size() == 2);
  CHECK(set.rows[0].orientation == 1);
  CHECK(set.rows[1].orientation == -1);
  CHECK(*set.rows[0].position == Approx(-0.009));
  CHECK(*set.rows[1].position == Approx(0.009));
  CHECK(set.rows[0].offset == Approx(2e-6));
  CHECK(set.spacers.at(0).stiffness == Approx(8e8));
  CHECK(set.preload.kind == PreloadKind::Force);
  CHECK(set.preload.force == Approx(211.0));
  CHECK(set.preload.in_operation);
  CHECK(set.load[0] == Approx(500.0));
  CHECK(set.load[2] == Approx(2000.0));
  CHECK(set.load[3] == Approx(3.0));
  CHECK(set.load_position == Approx(-0.03));
  CHECK(spacer_shifts(set).at(1) == Approx(-5e-6));
}

TEST_CASE("assembly_text(): written and read again → same values", "[unit][assembly]") {
  const Assembly set = read_assembly(kPair, "ASSEMBLY.json");
  const std::string text = assembly_text(set);
  const Assembly again = read_assembly(text, "ASSEMBLY.json");
  CHECK(assembly_text(again) == text);
  CHECK(again.rows[1].deck == "b/DATA.txt");
  CHECK(again.rows[0].offset == Approx(set.rows[0].offset).epsilon(1e-14));
  CHECK(again.preload.classes == set.preload.classes);
  CHECK(again.preload.source == set.preload.source);
  CHECK(again.spacers.at(0).outer == Approx(set.spacers.at(0).outer).epsilon(1e-14));
}

TEST_CASE("read_assembly(): wrong members → error with member and cause", "[unit][assembly]") {
  CHECK(has(error_of("\"version\": 1", "\"version\": 2"), "version = 2: this program reads"));
  CHECK(has(error_of("\"DB\"", "\"BD\""), "arrangement = \"BD\": unknown; enter one of DB, DF"));
  CHECK(has(error_of("\"DB\"", "\"TBT\""), "arrangement TBT has 3 rows, but rows lists 2"));
  CHECK(has(error_of("\"DB\"", "\"custom\""), "row 1: orientation is missing"));
  CHECK(has(error_of("\"name\"", "\"nome\""), "unknown member \"nome\""));
  CHECK(has(error_of("\"offset\"", "\"ofset\""), "row 1: unknown member \"ofset\""));
  CHECK(has(error_of("\"2 µm\"", "\"2 N\""), "row 1: offset = \"2 N\""));
  CHECK(has(error_of("\"2 µm\"", "true"), "offset must be a number [m] or a string with a unit"));
  CHECK(has(error_of("\"2 µm\"", "\"20 mm\""), "offset = 0.02 m: out of range"));
  CHECK(has(error_of("\"row-1\"", "\"../secret\""), "not inside the folder of the assembly"));
  CHECK(has(error_of("\"row-1\"", "\"/etc\""), "not inside the folder of the assembly"));
  CHECK(has(error_of(", \"position\": 0.009", ""), "position is missing in some rows"));
  CHECK(has(error_of("0.009", "-0.02"), "row 2: position = -0.02 m is not above that of row 1"));
  CHECK(has(error_of("\"20.005 mm\"", "\"40 mm\""), "inner and outer differ by 20 mm"));
  CHECK(has(error_of("\"class\": \"light\"", "\"class\": \"medium\""),
            "class = \"medium\": not one of the classes heavy, light"));
  CHECK(has(error_of("\"class\": \"light\"", "\"class\": \"light\", \"force\": 3"),
            "preload: give exactly one of force, offset and class"));
  CHECK(has(error_of("\"operation\"", "\"warm\""), "state = \"warm\": must be"));
  CHECK(has(error_of("\"about_y\"", "\"about_x\""), "load: unknown member \"about_x\""));
  CHECK(has(error_of("\"spacers\": [", "\"spacers\": [{\"inner\": 0, \"outer\": 0}, "),
            "spacers: 2 entries for 2 rows"));
  CHECK(has(message_of(R"({"version": 1, "arrangement": "DT",
                "rows": [{"deck": "a"}, {"deck": "a"}], "preload": {"force": "9 N"}})"),
            "all rows have the same orientation"));
}

TEST_CASE("positions(): rows without positions → side by side about the middle",
          "[unit][assembly]") {
  Assembly set = read_assembly(kPair, "ASSEMBLY.json");
  for (RowPlacement& row : set.rows) row.position.reset();
  const std::vector<double> at = positions(set, {0.018, 0.018});
  CHECK(at[1] - at[0] == Approx(0.018 + 0.020005));
  CHECK(at[0] + at[1] == Approx(0.0).margin(1e-15));
  CHECK_THROWS_AS(positions(set, {0.0, 0.018}), InputError);
}

#include "base/write_folder.hpp"
#include "results/key_results.hpp"
#include "results/sweep_table.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <tuple>

using namespace adore;
using namespace adore::results;

TEST_CASE("key results: each defined once, in SI, and recognized by plots", "[unit]") {
  std::set<std::string_view> ids;
  std::set<std::tuple<std::string_view, std::string_view, std::string_view>> names;
  for (const KeyResultSpec& spec : key_result_specs()) {
    CAPTURE(spec.id);
    CHECK(ids.insert(spec.id).second);
    REQUIRE(spec.unit != nullptr);
    CHECK(spec.unit->si_factor == 1.0);
    CHECK(names.emplace(spec.label, spec.part, spec.unit->si).second);
    CHECK(spec.id.find_first_of(", []\"") == std::string_view::npos);  // a heading of a CSV file
  }
  CHECK_THROWS(key_result("stiffness_x", 1.0));
  CHECK(find_key_result("stiffness_x").id.empty());
}

TEST_CASE("key results: a life is that of its model and modification", "[unit][life]") {
  using bearing::LifeModel;
  using bearing::LifeModification;
  const char* const models[] = {"lp", "lpu", "gz", "ih"};
  const char* const modifications[] = {"", "_stle", "_tallian"};
  for (int m = 0; m < 4; ++m)
    for (int k = 0; k < 3; ++k)
      CHECK(life_result(static_cast<LifeModel>(m), static_cast<LifeModification>(k), 1.0).of.id ==
            std::string("life_") + models[m] + modifications[k] + "_hours");
}

TEST_CASE("key results: columns of a sweep → names of the table, or headings of the file",
          "[unit]") {
  const auto path = std::filesystem::temp_directory_path() / "adore_sweep_columns.csv";
  std::string head = "appLoadX [N],exit", row = "100,0";
  for (const KeyResultSpec& spec : key_result_specs()) {
    head += "," + std::string(spec.id);
    row += ",1.5";
  }
  write_file_atomically(path, head + ",of_another_release_N,message\n" + row + ",2.5,\"\"\n");
  const SweepTable table = read_sweep(path);
  std::filesystem::remove(path);
  REQUIRE(table.columns.size() == key_result_specs().size() + 1);
  for (std::size_t i = 0; i < key_result_specs().size(); ++i) {
    // The table has the columns of a motion, whose load is that of its last instant.
    const bool at_end = key_result_specs()[i].id == "largest_contact_load_N";
    CHECK(table.columns[i].label ==
          std::string(key_result_specs()[i].label) + (at_end ? " at the end" : ""));
    CHECK(table.columns[i].part == key_result_specs()[i].part);
    CHECK(table.columns[i].unit == key_result_specs()[i].unit->si);
  }
  CHECK(table.columns.back().label == "of_another_release_N");
  CHECK(table.columns.back().unit.empty());
  CHECK(table.columns.back().values == std::vector<double>{2.5});
}

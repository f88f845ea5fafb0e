#include "core/runs/deck_runs.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "runs/run.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <set>

/// Numbers that no bearing has, in every variable of the records of decks of all types: where a run
/// is refused for one, or fails by it, it is told by its file, line, record, name and value.
using namespace adore;
namespace fs = std::filesystem;

namespace {

/// What refused a run or ended it; empty: nothing did.
std::string end_of_run(const deck::Deck& deck, const fs::path& file) {
  deck::write_deck(deck, file);
  runs::RunRequest request;
  request.deck = file;
  request.overwrite = true;
  try {
    (void)runs::run(request);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

void compare(const std::string& type) {
  const testing::TemporaryFolder folder;
  deck::Deck first = deck::new_deck(type);
  first.set_all(std::vector<std::pair<std::string, std::string>>{{"mode", "-1"}});
  REQUIRE(end_of_run(first, folder / "DATA.txt").empty());
  std::set<std::string> done;
  int tried = 0, refused = 0;
  for (const deck::RecordData& record : first.records) {
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 1; v < record.values.size(); ++v) {
      const deck::VariableSpec& variable = spec.variables[v];
      if (variable.type != deck::VarType::Real || record.values[v].empty() ||
          !done.insert(std::string(variable.name)).second)
        continue;
      std::string name(variable.name);
      if (!spec.repeat.empty()) name += fmt::format("[{}]", record.instance);
      if (variable.length != "1") name += "[1]";
      for (const char* value : {"1e9", "-1e9", "1e-30"}) {
        deck::Deck deck = first;
        deck.set(name, value);
        const std::string end = end_of_run(deck, folder / "DATA.txt");
        ++tried;
        if (end.empty()) continue;
        ++refused;
        INFO(type << ", record " << record.id << ", " << name << " = " << value << ": " << end);
        CHECK(end.find("DATA.txt:") != std::string::npos);
        CHECK(end.find(fmt::format("record {}", record.id.substr(0, record.id.find(".i")))) !=
              std::string::npos);
        CHECK(end.find(std::string(variable.name)) != std::string::npos);
      }
    }
  }
  CHECK(tried > 150);
  CHECK(refused > 60);
}

}  // namespace

TEST_CASE("impossible number → rejected with line, record and name", "[unit][beyond]") {
  compare("ball");
}

TEST_CASE("impossible numbers of roller bearings → rejected with lines, records and names",
          "[unit][beyond][slow]") {
  for (const char* type : {"cylindrical", "spherical", "tapered", "spherical-tapered"})
    compare(type);
}

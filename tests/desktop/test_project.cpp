#include "base/errors.hpp"
#include "desktop/project.hpp"

#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

/// PROJECT.json: lists of decks and runs.
using namespace adore;
using desktop::Project;
namespace fs = std::filesystem;

namespace {

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace

TEST_CASE("project: added decks and runs → relative names, and the same after it is moved",
          "[unit][desktop]") {
  const QTemporaryDir temporary;
  const fs::path base = temporary.path().toStdString();
  const fs::path folder = base / "one", moved = base / "two";
  fs::create_directories(folder / "out");
  write(folder / "DATA.txt", "deck");
  write(folder / "out" / "RUN.json", "{}");
  Project project = Project::open_or_create(folder);
  CHECK_FALSE(fs::exists(folder / desktop::kProjectFile));
  CHECK(project.add_deck(folder / "DATA.txt"));
  CHECK(project.add_run(folder / "out"));
  CHECK_FALSE(project.add_run(folder / "." / "out"));
  CHECK(project.add_run(base / "elsewhere"));
  project.save();
  CHECK(bytes_of(folder / desktop::kProjectFile).find("\"../elsewhere\"") != std::string::npos);
  fs::rename(folder, moved);
  CHECK(desktop::is_project(moved));
  CHECK(desktop::is_project(moved / "PROJECT.json"));
  CHECK_FALSE(desktop::is_project(moved / "out"));
  const Project again = Project::open(moved);
  REQUIRE(again.decks().size() == 1);
  CHECK(again.decks()[0].path == fs::absolute(moved) / "DATA.txt");
  CHECK_FALSE(again.decks()[0].missing);
  REQUIRE(again.runs().size() == 2);
  CHECK(again.runs()[0].name == "out");
  CHECK_FALSE(again.runs()[0].missing);
  CHECK(again.runs()[1].missing);  // listed, not fatal
}

TEST_CASE("project: unknown members → kept when it is saved", "[unit][desktop]") {
  const QTemporaryDir temporary;
  const fs::path folder = temporary.path().toStdString();
  write(folder / "PROJECT.json",
        R"({"format": "adore-project", "version": 1, "decks": [], "runs": [], "notes": {"a": 1}})");
  Project project = Project::open_or_create(folder);
  project.add_run(folder / "out");
  project.save();
  CHECK(bytes_of(folder / "PROJECT.json").find("\"notes\"") != std::string::npos);
}

TEST_CASE("project: damaged or newer file → a message, and the same bytes", "[unit][desktop]") {
  const QTemporaryDir temporary;
  const fs::path folder = temporary.path().toStdString();
  const fs::path file = folder / "PROJECT.json";
  for (const auto& [text, reason] :
       {std::pair<std::string, std::string>{"{\"format\": \"adore-pro", "damaged"},
        {"[]", "damaged"},
        {R"({"format": "other", "version": 1})", "not a project"},
        {R"({"format": "adore-project"})", "no version"},
        {R"({"format": "adore-project", "version": 2})", "newer program"},
        {R"({"format": "adore-project", "version": 1, "runs": [3]})", "list of names"}}) {
    INFO(text);
    write(file, text);
    CHECK_THROWS_WITH(Project::open(file),
                      Catch::Contains(reason) && Catch::Contains("PROJECT.json"));
    CHECK_THROWS_AS(Project::open_or_create(folder), InputError);
    CHECK(bytes_of(file) == text);
  }
  CHECK_THROWS_AS(Project::open(folder / "none" / "PROJECT.json"), InputError);
}

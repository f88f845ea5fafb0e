#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// The dependency rule of the design: a folder may include itself and what stands here.
const std::map<std::string, std::set<std::string>> kAllowed = {
    {"base", {}},
    {"deck", {"base"}},
    {"bearing", {"base"}},
    {"contact", {"base", "bearing"}},
    {"tribology", {"base", "bearing"}},
    {"integrators", {}},
    {"statics", {"base", "bearing", "contact", "tribology"}},
    {"thermal", {"base", "bearing", "contact", "statics"}},
    {"dynamics", {"base", "bearing", "contact", "tribology", "statics"}},
    {"life", {"base", "bearing", "contact", "tribology", "statics", "dynamics"}},
    {"build",
     {"base", "deck", "bearing", "contact", "tribology", "statics", "dynamics", "integrators"}},
    {"results", {"base", "deck", "bearing", "contact", "tribology", "statics", "dynamics", "life"}},
    {"facade",
     {"base", "deck", "bearing", "contact", "tribology", "statics", "thermal", "dynamics",
      "integrators", "life", "build", "results"}},
};
/// Apps see core through deck, results and facade only; base holds errors and files.
const std::set<std::string> kAppsMaySee = {"base", "deck", "results", "facade"};

std::vector<fs::path> sources(const fs::path& folder) {
  std::vector<fs::path> out;
  if (!fs::exists(folder)) return out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".hpp" || entry.path().extension() == ".cpp")
      out.push_back(entry.path());
  return out;
}

struct Include {
  std::string target;
  bool quoted = false;
};

std::vector<Include> includes(const fs::path& file) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> out;
  std::ifstream stream(file);
  std::string line;
  std::smatch match;
  while (std::getline(stream, line))
    if (std::regex_search(line, match, pattern)) out.push_back({match[2], match[1] == "\""});
  return out;
}

std::string first_folder(const std::string& target) { return target.substr(0, target.find('/')); }

bool is_qt(const Include& include) { return !include.quoted && include.target[0] == 'Q'; }

}  // namespace

TEST_CASE("core folders include only what the dependency rule allows", "[unit][architecture]") {
  const fs::path core = fs::path(ADORE_SOURCE_DIR) / "core";
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(core)) {
    if (!entry.is_directory()) continue;
    const std::string folder = entry.path().filename().string();
    INFO("core/" << folder << " has no line in the dependency rule");
    REQUIRE(kAllowed.count(folder) == 1);
    for (const fs::path& file : sources(entry.path()))
      for (const Include& include : includes(file)) {
        INFO(file.string() << " includes " << include.target);
        CHECK_FALSE(is_qt(include));
        if (!include.quoted) continue;
        ++seen;
        const std::string target = first_folder(include.target);
        CHECK((target == folder || kAllowed.at(folder).count(target) == 1));
      }
  }
  CHECK(seen > 50);
}

TEST_CASE("apps reach the core through deck, results and facade only", "[unit][architecture]") {
  for (const std::string app : {"desktop", "adrplot", "agore", "adrinput"})
    for (const fs::path& file : sources(fs::path(ADORE_SOURCE_DIR) / app))
      for (const Include& include : includes(file)) {
        if (!include.quoted) continue;
        INFO(file.string() << " includes " << include.target);
        const std::string target = first_folder(include.target);
        const bool own =
            target == app || target == "desktop" || include.target.find('/') == std::string::npos;
        CHECK((own || kAppsMaySee.count(target) == 1));
      }
}

TEST_CASE("the command line uses Qt in its picture commands only", "[unit][architecture]") {
  for (const fs::path& file : sources(fs::path(ADORE_SOURCE_DIR) / "cli"))
    for (const Include& include : includes(file)) {
      INFO(file.string() << " includes " << include.target);
      CHECK((!is_qt(include) || file.filename() == "pictures_qt.cpp"));
    }
}

#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

using Rule = std::map<std::string, std::set<std::string>>;

std::string text_of(const fs::path& file) { return adore::test::bytes_of(file); }

/// Dependency rule: core/CMakeLists.txt lists the folders that a folder may include.
Rule dependency_rule() {
  Rule rule;
  const std::string text = text_of(adore::test::source_dir() / "core" / "CMakeLists.txt");
  static const std::regex library(R"(adore_core_library\((\w+)([^)]*)\))");
  for (std::sregex_iterator match(text.begin(), text.end(), library), end; match != end; ++match) {
    std::set<std::string>& allowed = rule[(*match)[1]];
    std::istringstream words((*match)[2]);
    bool depends = false;
    for (std::string word; words >> word;) {
      if (word == "DEPENDS" || word == "LINK")
        depends = word == "DEPENDS";
      else if (depends)
        allowed.insert(word);
    }
  }
  return rule;
}
/// Parts of the core for applications: values, files, pages and drawings, runs, designs and
/// studies.
const std::set<std::string> kAppsMaySee = {"base",    "deck",        "results",      "listing",
                                           "drawing", "calculators", "runs",         "design",
                                           "studies", "assembly",    "command_line", "signal"};

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
  const fs::path core = adore::test::source_dir() / "core";
  const Rule rule = dependency_rule();
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(core)) {
    if (!entry.is_directory()) continue;
    const std::string folder = entry.path().filename().string();
    if (folder == "python") continue;  // sees the core as an app does
    INFO("core/" << folder << " has no line in the dependency rule");
    REQUIRE(rule.count(folder) == 1);
    for (const fs::path& file : sources(entry.path()))
      for (const Include& include : includes(file)) {
        INFO(file.string() << " includes " << include.target);
        CHECK_FALSE(is_qt(include));
        if (!include.quoted) continue;
        ++seen;
        const std::string target = first_folder(include.target);
        CHECK((target == folder || rule.at(folder).count(target) == 1));
      }
  }
  CHECK(seen > 50);
}

TEST_CASE("apps include only the core folders for values, files, drawings and runs",
          "[unit][architecture]") {
  for (const std::string app : {"desktop", "adrplot", "agore", "adrinput", "core/python"})
    for (const fs::path& file : sources(adore::test::source_dir() / app))
      for (const Include& include : includes(file)) {
        if (!include.quoted) continue;
        INFO(file.string() << " includes " << include.target);
        const std::string target = first_folder(include.target);
        const bool own =
            target == app || target == "desktop" || include.target.find('/') == std::string::npos;
        const bool routines = app == "core/python" && target == "user";  // hands functions over
        CHECK((own || routines || kAppsMaySee.count(target) == 1));
      }
}

TEST_CASE("effects are included only by dynamics", "[unit][architecture]") {
  for (const auto& entry : fs::directory_iterator(adore::test::source_dir() / "core")) {
    if (!entry.is_directory() || entry.path().filename() == "dynamics") continue;
    for (const fs::path& file : sources(entry.path()))
      for (const Include& include : includes(file)) {
        INFO(file.string() << " includes " << include.target);
        CHECK(include.target.rfind("dynamics/effects/", 0) == std::string::npos);
        CHECK(include.target != "dynamics/evaluation.hpp");
      }
  }
}

TEST_CASE("numbers are read independently of the locale", "[unit][architecture]") {
  // Qt and other programs that call us set the user's locale: in a German one stod("7.5") is 7.
  static const std::regex reader(R"(\b(stod|stof|stold|strtod|strtof|atof|sscanf)\s*\()");
  for (const std::string folder : {"core", "cli", "desktop", "adrplot", "agore", "adrinput"})
    for (const fs::path& file : sources(adore::test::source_dir() / folder)) {
      INFO(file.string());
      CHECK_FALSE(std::regex_search(text_of(file), reader));
    }
}

TEST_CASE("the command line uses Qt in its picture commands only", "[unit][architecture]") {
  for (const fs::path& file : sources(adore::test::source_dir() / "cli"))
    for (const Include& include : includes(file)) {
      INFO(file.string() << " includes " << include.target);
      CHECK((!is_qt(include) || file.parent_path().filename() == "pictures"));
    }
}

TEST_CASE("the picture of the core's folders is the dependency rule", "[unit][architecture]") {
  std::ifstream page(adore::test::source_dir() / "resources/docs/architecture.md");
  static const std::regex arrow(R"(  (\w+) --> (\w+))");
  Rule drawn;
  std::smatch match;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, match, arrow)) drawn[match[2]].insert(match[1]);
  // The picture leaves out arrows that others imply.
  const Rule rule = dependency_rule();
  const auto reaches = [&](const std::string& from, const std::string& to,
                           const auto& self) -> bool {
    const auto found = drawn.find(to);
    if (found == drawn.end()) return false;
    for (const std::string& before : found->second)
      if (before == from || self(from, before, self)) return true;
    return false;
  };
  for (const auto& [folder, allowed] : rule)
    for (const std::string& dependency : allowed) {
      INFO("no way from " << dependency << " to " << folder << " in architecture.md");
      CHECK(reaches(dependency, folder, reaches));
    }
  for (const auto& [folder, before] : drawn)
    for (const std::string& dependency : before) {
      INFO("architecture.md draws " << dependency << " --> " << folder);
      CHECK(rule.at(folder).count(dependency) == 1);
    }
}

TEST_CASE("citations: every reading and output rule in the code is in the docs",
          "[unit][architecture]") {
  const fs::path root = adore::test::source_dir();
  const std::string readings = text_of(root / "resources/docs/readings.md");
  const std::string outputs = text_of(root / "resources/docs/outputs.md");
  static const std::regex number(R"(\bN(\d{1,3})\b)"),
      section(R"(outputs\.md (?:§)?(\d+(?:\.\d+)?))");
  int seen = 0;
  for (const std::string folder : {"core", "cli", "desktop", "adrinput", "adrplot", "agore"})
    for (const fs::path& file : sources(root / folder)) {
      std::ifstream stream(file);
      for (std::string line; std::getline(stream, line);) {
        // Code has template parameters of this shape; readings are cited in comments.
        const std::size_t comment = line.find("//");
        if (comment == std::string::npos) continue;
        const std::string words = line.substr(comment);
        INFO(file.string() << ": " << words);
        for (std::sregex_iterator m(words.begin(), words.end(), number), end; m != end; ++m, ++seen)
          CHECK(readings.find("| N" + (*m)[1].str() + " |") != std::string::npos);
        for (std::sregex_iterator m(words.begin(), words.end(), section), end; m != end;
             ++m, ++seen)
          CHECK(outputs.find("# " + (*m)[1].str()) != std::string::npos);
      }
    }
  CHECK(seen > 50);
}

TEST_CASE("decisions: entries have numbers of their own, stand in the index, and resolve citations",
          "[unit][architecture]") {
  const fs::path root = adore::test::source_dir(), folder = root / "resources/docs/decisions";
  const std::string index = text_of(folder / "README.md");
  static const std::regex heading(R"((?:^|\n)## (\d{3,4}(?:, \d{3,4})*) ([^\n]+))"),
      number(R"(\d{3,4})");
  std::set<std::string> numbers;
  std::size_t entries = 0;
  for (const auto& file : fs::directory_iterator(folder)) {
    const std::string name = file.path().filename().string();
    if (name == "README.md") continue;
    CHECK(index.find("](" + name + ")") != std::string::npos);
    const std::string page = text_of(file.path());
    for (std::sregex_iterator m(page.begin(), page.end(), heading), end; m != end; ++m, ++entries) {
      const std::string of = (*m)[1], line = "- " + of + ": " + (*m)[2].str();
      INFO(name << ": " << of);
      CHECK(index.find(line) != std::string::npos);
      for (std::sregex_iterator n(of.begin(), of.end(), number); n != end; ++n)
        CHECK(numbers.insert(n->str()).second);
    }
  }
  CHECK(entries >= 100);
  CHECK(std::count(index.begin(), index.end(), '\n') > static_cast<std::ptrdiff_t>(entries));

  // "decision 041", "decisions 800 and 815", "(decision 041, 063)", also over a line's end.
  static const std::regex cited(
      R"([Dd]ecisions?[ \n/#*]+(\d{3,4}(?:(?:, | and |, and )\d{3,4})*))");
  int citations = 0;
  for (const char* part : {"core", "desktop", "adrinput", "adrplot", "agore", "cli", "tests"})
    for (const fs::path& file : sources(root / part)) {
      const std::string words = text_of(file);
      for (std::sregex_iterator m(words.begin(), words.end(), cited), end; m != end; ++m) {
        const std::string list = (*m)[1];
        for (std::sregex_iterator n(list.begin(), list.end(), number); n != end; ++n, ++citations) {
          INFO(file.string() << ": decision " << n->str());
          CHECK(numbers.count(n->str()) == 1);
        }
      }
    }
  CHECK(citations > 50);
}

TEST_CASE("no dialog is deleted as it closes, before its answer has been used",
          "[unit][architecture]") {
  std::vector<std::string> found;
  for (const char* app : {"desktop", "adrinput", "adrplot", "agore"})
    for (const fs::path& file : sources(adore::test::source_dir() / app)) {
      if (file.filename() == "dialogs.hpp") continue;  // with a reason
      std::istringstream lines(text_of(file));
      for (std::string line; std::getline(lines, line);)
        if (line.find("WA_DeleteOnClose") != std::string::npos) found.push_back(line);
    }
  // Windows of studies have no answer; all others are gone by desktop::delete_when_done().
  CHECK(found.size() == 2);
  for (const std::string& line : found) {
    INFO(line);
    CHECK(line.find("window->setAttribute") != std::string::npos);
  }
}

TEST_CASE("every window keeps letters with Alt from its fields", "[unit][architecture]") {
  int windows = 0;
  for (const char* app : {"adrinput", "adrplot", "agore"})
    for (const fs::path& header : sources(adore::test::source_dir() / app)) {
      if (header.extension() != ".hpp" ||
          text_of(header).find(": public QMainWindow") == std::string::npos)
        continue;
      ++windows;
      INFO(header);
      const fs::path source = fs::path(header).replace_extension(".cpp");
      CHECK(text_of(source).find("desktop::MenuKeys(*this)") != std::string::npos);
    }
  CHECK(windows == 4);
}

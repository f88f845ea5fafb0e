#include "base/counted.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

/// "1 pages": a number before a word in the plural is written by counted(), unless it is never 1.
namespace fs = std::filesystem;

TEST_CASE("counted: one thing is no plural", "[unit]") {
  CHECK(adore::counted(1, "page") == "1 page");
  CHECK(adore::counted(0, "page") == "0 pages");
  CHECK(adore::counted(12345UL, "step") == "12345 steps");
  CHECK(adore::counted(1, "spectrum", "spectra") == "1 spectrum");
  CHECK(adore::counted(2, "spectrum", "spectra") == "2 spectra");
}

TEST_CASE("sentences of AdrPlot's sources write no number before a plural", "[unit]") {
  // Numbers that are 2 at least where the sentence is said.
  const std::set<std::string> several{"Of every {} steps",
                                      "The last {} steps",
                                      "at {} of {} steps",
                                      "{} of {} steps {} no",
                                      "of {} of {} steps",
                                      "not hold {} of the {} steps",
                                      "needs at least {} stored steps",
                                      "{} and {} more sentences"};
  const std::regex plural(
      R"((\{[^}"]*\}|%[0-9]) (more |stored |other )*)"
      R"((steps|turns|files|points|runs|curves|values|pages|frames|pictures|spectra|names|messages|sentences|rows|lines)\b)");
  std::string found;
  int files = 0;
  for (const char* folder : {"adrplot", "desktop"})
    for (const auto& entry : fs::directory_iterator(adore::test::source_dir() / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      ++files;
      const std::string text = adore::test::bytes_of(entry.path());
      for (std::sregex_iterator hit(text.begin(), text.end(), plural), end; hit != end; ++hit) {
        const auto at = static_cast<std::size_t>(hit->position());
        const std::string around = text.substr(at > 30 ? at - 30 : 0, 90);
        bool allowed = false;
        for (const std::string& one : several)
          allowed = allowed || around.find(one) != std::string::npos;
        // A sentence with another one for 1 beside it.
        const std::string before = text.substr(at > 160 ? at - 160 : 0, at > 160 ? 160 : at);
        allowed = allowed || before.find("== 1") != std::string::npos;
        if (!allowed) found += entry.path().filename().string() + ": " + hit->str() + "\n";
      }
    }
  CHECK(files > 60);
  CHECK(found == "");
}

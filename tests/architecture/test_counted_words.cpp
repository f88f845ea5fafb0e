#include "base/counted.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

/// "1 pages": a number before a word in the plural is written by counted(), unless it is never 1.
namespace fs = std::filesystem;

TEST_CASE("counted(): one item → singular form", "[unit]") {
  CHECK(adore::counted(1, "page") == "1 page");
  CHECK(adore::counted(0, "page") == "0 pages");
  CHECK(adore::counted(12345UL, "step") == "12345 steps");
  CHECK(adore::counted(1, "spectrum", "spectra") == "1 spectrum");
  CHECK(adore::counted(2, "spectrum", "spectra") == "2 spectra");
  CHECK(adore::counted(std::string("1"), "turn") == "1 turn");
  CHECK(adore::counted(std::string("0.5"), "turn") == "0.5 turns");
  CHECK(adore::counted(std::string("1.5"), "body", "bodies") == "1.5 bodies");
}

namespace {

/// Sentences with a number before a plural in a source; none of `allowed`, none with another one
/// for 1 beside it, and no "3 of {} steps", "{} x {} points".
std::string plurals_in(const fs::path& file, const std::set<std::string>& allowed) {
  static const std::regex plural(
      R"((\{[^}"]*\}|%[0-9]) (more |stored |other |numbered |cage )*)"
      R"((steps|turns|revolutions|files|points|runs|curves|values|pages|frames|pictures|spectra|)"
      R"(names|messages|sentences|rows|lines|elements|segments|bodies|speeds|iterations|rounds|)"
      R"(calls|cases|variables|characters|problems|hours|processes|pieces|indices|fields|numbers|)"
      R"(settings|dimensions|warnings|remarks|errors|rollers|balls)\b)");
  const std::string text = adore::test::bytes_of(file);
  std::string found;
  for (std::size_t start = 0, stop = 0; start < text.size(); start = stop + 1) {
    stop = std::min(text.find('\n', start), text.size());
    const std::string line = text.substr(start, stop - start);
    if (line.find('"') == std::string::npos || line.find_first_of("{%") == std::string::npos)
      continue;
    for (std::sregex_iterator hit(line.begin(), line.end(), plural), end; hit != end; ++hit) {
      const std::size_t at = start + static_cast<std::size_t>(hit->position());
      const std::string around = text.substr(at > 40 ? at - 40 : 0, 110);
      bool fine = text.substr(at > 160 ? at - 160 : 0, at > 160 ? 160 : at).find("== 1") !=
                  std::string::npos;
      const std::string before = text.substr(at > 8 ? at - 8 : 0, at > 8 ? 8 : at);
      for (const char* part : {"of ", "f its ", "f the ", "x ", "e last "})
        fine = fine || before.ends_with(part);
      for (const std::string& one : allowed) fine = fine || around.find(one) != std::string::npos;
      if (!fine) found += file.filename().string() + ": " + hit->str() + "\n";
    }
  }
  return found;
}

}  // namespace

TEST_CASE("sentences of the sources write no number before a plural", "[unit]") {
  // Numbers that are 2 at least, or 0, where the sentence is said; decimals that are never "1".
  const std::set<std::string> several{"One of every {} steps",
                                      "The last {} steps",
                                      "needs at least {} stored steps",
                                      "{} and {} more sentences",  //
                                      "{:.3f} revolutions",        // "1.000"
                                      "{} from {} to {}, {} runs",
                                      "at most {} characters",
                                      "is {} characters long",
                                      "an interval of {} frames draws nothing",
                                      "more than {:g} pictures",
                                      "one of every %1 frames",
                                      "a movie of {} pictures per second is empty",
                                      "{} pockets cannot be shared equally",
                                      "publish it): {} elements of",
                                      "{} elements do not fit",
                                      "the bearing has {} elements",  // more than 40
                                      "the file has {} lines",
                                      "a deck has at most {} lines",
                                      "a table has at most {} lines",
                                      "a study has {} runs at most",
                                      "{} elements of {} mm on a pitch diameter",
                                      "an array of {} values",
                                      "as in a deck, {} values",
                                      "has {:.2g} {} steps per period",
                                      "this bearing has {} segments",
                                      "gives {} values per step, but {} rolling",
                                      "{} balls; there must be at least one",
                                      "{} rollers; there must be at least one",
                                      "the study has {:.3g} runs, more than the limit",
                                      "{} cage segments, ",
                                      "the study has more than {} runs",
                                      "{} names none",
                                      "{} names no set",
                                      "The ratings apply to all {} rows",
                                      "is narrower than {} lines"};
  std::string found;
  int files = 0;
  for (const char* folder : {"adrinput", "adrplot", "agore", "cli", "core", "desktop"})
    for (const auto& entry : fs::recursive_directory_iterator(adore::test::source_dir() / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      ++files;
      found += plurals_in(entry.path(), several);
    }
  CHECK(files > 600);
  CHECK(found == "");
}

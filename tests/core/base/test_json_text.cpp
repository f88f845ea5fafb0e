#include "base/json_text.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

using namespace adore;
using Catch::Matchers::Contains;

namespace {

std::string refusal(const std::string& text) {
  try {
    (void)parse_json(text, "IN.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string nested(int levels) {
  return std::string(static_cast<std::size_t>(levels), '[') +
         std::string(static_cast<std::size_t>(levels), ']');
}

}  // namespace

TEST_CASE("JSON: 64 levels of arrays and objects → read, deeper → error", "[unit][json]") {
  CHECK(refusal(nested(kMaxNesting)) == "no error");
  CHECK_THAT(refusal(nested(kMaxNesting + 1)),
             Contains("IN.json is not valid JSON") && Contains("more than 64 levels"));
  CHECK_THAT(refusal(nested(50000)), Contains("64 levels"));
  CHECK_THAT(refusal(std::string(200000, '[')), Contains("64 levels"));
  std::string objects;
  for (int k = 0; k < 1000; ++k) objects += "{\"a\":";
  CHECK_THAT(refusal(objects), Contains("64 levels"));
}

TEST_CASE("JSON: invalid text → one bounded printable line", "[unit][json]") {
  for (const std::string& text :
       {std::string("{ \"a\": "), std::string("nope"), std::string(), std::string("{\"a\": 1e999}"),
        "\"" + std::string(100000, '\xff'), std::string("\x1b[2J"), std::string("{\"a\": 1,}")}) {
    const std::string said = refusal(text);
    CHECK_THAT(said, Contains("IN.json is not valid JSON: "));
    CHECK(said.size() < 260);
    for (const char c : said) CHECK((c >= 0x20 && c < 0x7f));
  }
}

TEST_CASE("JSON: foreign files → parsed in one place", "[unit][json]") {
  // Tables that the program carries, and an option's value, are no foreign files.
  const std::set<std::string> own{"core/base/json_text.hpp",
                                  "core/base/validity.cpp",
                                  "core/bearing/material_laws.cpp",
                                  "core/bearing/material.cpp",
                                  "core/tribology/fluid.cpp",
                                  "core/tribology/lubricant.cpp",
                                  "core/tribology/lubricant_range.cpp",
                                  "core/life/constants.cpp",
                                  "core/runs/option_file.cpp"};
  namespace fs = std::filesystem;
  const fs::path root = adore::test::source_dir();
  for (const char* folder : {"core", "cli", "desktop", "adrinput", "adrplot", "agore"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp") continue;
      const std::string text = adore::test::bytes_of(entry.path());
      const std::string name = fs::relative(entry.path(), root).generic_string();
      if (own.count(name) > 0) continue;
      CAPTURE(name);
      CHECK(text.find("son::parse(") == std::string::npos);
    }
}

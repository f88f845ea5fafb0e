#include "base/errors.hpp"
#include "base/excerpt.hpp"

#include <catch2/catch.hpp>

#include <string>

using adore::excerpt;

TEST_CASE("excerpt(): short value → quoted whole, long one → its start", "[unit][base]") {
  CHECK(excerpt("12.7 mm") == "12.7 mm");
  CHECK(excerpt(std::string(200, 'x')) == std::string(200, 'x'));
  CHECK(excerpt(std::string(1'000'000, 'x')) == std::string(80, 'x') + "… (1000000 bytes)");
}

TEST_CASE("excerpt(): any length → characters are never cut", "[unit][base]") {
  for (int before = 0; before < 4; ++before) {
    std::string text(static_cast<std::size_t>(77 + before), 'x');
    const std::size_t start = text.size();
    for (int i = 0; i < 100; ++i) text += "\xF0\x9D\x9B\xBC";  // four bytes
    const std::string quoted = excerpt(text);
    const std::size_t end = quoted.find("…");
    INFO(quoted);
    REQUIRE(end != std::string::npos);
    CHECK(end <= 80);
    CHECK((end - start) % 4 == 0);
  }
}

TEST_CASE("issue: value of a megabyte → text that a window can show", "[unit][base]") {
  adore::Issue issue;
  issue.record = "3.1";
  issue.variable = "nRe";
  issue.value = std::string(1'000'000, '9');
  issue.message = "not a number";
  const std::string text = issue.text();
  CHECK(text.size() < 400);
  CHECK(text.find("not a number") != std::string::npos);
}

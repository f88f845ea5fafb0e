#include "deck/templates.hpp"
#include "facade/check.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace adore;

namespace {

const Issue* find(const std::vector<Issue>& issues, Severity severity, const std::string& phrase) {
  const auto found = std::find_if(issues.begin(), issues.end(), [&](const Issue& issue) {
    return issue.severity == severity && issue.text().find(phrase) != std::string::npos;
  });
  return found == issues.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("a motion that cannot be run has its geometry checked all the same", "[unit][check]") {
  deck::Deck deck = deck::new_deck("tapered");
  deck.set("mode", "0");
  deck.complete();
  auto issues = facade::check_model(deck);
  CHECK(find(issues, Severity::Note, "will refuse this deck") != nullptr);
  CHECK(find(issues, Severity::Error, "") == nullptr);
  deck.set("bReEndRad1", "0.001");  // smaller than the roller: no such end
  issues = facade::check_model(deck);
  CHECK(find(issues, Severity::Note, "will refuse this deck") != nullptr);
  CHECK(find(issues, Severity::Error, "radius") != nullptr);

  deck::Deck cylindrical = deck::new_deck("cylindrical");
  cylindrical.set("bReCrn", "0.001");
  CHECK(find(facade::check_model(cylindrical), Severity::Error, "crown radius") != nullptr);
}

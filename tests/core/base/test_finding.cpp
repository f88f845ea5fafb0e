#include "base/finding.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <string>

using adore::Finding;
using adore::Issue;
using adore::Severity;

namespace {

Issue issue(Severity severity, std::string message, std::string code = {}) {
  Issue out;
  out.severity = severity;
  out.message = std::move(message);
  out.code = std::move(code);
  return out;
}

}  // namespace

TEST_CASE("finding: any sentence without a code → deck.<severity>", "[unit][base]") {
  for (const adore::FindingKind& kind : adore::finding_kinds())
    for (const std::string& text : {kind.code, kind.meaning, kind.quantity}) {
      INFO(text);
      CHECK(Finding(issue(kind.severity, text)).code ==
            fmt::format("deck.{}", adore::severity_word(kind.severity)));
    }
}

TEST_CASE("finding: code of an issue → quantity and unit of the register, severity of the issue",
          "[unit][base]") {
  const Finding one(issue(Severity::Note, "any text", "fit.clearance"));
  CHECK(one.code == "fit.clearance");
  CHECK(one.quantity == "clearance");
  CHECK(one.unit == "m");
  CHECK(one.severity == Severity::Note);
  CHECK_THROWS_AS(Finding(issue(Severity::Note, "any text", "fit.no_such_code")),
                  adore::InternalError);
}

TEST_CASE("finding: other code → value, bounds and body stay", "[unit][base]") {
  const Finding film =
      adore::make_finding("film.thick", "text").of("outer race").measure(0.01, 0.003).at_least(0.0);
  const Finding thermal = adore::renamed(film, "thermal.film_doubt", "from step 2 on: text");
  CHECK(thermal.code == "thermal.film_doubt");
  CHECK(thermal.severity == Severity::Note);
  CHECK(thermal.measured == film.measured);
  CHECK(thermal.limit == film.limit);
  CHECK(thermal.least == film.least);
  CHECK(thermal.quantity == film.quantity);
  CHECK(thermal.body == "outer race");
}

TEST_CASE("finding: quantity and unit of its own → instead of those of the register",
          "[unit][base]") {
  const Finding one =
      adore::make_finding("statics.held", "text").measure("displacement about y", 1e-3, "rad");
  CHECK(one.quantity == "displacement about y");
  CHECK(one.unit == "rad");
  CHECK(one.measured == 1e-3);
}

#include "facade/check.hpp"

#include "build/build_bearing.hpp"
#include "facade/prepare.hpp"
#include "thermal/operating.hpp"

#include <algorithm>
#include <utility>

namespace adore::facade {

namespace {

bool has_error(const std::vector<Issue>& issues) {
  return std::any_of(issues.begin(), issues.end(),
                     [](const Issue& issue) { return issue.severity == Severity::Error; });
}

}  // namespace

std::vector<Issue> check_model(const deck::Deck& deck) {
  std::vector<Issue> issues = build::check_buildable(deck);
  const bool runs = !has_error(issues);
  for (Issue& issue : issues)
    if (issue.severity == Severity::Error) {
      issue.severity = Severity::Note;
      issue.message = "`adore run` will refuse this deck: " + issue.message;
    }
  deck::Deck model = deck;
  if (!runs) {
    // A motion that cannot be run has a geometry all the same.
    model.set("mode", "-1");
    model.complete();
    if (has_error(build::check_buildable(model))) return issues;
  }
  try {
    const bearing::Bearing operating = thermal::operating_bearing(build::build_bearing(model));
    for (Issue& issue : operating_warnings(operating, deck.file))
      issues.push_back(std::move(issue));
  } catch (const InputError& error) {
    issues.insert(issues.end(), error.issues().begin(), error.issues().end());
  }
  return issues;
}

}  // namespace adore::facade

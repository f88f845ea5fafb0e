#include "facade/check.hpp"

#include "build/build_bearing.hpp"
#include "facade/prepare.hpp"
#include "thermal/operating.hpp"

#include <utility>

namespace adore::facade {

std::vector<Issue> check_model(const deck::Deck& deck) {
  std::vector<Issue> issues;
  bool buildable = true;
  for (Issue issue : build::check_buildable(deck)) {
    if (issue.severity == Severity::Error) {
      buildable = false;
      issue.severity = Severity::Note;
      issue.message = "`adore run` will refuse this deck: " + issue.message;
    }
    issues.push_back(std::move(issue));
  }
  if (!buildable) return issues;
  try {
    const bearing::Bearing operating = thermal::operating_bearing(build::build_bearing(deck));
    for (Issue& issue : operating_warnings(operating, deck.file))
      issues.push_back(std::move(issue));
  } catch (const InputError& error) {
    issues.insert(issues.end(), error.issues().begin(), error.issues().end());
  }
  return issues;
}

}  // namespace adore::facade

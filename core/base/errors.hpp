#pragma once

#include <source_location>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Kinds of errors, and the place of the correction (CLI exit codes in brackets):
/// InputError [2] the user's deck, file or argument; SolverError [3] the numerics failed;
/// InternalError [1] a bug.
namespace adore {

enum class Severity : unsigned char { Note, Warning, Error };

/// One sentence about the user's input. Empty fields and line 0 mean "does not apply".
struct Issue {
  Severity severity = Severity::Error;
  std::string file;
  int line = 0;          ///< 1-based line of the file
  std::string record;    ///< record id, e.g. "5A"
  std::string variable;  ///< deck variable, e.g. "pitchDia"; "cageGsCls[2]" for the second instance
  std::string value;     ///< value given by the user
  std::string message;   ///< the problem, as a clause: "the pitch diameter must be larger than the
                         ///< ball diameter"
  std::string remedy;    ///< the valid range, as a clause: "give a value above 0.0127 m"
  std::string code;      ///< of the finding (base/finding.hpp); empty: "deck.<severity>"

  /// "DATA.txt:12: record 5A, pitchDia = 0.001: <message>; <remedy>"
  [[nodiscard]] std::string text() const;
};

/// Text of several issues, one line each.
std::string to_text(const std::vector<Issue>& issues);

/// The user's input is wrong. Carries every problem found, not only the first.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Issue> issues);
  explicit InputError(std::string message);
  [[nodiscard]] const std::vector<Issue>& issues() const noexcept { return issues_; }

 private:
  std::vector<Issue> issues_;
};

/// The numerics gave up: no equilibrium, step size collapsed, state not finite. The text holds
/// diagnosis and remedy.
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A broken invariant: our bug.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws InternalError with file and line when `condition` is false.
void demand(bool condition, std::string_view text,
            std::source_location where = std::source_location::current());

}  // namespace adore

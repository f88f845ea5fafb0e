#pragma once

#include "base/errors.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Findings: every remark of check, statics, plan, run, end of run and studies as data. Their codes
/// are in the register (resources/findings.json), and "validity.<range>" for each range of the
/// register of validity (base/validity.hpp).
namespace adore::validity {
struct Finding;
}

namespace adore {

/// Entry of the register.
struct FindingKind {
  std::string code;  ///< "cage.yielding"
  Severity severity = Severity::Note;
  std::string origin;    ///< check, statics, plan, run, end, study
  std::string meaning;   ///< short
  std::string quantity;  ///< empty: none
  std::string unit;      ///< of value and limit; empty: a pure number
  std::string range;     ///< entry of the register of validity; empty: none
  std::string field;     ///< deck variable to which a click leads; empty: none
  std::string topic;     ///< "cage", "contact", "film" ...: curves and pages that show it
  bool quiet = false;    ///< PRINT.txt has it on its page: not repeated in the list of remarks
};

/// All kinds: the file's, then one for each range of validity.
[[nodiscard]] std::span<const FindingKind> finding_kinds();
/// nullptr: no such code
[[nodiscard]] const FindingKind* find_finding_kind(std::string_view code);

/// A remark. Of Issue: code, severity, sentence (message), remedy, file, line, record, variable and
/// the given value. Fields that are empty do not apply. The code is given where the remark is made,
/// never derived from its sentence.
struct Finding : Issue {
  std::string quantity, unit;
  std::optional<double> measured;      ///< value of the quantity, in `unit`
  std::optional<double> least, limit;  ///< bounds of the quantity, in `unit`
  std::string body;                    ///< "ball 3, inner race", "cage"
  std::optional<double> time;          ///< [s]
  std::optional<long> step;

  Finding() = default;
  /// A remark of a module below; without a code: deck.error, deck.warning or deck.note.
  /// @throws InternalError when the register does not have its code
  Finding(Issue issue);  // NOLINT(google-explicit-constructor): a remark is a finding

  Finding& of(std::string which);
  Finding& measure(double number, std::optional<double> most = std::nullopt);
  /// Of a code for several quantities.
  Finding& measure(std::string what, double number, std::string in_unit,
                   std::optional<double> most = std::nullopt);
  Finding& at_least(double bound);
  Finding& at(double seconds);
};

/// A finding of the register. @throws InternalError when the register has no such code
[[nodiscard]] Finding make_finding(std::string_view code, std::string sentence);
/// Value, bounds and body of a finding under another code. @throws InternalError
[[nodiscard]] Finding renamed(const Finding& finding, std::string_view code, std::string sentence);
[[nodiscard]] std::vector<Finding> findings_of(std::vector<Issue> issues);
[[nodiscard]] std::vector<std::string> sentences_of(std::span<const Finding> findings);
/// "validity.<range>", with value, bounds, body and time.
[[nodiscard]] Finding finding_of_range(const validity::Finding& left);

[[nodiscard]] std::string_view severity_word(Severity severity);
[[nodiscard]] nlohmann::ordered_json finding_json(const Finding& finding);
[[nodiscard]] nlohmann::ordered_json findings_json(std::span<const Finding> findings);
/// From a file that may be foreign: entries that are not findings are left out, at
/// most kMostFindings are read.
[[nodiscard]] std::vector<Finding> read_findings(const nlohmann::json& list);
inline constexpr std::size_t kMostFindings = 1000;

/// Lines of text: warnings and notes that are not quiet. Notes of the register of validity are one
/// line.
[[nodiscard]] std::vector<Finding> shown_findings(std::span<const Finding> findings);

/// "2 warnings, 3 notes. Worst: <sentence>"; "No findings." without any.
[[nodiscard]] std::string findings_line(std::span<const Finding> findings);
/// The most severe, the first of them; nullptr: none.
[[nodiscard]] const Finding* worst_finding(std::span<const Finding> findings);

/// The register as a page of Markdown.
[[nodiscard]] std::string finding_codes_page();

}  // namespace adore

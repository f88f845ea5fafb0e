#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// The template of a report: HTML with {{name}} for a part of the report, and {{#runs}} ...
/// {{/runs}} around what is repeated for each run.
namespace adore::cli {

using ReportParts = std::map<std::string, std::string, std::less<>>;  ///< HTML by name

/// The template that `adore report` uses without --template.
[[nodiscard]] std::string default_report_template();

/// @param of_all parts outside of {{#runs}}; inside they are known, too
/// @param of_runs parts of each run; all have the same names
/// @throws InputError for an unknown name (it lists those known), an open {{, or a missing
/// {{/runs}}
[[nodiscard]] std::string fill_report(std::string_view text, const ReportParts& of_all,
                                      const std::vector<ReportParts>& of_runs);

}  // namespace adore::cli

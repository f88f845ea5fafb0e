#include "base/errors.hpp"

#include "base/excerpt.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore {

std::string Issue::text() const {
  std::string out;
  if (!file.empty())
    out += file + (line > 0 ? fmt::format(":{}", line) : "") + ": ";
  else if (line > 0)
    out += fmt::format("line {}: ", line);
  if (severity == Severity::Warning) out += "warning: ";
  if (severity == Severity::Note) out += "note: ";
  std::string place;
  if (!record.empty()) place = "record " + record;
  if (!variable.empty()) place += (place.empty() ? "" : ", ") + variable;
  if (!value.empty())
    place += (place.empty() ? "" : variable.empty() ? ": " : " = ") + excerpt(value);
  if (!place.empty()) out += place + ": ";
  out += message;
  if (!remedy.empty()) out += "; " + remedy;
  return out;
}

std::string to_text(const std::vector<Issue>& issues) {
  std::string out;
  for (const Issue& issue : issues) out += issue.text() + "\n";
  if (!out.empty()) out.pop_back();
  return out;
}

InputError::InputError(std::vector<Issue> issues)
    : std::runtime_error(to_text(issues)), issues_(std::move(issues)) {}

InputError::InputError(std::string message)
    : std::runtime_error(message),
      issues_{Issue{Severity::Error, {}, 0, {}, {}, {}, std::move(message), {}, {}}} {}

void demand(bool condition, std::string_view text, std::source_location where) {
  if (condition) return;
  throw InternalError(fmt::format("{}:{}: a check failed (this is a bug in Adore): {}",
                                  where.file_name(), where.line(), text));
}

}  // namespace adore

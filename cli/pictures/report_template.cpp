#include "cli/pictures/report_template.hpp"

#include "base/errors.hpp"

#include <QResource>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace adore::cli {
namespace {

constexpr std::string_view kRuns = "{{#runs}}", kEnd = "{{/runs}}";

std::string fill(std::string_view text, const ReportParts& parts) {
  std::string out;
  while (true) {
    const std::size_t open = text.find("{{");
    out += text.substr(0, open);
    if (open == std::string_view::npos) return out;
    const std::size_t close = text.find("}}", open);
    if (close == std::string_view::npos)
      throw InputError("the template has {{ without }} after it");
    const std::string_view name = text.substr(open + 2, close - open - 2);
    const auto part = parts.find(name);
    if (part == parts.end()) {
      std::vector<std::string> known;
      for (const auto& [each, html] : parts) known.push_back(each);
      throw InputError(
          fmt::format("the template contains the unknown name {{{{{}}}}}. Known names: {}", name,
                      fmt::join(known, ", ")));
    }
    out += part->second;
    text.remove_prefix(close + 2);
  }
}

}  // namespace

std::string default_report_template() {
  const QResource file(":/adore/report/template.html");
  if (!file.isValid()) throw InternalError("the template of reports is missing");
  return file.uncompressedData().toStdString();
}

std::string fill_report(std::string_view text, const ReportParts& of_all,
                        const std::vector<ReportParts>& of_runs) {
  std::string out;
  while (true) {
    const std::size_t begin = text.find(kRuns);
    out += fill(text.substr(0, begin), of_all);
    if (begin == std::string_view::npos) return out;
    const std::size_t end = text.find(kEnd, begin);
    if (end == std::string_view::npos)
      throw InputError("the template has {{#runs}} without {{/runs}} after it");
    const std::string_view each = text.substr(begin + kRuns.size(), end - begin - kRuns.size());
    for (ReportParts parts : of_runs) {
      parts.insert(of_all.begin(), of_all.end());
      out += fill(each, parts);
    }
    text.remove_prefix(end + kEnd.size());
  }
}

}  // namespace adore::cli

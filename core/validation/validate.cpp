#include "validation/validate.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "validation/adapters.hpp"
#include "validation/tolerance.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <set>

namespace adore::validation {
namespace {

using Json = nlohmann::json;

const std::vector<Adapter>& adapters() {
  static const std::vector<Adapter> all = all_adapters();
  return all;
}

double largest_magnitude(const Json& value) {
  if (value.is_number()) return std::abs(value.get<double>());
  double largest = 0.0;
  if (value.is_array())
    for (const Json& entry : value) largest = std::max(largest, largest_magnitude(entry));
  return largest;
}

/// Compares numbers, arrays and nulls under one rule and keeps the worst entry.
class Comparison {
 public:
  Comparison(const ToleranceRule& rule, const Json& expected)
      : rule_(rule), channel_(largest_magnitude(expected)) {
    if (rule.scale == ToleranceRule::Scale::Diagonal && expected.is_array())
      for (std::size_t i = 0; i < expected.size(); ++i)
        diagonal_.push_back(expected[i].is_array() && expected[i].size() > i
                                ? largest_magnitude(expected[i][i])
                                : 0.0);
  }
  QuantityResult run(const Json& expected, const Json& got) {
    compare(expected, got, {}, channel_);
    return result_;
  }

 private:
  void fail(std::string message) {
    if (!result_.message.empty()) return;
    result_.pass = false;
    result_.message = std::move(message);
  }

  void compare(const Json& expected, const Json& got, std::vector<std::size_t> index,
               double parent) {
    if (expected.is_null()) {
      if (!got.is_null()) fail("must be undefined (null)");
    } else if (expected.is_array()) {
      if (!got.is_array() || got.size() != expected.size())
        return fail(fmt::format("must be an array of {} values", expected.size()));
      const double norm = vector_norm(expected);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        index.push_back(i);
        compare(expected[i], got[i], index, norm);
        index.pop_back();
      }
    } else if (expected.is_number()) {
      if (!got.is_number()) return fail("is not a number");
      number(expected.get<double>(), got.get<double>(), index, parent);
    } else if (rule_.strings && expected != got) {
      fail(fmt::format("is {} but must be {}", dump_json(got), dump_json(expected)));
    }
  }

  static double vector_norm(const Json& vector) {
    double sum = 0.0;
    for (const Json& entry : vector) {
      if (!entry.is_number()) return 0.0;
      sum += entry.get<double>() * entry.get<double>();
    }
    return std::sqrt(sum);
  }

  void number(double expected, double got, const std::vector<std::size_t>& index, double norm) {
    double difference = std::abs(got - expected);
    if (rule_.period > 0.0) difference = std::abs(std::remainder(got - expected, rule_.period));
    double scale = std::abs(expected);
    switch (rule_.scale) {
      case ToleranceRule::Scale::Entry:
        break;
      case ToleranceRule::Scale::Channel:
        scale = channel_;
        break;
      case ToleranceRule::Scale::Norm:
        scale = norm;
        break;
      case ToleranceRule::Scale::Diagonal:
        scale = index.size() == 2 && std::max(index[0], index[1]) < diagonal_.size()
                    ? std::sqrt(diagonal_[index[0]] * diagonal_[index[1]])
                    : channel_;
        break;
    }
    const double allowed = std::max(rule_.relative * scale, rule_.absolute);
    if (!(difference <= allowed)) result_.pass = false;
    const double severity = std::isfinite(difference) ? (allowed > 0.0      ? difference / allowed
                                                         : difference > 0.0 ? kInfinity
                                                                            : 0.0)
                                                      : kInfinity;
    if (!(severity > severity_) && !first_) return;
    first_ = false;
    severity_ = severity;
    const bool relative = rule_.relative * scale >= rule_.absolute && scale > 0.0;
    result_.error = relative ? difference / scale : difference;
    result_.tolerance = relative ? rule_.relative : rule_.absolute;
  }

  const ToleranceRule& rule_;
  double channel_;
  std::vector<double> diagonal_;
  QuantityResult result_;
  double severity_ = 0.0;
  bool first_ = true;
};

bool holds_objects(const Json& value) {
  return value.is_array() && !value.empty() && value.front().is_object();
}

void compare_object(const std::string& family, const Json& the_case, const std::string& path,
                    const Json& expected, const Json& got, std::vector<QuantityResult>& out);

void compare_value(const std::string& family, const Json& the_case, const std::string& path,
                   const Json& expected, const Json* got, std::vector<QuantityResult>& out) {
  const ToleranceRule rule = tolerance_rule(family, path, the_case);
  if (rule.ignore || (expected.is_string() && !rule.strings)) return;
  if (expected.is_null() && got == nullptr) return;
  const auto missing = [&](const char* text) {
    out.push_back({path, kInfinity, 0.0, false, text});
  };
  if (got == nullptr) return missing("is missing in the result");
  if (expected.is_object()) {
    if (!got->is_object()) return missing("must be an object");
    return compare_object(family, the_case, path, expected, *got, out);
  }
  if (holds_objects(expected)) {
    if (!got->is_array() || got->size() != expected.size())
      return missing("has the wrong number of entries");
    for (std::size_t i = 0; i < expected.size(); ++i)
      compare_object(family, the_case, fmt::format("{}[{}]", path, i), expected[i], (*got)[i], out);
    return;
  }
  QuantityResult result = Comparison(rule, expected).run(expected, *got);
  result.key = path;
  out.push_back(std::move(result));
}

void compare_object(const std::string& family, const Json& the_case, const std::string& path,
                    const Json& expected, const Json& got, std::vector<QuantityResult>& out) {
  for (const auto& [key, value] : expected.items()) {
    const auto found = got.find(key);
    compare_value(family, the_case, path.empty() ? key : path + "." + key, value,
                  found == got.end() ? nullptr : &*found, out);
  }
}

double severity(const QuantityResult& quantity) {
  if (!quantity.message.empty()) return kInfinity;
  if (quantity.tolerance > 0.0) return quantity.error / quantity.tolerance;
  return quantity.error > 0.0 ? kInfinity : 0.0;
}

CaseResult run_case(const std::string& family, const Json& the_case) {
  CaseResult result;
  result.id = the_case.value("id", "?");
  result.status = "not_covered";
  result.message = fmt::format("no calculator for family {}", family);
  try {
    for (const Adapter& adapter : adapters()) {
      if (adapter.family != family) continue;
      if (const std::optional<Json> answer = adapter.run(the_case)) {
        CaseResult compared = compare_case(family, the_case, *answer);
        const auto of_motion = answer->find("evaluation");
        compared.evaluation =
            of_motion != answer->end()
                ? *of_motion
                : Json{{"entry", std::string(evaluated_library_functions(family))}};
        return compared;
      }
      result.message = "the inputs fit no kind of calculation of this family of reference cases";
    }
  } catch (const std::exception& error) {
    result.status = the_case.value("provenance", "") == "recalled" ? "not_covered" : "fail";
    result.message = error.what();
  }
  return result;
}

/// A case whose inputs name another one ("base": "ID: what differs") gets that case as "base_case".
Json with_base(const Json& the_case, const Json& cases) {
  const Json base = the_case.value("inputs", Json::object()).value("base", Json());
  if (!base.is_string()) return the_case;
  const std::string text = base.get<std::string>(), id = text.substr(0, text.find(':'));
  for (const Json& other : cases)
    if (other.value("id", "") == id) {
      Json complete = the_case;
      complete["base_case"] = other;
      return complete;
    }
  return the_case;
}

/// How messages call a file.
std::string shown_name(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path.string();
}

FileResult run_file(const std::filesystem::path& path, const Json& content) {
  const auto begin = std::chrono::steady_clock::now();
  FileResult result;
  result.file = shown_name(path);
  result.family = content.at("family").get<std::string>();
  for (const Json& the_case : content.at("cases"))
    result.cases.push_back(run_case(result.family, with_base(the_case, content.at("cases"))));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

/// Reason why the list is not a list of cases; empty when it is.
std::string wrong_case(const Json& cases) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Json& one = cases[i];
    if (!one.is_object()) return fmt::format("case {} is not an object", i + 1);
    for (const char* key : {"id", "kind", "provenance"})
      if (one.contains(key) && !one.at(key).is_string())
        return fmt::format("\"{}\" of case {} is not a string", key, i + 1);
    for (const char* key : {"inputs", "expected"})
      if (!one.contains(key) || !one.at(key).is_object())
        return fmt::format("case {} has no object \"{}\"", i + 1, key);
  }
  return {};
}

Json read_cases(const std::filesystem::path& path, const std::string& standard_input,
                std::vector<Issue>& issues) {
  const auto complain = [&](std::string message) {
    Issue issue;
    issue.file = shown_name(path);
    issue.message = std::move(message);
    issue.remedy = "give a JSON file with the members \"family\" and \"cases\"";
    issues.push_back(std::move(issue));
  };
  std::string text = standard_input;
  if (path != "-") {
    InputFile stream(path);
    if (!stream || !std::filesystem::is_regular_file(path)) {
      complain("the file cannot be read");
      return {};
    }
    text.assign(std::istreambuf_iterator<char>(stream), {});
  }
  Json content;
  try {
    content = parse_json(text, "the file");
  } catch (const InputError& error) {
    complain(error.what());
    return {};
  }
  if (!content.is_object() || !content.value("family", Json()).is_string() ||
      !content.value("cases", Json()).is_array())
    complain("the file contains no reference cases");
  else if (const std::string wrong = wrong_case(content.at("cases")); !wrong.empty())
    complain(wrong);
  return content;
}

/// Infinite numbers are not JSON.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

CaseResult compare_case(const std::string& family, const Json& the_case, const Json& result) {
  CaseResult out;
  out.id = the_case.value("id", "?");
  compare_object(family, the_case, "", the_case.at("expected"), result, out.quantities);
  out.status = "pass";
  double worst = -1.0;
  for (const QuantityResult& quantity : out.quantities) {
    if (!quantity.pass) out.status = "fail";
    const double size = severity(quantity) + (quantity.pass ? 0.0 : 1e-12);
    if (size <= worst) continue;
    worst = size;
    out.worst_key = quantity.key;
    out.error = quantity.error;
    out.tolerance = quantity.tolerance;
    out.message =
        quantity.message.empty() ? "" : fmt::format("{} {}", quantity.key, quantity.message);
  }
  if (out.quantities.empty()) {
    out.status = "not_covered";
    out.message = "the case has no expected value to compare";
  }
  if (out.status == "fail" && the_case.value("provenance", "") == "recalled") {
    out.status = "not_covered";
    out.message = fmt::format(
        "{} deviates by {:.3g}. This is not counted as a failure, because the expected value was "
        "not checked against its source",
        out.worst_key, out.error);
  }
  return out;
}

ValidateReport validate_files(std::span<const std::filesystem::path> files,
                              const std::function<void(const FileResult&)>& progress,
                              const std::string& standard_input) {
  std::vector<Issue> issues;
  std::vector<Json> contents;
  for (const std::filesystem::path& file : files)
    contents.push_back(read_cases(file, standard_input, issues));
  if (!issues.empty()) throw InputError(std::move(issues));
  ValidateReport report;
  for (std::size_t i = 0; i < files.size(); ++i) {
    report.files.push_back(run_file(files[i], contents[i]));
    for (const CaseResult& result : report.files.back().cases)
      ++(result.status == "pass"   ? report.pass
         : result.status == "fail" ? report.fail
                                   : report.not_covered);
    if (progress) progress(report.files.back());
  }
  return report;
}

Json report_json(const ValidateReport& report) {
  Json files = Json::array();
  for (const FileResult& file : report.files) {
    Json cases = Json::array();
    for (const CaseResult& result : file.cases) {
      Json entry = {{"id", result.id}, {"status", result.status}};
      if (!result.evaluation.is_null()) entry["evaluation"] = result.evaluation;
      if (!result.worst_key.empty())
        entry["worst"] = {{"key", result.worst_key},
                          {"error", finite(result.error)},
                          {"tolerance", finite(result.tolerance)}};
      if (!result.message.empty()) entry["message"] = result.message;
      cases.push_back(std::move(entry));
    }
    files.push_back({{"file", file.file},
                     {"family", file.family},
                     {"seconds", file.seconds},
                     {"cases", std::move(cases)}});
  }
  return {{"files", std::move(files)},
          {"totals",
           {{"pass", report.pass}, {"fail", report.fail}, {"not_covered", report.not_covered}}}};
}

namespace {

/// @param all quantities, or only those that fail
std::string case_text(const CaseResult& result, bool all) {
  std::string text = fmt::format("  {:<11} {}", result.status, result.id);
  if (!result.message.empty()) text += fmt::format(": {}", result.message);
  for (const QuantityResult& q : result.quantities) {
    if (!all && q.pass) continue;
    const std::string figures =
        q.message.empty() ? fmt::format("{:.1e}/{:.1e}", q.error, q.tolerance) : q.message;
    text += fmt::format("  {}{} {}", q.pass ? "" : "! ", q.key, figures);
  }
  return text + '\n';
}

}  // namespace

std::string file_result_text(const FileResult& file, bool verbose) {
  const auto count = [&](std::string_view status) {
    return std::count_if(file.cases.begin(), file.cases.end(),
                         [&](const CaseResult& one) { return one.status == status; });
  };
  std::string text =
      fmt::format("{}: {} passed, {} failed, {} not covered in {:.1f} s\n", file.file,
                  count("pass"), count("fail"), count("not_covered"), file.seconds);
  for (const CaseResult& result : file.cases)
    if (verbose || result.status == "fail") text += case_text(result, verbose);
  return text;
}

std::string totals_text(const ValidateReport& report) {
  return fmt::format("{} passed, {} failed, {} not covered\n", report.pass, report.fail,
                     report.not_covered);
}

}  // namespace adore::validation

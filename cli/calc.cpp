#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "cli/commands.hpp"
#include "cli/export.hpp"
#include "cli/streams.hpp"
#include "facade/calculator_inputs.hpp"
#include "facade/calculators.hpp"
#include "facade/validate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

namespace adore::cli {
namespace {

std::string read_all(const std::string& name) {
  if (name == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  std::ifstream file(name, std::ios::binary);
  if (!file)
    throw InputError(
        fmt::format("cannot read {}; give a JSON file, or - for standard input", name));
  return {std::istreambuf_iterator<char>(file), {}};
}

const facade::CalculatorInfo& calculator(const std::string& name) {
  for (const facade::CalculatorInfo& info : facade::calculators())
    if (info.name == name) return info;
  throw InputError(
      fmt::format("there is no calculator named \"{}\"; `adore calc --list` shows them", name));
}

/// All calculators, or one, with what they take and give.
void list_calculators(const std::string& name, bool json, bool describe) {
  if (json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const facade::CalculatorInfo& info : facade::calculators())
      if (name.empty() || info.name == name) all.push_back(facade::describe_calculator(info));
    fmt::print("{}\n", all.dump(2));
  } else if (describe && !name.empty()) {
    fmt::print("{}", facade::describe_calculator_text(calculator(name)));
  } else {
    for (const facade::CalculatorInfo& info : facade::calculators())
      fmt::print("{:<20} {}\n", info.name, info.help);
    fmt::print(
        "`adore calc NAME --describe` lists inputs and results with units, and an example\n");
  }
}

void calc(const std::string& name, const std::string& source) {
  const nlohmann::json input =
      parse_json(read_all(source), source == "-" ? "standard input" : source);
  fmt::print("{}\n", facade::calculate(name, input).dump(2));
}

int validate(const std::vector<std::string>& files, const std::string& report_file, bool quiet) {
  const std::vector<std::filesystem::path> paths(files.begin(), files.end());
  const facade::ValidateReport report =
      facade::validate_files(paths, [](const facade::FileResult& file) {
        tell(fmt::format("{}: {} cases in {:.1f} s\n", file.file, file.cases.size(),
                         file.seconds));
      });
  if (!quiet)
    fmt::print("{}", facade::report_text(report));
  else
    fmt::print("{} passed, {} failed, {} not covered\n", report.pass, report.fail,
               report.not_covered);
  if (!report_file.empty())
    write_export(report_file, facade::report_json(report).dump(2) + "\n", paths);
  return report.fail > 0 ? 1 : 0;
}

}  // namespace

void add_calc(CLI::App& app, int& exit_code) {
  {
    CLI::App* command = app.add_subcommand("calc", "component calculators: JSON in, JSON out");
    auto name = std::make_shared<std::string>();
    auto source = std::make_shared<std::string>("-");
    auto list = std::make_shared<bool>(false);
    command->add_option("name", *name, "calculator; see --list");
    command->add_option("--json", *source, "file of inputs, or - for standard input")
        ->capture_default_str();
    auto describe = std::make_shared<bool>(false);
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--list", *list, "list the calculators");
    command->add_flag("--describe", *describe,
                      "inputs and results of the calculator with units, and an example");
    command->add_flag("--as-json", *as_json, "--list or --describe as JSON");
    command->callback([=] {
      if (*list || *describe) return list_calculators(*name, *as_json, *describe);
      if (name->empty()) throw InputError("name a calculator; `adore calc --list` shows them");
      calc(*name, *source);
    });
  }
  {
    CLI::App* command =
        app.add_subcommand("validate", "run reference cases and print error against tolerance");
    auto files = std::make_shared<std::vector<std::string>>();
    auto report = std::make_shared<std::string>();
    auto quiet = std::make_shared<bool>(false);
    command->add_option("files", *files, "case files")->required();
    command->add_option("--report", *report, "write the results as JSON");
    command->add_flag("--quiet", *quiet, "only the totals");
    command->callback([=, &exit_code] { exit_code = validate(*files, *report, *quiet); });
  }
}

}  // namespace adore::cli

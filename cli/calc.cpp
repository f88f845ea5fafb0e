#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/terminal_text.hpp"
#include "calculators/calculator_description.hpp"
#include "calculators/calculators.hpp"
#include "cli/commands.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "design/calculator_inputs.hpp"
#include "validation/catalogue_torque.hpp"
#include "validation/experiments.hpp"
#include "validation/validate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace adore::cli {
namespace {

std::string read_all(const std::string& name) {
  if (name == kStream) return read_standard_input(kMaxInputBytes);
  return read_text_file(name, kMaxInputBytes);
}

const calculators::CalculatorInfo& calculator(const std::string& name) {
  for (const calculators::CalculatorInfo& info : calculators::calculator_list())
    if (info.name == name) return info;
  throw InputError(fmt::format(
      "there is no calculator named \"{}\"; `adore calc --list` lists all calculators", name));
}

/// All calculators, or one, with their inputs and results.
void list_calculators(const std::string& name, bool json, bool describe) {
  if (json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const calculators::CalculatorInfo& info : calculators::calculator_list())
      if (name.empty() || info.name == name) all.push_back(calculators::describe_calculator(info));
    print("{}\n", dump_json(all, 2));
  } else if (describe && !name.empty()) {
    print("{}", calculators::describe_calculator_text(calculator(name)));
  } else {
    for (const calculators::CalculatorInfo& info : calculators::calculator_list())
      print("{:<20} {}\n", info.name, info.help);
    print("`adore calc NAME --describe` shows the inputs and results with units, and an example\n");
  }
}

void calc(const std::string& name, const std::string& source) {
  const nlohmann::json input =
      parse_json(read_all(source), source == "-" ? "standard input" : source);
  print("{}\n", dump_json(calculators::calculate(name, input), 2));
}

/// With the inputs that a deck gives.
void calc_of_deck(const std::string& name, const std::string& deck, int element) {
  runs::DeckRequest request;
  request.deck = deck;
  const nlohmann::ordered_json inputs =
      design::calculator_inputs(runs::prepare(request), name, element);
  nlohmann::ordered_json out = nlohmann::ordered_json::object();
  for (const auto& [race, input] : inputs.items())
    out[race] = input.is_null()
                    ? nlohmann::ordered_json(nullptr)
                    : nlohmann::ordered_json{
                          {"inputs", input.contains("inputs") ? input.at("inputs") : input},
                          {"results", calculators::calculate(name, nlohmann::json(input))}};
  print("{}\n", dump_json(out, 2));
}

enum class Detail : unsigned char { Totals, Failures, Cases, Json };

int validate(const std::vector<std::string>& files, const std::string& report_file, Detail detail) {
  const std::vector<std::filesystem::path> paths(files.begin(), files.end());
  const auto piped = std::count(files.begin(), files.end(), kStream);
  if (piped > 1) throw InputError("standard input can be read only once; give - only once");
  const validation::ValidateReport report = validation::validate_files(
      paths,
      [&](const validation::FileResult& file) {
        const std::string text = validation::file_result_text(file, detail == Detail::Cases);
        if (detail == Detail::Totals || detail == Detail::Json) {
          tell(text.substr(0, text.find('\n') + 1));
        } else {
          print("{}", text);
          (void)std::fflush(stdout);  // minutes pass between files
        }
      },
      piped > 0 ? read_standard_input(kMaxInputBytes) : std::string());
  print("{}", detail == Detail::Json ? dump_json(validation::report_json(report), 2) + "\n"
                                     : validation::totals_text(report));
  if (!report_file.empty())
    write_text(report_file, "report.json", dump_json(validation::report_json(report), 2) + "\n",
               paths);
  return report.fail > 0 ? 1 : 0;
}

/// Exit code 0 in any case: the page shows deviations but does not judge them.
void experiments(const std::string& only, const std::string& report_file, bool json,
                 bool markdown) {
  const std::vector<validation::Experiment> all = validation::run_experiments(
      only, [](const std::string& id) { tell(fmt::format("{}\n", id)); });
  const std::string as_json = dump_json(validation::experiments_json(all), 2) + "\n";
  print("{}", json       ? as_json
              : markdown ? validation::experiments_markdown(all)
                         : validation::experiments_text(all));
  if (!report_file.empty()) write_text(report_file, "experiments.json", as_json);
}

void torque(const std::string& report_file, bool json, bool markdown) {
  const std::vector<validation::TorqueTable> tables = validation::compute_torque_tables();
  const std::string as_json = dump_json(validation::torque_json(tables), 2) + "\n";
  print("{}", json       ? as_json
              : markdown ? validation::torque_markdown(tables)
                         : validation::torque_text(tables));
  if (!report_file.empty()) write_text(report_file, "torque.json", as_json);
}

}  // namespace

void add_calc_commands(CLI::App& app, int& exit_code) {
  {
    CLI::App* command =
        app.add_subcommand("calc", "run a component calculator (input and results are JSON)");
    auto name = std::make_shared<std::string>();
    auto source = std::make_shared<std::string>("-");
    auto list = std::make_shared<bool>(false);
    auto describe = std::make_shared<bool>(false);
    auto as_json = std::make_shared<bool>(false);
    auto markdown = std::make_shared<bool>(false);
    auto deck = std::make_shared<std::string>();
    auto element = std::make_shared<int>(1);
    std::vector<std::string> names;
    for (const calculators::CalculatorInfo& info : calculators::calculator_list())
      names.push_back(info.name);
    command_line::suggest_values(
        command->add_option("name", *name, "name of the calculator (--list lists all calculators)")
            ->type_name("NAME"),
        names);
    command->add_option("input", *source, "file with the inputs, or - for standard input")
        ->type_name("FILE")
        ->capture_default_str();
    command->add_flag("--list", *list, "list the calculators");
    command->add_flag("--describe", *describe,
                      "show the inputs (with ranges, codes and defaults), the results (with units) "
                      "and an example");
    // Elsewhere --json is a flag; here a file may follow, as it did before there was `input`.
    command
        ->add_option_function<std::vector<std::string>>(
            "--json",
            [=](const std::vector<std::string>& given) {
              *as_json = true;
              if (!given.empty() && !given.front().empty()) *source = given.front();
            },
            "with --list or --describe: print JSON; without them: read the inputs from FILE")
        ->expected(0, 1)
        ->type_name("FILE");
    command->add_flag("--as-json", *as_json, "old name of --json")->group("");
    command->add_flag("--markdown", *markdown, "with --list: print all inputs as Markdown");
    command
        ->add_option("--deck", *deck,
                     fmt::format("take the inputs from the quasi-static solution of this deck "
                                 "(only for the calculators {})",
                                 fmt::join(design::deck_calculators(), ", ")))
        ->type_name("DECK");
    command
        ->add_option("--element", *element,
                     "with --deck: number of the rolling element (for the calculators film, hertz "
                     "and line-contact)")
        ->type_name("N")
        ->capture_default_str();
    command->footer(
        "Examples\n"
        "  adore calc --list\n"
        "  adore calc film --deck DATA.txt --element 1\n"
        "  adore calc static-safety --deck DATA.txt\n"
        "  adore calc hertz --describe\n"
        "  adore calc hertz input.json\n"
        "  echo '{\"code\": 100}' | adore calc material");
    command->callback([=] {
      if (*markdown) {
        if (!*list) throw InputError("--markdown works only together with --list; give both");
        print("{}", calculators::calculators_markdown());
        return;
      }
      if (*list || *describe) return list_calculators(*name, *as_json, *describe);
      if (name->empty())
        throw InputError(
            "give the name of a calculator; `adore calc --list` lists all calculators");
      if (!deck->empty()) return calc_of_deck(calculator(*name).name, *deck, *element);
      calc(calculator(*name).name, *source);
    });
  }
  {
    CLI::App* command = app.add_subcommand(
        "validate", "run reference cases and print each error with its tolerance");
    auto files = std::make_shared<std::vector<std::string>>();
    auto report = std::make_shared<std::string>();
    auto quiet = std::make_shared<bool>(false);
    auto json = std::make_shared<bool>(false);
    auto published = std::make_shared<bool>(false);
    auto markdown = std::make_shared<bool>(false);
    auto only = std::make_shared<std::string>();
    command->add_option("files", *files, "files of reference cases, or - for standard input")
        ->type_name("FILE");
    CLI::Option* experiments_flag = command->add_flag(
        "--experiments", *published,
        "compare computed results with published experiments; reads no files of reference cases");
    command->add_option("--only", *only, "run only the experiment with this id")
        ->type_name("ID")
        ->needs(experiments_flag);
    auto torques = std::make_shared<bool>(false);
    command
        ->add_flag("--torque", *torques,
                   "compare the computed friction torque of bearings with a catalog formula; reads "
                   "no files of reference cases")
        ->excludes(experiments_flag);
    command->add_flag("--markdown", *markdown,
                      "print the results of --experiments or --torque as Markdown");
    command->add_option("--report", *report, "write the results as JSON to this file")
        ->type_name("FILE");
    command->add_flag("--json", *json, "print the results as JSON");
    auto verbose = std::make_shared<bool>(false);
    command->add_flag("--quiet", *quiet, "print only the totals");
    command->add_flag("--verbose", *verbose, "print each case with all quantities")
        ->excludes("--quiet")
        ->excludes("--json");
    command->footer(
        "Examples\n"
        "  adore validate tests/reference/*.json --report report.json\n"
        "  adore validate --experiments\n"
        "  adore validate --torque");
    command->callback([=, &exit_code] {
      if (*published || *torques) {
        if (!files->empty())
          throw InputError("--experiments and --torque use built-in decks; remove the file names");
        return *torques ? torque(*report, *json, *markdown)
                        : experiments(*only, *report, *json, *markdown);
      }
      if (files->empty())
        throw InputError("give files of reference cases, --experiments or --torque");
      if (*markdown)
        throw InputError(
            "--markdown works only together with --experiments or --torque; give one of them");
      exit_code = validate(*files, *report,
                           *json      ? Detail::Json
                           : *quiet   ? Detail::Totals
                           : *verbose ? Detail::Cases
                                      : Detail::Failures);
    });
  }
}

}  // namespace adore::cli

#include "calculators/find.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/terminal_text.hpp"
#include "calculators/calculators.hpp"
#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/option_ranges.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "design/find.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace adore::cli {
namespace {

struct FindOptions : DeckOptions {
  std::string unknown, target, question, between, calculator;
  int points = 41;
  bool json = false, list = false;
};

void list_all(bool json) {
  if (json) {
    nlohmann::ordered_json out{{"questions", nlohmann::ordered_json::array()},
                               {"results", nlohmann::ordered_json::array()}};
    for (const design::FindQuestion& one : design::find_questions())
      out["questions"].push_back({{"name", one.name},
                                  {"meaning", one.meaning},
                                  {"calculator", one.calculator},
                                  {"unknown", one.unknown},
                                  {"target", one.target},
                                  {"value", one.value},
                                  {"example", one.example}});
    for (const design::FindResultInfo& one : design::find_results())
      out["results"].push_back({{"name", one.id}, {"unit", one.unit}, {"meaning", one.meaning}});
    print("{}\n", dump_json(out, 2));
    return;
  }
  print("Questions (--question NAME or NAME=VALUE)\n");
  for (const design::FindQuestion& one : design::find_questions())
    print("  {:<27} {}\n  {:<27} {}\n", one.name, one.meaning, "", one.example);
  print("\nResults of the equilibrium (--target NAME=VALUE)\n");
  for (const design::FindResultInfo& one : design::find_results())
    print("  {:<30} {:<9} {}\n", one.id, one.unit, one.meaning);
  print("\nResults of a component calculator: `adore calc NAME --describe`\n");
}

FindReport answer(const FindOptions& options) {
  design::FindRequest request;
  design::ParsedFindQuestion asked;
  if (!options.question.empty()) {
    asked = design::parse_question(options.question);
    request.unknown = asked.unknown;
    request.target = asked.target;
  }
  if (!options.unknown.empty()) {
    request.unknown = parse_unknown(options.unknown);
  } else if (!options.between.empty()) {
    std::tie(request.unknown.first, request.unknown.last) =
        parse_bounds("--between ", options.between);
  } else {
    throw InputError(options.question.empty()
                         ? "the unknown is missing. Give --unknown NAME=lower:upper, or "
                           "--question NAME (`adore find --list` lists the questions)."
                         : "the bounds of the unknown are missing. Give --between lower:upper.");
  }
  if (!options.target.empty())
    request.target = parse_target(options.target);
  else if (options.question.empty())
    throw InputError("the target is missing. Give --target NAME=value.");
  request.points = options.points;
  std::string calculator = options.calculator;
  if (asked.question != nullptr && calculator.empty()) calculator = asked.question->calculator;
  if (!calculator.empty()) {
    if (!options.sets.empty() || !options.options.empty() || !options.user.empty())
      throw InputError(
          "--set, --opt and --user change decks, not inputs of a calculator. Remove these "
          "options.");
    const std::string text = options.deck == kStream ? read_standard_input(kMaxInputBytes)
                                                     : read_text_file(options.deck, kMaxInputBytes);
    return calculators::find_in_calculator(calculator, parse_json(text, options.deck),
                                           request.unknown, request.target, request.points);
  }
  options.fill(request);
  if (asked.question != nullptr) design::add_sets(*asked.question, request);
  const InterruptWatch watch;
  return design::find_in_deck(request, watch.token());
}

}  // namespace

void add_find_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "find", "find the value of an input at which a result meets a target (inverse calculation)");
  auto options = std::make_shared<FindOptions>();
  options->add_to(*command);
  command_line::suggest_values(
      command
          ->add_option("--unknown", options->unknown,
                       "deck variable or run option with its bounds, NAME=lower:upper, in the "
                       "units of the deck")
          ->type_name("NAME=RANGE")
          ->allow_extra_args(false),
      variable_completions());
  std::vector<std::string> results, questions, calculators;
  for (const design::FindResultInfo& one : design::find_results()) results.push_back(one.id + "=");
  for (const design::FindQuestion& one : design::find_questions()) questions.emplace_back(one.name);
  for (const calculators::CalculatorInfo& one : calculators::calculator_list())
    calculators.push_back(one.name);
  command_line::suggest_values(
      command
          ->add_option(
              "--target", options->target,
              "result of the equilibrium and its target value, in the unit at the end of the name; "
              "other forms: 'NAME>=VALUE', 'NAME<=VALUE', NAME=least (minimum) and NAME=largest "
              "(maximum)")
          ->type_name("NAME=VALUE"),
      results);
  CLI::Option* question = command_line::suggest_values(
      command
          ->add_option("--question", options->question,
                       "predefined question, with a value if the question needs one (--list lists "
                       "all questions)")
          ->type_name("NAME[=VALUE]"),
      questions);
  command
      ->add_option("--between", options->between,
                   "bounds of the unknown of --question, lower:upper, in the units of the deck")
      ->type_name("RANGE")
      ->needs(question)
      ->excludes("--unknown");
  command_line::suggest_values(
      command
          ->add_option(
              "--calc", options->calculator,
              "use this component calculator. DECK is then the JSON file with its inputs. Unknown "
              "and target are paths such as body1.Rx, displacement.ux or 'least(Qi)'")
          ->type_name("NAME"),
      calculators);
  command
      ->add_option("--points", options->points,
                   "number of scan points between the bounds; more points separate solutions that "
                   "are close together")
      ->capture_default_str();
  command->add_flag("--list", options->list,
                    "list all questions for --question and all results for --target");
  command->add_flag("--json", options->json, "print as JSON");
  command->footer(
      "Exit codes\n"
      "  0 one solution; 1 no solution (the best value is printed); 2 wrong input;\n"
      "  3 no solution was found, but the result could not be computed everywhere;\n"
      "  4 more than one solution; 5 one solution, but the result is not monotonic\n\n"
      "Examples\n"
      "  adore find DATA.txt --unknown appLoadX=1:5000 --target least_element_load_N=0\n"
      "  adore find DATA.txt --question load-for-pressure=2e9 --between 100:50000\n"
      "  adore find DATA.txt --unknown rpm2=1e3:6e4 --target 'life_lp_hours>=10000'\n"
      "  adore find --calc hertz contact.json --unknown load=1:1e5 --target delta=1e-5");
  command->callback([=, &exit_code] {
    if (options->list) return list_all(options->json);
    check_range("--points", options->points);
    const FindReport report = answer(*options);
    if (options->json) {
      print("{}\n", dump_json(find_report_json(report), 2));
    } else {
      print("{}\n", question_text(report));
      for (const std::string& line : answer_lines(report)) print("{}\n", line);
    }
    exit_code = answer_exit_code(report.outcome.answer);
  });
}

}  // namespace adore::cli

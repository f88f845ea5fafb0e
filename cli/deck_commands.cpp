#include "base/json_text.hpp"
#include "base/terminal_text.hpp"
#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/option_ranges.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "deck/catalogue.hpp"
#include "deck/templates.hpp"
#include "facade/check.hpp"
#include "facade/deck_story.hpp"
#include "facade/plan.hpp"
#include "facade/what_if.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <utility>

namespace adore::cli {
namespace {

/// All errors and warnings of a deck; what it asks for that cannot run yet is a note here and an
/// error of `run`.
int check(const std::string& path, bool json) {
  const facade::DeckRequest request = deck_request(path);
  const facade::CheckReport report = facade::check(request);
  const std::vector<Finding>& issues = report.issues;
  const bool ok = report.ok();
  if (json) {
    nlohmann::ordered_json out;
    out["file"] = report.file;
    out["ok"] = ok;
    out["issues"] = nlohmann::ordered_json::array();
    std::vector<Finding> listed = shown_findings(issues);
    std::copy_if(issues.begin(), issues.end(), std::inserter(listed, listed.begin()),
                 [](const Finding& one) { return one.severity == Severity::Error; });
    for (const Issue& issue : listed)
      out["issues"].push_back({{"severity", severity_word(issue.severity)},
                               {"line", issue.line},
                               {"record", issue.record},
                               {"variable", issue.variable},
                               {"value", issue.value},
                               {"message", issue.message},
                               {"remedy", issue.remedy}});
    out["findings"] = findings_json(issues);
    print("{}\n", dump_json(out, 2));
  } else {
    std::size_t errors = 0;
    for (const Finding& issue : issues)
      if (issue.severity == Severity::Error) {
        print("{}\n", issue.text());
        ++errors;
      }
    const std::vector<Finding> others = shown_findings(issues);
    for (const Finding& one : others) print("{}\n", one.text());
    print("{}: {} records, {} error{}, {} other remark{}\n", report.file, report.records, errors,
          errors == 1 ? "" : "s", others.size(), others.size() == 1 ? "" : "s");
  }
  return ok ? 0 : 2;
}

struct PlanOptions : DeckOptions {
  bool json = false, what_if = false;
  double turns = 2.0;
};

std::string what_if_of(const PlanOptions& options, const facade::DeckRequest& request,
                       nlohmann::ordered_json& json) {
  facade::WhatIfRequest study;
  static_cast<facade::DeckRequest&>(study) = request;
  study.turns = options.turns;
  const InterruptWatch watch;
  const facade::WhatIf result = facade::what_if(study, {}, watch.token());
  json["what_if"] = facade::what_if_json(result);
  return facade::what_if_text(result);
}

void plan(const PlanOptions& options) {
  check_range("--turns", options.turns);
  facade::DeckRequest request;
  options.fill(request);
  facade::PlanReport report = facade::plan(request);
  print_warnings(report.remarks);
  if (!options.json) print("{}", report.text);
  std::fflush(stdout);
  const std::string differences = options.what_if ? what_if_of(options, request, report.json) : "";
  print("{}{}", options.json ? dump_json(report.json, 2) : differences, options.json ? "\n" : "");
}

std::string text_of(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

/// Writes a new deck where nothing is yet; its file, or nothing when it went to standard output.
std::string write_new(const std::string& out, std::string_view text) {
  std::filesystem::path path(out);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) path /= "DATA.txt";
  if (!out.empty() && out != kStream && std::filesystem::exists(path))
    throw InputError(
        fmt::format("{} exists already; name another file, or remove it first", path.string()));
  return write_text(out, "DATA.txt", text);
}

void new_deck(const std::string& type, const std::string& out) {
  const std::string written = write_new(out, deck::template_text(type));
  if (written.empty()) return;
  tell(fmt::format("wrote {}\n{}", written, text_of(facade::deck_story(deck::new_deck(type)))));
}

void new_from_catalogue(const std::string& designation, const std::string& out) {
  const deck::CatalogueBearing bearing = deck::find_bearing(designation);
  const std::string written = write_new(out, deck::catalogue_deck(bearing));
  const std::string story = text_of(deck::catalogue_story(bearing));
  tell(written.empty() ? story : fmt::format("wrote {}\n{}", written, story));
}

const deck::TemplateInfo& example(const std::string& name) {
  (void)deck::template_text(name);  // refuses an unknown one
  return *std::find_if(deck::templates().begin(), deck::templates().end(),
                       [&](const deck::TemplateInfo& info) { return info.name == name; });
}

nlohmann::ordered_json example_json(const deck::TemplateInfo& info) {
  return {{"name", info.name},
          {"description", info.description},
          {"does", facade::deck_story(deck::new_deck(info.name))}};
}

void examples(const std::string& name, bool json) {
  if (json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const deck::TemplateInfo& info : deck::templates())
      if (name.empty() || info.name == name) list.push_back(example_json(info));
    if (!name.empty()) (void)example(name);
    print("{}\n", dump_json(list, 2));
  } else if (!name.empty()) {
    print("{}: {}\n{}", name, example(name).description,
          text_of(facade::deck_story(deck::new_deck(name))));
  } else {
    for (const deck::TemplateInfo& info : deck::templates())
      print("{:<20} {}\n", info.name, info.description);
    print("\n`adore examples NAME` says what a deck does; `adore new NAME --out FILE` writes it\n");
  }
}

std::vector<std::string> template_names() {
  std::vector<std::string> out;
  for (const deck::TemplateInfo& info : deck::templates()) out.emplace_back(info.name);
  return out;
}

}  // namespace

void add_deck_commands(CLI::App& app, int& exit_code) {
  {
    CLI::App* command = app.add_subcommand("check", "list every error and warning of a deck");
    auto path = std::make_shared<std::string>(".");
    auto json = std::make_shared<bool>(false);
    add_deck(*command, *path);
    auto codes = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "as JSON");
    command->add_flag("--codes", *codes, "list the codes of all findings, as Markdown");
    command->footer(
        "Examples\n"
        "  adore check DATA.txt\n"
        "  adore new ball | adore check -");
    command->callback([=, &exit_code] {
      if (*codes)
        print("{}", finding_codes_page());
      else
        exit_code = check(*path, *json);
    });
  }
  {
    CLI::App* command = app.add_subcommand(
        "plan", "show what a deck would simulate, why, and at what cost in time and disk");
    auto options = std::make_shared<PlanOptions>();
    options->add_to(*command);
    command->add_flag("--json", options->json, "as JSON");
    CLI::Option* what_if = command->add_flag(
        "--what-if", options->what_if,
        "run a short span without each effect: what it changes, and its share of the cost");
    command->add_option("--turns", options->turns, "turns of the shaft of these runs")
        ->needs(what_if)
        ->capture_default_str();
    command->footer(
        "Examples\n"
        "  adore plan DATA.txt\n"
        "  adore plan DATA.txt --what-if --turns 5\n"
        "  adore plan DATA.txt --set kTrac=0 --json");
    command->callback([=] { plan(*options); });
  }
  {
    CLI::App* command = app.add_subcommand("schema", "print the record schema of the deck");
    auto format = std::make_shared<std::string>("tsv");
    auto json = std::make_shared<bool>(false);
    command_line::one_of(command->add_option("--format", *format, "form of the table")
                             ->capture_default_str()
                             ->type_name("FORM"),
                         {"tsv", "json", "md"});
    command->add_flag("--json", *json, "as JSON; the same as --format json");
    command->footer("Example\n  adore schema --format md > records.md");
    command->callback([=] {
      const std::string form = *json ? "json" : *format;
      write_text("", "",
                 form == "tsv"    ? deck::schema_tsv()
                 : form == "json" ? deck::schema_json()
                                  : deck::schema_markdown());
    });
  }
  {
    CLI::App* command =
        app.add_subcommand("new", "write a complete, runnable deck and say what it does");
    auto type = std::make_shared<std::string>();
    auto out = std::make_shared<std::string>();
    auto designation = std::make_shared<std::string>();
    CLI::Option* name = command->add_option(
        "type", *type,
        "ball, cylindrical, spherical, tapered or spherical-tapered, or another name of `adore "
        "examples`");
    command_line::offer(name->type_name("NAME"), template_names());
    command
        ->add_option("--catalogue", *designation,
                     "a bearing by its designation (6205, 7208 B, NU209, 30208, 22210) or outside "
                     "('deep-groove 25x52x15' in mm): standard boundary dimensions, the inside "
                     "estimated")
        ->type_name("BEARING")
        ->excludes(name);
    command->add_option("--out", *out, "file or folder to write (standard output unless given)")
        ->type_name("FILE");
    command->footer(
        "Examples\n"
        "  adore new ball --out DATA.txt\n"
        "  adore new --catalogue 6205 --out DATA.txt");
    command->callback([=] {
      if (!designation->empty()) return new_from_catalogue(*designation, *out);
      if (type->empty())
        throw InputError(
            "name an example (`adore examples` lists them), or a bearing with --catalogue");
      new_deck(*type, *out);
    });
  }
  {
    CLI::App* command =
        app.add_subcommand("examples", "list the example decks, or say what one does");
    auto name = std::make_shared<std::string>();
    auto json = std::make_shared<bool>(false);
    command_line::offer(
        command->add_option("name", *name, "the one to describe")->type_name("NAME"),
        template_names());
    command->add_flag("--json", *json, "as JSON");
    command->footer("Example\n  adore examples deep-groove-6205");
    command->callback([=] { examples(*name, *json); });
  }
}

}  // namespace adore::cli

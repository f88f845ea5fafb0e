#include "base/atomic_file.hpp"
#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/streams.hpp"
#include "deck/templates.hpp"
#include "facade/check.hpp"
#include "facade/plan_json.hpp"
#include "facade/prepare.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

namespace adore::cli {
namespace {

const char* word(Severity severity) {
  return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

/// All errors and warnings of a deck; what it asks for that cannot run yet is a note here and an
/// error of `run`.
int check(const std::string& path, bool json) {
  const deck::ReadResult read = deck::read_deck(facade::deck_path(path));
  std::vector<Issue> issues = read.issues;
  if (read.ok())
    for (Issue& issue : facade::check_model(read.deck)) issues.push_back(std::move(issue));
  const bool ok = std::none_of(issues.begin(), issues.end(), [](const Issue& issue) {
    return issue.severity == Severity::Error;
  });
  if (json) {
    nlohmann::ordered_json out;
    out["file"] = read.deck.file;
    out["ok"] = ok;
    out["issues"] = nlohmann::ordered_json::array();
    for (const Issue& issue : issues)
      out["issues"].push_back({{"severity", word(issue.severity)},
                               {"line", issue.line},
                               {"record", issue.record},
                               {"variable", issue.variable},
                               {"value", issue.value},
                               {"message", issue.message},
                               {"remedy", issue.remedy}});
    fmt::print("{}\n", out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    for (const Issue& issue : issues) fmt::print("{}\n", issue.text());
    std::size_t errors = 0;
    for (const Issue& issue : issues) errors += issue.severity == Severity::Error ? 1 : 0;
    fmt::print("{}: {} records, {} error{}, {} other remark{}\n", read.deck.file,
               read.deck.records.size(), errors, errors == 1 ? "" : "s", issues.size() - errors,
               issues.size() - errors == 1 ? "" : "s");
  }
  return ok ? 0 : 2;
}

void plan(const DeckOptions& options, bool json) {
  facade::DeckRequest request;
  options.fill(request);
  const facade::Prepared prepared = facade::prepare(request);
  print_warnings(prepared.input.warnings);
  const dynamics::ScenePlan scene = facade::plan_with_estimates(prepared);
  if (json)
    fmt::print("{}\n", facade::plan_json(scene, facade::stability_text(prepared)).dump(2));
  else
    fmt::print("{}", facade::plan_text(prepared, scene));
}

void new_deck(const std::string& type, const std::string& out) {
  const std::string_view text = deck::template_text(type);
  if (out.empty()) {
    fmt::print("{}", text);
    return;
  }
  const std::filesystem::path path(out);
  if (std::filesystem::exists(path))
    throw InputError(
        fmt::format("{} exists already; name another file, or remove it first", path.string()));
  write_file_atomically(path, text);
  tell(fmt::format("wrote {}\n", path.string()));
}

}  // namespace

void add_deck_commands(CLI::App& app, int& exit_code) {
  {
    CLI::App* command = app.add_subcommand("check", "list every error and warning of a deck");
    auto path = std::make_shared<std::string>(".");
    auto json = std::make_shared<bool>(false);
    command->add_option("deck", *path, "deck file, or a folder that holds DATA.txt")
        ->capture_default_str();
    command->add_flag("--json", *json, "as JSON");
    command->callback([=, &exit_code] { exit_code = check(*path, *json); });
  }
  {
    CLI::App* command =
        app.add_subcommand("plan", "show what a deck would simulate, why, and at what cost");
    auto options = std::make_shared<DeckOptions>();
    auto json = std::make_shared<bool>(false);
    options->add_to(*command);
    command->add_flag("--json", *json, "as JSON");
    command->callback([=] { plan(*options, *json); });
  }
  {
    CLI::App* command = app.add_subcommand("schema", "print the record schema of the deck");
    auto format = std::make_shared<std::string>("tsv");
    command->add_option("--format", *format, "tsv, json or md")
        ->check(CLI::IsMember({"tsv", "json", "md"}))
        ->capture_default_str();
    command->callback([=] {
      const std::string text = *format == "tsv"    ? deck::schema_tsv()
                               : *format == "json" ? deck::schema_json()
                                                   : deck::schema_markdown();
      std::fwrite(text.data(), 1, text.size(), stdout);
    });
  }
  {
    CLI::App* command = app.add_subcommand("new", "write a complete, runnable deck");
    auto type = std::make_shared<std::string>();
    auto out = std::make_shared<std::string>();
    command->add_option("type", *type, "ball, cylindrical, spherical, tapered or spherical-tapered")
        ->required();
    command->add_option("--out", *out, "file to write (default: standard output)");
    command->callback([=] { new_deck(*type, *out); });
  }
  {
    CLI::App* command = app.add_subcommand("examples", "list the example decks");
    command->callback([] {
      for (const deck::TemplateInfo& info : deck::templates())
        fmt::print("{:<20} {}\n", info.name, info.description);
    });
  }
}

}  // namespace adore::cli

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "base/terminal_text.hpp"
#include "cli/commands.hpp"
#include "cli/export.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "results/convert.hpp"
#include "results/file_sums.hpp"
#include "studies/campaign.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace adore::cli {
namespace {

/// @returns the problem of the file
std::string convert_to(const std::string& file, const std::string& format, const std::string& out) {
  if (out.empty() || out == kStream) {
    std::string note;
    print_export([&](std::ostream& text) { note = results::convert_file(file, format, text); });
    return note;
  }
  std::filesystem::path path(out);
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    path /= std::filesystem::path(file).filename().string() + "." + format;
  std::string note;
  write_export(path, [&](std::ostream& text) { note = results::convert_file(file, format, text); },
               {file});
  return note;
}

void convert(const std::string& file, const std::string& format, const std::string& out) {
  if (const std::string note = convert_to(file, format, out); !note.empty())
    tell(fmt::format("adore: warning: {}: {}\n", file, note));
}

std::string_view state_name(results::FileCheck::State state) {
  switch (state) {
    case results::FileCheck::State::Intact:
      return "intact";
    case results::FileCheck::State::Damaged:
      return "DAMAGED";
    case results::FileCheck::State::Missing:
      return "MISSING";
    case results::FileCheck::State::Unchecked:
      break;
  }
  return "unchecked";
}

int verify(const std::string& name, bool json) {
  using State = results::FileCheck::State;
  const std::filesystem::path folder(name);
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw InputError(name + ": this is not a folder; give the folder of a run, sweep or study");
  const bool study = std::filesystem::exists(folder / "job.json", error);
  const std::vector<results::FileCheck> files =
      study ? studies::verify_study(folder) : results::verify_run(folder);
  const bool damaged = std::any_of(files.begin(), files.end(), [](const auto& file) {
    return file.state == State::Damaged || file.state == State::Missing;
  });
  if (json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const results::FileCheck& file : files)
      list.push_back({{"file", file.file.string()},
                      {"state", state_name(file.state)},
                      {"detail", file.detail}});
    print("{}\n", dump_json(nlohmann::ordered_json{{"intact", !damaged}, {"files", list}}, 2));
  } else {
    for (const results::FileCheck& file : files)
      print("{:<10} {}: {}\n", state_name(file.state), file.file.string(), file.detail);
    print("{}\n", damaged ? "at least one file is damaged or missing" : "no damage was found");
  }
  return damaged ? 1 : 0;
}

}  // namespace

void add_file_commands(CLI::App& app, int& exit_code) {
  {
    CLI::App* command = app.add_subcommand(
        "verify", "check the files of a run, sweep or study against their checksums");
    auto folder = std::make_shared<std::string>();
    auto json = std::make_shared<bool>(false);
    command->add_option("folder", *folder, "folder of a run, sweep or study")
        ->required()
        ->type_name("FOLDER");
    command->add_flag("--json", *json, "print as JSON");
    command->footer(
        "Exit code 1: a file is damaged or missing. An unfinished run is checked up to its last\n"
        "checkpoint.\n\n"
        "Examples\n"
        "  adore verify RUN\n"
        "  adore verify clearance.study --json");
    command->callback([=, &exit_code] { exit_code = verify(*folder, *json); });
  }
  {
    CLI::App* command =
        app.add_subcommand("show", "describe a SOL, FINAL, MASTER, RUN.json or RESULTS.h5 file");
    auto file = std::make_shared<std::string>();
    auto json = std::make_shared<bool>(false);
    command->add_option("file", *file, "result file")->required()->type_name("FILE");
    command->add_flag("--json", *json, "print as JSON");
    command->footer(
        "Examples\n"
        "  adore show SOL1\n"
        "  adore show RESULTS.h5 --json");
    command->callback([=] {
      write_text("", "",
                 *json ? results::describe_file_json(*file) : results::describe_file(*file));
    });
  }
  {
    CLI::App* command = app.add_subcommand("convert", "export a result file");
    auto file = std::make_shared<std::string>();
    auto format = std::make_shared<std::string>();
    auto out = std::make_shared<std::string>();
    command->add_option("file", *file, "result file")->required()->type_name("FILE");
    command_line::one_of(
        command->add_option("--to", *format, "table format")->required()->type_name("FORM"),
        {"csv", "json"});
    command->add_option("--out", *out, "file or folder to write (default: standard output)")
        ->type_name("FILE");
    command->footer(
        "Examples\n"
        "  adore convert SOL1 --to csv --out sol1.csv\n"
        "  adore convert RESULTS.h5 --to json | jq .columns");
    command->callback([=] { convert(*file, *format, *out); });
  }
}

}  // namespace adore::cli

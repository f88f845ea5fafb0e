#include "cli/commands.hpp"
#include "cli/export.hpp"
#include "cli/streams.hpp"
#include "cli/text_io.hpp"
#include "command_line/tree.hpp"
#include "results/convert.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>

namespace adore::cli {
namespace {

/// @returns what is wrong with the file
std::string convert_to(const std::string& file, const std::string& format, const std::string& out) {
  if (out.empty() || out == kStream) return results::convert_file(file, format, std::cout);
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

}  // namespace

void add_file_commands(CLI::App& app, int&) {
  {
    CLI::App* command =
        app.add_subcommand("show", "look into a SOL, FINAL, MASTER, RUN.json or RESULTS.h5 file");
    auto file = std::make_shared<std::string>();
    auto json = std::make_shared<bool>(false);
    command->add_option("file", *file, "result file")->required()->type_name("FILE");
    command->add_flag("--json", *json, "as JSON");
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
        command->add_option("--to", *format, "form of the table")->required()->type_name("FORM"),
        {"csv", "json"});
    command->add_option("--out", *out, "file or folder to write (standard output unless given)")
        ->type_name("FILE");
    command->footer(
        "Examples\n"
        "  adore convert SOL1 --to csv --out sol1.csv\n"
        "  adore convert RESULTS.h5 --to json | jq .columns");
    command->callback([=] { convert(*file, *format, *out); });
  }
}

}  // namespace adore::cli

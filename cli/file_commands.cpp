#include "cli/commands.hpp"
#include "cli/export.hpp"
#include "results/convert.hpp"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <sstream>

namespace adore::cli {

void add_file_commands(CLI::App& app, int&) {
  {
    CLI::App* command =
        app.add_subcommand("show", "look into a SOL, FINAL, MASTER, RUN.json or RESULTS.h5 file");
    auto file = std::make_shared<std::string>();
    command->add_option("file", *file, "result file")->required();
    command->callback([=] { fmt::print("{}", results::describe_file(*file)); });
  }
  {
    CLI::App* command = app.add_subcommand("convert", "export a result file");
    auto file = std::make_shared<std::string>();
    auto format = std::make_shared<std::string>();
    auto out = std::make_shared<std::string>();
    command->add_option("file", *file, "result file")->required();
    command->add_option("--to", *format, "csv or json")
        ->required()
        ->check(CLI::IsMember({"csv", "json"}));
    command->add_option("--out", *out, "file to write (default: standard output)");
    command->callback([=] {
      if (out->empty()) return results::convert_file(*file, *format, std::cout);
      std::ostringstream text;
      text.imbue(std::locale::classic());
      results::convert_file(*file, *format, text);
      write_export(*out, text.str(), {*file});
    });
  }
}

}  // namespace adore::cli

#include "command_line/program.hpp"

#include "base/terminal_text.hpp"
#include "base/version.hpp"
#include "command_line/documents.hpp"
#include "command_line/terminal.hpp"
#include "command_line/usage_error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace adore::command_line {
namespace {

void print(std::FILE* stream, const std::string& text) { print_text(stream, text); }

std::string completion(const CLI::App& program, const std::string& shell) {
  const CommandDescription tree = describe(program);
  if (shell == "bash") return bash_completion(tree);
  if (shell == "zsh") return zsh_completion(tree);
  if (shell == "fish") return fish_completion(tree);
  return command_tree_json(tree);
}

std::string help(const CLI::App& program, int stream) {
  const CLI::App* app = &program;
  std::string path = program.get_name();
  while (!app->get_subcommands().empty()) {
    app = app->get_subcommands().back();
    path += " " + app->get_name();
  }
  return help_text(describe(*app), path, columns(stream));
}

/// `--quiet=3` is a mistake, not a flag given three times.
void refuse_values_of_flags(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() == 0) option->disable_flag_override();
  for (CLI::App* command : app.get_subcommands({})) refuse_values_of_flags(*command);
}

}  // namespace

std::unique_ptr<CLI::App> make_program(const std::string& text, const std::string& name) {
  auto program = std::make_unique<CLI::App>(text, name);
  program->set_help_flag("-h,--help", "show this help and exit");
  program->set_version_flag("--version", std::string(kProgramVersion), "show the version and exit");
  CLI::App* const app = program.get();
  program->add_flag_callback(
      "--man",
      [app] {
        print(stdout, manual_page(describe(*app), std::string(kProgramVersion)));
        throw CLI::Success();
      },
      "print the manual page; read it with `" + name + " --man | man -l -`");
  one_of(program
             ->add_option_function<std::string>(
                 "--completion",
                 [app](const std::string& shell) {
                   print(stdout, completion(*app, shell));
                   throw CLI::Success();
                 },
                 "print the completion script of a shell, or all commands and options as JSON")
             ->type_name("SHELL"),
         {"bash", "zsh", "fish", "json"});
  return program;
}

std::optional<int> parse(CLI::App& program, int argc, char** argv) {
  refuse_values_of_flags(program);
  try {
    program.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    print(stdout, help(program, STDOUT_FILENO));
    return 0;
  } catch (const CLI::CallForVersion& version) {
    print(stdout, std::string(version.what()) + "\n");
    return 0;
  } catch (const CLI::Success&) {
    return 0;
  } catch (const CLI::ParseError& error) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.empty()) print(stderr, help(program, STDERR_FILENO));
    print(stderr, fmt::format("{}: {}\n", program.get_name(), explain(program, error, arguments)));
    return 2;
  }
}

}  // namespace adore::command_line

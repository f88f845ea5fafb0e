#include "command_line/usage_error.hpp"

#include "command_line/tree.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::command_line {
namespace {

/// The command that was being read.
const CLI::App& current(const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  return chosen.empty() ? program : current(*chosen.back());
}

std::string path_of(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name()
                                     : path_of(*app.get_parent()) + " " + app.get_name();
}

/// "--out", "file": the name that begins a text of the option library.
std::string name_in(const CLI::ParseError& error, const std::string& before) {
  std::string text = error.what();
  const std::size_t from = before.empty() ? 0 : text.find(before);
  if (from == std::string::npos) return {};
  text = text.substr(from + before.size());
  return text.substr(0, text.find_first_of(": ="));
}

std::string after_colon(const CLI::ParseError& error) {
  const std::string text = error.what();
  const std::size_t colon = text.find(": ");
  return colon == std::string::npos ? text : text.substr(colon + 2);
}

std::vector<std::string> option_names(const CommandDescription& command) {
  std::vector<std::string> out;
  for (const OptionDescription& option : command.options)
    if (!option.positional) out.insert(out.end(), option.names.begin(), option.names.end());
  return out;
}

const OptionDescription* option_named(const CommandDescription& command, const std::string& name) {
  for (const OptionDescription& option : command.options)
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end())
      return &option;
  return nullptr;
}

std::string did_you_mean(const std::string& text, const std::vector<std::string>& words) {
  const std::string near = nearest(text, words);
  return near.empty() ? std::string() : fmt::format("; did you mean {}?", near);
}

std::string unknown_command(const CLI::App& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  for (const std::string& word : arguments)
    if (!word.empty() && word[0] != '-')
      return fmt::format("there is no command \"{}\"{}", word, did_you_mean(word, names));
  if (!arguments.empty())
    return fmt::format("option {} is not valid before a command{}", arguments.front(),
                       did_you_mean(arguments.front(), option_names(describe(program))));
  return "the command is missing";
}

std::string surplus(const CLI::App& app, const CommandDescription& command,
                    const std::string& path) {
  std::vector<std::string> rest = app.remaining(true);
  for (const CLI::App* above = app.get_parent(); above != nullptr; above = above->get_parent())
    for (const std::string& word : above->remaining(false)) rest.push_back(word);
  const std::string word = rest.empty() ? std::string() : rest.front();
  if (word.size() > 1 && word[0] == '-') {
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("`{}` has no option {}{}", path, name,
                       did_you_mean(name, option_names(command)));
  }
  if (option_named(command, "--set") != nullptr) {
    // CLI11 took the argument after a --set without value for the deck.
    std::vector<std::string> words{word};
    for (const CLI::Option* option : app.get_options())
      if (option->get_positional())
        words.insert(words.end(), option->results().begin(), option->results().end());
    for (const std::string& one : words)
      if (one.find('=') != std::string::npos)
        return fmt::format(
            "\"{}\" has no option before it; write --set (or --opt) before each name=value", one);
  }
  std::string takes;
  for (const OptionDescription& option : command.options)
    if (option.positional)
      takes += (takes.empty() ? "" : " and ") + ("one " + option.names.front());
  return fmt::format("\"{}\" is one argument too many; `{}` takes {}", word, path,
                     takes.empty() ? "none" : takes);
}

std::string what_to_give(const OptionDescription* option) {
  if (option == nullptr) return "a value";
  if (!option->words.empty() && option->words.size() <= 12) {
    std::string list;
    for (const std::string& word : option->words) list += (list.empty() ? "" : ", ") + word;
    return "one of " + list;
  }
  if (option->value == "N") return "a whole number: " + option->help;
  if (option->value == "NUMBER") return "a number: " + option->help;
  return fmt::format("{}: {}", option->value, option->help);
}

std::string sentence(const CLI::App& program, const CLI::ParseError& error,
                     const std::vector<std::string>& arguments) {
  const CLI::App& app = current(program);
  const CommandDescription command = describe(app);
  const std::string path = path_of(app);
  // For surplus arguments the library stores the command name instead of the kind of error.
  const std::string kind =
      dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ? "ExtrasError" : error.get_name();
  if (!command.commands.empty() && (kind == "RequiredError" || kind == "ExtrasError"))
    return unknown_command(program, arguments);
  if (kind == "ExtrasError") return surplus(app, command, path);
  if (kind == "RequiredError") {
    const std::string name = name_in(error, "");
    const OptionDescription* option = option_named(command, name);
    return fmt::format("`{}` needs {}: {}", path, name,
                       option == nullptr ? "it is missing" : option->help);
  }
  if (kind == "ArgumentMismatch") {
    std::string name = name_in(error, "");
    // For a flag with a value the library gives the name without its dashes.
    if (option_named(command, name) == nullptr) name = "--" + name;
    const OptionDescription* option = option_named(command, name);
    if (after_colon(error).find("Most") != std::string::npos)
      return fmt::format("{} was given more than once; give it only once", name);
    if (option != nullptr && option->value.empty())
      return fmt::format("{} takes no value. Remove the value", name);
    return fmt::format("{} needs a value; give {}", name, what_to_give(option));
  }
  if (kind == "ConversionError") {
    const std::string before = "Could not convert: ";
    const bool known = std::string(error.what()).compare(0, before.size(), before) == 0;
    const std::string name = name_in(error, known ? before : "");
    const OptionDescription* option = option_named(command, name);
    if (option != nullptr && option->value.empty())
      return fmt::format("{} takes no value. Remove the value", name);
    const std::string text = error.what();
    const std::size_t at = text.find(" = ");
    return fmt::format("{}{}: invalid value; give {}", name,
                       at == std::string::npos ? "" : " " + text.substr(at + 3),
                       what_to_give(option));
  }
  if (kind == "ValidationError")
    return fmt::format("{}: {}", name_in(error, ""), after_colon(error));
  if (kind == "RequiresError" || kind == "ExcludesError") {
    const std::string text = error.what(),
                      verb = kind == "RequiresError" ? " requires " : " excludes ";
    const std::size_t at = text.find(verb);
    const std::string one = text.substr(0, at),
                      other = text.substr(std::min(at, text.size() - verb.size()) + verb.size());
    return kind == "RequiresError"
               ? fmt::format("{} works only together with {}; give both", one, other)
               : fmt::format("{} and {} exclude each other; give only one of them", one, other);
  }
  return fmt::format("invalid command line ({})", error.what());
}

}  // namespace

std::string explain(const CLI::App& program, const CLI::ParseError& error,
                    const std::vector<std::string>& arguments) {
  return fmt::format("{}\n{}: `{} --help` lists commands and options",
                     sentence(program, error, arguments), program.get_name(),
                     path_of(current(program)));
}

}  // namespace adore::command_line

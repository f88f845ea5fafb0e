#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// The tree of a program's commands and options as plain values: help, manual page, completion and
/// JSON are walks over it.
namespace adore::command_line {

/// Kind of the value of an option, for completion.
enum class ValueKind : unsigned char { None, Text, Number, File, Folder, Words };

struct OptionDescription {
  std::vector<std::string> names;  ///< "--out", "-h"; of a positional its one name: "deck"
  std::string value;               ///< "FILE"; empty: a flag
  std::string help;
  std::string default_value;  ///< empty: none to show
  ValueKind kind = ValueKind::None;
  std::vector<std::string> words;  ///< possible values, or beginnings of possible values
  bool positional = false, required = false, many = false;
};

struct CommandDescription {
  std::string name, help, footer;
  std::vector<OptionDescription> options;  ///< positionals first
  std::vector<CommandDescription> commands;
};

/// Hidden options and commands (of an empty group) are left out.
[[nodiscard]] CommandDescription describe(const CLI::App& app);

/// Accepts only these values; other values are rejected with the nearest match. Help lists the
/// values, and the shells complete them.
CLI::Option* one_of(CLI::Option* option, std::vector<std::string> words);

/// Completions for an option that accepts other values, too: "pitchDia=".
CLI::Option* suggest_values(CLI::Option* option, std::vector<std::string> words);

/// A whole number, or a number, of at least `least`; refused otherwise.
CLI::Option* at_least(CLI::Option* option, double least);

/// The known word most similar to `text`; empty if none is similar.
[[nodiscard]] std::string nearest(const std::string& text, const std::vector<std::string>& words);

}  // namespace adore::command_line

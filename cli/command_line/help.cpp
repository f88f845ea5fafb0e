#include "command_line/documents.hpp"
#include "command_line/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::command_line {
namespace {

std::string value_of(const OptionDescription& option) {
  return option.value.empty() ? std::string() : option.value + (option.many ? " ..." : "");
}

std::string names_of(const OptionDescription& option) {
  std::string out;
  for (const std::string& name : option.names) out += (out.empty() ? "" : ", ") + name;
  if (!option.positional && !option.value.empty()) out += " " + option.value;
  if (option.positional && option.many) out += " ...";
  return out;
}

std::string help_of(const OptionDescription& option) {
  std::string out = help_with_choices(option);
  if (!option.default_value.empty()) out += fmt::format(" (default: {})", option.default_value);
  return out;
}

/// Names in a left column with texts next to them; long names get a separate line.
std::string entries(const std::vector<std::pair<std::string, std::string>>& rows,
                    std::size_t width) {
  constexpr std::size_t kMargin = 2, kMaxNameWidth = 24;
  std::size_t names = 0;
  for (const auto& row : rows)
    if (row.first.size() <= kMaxNameWidth) names = std::max(names, row.first.size());
  const std::size_t column = kMargin + std::max<std::size_t>(names, 8) + 2;
  std::string out;
  for (const auto& [name, text] : rows) {
    out += std::string(kMargin, ' ') + name;
    out += name.size() + kMargin + 2 > column ? "\n" + std::string(column, ' ')
                                              : std::string(column - kMargin - name.size(), ' ');
    out += wrap_text(text, width, column) + "\n";
  }
  return out;
}

}  // namespace

std::string help_with_choices(const OptionDescription& option) {
  constexpr std::size_t kMaxListedChoices = 12;
  if (option.words.empty() || option.words.size() > kMaxListedChoices) return option.help;
  std::string out = option.help;
  for (const std::string& word : option.words)
    out += (&word == &option.words.front() ? ": " : ", ") + word;
  return out;
}

std::string usage_line(const CommandDescription& command, const std::string& path) {
  std::string out = path;
  if (!command.commands.empty()) return out + " COMMAND ...";
  for (const OptionDescription& option : command.options) {
    if (!option.positional) continue;
    const std::string name = option.names.front() + (option.many ? " ..." : "");
    out += option.required ? " " + name : " [" + name + "]";
  }
  for (const OptionDescription& option : command.options)
    if (!option.positional && option.required)
      out += fmt::format(" {} {}", option.names.back(), value_of(option));
  return out + " [options]";
}

std::string help_text(const CommandDescription& command, const std::string& path,
                      std::size_t width) {
  const std::size_t columns = std::clamp<std::size_t>(width, 40, 110);
  std::string out = wrap_text(command.help, columns, 0) + "\n\n";
  out += "Usage: " + usage_line(command, path) + "\n";
  std::vector<std::pair<std::string, std::string>> positionals, options, commands;
  for (const OptionDescription& option : command.options)
    (option.positional ? positionals : options).emplace_back(names_of(option), help_of(option));
  for (const CommandDescription& one : command.commands) commands.emplace_back(one.name, one.help);
  if (!positionals.empty()) out += "\n" + entries(positionals, columns);
  if (!commands.empty()) out += "\nCommands\n" + entries(commands, columns);
  if (!options.empty()) out += "\nOptions\n" + entries(options, columns);
  if (!command.footer.empty()) out += "\n" + command.footer + "\n";
  return out;
}

}  // namespace adore::command_line

#include "base/json_text.hpp"
#include "command_line/documents.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace adore::command_line {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::vector<std::string> option_names(const CommandDescription& command) {
  std::vector<std::string> out;
  for (const OptionDescription& option : command.options)
    if (!option.positional) out.insert(out.end(), option.names.begin(), option.names.end());
  return out;
}

std::vector<std::string> command_names(const CommandDescription& program) {
  std::vector<std::string> out;
  for (const CommandDescription& command : program.commands) out.push_back(command.name);
  return out;
}

const OptionDescription* first_positional(const CommandDescription& command) {
  for (const OptionDescription& option : command.options)
    if (option.positional) return &option;
  return nullptr;
}

std::string identifier(std::string text) {
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

// bash

std::string bash_action(const OptionDescription& option) {
  switch (option.kind) {
    case ValueKind::Words:
      return fmt::format("_{{0}}_words \"{}\"", joined(option.words));
    case ValueKind::File:
      return "compopt -o default; COMPREPLY=()";
    case ValueKind::Folder:
      return "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- \"$cur\")";
    case ValueKind::None:
    case ValueKind::Text:
    case ValueKind::Number:
      break;
  }
  return "COMPREPLY=()";
}

std::string bash_cases(const CommandDescription& command, const std::string& self) {
  std::string out = "      case \"$prev\" in\n";
  for (const OptionDescription& option : command.options) {
    if (option.positional || option.value.empty()) continue;
    std::string names;
    for (const std::string& name : option.names) names += (names.empty() ? "" : "|") + name;
    out += fmt::format("        {}) {}; return ;;\n", names,
                       replaced(bash_action(option), "{0}", self));
  }
  out += "      esac\n";
  out += fmt::format("      if [[ $cur == -* ]]; then _{}_words \"{}\"; return; fi\n", self,
                     joined(option_names(command)));
  if (const OptionDescription* positional = first_positional(command))
    out += fmt::format("      {}\n", replaced(bash_action(*positional), "{0}", self));
  return out;
}

// zsh

std::string zsh_text(const std::string& text) {
  std::string out = replaced(text, "\\", "\\\\");
  for (const char* special : {"[", "]", ":"})
    out = replaced(out, special, std::string("\\") + special);
  return replaced(out, "'", "'\\''");
}

std::string zsh_action(const OptionDescription& option) {
  switch (option.kind) {
    case ValueKind::Words: {
      std::vector<std::string> words = option.words;
      for (std::string& word : words) word = zsh_text(word);
      // After "pitchDia=" the value follows, not a space.
      if (std::all_of(words.begin(), words.end(), [](const auto& w) { return w.ends_with('='); }))
        return fmt::format(":{}:compadd -S \"\" - {}", zsh_text(option.value), joined(words));
      return fmt::format(":{}:({})", zsh_text(option.value), joined(words));
    }
    case ValueKind::File:
      return fmt::format(":{}:_files", zsh_text(option.value));
    case ValueKind::Folder:
      return fmt::format(":{}:_files -/", zsh_text(option.value));
    case ValueKind::None:
      return {};
    case ValueKind::Text:
    case ValueKind::Number:
      break;
  }
  return fmt::format(":{}: ", zsh_text(option.value));
}

std::string zsh_arguments(const CommandDescription& command, const std::string& indent) {
  std::string out = indent + "_arguments -s";
  for (const OptionDescription& option : command.options) {
    if (option.positional) {
      out += fmt::format(" \\\n{}  '{}{}'", indent, option.many ? "*" : "1",
                         option.kind == ValueKind::None ? std::string(": : ") : zsh_action(option));
      continue;
    }
    for (const std::string& name : option.names)
      out += fmt::format(" \\\n{}  '{}{}[{}]{}'", indent, option.many ? "*" : "", name,
                         zsh_text(option.help), zsh_action(option));
  }
  return out + "\n";
}

// fish

std::string fish_text(const std::string& text) {
  return replaced(replaced(text, "\\", "\\\\"), "'", "\\'");
}

std::string fish_options(const CommandDescription& command, const std::string& program,
                         const std::string& condition) {
  std::string out;
  for (const OptionDescription& option : command.options) {
    std::string line = fmt::format("complete -c {}{}", program,
                                   condition.empty() ? "" : " -n '" + condition + "'");
    std::string action;
    if (option.kind == ValueKind::Words)
      action = fmt::format(" -f -a '{}'", fish_text(joined(option.words)));
    else if (option.kind == ValueKind::Folder)
      action = " -f -a '(__fish_complete_directories)'";
    else if (option.kind == ValueKind::File)
      action = " -F";
    if (option.positional) {
      if (!action.empty()) out += line + action + "\n";
      continue;
    }
    for (const std::string& name : option.names)
      line += name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (!option.value.empty()) line += " -r" + action;
    out += fmt::format("{} -d '{}'\n", line, fish_text(option.help));
  }
  return out;
}

nlohmann::ordered_json json_of(const CommandDescription& command) {
  nlohmann::ordered_json out{{"name", command.name}, {"help", command.help}};
  out["options"] = nlohmann::ordered_json::array();
  for (const OptionDescription& option : command.options) {
    nlohmann::ordered_json one{
        {"names", option.names}, {"positional", option.positional}, {"value", option.value},
        {"help", option.help},   {"default", option.default_value}, {"required", option.required},
        {"many", option.many}};
    if (!option.words.empty()) one["words"] = option.words;
    out["options"].push_back(std::move(one));
  }
  out["commands"] = nlohmann::ordered_json::array();
  for (const CommandDescription& one : command.commands) out["commands"].push_back(json_of(one));
  return out;
}

}  // namespace

std::string bash_completion(const CommandDescription& program) {
  const std::string self = identifier(program.name);
  std::string out = fmt::format(
      "# bash completion of {0}\n"
      "_{1}_words() {{\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$cur\")\n"
      "  [[ ${{#COMPREPLY[@]}} -eq 1 && ${{COMPREPLY[0]}} == *= ]] && compopt -o nospace\n"
      "}}\n"
      "_{1}() {{\n"
      "  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} command= i\n"
      "  COMPREPLY=()\n",
      program.name, self);
  if (!program.commands.empty()) {
    std::string names;
    for (const std::string& name : command_names(program))
      names += (names.empty() ? "" : "|") + name;
    out += fmt::format(
        "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
        "    case ${{COMP_WORDS[i]}} in\n"
        "      {}) command=${{COMP_WORDS[i]}}; break ;;\n"
        "    esac\n"
        "  done\n",
        names);
  }
  out += "  case \"$command\" in\n";
  for (const CommandDescription& command : program.commands)
    out += fmt::format("    {})\n{}      ;;\n", command.name, bash_cases(command, self));
  out += "    *)\n" + bash_cases(program, self);
  if (!program.commands.empty())
    out += fmt::format("      _{}_words \"{}\"\n", self, joined(command_names(program)));
  return out + fmt::format("      ;;\n  esac\n}}\ncomplete -F _{} {}\n", self, program.name);
}

std::string zsh_completion(const CommandDescription& program) {
  const std::string self = identifier(program.name);
  std::string out = fmt::format("#compdef {}\n_{}() {{\n", program.name, self);
  if (program.commands.empty())
    return out + zsh_arguments(program, "  ") + "}\n_" + self + " \"$@\"\n";
  out += "  local context state state_descr line\n  typeset -A opt_args\n";
  std::string arguments = zsh_arguments(program, "  ");
  arguments.insert(arguments.size() - 1, " \\\n    '1: :->command' '*:: :->arguments'");
  out += arguments + "  case $state in\n    command)\n      local -a commands=(\n";
  for (const CommandDescription& command : program.commands)
    out += fmt::format("        '{}:{}'\n", command.name, zsh_text(command.help));
  out += "      )\n      _describe command commands ;;\n    arguments)\n      case $line[1] in\n";
  for (const CommandDescription& command : program.commands)
    out += fmt::format("        {})\n{}          ;;\n", command.name,
                       zsh_arguments(command, "          "));
  return out + fmt::format("      esac ;;\n  esac\n}}\n_{} \"$@\"\n", self);
}

std::string fish_completion(const CommandDescription& program) {
  std::string out = fmt::format("# fish completion of {}\n", program.name);
  if (program.commands.empty()) return out + fish_options(program, program.name, "");
  out += fmt::format("complete -c {} -f\n", program.name);
  for (const CommandDescription& command : program.commands)
    out += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d '{}'\n", program.name,
                       command.name, fish_text(command.help));
  out += fish_options(program, program.name, "__fish_use_subcommand");
  for (const CommandDescription& command : program.commands)
    out += fish_options(command, program.name, "__fish_seen_subcommand_from " + command.name);
  return out;
}

std::string command_tree_json(const CommandDescription& program) {
  return dump_json(json_of(program), 2) + "\n";
}

}  // namespace adore::command_line

#include "command_line/documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace adore::command_line {
namespace {

/// Text of a page: hyphens as typed, backslashes kept, no line read as a request.
std::string roff(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool line_start = i == 0 || text[i - 1] == '\n';
    if (line_start && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string option_entry(const OptionDescription& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
  if (!option.positional && !option.value.empty())
    names += fmt::format(" \\fI{}\\fR", roff(option.value));
  if (option.many) names += " ...";
  std::string help = roff(help_with_choices(option));
  if (!option.default_value.empty())
    help += fmt::format(" (default: {})", roff(option.default_value));
  return fmt::format(".TP\n{}\n{}\n", names, help);
}

std::string options_of(const CommandDescription& command) {
  std::string out;
  for (const OptionDescription& option : command.options) out += option_entry(option);
  return out;
}

std::string footer_of(const CommandDescription& command) {
  return command.footer.empty() ? std::string()
                                : fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.footer));
}

}  // namespace

std::string manual_page(const CommandDescription& program, const std::string& version) {
  const std::size_t colon = program.help.find(": ");
  const std::string first = program.help.substr(colon == std::string::npos ? 0 : colon + 2);
  std::string out = fmt::format(".TH {} 1 \"\" \"{}\" \"Adore\"\n", upper(program.name), version);
  out += fmt::format(".SH NAME\n{} \\- {}\n", program.name,
                     roff(first.substr(0, std::min(first.find_first_of(".:"), first.size()))));
  out += fmt::format(".SH SYNOPSIS\n.B {}\n", roff(usage_line(program, program.name)));
  out += fmt::format(".SH DESCRIPTION\n{}\n", roff(program.help));
  out += ".SH OPTIONS\n" + options_of(program);
  if (!program.commands.empty()) out += ".SH COMMANDS\n";
  for (const CommandDescription& command : program.commands) {
    out += fmt::format(".SS {}\n{}\n.PP\n.B {}\n", roff(program.name + " " + command.name),
                       roff(command.help),
                       roff(usage_line(command, program.name + " " + command.name)));
    out += options_of(command) + footer_of(command);
  }
  if (!program.footer.empty()) out += ".SH NOTES\n" + footer_of(program);
  return out;
}

}  // namespace adore::command_line

#pragma once

#include "command_line/tree.hpp"

#include <cstddef>
#include <string>

/// Output generated from the tree of commands: help on the terminal, manual page, completion for
/// three shells, JSON.
namespace adore::command_line {

/// `--help` of a command; `path`: "adore run".
[[nodiscard]] std::string help_text(const CommandDescription& command, const std::string& path,
                                    std::size_t width);
/// Section 1, in man(7).
[[nodiscard]] std::string manual_page(const CommandDescription& program,
                                      const std::string& version);
[[nodiscard]] std::string bash_completion(const CommandDescription& program);
[[nodiscard]] std::string zsh_completion(const CommandDescription& program);
[[nodiscard]] std::string fish_completion(const CommandDescription& program);
[[nodiscard]] std::string command_tree_json(const CommandDescription& program);

/// Help of an option, followed by its choices: "view to draw: bearing, cage, 3d". Lists of more
/// than twelve are left out.
[[nodiscard]] std::string help_with_choices(const OptionDescription& option);

/// "adore run [DECK] [OPTIONS]"
[[nodiscard]] std::string usage_line(const CommandDescription& command, const std::string& path);

}  // namespace adore::command_line

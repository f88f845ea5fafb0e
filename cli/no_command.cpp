#include "cli/no_command.hpp"

#include "cli/streams.hpp"
#include "command_line/terminal.hpp"

#include <filesystem>
#include <iostream>
#include <string>
#include <unistd.h>

namespace adore::cli {

NoCommand ask_for_run() {
  std::error_code none;
  if (!std::filesystem::is_regular_file("DATA.txt", none)) return NoCommand::NoDeck;
  tell("This folder has a deck (DATA.txt). To run it:\n  adore run\n");
  const std::optional<bool> answer = ask("Run it now?");
  if (answer) return *answer ? NoCommand::Run : NoCommand::Declined;
  tell("adore: the command is missing\n");
  return NoCommand::NotAsked;
}

}  // namespace adore::cli

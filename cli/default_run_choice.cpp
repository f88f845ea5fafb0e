#include "cli/default_run_choice.hpp"

#include "cli/streams.hpp"
#include "command_line/terminal.hpp"

#include <filesystem>
#include <iostream>
#include <string>
#include <unistd.h>

namespace adore::cli {

DefaultRunChoice confirm_default_run() {
  std::error_code none;
  if (!std::filesystem::is_regular_file("DATA.txt", none)) return DefaultRunChoice::NoDeck;
  tell("This folder has a deck (DATA.txt). To run it:\n  adore run\n");
  const std::optional<bool> answer = ask("Run it now?");
  if (answer) return *answer ? DefaultRunChoice::Run : DefaultRunChoice::Declined;
  tell("adore: the command is missing\n");
  return DefaultRunChoice::NotAsked;
}

}  // namespace adore::cli

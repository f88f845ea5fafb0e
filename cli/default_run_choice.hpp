#pragma once

namespace adore::cli {

/// Of `adore` without a command.
enum class DefaultRunChoice : unsigned char {
  NoDeck,  ///< the folder has no DATA.txt
  Run,     ///< it has one, and the user wants it run
  Declined,
  NotAsked  ///< it has one, but there is no terminal to ask
};

/// The classic program runs the DATA.txt of its folder without a command. This one prints the
/// equivalent command, and runs it only after confirmation at the terminal.
[[nodiscard]] DefaultRunChoice confirm_default_run();

}  // namespace adore::cli

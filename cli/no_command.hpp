#pragma once

namespace adore::cli {

/// Of `adore` without a command.
enum class NoCommand : unsigned char {
  NoDeck,  ///< the folder has no DATA.txt
  Run,     ///< it has one, and the user wants it run
  Declined,
  NotAsked  ///< it has one, but nobody is at a terminal to be asked
};

/// The classic program runs the DATA.txt of its folder without being told to. This one says with
/// which command it does the same, and does it only after a yes at the terminal.
[[nodiscard]] NoCommand ask_for_run();

}  // namespace adore::cli

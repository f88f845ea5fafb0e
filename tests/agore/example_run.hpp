#pragma once

#include "core/results/synthetic.hpp"
#include "runs/run.hpp"
#include "support/paths.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <string>

/// The first steps of the example decks: real bodies, loads, flanges and cages of every type.
namespace adore::test {

inline const std::array<std::string, 5> kTypes{"ball", "cylindrical", "tapered", "spherical",
                                               "spherical-tapered"};

/// Folder of its files, made once for a program. SOL8 and RESULTS.h5 have every stored step.
inline const std::filesystem::path& example_run(const std::string& type) {
  static const testing::TemporaryFolder folder;
  static std::map<std::string, std::filesystem::path> made;
  const auto found = made.find(type);
  if (found != made.end()) return found->second;
  runs::RunRequest request;
  request.deck = source_dir() / "resources/decks" / (type + ".txt");
  request.out = folder / type;
  request.until =
      type == "ball" ? "0.3rev" : "0.1rev";  // balls start in equilibrium: later in pockets
  (void)runs::run(request);
  return made[type] = folder / type;
}

}  // namespace adore::test

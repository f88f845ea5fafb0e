#pragma once

#include <filesystem>
#include <string_view>

/// Paths of the files and programs of the tests. Compiled into one object, so that a clone in
/// another folder shares the compiler cache for all others.
namespace adore::test {

/// The checkout: `source_dir() / "resources/decks/ball.txt"`.
[[nodiscard]] const std::filesystem::path& source_dir();
/// The build folder, where tests may write.
[[nodiscard]] const std::filesystem::path& binary_dir();
/// A program of the suite: adore, adrinput, adrplot or agore.
[[nodiscard]] std::filesystem::path program(std::string_view name);

}  // namespace adore::test

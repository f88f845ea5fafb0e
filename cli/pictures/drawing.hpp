#pragma once

#include "cli/picture_commands.hpp"

#include <filesystem>

/// Drawing: the only part of the command line that links Qt.
namespace adore::cli {

/// `plot` and `animate` as AdrPlot and AGORE draw them; prints the names of the files.
[[nodiscard]] PictureActions drawing_actions();

/// Draws error against computing time of an ACCURACY.csv as a PNG. @throws InputError
void draw_accuracy_chart(const std::filesystem::path& table, const std::filesystem::path& picture);

}  // namespace adore::cli

#pragma once

#include <filesystem>
#include <vector>

namespace adore::adrinput {

struct RenderOptions {
  std::filesystem::path folder;  ///< made when missing
  int width = 1280, height = 800;
  bool dark = false;
};

/// Draws the window with all pages of a deck as PNG, named NN-record.png; for a form longer than
/// the window also the lower parts, and for tables wider than the window the right parts, as
/// NN-record-2.png and so on: every field is complete in one picture. Needs an application object
/// (desktop/bootstrap.hpp). @throws InputError for an unusable deck or folder.
std::vector<std::filesystem::path> render_pages(const std::filesystem::path& deck,
                                                const RenderOptions& options);

/// The same for a study file: its form in pieces, its text, and the result of the check.
std::vector<std::filesystem::path> render_study(const std::filesystem::path& file,
                                                const RenderOptions& options);

}  // namespace adore::adrinput

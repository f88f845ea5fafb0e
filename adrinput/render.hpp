#pragma once

#include <filesystem>
#include <vector>

namespace adore::adrinput {

struct RenderOptions {
  std::filesystem::path folder;  ///< made when missing
  int width = 1280, height = 800;
  bool dark = false;
};

/// Draws the window with every page of a deck as PNG, named NN-record.png; of a form that is longer
/// than the window also what lies further down, and of tables wider than the window what lies
/// further right, as NN-record-2.png and so on: every field is whole in some picture. Needs an
/// application object (desktop/bootstrap.hpp). @throws InputError for a deck or folder that cannot
/// be used.
std::vector<std::filesystem::path> render_pages(const std::filesystem::path& deck,
                                                const RenderOptions& options);

/// The same of a study file: its form, piece by piece, its text, and beside them what the check
/// says.
std::vector<std::filesystem::path> render_study(const std::filesystem::path& file,
                                                const RenderOptions& options);

}  // namespace adore::adrinput

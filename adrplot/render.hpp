#pragma once

#include "adrplot/plot_document.hpp"

#include <filesystem>
#include <functional>
#include <vector>

namespace adore::adrplot {

struct RenderOptions {
  std::filesystem::path folder;  ///< made when missing
  int page = 0;                  ///< 0 = every page
  results::SolRange range;
  int width = 1280, height = 800;
  std::function<void(long done, long total)> progress;  ///< called after each file; may be empty
  /// Called for each file without such a page, if others were drawn; may be empty.
  std::function<void(const std::string& sentence)> tell;
  bool dark = false;
  PageOptions view;
};

/// Parses the options for the domain ("history", "spectrum", "spectrogram"), the curve of
/// spectrograms, the scale of amplitudes ("units", "db", "relative") and the rows of spectrograms
/// ("time", "speed"). Empty: default. @throws InputError for an option of another domain
void set_domain(PageOptions& view, const std::string& domain, const std::string& curve,
                const std::string& scale = {}, const std::string& rows = {});

/// Draws the pages of result files, and of those of folders (`files_of`), as PNG, named
/// <file>-page-NN.png, and returns the names in order. Two files of the same name get their
/// folder's name in front. Needs an application object (desktop/bootstrap.hpp).
/// With a curve of spectrograms only pages that have it are drawn; a page that some files have is
/// drawn of those.
/// @throws InputError for files that are not ours, that curve on no page, a page that no file has,
/// and folders that cannot be written.
std::vector<std::filesystem::path> render_plots(const std::vector<std::filesystem::path>& paths,
                                                const RenderOptions& options);

/// The same for a file in memory; `stem` begins the pictures' names.
std::vector<std::filesystem::path> render_document(const PlotDocument& document,
                                                   const std::string& stem,
                                                   const RenderOptions& options);

}  // namespace adore::adrplot

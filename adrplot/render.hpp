#pragma once

#include "adrplot/plot_document.hpp"
#include "desktop/figure.hpp"

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
  std::string format = "png";  ///< or "svg", "pdf": lines and text, without the list of findings
  desktop::Figure figure;      ///< instead of pictures of width and height; never dark
  PageOptions view;
};

/// Parses the options for the domain (kDomainNames), the curve of spectrograms, the scale of
/// amplitudes ("units", "db", "relative"), the rows of spectrograms ("time", "speed"), the band of
/// envelopes in Hz ("2000:8000") and the part of orders (kOrderReferenceNames). Empty: default.
/// @throws InputError for an option of another domain, or an invalid band
void parse_domain_options(PageOptions& view, const std::string& domain, const std::string& curve,
                          const std::string& scale = {}, const std::string& rows = {},
                          const std::string& band = {}, const std::string& orders_of = {});

/// Draws all pages of result files. A folder stands for its result files (`plot_files_of`).
/// Pictures are named <file>-page-NN.png (or the format); files with equal names get the name of
/// their folder in front. Returns the names in order. Needs an application object
/// (desktop/bootstrap.hpp). For a curve of spectrograms, draws only the pages that have this curve,
/// and only from the files that have the page.
/// @throws InputError for files that are not ours, that curve on no page, a page that no file has,
/// and folders that cannot be written.
std::vector<std::filesystem::path> render_plots(const std::vector<std::filesystem::path>& paths,
                                                const RenderOptions& options);

/// The same for a file in memory; `stem` begins the pictures' names.
std::vector<std::filesystem::path> render_document(const PlotDocument& document,
                                                   const std::string& stem,
                                                   const RenderOptions& options);

}  // namespace adore::adrplot

#pragma once

#include "adrplot/page_builder.hpp"
#include "results/read_watch.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// One opened file of any type as numbered pages.
namespace adore::adrplot {

struct PlotDocument {
  struct Entry {
    std::string title;
    PageKind kind = PageKind::Chart;
    std::vector<std::string> panels = {};  ///< their titles; of result files only
    /// Names of the curves by panel; empty: this page has no curves over steps.
    std::vector<std::vector<std::string>> curves = {};
    std::string group = {};  ///< of pages in the tree of channels; empty: none
  };
  std::filesystem::path path;
  std::string subject;  ///< "rolling element 3", "quasi-static solution"
  std::string note;     ///< problem of the file; empty: none
  std::vector<Entry> pages;
  /// The chart of page 1 .. pages.size(). @throws InputError for another number
  std::function<desktop::ChartPage(int number, const PageOptions& options)> build;
  /// Rotation of the run; empty: unknown.
  std::function<RunMotion()> motion;
  /// For a study: a run in words, and the folder of its files (empty: not kept).
  std::function<std::string(long run)> about_run;
  std::function<std::filesystem::path(long run)> files_of_run;
};

/// The folder of a file in canonical form: it distinguishes runs.
[[nodiscard]] std::filesystem::path run_folder(const std::filesystem::path& file);

/// Numbers of a file that are held at a time [values]; of longer ones those of a few pages, and the
/// file is read again for others.
inline constexpr std::size_t kMostValues = 9'000'000;

/// RESULTS.h5 (h5_document.hpp), a table as CSV (csv_document.hpp), SOL1-SOL7 (with full precision
/// if RESULTS.h5 of the same run is in the folder), RUN.json of a quasi-static run, SWEEP.csv, or a
/// study (study_document.hpp). The type follows from the file name (.json, .csv), else from the
/// content. `watch` is called whenever steps are read, also later for other pages; a page whose
/// reading was stopped is read again when it is built again.
/// @throws InputError for other files; results::ReadStopped
[[nodiscard]] PlotDocument open_document(const std::filesystem::path& path,
                                         const results::SolRange& range = {},
                                         std::size_t most_values = kMostValues,
                                         const results::ReadWatch& watch = {});
[[nodiscard]] PlotDocument make_document(results::SolFile file);

/// Is the file read step by step, so that a range of steps can be selected?
[[nodiscard]] bool has_steps(const std::filesystem::path& path);

}  // namespace adore::adrplot

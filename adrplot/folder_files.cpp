#include "adrplot/folder_files.hpp"

#include "adrplot/study_document.hpp"
#include "base/errors.hpp"
#include "results/run_folder.hpp"

#include <fmt/format.h>

namespace adore::adrplot {

namespace fs = std::filesystem;

std::vector<fs::path> plot_files_of(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored) || is_study(path)) return {path};
  std::vector<fs::path> out = results::run_folder(path).plots;
  if (!out.empty()) return out;
  // A quasi-static run, a sweep or a study has no step files.
  for (const char* name : {"ACCURACY.json", "RUN.json", "SWEEP.csv", "RESULTS.h5"})
    if (fs::is_regular_file(path / name, ignored)) out.push_back(path / name);
  if (out.empty())
    throw InputError(
        fmt::format("{} contains no plot file (SOL1 to SOL7, RUN.json, SWEEP.csv or ACCURACY.json)",
                    path.string()));
  return out;
}

}  // namespace adore::adrplot

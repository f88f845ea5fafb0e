#include "runs/results_folder.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace adore::runs {
namespace fs = std::filesystem;

ResultsFolder::ResultsFolder(fs::path named, const fs::path& below) : path_(std::move(named)) {
  if (path_.empty()) path_ = ".";
  if (!path_.has_filename() && path_.has_relative_path()) path_ = path_.parent_path();  // "run/"
  try {
    created_folder_count_ = make_folders(path_);
    folder_.emplace(path_);
    if (below.empty()) return;
    std::error_code error;
    const fs::path all = path_ / below;
    for (fs::path at = all; at != path_ && !fs::exists(at, error); at = at.parent_path())
      ++created_folder_count_;
    folder_ = folder_->folder(below);
    path_ = all;
  } catch (const InputError& refused) {
    throw InputError(
        fmt::format("the output folder cannot be created: {}; choose another folder with --out",
                    refused.what()));
  }
}

ResultsFolder::~ResultsFolder() {
  folder_.reset();
  remove_empty_folders(path_, created_folder_count_);
}

}  // namespace adore::runs

#include "facade/results_folder.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace adore::facade {
namespace fs = std::filesystem;

ResultsFolder::ResultsFolder(fs::path folder) : path_(std::move(folder)) {
  if (path_.empty()) path_ = ".";
  if (!path_.has_filename() && path_.has_relative_path()) path_ = path_.parent_path();  // "run/"
  std::error_code error;
  for (fs::path at = path_; !at.empty() && !fs::exists(at, error); at = at.parent_path()) ++made_;
  fs::create_directories(path_, error);
  if (error || !fs::is_directory(path_))
    throw InputError(
        fmt::format("cannot make the output folder {}: {}; name another one with --out",
                    path_.string(), error ? error.message() : "a file of that name exists"));
}

ResultsFolder::~ResultsFolder() {
  std::error_code error;
  fs::path at = path_;
  for (int k = 0; k < made_; ++k, at = at.parent_path())
    if (!fs::remove(at, error)) return;  // not empty
}

}  // namespace adore::facade

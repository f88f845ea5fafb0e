#include "facade/passing_folder.hpp"

#include "base/write_error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace adore::facade {
namespace fs = std::filesystem;

PassingFolder::PassingFolder() {
  std::string pattern = (fs::temp_directory_path() / "adore-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr)
    throw WriteError("no folder for passing files can be made in " +
                     fs::temp_directory_path().string() + ": " + std::strerror(errno) +
                     "; name another place in the environment variable TMPDIR");
  path_ = pattern;
}

PassingFolder::~PassingFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

}  // namespace adore::facade

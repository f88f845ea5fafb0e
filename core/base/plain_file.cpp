#include "base/plain_file.hpp"

#include "base/errors.hpp"

namespace adore {

bool is_plain_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

void refuse_pipe(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::is_other(status))
    throw InputError(path.string() +
                     ": this is a pipe or a device, which may never end; give the name of a file");
}

}  // namespace adore

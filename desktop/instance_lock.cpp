#include "desktop/instance_lock.hpp"

#include "base/errors.hpp"
#include "base/write_folder.hpp"

#include <sys/file.h>
#include <unistd.h>

namespace adore::desktop {

std::optional<InstanceLock> InstanceLock::take(const std::filesystem::path& file) {
  int descriptor = -1;
  try {
    descriptor = WriteFolder(file.parent_path()).open_lock(file.filename().string());
  } catch (const InputError&) {
    return std::nullopt;  // no such folder
  }
  if (descriptor < 0) return std::nullopt;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return InstanceLock(descriptor);
  ::close(descriptor);
  return std::nullopt;
}

InstanceLock::~InstanceLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace adore::desktop

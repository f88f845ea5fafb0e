#include "adrinput/instance_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace adore::adrinput {

std::optional<InstanceLock> InstanceLock::take(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return std::nullopt;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return InstanceLock(descriptor);
  ::close(descriptor);
  return std::nullopt;
}

InstanceLock::~InstanceLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace adore::adrinput

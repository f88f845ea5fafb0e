#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace adore::desktop {

/// Held by a running program and let go by the system when it ends, however it ends.
class InstanceLock {
 public:
  /// Null if another program, or this one, holds it, or if the file cannot be created.
  [[nodiscard]] static std::optional<InstanceLock> take(const std::filesystem::path& file);
  InstanceLock(InstanceLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  InstanceLock& operator=(InstanceLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  InstanceLock(const InstanceLock&) = delete;
  InstanceLock& operator=(const InstanceLock&) = delete;
  ~InstanceLock();

 private:
  explicit InstanceLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace adore::desktop

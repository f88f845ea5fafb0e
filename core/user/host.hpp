#pragma once

#include "user/adore_user.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// The other end of adore_services: what routines read, print and write passes through one block of
/// memory, which a process of its own shares.
namespace adore::user {

/// Texts are cut at their room; `lost` says so.
template <std::size_t Room>
struct BoundedText {
  std::size_t size = 0;
  bool lost = false;
  std::array<char, Room> text{};
  void add(const char* more) noexcept;
  [[nodiscard]] std::string take();
};

struct HostSharedMemory {
  std::size_t line = 0;  ///< the next of the lines
  int mode = 0;
  BoundedText<std::size_t{1} << 16> print;
  BoundedText<std::size_t{1} << 20> write;
  BoundedText<512> fail;
};

/// Lives as long as the calls. Its address is call.host.
class Host {
 public:
  explicit Host(std::vector<std::string> lines);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  HostSharedMemory& block() noexcept { return *block_; }
  [[nodiscard]] const std::vector<std::string>& lines() const noexcept { return lines_; }
  [[nodiscard]] static const adore_services* services() noexcept;

 private:
  std::vector<std::string> lines_;
  HostSharedMemory* block_;  ///< shared memory
};

/// Numbers of a line as a list-directed read takes them: separated by blanks or commas, repeat
/// counts 3*0.5, d exponents; ends at a slash or at what is no number.
[[nodiscard]] std::vector<double> parse_list_directed(const std::string& line);

}  // namespace adore::user

#include "desktop/command_line.hpp"

#include "base/errors.hpp"
#include "base/terminal_text.hpp"

#include <fmt/core.h>

#include <charconv>

namespace adore::desktop {

PictureSize parse_size(const std::string& text) {
  constexpr int kSmallest = 160, kLargest = 8192;
  PictureSize size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool separated =
      width.ec == std::errc() && width.ptr != end && (*width.ptr == 'x' || *width.ptr == 'X');
  const auto height = separated ? std::from_chars(width.ptr + 1, end, size.height) : width;
  const auto fits = [](int pixels) { return pixels >= kSmallest && pixels <= kLargest; };
  if (!separated || height.ec != std::errc() || height.ptr != end || !fits(size.width) ||
      !fits(size.height))
    throw InputError(
        fmt::format("--size {} is not a picture size; write WIDTHxHEIGHT in pixels, each from {} "
                    "to {}, e.g. 1280x800",
                    text, kSmallest, kLargest));
  return size;
}

int run_guarded(const std::string& program, const std::function<int()>& body) {
  try {
    return body();
  } catch (const InputError& error) {
    print(stderr, "{}: {}\n", program, error.what());
    return 2;
  } catch (const SolverError& error) {
    print(stderr, "{}: {}\n", program, error.what());
    return 3;
  } catch (const std::exception& error) {
    print(stderr, "{}: internal error, please report it: {}\n", program, error.what());
    return 1;
  }
}

}  // namespace adore::desktop

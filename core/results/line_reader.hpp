#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

/// Lines of a text stream with their place in the file; "\n" and "\r\n" both end a line. Never
/// holds more than one line, and gives up on a line that no result file can have, so that a binary
/// file costs nothing.
namespace adore::results {

class LineReader {
 public:
  explicit LineReader(std::istream& stream)
      : stream_(stream), buffer_(std::size_t{1} << 16, '\0') {}

  /// Next line without its end; false at the end of the stream or after a line longer than 64 KiB
  /// (see is_line_too_long()).
  bool next(std::string_view& line) {
    line_.clear();
    has_line_end_ = false;
    for (;;) {
      if (at_ == filled_bytes_ && !refill()) break;
      const std::string_view rest(buffer_.data() + at_, filled_bytes_ - at_);
      const std::size_t end = rest.find('\n');
      const std::size_t taken = end == std::string_view::npos ? rest.size() : end;
      line_.append(rest.substr(0, taken));
      has_line_end_ = end != std::string_view::npos;
      at_ += taken + (has_line_end_ ? 1 : 0);
      offset_ += taken + (has_line_end_ ? 1 : 0);
      if (line_.size() > kLongest) {
        too_long_ = true;
        return false;
      }
      if (has_line_end_) break;
    }
    if (line_.empty() && !has_line_end_) return false;
    ++number_;
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    line = line_;
    return true;
  }
  [[nodiscard]] bool has_line_end() const noexcept {
    return has_line_end_;
  }  ///< did the last line have an end?
  [[nodiscard]] bool is_line_too_long() const noexcept { return too_long_; }
  [[nodiscard]] long number() const noexcept { return number_; }  ///< of the last line, from 1
  [[nodiscard]] std::uintmax_t offset() const noexcept {
    return offset_;
  }  ///< first byte after the last line

 private:
  static constexpr std::size_t kLongest = std::size_t{1} << 16;
  bool refill() {
    stream_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    filled_bytes_ = static_cast<std::size_t>(stream_.gcount());
    at_ = 0;
    return filled_bytes_ > 0;
  }
  std::istream& stream_;
  std::string buffer_, line_;
  std::size_t at_ = 0, filled_bytes_ = 0;
  std::uintmax_t offset_ = 0;
  long number_ = 0;
  bool has_line_end_ = false, too_long_ = false;
};

}  // namespace adore::results

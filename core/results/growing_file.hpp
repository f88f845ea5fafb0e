#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

/// A file that grows piece by piece and never holds a part of one: what is appended is handed to
/// the system at once, and a piece that could not be written whole is cut off again.
namespace adore::results {

class GrowingFile {
 public:
  /// Starts an empty file, replacing what was there. @throws InputError saying why and what to do.
  static GrowingFile create(const std::filesystem::path& path);
  /// Continues a file after its first `bytes` bytes; the rest is cut off.
  /// @throws InputError when the file is missing, shorter than that, or cannot be written.
  static GrowingFile append_after(const std::filesystem::path& path, std::uintmax_t bytes);

  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&& other) noexcept;
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Appends one piece. @throws InputError (disk full ...); the file then ends with the piece
  /// before.
  void append(std::string_view piece);
  [[nodiscard]] std::uintmax_t bytes() const noexcept { return bytes_; }
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  GrowingFile(std::filesystem::path path, int descriptor, std::uintmax_t bytes);
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uintmax_t bytes_ = 0;
};

/// The whole of a small text file. @throws InputError when it cannot be read or is larger than
/// `limit` bytes.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path,
                                         std::uintmax_t limit = 1U << 28);

}  // namespace adore::results

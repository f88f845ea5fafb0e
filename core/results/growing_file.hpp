#pragma once

#include "base/checksum.hpp"
#include "base/write_folder.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

/// A file that grows piece by piece and never holds a part of one: what is appended is handed to
/// the system at once, or many pieces together when they are collected, and pieces that could not
/// be written whole are cut off again.
namespace adore::results {

class GrowingFile {
 public:
  /// Starts an empty file, replacing what was there. @throws InputError saying why and what to do.
  static GrowingFile create(const WritePath& place);
  /// Continues a file after its first `bytes` bytes; the rest is cut off.
  /// @throws InputError when the file is missing, shorter than that, or cannot be written.
  static GrowingFile open_for_append(const WritePath& place, std::uintmax_t bytes);

  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&& other) noexcept;
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Appends one piece. @throws InputError (disk full ...); the file then ends with the piece
  /// before.
  void append(std::string_view piece);
  /// From now on pieces wait in memory until flush(), or until there are 64 kB of them. What waits
  /// at the end of this object is written without a word of errors: call flush() before.
  void collect() noexcept { is_buffering_ = true; }
  /// Hands the pieces that wait to the system. @throws as append()
  void flush();
  /// Of the pieces that the system has.
  [[nodiscard]] std::uintmax_t bytes() const noexcept { return bytes_; }
  /// Checksum of these pieces.
  [[nodiscard]] std::uint64_t sum() const noexcept { return sum_; }
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  GrowingFile(std::filesystem::path path, int descriptor, std::uintmax_t bytes);
  void write(std::string_view pieces);
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uintmax_t bytes_ = 0;
  std::uint64_t sum_ = checksum({});
  bool is_buffering_ = false;
  std::string pending_text_;
};

}  // namespace adore::results

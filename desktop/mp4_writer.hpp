#pragma once

#include "base/write_folder.hpp"

#include <QProcess>
#include <QSize>

#include <filesystem>

class QImage;

namespace adore::desktop {

/// Is there a program ffmpeg in the PATH?
[[nodiscard]] bool has_ffmpeg();

/// An MP4 film (H.264) by the program ffmpeg, which gets the pictures through a pipe. The file
/// appears under its name only when finish() succeeds.
class Mp4Writer {
 public:
  /// @throws InputError when ffmpeg is not there or does not start
  Mp4Writer(const std::filesystem::path& path, QSize size, int frames_per_second);
  ~Mp4Writer();
  /// @throws InputError with the last message of ffmpeg
  void add(const QImage& image);
  void finish();

 private:
  [[noreturn]] void fail();
  std::filesystem::path path_;
  PendingFile file_;  ///< ffmpeg writes into it by its number
  QSize size_;
  QProcess process_;
};

}  // namespace adore::desktop

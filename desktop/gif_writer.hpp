#pragma once

#include "base/write_folder.hpp"

#include <QByteArray>
#include <QSize>

#include <filesystem>

class QImage;

namespace adore::desktop {

/// An animated GIF (89a) that repeats for ever: 256 colors for each picture, LZW. The file appears
/// under its name only when finish() succeeds. Pauses are whole hundredths of a second: 50 pictures
/// a second at most.
class GifWriter {
 public:
  /// @throws InputError when the file cannot be written
  GifWriter(const std::filesystem::path& path, QSize size, int frames_per_second);
  /// The picture is scaled when its size differs. @throws InputError when the disk is full
  void add(const QImage& image);
  void finish();

 private:
  void write(const QByteArray& bytes);

  std::filesystem::path path_;
  PendingFile file_;
  QSize size_;
  int pause_;  ///< [1/100 s]
  int frames_ = 0;
};

}  // namespace adore::desktop

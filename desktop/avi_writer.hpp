#pragma once

#include "base/write_folder.hpp"

#include <QByteArray>
#include <QSize>

#include <filesystem>
#include <vector>

class QImage;

namespace adore::desktop {

/// A film as Motion-JPEG in an AVI container (RIFF, one video stream, old-style index), which the
/// usual players open. The file appears under its name only when finish() succeeds. Limit: 2 GB,
/// the size that such an index reaches.
class AviWriter {
 public:
  /// @throws InputError when the file cannot be written.
  AviWriter(const std::filesystem::path& path, QSize size, int frames_per_second);
  /// The picture is scaled when its size differs. @throws InputError when the disk is full or the
  /// film too long.
  void add(const QImage& image);
  void finish();
  [[nodiscard]] int frames() const { return static_cast<int>(index_.size()); }

 private:
  struct Entry {
    quint32 offset, size;
  };
  void write(const QByteArray& bytes);
  [[nodiscard]] QByteArray header() const;

  std::filesystem::path path_;
  PendingFile file_;
  QSize size_;
  int rate_;
  std::vector<Entry> index_;
  quint32 largest_ = 0;
  qint64 movie_bytes_ = 4;  ///< content of the list "movi", its name included
};

}  // namespace adore::desktop

#include "desktop/avi_writer.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"
#include "desktop/image_export.hpp"

#include <QBuffer>
#include <QImage>
#include <QImageWriter>
#include <QtEndian>

namespace adore::desktop {
namespace {

QByteArray number(quint32 value) {
  QByteArray bytes(4, '\0');
  qToLittleEndian(value, bytes.data());
  return bytes;
}

QByteArray half(quint16 value) {
  QByteArray bytes(2, '\0');
  qToLittleEndian(value, bytes.data());
  return bytes;
}

QByteArray chunk(const char* name, const QByteArray& content) {
  return name + number(static_cast<quint32>(content.size())) + content;
}

QByteArray list(const char* name, const QByteArray& content) {
  return chunk("LIST", name + content);
}

constexpr qint64 kLargestFile = 2'000'000'000;

}  // namespace

AviWriter::AviWriter(const std::filesystem::path& path, QSize size, int frames_per_second)
    : path_(path), file_(path), size_(size), rate_(frames_per_second) {
  demand(size.width() > 0 && size.height() > 0 && rate_ > 0,
         "a movie needs a size and a frame rate");
  check_replaceable(path_);
  write(header());
}

QByteArray AviWriter::header() const {
  const auto frame_count = static_cast<quint32>(index_.size());
  const auto width = static_cast<quint32>(size_.width()),
             height = static_cast<quint32>(size_.height());
  constexpr quint32 kHasIndex = 0x10;
  const QByteArray main = number(1'000'000U / static_cast<quint32>(rate_)) +
                          number(largest_ * static_cast<quint32>(rate_)) + number(0) +
                          number(kHasIndex) + number(frame_count) + number(0) + number(1) +
                          number(largest_) + number(width) + number(height) + QByteArray(16, '\0');
  const QByteArray stream = QByteArray("vidsMJPG") + number(0) + half(0) + half(0) + number(0) +
                            number(1) + number(static_cast<quint32>(rate_)) + number(0) +
                            number(frame_count) + number(largest_) + number(0xffffffffU) +
                            number(0) + half(0) + half(0) + half(static_cast<quint16>(width)) +
                            half(static_cast<quint16>(height));
  const QByteArray format = number(40) + number(width) + number(height) + half(1) + half(24) +
                            "MJPG" + number(width * height * 3) + QByteArray(16, '\0');
  QByteArray software(kProgramVersion.data(), static_cast<qsizetype>(kProgramVersion.size()));
  software.append(software.size() % 2 == 0 ? 2 : 1, '\0');  // chunks start at even offsets
  const QByteArray lists =
      list("hdrl",
           chunk("avih", main) + list("strl", chunk("strh", stream) + chunk("strf", format))) +
      list("INFO", chunk("ISFT", software));
  const qint64 index_bytes = frame_count == 0 ? 0 : 8 + 16 * static_cast<qint64>(frame_count);
  const qint64 riff = 4 + lists.size() + 8 + movie_bytes_ + index_bytes;
  return "RIFF" + number(static_cast<quint32>(riff)) + "AVI " + lists + "LIST" +
         number(static_cast<quint32>(movie_bytes_)) + "movi";
}

void AviWriter::write(const QByteArray& bytes) { file_.write(text_of(bytes)); }

void AviWriter::add(const QImage& image) {
  QByteArray jpeg;
  QBuffer buffer(&jpeg);
  buffer.open(QIODevice::WriteOnly);
  QImageWriter writer(&buffer, "jpeg");
  writer.setQuality(90);
  const QImage sized = image.size() == size_
                           ? image
                           : image.scaled(size_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  demand(writer.write(sized), "JPEG encoder failed");
  const auto size = static_cast<quint32>(jpeg.size());
  if (movie_bytes_ + size > kLargestFile)
    throw InputError("the movie " + path_.string() +
                     " would exceed 2 GB; use fewer frames (--every) or a smaller size (--size)");
  if (jpeg.size() % 2 != 0) jpeg.append('\0');  // chunks start at even offsets
  index_.push_back({static_cast<quint32>(movie_bytes_), size});
  largest_ = std::max(largest_, size);
  write("00dc" + number(size) + jpeg);
  movie_bytes_ += 8 + jpeg.size();
}

void AviWriter::finish() {
  if (index_.empty())
    throw InputError("the movie " + path_.string() +
                     " would have no pictures; select at least one frame");
  constexpr quint32 kKeyFrame = 0x10;
  QByteArray entries;
  for (const auto& entry : index_)
    entries += "00dc" + number(kKeyFrame) + number(entry.offset) + number(entry.size);
  write(chunk("idx1", entries));
  file_.write_at(0, text_of(header()));
  file_.commit();
}

}  // namespace adore::desktop

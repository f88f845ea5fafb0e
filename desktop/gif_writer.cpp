#include "desktop/gif_writer.hpp"

#include "base/errors.hpp"
#include "desktop/image_export.hpp"

#include <QImage>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace adore::desktop {
namespace {

void append_word(QByteArray& out, int value) {
  out.append(static_cast<char>(value & 0xff));
  out.append(static_cast<char>((value >> 8) & 0xff));
}

/// Codes of growing width, least significant bit first, in blocks of at most 255 bytes.
class CodeBlocks {
 public:
  void add(unsigned code, int width) {
    bits_ |= static_cast<quint64>(code) << used_;
    used_ += width;
    while (used_ >= 8) {
      bytes_.append(static_cast<char>(bits_ & 0xff));
      bits_ >>= 8;
      used_ -= 8;
    }
  }
  [[nodiscard]] QByteArray blocks() {
    if (used_ > 0) bytes_.append(static_cast<char>(bits_ & 0xff));
    QByteArray out;
    constexpr qsizetype kMost = 255;
    for (qsizetype at = 0; at < bytes_.size(); at += kMost) {
      const QByteArray part = bytes_.mid(at, kMost);
      out.append(static_cast<char>(part.size()));
      out.append(part);
    }
    out.append('\0');
    return out;
  }

 private:
  QByteArray bytes_;
  quint64 bits_ = 0;
  int used_ = 0;
};

/// LZW of GIF for 8-bit indices: codes 256 (begin anew) and 257 (end).
QByteArray compressed(const QImage& image) {
  constexpr unsigned kClear = 256, kEnd = 257, kMostCodes = 4096;
  constexpr int kFirstWidth = 9;
  CodeBlocks out;
  std::unordered_map<unsigned, unsigned> codes;  // (prefix, index) -> code
  unsigned next = kEnd + 1;
  int width = kFirstWidth;
  out.add(kClear, width);
  bool any = false;
  unsigned prefix = 0;
  for (int y = 0; y < image.height(); ++y) {
    const uchar* line = image.constScanLine(y);
    for (int x = 0; x < image.width(); ++x) {
      const unsigned index = line[x];
      if (!any) {
        prefix = index;
        any = true;
        continue;
      }
      const unsigned key = (prefix << 8) | index;
      if (const auto found = codes.find(key); found != codes.end()) {
        prefix = found->second;
        continue;
      }
      out.add(prefix, width);
      if (next < kMostCodes) {
        if (next == (1U << width)) ++width;
        codes.emplace(key, next++);
      } else {
        out.add(kClear, width);
        codes.clear();
        next = kEnd + 1;
        width = kFirstWidth;
      }
      prefix = index;
    }
  }
  if (any) out.add(prefix, width);
  out.add(kEnd, width);
  return out.blocks();
}

}  // namespace

GifWriter::GifWriter(const std::filesystem::path& path, QSize size, int frames_per_second)
    : path_(path),
      file_(QString::fromStdString(path.string())),
      size_(size),
      pause_(std::max(2, static_cast<int>(std::lround(100.0 / std::max(1, frames_per_second))))) {
  if (!file_.open(QIODevice::WriteOnly))
    throw InputError("cannot write " + path.string() + ": " + file_.errorString().toStdString() +
                     "; choose a folder that exists and is yours");
  QByteArray head("GIF89a");
  append_word(head, size.width());
  append_word(head, size.height());
  head.append('\x70');  // no colours of its own, eight bits each
  head.append('\0').append('\0');
  head.append("\x21\xff\x0bNETSCAPE2.0\x03\x01", 16);
  append_word(head, 0);
  head.append('\0');
  head.append(
      "\x21\xfe\x06"
      "Adore ",
      9);
  head.append('\0');
  write(head);
}

void GifWriter::write(const QByteArray& bytes) {
  if (file_.write(bytes) != bytes.size())
    throw InputError("cannot write " + path_.string() + ": " + file_.errorString().toStdString());
}

void GifWriter::add(const QImage& picture) {
  const QImage scaled = picture.size() == size_ ? picture
                                                : picture.scaled(size_, Qt::IgnoreAspectRatio,
                                                                 Qt::SmoothTransformation);
  const QImage image = scaled.convertToFormat(QImage::Format_RGB32)
                           .convertToFormat(QImage::Format_Indexed8, Qt::ThresholdDither);
  QByteArray out("\x21\xf9\x04\x04", 4);
  append_word(out, pause_);
  out.append('\0').append('\0');
  out.append('\x2c');
  append_word(out, 0);
  append_word(out, 0);
  append_word(out, size_.width());
  append_word(out, size_.height());
  out.append('\x87');  // 256 colours of its own
  const QList<QRgb> colours = image.colorTable();
  for (qsizetype i = 0; i < 256; ++i) {
    const QRgb c = i < colours.size() ? colours[i] : qRgb(0, 0, 0);
    out.append(static_cast<char>(qRed(c)));
    out.append(static_cast<char>(qGreen(c)));
    out.append(static_cast<char>(qBlue(c)));
  }
  out.append('\x08');
  out.append(compressed(image));
  write(out);
  ++frames_;
}

void GifWriter::finish() {
  if (frames_ == 0) throw InputError("a film without pictures is not written: " + path_.string());
  write(QByteArray(1, '\x3b'));
  if (!file_.commit())
    throw InputError("cannot write " + path_.string() + ": " + file_.errorString().toStdString());
}

}  // namespace adore::desktop

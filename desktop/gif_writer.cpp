#include "desktop/gif_writer.hpp"

#include "base/errors.hpp"
#include "desktop/image_export.hpp"

#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

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

/// LZW of GIF for 8-bit indices: codes 256 (reset) and 257 (end).
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

/// The 256 colors nearest to those of a picture: its colors in 32^3 cells, parted where they
/// spread most (median cut). A fixed palette paints gray metal teal, which is a color of scales.
class Palette {
 public:
  explicit Palette(const QImage& image) : cell_(kCells), index_(kCells, 0) {
    for (int y = 0; y < image.height(); ++y) {
      const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
      for (int x = 0; x < image.width(); ++x) {
        Cell& cell = cell_[cell_of(line[x])];
        ++cell.count;
        cell.sum[0] += qRed(line[x]), cell.sum[1] += qGreen(line[x]), cell.sum[2] += qBlue(line[x]);
      }
    }
    Box all;
    for (int i = 0; i < kCells; ++i)
      if (cell_[static_cast<std::size_t>(i)].count > 0) all.cells.push_back(i);
    std::vector<Box> boxes{measured(std::move(all))};
    while (boxes.size() < 256) {
      const auto widest =
          std::max_element(boxes.begin(), boxes.end(),
                           [](const Box& a, const Box& b) { return a.spread < b.spread; });
      if (!(widest->spread > 0.0)) break;
      boxes.push_back(parted(*widest));
    }
    for (const Box& box : boxes) {
      std::array<double, 3> sum{};
      double count = 0.0;
      for (const int i : box.cells) {
        const Cell& cell = cell_[static_cast<std::size_t>(i)];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += cell.sum[c];
        count += cell.count;
        index_[static_cast<std::size_t>(i)] = static_cast<uchar>(colours_.size());
      }
      colours_.push_back(qRgb(static_cast<int>(std::lround(sum[0] / count)),
                              static_cast<int>(std::lround(sum[1] / count)),
                              static_cast<int>(std::lround(sum[2] / count))));
    }
  }
  [[nodiscard]] QImage applied(const QImage& image) const {
    QImage out(image.size(), QImage::Format_Indexed8);
    out.setColorTable(colours_);
    for (int y = 0; y < image.height(); ++y) {
      const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
      uchar* to = out.scanLine(y);
      for (int x = 0; x < image.width(); ++x) to[x] = index_[cell_of(line[x])];
    }
    return out;
  }

 private:
  static constexpr int kCells = 32 * 32 * 32;
  struct Cell {
    double count = 0.0;
    std::array<double, 3> sum{};
  };
  struct Box {
    std::vector<int> cells;
    double spread = 0.0;
    int axis = 0;
  };
  static std::size_t cell_of(QRgb c) {
    return static_cast<std::size_t>((qRed(c) >> 3) << 10 | (qGreen(c) >> 3) << 5 | qBlue(c) >> 3);
  }
  static int along(int cell, int axis) { return (cell >> (10 - 5 * axis)) & 31; }

  /// With its longest axis; the spread is that of its cells, many pixels count a little more.
  [[nodiscard]] Box measured(Box box) const {
    box.spread = 0.0;
    double count = 0.0;
    for (const int i : box.cells) count += cell_[static_cast<std::size_t>(i)].count;
    for (int axis = 0; axis < 3; ++axis) {
      int low = 31, high = 0;
      for (const int i : box.cells) {
        low = std::min(low, along(i, axis));
        high = std::max(high, along(i, axis));
      }
      const double spread = (high - low) * std::pow(count, 0.25);
      if (spread > box.spread) box.spread = spread, box.axis = axis;
    }
    return box;
  }
  /// The upper half of a box, which keeps the lower one.
  Box parted(Box& box) const {
    const int axis = box.axis;
    std::stable_sort(box.cells.begin(), box.cells.end(),
                     [axis](int a, int b) { return along(a, axis) < along(b, axis); });
    const int first = along(box.cells.front(), axis), last = along(box.cells.back(), axis);
    const auto half = std::find_if(box.cells.begin(), box.cells.end(),
                                   [&](int i) { return 2 * along(i, axis) > first + last; });
    Box upper;
    upper.cells.assign(half, box.cells.end());
    box.cells.erase(half, box.cells.end());
    box = measured(std::move(box));
    return measured(std::move(upper));
  }

  std::vector<Cell> cell_;
  std::vector<uchar> index_;
  QList<QRgb> colours_;
};

}  // namespace

GifWriter::GifWriter(const std::filesystem::path& path, QSize size, int frames_per_second)
    : path_(path),
      file_(path),
      size_(size),
      pause_(std::max(2, static_cast<int>(std::lround(100.0 / std::max(1, frames_per_second))))) {
  QByteArray head("GIF89a");
  append_word(head, size.width());
  append_word(head, size.height());
  head.append('\x70');  // no separate palette, eight bits each
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

void GifWriter::write(const QByteArray& bytes) { file_.write(text_of(bytes)); }

void GifWriter::add(const QImage& picture) {
  const QImage scaled = picture.size() == size_ ? picture
                                                : picture.scaled(size_, Qt::IgnoreAspectRatio,
                                                                 Qt::SmoothTransformation);
  const QImage whole = scaled.convertToFormat(QImage::Format_RGB32);
  const QImage image = Palette(whole).applied(whole);
  QByteArray out("\x21\xf9\x04\x04", 4);
  append_word(out, pause_);
  out.append('\0').append('\0');
  out.append('\x2c');
  append_word(out, 0);
  append_word(out, 0);
  append_word(out, size_.width());
  append_word(out, size_.height());
  out.append('\x87');  // separate palette of 256 colors
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
  if (frames_ == 0) throw InputError("a movie without pictures was not written: " + path_.string());
  write(QByteArray(1, '\x3b'));
  file_.commit();
}

}  // namespace adore::desktop

#include "desktop/few_colours.hpp"

#include <QList>

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>
#include <vector>

namespace adore::desktop {
namespace {

constexpr int kBits = 5;  // of each channel: 32,768 boxes of like colors

int box_of(QRgb c) {
  constexpr int kShift = 8 - kBits;
  return (qRed(c) >> kShift) << (2 * kBits) | (qGreen(c) >> kShift) << kBits | (qBlue(c) >> kShift);
}

struct Box {
  long count = 0, red = 0, green = 0, blue = 0;
  [[nodiscard]] QRgb mean() const {
    return qRgb(static_cast<int>(red / count), static_cast<int>(green / count),
                static_cast<int>(blue / count));
  }
};

int apart(QRgb a, QRgb b) {
  const int r = qRed(a) - qRed(b), g = qGreen(a) - qGreen(b), d = qBlue(a) - qBlue(b);
  return r * r + g * g + d * d;
}

}  // namespace

namespace {

/// Colors of a picture, each the commonest of its box, chosen where most pixels are furthest from
/// those chosen before.
QList<QRgb> commonest_colours(const QImage& image, std::size_t most) {
  std::unordered_map<QRgb, long> counts;
  for (int y = 0; y < image.height(); ++y) {
    const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    for (int x = 0; x < image.width(); ++x) ++counts[line[x]];
  }
  struct Common {
    QRgb colour = 0;
    long times = 0, all = 0;
    double away = 1e9;
  };
  std::vector<Common> boxes(std::size_t{1} << (3 * kBits));
  for (const auto& [colour, times] : counts) {
    Common& box = boxes[static_cast<std::size_t>(box_of(colour))];
    box.all += times;
    if (times > box.times || (times == box.times && colour < box.colour))
      box.colour = colour, box.times = times;
  }
  std::erase_if(boxes, [](const Common& box) { return box.all == 0; });
  QList<QRgb> out;
  while (static_cast<std::size_t>(out.size()) < std::min(most, boxes.size())) {
    const auto next =
        std::max_element(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) {
          return a.away * static_cast<double>(a.all) < b.away * static_cast<double>(b.all);
        });
    const QRgb chosen = next->colour;
    out.append(chosen);
    for (Common& box : boxes)
      box.away = std::min(box.away, static_cast<double>(apart(box.colour, chosen)));
  }
  return out;
}

/// The nearest color of a table, looked for once for colors that differ by less than is seen.
class Nearest {
 public:
  explicit Nearest(const QList<QRgb>& table)
      : table_(table), known_(std::size_t{1} << (3 * kFine), -1) {}
  [[nodiscard]] int of(int red, int green, int blue) {
    constexpr int kShift = 8 - kFine;
    const auto cell = static_cast<std::size_t>((red >> kShift) << (2 * kFine) |
                                               (green >> kShift) << kFine | (blue >> kShift));
    if (known_[cell] >= 0) return known_[cell];
    int best = std::numeric_limits<int>::max(), at = 0;
    for (int i = 0; i < static_cast<int>(table_.size()); ++i)
      if (const int far = apart(table_[i], qRgb(red, green, blue)); far < best) best = far, at = i;
    known_[cell] = static_cast<short>(at);
    return at;
  }

 private:
  static constexpr int kFine = 6;  // bits of each channel
  const QList<QRgb>& table_;
  std::vector<short> known_;
};

}  // namespace

QImage reduce_colors(const QImage& picture, std::size_t most) {
  const QImage image = picture.convertToFormat(QImage::Format_RGB32);
  std::vector<Box> boxes(std::size_t{1} << (3 * kBits));
  for (int y = 0; y < image.height(); ++y) {
    const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    for (int x = 0; x < image.width(); ++x) {
      Box& box = boxes[static_cast<std::size_t>(box_of(line[x]))];
      ++box.count, box.red += qRed(line[x]), box.green += qGreen(line[x]),
          box.blue += qBlue(line[x]);
    }
  }
  // Color after color where most pixels are furthest from those chosen before.
  struct Used {
    std::size_t box;
    QRgb mean;
    double away;
    uchar index;
  };
  std::vector<Used> used;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].count > 0) used.push_back({i, boxes[i].mean(), 1e9, 0});
  QList<QRgb> table;
  while (static_cast<std::size_t>(table.size()) < std::min(most, used.size())) {
    const auto next = std::max_element(used.begin(), used.end(), [&](const Used& a, const Used& b) {
      return a.away * static_cast<double>(boxes[a.box].count) <
             b.away * static_cast<double>(boxes[b.box].count);
    });
    if (!(next->away > 0.0)) break;
    const QRgb chosen = next->mean;
    for (Used& other : used) {
      const double away = apart(other.mean, chosen);
      if (away >= other.away) continue;
      other.away = away;
      other.index = static_cast<uchar>(table.size());
    }
    table.append(chosen);
  }
  std::vector<uchar> index(boxes.size(), 0);
  for (const Used& each : used) index[each.box] = each.index;
  QImage out(image.size(), QImage::Format_Indexed8);
  out.setColorTable(table);
  for (int y = 0; y < image.height(); ++y) {
    const auto* from = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    uchar* line = out.scanLine(y);
    for (int x = 0; x < image.width(); ++x)
      line[x] = index[static_cast<std::size_t>(box_of(from[x]))];
  }
  return out;
}

QImage dither_colors(const QImage& picture) {
  constexpr std::size_t kColours = 256;
  const QImage image = picture.convertToFormat(QImage::Format_RGB32);
  const QList<QRgb> table = commonest_colours(image, kColours);
  std::unordered_map<QRgb, int> own;
  for (int i = 0; i < static_cast<int>(table.size()); ++i) own[table[i]] = i;
  Nearest nearest(table);
  QImage out(image.size(), QImage::Format_Indexed8);
  out.setColorTable(table);
  // The color error of a pixel is distributed to those to its right and below it, in sixteenths.
  using Error = std::array<int, 3>;
  const auto width = static_cast<std::size_t>(image.width());
  std::vector<Error> here(width + 2), below(width + 2);
  for (int y = 0; y < image.height(); ++y) {
    const auto* from = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    uchar* line = out.scanLine(y);
    std::fill(below.begin(), below.end(), Error{});
    for (std::size_t x = 0; x < width; ++x) {
      if (const auto exact = own.find(from[x]); exact != own.end()) {
        line[x] = static_cast<uchar>(exact->second);
        continue;
      }
      const std::array<int, 3> meant{qRed(from[x]), qGreen(from[x]), qBlue(from[x])};
      Error wanted{};
      for (std::size_t c = 0; c < 3; ++c)
        wanted[c] = std::clamp(meant[c] + here[x + 1][c] / 16, 0, 255);
      const int chosen = nearest.of(wanted[0], wanted[1], wanted[2]);
      line[x] = static_cast<uchar>(chosen);
      const QRgb is = table[chosen];
      const std::array<int, 3> got{qRed(is), qGreen(is), qBlue(is)};
      for (std::size_t c = 0; c < 3; ++c) {
        const int off = wanted[c] - got[c];
        here[x + 2][c] += 7 * off;
        below[x][c] += 3 * off;
        below[x + 1][c] += 5 * off;
        below[x + 2][c] += off;
      }
    }
    std::swap(here, below);
  }
  return out;
}

}  // namespace adore::desktop

#include "agore/example_run.hpp"
#include "agore/kept.hpp"
#include "agore/made_run.hpp"
#include "agore/motion_picture.hpp"
#include "agore/picture_words.hpp"
#include "agore/short_run.hpp"
#include "agore/view_scene.hpp"
#include "desktop/svg_writer.hpp"
#include "support/qt_app.hpp"

#include <QImage>
#include <QPainter>
#include <QPolygonF>
#include <QRegularExpression>
#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

/// Keys against pictures: what one names the other shows, and in one color everywhere.
using namespace adore;
using namespace adore::agore;

namespace {

constexpr std::array<View, 9> kViews{View::Bearing, View::Cage,      View::Pocket,
                                     View::Element, View::OuterRace, View::InnerRace,
                                     View::Flange,  View::Section,   View::Solid};

/// A picture alone, in a small window, and what its key says.
struct Shown {
  QImage image;  ///< without the marks of the key
  std::vector<PictureLegendEntry> key;
  QString words;
  double key_top = 0.0;  ///< of its first entry
  QByteArray svg;
  std::vector<QRectF> key_marks;  ///< where the marks of the key are
};

Shown show(const Animation& animation, std::size_t frame, const ViewOptions& options) {
  const QSizeF size = MotionPicture::pictureAreas({0, 0, 700, 450}, 1).front().size();
  const QRectF area(QPointF(0, 0), QSizeF(size.toSize()));
  const QColor paper = theme_of(options).surface;
  Shown out;
  ViewCache kept;
  const auto paint = [&](QPainter& painter, ViewCache& of) {
    paint_picture(painter, area, animation, frame, options, &of);
  };
  out.image = QImage(area.size().toSize(), QImage::Format_RGB32);
  out.image.fill(paper);
  QPainter painter(&out.image);
  paint(painter, kept);
  out.key = kept.key.entries();
  ViewCache again;
  const QByteArray svg = out.svg =
      desktop::render_svg(area.size().toSize(), [&](QPainter& p) { paint(p, again); });
  out.words = test::all_words(svg);
  out.key_top = area.height();
  for (const test::Words& words : test::words_of(svg))
    for (const PictureLegendEntry& entry : out.key) {
      if (words.text != entry.text && !entry.text.startsWith(words.text + " ")) continue;
      const QRectF mark(words.place.left() - 27.0, words.place.top() - 4.0, 27.0,
                        words.place.height() + 8.0);
      painter.fillRect(mark, paper);
      out.key_marks.push_back(mark);
      out.key_top = std::min(out.key_top, words.place.top());
    }
  return out;
}

/// Pixels that are nearly of a color.
int inked(const QImage& image, const QColor& colour, int within) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QRgb c = image.pixel(x, y);
      count += std::abs(qRed(c) - colour.red()) + std::abs(qGreen(c) - colour.green()) +
                   std::abs(qBlue(c) - colour.blue()) <=
               within;
    }
  return count;
}

/// Calls for all that can be seen: of five types, of balls without a cage and of SOL8 alone, in
/// every view, with and without all marks, light and dark, at the beginning, within and at the end.
void for_each_state(const std::function<void(const Animation&, std::size_t, const ViewOptions&,
                                             const std::string&)>& look) {
  std::vector<std::pair<std::string, Animation>> runs;
  for (const std::string& type : test::kTypes)
    runs.emplace_back(type, open_motion(test::example_run(type) / "RESULTS.h5"));
  runs.emplace_back("SOL8 alone", prepare(test::synthetic_sol8(test::short_run(40))));
  const testing::TemporaryFolder folder;
  {
    using namespace adore::testing;
    const bearing::Bearing bearing = make_bearing(8, false);
    results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
    results::H5Writer h5 =
        results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
    for (long step = 0; step <= 10; ++step) h5.write(recorder.record(make_snapshot(bearing, step)));
    h5.close();
  }
  runs.emplace_back("no cage", open_motion(folder / "RESULTS.h5"));
  for (const auto& [name, animation] : runs)
    for (const View view : kViews) {
      if (!why_not(view, animation).empty()) continue;
      for (const bool all : {false, true})
        for (const bool dark : {false, true})
          for (const std::size_t frame :
               {std::size_t{0}, animation.frames() / 2, animation.frames() - 1}) {
            ViewOptions options;
            options.view = view;
            options.dark = dark;
            options.contacts = options.trails = all;
            options.colour = all ? ColourBy::Load : ColourBy::None;
            options.element = 1 + static_cast<int>(frame) % animation.file.elements;
            choose_flange_race(animation, options);
            look(animation, frame, options,
                 name + ", " + view_title(view) + (all ? ", all marks" : "") +
                     (dark ? ", dark" : "") + ", frame " + std::to_string(frame + 1));
          }
    }
}

bool drawn(const PictureLegendEntry& entry) {
  return entry.colour.isValid() && entry.mark != LegendMark::None;
}

/// Subject of an entry in any view; empty: unknown, which is a fault of this list.
std::optional<std::string> quantity_of(const QString& text, View view) {
  const auto has = [&](const char* words) { return text.contains(words); };
  const std::string race = view == View::OuterRace ? "outer" : "inner";
  if (has("flange")) return "force of flanges";
  if (has("guide lands") || has("clearance circle")) return "guide lands";
  if (has("mass center now") || has("race center now") || has("origin now")) return "orbit";
  for (const char* const side : {"outer", "inner"}) {
    const QString name = QString("%1 race").arg(side);
    if (text.startsWith(name + " frame") || text == name + " mark")
      return std::string(side) + " race";
    if (text.startsWith(name + ":") || text.startsWith(name + " loads"))
      return std::string(side) + " loads";
  }
  if (has("race mark")) return race + " race";
  if (has("cage frame") || has("frame of segment") || has("cage rotation")) return "cage";
  if (has("pocket contact")) return "pocket contact";
  if (has("land contact")) return "land contact";
  if (has("path of the race") || has("orbit ") || has(" at each frame")) return "orbit";
  if (has("path") || has("earlier frames")) return "way of an element";
  for (const char* const same : {"later frames", "rotation mark", "no contact", "pitch circle",
                                 "long arm", "dashed: behind a body"})
    if (has(same)) return same;
  return std::nullopt;
}

}  // namespace

TEST_CASE("keys: what a key names is drawn, and every color of a mark is named",
          "[gui][keys][slow]") {
  test::use_qt();
  int named = 0;
  for_each_state([&](const Animation& animation, std::size_t frame, const ViewOptions& options,
                     const std::string& state) {
    const Shown shown = show(animation, frame, options);
    const desktop::Theme& t = theme_of(options);
    const bool solid = options.view == View::Solid;
    INFO(state);
    std::set<QRgb> key;
    for (const PictureLegendEntry& entry : shown.key) {
      if (!drawn(entry)) continue;
      key.insert(entry.colour.rgb());
      ++named;
      INFO(entry.text.toStdString());
      // In space bodies, and what is painted on them, have light and shade.
      if (solid && (entry.mark == LegendMark::Disc || entry.mark == LegendMark::Turning ||
                    entry.mark == LegendMark::Sector))
        continue;
      if (solid && entry.text == kGuideLands) continue;
      const bool thin = entry.mark == LegendMark::Dashed || entry.mark == LegendMark::Dotted;
      CHECK(inked(shown.image, entry.colour, thin ? 120 : 40) > 0);
    }
    // Steel has the gray of elements without contact: the run distinguishes them.
    const auto* const loads = animation.contacts_at(frame);
    const bool grey = (options.view == View::Bearing || solid) &&
                      options.colour != ColourBy::None && loads &&
                      std::any_of(loads->begin(), loads->end(), [](const ContactFrame& contact) {
                        return contact.load == std::array<double, 2>{};
                      });
    CHECK((key.count(no_contact_colour().rgb()) > 0) == grey);
    constexpr int kMark = 12;  // pixels
    for (const QColor& colour : {t.red, t.green, t.blue, t.light_blue, t.curves[0], t.curves[1],
                                 t.curves[2], t.curves[3], t.curves[4]}) {
      if (key.count(colour.rgb()) > 0) continue;
      if (colour == t.green && shown.words.contains("cage rotation")) continue;
      INFO(colour.name().toStdString() << " is in no key");
      CHECK(inked(shown.image, colour, 0) < kMark);
    }
  });
  CHECK(named > 1000);
}

namespace {

/// A mark that is drawn outside of the key: what it is, from its shape.
struct Drawn {
  enum class Shape { Round, Dashes, Star } shape;
  QString colour;
  QPointF at;
};

/// Points of an outline, and of how many curves it is.
std::pair<QPolygonF, int> outline_of(const QString& d) {
  static const QRegularExpression number("(-?[0-9.e-]+),(-?[0-9.e-]+)");
  QPolygonF out;
  auto found = number.globalMatch(d);
  while (found.hasNext()) {
    const auto match = found.next();
    out.append({match.captured(1).toDouble(), match.captured(2).toDouble()});
  }
  return {out, static_cast<int>(d.count('C'))};
}

std::vector<Drawn> marks_of(const Shown& shown) {
  static const QRegularExpression path("<path d=\"([^\"]*)\" ([^>]*)/>"),
      filled("fill=\"(#[0-9a-f]{6})\""), stroked("stroke=\"(#[0-9a-f]{6})\""),
      wide("stroke-width=\"([0-9.]+)\"");
  std::vector<Drawn> out;
  std::map<std::pair<QString, std::pair<int, int>>, int> crossing;  // lines through a middle
  auto found = path.globalMatch(QString::fromUtf8(shown.svg));
  while (found.hasNext()) {
    const auto match = found.next();
    const auto [points, curves] = outline_of(match.captured(1));
    const QRectF box = points.boundingRect();
    const QString look = match.captured(2), fill = filled.match(look).captured(1),
                  stroke = stroked.match(look).captured(1);
    if (std::any_of(shown.key_marks.begin(), shown.key_marks.end(),
                    [&](const QRectF& mark) { return mark.contains(box.center()); }))
      continue;
    constexpr double kLeast = 6.0, kMost = 16.0;  // pixels; smaller ones are frames on a path
    if (curves == 4 && box.width() > kLeast && box.width() < kMost &&
        std::abs(box.width() - box.height()) < 0.1)
      out.push_back({Drawn::Shape::Round, fill, box.center()});
    if (look.contains("stroke-dasharray"))
      out.push_back({Drawn::Shape::Dashes, stroke, box.center()});
    if (curves == 0 && points.size() == 2 && wide.match(look).captured(1).toDouble() > 2.5)
      if (++crossing[{stroke, {qRound(box.center().x()), qRound(box.center().y())}}] == 3)
        out.push_back({Drawn::Shape::Star, stroke, box.center()});
  }
  return out;
}

/// Which marks of a key name it.
bool names(const PictureLegendEntry& entry, const Drawn& mark) {
  // In space one entry explains all dashes.
  if (mark.shape == Drawn::Shape::Dashes && entry.text == "dashed: behind a body") return true;
  if (entry.colour.name() != mark.colour) return false;
  switch (mark.shape) {
    case Drawn::Shape::Round:
      return entry.mark == LegendMark::Spot || entry.mark == LegendMark::Dots;
    case Drawn::Shape::Dashes:
      return entry.mark == LegendMark::Dashed || entry.mark == LegendMark::Dotted ||
             entry.mark == LegendMark::Contact;
    case Drawn::Shape::Star:
      return entry.mark == LegendMark::Star;
  }
  return false;
}

}  // namespace

TEST_CASE("keys: every drawn dot, star and dashed line has an entry with its shape",
          "[gui][keys][slow]") {
  test::use_qt();
  std::map<Drawn::Shape, int> found;
  for_each_state([&](const Animation& animation, std::size_t frame, const ViewOptions& options,
                     const std::string& state) {
    const Shown shown = show(animation, frame, options);
    const desktop::Theme& t = theme_of(options);
    std::set<QString> inks{t.red.name(), t.green.name(), t.blue.name(), t.light_blue.name(),
                           t.muted.name()};
    for (std::size_t i = 0; i < 5; ++i) inks.insert(t.curves[i].name());
    for (const Drawn& mark : marks_of(shown)) {
      if (inks.count(mark.colour) == 0) continue;  // of bodies and of paper
      ++found[mark.shape];
      INFO(state << ": " << mark.colour.toStdString() << " at " << mark.at.x() << ", "
                 << mark.at.y() << ", shape " << static_cast<int>(mark.shape));
      CHECK(std::any_of(shown.key.begin(), shown.key.end(),
                        [&](const PictureLegendEntry& entry) { return names(entry, mark); }));
    }
  });
  for (const auto shape : {Drawn::Shape::Round, Drawn::Shape::Dashes, Drawn::Shape::Star})
    CHECK(found[shape] > 20);
}

TEST_CASE("keys: below four small pictures entries stand in columns, none left out",
          "[gui][keys][slow]") {
  test::use_qt();
  constexpr QSize kSize(700, 450);
  for (const std::string& type : test::kTypes) {
    MotionPicture picture(open_motion(test::example_run(type) / "RESULTS.h5"));
    for (const bool all : {false, true}) {
      ViewOptions options;
      options.beside = {{View::Solid}, {View::Section}, {View::Pocket}};
      options.contacts = all;
      options.colour = all ? ColourBy::Slip : ColourBy::None;
      const QRectF key = MotionPicture::sharedLegendArea(QRectF({0, 0}, kSize), 4);
      std::set<int> left;
      int entries = 0;
      const QByteArray svg = picture.svg(kSize, picture.frames() - 1, options);
      for (const test::Words& words : test::words_of(svg))
        if (key.contains(words.place.center())) left.insert(qRound(words.place.left())), ++entries;
      INFO(type << (all ? ", all marks: " : ": ") << entries << " entries");
      CHECK(entries > 8);
      CHECK(left.size() <= 3);
      CHECK_FALSE(svg.contains("see the single view"));
    }
  }
}

TEST_CASE("keys: one quantity has one color in all views", "[gui][keys][slow]") {
  test::use_qt();
  std::map<std::pair<std::string, bool>, std::set<QString>> colours;
  for_each_state([&](const Animation& animation, std::size_t frame, const ViewOptions& options,
                     const std::string& state) {
    for (const PictureLegendEntry& entry : show(animation, frame, options).key) {
      if (!drawn(entry)) continue;
      const auto quantity = quantity_of(entry.text, options.view);
      INFO(state << ": " << entry.text.toStdString());
      REQUIRE(quantity);
      // Has the color of the dashed object; in space a separate color, with light and shade.
      if (*quantity == "dashed: behind a body") continue;
      if (*quantity == "rotation mark" && options.view == View::Solid) continue;
      colours[{*quantity, options.dark}].insert(entry.colour.name());
    }
  });
  for (const auto& [quantity, names] : colours) {
    INFO(quantity.first << (quantity.second ? ", dark: " : ": ")
                        << QStringList(names.begin(), names.end()).join(" ").toStdString());
    CHECK(names.size() == 1);
  }
  CHECK(colours.size() > 24);
}

TEST_CASE("keys: small window → bearing has half of the picture height, for any key",
          "[gui][keys][slow]") {
  test::use_qt();
  for_each_state([&](const Animation& animation, std::size_t frame, const ViewOptions& options,
                     const std::string& state) {
    const bool round = options.view == View::Bearing || options.view == View::Solid ||
                       options.view == View::Element || options.view == View::OuterRace;
    if (!round || options.dark || frame == 0) return;
    const Shown shown = show(animation, frame, options);
    // From the highest to the lowest of its rows without text.
    const QRgb paper = theme_of(options).surface.rgb();
    int first = shown.image.height(), last = -1;
    for (int y = 0; y < static_cast<int>(shown.key_top) - 3; ++y) {
      int longest = 0, run = 0;
      for (int x = 60; x < 284; ++x) {  // outside the axes and the scale in the corners
        run = shown.image.pixel(x, y) != paper ? run + 1 : 0;
        longest = std::max(longest, run);
      }
      if (longest > 16) first = std::min(first, y), last = y;
    }
    INFO(state << ": rows " << first << " to " << last << " of " << shown.image.height());
    CHECK(2 * (last - first + 1) >= shown.image.height());
  });
}

TEST_CASE("views: four small pictures → numbers of the curves do not overlap",
          "[gui][agore][slow]") {
  test::use_qt();
  constexpr QSize kSize(700, 450);
  for (const std::string& type : test::kTypes) {
    MotionPicture picture(open_motion(test::example_run(type) / "RESULTS.h5"));
    for (const View view : kViews) {
      if (!why_not(view, picture.animation()).empty()) continue;
      ViewOptions options;
      options.view = view;
      options.beside = {{View::Solid}, {View::Section}, {View::Element}};
      choose_flange_race(picture.animation(), options);
      const QRectF data = MotionPicture::dataArea(QRectF({0, 0}, kSize), 4);
      std::vector<test::Words> words;
      for (const test::Words& one :
           test::words_of(picture.svg(kSize, picture.frames() - 1, options)))
        if (data.contains(one.place.center())) words.push_back(one);
      INFO(type << ", " << view_title(view));
      CHECK(words.size() > 6);
      for (std::size_t i = 0; i < words.size(); ++i)
        for (std::size_t k = i + 1; k < words.size(); ++k) {
          INFO(words[i].text.toStdString() << " and " << words[k].text.toStdString());
          CHECK_FALSE(words[i].place.intersects(words[k].place));
        }
    }
  }
}

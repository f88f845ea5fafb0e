#include "base/errors.hpp"
#include "desktop/avi_writer.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/command_line.hpp"
#include "desktop/disclaimer.hpp"
#include "desktop/image_export.hpp"
#include "desktop/log_chart.hpp"
#include "desktop/text_faults.hpp"
#include "desktop/window_place.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QChart>
#include <QFile>
#include <QFontInfo>
#include <QGraphicsItem>
#include <QGraphicsLineItem>
#include <QGraphicsTextItem>
#include <QImage>
#include <QImageReader>
#include <QLabel>
#include <QLineSeries>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QValueAxis>
#include <QWidget>
#include <QtEndian>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

using namespace adore;
using namespace adore::desktop;
namespace fs = std::filesystem;

namespace {

ChartPage wave_page(int points, int panels) {
  ChartPage page;
  page.title = "Waves";
  page.x_title = "Bearing rotation";
  page.x_unit = "rev";
  for (int i = 0; i < points; ++i) page.x.push_back(3.0 * i / (points - 1));
  for (int p = 0; p < panels; ++p) {
    ChartPanel panel{"Force", "N", {}, false};
    for (const char* name : {"outer", "inner"}) {
      ChartCurve curve{name, {}, {}};
      for (const double x : page.x) curve.y.push_back(100 * std::sin(6.28 * x) + 10 * p);
      panel.curves.push_back(std::move(curve));
    }
    page.panels.push_back(std::move(panel));
  }
  return page;
}

quint32 number_at(const QByteArray& bytes, qsizetype at) {
  return qFromLittleEndian<quint32>(bytes.constData() + at);
}

}  // namespace

TEST_CASE("axis_scale: ticks are 1, 2 or 5 times a power of ten and hold the data", "[unit]") {
  for (const double span : {1.0, 3.7, 0.021, 8.8e5, 4e-9}) {
    const AxisScale axis = value_axis(0.3 * span, 1.3 * span, "", 5);
    const double mantissa = axis.step / std::pow(10.0, std::floor(std::log10(axis.step) + 1e-9));
    CHECK((std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 ||
           std::abs(mantissa - 5) < 1e-9));
    CHECK(axis.min <= axis.shown(0.3 * span));
    CHECK(axis.max >= axis.shown(1.3 * span));
    CHECK((axis.max - axis.min) / axis.step <=
          7.5);  // five parts wanted, rounding outwards adds two at most
  }
}

TEST_CASE("axis_scale: units take SI prefixes, or powers of ten where they have none", "[unit]") {
  CHECK(value_axis(0, 3.2e-6, "m", 5).unit == "µm");
  CHECK(value_axis(0, 3.2e-6, "m", 5).factor == Approx(1e-6));
  CHECK(value_axis(0, 12500, "N", 5).unit == "kN");
  CHECK(value_axis(0, 420, "N", 5).unit == "N");
  CHECK(value_axis(-3e6, 2e6, "rpm/s", 5).unit == "10⁶ rpm/s");
  CHECK(value_axis(0, 8000, "rpm", 5).unit == "rpm");
  CHECK(value_axis(0, 4e-17, "m^3/s", 5).unit == "10⁻¹⁸ m³/s");
  CHECK(value_axis(0, 0.2, "N.m", 5).unit == "mN·m");
  CHECK(tight_axis(0, 0.018, "s", 5).unit == "ms");
}

TEST_CASE("axis_scale: a signal that hardly moves is shown from a base value", "[unit]") {
  const AxisScale axis = value_axis(0.0325 - 4e-7, 0.0325 + 4e-7, "m", 5);
  CHECK(axis.unit == "nm");
  CHECK(axis.offset == Approx(0.0325).epsilon(1e-9));
  CHECK(axis.offset_text == "32.5 mm");
  CHECK(axis.shown(0.0325 + 4e-7) == Approx(400.0).epsilon(1e-6));
}

TEST_CASE("axis_scale: constants, zeros and missing values still give a drawable axis", "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for (const auto& [low, high] : {std::pair{0.0, 0.0},
                                  {5.0, 5.0},
                                  {-2e-30, -2e-30},
                                  {nan, nan},
                                  {inf, -inf},
                                  {1e300, 1e300},
                                  {9e307, 9e307},
                                  {-1.7e308, 1.7e308},
                                  {5e-324, 5e-324}}) {
    const AxisScale axis = value_axis(low, high, "m", 5);
    CHECK(std::isfinite(axis.min));
    CHECK(std::isfinite(axis.max));
    CHECK(axis.max > axis.min);
    CHECK(axis.step > 0.0);
    CHECK((axis.max - axis.min) / axis.step < 20.0);
  }
}

TEST_CASE("axis_scale: numbers for people carry no negative zero and a true minus sign", "[unit]") {
  CHECK(tick_text(-0.4, 1) == "−0.4");
  CHECK(tick_text(-1e-17, 1) == "0.0");
  CHECK(pretty_number(1416.3, 3) == "1416");
  CHECK(pretty_number(0.43, 3) == "0.43");
  CHECK(pretty_number(-2.5e-9, 3) == "−2.5·10⁻⁹");
  CHECK(pretty_quantity(3.2e-6, "m", 3) == "3.2 µm");
  CHECK(pretty_quantity(8.3936e-3, "s", 5) == "8.3936 ms");
}

TEST_CASE("chart_page: lines break at missing values and where an angle starts again", "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> x{0, 1, 2, 3, 4, 5, 6};
  CHECK(drawable_pieces(x, {0, 1, nan, 3, 4, 5, 6}, 0, 6, 100, false).size() == 2);
  CHECK(drawable_pieces(x, {340, 350, 359, 5, 15, 25, 35}, 0, 6, 100, true).size() == 2);
  CHECK(drawable_pieces(x, {340, 350, 359, 5, 15, 25, 35}, 0, 6, 100, false).size() == 1);
  const auto zoomed = drawable_pieces(x, {0, 1, 2, 3, 4, 5, 6}, 2.5, 3.5, 100, false);
  REQUIRE(zoomed.size() == 1);
  CHECK(zoomed.front().x == std::vector<double>{2, 3, 4});  // one neighbour beyond each end
}

TEST_CASE("chart_page: thinning a long line keeps every peak", "[unit]") {
  std::vector<double> x, y;
  for (int i = 0; i < 200000; ++i) {
    x.push_back(i);
    y.push_back(std::sin(0.7 * i));
  }
  y[123457] = 50.0;
  y[61001] = -40.0;
  const auto pieces = drawable_pieces(x, y, 0, 199999, 800, false);
  REQUIRE(pieces.size() == 1);
  CHECK(pieces.front().x.size() <= 4 * 801);
  CHECK(*std::max_element(pieces.front().y.begin(), pieces.front().y.end()) == 50.0);
  CHECK(*std::min_element(pieces.front().y.begin(), pieces.front().y.end()) == -40.0);
  CHECK(std::is_sorted(pieces.front().x.begin(), pieces.front().x.end()));
}

TEST_CASE("chart_scene: panels stand over one abscissa with a series per curve", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({1280, 800});
  scene.setPage(wave_page(5000, 3));
  REQUIRE(scene.charts().size() == 3);
  REQUIRE(scene.plotAreas().size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(scene.linesOf(i) == 2);
    CHECK(scene.plotAreas()[i].left() == scene.plotAreas()[0].left());
    CHECK(scene.plotAreas()[i].width() == scene.plotAreas()[0].width());
    CHECK(scene.sceneRect().contains(scene.plotAreas()[i]));
    CHECK(scene.charts()[i]->axes(Qt::Vertical).front()->titleText() == "Force [N]");
  }
  CHECK(scene.charts()[2]->axes(Qt::Horizontal).front()->titleText() == "Bearing rotation [rev]");
  CHECK_FALSE(scene.plotAreas()[0].intersects(scene.plotAreas()[1]));
  // No text or curve reaches beyond the page: nothing is clipped.
  for (auto* item : scene.items())
    if (item->parentItem() == nullptr)
      CHECK(scene.sceneRect().contains(item->sceneBoundingRect().adjusted(1, 1, -1, -1)));
}

TEST_CASE("chart_scene: zooming follows the abscissa and keeps inside the data", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setPage(wave_page(1000, 1));
  CHECK(scene.viewHigh() == Approx(3.0));
  scene.setView(1.0, 2.0);
  CHECK(scene.viewLow() == 1.0);
  CHECK(scene.abscissaAt(scene.positionOf(1.25)) == Approx(1.25));
  auto* axis = qobject_cast<QValueAxis*>(scene.charts()[0]->axes(Qt::Horizontal).front());
  CHECK(axis->max() == Approx(2.0).epsilon(1e-5));
  scene.setView(-5.0, 99.0);
  CHECK(scene.viewLow() == 0.0);
  CHECK(scene.viewHigh() == Approx(3.0));
  const QPointF middle(scene.positionOf(0.75), scene.plotAreas()[0].center().y());
  CHECK(scene.readout(middle).contains("outer −"));
  CHECK(scene.readout({1, 1}).isEmpty());
}

TEST_CASE("chart_scene: a logarithmic axis says which curves it cannot show", "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x = {0.0, 1.0, 2.0};
  page.panels = {
      {"Spin/roll", "", {{"outer", {0.1, 0.2, 0.3}, {}}, {"inner", {-0.1, -0.2, -0.1}, {}}}},
      {"Angle", "deg", {{"outer", {-3.0, -2.0, -1.0}, {}}}}};
  ChartScene scene;
  const auto words = [&](bool log) {
    for (ChartPanel& panel : page.panels) panel.log = log;
    scene.setPage(page);
    QString text;
    for (auto* item : scene.items()) {
      if (auto* simple = dynamic_cast<QGraphicsSimpleTextItem*>(item)) text += simple->text() + "|";
      if (auto* rich = dynamic_cast<QGraphicsTextItem*>(item)) text += rich->toPlainText() + "|";
    }
    return text;
  };
  CHECK(words(true).contains("inner (not above 0)|"));
  CHECK_FALSE(words(true).contains("outer (not above 0)"));
  CHECK(words(true).count("No value is above 0") == 1);
  CHECK_FALSE(words(false).contains("above 0"));
}

TEST_CASE("chart_scene: titles of neighbouring panels do not run into each other", "[gui]") {
  test::use_qt();
  ChartPage page;
  page.title = "Applied forces";
  page.subtitle = "7208   ·   inner race   ·   SOL4   ·   page 2 of 9   ·   all digits";
  page.x_title = "Time", page.x_unit = "s";
  page.x = {0.0, 1.0, 2.0};
  ChartScene scene;
  for (const int count : {2, 3, 4})
    for (const int height : {300, 400, 450, 500, 600, 800}) {
      if (height < 100 * count) continue;
      page.panels.clear();
      for (int p = 0; p < count; ++p)
        page.panels.push_back(
            {std::string(1, static_cast<char>('X' + p)) + " component", "N", {{"", page.x, {}}}});
      scene.setPageSize(QSizeF(700, height));
      scene.setPage(page);
      std::vector<QRectF> titles;
      for (auto* item : scene.items())
        if (item->rotation() != 0.0 && dynamic_cast<QGraphicsSimpleTextItem*>(item) != nullptr)
          titles.push_back(item->sceneBoundingRect());
      INFO(count << " panels, " << height << " high");
      for (std::size_t a = 0; a < titles.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
          const bool beside = titles[a].right() <= titles[b].left() + 3.0 ||
                              titles[b].right() <= titles[a].left() + 3.0;
          CHECK((beside || !titles[a].adjusted(0, -8, 0, 8).intersects(titles[b])));
        }
      CHECK(text_faults(scene).empty());
    }
}

TEST_CASE("a line too long for its place is drawn closer before it is cut", "[gui][desktop]") {
  test::use_qt();
  const QFontMetricsF metrics(ui_font(13));
  const QString text = "a file   ·   page 2 of 9   ·   all digits";
  CHECK(fitted_line(text, metrics, 2000.0) == text);
  const qreal close = metrics.horizontalAdvance("a file · page 2 of 9 · all digits");
  CHECK(fitted_line(text, metrics, close + 1.0) == "a file · page 2 of 9 · all digits");
  const QString named = fitted_line("a long name of a file" + text.mid(6), metrics, close + 60.0);
  CHECK(named.startsWith("a long"));
  CHECK(named.contains(QString(QChar(0x2026)) + " · page 2 of 9 · all digits"));
  CHECK(metrics.horizontalAdvance(named) <= close + 60.0);
  CHECK(fitted_line(text, metrics, close - 30.0).endsWith(QChar(0x2026)));
}

TEST_CASE("chart_scene: every marked frequency has its name, however close the lines are",
          "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x_title = "Frequency", page.x_unit = "Hz";
  for (int i = 0; i <= 100; ++i) page.x.push_back(10.0 * i);
  page.panels = {{"Load", "N", {{"outer race", page.x, {}}, {"inner race", page.x, {}}}}};
  page.marks = {{67.0, "FTF"},  {70.0, "whirl"}, {167.0, "shaft"},
                {383.0, "BSF"}, {816.0, "BPFO"}, {990.0, "BPFI"}};
  ChartScene scene;
  for (const QSizeF size : {QSizeF(1280, 800), QSizeF(700, 450), QSizeF(300, 240)})
    for (const double last : {1000.0, 1000.0 / 3.0}) {
      scene.setPageSize(size);
      scene.setPage(page);
      scene.setView(0.0, last);
      QStringList words;
      for (auto* item : scene.items())
        if (auto* text = dynamic_cast<QGraphicsSimpleTextItem*>(item)) {
          words << text->text();
          CHECK(scene.sceneRect().contains(text->sceneBoundingRect()));
        }
      INFO(size.width() << ", " << last << ": " << words.join("|").toStdString());
      for (const ChartMark& mark : page.marks) {
        if (size.width() < 500) continue;  // there names are shortened, not laid over each other
        const QRegularExpression name("\\b" + QString::fromStdString(mark.label) + "\\b");
        CHECK(words.filter(name).isEmpty() == (mark.x > last));
      }
      CHECK(text_faults(scene).empty());
    }
}

TEST_CASE("chart_scene: a step leads from a name to its line where others take its place",
          "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x_title = "Frequency", page.x_unit = "Hz";
  for (int i = 0; i <= 100; ++i) page.x.push_back(300.0 * i);
  page.panels = {{"Amplitude", "N", {{"", page.x, {}}}}};
  page.marks = {{41.0, "FTF"}, {100.0, "shaft"}, {230.0, "BSF"}, {420.0, "BPFO"}, {610.0, "BPFI"}};
  ChartScene scene;
  for (const QSizeF size : {QSizeF(1280, 800), QSizeF(700, 450)}) {
    scene.setPageSize(size);
    scene.setPage(page);
    const QRectF area = scene.plotAreas().front();
    struct Step {
      double from, to, y;
    };
    std::vector<Step> steps;
    std::vector<double> feet;
    for (auto* item : scene.items())
      if (auto* line = dynamic_cast<QGraphicsLineItem*>(item)) {
        if (line->parentItem() != nullptr) continue;  // of the axes
        const QLineF l = line->line();
        if (l.y1() == l.y2() && l.y1() > area.top() && l.y1() < area.bottom())
          steps.push_back({l.x1(), l.x2(), l.y1()});
        if (l.x1() == l.x2() && l.y1() < area.top()) feet.push_back(l.x1());
      }
    REQUIRE(steps.size() >= 3);
    std::sort(steps.begin(), steps.end(), [](auto& a, auto& b) { return a.from < b.from; });
    std::size_t mark = 0;
    for (std::size_t i = 0; i < steps.size(); ++i, ++mark) {
      // From below its name to its line, in their order; each below the one before, so that none
      // crosses it.
      while (mark < page.marks.size() &&
             std::abs(steps[i].to - scene.positionOf(page.marks[mark].x)) > 0.01)
        ++mark;
      CHECK(mark < page.marks.size());
      CHECK(std::find(feet.begin(), feet.end(), steps[i].from) != feet.end());
      if (i > 0) CHECK(steps[i].y > steps[i - 1].y + 1.0);
    }
    CHECK(text_faults(scene).empty());
  }
}

TEST_CASE("chart_scene: curves that would hide another say so and leave it half of the way",
          "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x_title = "Time", page.x_unit = "s";
  std::vector<double> wave, near, other;
  for (int i = 0; i <= 400; ++i) {
    page.x.push_back(0.01 * i);
    wave.push_back(100.0 * std::sin(0.05 * i));
    near.push_back(wave.back() + 0.01 * std::cos(0.3 * i));  // less than a pixel
    other.push_back(wave.back() + (i > 200 && i < 220 ? 20.0 : 0.0));
  }
  const auto words = [](const ChartScene& scene) {
    QStringList out;
    for (auto* item : scene.items())
      if (auto* text = dynamic_cast<QGraphicsSimpleTextItem*>(item)) out << text->text();
    return out;
  };
  const auto inked = [](const ChartScene& scene, const QImage& image, int curve) {
    const QRect area = scene.plotAreas().front().toRect();
    int out = 0;
    for (int y = area.top(); y < area.bottom(); ++y)
      for (int x = area.left(); x < area.right(); ++x) {
        const QColor seen = image.pixelColor(x, y), wanted = theme(ThemeKind::Light).curves[curve];
        out += std::abs(seen.red() - wanted.red()) + std::abs(seen.green() - wanted.green()) +
                   std::abs(seen.blue() - wanted.blue()) <
               30;
      }
    return out;
  };
  ChartScene scene;
  scene.setTheme(theme(ThemeKind::Light));
  const auto look = [&](const std::vector<double>& second) {
    page.panels = {{"Force", "N", {{"land 1", wave, {}}, {"land 2", second, {}}}}};
    scene.setPage(page);
    return scene.image({1280, 800});
  };
  const QImage alone = look(other);
  CHECK(words(scene).contains("land 2"));
  const QImage both = look(wave);
  CHECK(words(scene).contains("land 2 (= land 1)"));
  CHECK(scene.linesOf(0) == 2);
  const int first = inked(scene, both, 0), second = inked(scene, both, 1);
  CHECK(first > 200);
  CHECK(second > 200);
  CHECK(inked(scene, alone, 0) < first / 3);  // it is hidden where the curves coincide
  look(near);
  CHECK(words(scene).contains("land 2 (≈ land 1)"));
  scene.setPanelView(0, std::pair(-1.0, 1.0));  // there they part
  CHECK(words(scene).contains("land 2"));
  // A curve that is switched off hides nothing.
  look(wave);
  scene.showCurve(0, 0, false);
  CHECK(words(scene).contains("land 2"));
  // Three of a kind, and a long run, whose curves are thinned.
  std::vector<double> noise;
  page.x.clear();
  for (int i = 0; i < 200000; ++i) {
    page.x.push_back(1e-5 * i);
    noise.push_back(std::sin(0.01 * i) + 0.3 * std::sin(1.7 * i));
  }
  page.panels = {{"Force", "N", {{"a", noise, {}}, {"b", noise, {}}, {"c", noise, {}}}}};
  scene.setPage(page);
  const QImage three = scene.image({1280, 800});
  CHECK(words(scene).contains("b (= a)"));
  CHECK(words(scene).contains("c (= a)"));
  for (const int curve : {0, 1, 2}) CHECK(inked(scene, three, curve) > 1000);
}

TEST_CASE("chart_scene: what is said of a curve over another is true of their values, and cheap",
          "[gui]") {
  test::use_qt();
  const auto name = [](const ChartScene& scene, const QString& start) {
    for (QGraphicsItem* item : scene.items())
      if (auto* text = dynamic_cast<QGraphicsSimpleTextItem*>(item);
          text && text->text().startsWith(start))
        return text->text().toStdString();
    return std::string();
  };
  ChartPage page;
  std::vector<double> wave, opposite;
  for (int i = 0; i < 200000; ++i) {
    page.x.push_back(1e-5 * i);
    wave.push_back(std::sin(2.39996 * i));  // a golden angle: near its peak in each column
    opposite.push_back(-wave.back());
  }
  ChartScene scene;
  scene.setTheme(theme(ThemeKind::Light));
  scene.setPageSize({1280, 800});
  using Values = std::vector<double>;
  const auto show = [&](const Values& first, const Values& second, const Values& low = {},
                        const Values& high = {}, const Values& second_high = {}) {
    page.panels = {{"Place", "m", {{"cage y", first, {}}, {"second", second, {}}}}};
    for (ChartCurve& curve : page.panels[0].curves) curve.low = low, curve.high = high;
    if (!second_high.empty()) page.panels[0].curves[1].high = second_high;
    scene.setPage(page);
    return name(scene, "second");
  };
  CHECK(show(wave, opposite) == "second (over cage y)");
  CHECK(show(wave, wave) == "second (= cage y)");
  Values late = wave;
  late.back() += 0.1;
  CHECK(show(wave, late) == "second (over cage y)");
  scene.setView(0.0, 1.0);
  CHECK(name(scene, "second") == "second (= cage y)");  // there they are
  late.back() = wave.back() + 1e-4;
  CHECK(show(wave, late) == "second (≈ cage y)");
  // Bands are part of what is told.
  Values low = wave, high = wave, higher = wave;
  for (double& v : low) v -= 1.0;
  for (double& v : high) v += 1.0;
  for (double& v : higher) v += 2.0;
  CHECK(show(wave, wave, low, high) == "second (= cage y)");
  CHECK(show(wave, wave, low, high, higher) == "second (over cage y)");
  // Far beyond a short range there is nothing to draw, and stripes are no items of their own.
  show(wave, {});
  const auto alone = scene.items().size();
  show(wave, wave);
  CHECK(scene.items().size() <= alone + 3);
  scene.setView(0.0, 2e-3);
  scene.setPanelView(0, std::pair(0.0, 1e-3));
  CHECK(scene.items().size() <= alone + 20);
}

TEST_CASE("chart_scene: a logarithmic panel without a value above 0 says so beside an empty curve",
          "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x = {0.0, 1.0, 2.0};
  const double none = std::numeric_limits<double>::quiet_NaN();
  page.panels = {{"Load", "N", {{"a", {0.0, 0.0, -1.0}, {}}, {"b", {none, none, none}, {}}}}};
  page.panels[0].log = true;
  ChartScene scene;
  scene.setPage(page);
  const auto said = [&] {
    const QList<QGraphicsItem*> items = scene.items();
    return std::any_of(items.begin(), items.end(), [](QGraphicsItem* item) {
      auto* text = dynamic_cast<QGraphicsTextItem*>(item);
      return text != nullptr && text->toPlainText().startsWith("No value is above 0");
    });
  };
  CHECK(said());
  page.panels[0].curves[0].y[1] = 1.0;
  scene.setPage(page);
  CHECK_FALSE(said());
}

TEST_CASE("chart_scene: a page without panels shows its sentence, in both themes", "[gui]") {
  test::use_qt();
  ChartPage page;
  page.note = "The stored steps are not equally spaced.";
  for (const auto kind : {ThemeKind::Light, ThemeKind::Dark}) {
    ChartScene scene;
    scene.setTheme(theme(kind));
    scene.setPage(page);
    const QImage image = scene.image({640, 400});
    CHECK(image.pixelColor(3, 3) == theme(kind).surface);
    int inked = 0;
    for (int y = 0; y < 400; ++y)
      for (int x = 0; x < 640; ++x) inked += image.pixelColor(x, y) != theme(kind).surface;
    CHECK(inked > 300);
  }
}

TEST_CASE("theme: the shipped font is the one in use", "[gui]") {
  test::use_qt();
  CHECK(QFontInfo(ui_font(13)).family() == "DejaVu Sans");
  CHECK(QFile::exists(":/adore/fonts/LICENSE-DejaVu.txt"));
}

TEST_CASE("every app has an icon and an entry in the desktop's menu", "[gui]") {
  test::use_qt();
  const fs::path resources = adore::test::source_dir() / "resources";
  for (const std::string app : {"adrinput", "adrplot", "agore"}) {
    INFO(app);
    const QImage icon(QString::fromStdString(":/adore/icons/" + app + ".png"));
    CHECK(icon.size() == QSize(128, 128));
    CHECK(fs::exists(resources / "icons" / (app + ".svg")));
    std::ifstream file(resources / "applications" / (app + ".desktop"));
    const std::string entry{std::istreambuf_iterator<char>(file), {}};
    CHECK(entry.find("\nExec=" + app + " %") != std::string::npos);
    CHECK(entry.find("\nIcon=" + app + "\n") != std::string::npos);
  }
}

TEST_CASE("image_export: names count on, and skip files that exist", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const QString first = folder.filePath("plot.jpg");
  CHECK(next_image_name(first) == folder.filePath("plot-2.jpg"));
  CHECK(next_image_name(folder.filePath("plot-9.png")) == folder.filePath("plot-10.png"));
  QImage image(20, 10, QImage::Format_RGB32);
  image.fill(Qt::red);
  save_image(image, folder.filePath("plot-2.jpg").toStdString());
  CHECK(next_image_name(first) == folder.filePath("plot-3.jpg"));
  CHECK(proposed_image_name("test-app", "page.jpg") == "page.jpg");
  remember_image_name("test-app", first);
  CHECK(proposed_image_name("test-app", "page.jpg") == folder.filePath("plot-3.jpg"));
}

TEST_CASE("image_export: PNG and JPEG are written, other wishes are refused with a sentence",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  QImage image(64, 48, QImage::Format_RGB32);
  image.fill(QColor(10, 120, 200));
  for (const char* name : {"a.png", "b.jpg", "c.JPEG"}) {
    save_image(image, folder.filePath(name).toStdString());
    const QImage back(folder.filePath(name));
    REQUIRE(back.size() == image.size());
    CHECK(std::abs(back.pixelColor(30, 20).green() - 120) <= 3);  // JPEG is lossy by a few levels
  }
  CHECK_THROWS_WITH(save_image(image, folder.filePath("d.bmp").toStdString()),
                    Catch::Contains(".png, .jpg or .jpeg"));
  CHECK_THROWS_AS(save_image(image, folder.filePath("missing/e.png").toStdString()), InputError);
}

TEST_CASE("image_export: only own pictures and films are replaced without a question", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  QImage image(64, 48, QImage::Format_RGB32);
  image.fill(Qt::green);
  const auto path = [&](const char* name) {
    return std::filesystem::path(folder.filePath(name).toStdString());
  };
  for (const char* name : {"own.png", "own.jpg"}) {
    save_image(image, path(name));
    CHECK_NOTHROW(save_image(image, path(name)));
    REQUIRE(image.save(folder.filePath(name)));  // as another program would
    CHECK_THROWS_WITH(save_image(image, path(name)), Catch::Contains("not drawn by this program"));
    CHECK_NOTHROW(save_image(image, path(name), Replace::Anything));  // somebody was asked
    CHECK_NOTHROW(save_image(image, path(name)));
  }
  std::filesystem::create_symlink(path("own.png"), path("link.png"));
  CHECK_THROWS_AS(save_image(image, path("link.png")), InputError);
  CHECK_THROWS_AS(AviWriter(path("link.png"), {64, 48}, 25), InputError);
  for (int time = 0; time < 2; ++time) {
    AviWriter film(path("film.avi"), {64, 48}, 25);
    film.add(image);
    film.finish();
  }
  QFile file(folder.filePath("film.avi"));
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write("RIFF\1\2\3\4AVI of somebody else");
  file.close();
  CHECK_THROWS_WITH(AviWriter(path("film.avi"), {64, 48}, 25),
                    Catch::Contains("not drawn by this program"));
}

TEST_CASE("avi_writer: the film is a valid RIFF file whose index finds every picture", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const QString name = folder.filePath("film.avi");
  constexpr int kFrames = 7;
  {
    AviWriter film(name.toStdString(), {320, 200}, 25);
    for (int i = 0; i < kFrames; ++i) {
      QImage image(320, 200, QImage::Format_RGB32);
      image.fill(QColor(30 * i, 90, 200 - 20 * i));
      film.add(image);
    }
    CHECK_FALSE(QFile::exists(name));  // appears when complete
    film.finish();
  }
  QFile file(name);
  REQUIRE(file.open(QIODevice::ReadOnly));
  const QByteArray bytes = file.readAll();
  CHECK(bytes.left(4) == "RIFF");
  CHECK(number_at(bytes, 4) == bytes.size() - 8);
  const auto movi = bytes.indexOf("movi"), index = bytes.indexOf("idx1");
  REQUIRE(movi > 0);
  REQUIRE(index > movi);
  CHECK(number_at(bytes, movi - 4) == index - movi);
  REQUIRE(number_at(bytes, index + 4) == 16 * kFrames);
  CHECK(number_at(bytes, bytes.indexOf("avih") + 8 + 16) == kFrames);
  for (int i = 0; i < kFrames; ++i) {
    const auto entry = index + 8 + 16 * i;
    const auto chunk = movi + number_at(bytes, entry + 8);
    CHECK(bytes.mid(chunk, 4) == "00dc");
    CHECK(number_at(bytes, chunk + 4) == number_at(bytes, entry + 12));
    const QImage picture =
        QImage::fromData(bytes.mid(chunk + 8, number_at(bytes, chunk + 4)), "JPEG");
    REQUIRE(picture.size() == QSize(320, 200));
    CHECK(std::abs(picture.pixelColor(100, 100).red() - 30 * i) <= 4);
  }
}

TEST_CASE("avi_writer: an unfinished or empty film leaves no file", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const QString name = folder.filePath("film.avi");
  AviWriter film(name.toStdString(), {320, 200}, 25);
  CHECK_THROWS_AS(film.finish(), InputError);
  CHECK_FALSE(QFile::exists(name));
  CHECK_THROWS_AS(AviWriter(folder.filePath("no/film.avi").toStdString(), {320, 200}, 25),
                  InputError);
}

TEST_CASE("disclaimer: names warranty and independence, and is remembered", "[gui]") {
  test::use_qt();
  DisclaimerDialog dialog("AdrPlot");
  QString text;
  for (auto* label : dialog.findChildren<QLabel*>()) text += label->text();
  CHECK(text.contains("without any warranty"));
  CHECK(text.contains("independent implementation"));
  CHECK_FALSE(disclaimer_accepted());
  remember_disclaimer();
  CHECK(disclaimer_accepted());
  CHECK(ask_for_disclaimer("AdrPlot"));  // returns at once
}

TEST_CASE("command_line: picture sizes are checked", "[unit]") {
  CHECK(parse_size("800x600").width == 800);
  CHECK(parse_size("800x600").height == 600);
  for (const char* wrong :
       {"", "800", "800x", "x600", "800x600x3", "10x600", "99999x600", "8e2x600"})
    CHECK_THROWS_AS(parse_size(wrong), InputError);
}

TEST_CASE("log chart: a picture with every curve, and none without points", "[gui]") {
  test::use_qt();
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath("log.png").toStdString();
  LogChart chart{"Cost", "seconds", "error", {{"a", {}, {}}}};
  CHECK_FALSE(save_log_chart(chart, file));
  CHECK_FALSE(std::filesystem::exists(file));
  chart.curves = {{"a", {1e-3, 1e-5, 1e-7}, {0.01, 0.1, 1.0}}, {"b", {1e-2, 1e-6}, {0.02, 2.0}}};
  REQUIRE(save_log_chart(chart, file));
  const QImage image(QString::fromStdString(file.string()));
  CHECK(image.size() == QSize(1280, 800));
  int blue = 0, orange = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      blue += image.pixelColor(x, y) == QColor("#0072b2");
      orange += image.pixelColor(x, y) == QColor("#d55e00");
    }
  CHECK(blue > 500);
  CHECK(orange > 500);
}

TEST_CASE("a window opens within its screen, frame and title bar included", "[unit][gui][window]") {
  CHECK(desktop::size_within({1320, 820}, {2560, 1440}) == QSize(1320, 820));
  CHECK(desktop::size_within({1320, 820}, {1280, 800}) == QSize(1264, 752));
  CHECK(desktop::size_within({1280, 860}, {1920, 800}) == QSize(1280, 752));
}

TEST_CASE("a window comes back where it was closed", "[unit][gui][window]") {
  test::use_qt();
  const QString app = "adore-test-window-place";
  QSettings("Adore", app).clear();
  {
    QWidget window;
    desktop::open_at_size(window, {700, 500});
    const desktop::WindowMemory memory(window, app);
    CHECK(window.size() == QSize(700, 500));
    window.show();
    window.resize(640, 410);
    window.close();
  }
  QWidget window;
  desktop::open_at_size(window, {700, 500});
  const desktop::WindowMemory memory(window, app);
  CHECK(window.size() == QSize(640, 410));
  QSettings("Adore", app).clear();
}

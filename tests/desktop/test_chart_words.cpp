#include "desktop/chart_scene.hpp"
#include "desktop/text_faults.hpp"
#include "desktop/theme.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsItem>
#include <QGraphicsLineItem>
#include <QGraphicsTextItem>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QTextDocument>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// Texts on a page of charts.
using namespace adore;
using namespace adore::desktop;

namespace {

/// Texts of a page.
QStringList words(const ChartScene& scene) {
  QStringList out;
  for (auto* item : scene.items())
    if (auto* text = dynamic_cast<QGraphicsSimpleTextItem*>(item)) out << text->text();
  return out;
}

}  // namespace

TEST_CASE("chart_scene: titles of neighboring panels do not run into each other", "[gui]") {
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
  // A text without space below the title is next to it, unshortened.
  const FittedHeading wide = fitted_heading(text, metrics, 2000.0, 1500.0);
  CHECK(wide.below == text);
  CHECK(wide.beside.isEmpty());
  const FittedHeading narrow = fitted_heading(text, metrics, close - 30.0, 400.0);
  CHECK(narrow.below == "a file   ·   page 2 of 9");
  CHECK(narrow.beside == "all digits");
  CHECK(fitted_heading(text, metrics, close - 30.0, 5.0).below.endsWith(QChar(0x2026)));
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
      for (auto* item : scene.items())
        if (auto* text = dynamic_cast<QGraphicsSimpleTextItem*>(item))
          CHECK(scene.sceneRect().contains(text->sceneBoundingRect()));
      const QStringList said = words(scene);
      INFO(size.width() << ", " << last << ": " << said.join("|").toStdString());
      for (const ChartMark& mark : page.marks) {
        if (size.width() < 500) continue;  // there names are shortened, not laid over each other
        const QRegularExpression name("\\b" + QString::fromStdString(mark.label) + "\\b");
        CHECK(said.filter(name).isEmpty() == (mark.x > last));
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
  page.marks = {
      {180.0, "FTF"}, {400.0, "shaft"}, {640.0, "BSF"}, {900.0, "BPFO"}, {1100.0, "BPFI"}};
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
        if (l.y1() == l.y2() && std::abs(l.y1() - area.top()) < 25.0)
          steps.push_back({l.x1(), l.x2(), l.y1()});
        if (l.x1() == l.x2() && l.y1() < area.top()) feet.push_back(l.x1());
        // Nothing but the broken lines of the marks stands among the curves.
        if (line->pen().style() == Qt::SolidLine) CHECK(std::max(l.y1(), l.y2()) <= area.top());
      }
    REQUIRE(steps.size() >= 3);
    std::sort(steps.begin(), steps.end(), [](auto& a, auto& b) { return a.from < b.from; });
    std::size_t mark = 0;
    for (std::size_t i = 0; i < steps.size(); ++i, ++mark) {
      // From below its name to its line, in their order; each below the one before, so that none
      // crosses it.
      while (mark < page.marks.size() &&
             std::abs(steps[i].to - scene.sceneXAt(page.marks[mark].x)) > 0.01)
        ++mark;
      CHECK(mark < page.marks.size());
      CHECK(std::find(feet.begin(), feet.end(), steps[i].from) != feet.end());
      if (i > 0) CHECK(steps[i].y > steps[i - 1].y + 1.0);
      CHECK(steps[i].y < area.top());
    }
    CHECK(text_faults(scene).empty());
  }
}

TEST_CASE("chart_scene: curves that would hide others → legend text, half of the line left",
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
  (void)look(other);  // one wave of it is another
  CHECK(words(scene).contains("land 2 (partly = land 1)"));
  std::vector<double> apart = wave;
  for (double& value : apart) value += 20.0;
  const QImage alone = look(apart);
  CHECK(words(scene).contains("land 2"));
  const QImage both = look(wave);
  CHECK(words(scene).contains("land 2 (= land 1)"));
  CHECK(scene.lineCount(0) == 2);
  const int first = inked(scene, both, 0), second = inked(scene, both, 1);
  CHECK(first > 200);
  CHECK(second > 200);
  CHECK(inked(scene, alone, 0) > first / 2);  // half of the way is the other's where they coincide
  look(near);
  CHECK(words(scene).contains("land 2 (≈ land 1)"));
  scene.setPanelView(0, std::pair(-1.0, 1.0));  // there they part
  CHECK(words(scene).contains("land 2"));
  // Lines closer than a line width are distinguished at the current size and zoom.
  for (const QSizeF size : {QSizeF(1600, 1000), QSizeF(700, 450), QSizeF(400, 260)}) {
    scene.setPageSize(size);
    look(near);
    CHECK(words(scene).filter("≈").size() == 1);
    for (const double pixels : {1.4, 1.8}) {
      std::vector<double> beside = wave;
      const double shift = pixels * 240.0 / scene.plotAreas()[0].height();
      for (double& value : beside) value += shift;
      page.panels = {{"Force", "N", {{"land 1", wave, {}}, {"land 2", beside, {}}}}};
      scene.setPage(page);
      scene.setPanelView(0, std::pair(-120.0, 120.0));
      INFO(size.width() << ", " << pixels << ": " << words(scene).join("; ").toStdString());
      CHECK((words(scene).filter("land 2 (≈").size() == 1) == (pixels < 1.6));
      scene.setPanelView(0, std::pair(-12.0, 12.0));
      CHECK(words(scene).contains("land 2"));
    }
  }
  // Rounding errors count as 0.
  std::vector<double> noise_1, noise_2;
  for (std::size_t i = 0; i < wave.size(); ++i) {
    noise_1.push_back(1e-19 * std::sin(1.7 * static_cast<double>(i)));
    noise_2.push_back(1e-19 * std::cos(2.9 * static_cast<double>(i)));
  }
  page.panels = {{"Place", "m", {{"land 1", noise_1, {}}, {"land 2", noise_2, {}}}}};
  scene.setPage(page);
  CHECK(words(scene).contains("land 2 (= land 1)"));
  // One that breaks off now and then is hidden as well, and one that is there for a tenth.
  std::vector<double> gaps = wave, few(wave.size(), std::nan(""));
  for (const std::size_t i : {50U, 51U, 200U, 333U}) gaps[i] = std::nan("");
  std::copy(wave.begin() + 100, wave.begin() + 140, few.begin() + 100);
  for (const auto& [below, hidden] : {std::pair{&gaps, true}, {&few, false}}) {
    page.panels = {{"Force", "N", {{"land 1", *below, {}}, {"land 2", wave, {}}}}};
    scene.setPageSize({1280, 800});
    scene.setPage(page);
    CHECK(words(scene).contains(hidden ? "land 2 (= land 1)" : "land 2 (partly = land 1)"));
    if (hidden) CHECK(inked(scene, scene.image({1280, 800}), 0) > 200);
  }
  // A later one with gaps hides the earlier one where it is.
  page.panels = {{"Force", "N", {{"land 1", wave, {}}, {"land 2", gaps, {}}}}};
  scene.setPage(page);
  CHECK(words(scene).contains("land 2 (= land 1)"));
  for (std::size_t i = 150; i < 200; ++i) gaps[i] = std::nan("");
  page.panels[0].curves[1].y = gaps;
  scene.setPage(page);
  CHECK(words(scene).contains("land 2 (partly = land 1)"));
  // A curve that is switched off hides nothing.
  scene.setPageSize({1280, 800});
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

TEST_CASE("chart_scene: stretches of long curves are found as those of short ones", "[gui]") {
  test::use_qt();
  ChartScene scene;
  scene.setTheme(theme(ThemeKind::Light));
  scene.setPageSize({1280, 800});
  const auto said = [&](int steps, double from, double to, double gap) {
    ChartPage page;
    std::vector<double> one, other;
    for (int i = 0; i < steps; ++i) {
      const double x = static_cast<double>(i) / (steps - 1);
      page.x.push_back(x);
      one.push_back(std::sin(5.0 * x));
      const bool same = x >= from && x <= to && !(std::abs(x - gap) < 0.002);
      other.push_back(one.back() + (same ? 0.0 : 0.5));
    }
    page.panels = {{"Load", "N", {{"first", one, {}}, {"second", other, {}}}}};
    scene.setPage(page);
    QString out;
    for (const QString& text : words(scene))
      if (text.startsWith("second")) out = text;
    return out.toStdString();
  };
  // Over a part, from the start, to the end, everywhere, in two parts, nowhere, too short to see.
  const std::array<std::array<double, 3>, 7> cases{{{0.3, 0.6, 2.0},
                                                    {0.0, 0.4, 2.0},
                                                    {0.7, 1.0, 2.0},
                                                    {0.0, 1.0, 2.0},
                                                    {0.2, 0.8, 0.5},
                                                    {2.0, 3.0, 2.0},
                                                    {0.5, 0.51, 2.0}}};
  for (const auto& [from, to, gap] : cases) {
    CAPTURE(from, to, gap);
    const std::string few = said(2'000, from, to, gap);
    CHECK(said(200'000, from, to, gap) == few);
    CHECK((few == "second") == !(std::min(to, 1.0) - from > 0.03));
  }
}

TEST_CASE("chart_scene: texts on covering curves → correct and fast", "[gui]") {
  test::use_qt();
  const auto name = [](const ChartScene& scene, const QString& start) {
    for (const QString& text : words(scene))
      if (text.startsWith(start)) return text.toStdString();
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
  CHECK(show(wave, opposite) == "second (covers cage y)");
  CHECK(show(wave, wave) == "second (= cage y)");
  Values late = wave;
  late.back() += 0.1;
  CHECK(show(wave, late) == "second (covers cage y)");
  scene.setView(0.0, 1.0);
  CHECK(name(scene, "second") == "second (= cage y)");  // there they are
  late.back() = wave.back() + 1e-4;
  CHECK(show(wave, late) == "second (≈ cage y)");
  // Bands are part of the text.
  Values low = wave, high = wave, higher = wave;
  for (double& v : low) v -= 1.0;
  for (double& v : high) v += 1.0;
  for (double& v : higher) v += 2.0;
  CHECK(show(wave, wave, low, high) == "second (= cage y)");
  CHECK(show(wave, wave, low, high, higher) == "second (covers cage y)");
  // Far beyond a short range nothing is drawn, and stripes are not separate items.
  show(wave, {});
  const auto alone = scene.items().size();
  show(wave, wave);
  CHECK(scene.items().size() <= alone + 3);
  scene.setView(0.0, 2e-3);
  scene.setPanelView(0, std::pair(0.0, 1e-3));
  CHECK(scene.items().size() <= alone + 20);
}

TEST_CASE(
    "chart_scene: logarithmic panel without positive values → message, also with an empty curve",
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

TEST_CASE("chart_scene: panel without values → no scale, message with the reason", "[gui]") {
  test::use_qt();
  ChartPage page;
  page.x_title = "Time", page.x_unit = "s";
  page.x = {0.0, 1.0, 2.0};
  const double none = std::numeric_limits<double>::quiet_NaN();
  page.panels = {{"Film", "m", {{"outer race", {none, none, none}, {}}, {"inner race", {}, {}}}},
                 {"Load", "N", {{"", {1.0, 2.0, 3.0}, {}}}}};
  page.panels[0].message = "No film was computed.";
  ChartScene scene;
  for (const QSizeF size : {QSizeF(1280, 800), QSizeF(700, 450)}) {
    scene.setPageSize(size);
    scene.setPage(page);
    const QRectF area = scene.plotAreas().front();
    QStringList beside;
    for (auto* item : scene.items()) {
      if (auto* text = dynamic_cast<QGraphicsSimpleTextItem*>(item))
        if (text->rotation() == 0.0 && text->sceneBoundingRect().top() > area.top() - 25.0 &&
            text->sceneBoundingRect().bottom() < area.bottom() + 5.0)
          beside << text->text();
    }
    INFO(beside.join("|").toStdString());
    CHECK(beside.isEmpty());
    CHECK(words(scene).contains("Film"));  // without a unit's prefix
    CHECK(words(scene).contains("Load [N]"));
    const QList<QGraphicsItem*> items = scene.items();
    const bool told = std::any_of(items.begin(), items.end(), [](QGraphicsItem* item) {
      auto* text = dynamic_cast<QGraphicsTextItem*>(item);
      return text != nullptr && text->toPlainText() == "No film was computed.";
    });
    CHECK(told);
  }
}

TEST_CASE("a legend that reaches over the labels of its axis stands above them", "[gui][desktop]") {
  test::use_qt();
  ChartPage page;
  page.title = "Contact loads of element 1";
  page.x_title = "Time", page.x_unit = "s";
  page.x = {0.0, 1.0, 2.0, 3.0};
  ChartScene scene(ChartStyle::Compact);
  bool any_over = false, any_beside = false;
  for (const char* const name : {"b", "inner race (over)", "inner race (over the outer one)"})
    for (const double top : {1.49, 1.5, 1.501, 1.7})
      for (const double width : {200.0, 252.0, 330.0}) {
        page.panels = {{"Load", "N", {{"outer race", {0.0, top, 0.0, top}, {}}}}};
        page.panels.front().curves.push_back({name, {0.0, 0.3, 0.6, 0.2}, {}});
        scene.setPageSize(QSizeF(width, 334.0));
        scene.setPage(page);
        REQUIRE(scene.legend().size() == 2);
        INFO(name << " up to " << top << ", " << width << " wide");
        const bool over = scene.legend().back().place.left() < scene.plotAreas().front().left();
        any_over = any_over || over, any_beside = any_beside || !over;
        for (const LegendEntry& entry : scene.legend())
          for (const QGraphicsItem* item : scene.items()) {
            const auto* text = dynamic_cast<const QGraphicsSimpleTextItem*>(item);
            if (text == nullptr || text->rotation() != 0.0) continue;
            bool number = false;
            text->text().toDouble(&number);
            INFO(text->text().toStdString());
            if (number) CHECK_FALSE(entry.place.intersects(text->sceneBoundingRect()));
          }
      }
  CHECK(any_over);
  CHECK(any_beside);
}

TEST_CASE("a note takes smaller letters and room before sentences are counted, none is cut",
          "[gui][desktop]") {
  test::use_qt();
  ChartScene scene;
  const auto note_of = [&](int count) {
    std::string note;
    for (int i = 0; i < count; ++i)
      note += (i > 0 ? " " : "") + std::string("Sentence ") + std::to_string(i) +
              " tells of a load of 12.5 kN that a page has to explain.";
    return note;
  };
  for (const auto& [size, interactive] : {std::pair(QSizeF(700, 450), true),
                                          {QSizeF(1280, 800), true},
                                          {QSizeF(700, 450), false},
                                          {QSizeF(1280, 800), false}})
    for (int panels = 1; panels <= 3; ++panels) {
      scene.setInteractive(interactive);
      bool counted = false;
      for (int count = 1; count <= 400 && !counted; count += count < 12 ? 1 : 7) {
        INFO(size.width() << " wide, " << panels << " panels, " << count << " sentences");
        ChartPage page;
        page.title = "A page";
        page.x = {0.0, 1.0};
        for (int p = 0; p < panels; ++p)
          page.panels.push_back({"Load", "N", {{"", {0.0, 1.0}, {}}}});
        page.note = note_of(count);
        scene.setPageSize(size);
        scene.setPage(page);
        QString all;
        int told = 0, more = 0;
        QString whole_note;
        for (QGraphicsItem* item : scene.items(Qt::AscendingOrder)) {
          auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item);
          if (text == nullptr || text->pos().x() != 24.0 || text->pos().y() < 60.0) continue;
          all += text->text() + ' ';
          whole_note = text->toolTip();
        }
        all.replace(QChar(QChar::Nbsp), ' ');
        for (int i = 0; i < count; ++i)
          told += all.contains(QString("Sentence %1 tells").arg(i)) ? 1 : 0;
        if (all.contains("(1 more sentence")) more = 1;
        if (const auto at = all.indexOf(interactive ? " more sentences: move the pointer here"
                                                    : " more sentences not shown");
            at > 0)
          more = all.left(at).section('(', -1).toInt();
        CHECK(told + more == count);
        CHECK_FALSE(all.contains(QChar(0x2026)));
        if (more > 0) CHECK(whole_note.contains(QString("Sentence %1 tells").arg(count - 1)));
        counted = counted || more > 0;
        CHECK(text_faults(scene) == std::vector<std::string>());
        for (const QRectF& area : scene.plotAreas())
          CHECK(area.height() >= (interactive ? 43.0 : 33.0));
      }
      CHECK(counted);  // the test went far enough
    }
}

TEST_CASE("a note does not end in a word alone, nor takes a line more for that", "[gui][desktop]") {
  test::use_qt();
  ChartScene scene;
  scene.setPageSize({700, 450});
  std::string note = "A load.";
  int seen = 0;
  for (int words = 1; words < 60; ++words) {
    note.insert(note.size() - 1, words % 3 == 0 ? " and more" : " of it");
    ChartPage page;
    page.title = "A page";
    page.x = {0.0, 1.0};
    page.panels = {{"Load", "N", {{"", {0.0, 1.0}, {}}}}};
    page.note = note;
    scene.setPage(page);
    QStringList lines;
    for (QGraphicsItem* item : scene.items(Qt::AscendingOrder))
      if (auto* text = qgraphicsitem_cast<QGraphicsSimpleTextItem*>(item);
          text != nullptr && text->pos().x() == 24.0 && text->pos().y() >= 60.0)
        lines << text->text();
    REQUIRE(lines.join(' ') == QString::fromStdString(note));
    if (lines.size() < 2) continue;
    ++seen;
    INFO(lines.join("|").toStdString());
    CHECK(lines.back().count(' ') >= 2);
  }
  CHECK(seen > 20);
}

TEST_CASE("legend: curves without values are marked", "[gui][desktop]") {
  test::use_qt();
  ChartPage page;
  page.x = {0.0, 1.0};
  page.panels = {{"Load", "N", {{"outer race", {0.0, 1.0}, {}}, {"inner race", {}, {}}}}};
  ChartScene scene;
  scene.setPage(page);
  CHECK(words(scene).contains("inner race (none)"));
  CHECK(words(scene).contains("outer race"));
}

TEST_CASE("the reason of an empty panel stays within it", "[gui][desktop]") {
  test::use_qt();
  ChartPage page;
  page.title = "A page";
  page.x_title = "Frequency", page.x_unit = "Hz";
  page.x = {0.0, 1.0};
  page.note = "A note that takes a line of its own.";
  page.marks = {{0.5, "shaft"}};
  page.panels = {{"Contact load", "N", {{"", {0.0, 1.0}, {}}}}};
  ChartPanel empty{"Contact angle", "deg", {{"outer race", {}, {}}, {"inner race", {}, {}}}};
  empty.message =
      "Outer race: there are no values at 2 of 5690 steps. Inner race: there are no values at 3757 "
      "of 5690 steps, so there is no frequency spectrum.";
  page.panels.insert(page.panels.end(), 2, empty);
  ChartScene scene;
  scene.setPageSize(QSizeF(700, 450));
  scene.setPage(page);
  int found = 0;
  for (const QGraphicsItem* item : scene.items()) {
    const auto* text = dynamic_cast<const QGraphicsTextItem*>(item);
    if (text == nullptr || !text->toPlainText().startsWith("Outer")) continue;
    ++found;
    const qreal margin = text->document()->documentMargin();
    const QRectF words = text->sceneBoundingRect().adjusted(margin, margin, -margin, -margin);
    CHECK((scene.plotAreas()[1].contains(words) || scene.plotAreas()[2].contains(words)));
  }
  CHECK(found == 2);
  CHECK(text_faults(scene).empty());
}

TEST_CASE("chart_scene: outline on another one → half of the line left, with a text", "[gui]") {
  test::use_qt();
  for (const double apart : {0.0, 1e-3, 0.1}) {
    ChartPage page;
    page.title = "Load around the bearing";
    page.x_title = "y direction", page.x_unit = "N";
    page.equal_axes = page.closed_outline = true;
    ChartPanel rose;
    rose.title = "z direction", rose.unit = "N";
    for (const bool outer : {true, false}) {
      ChartCurve curve{outer ? "outer race" : "inner race", {}, {}};
      for (int i = 0; i <= 360; ++i) {
        const double a = i * std::acos(-1.0) / 180.0, r = 100.0 * (outer ? 1.0 : 1.0 + apart);
        curve.x.push_back(-r * std::sin(a));
        curve.y.push_back(r * std::cos(a));
      }
      rose.curves.push_back(std::move(curve));
    }
    page.panels = {rose};
    ChartScene scene;
    scene.setTheme(theme(ThemeKind::Light));
    scene.setPageSize({800, 700});
    scene.setPage(page);
    QImage image(800, 700, QImage::Format_RGB32);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    scene.paintPage(painter, QRectF(0, 0, 800, 700));
    painter.end();
    std::array<int, 2> seen{};
    const QRect inside = scene.plotAreas().front().toRect();
    for (int y = inside.top(); y < inside.bottom(); ++y)
      for (int x = inside.left(); x < inside.right(); ++x)
        for (std::size_t i = 0; i < 2; ++i) {
          const QColor c = image.pixelColor(x, y), of = theme(ThemeKind::Light).curves[i];
          seen[i] += std::abs(c.red() - of.red()) + std::abs(c.green() - of.green()) +
                         std::abs(c.blue() - of.blue()) <
                     60;
        }
    const QString all = words(scene).join("|");
    CAPTURE(apart, seen[0], seen[1], all.toStdString());
    CHECK(seen[0] > 200);
    CHECK(seen[1] > 200);
    CHECK(all.contains("inner race (= outer race)") == (apart == 0.0));
    CHECK(all.contains("inner race (≈ outer race)") == (apart == 1e-3));
  }
}

TEST_CASE("legend: names with a common word that do not fit → the word once, then numbers",
          "[gui][desktop]") {
  test::use_qt();
  ChartPage page;
  page.title = "Contact load";
  page.x_title = "Time", page.x_unit = "s";
  page.x = {0.0, 1.0, 2.0};
  page.panels = {{"Contact load", "N", {}}};
  for (int i = 1; i <= 12; ++i) {
    ChartCurve curve{"element " + std::to_string(i), {1.0 * i, 2.0 * i, 3.0 + i}, {}};
    curve.hidden = i > 4;
    page.panels.front().curves.push_back(std::move(curve));
  }
  ChartScene scene;
  scene.setPageSize(QSizeF(900, 600));
  scene.setPage(page);
  QStringList shown = words(scene);
  CHECK(shown.filter("…").isEmpty());
  CHECK(shown.contains("element 1"));
  CHECK(shown.contains("12"));
  CHECK_FALSE(shown.contains("element 12"));
  scene.setPageSize(QSizeF(2400, 600));
  CHECK(words(scene).contains("element 12"));
  // Other names are shortened as before.
  for (ChartCurve& curve : page.panels.front().curves) curve.name = "outer race at " + curve.name;
  page.panels.front().curves.back().name = "inner race";
  scene.setPageSize(QSizeF(900, 600));
  scene.setPage(page);
  CHECK_FALSE(words(scene).filter("…").isEmpty());
}

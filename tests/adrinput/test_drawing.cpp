#include "adrinput/deck_window.hpp"
#include "adrinput/drawing_panel.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/record_page.hpp"
#include "deck/templates.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/theme.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <catch2/catch.hpp>

#include <algorithm>
#include <ctime>

using namespace adore;
using namespace adore::adrinput;

namespace {

QImage picture_of(DrawingView& view) { return view.grab().toImage(); }

/// Pixels in which two pictures differ.
int differing(const QImage& a, const QImage& b) {
  REQUIRE(a.size() == b.size());
  int out = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) out += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return out;
}

int pixels_like(const QImage& image, const QColor& colour) {
  int out = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) out += image.pixelColor(x, y) == colour ? 1 : 0;
  return out;
}

QString strong_label(const DrawingView& view) {
  for (const auto& label : view.labels())
    if (label.strong) return label.text;
  return {};
}

void check_labels(const DrawingView& view) {
  const auto& labels = view.labels();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    INFO(labels[i].text.toStdString());
    CHECK(QRectF(view.rect()).contains(labels[i].box));
    for (std::size_t k = 0; k < i; ++k) {
      INFO(labels[k].text.toStdString());
      CHECK_FALSE(labels[i].box.intersects(labels[k].box));
    }
  }
}

}  // namespace

TEST_CASE("drawing: highlights the dimension of the field in focus", "[gui][adrinput][drawing]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  DrawingPanel& panel = window.drawingPanel();
  DrawingView& view = panel.drawingView();
  panel.drawNow();
  const auto focus = [&](const char* name) {
    const Cell at = cell(name);
    window.showRecord(at.record);
    REQUIRE(window.page()->focusCell(at));
    picture_of(view);
  };
  focus("pitchDia");
  CHECK(panel.view() == drawing::View::CrossSection);
  CHECK(view.currentFocus().variable == "pitchDia");
  CHECK(strong_label(view) == "pitchDia = 0.06 m");
  const QImage pitch = picture_of(view);
  focus("shoulderDia1");
  CHECK(strong_label(view) == "shoulderDia1 = 0.0663 m");
  CHECK(differing(pitch, picture_of(view)) > 200);
  focus("bPocCls1");
  CHECK(panel.view() == drawing::View::Pocket);
  CHECK(strong_label(view) == "bPocCls1 = 0.00025 m");
  focus("appLoadX");
  CHECK(panel.view() == drawing::View::Loads);
  CHECK(strong_label(view) == "appLoadX = 1500.0 N");
  window.showRecord("10.1C");
  REQUIRE(window.page()->focusCell({"10.1C", 1, cell("reRaceTC2").variable, 0}));
  picture_of(view);
  CHECK(panel.view() == drawing::View::Traction);
  CHECK(strong_label(view) == "reRaceTC2 = 0.06");

  // A second land: the instance in focus is the one that is measured.
  window.showRecord("7.2.i");
  REQUIRE(window.page()->focusCell({"7.2.i", 2, cell("cageGsPos").variable, 0}));
  picture_of(view);
  CHECK(panel.view() == drawing::View::Lands);
  CHECK(view.currentFocus().instance == 2);
  CHECK(strong_label(view) == "cageGsPos[2] = 0.0085 m");

  // A field without a measure lights the body that it speaks of.
  focus("raceTemp1");
  const QImage outer = picture_of(view);
  CHECK(strong_label(view) == "raceTemp1 = 293.15 K");
  CHECK(pixels_like(outer, desktop::current_theme().accent) > 300);

  // A view chosen by hand stays for fields that belong to the same view.
  panel.chooseView(drawing::View::AdditionalView);
  focus("raceTemp2");
  CHECK(panel.view() == drawing::View::AdditionalView);
  focus("appLoadZ");
  CHECK(panel.view() == drawing::View::Loads);
}

TEST_CASE("drawing: follows typing; wrong value → last drawing is kept with the reason",
          "[gui][adrinput][drawing]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  DrawingPanel& panel = window.drawingPanel();
  window.showRecord("5A");
  auto* field = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("bReDia").variable));
  REQUIRE(field != nullptr);
  panel.drawNow();
  const QImage before = picture_of(panel.drawingView());
  replace_text(field, "0.0115");
  const auto radius = [&] {
    for (const drawing::Shape& shape : panel.drawingView().drawing().panes.at(0).shapes)
      if (shape.name == "ball") return shape.circles.at(0).radius;
    return 0.0;
  };
  CHECK(radius() == 0.5 * 0.0127);  // not at every key, but after a short pause
  CHECK(QTest::qWaitFor([&] { return radius() == 0.5 * 0.0115; }));
  const QImage after = picture_of(panel.drawingView());
  CHECK(differing(before, after) > 1000);
  replace_text(field, "-1");
  panel.drawNow();
  const QImage stale = picture_of(panel.drawingView());
  CHECK(radius() == 0.5 * 0.0115);
  CHECK(differing(after, stale) > 1000);
  replace_text(field, "0.0115");
  panel.drawNow();
  CHECK(differing(after, picture_of(panel.drawingView())) == 0);
}

TEST_CASE(
    "drawing: labels of all fields of the example decks are inside the picture and do not overlap",
    "[gui][adrinput][drawing][slow]") {
  test::use_qt();
  DrawingPanel panel;
  panel.resize(380, 740);
  panel.show();
  for (const deck::TemplateInfo& info : deck::templates()) {
    const deck::Deck deck = deck::new_deck(info.name);
    panel.setDeck(deck);
    panel.drawNow();
    for (const deck::RecordData& record : deck.records)
      for (const deck::VariableSpec& variable : deck::find_record(record.id)->variables) {
        panel.setFocusOn({record.id, std::string(variable.name), record.instance, 1});
        const QImage image = picture_of(panel.drawingView());
        INFO(info.name << ", record " << record.id << ", " << variable.name);
        check_labels(panel.drawingView());
        // Something is drawn: the ground is not all there is.
        const int ground = pixels_like(image, desktop::current_theme().surface);
        CHECK(ground < image.width() * image.height() * 98 / 100);
      }
  }
}

TEST_CASE("the drawing in dark and light, hidden and shown", "[gui][adrinput][drawing]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  DrawingPanel& panel = window.drawingPanel();
  panel.drawNow();
  const QImage light = picture_of(panel.drawingView());
  CHECK(light.pixelColor(4, 40).lightness() > 200);
  window.switchTheme();
  const QImage dark = picture_of(panel.drawingView());
  CHECK(dark.pixelColor(4, 40).lightness() < 80);
  // Search results keep their contrast, too.
  auto* query = window.findChild<QLineEdit*>("search");
  REQUIRE(query != nullptr);
  query->setText("breLen");
  auto* found = window.findChild<QListWidget*>("found");
  REQUIRE(found != nullptr);
  REQUIRE(found->count() > 0);
  const auto pale = [&] { return found->item(0)->foreground().color(); };
  CHECK(pale() == desktop::current_theme().muted);
  window.switchTheme();
  CHECK(pale() == desktop::current_theme().muted);
  window.switchTheme();
  const auto charts = window.findChildren<desktop::ChartView*>();
  CHECK(charts.size() >= 2);  // of the solution and of the lubricant
  for (desktop::ChartView* chart : charts)
    CHECK(chart->chartScene().backgroundBrush().color() == desktop::current_theme().surface);
  window.switchTheme();
  for (desktop::ChartView* chart : charts)
    CHECK(chart->chartScene().backgroundBrush().color() == desktop::current_theme().surface);
  auto* dock = window.findChild<QDockWidget*>("drawing-dock");
  REQUIRE(dock != nullptr);
  CHECK(dock->isVisible());
  CHECK_FALSE(dock->toggleViewAction()->shortcut().isEmpty());
  const int narrow = window.pageArea().width();
  dock->toggleViewAction()->trigger();
  QCoreApplication::processEvents();
  CHECK_FALSE(dock->isVisible());
  CHECK(window.pageArea().width() > narrow + 200);
}

TEST_CASE("adrinput: shortcut of a covered dock → raised first, then hidden",
          "[gui][adrinput][drawing]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  std::vector<QDockWidget*> docks;
  for (const char* name : {"drawing-dock", "solution-dock"}) {
    docks.push_back(window.findChild<QDockWidget*>(name));
    REQUIRE(docks.back() != nullptr);
    docks.back()->show();
  }
  const auto in_front = [](const QDockWidget* dock) {
    QCoreApplication::processEvents();
    return !dock->isHidden() && !dock->visibleRegion().isEmpty();
  };
  docks[1]->raise();
  REQUIRE(in_front(docks[1]));
  REQUIRE_FALSE(in_front(docks[0]));
  for (std::size_t i : {0U, 1U, 0U}) {
    INFO(i);
    docks[i]->toggleViewAction()->trigger();
    CHECK(in_front(docks[i]));
    CHECK_FALSE(docks[1 - i]->isHidden());
    CHECK(docks[i]->toggleViewAction()->isChecked());
  }
  docks[0]->toggleViewAction()->trigger();
  CHECK_FALSE(in_front(docks[0]));
  CHECK(docks[0]->isHidden());
  CHECK(in_front(docks[1]));
  docks[0]->toggleViewAction()->trigger();
  CHECK(in_front(docks[0]));
}

TEST_CASE("drawing: click on a dimension → focus in its field", "[gui][adrinput][drawing]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  DrawingPanel& panel = window.drawingPanel();
  DrawingView& view = panel.drawingView();
  window.showRecord("4");
  panel.drawNow();
  picture_of(view);
  // Looks for the measure of brgOD on the screen.
  QPoint place(-1, -1);
  for (int y = 0; y < view.height() && place.x() < 0; y += 3)
    for (int x = view.width() - 1; x >= 0; --x) {
      const drawing::Dimension* d = view.dimensionAt(QPointF(x, y));
      if (d == nullptr || d->variable != "brgOD") continue;
      place = {x, y};
      break;
    }
  REQUIRE(place.x() >= 0);
  QTest::mouseClick(&view, Qt::LeftButton, {}, place);
  CHECK(view.currentFocus().variable == "brgOD");
  picture_of(view);
  CHECK(strong_label(view).startsWith("brgOD"));
}

TEST_CASE("the drawing does not slow down typing or turning pages", "[gui][adrinput][drawing]") {
  test::use_qt();
  // Half of what a change of page may take, in processor time, which other programs do not use up;
  // the best of ten.
  DrawingPanel panel;
  panel.resize(380, 740);
  panel.show();
  for (const char* name : {"ball", "tapered", "spherical"}) {
    const deck::Deck deck = deck::new_deck(name);
    panel.setDeck(deck);
    for (const drawing::View view : drawing::views_of(deck)) {
      double best = 1e9;
      for (int i = 0; i < 10; ++i) {
        const std::clock_t start = std::clock();
        panel.chooseView(view);
        picture_of(panel.drawingView());
        best = std::min(best, 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      }
      INFO(name << ", " << drawing::title_of(view));
      CHECK(best < 25.0);  // ms
    }
  }
}

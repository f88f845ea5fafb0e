#include "adrplot/distinct_colours.hpp"
#include "adrplot/own_chart.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/range_dialog.hpp"
#include "desktop/chart_view.hpp"
#include "support/drops.hpp"
#include "support/message.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QTreeWidget>
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <functional>
#include <utility>

using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

void press(PlotWindow& window, const QString& button) {
  for (auto* action : window.findChild<QToolBar*>("buttons")->actions())
    if (action->text() == button) return action->trigger();
  FAIL("no button " << button.toStdString());
}

/// A page over three moments, whose panels `fill` adds.
PlotDocument document_of(std::function<void(desktop::ChartPage&)> fill) {
  PlotDocument document;
  document.path = "many";
  document.pages = {{"Many", PageKind::History}};
  document.build = [fill = std::move(fill)](int, const PageOptions&) {
    desktop::ChartPage page;
    page.x_title = "Time", page.x_unit = "s";
    page.x = {0.0, 1.0, 2.0};
    fill(page);
    return page;
  };
  return document;
}

/// Does a label have space for all of its lines?
bool is_whole(const QLabel& label) {
  return label.fontMetrics()
             .boundingRect(QRect(0, 0, label.width(), 5000), Qt::TextWordWrap, label.text())
             .height() <= label.height();
}

}  // namespace

TEST_CASE("plot_window: pages turn to both ends with a message there", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.show();
  window.addFile(test::synthetic_sol(SolKind::Element));
  CHECK(window.currentPage() == 1);
  press(window, "Prev Plot");
  CHECK(window.statusBar()->currentMessage() == "This is the first plot.");
  CHECK(window.currentPage() == 1);
  for (int page = 2; page <= 8; ++page) {
    press(window, "Next Plot");
    CHECK(window.currentPage() == page);
    CHECK(test::take_message(window).isEmpty());
    CHECK_FALSE(window.view().chartScene().plotAreas().empty());
    for (std::size_t i = 0; i < window.view().chartScene().plotAreas().size(); ++i)
      CHECK(window.view().chartScene().lineCount(i) > 0);
  }
  press(window, "Next Plot");
  CHECK(window.statusBar()->currentMessage() == "This is the last plot.");
  CHECK(window.currentPage() == 8);
  CHECK(window.windowTitle().contains("page 8 of 8"));
}

TEST_CASE("plot_window: Plot Number and the page tree go to a page", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Cage));
  press(window, "Plot Number");
  auto* question = window.findChild<QInputDialog*>("number");
  REQUIRE(question);
  CHECK(question->intMaximum() == 21);
  question->setIntValue(14);
  question->accept();
  CHECK(window.currentPage() == 14);
  auto* tree = window.findChild<QTreeWidget*>("pages");
  tree->setCurrentItem(tree->topLevelItem(0)->child(1));
  CHECK(window.currentPage() == 2);
}

TEST_CASE("plot_window: orbit page offers other pairs, history pages another abscissa", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Race));
  auto& scene = window.view().chartScene();
  auto* orbit = window.findChild<QComboBox*>("orbit");
  auto* abscissa = window.findChild<QComboBox*>("abscissa");
  window.showPage(2);
  CHECK(scene.page().x_unit == "rev");
  abscissa->setCurrentIndex(1);
  CHECK(scene.page().x_unit == "s");
  window.showPage(5);
  REQUIRE(scene.page().equal_axes);
  CHECK_FALSE(abscissa->isEnabled());
  CHECK(scene.page().x_title == "Y position");
  orbit->setCurrentIndex(1);
  CHECK(scene.page().x_title == "X position");
  CHECK(scene.page().panels[0].title == "Z position");
  CHECK(scene.plotAreas()[0].width() == Approx(scene.plotAreas()[0].height()));
  const QRectF& frame = scene.plotAreas()[0];  // equal axes
  CHECK(scene.abscissaAt(frame.right()) - scene.abscissaAt(frame.left()) ==
        Approx(scene.valueAt(0, frame.top()) - scene.valueAt(0, frame.bottom())));
}

TEST_CASE("plot_window: files → opened, rejected with a reason, truncated ones explained",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::SyntheticRun run;
  run.steps = 60;
  const std::string text = test::sol_text(test::synthetic_sol(SolKind::Element, run));
  test::write_text(base / "SOL1", text);
  test::write_text(base / "cut", text.substr(0, text.size() - 150));
  test::write_text(base / "letter.txt", "Dear reader,\nthis is no result file.\n");
  PlotWindow window;
  CHECK(window.openFile(base / "SOL1", {1, 40, 2}));
  CHECK(window.view().chartScene().page().x.size() == 20);
  auto* note = window.findChild<QLabel*>("note");
  CHECK(note->text().isEmpty());
  CHECK_FALSE(window.openFile(base / "letter.txt"));
  CHECK(test::take_message(window).contains("letter.txt"));
  CHECK(window.fileCount() == 1);
  CHECK_FALSE(window.openFile(base / "nowhere"));
  CHECK_FALSE(test::take_message(window).isEmpty());
  CHECK(window.openFile(base / "cut"));
  CHECK(note->text().contains("Incomplete file"));
  CHECK(window.view().chartScene().page().x.size() == 59);
  CHECK(window.fileCount() == 2);
  test::write_text(base / "cut", text);
  press(window, "Reload");
  CHECK(window.view().chartScene().page().x.size() == 60);
  CHECK(note->text().isEmpty());
}

TEST_CASE("plot_window: a dropped file asks for its range, several are opened at once", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::SyntheticRun run;
  run.steps = 30;
  const std::string text = test::sol_text(test::synthetic_sol(SolKind::Element, run));
  test::write_text(base / "SOL1", text);
  test::write_text(base / "SOL2", text);
  PlotWindow window;
  window.show();
  const auto drop = [&](const QStringList& names) {
    CHECK(test::drop_on(window, folder.path(), names));
  };
  drop({"SOL1", "SOL2"});
  CHECK(window.fileCount() == 2);
  drop({"SOL2"});
  auto* dialog = window.findChild<RangeDialog*>();
  REQUIRE(dialog != nullptr);
  dialog->reject();
  CHECK(window.fileCount() == 2);
  // Anywhere: on the chart, the tree of files, the menu, the tool bar, and a folder as well.
  QDir(folder.path()).mkdir("run");
  test::write_text(base / "run" / "SOL1", text);
  int more = 2;
  for (const QPoint& place : test::places_of(window)) {
    INFO(place.x() << ", " << place.y());
    CHECK(test::drop_on(window, folder.path(), {"SOL1", "run"}, place));
    CHECK(window.fileCount() > more);
    more = window.fileCount();
  }
  QMimeData words;
  words.setText("SOL1");
  CHECK_FALSE(test::drop_on(window, words, window.view().geometry().center()));
}

TEST_CASE("a file is opened by the question of its steps, however long the window lives meanwhile",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("SOL1").toStdString();
  test::SyntheticRun run;
  run.steps = 30;
  test::write_text(path, test::sol_text(test::synthetic_sol(SolKind::Element, run)));
  PlotWindow window;
  window.show();
  window.openFiles({folder.filePath("SOL1")});
  const QPointer<RangeDialog> dialog = window.findChild<RangeDialog*>();
  REQUIRE(dialog);
  bool there = false;
  QObject::connect(dialog, &QDialog::accepted, &window, [&] {
    // As the box of progress does, once a long file is read behind the same signal.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    there = !dialog.isNull();
  });
  dialog->accept();
  CHECK(there);
  CHECK(window.fileCount() == 1);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  CHECK(dialog.isNull());
}

TEST_CASE("range_dialog: starts with the whole run and keeps the end behind the start", "[gui]") {
  test::use_qt();
  RangeDialog dialog("SOL1", 9000);
  dialog.setAttribute(Qt::WA_DeleteOnClose, false);
  CHECK(dialog.range().from == 1);
  CHECK(dialog.range().to == results::SolRange{}.to);  // the end, also when the file grows
  CHECK(dialog.findChild<QLabel*>("count")->text() == "9000 of 9000 stored steps");
  CHECK(dialog.range().every == 1);
  dialog.findChild<QSpinBox*>("to")->setValue(100);
  dialog.findChild<QSpinBox*>("from")->setValue(8000);
  CHECK(dialog.range().to == 8000);
  dialog.findChild<QSpinBox*>("every")->setValue(10);
  CHECK(dialog.range().every == 10);
}

TEST_CASE("plot_window: Save JPG writes the page and proposes the next number", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  PlotWindow window;
  window.show();
  window.addFile(test::synthetic_sol(SolKind::Element));
  press(window, "Save JPG");
  auto* dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog);
  const QString name = folder.filePath("wave.jpg");
  emit dialog->fileSelected(name);
  dialog->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  const QImage image(name);
  CHECK(image.width() > 480);
  CHECK(distinct_colours(image) > 20);
  press(window, "Save JPG");
  dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog);
  REQUIRE(dialog->selectedFiles().size() == 1);
  CHECK(dialog->selectedFiles().front().endsWith("wave-2.jpg"));
  emit dialog->fileSelected("/proc/no/such/folder/x.jpg");
  CHECK(test::take_message(window).contains("cannot be written"));
  // Lines and text, too; any other name is rejected with the valid ones.
  for (const auto& [ending, begins] : {std::pair{"svg", "<?xml"}, std::pair{"pdf", "%PDF"}}) {
    const QString page = folder.filePath(QString("wave.") + ending);
    emit dialog->fileSelected(page);
    QFile file(page);
    REQUIRE(file.open(QIODevice::ReadOnly));
    CHECK(file.read(5).startsWith(begins));
    CHECK(file.size() > 5000);
  }
  emit dialog->fileSelected(folder.filePath("wave.bmp"));
  CHECK(test::take_message(window).contains(".svg or .pdf"));
}

TEST_CASE("plot_window: dark theme → pictures in files and in the clipboard are light",
          "[gui][adrplot]") {
  test::use_qt();
  QTemporaryDir folder;
  PlotWindow window;
  window.show();
  window.addFile(test::synthetic_sol(SolKind::Element));
  window.switchTheme();
  REQUIRE(desktop::current_theme().kind == desktop::ThemeKind::Dark);
  const auto is_light = [](const QImage& image) {
    return !image.isNull() && qGray(image.pixel(2, 2)) > 200 &&
           qGray(image.pixel(image.width() - 3, image.height() - 3)) > 200;
  };
  CHECK_FALSE(is_light(window.view().chartScene().image({600, 400})));
  CHECK(window.exportTo(folder.filePath("page.png"), false));
  CHECK(is_light(QImage(folder.filePath("page.png"))));
  CHECK(window.exportTo(folder.filePath("all.png"), true));
  CHECK(is_light(QImage(folder.filePath("all-02.png"))));
  press(window, "Save JPG");
  auto* dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog);
  emit dialog->fileSelected(folder.filePath("saved.png"));
  dialog->close();
  CHECK(is_light(QImage(folder.filePath("saved.png"))));
  window.copyPicture();
  CHECK(is_light(QGuiApplication::clipboard()->image()));
  window.switchTheme();
}

TEST_CASE("plot_window: figure for print → dialog with preview, then a file of that size",
          "[gui][adrplot]") {
  test::use_qt();
  QTemporaryDir folder;
  PlotWindow window;
  window.show();
  window.addFile(test::synthetic_sol(SolKind::Element));
  window.exportFigure();
  auto* dialog = window.findChild<QDialog*>("figure");
  REQUIRE(dialog);
  auto* width = dialog->findChild<QDoubleSpinBox*>("width");
  auto* letters = dialog->findChild<QDoubleSpinBox*>("letters");
  auto* preview = dialog->findChild<QLabel*>("preview");
  auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  REQUIRE((width && letters && preview && ok));
  letters->setValue(8.0);
  dialog->findChild<QPushButton*>("two-columns")->click();
  CHECK(width->value() == 170.0);
  dialog->findChild<QPushButton*>("one-column")->click();
  CHECK(width->value() == 85.0);
  CHECK_FALSE(preview->pixmap(Qt::ReturnByValue).isNull());
  letters->setValue(24.0);  // axes and legend do not fit
  CHECK_FALSE(ok->isEnabled());
  CHECK(preview->text().contains("give at most"));
  letters->setValue(8.0);
  REQUIRE(ok->isEnabled());
  ok->click();
  auto* files = window.findChild<QFileDialog*>("export");
  REQUIRE(files);
  emit files->fileSelected(folder.filePath("figure.svg"));
  QFile svg(folder.filePath("figure.svg"));
  REQUIRE(svg.open(QIODevice::ReadOnly));
  CHECK(svg.readAll().contains("width=\"85mm\""));
  emit files->fileSelected(folder.filePath("no/such/figure.svg"));
  CHECK_FALSE(test::take_message(window).isEmpty());
}

TEST_CASE("plot_window: the values of all panels under the mouse are read whole, at any size",
          "[gui]") {
  test::use_qt();
  PlotWindow window;
  for (const SolKind kind : {SolKind::Element, SolKind::Cage, SolKind::Race, SolKind::Power})
    window.addFile(test::synthetic_sol(kind));
  window.show();
  auto* label = window.findChild<QLabel*>("readout");
  REQUIRE(label != nullptr);
  auto* tree = window.findChild<QTreeWidget*>("pages");
  for (const QSize size : {QSize(1264, 770), QSize(700, 450)}) {
    window.resize(size);
    for (int file = 0; file < window.fileCount(); ++file)
      for (int page = 0; page < tree->topLevelItem(file)->childCount(); ++page) {
        tree->setCurrentItem(tree->topLevelItem(file)->child(page));
        // The new height of the line reaches the window's layout in a second round.
        for (int round = 0; round < 2; ++round) QCoreApplication::processEvents();
        auto& scene = window.view().chartScene();
        if (scene.plotAreas().empty() || scene.page().equal_axes) continue;
        const QRectF& area = scene.plotAreas().back();
        for (const double part : {0.1, 0.37, 0.8}) {
          const QPointF place(area.left() + part * area.width(), area.center().y());
          emit window.view().readoutChanged(scene.readoutParts(place));
          INFO(window.windowTitle().toStdString() << ": " << label->text().toStdString());
          CHECK_FALSE(label->text().isEmpty());
          const QRect needed = label->fontMetrics().boundingRect(QRect(0, 0, label->width(), 1000),
                                                                 Qt::TextWordWrap, label->text());
          CHECK(needed.height() <= label->height());
          CHECK(needed.width() <= label->width());
          INFO("window " << window.width() << " x " << window.height() << ", at least "
                         << window.minimumSizeHint().height() << ", chart "
                         << window.view().height() << ", readout " << label->height());
          CHECK(window.rect().contains(QRect(label->mapTo(&window, QPoint()), label->size())));
        }
      }
  }
}

TEST_CASE("plot_window: chart of sixty curves → keeps most of the window, omitted values counted",
          "[gui]") {
  test::use_qt();
  PlotWindow window;
  PlotDocument document = document_of([](desktop::ChartPage& page) {
    page.panels = {{"Load", "N", {}}};
    for (int c = 0; c < 60; ++c)
      page.panels[0].curves.push_back(
          {"rolling element " + std::to_string(c + 1), {1.0 + c, 2.0 + c, 3.0 + c}, {}});
  });
  std::vector<CurvePick> picks;
  for (std::size_t c = 0; c < 60; ++c) picks.push_back({&document, 1, 0, c});
  window.addChart(picks, Combine::Overlay);
  window.show();
  auto* label = window.findChild<QLabel*>("readout");
  auto& scene = window.view().chartScene();
  const auto read = [&](QSize size) {
    window.resize(size);
    QCoreApplication::processEvents();
    const QRectF area = scene.plotAreas().front();
    emit window.view().readoutChanged(scene.readoutParts(area.center()));
    CHECK(label->height() <= window.height() / 5 + 2);
    CHECK(is_whole(*label));
    return label->text();
  };
  const QString small = read({700, 450}), large = read({1264, 770});
  CHECK(QRegularExpression(" … [0-9]+ more$").match(small).hasMatch());
  CHECK(large.size() > small.size());
  // Without most of them the line has the height of the rest.
  const int high = label->height();
  for (int c = 1; c < 60; ++c) scene.showCurve(0, static_cast<std::size_t>(c), false);
  emit window.view().curvesChanged();
  CHECK(label->height() < high / 2);
  CHECK(read({1264, 770}).contains("rolling element 1"));
  CHECK(label->text().endsWith(" 2 N"));
}

TEST_CASE("plot_window: omitted values are counted, others are complete", "[gui]") {
  test::use_qt();
  PlotWindow window;
  PlotDocument document = document_of([](desktop::ChartPage& page) {
    for (const char* title : {"Load", "Speed, of the race", "Force"}) {
      page.panels.push_back({title, "N", {}});
      for (int c = 0; c < 40; ++c)
        page.panels.back().curves.push_back(
            {fmt::format("element {}, case a, outer", c + 1), {1.0, 2.0, 3.0}, {}});
    }
  });
  std::vector<CurvePick> picks;
  for (std::size_t c = 0; c < 3; ++c) picks.push_back({&document, 1, c, 0});
  window.addChart(picks, Combine::Overlay);
  window.show();
  window.resize({700, 450});
  QCoreApplication::processEvents();
  window.view().showPage(document.build(1, {}));
  auto* label = window.findChild<QLabel*>("readout");
  auto& scene = window.view().chartScene();
  const QStringList all = scene.readoutParts(scene.plotAreas().back().center());
  REQUIRE(all.size() == 120);
  CHECK(all.join("") == scene.readout(scene.plotAreas().back().center()));
  emit window.view().readoutChanged(all);
  const auto told = label->text().count(" N");
  CHECK(told > 0);
  CHECK(label->text().endsWith(QString(" … %1 more").arg(120 - told)));
  CHECK(is_whole(*label));
  // A smaller window has room for less of the same; other curves have other values.
  window.resize({500, 420});
  QCoreApplication::processEvents();
  CHECK(is_whole(*label));
  CHECK(label->text().endsWith(QString(" … %1 more").arg(120 - label->text().count(" N"))));
  emit window.view().curvesChanged();
  CHECK(label->text().isEmpty());
  // No value, and a line that is hardly there.
  emit window.view().readoutChanged({});
  CHECK(label->text().isEmpty());
  label->setFixedWidth(20);
  emit window.view().readoutChanged({});
  CHECK(label->text().isEmpty());
  emit window.view().readoutChanged(all);
  constexpr int kLeast = 100;  // for which it is written at least
  CHECK_FALSE(label->text().isEmpty());
  CHECK(label->fontMetrics()
            .boundingRect(QRect(0, 0, kLeast, 5000), Qt::TextWordWrap, label->text())
            .height() <= label->height());
  label->setMinimumWidth(1);
  label->setMaximumWidth(QWIDGETSIZE_MAX);
  QCoreApplication::processEvents();
  // One value without room is shortened, and nothing more is promised.
  emit window.view().readoutChanged({QString("a name of the run's own ").repeated(200) + "2 N"});
  CHECK(label->text().contains("…"));
  CHECK_FALSE(label->text().contains("more"));
  CHECK(is_whole(*label));
}

TEST_CASE("plot_window: the wheel zooms and the pointer reads values", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.show();
  window.addFile(test::synthetic_sol(SolKind::Element));
  auto& view = window.view();
  auto& scene = view.chartScene();
  const QPoint middle = view.mapFromScene(scene.plotAreas()[1].center());
  QWheelEvent wheel(middle, view.viewport()->mapToGlobal(middle), {}, {0, 240}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(view.viewport(), &wheel);
  CHECK(scene.viewHigh() - scene.viewLow() ==
        Approx(3.0 * 0.64).epsilon(1e-3));  // two notches of 0.8
  QSignalSpy readout(&view, &desktop::ChartView::readoutChanged);
  // Sent directly: a headless platform has no pointer that QTest could move.
  const QPointF there = middle + QPoint(3, 3);
  QMouseEvent move(QEvent::MouseMove, there, view.viewport()->mapToGlobal(there), Qt::NoButton,
                   Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(view.viewport(), &move);
  REQUIRE(readout.count() > 0);
  CHECK(readout.back().front().toStringList().join("").contains("Radial"));
  QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, middle);
  CHECK(scene.viewHigh() == Approx(3.0).epsilon(1e-6));
}

TEST_CASE("plot_window: axes that a page wants logarithmic are, until another is chosen", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path path =
      std::filesystem::path(folder.path().toStdString()) / "ACCURACY.json";
  test::write_text(path, R"({"screening": [{"curve": "rk4", "seconds": 0.5, "error": 1e-3},
                                           {"curve": "rk4", "seconds": 0.2, "error": 1e-2}]})");
  PlotWindow window;
  REQUIRE(window.openFile(path));
  const auto page = [&window] { return window.view().chartScene().page(); };
  CHECK(page().log_x);
  CHECK(page().panels.at(0).log);
  CHECK(page().note.find("ogarithmic") == std::string::npos);  // the menu may make it untrue
  QAction* values = nullptr;
  for (QAction* action : window.findChildren<QAction*>())
    if (action->text() == "Logarithmic &Values") values = action;
  REQUIRE(values);
  CHECK(values->isChecked());
  values->trigger();
  CHECK_FALSE(page().panels.at(0).log);
  CHECK(page().log_x);
}

TEST_CASE("plot_window: the picture that is copied is the chart that is seen", "[gui]") {
  test::use_qt();
  PlotWindow window;
  QApplication::clipboard()->setText("nothing yet");
  window.copyPicture();  // without a file there is none
  CHECK(QApplication::clipboard()->text() == "nothing yet");
  window.resize(1000, 700);
  window.addFile(test::synthetic_sol(results::SolKind::Element));
  window.show();
  for (const int page : {1, 6}) {
    window.showPage(page);
    window.copyPicture();
    const QImage copied = QApplication::clipboard()->image();
    CHECK(copied.size() == window.view().viewport()->size());
    const QImage seen = window.view().viewport()->grab().toImage().convertToFormat(copied.format());
    REQUIRE(seen.size() == copied.size());
    int unlike = 0;
    for (int y = 0; y < seen.height(); ++y)
      for (int x = 0; x < seen.width(); ++x)
        unlike += std::abs(qGray(seen.pixel(x, y)) - qGray(copied.pixel(x, y))) > 60 ? 1 : 0;
    INFO("page " << page << ": " << unlike << " pixels differ");
    CHECK(unlike < seen.width() * seen.height() / 1000);
  }
}

TEST_CASE("plot_window: marked statistics are copied as text, and all of them by a command",
          "[gui][adrplot]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(SolKind::Element));
  QClipboard* const clipboard = QApplication::clipboard();
  clipboard->setText("nothing yet");
  window.copyCursorReport();  // without cursors there are none
  CHECK(clipboard->text() == "nothing yet");
  desktop::ChartView& view = window.view();
  const std::vector<double>& x = view.chartScene().page().x;
  view.setCursorAbscissa(0, x[x.size() / 4]);
  view.setCursorAbscissa(1, x[x.size() / 2]);
  window.copyCursorReport();
  QString report = view.cursorReport();
  REQUIRE(report.contains(QChar(0x2212)));  // "B − A"
  CHECK(clipboard->text() == report.replace(QChar(0x2212), '-'));
  CHECK(clipboard->text().count('\n') >= 2);
  auto* label = window.findChild<QLabel*>("cursors");
  REQUIRE(label);
  label->setSelection(0, label->text().indexOf('\n') + 4);
  window.copyPicture();
  CHECK(clipboard->image().isNull());
  CHECK(clipboard->text() == report.left(report.indexOf('\n') + 4));
  label->setSelection(0, 0);
  window.copyPicture();
  CHECK_FALSE(clipboard->image().isNull());
}

#include "agore/agore_window.hpp"
#include "agore/example_run.hpp"
#include "agore/film_dialog.hpp"
#include "agore/short_run.hpp"
#include "agore/shown_window.hpp"
#include "base/errors.hpp"
#include "desktop/mp4_writer.hpp"
#include "desktop/project.hpp"
#include "support/drops.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;
using namespace adore::agore;
using test::pixels_of;
using test::short_run;

namespace {

void click(AgoreWindow& window, const char* button) {
  window.findChild<QPushButton*>(button)->click();
}

QAction* menu_action(AgoreWindow& window, const QString& text) {
  for (auto* action : window.findChildren<QAction*>())
    if (action->text().remove('&') == text) return action;
  return nullptr;
}

}  // namespace

TEST_CASE("agore_window: play, frame and pause move through the frames", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.show();
  CHECK_FALSE(window.findChild<QPushButton*>("play")->isEnabled());
  window.setAnimation(prepare(test::synthetic_sol8(short_run())));
  REQUIRE(window.frameCount() == 120);
  click(window, "frame");
  click(window, "frame");
  CHECK(window.currentFrame() == 2);
  click(window, "frameBack");
  CHECK(window.currentFrame() == 1);
  window.setFrame(0);
  click(window, "frameBack");
  CHECK(window.currentFrame() == 0);

  window.findChild<QComboBox*>("speed")->setCurrentText("100");
  click(window, "play");
  CHECK(window.playing());
  CHECK(QTest::qWaitFor([&] { return window.currentFrame() > 3; }, 20000));
  click(window, "pause");
  CHECK_FALSE(window.playing());
  const auto stopped = window.currentFrame();
  QTest::qWait(80);
  CHECK(window.currentFrame() == stopped);

  click(window, "playBack");
  CHECK(QTest::qWaitFor([&] { return !window.playing(); }, 20000));
  CHECK(window.currentFrame() == 0);
  window.findChild<QComboBox*>("speed")->setCurrentText("1000");
  click(window, "play");
  CHECK(QTest::qWaitFor([&] { return !window.playing(); }, 20000));
  CHECK(window.currentFrame() == 119);
}

TEST_CASE("agore_window: movie format follows the file name", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.show();
  window.setAnimation(prepare(test::synthetic_sol8(short_run(20))));
  menu_action(window, "Save Movie...")->trigger();
  auto* range = window.findChild<MovieDialog*>("filmRange");
  REQUIRE(range != nullptr);
  CHECK(range->windowTitle() == "Save Movie");
  range->accept();
  auto* dialog = window.findChild<QFileDialog*>("film");
  REQUIRE(dialog != nullptr);
  CHECK(dialog->defaultSuffix() == (desktop::has_ffmpeg() ? "mp4" : "gif"));
  for (const QString& filter : dialog->nameFilters()) {
    emit dialog->filterSelected(filter);
    const QString name = dialog->selectedFiles().value(0);
    INFO(filter.toStdString() << ": " << name.toStdString());
    for (const char* suffix : {"gif", "avi", "mp4"})
      CHECK(name.endsWith(window.proposedName(suffix)) == filter.contains(QString("*.") + suffix));
  }
  dialog->close();
}

TEST_CASE("agore_window: movie from a frame or time to another → length displayed", "[gui]") {
  test::use_qt();
  QTemporaryDir base;
  const QString run = base.filePath("shaft at 9000");
  REQUIRE(QDir().mkdir(run));
  const std::filesystem::path sol8 = (run + "/SOL8").toStdString();
  test::write_text(sol8, test::sol8_text(test::synthetic_sol8(short_run(20))));
  AgoreWindow window;
  window.resize(500, 400);
  window.show();
  REQUIRE(window.openFile(sol8));
  CHECK(window.proposedName("gif") == "shaft at 9000-bearing.gif");
  CHECK(window.windowTitle().startsWith("shaft at 9000/SOL8"));
  window.saveMovie();
  auto* range = window.findChild<MovieDialog*>("filmRange");
  REQUIRE(range != nullptr);
  auto* words = range->findChild<QLabel*>("filmLength");
  CHECK(words->text().startsWith("20 pictures at 25 per second: length 800 ms."));
  CHECK(QRegularExpression("Size: about [0-9.]+ MB as MP4, [0-9.]+ MB as GIF, [0-9.]+ MB as AVI")
            .match(words->text())
            .hasMatch());
  auto* from = range->findChild<QSpinBox*>("filmFrom");
  auto* until = range->findChild<QDoubleSpinBox*>("filmToTime");
  const auto& time = window.picture()->animation().time;
  CHECK(range->findChild<QSpinBox*>("filmTo")->value() == 20);
  from->setValue(5);
  CHECK(range->findChild<QDoubleSpinBox*>("filmFromTime")->value() == Approx(1e3 * time[4]));
  until->setValue(1e3 * (0.6 * time[11] + 0.4 * time[12]));  // a time of no frame: the next to it
  CHECK(range->findChild<QSpinBox*>("filmTo")->value() == 12);
  CHECK(range->first() == 4);
  CHECK(range->last() == 11);
  CHECK(words->text().startsWith("8 pictures"));
  range->findChild<QSpinBox*>("filmEvery")->setValue(3);
  range->findChild<QSpinBox*>("filmRate")->setValue(10);
  CHECK(words->text().startsWith("3 pictures at 10 per second: length 300 ms."));
  auto* size = range->findChild<QComboBox*>("filmSize");
  CHECK(size->currentText().contains("as displayed"));
  const QString small = words->text();
  size->setCurrentIndex(size->findData(QSize(1920, 1080)));
  CHECK(words->text() != small);
  const MovieSettings chosen = range->choice();
  CHECK(chosen.every == 3);
  CHECK(chosen.size == QSize(1920, 1080));
  auto* next = range->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  CHECK(next->isEnabled());
  from->setValue(15);
  CHECK(words->text().contains("frame (15) is after the last frame (12)"));
  CHECK_FALSE(next->isEnabled());
  range->reject();
  // Saved files are reported, and no others.
  const QString film = run + "/part.avi", pictures = run + "/pictures";
  REQUIRE(window.writeMovie(film, 5, 12));
  CHECK(window.statusBar()->isVisible());
  CHECK(window.statusBar()->currentMessage() == "Saved " + film + ": 8 pictures.");
  REQUIRE(window.writeMovie(film, MovieSettings{4, 11, 3, 10, QSize(640, 480)}));
  CHECK(window.statusBar()->currentMessage() ==
        "Saved " + film + ": 3 pictures, one of every 3 frames.");
  REQUIRE(window.writeMovie(pictures, 19));
  CHECK(window.statusBar()->currentMessage() == "Saved 2 numbered pictures in " + pictures + ".");
  CHECK(QDir(pictures).entryList({"*.png"}) ==
        QStringList{"SOL8-frame-00019.png", "SOL8-frame-00020.png"});
  window.statusBar()->clearMessage();
  CHECK_FALSE(window.statusBar()->isVisible());
  // Faster than players are: it lasts as long as the window plays.
  for (const auto& [rate, count] : {std::pair{"50", 20}, {"100", 10}, {"250", 4}, {"1000", 1}}) {
    window.findChild<QComboBox*>("speed")->setCurrentText(rate);
    INFO(rate);
    REQUIRE(window.writeMovie(film));
    const QString said = window.statusBar()->currentMessage();
    CHECK(said.startsWith(QString("Saved %1: %2 picture").arg(film).arg(count)));
    CHECK(said.contains("one of every") == (count < 20));
  }
}

TEST_CASE("agore_window: project → its runs in the menu, missing ones listed, damaged file kept",
          "[gui][project]") {
  test::use_qt();
  QTemporaryDir base;
  const std::filesystem::path folder = base.path().toStdString();
  for (const char* run : {"first", "second"}) {
    std::filesystem::create_directories(folder / run);
    test::write_text(folder / run / "SOL8",
                     test::sol8_text(test::synthetic_sol8(short_run(run[0] == 'f' ? 20 : 10))));
  }
  desktop::Project project = desktop::Project::open_or_create(folder);
  for (const char* run : {"gone", "first", "second"}) project.add_run(folder / run);
  project.save();
  AgoreWindow window;
  window.show();
  REQUIRE(window.openFile(project.file()));
  CHECK(test::take_message(window).isEmpty());  // the menu shows it
  CHECK(window.statusBar()->currentMessage().contains("gone"));
  CHECK(window.frameCount() == 20);
  const QList<QAction*> runs = window.findChild<QMenu*>("projectMenu")->actions();
  REQUIRE(runs.size() == 3);
  CHECK(runs[0]->text() == "gone (missing)");
  CHECK_FALSE(runs[0]->isEnabled());
  runs[2]->trigger();
  CHECK(window.frameCount() == 10);
  test::write_text(project.file(), "{\"format\": \"adore-pro");
  CHECK_FALSE(window.openFile(project.file()));
  CHECK(test::take_message(window).contains("damaged"));
  CHECK(window.frameCount() == 10);
}

TEST_CASE("agore_window: selected additional view → exchanged with the first view", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8(short_run(5))));
  window.setView(View::Bearing);
  window.setAdditionalView(View::Cage, true);
  window.setAdditionalView(View::Pocket, true);
  window.setView(View::Pocket);
  CHECK(window.options().view == View::Pocket);
  REQUIRE(window.options().beside.size() == 2);
  CHECK(window.options().beside[0].view == View::Cage);
  CHECK(window.options().beside[1].view == View::Bearing);
}

TEST_CASE("agore_window: active run → reloaded at the same time", "[gui]") {
  test::use_qt();
  QTemporaryDir base;
  const std::filesystem::path sol8 = base.filePath("SOL8").toStdString();
  test::write_text(sol8, test::sol8_text(test::synthetic_sol8(short_run(20))));
  AgoreWindow window;
  REQUIRE(window.openFile(sol8));
  window.setView(View::Cage);
  window.setTrails(true);
  window.setFrame(7);
  const double moment = window.picture()->animation().time[7];
  test::write_text(sol8, test::sol8_text(test::synthetic_sol8(short_run(35))));
  menu_action(window, "Reload")->trigger();
  REQUIRE(window.frameCount() == 35);
  // To the frame next to that time.
  const auto& time = window.picture()->animation().time;
  CHECK(window.currentFrame() > 0);
  CHECK(time[window.currentFrame()] == Approx(moment).margin(0.5 * (time[1] - time[0])));
  CHECK(window.options().view == View::Cage);
  CHECK(window.options().trails);
  CHECK(window.statusBar()->currentMessage().startsWith("Reloaded: 35 frames"));
  // A file that is gone leaves what is shown.
  std::filesystem::remove(sol8);
  menu_action(window, "Reload")->trigger();
  CHECK_FALSE(test::take_message(window).isEmpty());
  CHECK(window.frameCount() == 35);
}

TEST_CASE("agore_window: a picture is saved as pixels or as lines and text, by its name", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  AgoreWindow window;
  test::show_painted(window);
  click(window, "save");
  auto* dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog);
  for (const auto& [ending, begins] : {std::pair{"jpg", "\xff\xd8"}, std::pair{"png", "\x89PNG"},
                                       std::pair{"svg", "<?xml"}, std::pair{"pdf", "%PDF"}}) {
    const QString name = folder.filePath(QString("moment.") + ending);
    emit dialog->fileSelected(name);
    QFile file(name);
    INFO(ending);
    REQUIRE(file.open(QIODevice::ReadOnly));
    CHECK(file.read(5).startsWith(begins));
    CHECK(file.size() > 5000);
  }
  emit dialog->fileSelected(folder.filePath("moment.bmp"));
  CHECK(test::take_message(window).contains(".svg or .pdf"));
  CHECK_FALSE(QFile::exists(folder.filePath("moment.bmp")));
}

TEST_CASE("agore_window: dark theme → saved pictures are light", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  AgoreWindow window;
  test::show_painted(window);
  window.switchTheme();
  REQUIRE(desktop::current_theme().kind == desktop::ThemeKind::Dark);
  click(window, "save");
  auto* dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog);
  emit dialog->fileSelected(folder.filePath("moment.png"));
  dialog->close();
  const QImage image(folder.filePath("moment.png"));
  REQUIRE_FALSE(image.isNull());
  CHECK(qGray(image.pixel(2, 2)) > 200);
  window.switchTheme();
}

TEST_CASE("agore_window: the time bar fills and can be clicked", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.show();
  window.setAnimation(prepare(test::synthetic_sol8(short_run(101))));
  auto* canvas = window.findChild<PictureWidget*>();
  const QRectF bar = MotionPicture::timeBar(canvas->rect());
  const auto& t = desktop::current_theme();
  const auto filled = [&] {
    const QImage image =
        window.picture()->image(canvas->size(), window.currentFrame(), window.options());
    return pixels_of(image, bar.toRect().adjusted(8, 4, -8, -4), t.accent);
  };
  CHECK(window.picture()->progress(50) == Approx(0.5));
  const int at_start = filled();
  QTest::mouseClick(canvas, Qt::LeftButton, {},
                    QPointF(bar.left() + 0.5 * bar.width(), bar.center().y()).toPoint());
  CHECK(std::abs(static_cast<int>(window.currentFrame()) - 50) <= 1);
  const int at_middle = filled();
  window.setFrame(100);
  CHECK(at_middle > at_start);
  CHECK(filled() > 1.8 * at_middle);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(300, 300));  // no action outside the bar
  CHECK(window.currentFrame() == 100);
}

TEST_CASE("agore_window: open dialog → default is the largest number of steps", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  for (int time = 0; time < 2; ++time) {
    window.askForFile();
    auto* question = window.findChild<QInputDialog*>("number");
    REQUIRE(question);
    CHECK(question->intValue() == static_cast<int>(results::MotionFile::kMostFrames));
    question->setIntValue(5);
    question->reject();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_CASE("agore_window: each command changes the picture as requested", "[gui][slow]") {
  test::use_qt();
  for (const std::string& type : test::kTypes) {
    AgoreWindow window;
    window.resize(900, 560);
    window.show();
    REQUIRE(window.openFile(test::example_run(type) / "RESULTS.h5"));
    QCoreApplication::processEvents();  // the line of findings needs its height
    MotionPicture picture(open_motion(test::example_run(type) / "RESULTS.h5"));
    auto* canvas = window.findChild<PictureWidget*>();
    REQUIRE(canvas != nullptr);
    for (const char* const view :
         {"bearing", "cage", "pocket", "element", "race", "flange", "section", "3d"})
      for (const char* const race : {"outer", "inner"})
        for (const int element : {1, 5, 99})
          for (const char* const beside : {"", "flange", "race,pocket"}) {
            ViewOptions asked;
            asked.view = parse_view(view, race);
            asked.flange_race = std::string(race) == "outer" ? 0 : 1;
            asked.element = element;
            asked.beside = parse_additional_views(beside, race);
            asked.scale = window.options().scale;
            INFO(type << ": --view " << view << " --race " << race << " --element " << element
                      << " --beside " << beside);
            std::string refused;
            QImage wanted;
            try {
              wanted = picture.image(canvas->size(), window.currentFrame(), asked);
            } catch (const InputError& error) {
              refused = error.what();
            }
            CHECK(window.applyViewOptions(asked) == refused.empty());
            if (!refused.empty()) {
              CHECK(test::take_message(window).toStdString() == refused);
              continue;
            }
            CHECK(canvas->grab().toImage().convertToFormat(QImage::Format_RGB32) == wanted);
          }
  }
}

TEST_CASE("agore_window: view changed → zoom is reset", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8(short_run(20))));
  menu_action(window, "Zoom In")->trigger();
  REQUIRE(window.options().zoom > 1.0);
  menu_action(window, "Bearing Motion")->trigger();  // the same one
  CHECK(window.options().zoom > 1.0);
  menu_action(window, "Cage Motion")->trigger();
  CHECK(window.options().zoom == 1.0);
  CHECK(window.options().pan == QPointF(0.0, 0.0));
}

TEST_CASE("agore_window: views by menu, with numbers asked and remembered", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8(short_run(20))));
  menu_action(window, "Cage Motion")->trigger();
  CHECK(window.options().view == View::Cage);
  CHECK(window.windowTitle().contains("Cage motion"));
  menu_action(window, "Pocket Interaction...")->trigger();
  auto* question = window.findChild<QInputDialog*>("number");
  REQUIRE(question);
  CHECK(question->intMaximum() == 12);
  question->setIntValue(7);
  question->accept();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  CHECK(window.options().view == View::Pocket);
  CHECK(window.options().element == 7);
  menu_action(window, "RE Motion...")->trigger();
  question = window.findChild<QInputDialog*>("number");
  REQUIRE(question);
  CHECK(question->intValue() == 7);
  question->reject();
  menu_action(window, "Outer")->trigger();
  CHECK(window.options().view == View::OuterRace);
  menu_action(window, "Inner Race...")->trigger();
  CHECK(test::take_message(window).contains("no flanges"));  // balls
  CHECK(window.options().view == View::OuterRace);
  menu_action(window, "Axial Section...")->trigger();
  CHECK(test::take_message(window).contains("RESULTS.h5"));
  menu_action(window, "Contact Load")->trigger();
  CHECK(window.options().colour == ColourBy::Load);
  menu_action(window, "About AGORE")->trigger();
  CHECK(test::take_message(window).contains("0.1"));
  menu_action(window, "× 10")->trigger();
  CHECK(window.options().exaggeration == 10.0);
}

TEST_CASE("agore_window: files → opened, thinned to the selected steps, rejected with a reason",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  const std::string text = test::sol8_text(test::synthetic_sol8(short_run(40)));
  test::write_text(base / "SOL8", text);
  test::write_text(base / "cut", text.substr(0, text.size() - 300));
  test::write_text(base / "other", "nothing of ours\n");
  AgoreWindow window;
  CHECK(window.openFile(base / "SOL8", 15));  // the whole run, with a remark on the omitted frames
  CHECK(window.frameCount() == 14);
  const Animation thinned = open_motion(base / "SOL8", 15);
  CHECK(thinned.frame(13).step == open_motion(base / "SOL8").frame(39).step);
  CHECK(thinned.source.find("one in 3 of the 40") != std::string::npos);
  CHECK(window.openFile(base / "SOL8"));
  CHECK(window.frameCount() == 40);
  CHECK_FALSE(window.openFile(base / "other"));
  CHECK(test::take_message(window).contains("other"));
  CHECK(window.frameCount() == 40);  // the old one stays
  CHECK(window.openFile(base / "cut"));
  CHECK(window.frameCount() == 39);
  CHECK(test::take_message(window).contains("Incomplete file"));
}

TEST_CASE("agore_window: a file dropped on it is opened, several are not", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::write_text(base / "SOL8", test::sol8_text(test::synthetic_sol8(short_run(20))));
  AgoreWindow window;
  window.show();
  const auto drop = [&](const QStringList& names) {
    CHECK(test::drop_on(window, folder.path(), names));
  };
  drop({"SOL8", "SOL9"});
  CHECK(test::take_message(window).contains("one file"));
  CHECK(window.frameCount() == 0);
  drop({"nowhere"});
  CHECK(test::take_message(window).contains("nowhere"));
  drop({"SOL8"});
  CHECK(test::take_message(window).isEmpty());
  CHECK(window.frameCount() == 20);
  for (const QPoint& place : test::places_of(window)) {  // also with a picture in it
    INFO(place.x() << ", " << place.y());
    CHECK(test::drop_on(window, folder.path(), {"SOL8"}, place));
  }
  // The folder of a run is its animation.
  std::filesystem::create_directories(base / "run");
  std::filesystem::create_directories(base / "empty");
  test::write_text(base / "run/SOL8", test::sol8_text(test::synthetic_sol8(short_run(12))));
  drop({"run"});
  CHECK(test::take_message(window).isEmpty());
  CHECK(window.frameCount() == 12);
  drop({"empty"});
  CHECK(test::take_message(window).contains("no animation"));
  CHECK(window.frameCount() == 12);
  QMimeData text;
  text.setText("SOL8");
  CHECK_FALSE(test::drop_on(window, text));
}

TEST_CASE("agore_window: slow motion follows the simulated time, and repeats when asked", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  auto file = test::synthetic_sol8(short_run(60));
  const double span = file.frames.back().time;  // 18 ms
  window.setAnimation(prepare(std::move(file)));
  window.resize(900, 600);
  window.show();
  window.setSlowMotion(span / 0.4);  // the whole run in 0.4 s
  window.playForward();
  QTest::qWait(200);
  for (int i = 0; i < 100 && window.currentFrame() <= 5; ++i) QTest::qWait(50);  // a busy machine
  CHECK(window.currentFrame() > 5);
  for (int i = 0; i < 100 && window.playing(); ++i) QTest::qWait(50);
  CHECK_FALSE(window.playing());
  CHECK(window.currentFrame() == 59);
  window.setLoop(true);
  window.playForward();
  QTest::qWait(900);
  CHECK(window.playing());
  window.pause();
}

TEST_CASE("agore_window: slower and faster keys change the current speed", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  test::show_painted(window);
  auto *rate = window.findChild<QComboBox*>("speed"), *slow = window.findChild<QComboBox*>("slow");
  const auto press = [&](Qt::Key key) { QTest::keyClick(&window, key); };
  const int before = rate->currentIndex();
  press(Qt::Key_BracketRight);
  CHECK(rate->currentIndex() == before + 1);
  press(Qt::Key_BracketLeft);
  press(Qt::Key_BracketLeft);
  CHECK(rate->currentIndex() == before - 1);
  slow->setCurrentText("1/1000");
  press(Qt::Key_BracketLeft);
  CHECK(slow->currentText() == "1/5000");
  press(Qt::Key_BracketRight);
  press(Qt::Key_BracketRight);
  CHECK(slow->currentText() == "1/100");
  for (int i = 0; i < 4; ++i) press(Qt::Key_BracketRight);
  CHECK(slow->currentText() == "1/10");  // still slow motion
  CHECK(rate->currentIndex() == before - 1);
}

TEST_CASE("agore_window: a click on the curve goes to that moment, the wheel zooms the picture",
          "[gui]") {
  test::use_qt();
  AgoreWindow window;
  auto* canvas = test::show_painted(window);
  const QRectF data = MotionPicture::dataArea(canvas->rect());
  QTest::mouseClick(canvas, Qt::LeftButton, {},
                    QPointF(data.center().x(), data.center().y()).toPoint());
  const auto time = window.picture()->timeAt(canvas->rect(), data.center().toPoint());
  REQUIRE(time);
  CHECK(window.currentFrame() == window.picture()->frameAt(*time));
  CHECK(window.currentFrame() > 15);
  CHECK(window.currentFrame() < 45);
  const QPointF middle = MotionPicture::pictureAreas(canvas->rect(), 1).front().center();
  QWheelEvent wheel(middle, canvas->mapToGlobal(middle), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(canvas, &wheel);
  CHECK(window.options().zoom == Approx(1.5625));
  QTest::mouseDClick(canvas, Qt::LeftButton, {}, middle.toPoint());
  CHECK(window.options().zoom == 1.0);
}

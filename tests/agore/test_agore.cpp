#include "agore/agore_window.hpp"
#include "agore/pocket_outline.hpp"
#include "agore/render.hpp"
#include "agore/view_scene.hpp"
#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "results/results_h5.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPrinter>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <QXmlStreamReader>
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

using namespace adore;
using namespace adore::agore;

namespace {

test::SyntheticRun short_run(int steps = 120) {
  test::SyntheticRun run;
  run.steps = steps;
  return run;
}

/// Pixels of about a colour inside a rectangle.
int pixels_of(const QImage& image, const QRect& area, const QColor& colour) {
  int count = 0;
  for (int y = area.top(); y <= area.bottom(); ++y)
    for (int x = area.left(); x <= area.right(); ++x) {
      const QColor c = image.pixelColor(x, y);
      count += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                   std::abs(c.blue() - colour.blue()) <
               30;
    }
  return count;
}

const QRect kPicture(0, 60, 780, 620);

QString take_message(QWidget& window) {
  auto* box = window.findChild<QMessageBox*>("message");
  if (!box) return {};
  const QString text = box->text();
  box->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  return text;
}

void click(AgoreWindow& window, const char* button) {
  window.findChild<QPushButton*>(button)->click();
}

QAction* menu_action(AgoreWindow& window, const QString& text) {
  for (auto* action : window.findChildren<QAction*>())
    if (action->text().remove('&') == text) return action;
  return nullptr;
}

}  // namespace

TEST_CASE("animation: angles become continuous and their rate is the speed", "[unit]") {
  std::vector<double> angle, time;
  for (int i = 0; i < 400; ++i) {
    time.push_back(1e-4 * i);
    // Three digits, as the file holds them.
    angle.push_back(std::round(100 * std::remainder(430.0 * time.back(), 2 * std::numbers::pi)) /
                    100);
  }
  const auto turned = continuous(angle);
  CHECK(turned.back() == Approx(430.0 * time.back()).margin(0.006));
  for (const double speed : rate(turned, time))
    CHECK(speed == Approx(430.0).epsilon(0.03));  // 0.005 rad at both ends of 0.5 rad
  CHECK(std::isnan(rate({0.0, 1.0}, {0.0, 1.0}).front()));
}

TEST_CASE("animation: rotation matrix turns about X, then the new Y, then the newest Z", "[unit]") {
  const auto r = rotation({0.3, 0.0, 0.0});
  CHECK(r(1, 2) == Approx(-std::sin(0.3)));  // z axis leans to -y, as an azimuth does
  CHECK(r(2, 2) == Approx(std::cos(0.3)));
  const auto full = rotation({0.4, -0.7, 1.1});
  CHECK((full.transpose() * full - Mat3::Identity()).norm() < 1e-14);
}

TEST_CASE("animation: speeds, pockets and guiding race are recovered from a file of three digits",
          "[unit]") {
  QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("SOL8").toStdString();
  const auto made = test::synthetic_sol8(short_run(600));
  test::write_text(path, test::sol8_text(made));
  const Animation a = prepare(results::read_sol8(path));
  REQUIRE(a.frames() == 600);
  CHECK(a.has_cage);
  CHECK(a.guide == Guide::Inner);
  CHECK(a.guide_clearance == Approx(150e-6));
  for (std::size_t k = 0; k < 12; ++k)  // the mean over 600 coarse angles is good to about
                                        // 0.005/sqrt(600) rad, plus averaging at the ends
    CHECK(std::abs(
              std::remainder(a.pocket_angle[k] - 2 * std::numbers::pi * static_cast<double>(k) / 12,
                             2 * std::numbers::pi)) < 2e-3);
  CHECK(shaft_speed(a) == Approx(2 * std::numbers::pi * 10000 / 60).epsilon(1e-6));
  const auto mean = [](const std::vector<double>& v) {
    double sum = 0;
    for (const double x : v) sum += x;
    return sum / static_cast<double>(v.size());
  };
  CHECK(mean(cage_whirl(a).value) == Approx(0.46).epsilon(0.01));
  CHECK(mean(cage_speed(a).value) == Approx(0.43).epsilon(0.01));
  CHECK(mean(element_orbit(a, 4).value) == Approx(0.43).epsilon(0.01));
  // Every frame adds its rounding to a sum of sizes, so the spin comes out a little high.
  CHECK(mean(element_spin(a, 4).value) == Approx(3.1).epsilon(0.1));
}

TEST_CASE("animation: a lone SOL8 is drawn at its own times, and says what it cannot know",
          "[unit]") {
  auto file = test::synthetic_sol8(short_run(60));
  // The run ends half a stored interval later: nothing may dip there.
  auto last = file.frames.back();
  last.time += 0.5 * (last.time - file.frames[58].time);
  last.revolutions = 10000.0 / 60.0 * last.time;
  const double turned = 2 * std::numbers::pi * 0.43 * last.revolutions;
  for (int k = 0; k < 12; ++k)
    last.elements[static_cast<std::size_t>(k)].theta =
        std::remainder(turned + 2 * std::numbers::pi * k / 12, 2 * std::numbers::pi);
  file.frames.push_back(last);
  const Animation a = prepare(file);
  CHECK(a.source.find("SOL8 alone") == 0);
  for (const double ratio : element_orbit(a, 4).value) CHECK(ratio == Approx(0.43).epsilon(0.05));
  CHECK(a.cage_angle[30] == Approx(continuous([&] {
          std::vector<double> angle;
          for (const auto& frame : file.frames) angle.push_back(frame.cage.angles[0]);
          return angle;
        }())[30]));
  // Every sixth frame: an element turns by about 1 turn in between, the cage by 0.13.
  auto sparse = file;
  sparse.frames.clear();
  for (std::size_t i = 0; i < 60; i += 6) sparse.frames.push_back(file.frames[i]);
  const Animation b = prepare(sparse);
  const History spin = element_spin(b, 0);
  CHECK(spin.unknown.find("Not to be known") == 0);
  CHECK(std::isnan(spin.value[5]));
  CHECK(element_orbit(b, 0).unknown.empty());
}

TEST_CASE("animation: SOL files beside a lone SOL8 give its curves", "[unit]") {
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::write_text(base / "SOL8", test::sol8_text(test::synthetic_sol8(short_run(40))));
  const Animation alone = prepare(results::read_sol8(base / "SOL8"));
  CHECK(element_orbit(alone, 0).time.size() == 40);
  const auto element = test::synthetic_sol(results::SolKind::Element);
  test::write_text(base / "SOL1", test::sol_text(element));
  const auto cage = test::synthetic_sol(results::SolKind::Cage);
  test::write_text(base / "SOL2", test::sol_text(cage));
  const History orbit = element_orbit(alone, 0);
  REQUIRE(orbit.value.size() == element.steps.size());
  CHECK(orbit.value[700] == Approx(element.steps[700].values[3] / 10000.0).epsilon(1e-4));
  CHECK(element_orbit(alone, 1).time.size() == 40);  // no file of that element
  const History force = pocket_force(alone, 2);
  REQUIRE(force.value.size() == cage.steps.size());
  double largest = 0.0;
  for (const auto& step : cage.steps) largest = std::max(largest, step.values[24 + 8]);
  CHECK(*std::max_element(force.value.begin(), force.value.end()) == Approx(largest).epsilon(1e-6));
}

TEST_CASE("animation: the contacts tell which race guides, and lands that are not there stay away",
          "[unit]") {
  auto file = test::synthetic_sol8(short_run(60));
  // The clearances alone would say inner; the cage touches on the side to which it has moved.
  for (auto& frame : file.frames) {
    const auto& p = frame.cage.position;
    const double side = std::atan2(-p[1], p[2]) - frame.cage.angles[0];
    frame.land_force = {5.0, 0.0};
    frame.land_angle = {side, 0.0};
  }
  const Animation outer = prepare(file);
  CHECK(outer.guide == Guide::Outer);
  CHECK(outer.guide_clearance == Approx(9e-4));
  CHECK(outer.land[0]);
  CHECK_FALSE(outer.land[1]);
  const auto page = data_page(outer, {});
  REQUIRE(page.panels.size() == 1);
  CHECK(page.panels[0].curves.size() == 1);
  for (auto& frame : file.frames) frame.land_force = frame.land_angle = {0.0, 0.0};
  const Animation none = prepare(file);
  CHECK(none.guide == Guide::None);
  CHECK(data_page(none, {}).panels[0].message.find("no guide land") != std::string::npos);
}

TEST_CASE("animation: what cannot be shown is refused with a sentence", "[unit]") {
  auto file = test::synthetic_sol8(short_run(5));
  auto old = file;
  old.version = "Adore0.0.9";
  CHECK_THROWS_WITH(prepare(old), Catch::Contains("versions from 0.1"));
  old.version = "nameless";
  CHECK_THROWS_AS(prepare(old), InputError);
  auto empty = file;
  empty.frames.clear();
  CHECK_THROWS_WITH(prepare(empty), Catch::Contains("no complete frame"));
  auto flat = file;
  flat.geometry.pitch_diameter = 0;
  CHECK_THROWS_AS(prepare(flat), InputError);
  auto bare = file;
  bare.geometry.cage_outer_radius = bare.geometry.cage_inner_radius = 0;
  const Animation a = prepare(bare);
  CHECK_FALSE(a.has_cage);
  CHECK_FALSE(why_not(View::Cage, a).empty());
  CHECK(why_not(View::Bearing, a).empty());
}

TEST_CASE("view_options: names, and an exaggeration that keeps pockets apart", "[unit]") {
  CHECK(view_named("race", "outer") == View::OuterRace);
  CHECK(view_named("flange") == View::Flange);
  CHECK_THROWS_WITH(view_named("front"), Catch::Contains("bearing, cage, pocket, element"));
  const Animation a = prepare(test::synthetic_sol8(short_run(5)));
  CHECK(used_exaggeration(a, {}) == 5.0);
  ViewOptions options;
  options.exaggeration = 12;
  CHECK(used_exaggeration(a, options) == 12.0);
}

TEST_CASE("views: bearing picture shows the frames, the arrow, the dashed circle and the asterisks",
          "[gui]") {
  test::use_qt();
  MotionPicture picture(prepare(test::synthetic_sol8()));
  const ViewOptions options;
  const auto& t = theme_of(options);
  const QImage start = picture.image({1280, 800}, 0, options),
               later = picture.image({1280, 800}, 1200, options);
  for (const QColor& colour : {t.red, t.green, t.blue, t.light_blue})
    CHECK(pixels_of(later, kPicture, colour) > 60);
  CHECK(start != later);
  // No land force in the first frame: the arrow is missing there, and it is long.
  CHECK(pixels_of(later, kPicture, t.red) > pixels_of(start, kPicture, t.red) + 250);
  CHECK(picture.image({1280, 800}, 1200, options) ==
        later);  // a picture depends on its frame alone
}

TEST_CASE("views: an arrow appears exactly where the land contact is", "[gui]") {
  test::use_qt();
  auto file = test::synthetic_sol8(short_run(3));
  for (auto& frame : file.frames) {
    frame.cage.angles[0] = 0.0;
    frame.cage.position = {0, 0, 0};
    for (auto& e : frame.elements) e.pocket_force = 0.0;
    frame.land_force = {10.0, 0.0};
    frame.land_angle = {-0.5 * std::numbers::pi, 0.0};  // azimuth -90 degrees: +y, to the right
  }
  MotionPicture picture(prepare(file));
  ViewOptions options;
  options.view = View::Cage;
  const QImage image = picture.image({1280, 800}, 1, options);
  const auto& red = theme_of(options).red;
  CHECK(pixels_of(image, QRect(520, 380, 110, 40), red) > 100);  // right of the middle
  CHECK(pixels_of(image, QRect(200, 380, 110, 40), red) < 20);   // not left of it
}

TEST_CASE("views: a round picture leaves the corner to its key, and no more than that", "[gui]") {
  test::use_qt();
  const Animation animation = prepare(test::synthetic_sol8());
  ViewOptions options;
  for (const View view : {View::Bearing, View::Element, View::OuterRace, View::InnerRace}) {
    options.view = view;
    const QRectF narrow(0, 0, 700, 684), wide(0, 0, 1500, 600);
    INFO(view_title(view));
    CHECK(picture_middle(animation, options, narrow).y() < narrow.center().y());
    CHECK(picture_middle(animation, options, narrow).y() > 0.43 * narrow.height());
    CHECK(picture_middle(animation, options, wide) == wide.center());
  }
}

TEST_CASE("views: each view has its data curves", "[gui]") {
  test::use_qt();
  const Animation a = prepare(test::synthetic_sol8(short_run()));
  const auto panels = [&](View view) {
    ViewOptions options;
    options.view = view;
    options.element = 3;
    const auto page = data_page(a, options);
    for (const auto& panel : page.panels)
      for (const auto& curve : panel.curves) CHECK(curve.y.size() == a.frames());
    return page.panels.size();
  };
  CHECK(panels(View::Bearing) == 1);
  CHECK(panels(View::Cage) == 2);
  CHECK(panels(View::Pocket) == 1);
  CHECK(panels(View::Element) == 2);
  CHECK(panels(View::OuterRace) == 3);
  ViewOptions wrong;
  wrong.element = 13;
  QImage image(100, 100, QImage::Format_RGB32);
  QPainter painter(&image);
  CHECK_THROWS_AS(paint_picture(painter, {0, 0, 100, 100}, a, 0, wrong), InputError);
}

TEST_CASE("views: a frame is drawn within a twenty-fifth of a second of processor time", "[gui]") {
  test::use_qt();
  MotionPicture picture(prepare(test::synthetic_sol8()));
  QImage image = picture.image({1280, 800}, 0, {});
  constexpr int kFrames = 20;
  const std::clock_t start = std::clock();
  for (int i = 0; i < kFrames; ++i)
    image = picture.image({1280, 800}, static_cast<std::size_t>(50 * i), {});
  const double per_frame =
      1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / kFrames;
  INFO("one frame takes " << per_frame << " ms");
  CHECK_FALSE(image.isNull());
  CHECK(per_frame < 40.0);  // processor time, so that a busy machine does not fail it
}

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

TEST_CASE("agore_window: the format chosen for a film is what its name says", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.show();
  window.setAnimation(prepare(test::synthetic_sol8(short_run(20))));
  menu_action(window, "Save Film...")->trigger();
  auto* dialog = window.findChild<QFileDialog*>("film");
  REQUIRE(dialog != nullptr);
  CHECK(dialog->defaultSuffix() == "gif");
  for (const QString& filter : dialog->nameFilters()) {
    emit dialog->filterSelected(filter);
    const QString name = dialog->selectedFiles().value(0);
    INFO(filter.toStdString() << ": " << name.toStdString());
    for (const char* suffix : {"gif", "avi", "mp4"})
      CHECK(name.endsWith(QString("bearing.") + suffix) == filter.contains(QString("*.") + suffix));
  }
  dialog->close();
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
  QTest::mouseClick(canvas, Qt::LeftButton, {},
                    QPoint(300, 300));  // beside the bar nothing happens
  CHECK(window.currentFrame() == 100);
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
  CHECK(take_message(window).contains("no flanges"));  // balls
  CHECK(window.options().view == View::OuterRace);
  menu_action(window, "Axial Section...")->trigger();
  CHECK(take_message(window).contains("RESULTS.h5"));
  menu_action(window, "Contact Load")->trigger();
  CHECK(window.options().colour == ColourBy::Load);
  menu_action(window, "About AGORE")->trigger();
  CHECK(take_message(window).contains("0.1"));
  menu_action(window, "× 10")->trigger();
  CHECK(window.options().exaggeration == 10.0);
}

TEST_CASE(
    "agore_window: files are opened, thinned to the steps asked for, and refused with a reason",
    "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  const std::string text = test::sol8_text(test::synthetic_sol8(short_run(40)));
  test::write_text(base / "SOL8", text);
  test::write_text(base / "cut", text.substr(0, text.size() - 300));
  test::write_text(base / "other", "nothing of ours\n");
  AgoreWindow window;
  CHECK(window.openFile(base / "SOL8", 15));  // the whole run, and it says what is left out
  CHECK(window.frameCount() == 14);
  const Animation thinned = open_motion(base / "SOL8", 15);
  CHECK(thinned.frame(13).step == open_motion(base / "SOL8").frame(39).step);
  CHECK(thinned.source.find("every 3. of 40") != std::string::npos);
  CHECK(window.openFile(base / "SOL8"));
  CHECK(window.frameCount() == 40);
  CHECK_FALSE(window.openFile(base / "other"));
  CHECK(take_message(window).contains("other"));
  CHECK(window.frameCount() == 40);  // the old one stays
  CHECK(window.openFile(base / "cut"));
  CHECK(window.frameCount() == 39);
  CHECK(take_message(window).contains("incomplete"));
}

TEST_CASE("agore_window: a file dropped on it is opened, several are not", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::write_text(base / "SOL8", test::sol8_text(test::synthetic_sol8(short_run(20))));
  AgoreWindow window;
  const auto drop = [&](const QStringList& names) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& name : names) urls << QUrl::fromLocalFile(folder.filePath(name));
    data.setUrls(urls);
    QDragEnterEvent enter({9, 9}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    CHECK(enter.isAccepted());
    QDropEvent event({9.0, 9.0}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
    CHECK(event.isAccepted());
  };
  drop({"SOL8", "SOL9"});
  CHECK(take_message(window).contains("single SOL8"));
  CHECK(window.frameCount() == 0);
  drop({"nowhere"});
  CHECK(take_message(window).contains("nowhere"));
  drop({"SOL8"});
  CHECK(take_message(window).isEmpty());
  CHECK(window.frameCount() == 20);
  QMimeData text;
  text.setText("SOL8");
  QDragEnterEvent enter({9, 9}, Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QCoreApplication::sendEvent(&window, &enter);
  CHECK_FALSE(enter.isAccepted());
}

TEST_CASE("views: the element view shows contact loads when RESULTS.h5 lies beside the file",
          "[gui]") {
  test::use_qt();
  const auto picture = [](bool with_contacts) {
    Animation animation = prepare(test::synthetic_sol8(short_run(30)));
    CHECK_FALSE(animation.contacts.has_value());  // nothing lies beside a file in memory
    CHECK_FALSE(animation.no_contacts.empty());
    if (with_contacts) {
      ContactFrames contacts{"N", "m/s", {}, 200.0};
      contacts.frames.assign(30, std::vector<ContactFrame>(12, {{200.0, 100.0}, {1, 2}}));
      animation.contacts = contacts;
    }
    ViewOptions options;
    options.view = View::Element;
    options.element = 4;
    return MotionPicture(std::move(animation)).image({780, 680}, 29, options);
  };
  const QImage with = picture(true), without = picture(false);
  const auto& curves = theme_of({}).curves;
  const QRect drawing(0, 0, 780, 560);  // above the key
  const int outer = pixels_of(with, drawing, curves[0]) - pixels_of(without, drawing, curves[0]);
  const int inner = pixels_of(with, drawing, curves[1]) - pixels_of(without, drawing, curves[1]);
  CHECK(inner > 20);
  CHECK(outer > 1.4 * inner);  // twice the load, twice the shaft
}

TEST_CASE("render: pictures, numbered pictures and a film", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::write_text(base / "SOL8", test::sol8_text(test::synthetic_sol8(short_run(30))));
  MotionPicture picture = open_animation(base / "SOL8");
  RenderOptions options;
  options.width = 640, options.height = 400;
  const auto written = render_frames(picture, 10, base / "frames", options);
  REQUIRE(written.size() == 3);
  CHECK(written[1].filename() == "SOL8-frame-00011.png");
  CHECK(QImage(QString::fromStdString(written[2].string())).size() == QSize(640, 400));
  CHECK_THROWS_WITH(render_frame(picture, 31, base / "x.png", options), Catch::Contains("1 to 30"));
  render_movie(picture, 3, 25, base / "films" / "run.avi", options);
  CHECK(std::filesystem::file_size(base / "films" / "run.avi") > 10 * 5000);
  CHECK_THROWS_AS(render_movie(picture, 1, 25, base / "run.mkv", options), InputError);
  render_movie(picture, 15, 25, base / "run.gif", options);
  CHECK(QImage(QString::fromStdString((base / "run.gif").string())).size() == QSize(640, 400));
  render_movie(picture, 15, 25, base / "stills", options);
  CHECK(std::filesystem::exists(base / "stills" / "SOL8-frame-00016.png"));
}

TEST_CASE("render: a film in slow motion shows the frames at their own times", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  auto file = test::synthetic_sol8(short_run(8));
  for (std::size_t i = 0; i < file.frames.size(); ++i)  // 0, 1, 4, 9, ... 49 us
    file.frames[i].time = 1e-6 * static_cast<double>(i * i);
  MotionPicture picture(prepare(file));
  RenderOptions options;
  options.width = 320, options.height = 240;
  options.slow = 7e-6 * 25.0;  // 7 us a picture: 0, 7, 14, 21, 28, 35, 42 us and the end
  render_movie(picture, 1, 25, base / "stills", options);
  const std::size_t shown[] = {0, 2, 3, 4, 5, 5, 6, 7};
  const std::string stem = picture.animation().file.path.filename().string();
  int number = 0;
  for (const std::size_t frame : shown) {
    const auto path = base / "stills" / fmt::format("{}-picture-{:05}.png", stem, ++number);
    INFO(path.string() << " is frame " << frame);
    const QImage image(QString::fromStdString(path.string()));
    REQUIRE_FALSE(image.isNull());
    CHECK(image.convertToFormat(QImage::Format_RGB32) ==
          picture.image({320, 240}, frame, options.view).convertToFormat(QImage::Format_RGB32));
  }
  CHECK_FALSE(std::filesystem::exists(base / "stills" /
                                      fmt::format("{}-picture-{:05}.png", stem, number + 1)));
  options.slow = 1e-30;
  CHECK_THROWS_WITH(render_movie(picture, 1, 25, base / "film.gif", options),
                    Catch::Contains("a larger --slow"));
}

TEST_CASE("render: numbered pictures end when somebody stops them", "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  MotionPicture picture(prepare(test::synthetic_sol8(short_run(30))));
  RenderOptions options;
  options.width = 320, options.height = 240;
  long drawn = 0;
  options.progress = [&](long done, long total) {
    drawn = done;
    CHECK(total == 30);
  };
  options.stop = [&] { return drawn == 3; };
  CHECK(render_frames(picture, 1, base / "stills", options).size() == 3);
  render_movie(picture, 1, 25, base / "film.gif", options);
  CHECK_FALSE(std::filesystem::exists(base / "film.gif"));
}

TEST_CASE("motion_picture: SVG and paper hold lines and text, inside the zoomed picture's frame",
          "[gui]") {
  test::use_qt();
  QTemporaryDir folder;
  MotionPicture picture(prepare(test::synthetic_sol8(short_run(30))));
  for (const View view : {View::Bearing, View::Cage, View::Pocket, View::Element, View::InnerRace})
    for (const double zoom : {1.0, 4.0}) {
      ViewOptions options;
      options.view = view;
      options.zoom = zoom;
      INFO(view_title(view) << ", zoom " << zoom);
      const QByteArray svg = picture.svg({900, 600}, 2, options);
      QXmlStreamReader xml(svg);
      int paths = 0, images = 0;
      QString words;
      QStringList clips, clipped;
      while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        paths += xml.name() == QLatin1String("path");
        images += xml.name() == QLatin1String("image");
        if (xml.name() == QLatin1String("clipPath"))
          clips << xml.attributes().value("id").toString();
        if (xml.attributes().hasAttribute("clip-path"))
          clipped << xml.attributes().value("clip-path").toString();
        if (xml.name() == QLatin1String("text")) words += xml.readElementText() + "|";
      }
      CHECK_FALSE(xml.hasError());
      CHECK(paths > 30);
      CHECK(images == 0);
      CHECK(words.contains("frame 3 of 30|"));
      CHECK(words.contains(QString::fromStdString(view_title(view)) + "|"));
      for (const QString& use : clipped) CHECK(clips.contains(use.mid(5).chopped(1)));
      if (zoom > 1.0) CHECK(clipped.size() > 5);  // the picture's bodies stay in its frame
    }
  QPrinter printer;
  printer.setOutputFormat(QPrinter::PdfFormat);
  printer.setOutputFileName(folder.filePath("page.pdf"));
  {
    QPainter painter(&printer);
    picture.paintOnPaper(painter, painter.viewport(), {900, 600}, 2, {});
  }
  QFile file(folder.filePath("page.pdf"));
  REQUIRE(file.open(QIODevice::ReadOnly));
  const QByteArray bytes = file.readAll();
  CHECK(bytes.startsWith("%PDF"));
  CHECK(bytes.count("/Type /Page\n") == 1);
  CHECK(bytes.contains("/Type /Font"));
  CHECK_FALSE(bytes.contains("/Subtype /Image"));
}

TEST_CASE("pocket outlines have the clearances of their shape", "[unit][agore][pocket]") {
  using agore::PocketOutline;
  const auto half = [](PocketOutline p) { return agore::pocket_half(p); };
  const PocketOutline ball{.radius = 5.0, .clearance_1 = 1.0, .clearance_2 = 2.0};
  const auto with = [&](int code) {
    PocketOutline p = ball;
    p.code = code;
    return p;
  };
  CHECK(half(with(0)) == QSizeF(5.5, 5.5));
  CHECK(half(with(2)) == QSizeF(6.5, 5.5));  // round the bearing
  CHECK(half(with(3)) == QSizeF(5.5, 6.0));
  CHECK(half(with(4)) == QSizeF(6.0, 6.0));
  for (const int code : {0, 1, 2, 3, 4}) {
    const QRectF box = agore::pocket_hole(with(code)).boundingRect();
    CHECK(box.width() == Approx(2.0 * half(with(code)).width()));
    CHECK(box.height() == Approx(2.0 * half(with(code)).height()));
  }
  PocketOutline roller = ball;
  roller.roller_length = 14.0;
  CHECK(agore::pocket_hole(roller).contains(agore::roller_side(roller).boundingRect()));
  CHECK(agore::roller_side(roller).boundingRect().size() == QSizeF(10.0, 14.0));
}

TEST_CASE("views: RESULTS.h5 alone shows sections, colours and race loads", "[gui][h5]") {
  using namespace adore::testing;
  test::use_qt();
  TemporaryFolder folder;
  const bearing::Bearing bearing = make_bearing(8);
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  for (long step = 0; step <= 30; ++step) h5.write(recorder.record(make_snapshot(bearing, step)));
  h5.close();
  MotionPicture picture = open_animation(folder / "RESULTS.h5");
  const Animation& a = picture.animation();
  REQUIRE(picture.frames() == 31);
  CHECK(a.source.find("every stored step") == 0);
  CHECK(a.guide == Guide::Outer);
  CHECK(a.guide_clearance == Approx(0.0003));
  CHECK(a.land[1]);
  // Channels of the run, not differences: 400 + k rad/s of a shaft at 1000.
  const History orbit = element_orbit(a, 2);
  REQUIRE(orbit.value.size() == 31);
  for (const double ratio : orbit.value) CHECK(ratio == Approx(0.403));
  const Colouring load = colouring(a, 5, ColourBy::Load);
  REQUIRE(load.value.size() == 8);
  CHECK(load.value[2] == Approx(1300.0));  // the larger of both contacts: 100 (3 + 10)
  CHECK(load.largest == Approx(1800.0));
  CHECK(scale_colour(0.0) == QColor(68, 1, 84));
  CHECK(scale_colour(1.0) == QColor(253, 231, 37));
  ViewOptions options;
  const QImage plain = picture.image({900, 600}, 3, options);
  options.colour = ColourBy::Load;
  options.contacts = true;
  CHECK(picture.image({900, 600}, 3, options) != plain);
  options = {};
  options.view = View::Section;
  options.element = 2;
  const QImage section = picture.image({900, 600}, 3, options);
  CHECK(pixels_of(section, {0, 60, 540, 460}, theme_of(options).curves[0]) > 20);
  options.zoom = 4.0;
  CHECK(picture.image({900, 600}, 3, options) != section);
  options = {};
  options.view = View::Flange;
  CHECK_THROWS_WITH(picture.image({900, 600}, 3, options), Catch::Contains("no flanges"));
}

TEST_CASE("views: a bearing whose cage has no land shows loads beside it, not an empty chart",
          "[gui][h5]") {
  using namespace adore::testing;
  TemporaryFolder folder;
  bearing::Bearing bearing = make_bearing(8);
  bearing.cage->lands.clear();
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  for (long step = 0; step <= 5; ++step) h5.write(recorder.record(make_snapshot(bearing, step)));
  h5.close();
  const Animation a = open_motion(folder / "RESULTS.h5");
  REQUIRE_FALSE((a.land[0] || a.land[1]));
  ViewOptions options;
  options.element = 3;
  const desktop::ChartPage page = data_page(a, options);
  CHECK(page.title == "Contact loads of element 3");
  REQUIRE(page.panels.size() == 1);
  CHECK(page.panels[0].message.empty());
  CHECK(page.panels[0].curves.size() == 2);
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

TEST_CASE("agore_window: a click on the curve goes to that moment, the wheel zooms the picture",
          "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8(short_run(61))));
  window.resize(1100, 700);
  window.show();
  QCoreApplication::processEvents();
  auto* canvas = window.findChild<PictureWidget*>();
  canvas->grab();  // painted once: the curves have their place
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

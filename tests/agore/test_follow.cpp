#include "agore/agore_window.hpp"
#include "agore/short_run.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QAction>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

/// A window while the solver runs.
using namespace adore;
using namespace adore::agore;
using test::short_run;

namespace {

constexpr int kPatience = 20000;  // [ms] of a busy machine

/// The first `frames` of a run of a hundred, and a part of the next one.
std::string begun(int frames, std::size_t part = 0) {
  results::Sol8File file = test::synthetic_sol8(short_run(100));
  const std::string whole = test::sol8_text(file);
  file.frames.resize(static_cast<std::size_t>(frames));
  return whole.substr(0, test::sol8_text(file).size() + part);
}

}  // namespace

TEST_CASE("agore_window: a running solver is followed, at the moment and place that is looked at",
          "[gui][follow]") {
  test::use_qt();
  QTemporaryDir base;
  const std::filesystem::path sol8 = base.filePath("SOL8").toStdString();
  test::write_text(sol8, begun(20));
  AgoreWindow window;
  window.show();
  REQUIRE(window.openFile(sol8));
  window.setView(View::Cage);
  window.setFrame(7);
  window.setRepeatRange(window.picture()->animation().time[3], {});
  const auto grows = [&](const std::string& text, std::size_t frames) {
    test::write_text(sol8, text);
    return QTest::qWaitFor([&] { return window.frameCount() == frames; }, kPatience);
  };
  test::write_text(sol8, begun(25));
  QTest::qWait(1500);
  CHECK(window.frameCount() == 20);  // nobody asked
  window.follow(true);
  CHECK(QTest::qWaitFor([&] { return window.frameCount() == 25; }, kPatience));
  CHECK(window.currentFrame() == 7);
  CHECK(window.options().view == View::Cage);
  CHECK(window.options().span_from.has_value());
  CHECK(window.windowTitle().contains("followed"));
  // Half a record is ignored, without a message.
  CHECK(grows(begun(31, 300), 31));
  CHECK(window.findChild<QMessageBox*>("message") == nullptr);
  CHECK(window.currentFrame() == 7);
  // A view at the end stays at the end.
  window.setFrame(30);
  CHECK(grows(begun(40), 40));
  CHECK(window.currentFrame() == 39);
  // Unreadable data leave the picture unchanged until they can be read.
  test::write_text(sol8, "");
  QTest::qWait(1500);
  CHECK(window.frameCount() == 40);
  CHECK(window.findChild<QMessageBox*>("message") == nullptr);
  CHECK(grows(begun(50), 50));
  // A playing animation continues.
  window.setFrame(10);
  window.playForward();
  CHECK(grows(begun(100), 100));
  CHECK(window.playing());
  window.pause();
  {
    AgoreWindow next;  // a program that asked for it did so once
    CHECK_FALSE(next.findChild<QAction*>("followAction")->isChecked());
  }
  window.follow(false);
  window.findChild<QAction*>("followAction")->trigger();  // as a person does
  AgoreWindow next;
  CHECK(next.findChild<QAction*>("followAction")->isChecked());  // remembered
  next.findChild<QAction*>("followAction")->trigger();
  window.follow(false);
  CHECK_FALSE(QSettings("Adore", "agore").value("follow").toBool());
}

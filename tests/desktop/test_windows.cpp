#include "desktop/behind.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/launch.hpp"
#include "desktop/menu_keys.hpp"
#include "desktop/one_window.hpp"
#include "desktop/theme.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QMessageBox>
#include <QPalette>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;

namespace {

/// Contrast of two colors as WCAG 2 defines it, 1 to 21.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& colour) {
    const auto linear = [](double v) {
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
  };
  const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
  return x > y ? x / y : y / x;
}

}  // namespace

TEST_CASE("a program that was started holds no stream of the one that started it",
          "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir folder;
  QFile script(folder.filePath("viewer"));
  REQUIRE(script.open(QIODevice::WriteOnly));
  script.write(
      "#!/bin/sh\nheld=$(readlink /proc/$$/fd/0 /proc/$$/fd/1 /proc/$$/fd/2)\n"
      "echo \"$held\" > \"$1.part\"\nmv \"$1.part\" \"$1\"\n");
  script.close();
  REQUIRE(script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
  const desktop::Starter before = desktop::set_program_starter({});
  const QByteArray path = qgetenv("PATH");
  qputenv("PATH", folder.path().toUtf8() + ':' + path);
  desktop::start_program("viewer", {folder.filePath("streams")});
  qputenv("PATH", path);
  desktop::set_program_starter(before);
  QFile streams(folder.filePath("streams"));
  REQUIRE(QTest::qWaitFor([&] { return streams.exists(); }, 30000));
  REQUIRE(streams.open(QIODevice::ReadOnly));
  const QList<QByteArray> held = streams.readAll().trimmed().split('\n');
  REQUIRE(held.size() == 3);
  for (const QByteArray& stream : held) CHECK(stream == "/dev/null");
}

TEST_CASE("keys of the menu go before the editing keys of a field", "[gui][desktop]") {
  test::use_qt();
  QMainWindow window;
  auto* line = new QLineEdit("0.0127", &window);
  window.setCentralWidget(line);
  QMenu* menu = window.menuBar()->addMenu("View");
  menu->addAction("Units", QKeySequence(Qt::CTRL | Qt::Key_U), &window, [] {});
  menu->addAction("Copy picture", QKeySequence::Copy, &window, [] {});
  new desktop::MenuKeys(window);
  const auto taken_by_field = [&](int key, Qt::KeyboardModifiers modifiers) {
    QKeyEvent event(QEvent::ShortcutOverride, key, modifiers);
    event.setAccepted(false);
    // As Qt asks before it acts; under X11 a field would accept Ctrl+U.
    event.accept();
    QApplication::sendEvent(line, &event);
    return event.isAccepted();
  };
  CHECK_FALSE(taken_by_field(Qt::Key_U, Qt::ControlModifier));
  CHECK(taken_by_field(Qt::Key_C, Qt::ControlModifier));  // copying stays with the field
}

TEST_CASE("messages: several at once → one box, closed by one key", "[gui][desktop]") {
  test::use_qt();
  QMainWindow window;
  window.show();
  for (int i = 1; i <= 45; ++i)
    desktop::show_message(&window, QString("file %1 is damaged").arg(i), i == 2);
  desktop::show_message(&window, "file 3 is damaged", true);
  const auto boxes = window.findChildren<QMessageBox*>("message");
  REQUIRE(boxes.size() == 1);
  CHECK(boxes.front()->icon() == QMessageBox::Warning);
  CHECK(boxes.front()->text().contains("file 1 is damaged"));
  CHECK(boxes.front()->text().contains("file 8 is damaged"));
  CHECK_FALSE(boxes.front()->text().contains("file 9 is damaged"));
  CHECK(boxes.front()->text().contains("37 more"));
  QTest::keyClick(boxes.front(), Qt::Key_Escape);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  CHECK(window.findChildren<QMessageBox*>("message").isEmpty());
  desktop::show_message(&window, "another");
  CHECK(window.findChild<QMessageBox*>("message")->text() == "another");
}

TEST_CASE("a message that is higher than the screen scrolls, and no dialog opens larger than it",
          "[gui][desktop]") {
  test::use_qt();
  QMainWindow window;
  window.show();
  const QSize screen = window.screen()->availableSize();
  QStringList lines;
  for (int i = 1; i <= 200; ++i) lines << QString("line %1").arg(i);
  desktop::show_message(&window, lines.join("\n"));
  auto* box = window.findChild<QMessageBox*>("message");
  REQUIRE(box != nullptr);
  const auto area = [&] { return box->findChild<QScrollArea*>("message-text"); };
  REQUIRE(QTest::qWaitFor([&] { return area() != nullptr; }, 5000));
  CHECK(QTest::qWaitFor([&] { return box->height() <= screen.height(); }, 5000));
  CHECK(area()->verticalScrollBar()->maximum() > 0);
  CHECK(area()->widget()->height() > screen.height());
  CHECK(box->rect().contains(box->button(QMessageBox::Ok)->geometry()));
  // Widgets that are added later scroll, too.
  const int before = area()->verticalScrollBar()->maximum();
  desktop::show_message(&window, lines.join(" "), true);
  CHECK(QTest::qWaitFor([&] { return area()->verticalScrollBar()->maximum() > before; }, 5000));
  CHECK(box->height() <= screen.height());
  delete box;
  desktop::show_message(&window, "short");
  box = window.findChild<QMessageBox*>("message");
  QCoreApplication::processEvents();
  CHECK(area() == nullptr);
  delete box;

  QDialog large(&window);
  large.resize(2000, 1500);
  large.show();
  CHECK(large.width() < screen.width());
  CHECK(large.height() < screen.height());
  // A dock that is unfolded in place keeps its lower edge visible.
  large.resize(300, 100);
  large.move(20, screen.height() - 150);
  QCoreApplication::processEvents();
  large.resize(300, 400);
  CHECK(QTest::qWaitFor([&] { return large.frameGeometry().bottom() <= screen.height(); }, 5000));
}

TEST_CASE("files go to the window that shows their folder, and to no other", "[gui][desktop]") {
  test::use_qt();
  const QTemporaryDir project, other;
  QStringList shown;
  const QStringList files{project.filePath("SOL1"), project.filePath("SOL2")};
  CHECK_FALSE(desktop::send_to_open_window("adrplot", project.path(), files));
  {
    const desktop::SingleWindowServer window("adrplot", project.path(), nullptr,
                                             [&](const QStringList& names) { shown = names; });
    REQUIRE(window.is_listening());
    const desktop::SingleWindowServer second("adrplot", project.path(), nullptr,
                                             [](const QStringList&) {});
    CHECK_FALSE(second.is_listening());
    CHECK(desktop::send_to_open_window("adrplot", project.path(), files));
    CHECK(QTest::qWaitFor([&] { return shown == files; }, 5000));
    const QStringList of_a_run = QStringList{"--follow"} + files;  // which continues
    CHECK(desktop::send_to_open_window("adrplot", project.path(), of_a_run));
    CHECK(QTest::qWaitFor([&] { return shown == of_a_run; }, 5000));
    // A run in a separate folder belongs to the project that started it.
    const QStringList of_folder{project.filePath("run-001/SOL1")};
    CHECK(desktop::send_to_open_window("adrplot", project.path(), of_folder));
    CHECK(QTest::qWaitFor([&] { return shown == of_folder; }, 5000));
    CHECK_FALSE(desktop::send_to_open_window("adrplot", project.path(), {"--follow"}));
    CHECK_FALSE(desktop::send_to_open_window("adrplot", other.path(), {other.filePath("SOL1")}));
    CHECK_FALSE(desktop::send_to_open_window("agore", project.path(), files));
  }
  CHECK_FALSE(desktop::send_to_open_window("adrplot", project.path(), files));
}

TEST_CASE("a window that opens behind does not take the keyboard until it is chosen",
          "[gui][desktop]") {
  test::use_qt();
  QWidget before;
  before.show();
  {
    const desktop::OpenWithoutFocusGuard behind;
    QWidget window;
    QDialog question(&window);
    window.show();
    question.show();
    CHECK(window.testAttribute(Qt::WA_ShowWithoutActivating));
    CHECK(question.testAttribute(Qt::WA_ShowWithoutActivating));
    QEvent chosen(QEvent::WindowActivate);
    QApplication::sendEvent(&window, &chosen);
    QWidget asked_for;
    asked_for.show();
    CHECK_FALSE(asked_for.testAttribute(Qt::WA_ShowWithoutActivating));
  }
  CHECK_FALSE(before.testAttribute(Qt::WA_ShowWithoutActivating));
}

TEST_CASE("themes: selected text has contrast to its background", "[gui][desktop]") {
  test::use_qt();
  for (const auto kind : {desktop::ThemeKind::Light, desktop::ThemeKind::Dark}) {
    desktop::apply_theme(kind);
    const QPalette palette = QApplication::palette();
    // 4.5: what WCAG 2 asks of text.
    CHECK(contrast(palette.color(QPalette::Highlight), palette.color(QPalette::HighlightedText)) >
          4.5);
    CHECK(contrast(palette.color(QPalette::Window), palette.color(QPalette::WindowText)) > 4.5);
    CHECK(contrast(palette.color(QPalette::Window), desktop::current_theme().muted) > 4.5);
    // Disabled elements are paler and still readable; Fusion's buttons are lighter at their top.
    const QColor idle = palette.color(QPalette::Disabled, QPalette::ButtonText);
    const QColor button = palette.color(QPalette::Button);
    for (const QColor& ground : {button, button.lighter(124), palette.color(QPalette::Window),
                                 palette.color(QPalette::Base)}) {
      INFO(ground.name().toStdString() << " " << contrast(ground, idle));
      CHECK(contrast(ground, idle) > 2.5);
      CHECK(contrast(ground, idle) < 0.8 * contrast(ground, palette.color(QPalette::ButtonText)));
    }
  }
  desktop::apply_theme(desktop::ThemeKind::Light);
}

#include "agore/agore_window.hpp"
#include "support/qt_app.hpp"
#include "support/qt_warnings.hpp"
#include "support/reachable.hpp"
#include "support/spoken.hpp"
#include "support/synthetic_results.hpp"

#include <QTest>
#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::agore;

TEST_CASE(
    "agore_window: everything has a name for those who cannot see it, and the help has the "
    "keys, the wheel and the drag",
    "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8()));
  window.show();
  CHECK(test::nameless_widgets(window).join("; ").toStdString() == "");
  CHECK(test::unspoken_parts(window).join("; ").toStdString() == "");
  CHECK(test::clashing_letters(window).join("; ").toStdString() == "");
  const QString help = test::help_text(window, "Keys and Mouse");
  for (const char* word :
       {"wheel", "drag", "Space", "Home", "Up, Down", "Ctrl+7", "[, ]", "+ or =, -, 0"})
    CHECK(help.contains(word));
  CHECK(test::keys_without_help(window, help) == QStringList());
  CHECK(test::unreadable_help(window).join("; ").toStdString() == "");
}

TEST_CASE("agore_window: access keys are unique, also in dialogs", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8()));
  window.show();
  CHECK(test::contested_letters_of_pages(window).join("; ").toStdString() == "");
  int dialogs = 0;
  CHECK(test::contested_letters_of_dialogs(window, dialogs).join("; ").toStdString() == "");
  CHECK(dialogs >= 1);
  CHECK(test::unspoken_in_dialogs(window, dialogs).join("; ").toStdString() == "");
}

TEST_CASE("agore_window: Alt+letter without an action is not typed into a field", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8()));
  window.show();
  CHECK(test::letters_typed_by_alt(window).join("; ").toStdString() == "");
}

TEST_CASE("agore_window: no Qt warnings while switches are toggled at any size", "[gui]") {
  test::use_qt();
  const test::QtWarnings warnings;
  AgoreWindow window;
  window.show();
  window.setAnimation(prepare(test::synthetic_sol8()));
  CHECK(test::warned_by_switches(window) == "");
}

TEST_CASE(
    "agore_window: the picture is focusable and its accessible text has views, frame and time",
    "[gui]") {
  test::use_qt();
  AgoreWindow window;
  auto* picture = window.findChild<PictureWidget*>();
  CHECK(picture->accessibleDescription() == "No file is open.");
  window.setAnimation(prepare(test::synthetic_sol8()));
  window.show();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  QTest::keyClick(&window, Qt::Key_Tab);
  REQUIRE(QApplication::focusWidget() == picture);
  const auto& time = window.picture()->animation().time;
  const auto told = [&](std::size_t frame) {
    return QString("frame %1 of %2, ").arg(frame + 1).arg(window.frameCount()) +
           QString::fromStdString(desktop::pretty_quantity(time[frame], "s", 5));
  };
  const QString bearing = QString::fromStdString(view_title(View::Bearing)) + "; ";
  CHECK(picture->accessibleDescription() == bearing + told(0));
  for (std::size_t frame = 1; frame < 4; ++frame) {
    QTest::keyClick(picture, Qt::Key_Right);
    CHECK(picture->accessibleDescription() == bearing + told(frame));
  }
  window.setView(View::Element, 2);
  window.setAdditionalView(View::OuterRace, true);
  CHECK(picture->accessibleDescription() ==
        QString::fromStdString(view_title(View::Element)) + " 2, " +
            QString::fromStdString(view_title(View::OuterRace)) + "; " + told(3));
  // While playing a reader is not told frame after frame: it would never end.
  QStringList seen;
  window.playForward();
  for (std::size_t frame = 4; frame < 9; ++frame) {
    window.setFrame(frame);
    if (!seen.contains(picture->accessibleDescription())) seen << picture->accessibleDescription();
  }
  REQUIRE(window.playing());
  CHECK(seen.size() == 1);
  CHECK(seen.join("").endsWith("playing"));
  window.pause();
  CHECK(picture->accessibleDescription().endsWith(told(window.currentFrame())));
}

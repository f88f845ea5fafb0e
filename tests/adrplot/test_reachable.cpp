#include "adrplot/plot_window.hpp"
#include "support/qt_app.hpp"
#include "support/qt_warnings.hpp"
#include "support/reachable.hpp"
#include "support/spoken.hpp"
#include "support/synthetic_results.hpp"

#include <QTest>
#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::adrplot;

TEST_CASE(
    "plot_window: everything has a name for those who cannot see it, and the help has the "
    "keys, the wheel and the drag",
    "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(results::SolKind::Cage));
  window.show();
  CHECK(test::nameless_widgets(window).join("; ").toStdString() == "");
  CHECK(test::unspoken_parts(window).join("; ").toStdString() == "");
  CHECK(test::clashing_letters(window).join("; ").toStdString() == "");
  const QString help = test::help_text(window, "Keys and Mouse");
  for (const char* word : {"wheel", "drag", "Home", "Alt+Left", "Ctrl+click", "legend"})
    CHECK(help.contains(word));
  CHECK(test::keys_without_help(window, help) == QStringList());
  CHECK(test::unreadable_help(window).join("; ").toStdString() == "");
}

TEST_CASE("plot_window: access keys are unique, also in dialogs", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(results::SolKind::Cage));
  window.show();
  CHECK(test::contested_letters_of_pages(window).join("; ").toStdString() == "");
  int dialogs = 0;
  CHECK(test::contested_letters_of_dialogs(window, dialogs).join("; ").toStdString() == "");
  CHECK(dialogs >= 1);
  CHECK(test::unspoken_in_dialogs(window, dialogs).join("; ").toStdString() == "");
}

TEST_CASE("plot_window: Alt+letter without an action is not typed into a field", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(results::SolKind::Cage));
  window.show();
  CHECK(test::letters_typed_by_alt(window).join("; ").toStdString() == "");
}

TEST_CASE("plot_window: every key does what the menus promise, wherever the focus is", "[gui]") {
  test::use_qt();
  PlotWindow window;
  window.addFile(test::synthetic_sol(results::SolKind::Cage));
  window.show();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  CHECK(test::keys_without_effect(window).join("; ").toStdString() == "");
}

TEST_CASE("plot_window: no Qt warnings while switches are toggled at any size", "[gui]") {
  test::use_qt();
  const test::QtWarnings warnings;
  PlotWindow window;
  for (const auto kind : {results::SolKind::Element, results::SolKind::Cage})
    window.addFile(test::synthetic_sol(kind));
  window.show();
  CHECK(test::warned_by_switches(window) == "");
}

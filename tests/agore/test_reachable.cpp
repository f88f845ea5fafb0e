#include "agore/agore_window.hpp"
#include "support/qt_app.hpp"
#include "support/qt_warnings.hpp"
#include "support/reachable.hpp"
#include "support/synthetic_results.hpp"

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
  CHECK(test::clashing_letters(window).join("; ").toStdString() == "");
  const QString help = test::help_text(window, "Keys and Mouse");
  for (const char* word :
       {"wheel", "drag", "Space", "Home", "Up, Down", "Ctrl+7", "[, ]", "+ or =, -, 0"})
    CHECK(help.contains(word));
  CHECK(test::keys_without_help(window, help) == QStringList());
  CHECK(test::unreadable_help(window).join("; ").toStdString() == "");
}

TEST_CASE("agore_window: a letter with Alt chooses one thing, in its dialogs, too", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8()));
  window.show();
  CHECK(test::contested_letters_of_pages(window).join("; ").toStdString() == "");
  int dialogs = 0;
  CHECK(test::contested_letters_of_dialogs(window, dialogs).join("; ").toStdString() == "");
  CHECK(dialogs >= 1);
}

TEST_CASE("agore_window: a letter with Alt that chooses nothing now is not typed", "[gui]") {
  test::use_qt();
  AgoreWindow window;
  window.setAnimation(prepare(test::synthetic_sol8()));
  window.show();
  CHECK(test::letters_typed_by_alt(window).join("; ").toStdString() == "");
}

TEST_CASE("agore_window: Qt has nothing to warn of while switches go off and on in every size",
          "[gui]") {
  test::use_qt();
  const test::QtWarnings warnings;
  AgoreWindow window;
  window.show();
  window.setAnimation(prepare(test::synthetic_sol8()));
  CHECK(test::warned_by_switches(window) == "");
}

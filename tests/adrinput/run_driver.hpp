#pragma once

#include "adrinput/driver.hpp"
#include "adrinput/run_panel.hpp"
#include "support/qt_app.hpp"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <utility>
#include <vector>

/// Actions of run tests on AdrInput's window.
namespace adore::adrinput {

using Launches = std::vector<std::pair<QString, QStringList>>;

inline void watch_launches(DeckWindow& window, Launches& launches) {
  window.runPanel().launch = [&launches](const QString& program, const QStringList& arguments) {
    launches.emplace_back(program, arguments);
  };
  for (const char* box : {"plots-at-end", "animation-at-end"})
    window.findChild<QCheckBox*>(box)->setChecked(true);
}

inline void run_to_end(DeckWindow& window) {
  QSignalSpy spy(&window.runPanel(), &RunPanel::finished);
  press(window, "run-deck");
  REQUIRE(window.runPanel().busy());
  REQUIRE(spy.wait(120000));
  CHECK_FALSE(window.runPanel().busy());
}

inline QString note(DeckWindow& window) { return window.findChild<QLabel*>("run-note")->text(); }

/// Starts a run whose deck is another than that of the results, which it may replace.
inline void replace_and_run(DeckWindow& window) {
  QSignalSpy spy(&window.runPanel(), &RunPanel::finished);
  window.runDeck();
  REQUIRE(spy.wait(120000));
  auto* replace = window.findChild<QPushButton*>("replace-them");
  REQUIRE(replace != nullptr);
  QTest::mouseClick(replace, Qt::LeftButton);
  REQUIRE(window.runPanel().busy());
}

inline void shorten(Document& document, const char* steps) {
  document.edit(cell("maxStps"), steps);
  document.edit(cell("kPltFreq"), "1");
  document.edit(cell("kAGraf"), "1");
}

struct QtInUse {
  QtInUse() { test::use_qt(); }
};

/// A window that runs decks in a separate folder, and the files that it would open.
struct RunBench : QtInUse {
  QTemporaryDir folder;
  DeckWindow window;
  Launches launches;
  RunBench() {
    watch_launches(window, launches);
    window.show();
  }
};

}  // namespace adore::adrinput

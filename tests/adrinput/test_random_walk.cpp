#include "adrinput/deck_window.hpp"
#include "adrinput/drawing_panel.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_page.hpp"
#include "deck/templates.hpp"
#include "desktop/theme.hpp"
#include "runs/check.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <random>

using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

/// Actions of an impatient user, in random order.
void random_walk(unsigned seed, int actions) {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::vector<std::string> texts = {"0",   "1",    "2",     "3",   "-1",    "9",     "12",
                                          "0,5", "1e-3", "1e999", "abc", "",      "''",    "0.06",
                                          "-5",  "nan",  "1.5d2", "40",  "40000", "a 'b'", "1e-9"};
  int written = 0, refused = 0;
  auto window = std::make_unique<DeckWindow>();
  window->show();
  for (int action = 0; action < actions; ++action) {
    Document& document = window->document();
    INFO("action " << action);
    const std::size_t what = below(100);
    const auto pages = document.pages();
    if (what < 55) {
      const deck::RecordSpec& spec = *page_record(window->currentRecord());
      if (spec.id == "12") {
        window->page()->findChild<QPlainTextEdit*>()->setPlainText(
            QString::fromStdString(texts[below(texts.size())]));
        window->showRecord(pages[below(pages.size())]);
        continue;
      }
      const std::size_t v = below(spec.variables.size());
      QWidget* field = window->page()->fieldOf(v);
      if (auto* combo = qobject_cast<QComboBox*>(field); combo != nullptr && below(4) != 0) {
        emit combo->activated(static_cast<int>(below(static_cast<std::size_t>(combo->count()))));
      } else if (auto* line = qobject_cast<QLineEdit*>(field)) {
        replace_text(line, QString::fromStdString(texts[below(texts.size())]));
      } else {
        const int instances = std::max(document.instances(spec.id), 1);
        document.edit(
            {std::string(spec.id), 1 + static_cast<int>(below(static_cast<std::size_t>(instances))),
             v, below(4)},
            texts[below(texts.size())]);
      }
    } else if (what < 75) {
      window->showRecord(pages[below(pages.size())]);
    } else if (what < 79) {
      window->nextRecord();
    } else if (what < 82) {
      window->goBack();
    } else if (what < 90) {
      for (std::size_t i = below(6); i > 0; --i) window->undo();
    } else if (what < 93) {
      window->redo();
    } else if (what < 94) {
      const auto& all = deck::templates();
      document.start_new(all[below(all.size())].name);
    } else if (what < 95) {
      switch (below(4)) {
        case 0:
          window->nextProblem();
          break;
        case 1:
          window->findChild<QAction*>("other-units-action")->toggle();
          break;
        case 2:
          window->drawingPanel().parentWidget()->setVisible(below(2) == 0);
          break;
        default:
          window->compareWith(deck::new_deck(deck::templates()[below(5)].name), "an example");
          if (below(2) == 0) window->switchTheme();
      }
    } else if (what < 99) {
      try {
        document.save(path);
        ++written;
        const deck::ReadResult back = deck::read_deck(path);
        CHECK(back.ok());
        CHECK(back.deck == document.deck());
        for (const Issue& issue : runs::check_model(back.deck)) {
          INFO(issue.text());
          CHECK(issue.severity != Severity::Error);
        }
      } catch (const InputError& error) {
        ++refused;
        CHECK(document.has_errors());
      }
    } else if (fs::exists(path)) {
      window->openFile(path);
    }
    while (!take_message(*window).isEmpty()) {
    }
    if (action % 50 == 0) {
      window->checkNow();
      QCoreApplication::processEvents();
    }
  }
  CHECK(written > 5);
  CHECK(refused > 20);
  desktop::apply_theme(desktop::ThemeKind::Light);
}

}  // namespace

// Ten thousand actions in four walks, so that they can go side by side.
TEST_CASE("adrinput: random walk → no crash; written decks pass the check or saving is rejected",
          "[gui][adrinput][slow]") {
  random_walk(20260101, 2500);
}
TEST_CASE("a second random walk never crashes either", "[gui][adrinput][slow][nightly]") {
  random_walk(20260202, 2500);
}
TEST_CASE("a third random walk never crashes either", "[gui][adrinput][slow][nightly]") {
  random_walk(20260303, 2500);
}
TEST_CASE("a fourth random walk never crashes either", "[gui][adrinput][slow][nightly]") {
  random_walk(20260404, 2500);
}

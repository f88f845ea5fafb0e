#include "adrinput/render.hpp"

#include "adrinput/cell_table.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/design_page.hpp"
#include "adrinput/drawing_panel.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/study_window.hpp"
#include "base/input_file.hpp"
#include "desktop/image_export.hpp"
#include "desktop/theme.hpp"
#include "runs/prepare.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QScrollArea>
#include <QScrollBar>
#include <QThread>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace adore::adrinput {

namespace fs = std::filesystem;

namespace {

/// Lists lay out their items in a later event than the one that shows them.
void settle() {
  for (int i = 0; i < 3; ++i) QApplication::processEvents();
}

template <class Condition>
void wait_for(const Condition& condition) {
  constexpr qint64 kLongest = 30'000;  // [ms]
  QElapsedTimer waited;
  waited.start();
  while (!condition() && waited.elapsed() < kLongest) {
    QApplication::processEvents();
    QThread::msleep(5);  // processEvents() waits for no event
  }
}

/// Pictures show results of the checks, not running checks.
void wait_for_checks(DeckWindow& window) {
  window.checkNow();
  wait_for([&] { return window.document().deck_state() != DeckState::Unchecked; });
}

constexpr int kOverlap = 90;  // pixels of a form in two pictures, so that no field is cut in both

/// Shows everything along a scroll bar, piece by piece.
template <class Show>
void scroll_through(QScrollBar& bar, int overlap, const Show& show) {
  for (;;) {
    show();
    if (bar.value() >= bar.maximum()) return;
    bar.setValue(bar.value() + std::max(bar.pageStep() - overlap, 1));
  }
}

}  // namespace

std::vector<fs::path> render_pages(const fs::path& deck, const RenderOptions& options) {
  const fs::path file = runs::deck_path(deck);
  reject_special_file(file);
  (void)deck::read_deck(file);  // throws for files that are not text, before a window asks
  desktop::make_folder(options.folder);
  desktop::apply_theme(options.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light);
  DeckWindow window;
  window.resize(options.width, options.height);
  window.show();
  window.openFile(file);
  wait_for_checks(window);
  std::vector<fs::path> written;
  window.showDesign();
  wait_for([&] { return !window.design().computing(); });
  settle();
  written.push_back(options.folder / "00-design.png");
  desktop::save_image(window.grab().toImage(), written.back());
  int number = 0;
  for (const std::string& record : window.document().pages()) {
    ++number;
    window.showRecord(record);
    window.drawingPanel().drawNow();
    settle();
    int part = 0;
    const auto draw = [&] {
      settle();
      const std::string name = ++part == 1 ? fmt::format("{:02}-{}.png", number, record)
                                           : fmt::format("{:02}-{}-{}.png", number, record, part);
      written.push_back(options.folder / name);
      desktop::save_image(window.grab().toImage(), written.back());
    };
    scroll_through(*window.pageArea().verticalScrollBar(), kOverlap, draw);
    // Wide tables: the first columns are drawn already.
    for (CellTable* table : window.page()->findChildren<CellTable*>()) {
      QScrollBar* bar = table->horizontalScrollBar();
      if (!table->isVisible() || bar->maximum() == bar->minimum()) continue;
      window.pageArea().ensureWidgetVisible(table, 20, 20);
      bool first = true;
      scroll_through(*bar, 1, [&] {
        if (!std::exchange(first, false)) draw();
      });
      bar->setValue(bar->minimum());
    }
  }
  return written;
}

std::vector<fs::path> render_study(const fs::path& file, const RenderOptions& options) {
  (void)read_text_file(file);  // throws for unreadable files, before a window asks
  desktop::make_folder(options.folder);
  desktop::apply_theme(options.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light);
  StudyWindow window;
  window.resize(options.width, options.height);
  window.show();
  window.openFile(file);
  std::vector<fs::path> written;
  const auto draw = [&](const std::string& name) {
    settle();
    written.push_back(options.folder / name);
    desktop::save_image(window.grab().toImage(), written.back());
  };
  settle();
  int part = 0;
  scroll_through(*window.formArea().verticalScrollBar(), kOverlap,
                 [&] { draw(fmt::format("study-form-{}.png", ++part)); });
  window.showText(true);
  draw("study-file.png");
  return written;
}

}  // namespace adore::adrinput

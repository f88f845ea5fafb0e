#include "adrinput/render.hpp"

#include "adrinput/deck_window.hpp"
#include "adrinput/drawing_panel.hpp"
#include "adrinput/record_page.hpp"
#include "desktop/image_export.hpp"
#include "desktop/theme.hpp"
#include "facade/prepare.hpp"

#include <QApplication>
#include <QScrollArea>
#include <QScrollBar>
#include <fmt/format.h>

#include <algorithm>

namespace adore::adrinput {

namespace fs = std::filesystem;

namespace {

/// Lists lay out their items in a later event than the one that shows them.
void settle() {
  for (int i = 0; i < 3; ++i) QApplication::processEvents();
}

}  // namespace

std::vector<fs::path> render_pages(const fs::path& deck, const RenderOptions& options) {
  const fs::path file = facade::deck_path(deck);
  (void)deck::read_deck(file);  // throws for what is no text, before a window asks
  desktop::make_folder(options.folder);
  desktop::apply_theme(options.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light);
  DeckWindow window;
  window.resize(options.width, options.height);
  window.show();
  window.openFile(file);
  std::vector<fs::path> written;
  int number = 0;
  for (const std::string& record : window.document().pages()) {
    ++number;
    window.showRecord(record);
    window.drawingPanel().drawNow();
    settle();
    QScrollBar* bar = window.pageArea().verticalScrollBar();
    for (int part = 1;; ++part) {
      const std::string name = part == 1 ? fmt::format("{:02}-{}.png", number, record)
                                         : fmt::format("{:02}-{}-{}.png", number, record, part);
      written.push_back(options.folder / name);
      desktop::save_image(window.grab().toImage(), written.back());
      if (bar->value() >= bar->maximum()) break;
      bar->setValue(bar->value() + bar->pageStep());
      settle();
    }
  }
  return written;
}

}  // namespace adore::adrinput

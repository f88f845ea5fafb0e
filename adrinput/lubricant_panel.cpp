#include "adrinput/lubricant_panel.hpp"

#include "base/errors.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/lubricant_pages.hpp"

#include <QComboBox>
#include <QDockWidget>
#include <QMainWindow>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

namespace adore::adrinput {
namespace {

constexpr int kPause = 300;  // ms
constexpr int kUsers = 9;    // kTrac

/// A value of the deck in SI that is there and in use, else the fallback.
double value_or(const deck::Deck& deck, const char* name, double fallback) {
  try {
    return deck.has(name) ? deck.si(name) : fallback;
  } catch (const InputError&) {
    return fallback;  // not typed yet
  }
}

desktop::ChartPage sentence(const std::string& text) {
  desktop::ChartPage page;
  page.title = "Lubricant";
  page.note = text;
  return page;
}

}  // namespace

std::optional<calculators::LubricantContact> lubricant_contact(const deck::Deck& deck) {
  const long long code = deck.integer("kTrac");
  if (code < 1 || code == kUsers) return std::nullopt;
  calculators::LubricantContact out;
  out.code = static_cast<int>(code);
  out.temperature = 0.5 * (value_or(deck, "raceTemp2", out.temperature) +
                           value_or(deck, "reTemp", out.temperature));
  out.roughness = value_or(deck, "rmsAspHt2", out.roughness);
  out.critical_film = value_or(deck, "reRaceFilm", out.critical_film);
  out.meniscus = value_or(deck, "strParam", out.meniscus);
  out.metal_type = static_cast<int>(deck.integer("kTracType"));
  for (std::size_t n = 0; n < out.metal.size(); ++n)
    out.metal[n] = value_or(deck, ("reRaceTC" + std::to_string(n + 1)).c_str(), out.metal[n]);
  return out;
}

LubricantPanel::LubricantPanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  pages_ = new QComboBox(this);
  pages_->setObjectName("lubricant-page");
  pages_->addItems(
      {tr("Traction over slip"), tr("Viscosity over pressure"), tr("Film and lambda")});
  chart_ = new desktop::ChartView(this);
  chart_->setObjectName("lubricant-chart");
  pause_ = new QTimer(this);
  pause_->setSingleShot(true);
  pause_->setInterval(kPause);
  column->addWidget(pages_);
  column->addWidget(chart_, 1);
  connect(pause_, &QTimer::timeout, this, &LubricantPanel::showPage);
  connect(pages_, &QComboBox::currentIndexChanged, this, &LubricantPanel::showPage);
}

LubricantPanel* LubricantPanel::inDockOf(QMainWindow* window) {
  auto* dock = new QDockWidget(tr("Lubricant"), window);
  dock->setObjectName("lubricant-dock");
  auto* panel = new LubricantPanel(dock);
  dock->setWidget(panel);
  window->addDockWidget(Qt::RightDockWidgetArea, dock);
  dock->hide();
  return panel;
}

void LubricantPanel::setDeck(const deck::Deck& deck) {
  deck_ = deck;
  if (isVisible()) pause_->start();
}

void LubricantPanel::drawNow() {
  pause_->stop();
  showPage();
}

void LubricantPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  pause_->start();
}

void LubricantPanel::showPage() {
  if (!isVisible()) return;
  const std::optional<calculators::LubricantContact> contact = lubricant_contact(deck_);
  if (!contact)
    return chart_->showPage(sentence(
        deck_.integer("kTrac") == kUsers
            ? "kTrac = 9 is the lubricant of records 10.4.0 to 10.4.4: it has no charts here; a "
              "quasi-static solution (F6) shows its films and friction"
            : "kTrac on record 10.0 names no lubricant of the table (1 to 20 but 9)"));
  try {
    desktop::ChartPage page = desktop::lubricant_pages(*contact, desktop::LubricantTitle::Lubricant)
                                  .at(static_cast<std::size_t>(pages_->currentIndex()));
    // There is little room: what is drawn stands in the list above, doubts come before conditions.
    page.note += (page.note.empty() ? "" : "; ") + page.subtitle;
    page.subtitle.clear();
    chart_->showPage(page);
  } catch (const InputError& error) {
    chart_->showPage(sentence(error.what()));
  }
}

}  // namespace adore::adrinput

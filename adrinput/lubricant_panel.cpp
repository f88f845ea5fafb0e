#include "adrinput/lubricant_panel.hpp"

#include "base/errors.hpp"
#include "calculators/deck_lubricant.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/lubricant_pages.hpp"
#include "desktop/spoken_name.hpp"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace adore::adrinput {
namespace {

constexpr int kPause = 300;                           // ms
constexpr int kLeastWidth = 400, kLeastHeight = 360;  // of a chart with four lines of notes
constexpr int kLeastDockWidth = 140, kLeastDockHeight = 120;
constexpr int kDockTitle = 40;     // its height, at most
constexpr int kRoomForDock = 640;  // width of the window for list and form next to the dock

desktop::ChartPage sentence(const std::string& text) {
  desktop::ChartPage page;
  page.title = "Lubricant";
  page.note = text;
  return page;
}

}  // namespace

LubricantPanel::LubricantPanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  page_box_ = new QComboBox(this);
  page_box_->setObjectName("lubricant-page");
  desktop::set_accessible_name(*page_box_, tr("Lubricant chart"));
  page_box_->addItems(
      {tr("Traction over slip"), tr("Viscosity over pressure"), tr("Film and lambda")});
  chart_ = new desktop::ChartView(this);
  chart_->setObjectName("lubricant-chart");
  chart_->setMinimumSize(kLeastWidth, kLeastHeight);
  conditions_ = new QLabel(this);
  conditions_->setObjectName("lubricant-conditions");
  conditions_->setAccessibleName(tr("Chart conditions"));
  conditions_->setWordWrap(true);
  conditions_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // Docks do not ask a label for its height: three lines at the smallest width.
  conditions_->setMinimumHeight(3 * conditions_->fontMetrics().lineSpacing() + 4);
  conditions_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  delay_timer_ = new QTimer(this);
  delay_timer_->setSingleShot(true);
  delay_timer_->setInterval(kPause);
  column->addWidget(page_box_);
  column->addWidget(chart_, 1);
  column->addWidget(conditions_);
  connect(delay_timer_, &QTimer::timeout, this, &LubricantPanel::showPage);
  connect(page_box_, &QComboBox::currentIndexChanged, this, &LubricantPanel::showPage);
}

LubricantPanel* LubricantPanel::createInDock(QMainWindow* window) {
  auto* dock = new QDockWidget(tr("Lubricant"), window);
  dock->setObjectName("lubricant-dock");
  auto* panel = new LubricantPanel;
  auto* scroll = new QScrollArea(dock);  // narrower than its charts can be read, it scrolls
  scroll->setAccessibleName(tr("Lubricant"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(panel);
  scroll->setMinimumSize(kLeastDockWidth, kLeastDockHeight);
  dock->setWidget(scroll);
  window->addDockWidget(Qt::RightDockWidgetArea, dock);
  dock->hide();
  connect(dock->toggleViewAction(), &QAction::triggered, dock, [window, dock, panel](bool shown) {
    if (!shown) return;
    const QSize whole = panel->minimumSizeHint() + QSize(2, kDockTitle);
    if (window->width() >= kRoomForDock + whole.width())
      window->resizeDocks({dock}, {whole.width()}, Qt::Horizontal);
    QList<QDockWidget*> docks{dock};  // and those below it
    QList<int> heights{whole.height()};
    for (QDockWidget* other : window->findChildren<QDockWidget*>())
      if (other != dock && other->isVisible() && !other->isFloating()) {
        docks.append(other);
        heights.append(std::max(1, window->centralWidget()->height() - whole.height()));
      }
    window->resizeDocks(docks, heights, Qt::Vertical);
  });
  return panel;
}

void LubricantPanel::setDeck(const deck::Deck& deck) {
  deck_ = deck;
  if (isVisible()) delay_timer_->start();
}

void LubricantPanel::drawNow() {
  delay_timer_->stop();
  showPage();
}

void LubricantPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  delay_timer_->start();
}

void LubricantPanel::showPage() {
  if (!isVisible()) return;
  conditions_->hide();
  try {
    const auto contact = calculators::lubricant_contact(deck_);
    if (!contact)
      return chart_->showPage(sentence(
          deck_.integer("kTrac") == 0 ? "The deck has no lubricant (kTrac = 0 in record 10.0). All "
                                        "contacts use the traction curves of records 10.1 to 10.5, "
                                        "which are drawn on the pages of these records."
                                      : "kTrac in record 10.0 does not select a built-in "
                                        "lubricant. The user routine ADRX7 defines the traction."));
    desktop::ChartPage page = desktop::lubricant_pages(*contact, desktop::LubricantTitle::Lubricant)
                                  .at(static_cast<std::size_t>(page_box_->currentIndex()));
    // The space is limited: the list above names the charts, the conditions are below.
    conditions_->setText(QString::fromStdString(page.title + ": " + page.subtitle));
    page.title = page.title.substr(0, page.title.find(" ("));
    page.subtitle.clear();
    chart_->showPage(page);
    conditions_->show();
  } catch (const InputError& error) {
    chart_->showPage(sentence(error.what()));
  }
}

}  // namespace adore::adrinput

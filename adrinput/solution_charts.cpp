#include "adrinput/solution_charts.hpp"

#include "desktop/chart_view.hpp"
#include "desktop/spoken_name.hpp"
#include "desktop/static_pages.hpp"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace adore::adrinput {
namespace {

// In a low dock the charts scroll: titles of axes lower than these are cut.
constexpr int kHead = 150;            // title, note and the axis below
constexpr int kPanel = 145;           // of several below each other
constexpr int kOne = 370;             // alone, with a long title
constexpr int kMinScrollWidth = 130;  // of the area in which a chart scrolls

}  // namespace

SolutionCharts::SolutionCharts(QWidget* parent)
    : QWidget(parent),
      page_box_(new QComboBox(this)),
      note_(new QLabel(this)),
      view_(new desktop::ChartView(this)) {
  page_box_->setObjectName("solution-page");
  desktop::set_accessible_name(*page_box_, tr("Chart of the quasi-static solution"));
  page_box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  page_box_->setMinimumContentsLength(6);
  note_->setWordWrap(true);
  note_->setMargin(6);
  view_->setObjectName("solution-chart");
  view_->setAccessibleName(tr("Chart of the quasi-static solution"));
  scroll_area_ = new QScrollArea(this);
  scroll_area_->setWidgetResizable(true);
  scroll_area_->setFrameShape(QFrame::NoFrame);
  scroll_area_->setFocusPolicy(Qt::NoFocus);
  scroll_area_->setMinimumSize(kMinScrollWidth, 160);
  scroll_area_->setWidget(view_);
  invalidateResult();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(page_box_);
  layout->addWidget(note_);
  layout->addWidget(scroll_area_, 1);
  layout->addStretch(0);
  connect(page_box_, &QComboBox::activated, this, &SolutionCharts::showPage);
}

int SolutionCharts::fullChartWidth() const {
  const QMargins margins = layout()->contentsMargins();
  return view_->minimumWidth() + scroll_area_->verticalScrollBar()->sizeHint().width() +
         margins.left() + margins.right();
}

QStringList SolutionCharts::pages() const {
  QStringList out;
  for (int i = 0; i < page_box_->count(); ++i) out << page_box_->itemText(i);
  return out;
}

void SolutionCharts::choosePage(int index) {
  page_box_->setCurrentIndex(index);
  showPage(index);
}

void SolutionCharts::setSolution(const results::StaticTables& tables) {
  tables_ = tables;
  const QString before = page_box_->currentText();
  page_box_->clear();
  for (const desktop::ChartPage& page : desktop::static_pages(tables_))
    page_box_->addItem(QString::fromStdString(page.title));
  const bool any = page_box_->count() > 0;
  page_box_->setVisible(any);
  scroll_area_->setVisible(any);
  setStale(false);
  if (any) choosePage(std::max(page_box_->findText(before), 0));
}

void SolutionCharts::invalidateResult() {
  tables_ = {};
  page_box_->clear();
  page_box_->hide();
  scroll_area_->hide();
  note_->setText(tr("Run the quasi-static solution (F6) to see its charts here."));
  note_->show();
}

void SolutionCharts::setStale(bool stale) {
  if (page_box_->count() == 0) return;
  note_->setText(tr("Out of date: the deck has changed."));
  note_->setVisible(stale);
}

void SolutionCharts::showPage(int index) {
  const std::vector<desktop::ChartPage> pages = desktop::static_pages(tables_);
  if (index < 0 || index >= static_cast<int>(pages.size())) return;
  const desktop::ChartPage& page = pages[static_cast<std::size_t>(index)];
  view_->setMinimumHeight(std::max(kOne, kHead + kPanel * static_cast<int>(page.panels.size())));
  view_->showPage(page);
}

}  // namespace adore::adrinput

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
constexpr int kHead = 150;        // title, note and the axis below
constexpr int kPanel = 145;       // of several below each other
constexpr int kOne = 370;         // alone, with a long title
constexpr int kLeastWidth = 130;  // of the area in which a chart scrolls

}  // namespace

SolutionCharts::SolutionCharts(QWidget* parent)
    : QWidget(parent),
      choice_(new QComboBox(this)),
      note_(new QLabel(this)),
      view_(new desktop::ChartView(this)) {
  choice_->setObjectName("solution-page");
  desktop::name_box(*choice_, tr("Chart of the quasi-static solution"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(6);
  note_->setWordWrap(true);
  note_->setMargin(6);
  view_->setObjectName("solution-chart");
  view_->setAccessibleName(tr("Chart of the quasi-static solution"));
  area_ = new QScrollArea(this);
  area_->setWidgetResizable(true);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setFocusPolicy(Qt::NoFocus);
  area_->setMinimumSize(kLeastWidth, 160);
  area_->setWidget(view_);
  forget();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(choice_);
  layout->addWidget(note_);
  layout->addWidget(area_, 1);
  layout->addStretch(0);
  connect(choice_, &QComboBox::activated, this, &SolutionCharts::showPage);
}

int SolutionCharts::wholeWidth() const {
  const QMargins margins = layout()->contentsMargins();
  return view_->minimumWidth() + area_->verticalScrollBar()->sizeHint().width() + margins.left() +
         margins.right();
}

QStringList SolutionCharts::pages() const {
  QStringList out;
  for (int i = 0; i < choice_->count(); ++i) out << choice_->itemText(i);
  return out;
}

void SolutionCharts::choosePage(int index) {
  choice_->setCurrentIndex(index);
  showPage(index);
}

void SolutionCharts::setSolution(const results::StaticTables& tables) {
  tables_ = tables;
  const QString before = choice_->currentText();
  choice_->clear();
  for (const desktop::ChartPage& page : desktop::static_pages(tables_))
    choice_->addItem(QString::fromStdString(page.title));
  const bool any = choice_->count() > 0;
  choice_->setVisible(any);
  area_->setVisible(any);
  setStale(false);
  if (any) choosePage(std::max(choice_->findText(before), 0));
}

void SolutionCharts::forget() {
  tables_ = {};
  choice_->clear();
  choice_->hide();
  area_->hide();
  note_->setText(tr("Run the quasi-static solution (F6) to see its charts here."));
  note_->show();
}

void SolutionCharts::setStale(bool stale) {
  if (choice_->count() == 0) return;
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

#include "adrinput/design_card.hpp"

#include "adrinput/record_list.hpp"
#include "base/counted.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/theme.hpp"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>

#include <algorithm>

namespace adore::adrinput {
namespace {

constexpr int kListHeight = 90;  // of the findings, at least
constexpr int kColumns = 3;      // of one half: label, value, gap

/// Groups of the left half; all others are in the right one.
bool is_left(const std::string& group) {
  return group == "Life" || group == "Contacts" || group == "Film";
}

}  // namespace

DesignResultsPanel::DesignResultsPanel(QWidget* parent)
    : QWidget(parent),
      state_(new QLabel(this)),
      heading_(new QLabel(this)),
      grid_(new QGridLayout),
      list_(new QListWidget(this)) {
  setObjectName("design-card");
  state_->setObjectName("design-state");
  state_->setWordWrap(true);
  heading_->setFont(desktop::ui_font(15, true));
  grid_->setHorizontalSpacing(10);
  grid_->setVerticalSpacing(1);
  list_->setObjectName("design-findings");
  list_->setAccessibleName(tr("Findings"));
  list_->setWordWrap(true);
  list_->setResizeMode(QListView::Adjust);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setMinimumHeight(kListHeight);
  const auto chosen = [this](QListWidgetItem* item) {
    const int row = list_->row(item);
    if (row >= 0 && row < static_cast<int>(findings_.size()))
      emit findingChosen(findings_[static_cast<std::size_t>(row)]);
  };
  connect(list_, &QListWidget::itemClicked, this, chosen);
  connect(list_, &QListWidget::itemActivated, this, chosen);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 8);
  column->setSpacing(4);
  column->addWidget(heading_);
  column->addWidget(state_);
  column->addLayout(grid_);
  column->addWidget(list_, 1);
  setSummary(std::nullopt, tr("Computing …"));
}

void DesignResultsPanel::setSummary(std::optional<design::DesignSummary> summary,
                                    const QString& failure) {
  failure_ = failure;
  stale_ = false;
  // Without a new summary the old values stay, pale.
  if (summary) summary_ = std::move(summary);
  const bool first = summary_ && rows_.empty();
  if (first) buildRows();
  fillRows();
  if (first) emit rowsBuilt();
}

void DesignResultsPanel::setStale(bool stale) {
  if (stale == stale_) return;
  stale_ = stale;
  fillRows();
}

/// One label per value: the ids are the same for every deck.
void DesignResultsPanel::buildRows() {
  int row[2] = {0, 0};
  std::string group[2];
  for (const design::DesignValue& one : summary_->values) {
    const int side = is_left(one.group) ? 0 : 1;
    const int column = side * kColumns;
    if (one.group != group[side]) {
      group[side] = one.group;
      auto* title = new QLabel(QString::fromStdString(one.group), this);
      title->setFont(desktop::ui_font(12, true));
      title->setContentsMargins(0, row[side] == 0 ? 0 : 5, 0, 0);
      grid_->addWidget(title, row[side]++, column, 1, 2);
    }
    auto* name = new QLabel(QString::fromStdString(one.label), this);
    auto* value = new QLabel(this);
    value->setObjectName(QString::fromStdString("design-" + one.id));
    value->setAccessibleName(name->text());
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setMinimumWidth(fontMetrics().horizontalAdvance("> 1 000 000 h"));
    grid_->addWidget(name, row[side], column);
    grid_->addWidget(value, row[side]++, column + 1);
    rows_[one.id] = {name, value};
  }
  grid_->setColumnMinimumWidth(2, 12);
  grid_->setColumnStretch(0, 1);
  grid_->setColumnStretch(kColumns, 1);
}

void DesignResultsPanel::fillRows() {
  const desktop::Theme& theme = desktop::current_theme();
  const bool old = stale_ || !failure_.isEmpty();
  heading_->setText(summary_ ? tr("Results: %1").arg(QString::fromStdString(summary_->bearing))
                             : tr("Results"));
  state_->setText(!failure_.isEmpty() ? failure_
                  : stale_            ? tr("Computing …")
                                      : tr("Quasi-static solution, up to date"));
  QPalette told = state_->palette();
  told.setColor(QPalette::WindowText, failure_.isEmpty() || !summary_ ? theme.muted : theme.red);
  state_->setPalette(told);
  if (summary_)
    for (const design::DesignValue& one : summary_->values) {
      const Row& row = rows_.at(one.id);
      row.name->setText(QString::fromStdString(one.label));
      QLabel* label = row.value;
      label->setText(QString::fromStdString(design::quantity_text(one)));
      label->setToolTip(QString::fromStdString(one.note));
      QPalette palette = label->palette();
      palette.setColor(QPalette::WindowText, one.value && !old ? theme.text : theme.muted);
      label->setPalette(palette);
    }
}

void DesignResultsPanel::setFindings(std::vector<Finding> findings) {
  findings_ = std::move(findings);
  std::stable_sort(findings_.begin(), findings_.end(), [](const Finding& a, const Finding& b) {
    return static_cast<int>(a.severity) > static_cast<int>(b.severity);
  });
  list_->clear();
  for (const Finding& one : findings_)
    list_->addItem(new QListWidgetItem(
        state_icon(one.severity == Severity::Error     ? RecordState::Wrong
                   : one.severity == Severity::Warning ? RecordState::Doubtful
                                                       : RecordState::Untouched),
        desktop::finding_text(one)));
  if (findings_.empty()) list_->addItem(tr("No findings."));
}

QString DesignResultsPanel::textOf(const std::string& id) const {
  const auto found = rows_.find(id);
  return found == rows_.end() ? QString() : found->second.value->text();
}

void DesignResultsPanel::restyle() {
  fillRows();
  setFindings(findings_);
}

}  // namespace adore::adrinput

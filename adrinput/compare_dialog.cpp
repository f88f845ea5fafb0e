#include "adrinput/compare_dialog.hpp"

#include "adrinput/help_text.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/theme.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace adore::adrinput {
namespace {

constexpr int kRowRole = Qt::UserRole;

QString counted(int number, const QString& one, const QString& many) {
  return QString("%1 %2").arg(number).arg(number == 1 ? one : many);
}

}  // namespace

CompareDialog::CompareDialog(const Document& document, deck::Deck other, const QString& name,
                             QWidget* parent)
    : QDialog(parent),
      document_(document),
      other_deck_(std::move(other)),
      other_deck_name_(name),
      summary_(new QLabel(this)),
      include_labels_box_(new QCheckBox(tr("Include record &labels"), this)),
      list_(new QListWidget(this)) {
  setObjectName("compare");
  desktop::delete_when_done(*this);
  setWindowTitle(tr("Compare with %1").arg(name));
  resize(820, 560);
  summary_->setObjectName("summary");
  summary_->setWordWrap(true);
  summary_->setTextFormat(Qt::PlainText);
  include_labels_box_->setObjectName("labels");
  list_->setObjectName("differences");
  list_->setAccessibleName(tr("Differences"));
  list_->setWordWrap(true);
  list_->setResizeMode(QListView::Adjust);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(summary_);
  layout->addWidget(list_, 1);
  layout->addWidget(include_labels_box_);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(include_labels_box_, &QCheckBox::toggled, this, &CompareDialog::sync);
  connect(list_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { choose(list_->row(item)); });
  connect(list_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { choose(list_->row(item)); });
  list_->setFocus();
  sync();
}

void CompareDialog::sync() {
  differences_ = deck::differences(document_.deck(), other_deck_);
  const auto label = [](const deck::Difference& d) { return d.label; };
  const auto labels =
      static_cast<int>(std::count_if(differences_.begin(), differences_.end(), label));
  if (!include_labels_box_->isChecked()) std::erase_if(differences_, label);
  const int number =
      static_cast<int>(differences_.size()) - (include_labels_box_->isChecked() ? labels : 0);
  QString text = number == 0 ? tr("No difference from %1").arg(other_deck_name_)
                             : tr("%1 from %2")
                                   .arg(counted(number, tr("difference"), tr("differences")),
                                        other_deck_name_);
  if (labels > 0)
    text += tr("; %1 (no effect on a run)")
                .arg(counted(labels, tr("record label differs"), tr("record labels differ")));
  text += tr(". \"Here\" is the deck in the window, and \"there\" is %1.").arg(other_deck_name_);
  summary_->setText(text);
  include_labels_box_->setEnabled(labels > 0);

  const int current = list_->currentRow();
  list_->clear();
  std::string record;
  for (std::size_t i = 0; i < differences_.size(); ++i) {
    const deck::Difference& row = differences_[i];
    if (row.variable.empty() && row.record != "12") {
      record.clear();
      QString heading = page_heading(*deck::find_record(row.record));
      if (row.instance > 1) heading += QString(" (%1)").arg(row.instance);
      auto* item = new QListWidgetItem(
          tr("%1: only %2").arg(heading, row.in_left ? tr("here") : tr("there")), list_);
      item->setFont(desktop::ui_font(13, true));
      item->setData(kRowRole, static_cast<int>(i));
      continue;
    }
    if (row.record != record) {
      record = row.record;
      auto* heading = new QListWidgetItem(page_heading(*deck::find_record(record)), list_);
      heading->setFont(desktop::ui_font(13, true));
      heading->setFlags(Qt::ItemIsEnabled);
      heading->setData(kRowRole, -1);
    }
    auto* item = new QListWidgetItem("    " + QString::fromStdString(row.sentence), list_);
    item->setData(kRowRole, static_cast<int>(i));
  }
  list_->setCurrentRow(std::clamp(current, list_->count() > 1 ? 1 : 0, list_->count() - 1));
}

/// A value that only the other deck has has no field; its record is shown if it exists.
void CompareDialog::choose(int row) {
  const int at = list_->item(row)->data(kRowRole).toInt();
  if (at < 0 || at >= static_cast<int>(differences_.size())) return;
  const deck::Difference& difference = differences_[static_cast<std::size_t>(at)];
  Cell cell;
  cell.record = difference.record;
  cell.instance = difference.instance;
  cell.element = static_cast<std::size_t>(std::max(difference.index, 1)) - 1;
  const auto& variables = deck::find_record(cell.record)->variables;
  for (std::size_t v = 0; v < variables.size(); ++v)
    if (variables[v].name == difference.variable) cell.variable = v;
  emit cellChosen(cell);
}

}  // namespace adore::adrinput

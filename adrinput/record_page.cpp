#include "adrinput/record_page.hpp"

#include "adrinput/cell_table.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/page_parts.hpp"
#include "desktop/theme.hpp"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace adore::adrinput {
namespace {

constexpr int kGridRows = 6;  // of a variable

}  // namespace

RecordPage::RecordPage(Document& document, const std::string& record, QWidget* parent)
    : QWidget(parent), document_(document), record_(record), spec_(*page_record(record)) {
  setObjectName("page");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 14, 20, 14);
  layout->setSpacing(8);
  addHeading(layout);
  if (spec_.id == "12") {
    addUserLines(layout);
  } else if (is_diameter_record(record_)) {
    addListedDiameters(layout);
  } else if (!spec_.repeat.empty()) {
    addInstances(layout);
  } else {
    auto* grid = make_grid();
    for (std::size_t v = 0; v < spec_.variables.size(); ++v) addVariable(grid, v);
    layout->addLayout(grid);
  }
  layout->addStretch(1);
  sync(true);
}

RecordPage::~RecordPage() = default;

void RecordPage::addHeading(QVBoxLayout* layout) {
  auto* title = new QLabel(page_heading(spec_), this);
  title->setObjectName("title");
  title->setFont(desktop::ui_font(18, true));
  title->setWordWrap(true);
  condition_label_ = make_text_label({}, desktop::current_theme().muted, this);
  layout->addWidget(title);
  layout->addWidget(condition_label_);
}

Cell RecordPage::cellOf(std::size_t variable) const {
  Cell cell;
  cell.record = record_;
  cell.variable = variable;
  return cell;
}

/// The name next to the value or, on a narrow page, above it.
void RecordPage::place(Row& row) {
  const int column = narrow_layout_ ? 0 : 1, span = narrow_layout_ ? 2 : 1;
  // If a table contains all variables, a grid below it describes each.
  const std::vector<QLabel*> below =
      row.value != nullptr ? std::vector<QLabel*>{row.other, row.problem, row.help, row.unused}
                           : std::vector<QLabel*>{row.help, row.unit, row.problem};
  row.grid->removeWidget(row.name);
  for (QLabel* label : below) row.grid->removeWidget(label);
  if (row.value != nullptr) row.grid->removeItem(row.value);
  row.grid->addWidget(row.name, narrow_layout_ ? row.at : row.at + 1, 0, 1, span,
                      row.table != nullptr ? Qt::AlignTop : Qt::AlignVCenter);
  int at = row.at + 1;
  if (row.value != nullptr) row.grid->addLayout(row.value, at++, column, 1, span);
  if (row.side != nullptr) {
    row.side->removeWidget(row.unit);
    row.value->removeWidget(row.unit);
    if (narrow_layout_)
      row.value->insertWidget(1, row.unit);
    else
      row.side->insertWidget(row.side->count() - 1, row.unit, 1000);
  }
  for (QLabel* label : below) row.grid->addWidget(label, at++, column, 1, span);
  row.grid->setRowMinimumHeight(row.at + kGridRows, 8);
}

/// Sideways scrolling is worse than a longer page.
void RecordPage::fitToWidth(int width) {
  constexpr int kLetters = 42;  // width of a value next to its name
  int names = 0, least = 0;
  for (const Row& row : rows_) {
    if (row.grid == nullptr) continue;
    names = std::max(names, row.name->sizeHint().width());
    least = std::max(least, kLetters * row.help->fontMetrics().averageCharWidth());
    least = std::max(least, row.help->minimumSizeHint().width());
    if (row.side != nullptr)
      least = std::max(least, row.side->minimumSize().width() +
                                  (narrow_layout_ ? row.unit->minimumSizeHint().width() : 0));
  }
  const QMargins margins = layout()->contentsMargins();
  const int room = width - margins.left() - margins.right() - names - kBetween;
  const bool narrow = room < least;
  if (narrow != narrow_layout_) {
    narrow_layout_ = narrow;
    for (Row& row : rows_)
      if (row.grid != nullptr) place(row);
  }
}

void RecordPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  for (Row& row : rows_)
    if (row.combo != nullptr)
      showStatusOfRow(row);  // a narrower list shows its hidden text in a tooltip
}

bool RecordPage::event(QEvent* event) {
  if (event->type() == QEvent::ParentChange && parentWidget() != nullptr) {
    parentWidget()->installEventFilter(this);  // visible area of the page
    fitToWidth(parentWidget()->width());
  }
  return QWidget::event(event);
}

void RecordPage::setOtherUnitsShown(bool shown) {
  shows_other_units_ = shown;
  if (other_units_ != nullptr) other_units_->setChecked(shown);
  for (Row& row : rows_)
    if (row.table != nullptr) row.table->setOtherUnitsShown(shown);
  sync();
}

bool RecordPage::eventFilter(QObject* object, QEvent* event) {
  auto* field = qobject_cast<QWidget*>(object);
  if (object == parentWidget()) {
    if (event->type() == QEvent::Resize) fitToWidth(field->width());
    return false;
  }
  if (event->type() == QEvent::Wheel && !field->hasFocus() &&
      qobject_cast<QComboBox*>(field) != nullptr) {
    event->ignore();  // scrolling over a form must not change it
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();  // undo of the deck, not of the field
      return true;
    }
  }
  if (event->type() == QEvent::KeyPress && openMenuOf(field, *static_cast<QKeyEvent*>(event)))
    return true;
  if (event->type() == QEvent::KeyPress && field->property("typing").toBool() &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Tab) {
    // A count may create the next table: it has to exist before Tab looks for it.
    if (auto* line = qobject_cast<QLineEdit*>(field)) emit line->editingFinished();
  }
  if (event->type() == QEvent::FocusIn) {
    emit focusMoved(field);
    announceFocusedCell(field);
  }
  if (event->type() == QEvent::FocusOut && user_lines_edit_ == object) document_.end_undo_step();
  return QWidget::eventFilter(object, event);
}

/// Alt+Down opens the menu of the button after a field.
bool RecordPage::openMenuOf(const QWidget* field, const QKeyEvent& key) {
  if (key.key() != Qt::Key_Down || !key.modifiers().testFlag(Qt::AltModifier)) return false;
  for (const Row& row : rows_) {
    QToolButton* button = row.choice != nullptr ? row.choice : row.names;
    if (row.line == nullptr || row.line != field || button == nullptr || button->isHidden())
      continue;
    button->menu()->popup(button->mapToGlobal(button->rect().bottomLeft()));
    for (QAction* action : button->menu()->actions())  // the keys start from the current choice
      if (action->isChecked() && row.choice != nullptr) button->menu()->setActiveAction(action);
    return true;
  }
  return false;
}

void RecordPage::announceFocusedCell(const QWidget* field) {
  for (const Row& row : rows_) {
    if (row.table != nullptr && row.table == field) {
      const int at = row.table->currentRow();
      emit cellFocused(at < 0 ? cellOf(row.variable)
                              : row.table->cellAt(at, row.table->currentColumn()));
      return;
    }
    const bool here =
        (row.line != nullptr && row.line == field) ||
        (row.combo != nullptr && (row.combo == field || row.combo->lineEdit() == field));
    if (here) emit cellFocused(cellOf(row.variable));
  }
}

QWidget* RecordPage::fieldOf(std::size_t variable) const {
  if (user_lines_edit_ != nullptr) return user_lines_edit_;
  for (const Row& row : rows_)
    if (row.variable == variable) {
      if (row.line != nullptr) return row.line;
      if (row.combo != nullptr) return row.combo;
      return row.table;
    }
  return nullptr;
}

bool RecordPage::focusCell(const Cell& cell) {
  QWidget* field = fieldOf(cell.variable);
  if (field == nullptr || cell.record != record_) return false;
  if (auto* table = qobject_cast<CellTable*>(field)) {
    const bool there = table->focusCell(cell);
    emit focusMoved(table);
    announceFocusedCell(table);  // an inactive window gets no focus event
    return there;
  }
  field->setFocus(Qt::OtherFocusReason);
  if (auto* line = qobject_cast<QLineEdit*>(field)) line->selectAll();
  emit focusMoved(field);
  announceFocusedCell(field);
  return true;
}

void RecordPage::focusFirst() {
  if (user_lines_edit_ != nullptr) return user_lines_edit_->setFocus();
  if (rows_.size() > 1) focusCell(cellOf(record_ == kOptionsPage ? 0 : 1));  // behind the label
}

}  // namespace adore::adrinput

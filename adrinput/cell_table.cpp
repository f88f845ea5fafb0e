#include "adrinput/cell_table.hpp"

#include "adrinput/page_parts.hpp"
#include "adrinput/typed.hpp"
#include "adrinput/unit_choice.hpp"
#include "adrinput/unit_view.hpp"
#include "deck/element_names.hpp"
#include "deck/lookup.hpp"
#include "desktop/spoken_name.hpp"
#include "desktop/theme.hpp"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpression>
#include <QScrollBar>
#include <QStyledItemDelegate>

#include <algorithm>
#include <set>
#include <utility>

namespace adore::adrinput {
namespace {

constexpr int kOtherRole = Qt::UserRole;  // the value in the other system of units
constexpr int kRowHeight = 28, kTwoLines = 44;

/// Several values, as from a spreadsheet or a list of numbers: not the text of one cell. Two
/// numbers separated by a blank may be one with a group of digits.
bool fills_cells(const QString& text) {
  static const QRegularExpression list(
      R"(^\s*[-+]?[\d.,]+([eEdD][-+]?\d+)?((\s*;\s*|\s+)[-+]?[\d.,]+([eEdD][-+]?\d+)?){2,}\s*$)");
  return text.trimmed().contains(QRegularExpression("[\t\r\n]")) || list.match(text).hasMatch();
}

/// The text of a cell while it is edited. Several pasted values go into the table.
class CellEditor : public QLineEdit {
 public:
  CellEditor(CellTable* table, QWidget* parent) : QLineEdit(parent), table_(table) {
    setFrame(false);
  }

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    if (!event->matches(QKeySequence::Paste) || !fills_cells(QApplication::clipboard()->text()))
      return QLineEdit::keyPressEvent(event);
    table_->setFocus();  // closes this
    table_->paste();
  }

 private:
  CellTable* table_;
};

/// Edits a cell as text, or as a choice for variables with codes.
class CellDelegate : public QStyledItemDelegate {
 public:
  CellDelegate(Document& document, CellTable* table)
      : QStyledItemDelegate(table), document_(document), table_(table) {}

  /// The value, and below it the value in the other unit system.
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const QString other = index.data(kOtherRole).toString();
    if (other.isEmpty()) return QStyledItemDelegate::paint(painter, option, index);
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    const QString text = std::exchange(cell.text, QString());
    table_->style()->drawControl(QStyle::CE_ItemViewItem, &cell, painter, table_);
    const desktop::Theme& theme = desktop::current_theme();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const QRect rect = option.rect.adjusted(5, 4, -2, -4);
    painter->save();
    painter->setFont(cell.font);
    const QColor chosen = table_->palette().color(QPalette::HighlightedText);
    const QColor plain = cell.palette.color(QPalette::Text);  // pale if it is not used
    painter->setPen(selected ? chosen : plain);
    painter->drawText(rect, Qt::AlignLeft | Qt::AlignTop, text);
    painter->setPen(selected ? chosen : plain == theme.muted ? plain : theme.accent);
    painter->drawText(rect, Qt::AlignLeft | Qt::AlignBottom, other);
    painter->restore();
  }
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QString other = index.data(kOtherRole).toString();
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    size.setWidth(std::max(size.width(), option.fontMetrics.horizontalAdvance(other) + 10));
    return size;
  }
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                        const QModelIndex& index) const override {
    const deck::VariableSpec& variable = *variable_of(at(index));
    if (variable.options.empty()) return new CellEditor(table_, parent);
    auto* combo = new QComboBox(parent);
    desktop::set_accessible_name(*combo, QString::fromStdString(std::string(variable.name)));
    for (const deck::OptionSpec& choice : variable.options)
      combo->addItem(choice_text(choice.code, choice.meaning),
                     QString::fromStdString(std::string(choice.code)));
    return combo;
  }
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    const QString text = shown_value(document_, at(index));
    if (auto* combo = qobject_cast<QComboBox*>(editor))
      combo->setCurrentIndex(combo->findData(text));
    else
      qobject_cast<QLineEdit*>(editor)->setText(text);
  }
  void setModelData(QWidget* editor, QAbstractItemModel* /*model*/,
                    const QModelIndex& index) const override {
    auto* combo = qobject_cast<QComboBox*>(editor);
    const QString text = combo != nullptr ? combo->currentData().toString()
                                          : qobject_cast<QLineEdit*>(editor)->text();
    const Cell cell = at(index);
    if (text == shown_value(document_, cell)) return;
    document_.end_undo_step();
    document_.edit(cell, add_display_unit(document_, cell, text.toStdString()));
    document_.end_undo_step();
  }

 private:
  [[nodiscard]] Cell at(const QModelIndex& index) const {
    return table_->cellAt(index.row(), index.column());
  }
  Document& document_;
  CellTable* table_;
};

}  // namespace

CellTable::CellTable(Document& document, const std::string& record, std::size_t variable,
                     QWidget* parent)
    : QTableWidget(parent), document_(document), record_(record) {
  lines_.push_back({variable, 0, {}});
  setUp();
}

CellTable::CellTable(Document& document, const std::string& record, QWidget* parent)
    : QTableWidget(parent), document_(document), record_(record), is_repeated_record_(true) {
  const deck::RecordSpec& spec = *deck::find_record(record);
  for (std::size_t v = 0; v < spec.variables.size(); ++v) {
    const auto length =
        static_cast<std::size_t>(deck::array_length(document.deck(), spec.variables[v]));
    for (std::size_t k = 0; k < length; ++k) lines_.push_back({v, k, {}});
  }
  setUp();
}

CellTable::CellTable(Document& document, QWidget* parent)
    : QTableWidget(parent), document_(document) {}

CellTable* CellTable::createForListedDiameters(Document& document, QWidget* parent) {
  auto* table = new CellTable(document, parent);
  for (const char* record : {"5G.1D.1", "5G.1D.2", "5G.1D.3", "5G.1D.4"})
    table->lines_.push_back({1, 0, record});
  table->record_ = table->lines_.front().record;
  table->setUp();
  return table;
}

void CellTable::setUp() {
  setItemDelegate(new CellDelegate(document_, this));
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::SelectedClicked |
                  QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
  setSelectionMode(QAbstractItemView::SingleSelection);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  horizontalHeader()->setDefaultSectionSize(110);
  verticalHeader()->setDefaultSectionSize(kRowHeight);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWordWrap(false);
  setRowCount(static_cast<int>(lines_.size()));
  verticalHeader()->setVisible(is_repeated_record_ || hasSeveralRecords());
  sync();
}

void CellTable::nameRows() {
  const deck::RecordSpec& spec = *deck::find_record(record_);
  QStringList names;
  for (const Line& line : lines_) {
    const deck::VariableSpec& variable = spec.variables[line.variable];
    QString name = QString::fromStdString(std::string(variable.name));
    if (hasSeveralRecords()) {
      const auto first = 10 * names.size() + 1;
      names << tr("%1 to %2").arg(first).arg(first + 9);
      continue;
    }
    if (is_repeated_record_ && variable.length != "1")
      name += " " + QString::fromStdString(deck::array_element_name(variable, line.element));
    const QString unit = display_unit(document_, variable);
    if (!unit.isEmpty()) name += QString(" [%1]").arg(unit);
    names << name;
  }
  setVerticalHeaderLabels(names);
}

Cell CellTable::cellAt(int row, int column) const {
  const Line& line = lines_[static_cast<std::size_t>(row)];
  Cell cell;
  cell.record = record_;
  cell.variable = line.variable;
  if (hasSeveralRecords()) {
    cell.record = line.record;
    cell.variable += static_cast<std::size_t>(column);
    return cell;
  }
  cell.instance = is_repeated_record_ ? column + 1 : 1;
  cell.element = is_repeated_record_ ? line.element : static_cast<std::size_t>(column);
  return cell;
}

void CellTable::fillCell(int row, int column) {
  const Cell cell = cellAt(row, column);
  const std::string code = document_.text(cell);
  const deck::VariableSpec& variable = *variable_of(cell);
  std::string meaning = meaning_of(variable, code);
  const deck::Value* value = value_at(document_.deck(), cell);
  if (const auto* body = value == nullptr ? nullptr : std::get_if<long long>(value);
      body != nullptr && variable.name == "kPltElemInd" && !document_.has_unparsed_text(cell))
    meaning = deck::body_name(document_.deck(), *body);
  const QString text = meaning.empty() ? shown_value(document_, cell) : choice_text(code, meaning);
  QTableWidgetItem* old = item(row, column);
  if (old == nullptr)
    setItem(row, column, new QTableWidgetItem(text));
  else if (old->text() != text)
    old->setText(text);
  const QString other = shows_other_units_ ? value_in_other_units(document_, cell) : QString();
  item(row, column)->setData(kOtherRole, other);
}

void CellTable::setOtherUnitsShown(bool shown) {
  if (shown == shows_other_units_) return;
  shows_other_units_ = shown;
  verticalHeader()->setDefaultSectionSize(shown ? kTwoLines : kRowHeight);
  sync();
}

void CellTable::sync() {
  const QSignalBlocker quiet(this);
  nameRows();
  constexpr int kListed = 10;  // deviations in a record
  const int columns = hasSeveralRecords() ? kListed
                      : is_repeated_record_
                          ? document_.instances(record_)
                          : deck::array_length(document_.deck(), *variable_of(cellAt(0, 0)));
  if (columnCount() != columns) {
    setColumnCount(columns);
    QStringList names;
    for (int column = 0; column < columns; ++column)
      names << (is_repeated_record_ || hasSeveralRecords()
                    ? QString::number(column + 1)
                    : QString::fromStdString(deck::array_element_name(
                          *variable_of(cellAt(0, 0)), static_cast<std::size_t>(column))));
    setHorizontalHeaderLabels(names);
  }
  std::set<Cell> wrong;
  for (const Problem& problem : document_.problems())
    if (problem.cell && (hasSeveralRecords() || problem.page == record_) &&
        problem.issue.severity == Severity::Error)
      wrong.insert(*problem.cell);
  QColor mark = desktop::current_theme().red;
  mark.setAlpha(70);
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < columns; ++column) {
      fillCell(row, column);
      const bool used = document_.unused_reason(cellAt(row, column)).empty();
      const desktop::Theme& theme = desktop::current_theme();
      item(row, column)->setForeground(used ? theme.text : theme.muted);
      QFont font = item(row, column)->font();
      font.setItalic(!used);
      item(row, column)->setFont(font);
      item(row, column)
          ->setBackground(wrong.count(cellAt(row, column)) > 0 ? QBrush(mark) : QBrush());
    }
  constexpr int kMeasured = 64;  // more columns would be slow
  if (columns <= kMeasured) {
    resizeColumnsToContents();
    for (int column = 0; column < columns; ++column)
      setColumnWidth(column, std::max(columnWidth(column) + 12, 96));
  }
  verticalHeader()->setMinimumWidth(verticalHeader()->sizeHint().width());
  int height = 2 * frameWidth() + horizontalHeader()->sizeHint().height() + 2;
  for (int row = 0; row < rowCount(); ++row) height += rowHeight(row);
  // A table is as wide as its cells, and scrolls if there is less space.
  const bool named = is_repeated_record_ || hasSeveralRecords();
  int width = 2 * frameWidth() + (named ? verticalHeader()->sizeHint().width() : 0) + 2;
  for (int column = 0; column < columns; ++column) width += columnWidth(column);
  content_size_ = {width, height};
  setMaximumWidth(width);
  fitHeight();
  setVisible(columns > 0);
}

/// Space for the scroll bar if the table scrolls horizontally.
void CellTable::fitHeight() {
  const bool scrolls = width() < content_size_.width();
  setHorizontalScrollBarPolicy(scrolls ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
  setFixedHeight(content_size_.height() +
                 (scrolls ? horizontalScrollBar()->sizeHint().height() : 0));
}

void CellTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  if (content_size_.isValid()) fitHeight();
}

bool CellTable::focusCell(const Cell& cell) {
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < columnCount(); ++column)
      if (cellAt(row, column) == cell) {
        setFocus();
        setCurrentCell(row, column);
        return true;
      }
  return false;
}

/// Values in their order, with any separators: for tables that are a single list.
void CellTable::pasteInOrder(const QString& text) {
  const bool cells = text.contains('\t') || text.trimmed().contains('\n');
  const QString between = cells                ? "[\\t\\r\\n]+"
                          : text.contains(';') ? "\\s*;\\s*"
                                               : "[\\s]+|,\\s+";
  const QStringList values = text.trimmed().split(QRegularExpression(between), Qt::SkipEmptyParts);
  int at = std::max(currentRow(), 0) * columnCount() + std::max(currentColumn(), 0);
  std::vector<std::pair<Cell, std::string>> typed;
  for (const QString& value : values) {
    if (at >= rowCount() * columnCount()) break;
    const Cell cell = cellAt(at / columnCount(), at % columnCount());
    typed.emplace_back(cell, add_display_unit(document_, cell, value.toStdString()));
    ++at;
  }
  document_.edit_all(typed);
}

void CellTable::paste() {
  if (!is_repeated_record_) return pasteInOrder(QApplication::clipboard()->text());
  const int top = std::max(currentRow(), 0), left = std::max(currentColumn(), 0);
  QStringList lines = QApplication::clipboard()->text().split('\n');
  if (!lines.isEmpty() && lines.back().isEmpty()) lines.removeLast();
  std::vector<std::pair<Cell, std::string>> typed;
  for (int r = 0; r < lines.size() && top + r < rowCount(); ++r) {
    const QStringList values = lines[r].remove('\r').split('\t');
    for (int c = 0; c < values.size() && left + c < columnCount(); ++c)
      typed.emplace_back(
          cellAt(top + r, left + c),
          add_display_unit(document_, cellAt(top + r, left + c), values[c].toStdString()));
  }
  document_.edit_all(typed);
}

void CellTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Paste)) return paste();
  if (event->key() == Qt::Key_PageDown || event->key() == Qt::Key_PageUp) return event->ignore();
  QTableWidget::keyPressEvent(event);
}

bool CellTable::atEnd(bool next) const {
  return next ? currentRow() >= rowCount() - 1 && currentColumn() >= columnCount() - 1
              : currentRow() <= 0 && currentColumn() <= 0;
}

/// Tab leaves the table behind its last cell, so that a form can be filled in without a mouse.
bool CellTable::focusNextPrevChild(bool next) {
  setTabKeyNavigation(!atEnd(next));
  return QTableWidget::focusNextPrevChild(next);
}

void CellTable::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
  const bool next = hint == QAbstractItemDelegate::EditNextItem;
  const bool leaves = (next || hint == QAbstractItemDelegate::EditPreviousItem) && atEnd(next);
  QTableWidget::closeEditor(editor, leaves ? QAbstractItemDelegate::NoHint : hint);
  if (leaves) focusNextPrevChild(next);
}

}  // namespace adore::adrinput

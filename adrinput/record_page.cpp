#include "adrinput/record_page.hpp"

#include "adrinput/cell_table.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/typed.hpp"
#include "adrinput/unit_view.hpp"
#include "desktop/theme.hpp"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace adore::adrinput {
namespace {

QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QLabel* make_text(const QString& text, const QColor& colour, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setStyleSheet(QString("color: %1").arg(colour.name()));
  return label;
}

std::vector<deck::OptionSpec> choices_of(const deck::VariableSpec& variable) {
  std::vector<deck::OptionSpec> all = variable.options;
  if (!variable.option_table.empty())
    for (const deck::OptionSpec& option : deck::option_table(variable.option_table))
      all.push_back(option);
  return all;
}

/// Are there codes beyond those that a list can show? Their meanings, or empty.
QString open_codes(const deck::VariableSpec& variable) {
  QString text;
  for (const deck::OptionSpec& option : variable.options) {
    if (option.code != "n" && option.code != "-n") continue;
    if (!text.isEmpty()) text += "; ";
    text +=
        QString(option.code == "n" ? "or type a larger number: %1" : "or type a smaller number: %1")
            .arg(text_of(option.meaning));
  }
  return text;
}

/// Shows a text that is longer than its field from its beginning.
void combo_home(QComboBox* combo) { combo->lineEdit()->setCursorPosition(0); }

}  // namespace

QString choice_text(std::string_view code, std::string_view meaning) {
  return QString("%1 — %2").arg(text_of(code), text_of(meaning));
}

RecordPage::RecordPage(Document& document, const std::string& record, QWidget* parent)
    : QWidget(parent), document_(document), record_(record), spec_(*page_record(record)) {
  setObjectName("page");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 14, 20, 14);
  layout->setSpacing(8);
  addHeading(layout);
  if (spec_.id == "12") {
    addUserLines(layout);
  } else if (!spec_.repeat.empty()) {
    addInstances(layout);
  } else {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(14);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
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
  reason_ = make_text({}, desktop::current_theme().muted, this);
  layout->addWidget(title);
  layout->addWidget(reason_);
}

Cell RecordPage::cellOf(std::size_t variable) const {
  Cell cell;
  cell.record = record_;
  cell.variable = variable;
  return cell;
}

void RecordPage::finish(QWidget* field) {
  field->installEventFilter(this);
  field->setFocusPolicy(Qt::StrongFocus);
}

QLineEdit* RecordPage::makeLine(const Cell& cell) {
  auto* line = new QLineEdit(this);
  const bool text = variable_of(cell)->type == deck::VarType::String;
  line->setFixedWidth(text ? 330 : 200);
  connect(line, &QLineEdit::textEdited, this, [this, cell, line](const QString& typed) {
    line->setProperty("typing", true);
    document_.edit(cell, typed.toStdString());
  });
  connect(line, &QLineEdit::editingFinished, this, [this, line] {
    line->setProperty("typing", false);
    document_.end_step();
    sync();
  });
  finish(line);
  return line;
}

QComboBox* RecordPage::makeCombo(const Cell& cell) {
  const deck::VariableSpec& variable = *variable_of(cell);
  auto* combo = new QComboBox(this);
  combo->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  combo->setMaxVisibleItems(24);
  const bool open = !open_codes(variable).isEmpty();
  combo->setEditable(open);
  combo->setInsertPolicy(QComboBox::NoInsert);
  for (const deck::OptionSpec& option : choices_of(variable))
    if (option.code != "n" && option.code != "-n")
      combo->addItem(choice_text(option.code, option.meaning), text_of(option.code));
  connect(combo, &QComboBox::activated, this, [this, combo, cell](int index) {
    document_.end_step();
    document_.edit(cell, combo->itemData(index).toString().toStdString());
    document_.end_step();
    sync(true);
  });
  if (open) {
    combo->setCompleter(nullptr);
    // A count is shown with its meaning; it must fit too.
    int widest = combo->sizeHint().width();
    for (const char* any : {"n", "-n"})
      widest = std::max(widest, combo->fontMetrics().horizontalAdvance(
                                    choice_text("-100000", meaning_of(variable, any))) +
                                    44);
    combo->setMinimumWidth(widest);
    connect(combo->lineEdit(), &QLineEdit::textEdited, this, [this, combo, cell](const QString& t) {
      combo->lineEdit()->setProperty("typing", true);
      document_.edit(cell, t.section(QChar(0x2014), 0, 0).trimmed().toStdString());
    });
    connect(combo->lineEdit(), &QLineEdit::editingFinished, this, [this, combo] {
      combo->lineEdit()->setProperty("typing", false);
      document_.end_step();
      sync();
    });
    combo->lineEdit()->installEventFilter(this);
  }
  finish(combo);
  return combo;
}

void RecordPage::addVariable(QGridLayout* grid, std::size_t v) {
  const deck::VariableSpec& variable = spec_.variables[v];
  const desktop::Theme& theme = desktop::current_theme();
  Row row;
  row.variable = v;
  auto* name = new QLabel(text_of(variable.name), this);
  name->setFont(desktop::ui_font(13, true));
  auto* side = new QHBoxLayout;
  side->setSpacing(10);
  QWidget* field = nullptr;
  if (variable.length != "1") {
    field = row.table = new CellTable(document_, record_, v, this);
    row.table->installEventFilter(this);
    connect(row.table, &QTableWidget::currentCellChanged, this,
            [this, table = row.table] { announce(table); });
  } else if (!variable.options.empty() || !variable.option_table.empty()) {
    field = row.combo = makeCombo(cellOf(v));
  } else {
    field = row.line = makeLine(cellOf(v));
  }
  field->setObjectName(text_of(variable.name));
  field->setAccessibleName(text_of(variable.name));
  field->setAccessibleDescription(text_of(variable.help));
  name->setBuddy(field);
  row.unit = new QLabel(this);
  row.unit->setTextFormat(Qt::PlainText);
  side->addWidget(field, row.table != nullptr ? 100 : 0);
  if (variable.name == "kUnit") side->addWidget(other_units_ = makeUnitsButton());
  row.unit->setWordWrap(true);
  side->addWidget(row.unit, 1000);
  row.other = new QLabel(this);
  row.other->setTextFormat(Qt::PlainText);
  row.other->setObjectName("other-" + text_of(variable.name));
  row.other->setStyleSheet(QString("color: %1").arg(theme.accent.name()));
  side->addStretch(1);
  QString help = text_of(variable.help);
  if (row.combo != nullptr && row.combo->isEditable()) help += " (" + open_codes(variable) + ")";
  row.problem = make_text({}, theme.red, this);
  row.problem->setObjectName("problem-" + text_of(variable.name));
  const int at = grid->rowCount();
  grid->addWidget(name, at, 0, row.table != nullptr ? Qt::AlignTop : Qt::AlignVCenter);
  grid->addLayout(side, at, 1);
  grid->addWidget(row.other, at + 1, 1);
  grid->addWidget(row.problem, at + 2, 1);
  grid->addWidget(make_text(help, theme.muted, this), at + 3, 1);
  grid->setRowMinimumHeight(at + 4, 8);
  rows_.push_back(row);
}

QPushButton* RecordPage::makeUnitsButton() {
  auto* button = new QPushButton(tr("Show other &units too"), this);
  button->setObjectName("other-units");
  button->setToolTip(tr("Beside each value what it is in the other system of units (Ctrl+U)"));
  button->setCheckable(true);
  button->setAutoDefault(true);
  connect(button, &QPushButton::clicked, this, &RecordPage::otherUnitsWanted);
  return button;
}

void RecordPage::setOtherUnits(bool shown) {
  shows_other_units_ = shown;
  if (other_units_ != nullptr) other_units_->setChecked(shown);
  for (Row& row : rows_)
    if (row.table != nullptr) row.table->setOtherUnits(shown);
  sync();
}

void RecordPage::addInstances(QVBoxLayout* layout) {
  const desktop::Theme& theme = desktop::current_theme();
  auto* table = new CellTable(document_, record_, this);
  table->setObjectName("instances");
  table->installEventFilter(this);
  connect(table, &QTableWidget::currentCellChanged, this, [this, table] { announce(table); });
  layout->addWidget(table);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(14);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  for (std::size_t v = 0; v < spec_.variables.size(); ++v) {
    const deck::VariableSpec& variable = spec_.variables[v];
    Row row;
    row.variable = v;
    row.table = table;
    auto* name = new QLabel(text_of(variable.name), this);
    name->setFont(desktop::ui_font(13, true));
    row.unit = new QLabel(this);
    row.unit->setTextFormat(Qt::PlainText);
    row.problem = make_text({}, theme.red, this);
    row.problem->setObjectName("problem-" + text_of(variable.name));
    const int at = grid->rowCount();
    grid->addWidget(name, at, 0, Qt::AlignTop);
    grid->addWidget(make_text(text_of(variable.help), theme.muted, this), at, 1);
    grid->addWidget(row.unit, at + 1, 1);
    grid->addWidget(row.problem, at + 2, 1);
    grid->setRowMinimumHeight(at + 3, 6);
    rows_.push_back(row);
  }
  layout->addLayout(grid);
}

void RecordPage::addUserLines(QVBoxLayout* layout) {
  lines_ = new QPlainTextEdit(this);
  lines_->setObjectName("lines");
  lines_->setAccessibleName("Lines of user routines");
  lines_->setLineWrapMode(QPlainTextEdit::NoWrap);
  lines_->setTabChangesFocus(true);
  lines_->setUndoRedoEnabled(false);
  lines_->setMinimumHeight(240);
  connect(lines_, &QPlainTextEdit::textChanged, this, [this] {
    std::vector<std::string> kept;
    for (const QString& line : lines_->toPlainText().split('\n'))
      if (!line.trimmed().isEmpty()) kept.push_back(line.toStdString());
    document_.set_user_lines(std::move(kept));
  });
  finish(lines_);
  layout->addWidget(
      make_text("Lines that user routines read, as they stand at the end of the deck. "
                "Blank lines are not kept. Leave this empty when there is no routine.",
                desktop::current_theme().muted, this));
  layout->addWidget(lines_);
}

bool RecordPage::eventFilter(QObject* object, QEvent* event) {
  auto* field = qobject_cast<QWidget*>(object);
  if (event->type() == QEvent::Wheel && !field->hasFocus() &&
      qobject_cast<QComboBox*>(field) != nullptr) {
    event->ignore();  // scrolling over a form must not change it
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();  // the deck's own undo, not the field's
      return true;
    }
  }
  if (event->type() == QEvent::FocusIn) {
    emit focusMoved(field);
    announce(field);
  }
  if (event->type() == QEvent::FocusOut && lines_ == object) document_.end_step();
  return QWidget::eventFilter(object, event);
}

void RecordPage::announce(const QWidget* field) {
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

void RecordPage::showProblems(Row& row) {
  QStringList texts;
  bool error = false;
  for (const Problem& problem : document_.problems()) {
    if (problem.page != record_ || !problem.cell || problem.cell->variable != row.variable)
      continue;
    QString text = QString::fromStdString(problem.issue.message);
    if (row.table != nullptr) text = QString::fromStdString(problem.issue.variable) + " " + text;
    if (!problem.issue.remedy.empty()) text += "; " + QString::fromStdString(problem.issue.remedy);
    error = error || problem.issue.severity == Severity::Error;
    texts << text;
  }
  const desktop::Theme& theme = desktop::current_theme();
  row.problem->setText(texts.join('\n'));
  row.problem->setStyleSheet(
      QString("color: %1").arg(error ? theme.red.name() : theme.curves[1].name()));
  row.problem->setVisible(!texts.isEmpty());
  if (row.line != nullptr)
    row.line->setStyleSheet(
        error ? QString("QLineEdit { border: 1px solid %1; padding: 3px; }").arg(theme.red.name())
              : QString());
}

void RecordPage::syncRow(Row& row, bool all) {
  const deck::VariableSpec& variable = spec_.variables[row.variable];
  const QString value = QString::fromStdString(document_.text(cellOf(row.variable)));
  if (row.line != nullptr) {
    if (all) row.line->setProperty("typing", false);
    const bool typing = row.line->property("typing").toBool();
    if ((all || !typing) && row.line->text() != value) row.line->setText(value);
  }
  if (row.combo != nullptr) {
    if (all && row.combo->lineEdit() != nullptr)
      row.combo->lineEdit()->setProperty("typing", false);
    const bool typing =
        row.combo->lineEdit() != nullptr && row.combo->lineEdit()->property("typing").toBool();
    if (all || !typing) {
      const QSignalBlocker quiet(row.combo);
      int index = row.combo->findData(value);
      const std::string any = value.startsWith('-') ? "-n" : "n";
      if (index < 0 && row.combo->isEditable()) {
        row.combo->setCurrentIndex(-1);
        const std::string meaning = meaning_of(variable, any);
        const bool known = !parse_typed(variable, value.toStdString()).problem;
        row.combo->setEditText(known && !meaning.empty() ? choice_text(value.toStdString(), meaning)
                                                         : value);
        combo_home(row.combo);
      } else {
        // A code of the file that does not exist is shown as what it is.
        if (index < 0 && !value.isEmpty()) {
          row.combo->addItem(value + " — no such code", value);
          index = row.combo->count() - 1;
        }
        row.combo->setCurrentIndex(index);
        if (row.combo->isEditable()) {
          row.combo->setEditText(row.combo->itemText(index));
          combo_home(row.combo);
        }
      }
    }
  }
  QString unit = QString::fromStdString(unit_of(document_.deck(), variable));
  const QString limits = QString::fromStdString(limits_of(document_.deck(), variable));
  if (!limits.isEmpty()) unit += (unit.isEmpty() ? "" : "   ") + QString("(%1)").arg(limits);
  row.unit->setText(unit);
  row.unit->setVisible(!unit.isEmpty());
  if (row.other != nullptr) {
    const bool shown = shows_other_units_ && row.table == nullptr;
    const QString other = shown ? in_other_units(document_, cellOf(row.variable)) : QString();
    row.other->setText(other.isEmpty() ? other : "= " + other);
    row.other->setVisible(!other.isEmpty());
  }
  showProblems(row);
}

void RecordPage::sync(bool all) {
  const int count = document_.instances(record_);
  QString reason = reason_for(document_.deck(), spec_.condition);
  if (!reason.isEmpty()) reason = "Asked for by " + reason + ".";
  reason_->setText(reason);
  reason_->setVisible(!reason.isEmpty());
  if (lines_ != nullptr) {
    QStringList lines;
    for (const std::string& line : document_.deck().user_lines)
      lines << QString::fromStdString(line);
    if (all && lines_->toPlainText() != lines.join('\n')) {
      const QSignalBlocker quiet(lines_);
      lines_->setPlainText(lines.join('\n'));
    }
    return;
  }
  if (count == 0) return;  // about to be left
  for (Row& row : rows_) {
    if (row.table != nullptr && (spec_.repeat.empty() || row.variable == 0)) row.table->sync();
    syncRow(row, all);
  }
}

QWidget* RecordPage::fieldOf(std::size_t variable) const {
  if (lines_ != nullptr) return lines_;
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
    announce(table);  // an inactive window gets no focus event
    return there;
  }
  field->setFocus(Qt::OtherFocusReason);
  if (auto* line = qobject_cast<QLineEdit*>(field)) line->selectAll();
  emit focusMoved(field);
  announce(field);
  return true;
}

void RecordPage::focusFirst() {
  if (lines_ != nullptr) return lines_->setFocus();
  if (rows_.size() > 1) focusCell(cellOf(record_ == kOptionsPage ? 0 : 1));  // behind the label
}

}  // namespace adore::adrinput

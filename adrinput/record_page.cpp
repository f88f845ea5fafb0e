#include "adrinput/record_page.hpp"

#include "adrinput/cell_table.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/typed.hpp"
#include "adrinput/unit_choice.hpp"
#include "adrinput/unit_view.hpp"
#include "deck/quantity.hpp"
#include "deck/unit_change.hpp"
#include "desktop/theme.hpp"

#include <QAbstractItemView>
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

bool is_diameter_record(const std::string& record) { return record.starts_with("5G.1D."); }

constexpr int kTextWidth = 330, kNumberWidth = 200, kLeastWidth = 90;  // of fields
constexpr int kBetween = 14;                                           // name and value
constexpr int kLeastLetters = 8;    // of a list that must be narrow
constexpr int kGridRows = 6;        // of a variable
constexpr int kFrameAndArrow = 44;  // of a list

/// A field as wide as its values want it, less where there is no room.
class ValueLine : public QLineEdit {
 public:
  ValueLine(int usual, QWidget* parent) : QLineEdit(parent), usual_(usual) {
    setMinimumWidth(kLeastWidth);
    setMaximumWidth(usual);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  }
  [[nodiscard]] QSize sizeHint() const override { return {usual_, QLineEdit::sizeHint().height()}; }

 private:
  int usual_;
};

/// As wide as its longest text, less where there is no room; the open list is never narrower.
class ChoiceBox : public QComboBox {
 public:
  explicit ChoiceBox(QWidget* parent) : QComboBox(parent) {
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    setMinimumContentsLength(kLeastLetters);
    setMaxVisibleItems(24);
    setInsertPolicy(QComboBox::NoInsert);
  }
  /// A text that is not in the list, and must fit too.
  void makeRoomFor(const QString& text) {
    widest_ = std::max(widest_, fontMetrics().horizontalAdvance(text) + kFrameAndArrow);
  }
  [[nodiscard]] QSize sizeHint() const override {
    return QComboBox::sizeHint().expandedTo({widest_, 0});
  }
  void showPopup() override {
    constexpr int kMargins = 24;
    view()->setMinimumWidth(view()->sizeHintForColumn(0) + kMargins);
    QComboBox::showPopup();
  }

 private:
  int widest_ = 0;
};

/// Is a list shown narrower than what is chosen in it?
bool is_cut(const QComboBox& combo) {
  return combo.isVisible() && combo.width() < combo.sizeHint().width() &&
         combo.fontMetrics().horizontalAdvance(combo.currentText()) + kFrameAndArrow >
             combo.width();
}

QGridLayout* make_grid() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kBetween);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  return grid;
}

/// Shows a text that is longer than its field from its beginning.
void combo_home(QComboBox* combo) { combo->lineEdit()->setCursorPosition(0); }

}  // namespace

QString choice_text(std::string_view code, std::string_view meaning) {
  if (meaning.empty()) return text_of(code);
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
  const bool text = variable_of(cell)->type == deck::VarType::String;
  auto* line = new ValueLine(text ? kTextWidth : kNumberWidth, this);
  connect(line, &QLineEdit::textEdited, this, [this, cell, line](const QString& typed) {
    line->setProperty("typing", true);
    document_.type(cell, typed.toStdString());
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
  auto* combo = new ChoiceBox(this);
  const bool open = !open_codes(variable).isEmpty();
  combo->setEditable(open);
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
    for (const char* any : {"n", "-n"})  // a count is shown with its meaning
      combo->makeRoomFor(choice_text("-100000", meaning_of(variable, any)));
    connect(combo->lineEdit(), &QLineEdit::textEdited, this, [this, combo, cell](const QString& t) {
      combo->lineEdit()->setProperty("typing", true);
      document_.type(cell, t.section(QChar(0x2014), 0, 0).trimmed().toStdString());
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
  auto* name = row.name = new QLabel(text_of(variable.name), this);
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
  row.unit->setWordWrap(true);
  if (row.line != nullptr && !deck::usual_units(variable.unit).empty())
    side->addWidget(row.choice = makeUnitChoice(variable));
  if (record_ == kOptionsPage && variable.name == "effectsOff")
    side->addWidget(row.names = makeEffectNames(cellOf(v)));
  // Limits stand beside a field; below a table, which may be as wide as the page.
  auto* whole = new QVBoxLayout;
  whole->setSpacing(2);
  whole->addLayout(side);
  if (variable.name == "kUnit")
    whole->addWidget(other_units_ = makeUnitsButton(), 0, Qt::AlignLeft);
  if (row.table != nullptr)
    whole->addWidget(row.unit);
  else
    row.side = side;
  row.other = new QLabel(this);
  row.other->setTextFormat(Qt::PlainText);
  row.other->setWordWrap(true);
  row.other->setObjectName("other-" + text_of(variable.name));
  row.other->setStyleSheet(QString("color: %1").arg(theme.accent.name()));
  side->addStretch(1);
  QString help = text_of(variable.help);
  if (row.combo != nullptr && row.combo->isEditable()) help += " (" + open_codes(variable) + ")";
  row.problem = make_text({}, theme.red, this);
  row.problem->setObjectName("problem-" + text_of(variable.name));
  row.value = whole;
  row.help = make_text(help, theme.muted, this);
  row.unused = make_text({}, theme.muted, this);
  row.unused->setObjectName("unused-" + text_of(variable.name));
  row.grid = grid;
  row.at = grid->rowCount();
  place(row);
  rows_.push_back(row);
}

/// The name beside the value or, where the page is narrow, above it.
void RecordPage::place(Row& row) {
  const int column = narrow_ ? 0 : 1, span = narrow_ ? 2 : 1;
  // Where one table holds all variables, a grid below it tells of each.
  const std::vector<QLabel*> below =
      row.value != nullptr ? std::vector<QLabel*>{row.other, row.problem, row.help, row.unused}
                           : std::vector<QLabel*>{row.help, row.unit, row.problem};
  row.grid->removeWidget(row.name);
  for (QLabel* label : below) row.grid->removeWidget(label);
  if (row.value != nullptr) row.grid->removeItem(row.value);
  row.grid->addWidget(row.name, narrow_ ? row.at : row.at + 1, 0, 1, span,
                      row.table != nullptr ? Qt::AlignTop : Qt::AlignVCenter);
  int at = row.at + 1;
  if (row.value != nullptr) row.grid->addLayout(row.value, at++, column, 1, span);
  if (row.side != nullptr) {
    row.side->removeWidget(row.unit);
    row.value->removeWidget(row.unit);
    if (narrow_)
      row.value->insertWidget(1, row.unit);
    else
      row.side->insertWidget(row.side->count() - 1, row.unit, 1000);
  }
  for (QLabel* label : below) row.grid->addWidget(label, at++, column, 1, span);
  row.grid->setRowMinimumHeight(row.at + kGridRows, 8);
}

/// Sideways scrolling is worse than a longer page.
void RecordPage::fitTo(int width) {
  constexpr int kLetters = 42;  // that a value wants beside its name
  int names = 0, least = 0;
  for (const Row& row : rows_) {
    if (row.grid == nullptr) continue;
    names = std::max(names, row.name->sizeHint().width());
    least = std::max(least, kLetters * row.help->fontMetrics().averageCharWidth());
    least = std::max(least, row.help->minimumSizeHint().width());
    if (row.side != nullptr)
      least = std::max(least, row.side->minimumSize().width() +
                                  (narrow_ ? row.unit->minimumSizeHint().width() : 0));
  }
  const QMargins margins = layout()->contentsMargins();
  const int room = width - margins.left() - margins.right() - names - kBetween;
  const bool narrow = room < least;
  if (narrow != narrow_) {
    narrow_ = narrow;
    for (Row& row : rows_)
      if (row.grid != nullptr) place(row);
  }
}

void RecordPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  for (Row& row : rows_)
    if (row.combo != nullptr) showAside(row);  // a list that became narrow says what it hides
}

bool RecordPage::event(QEvent* event) {
  if (event->type() == QEvent::ParentChange && parentWidget() != nullptr) {
    parentWidget()->installEventFilter(this);  // what can be seen of the page
    fitTo(parentWidget()->width());
  }
  return QWidget::event(event);
}

/// Effects of this deck's motion by name, each to be left out or not.
QToolButton* RecordPage::makeEffectNames(const Cell& cell) {
  auto* button = new QToolButton(this);
  button->setObjectName("effect-names");
  button->setText(tr("Choose"));
  button->setFocusPolicy(Qt::NoFocus);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolTip(tr("Effects of this deck that a run can leave out (Alt+Down in the field)"));
  button->setAccessibleName(tr("Effects that a run leaves out"));
  auto* menu = new QMenu(button);
  connect(menu, &QMenu::aboutToShow, this, [this, menu, cell] {
    menu->clear();
    document_.end_step();
    QStringList out;
    for (const QString& name : QString::fromStdString(document_.text(cell)).split(','))
      if (!name.trimmed().isEmpty()) out << name.trimmed();
    QStringList names = out;
    for (const std::string& name : document_.effects())
      if (!names.contains(QString::fromStdString(name))) names << QString::fromStdString(name);
    names.sort();
    if (names.isEmpty())
      menu->addAction(tr("This deck has no motion, or errors: nothing to leave out"))
          ->setEnabled(false);
    for (const QString& name : names) {
      QAction* action = menu->addAction(tr("without %1").arg(name));
      action->setCheckable(true);
      action->setChecked(out.contains(name));
      connect(action, &QAction::toggled, this, [this, cell, out, name](bool left_out) {
        QStringList chosen = out;
        if (left_out)
          chosen << name;
        else
          chosen.removeAll(name);
        document_.edit(cell, chosen.join(",").toStdString());
        document_.end_step();
        sync(true);
      });
    }
  });
  button->setMenu(menu);
  return button;
}

/// By mouse, or by Alt+Down in the field: Tab goes from value to value.
QToolButton* RecordPage::makeUnitChoice(const deck::VariableSpec& variable) {
  auto* button = new QToolButton(this);
  button->setObjectName("unit-" + text_of(variable.name));
  button->setFocusPolicy(Qt::NoFocus);
  button->setAutoRaise(true);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolTip(
      tr("Unit in which values of this kind are shown; the deck keeps its own "
         "(Alt+Down in the field)"));
  button->setAccessibleName(tr("Unit of %1").arg(text_of(variable.name)));
  auto* menu = new QMenu(button);
  connect(menu, &QMenu::aboutToShow, this, [this, menu, &variable] {
    menu->clear();
    const auto add = [&](const QString& text, const QString& unit) {
      QAction* action = menu->addAction(text);
      action->setCheckable(true);
      action->setChecked(chosen_unit(variable.unit.si) == unit);
      connect(action, &QAction::triggered, this, [this, &variable, unit] {
        choose_unit(variable.unit.si, unit);
        emit unitChosen();
      });
    };
    add(tr("%1, as in the deck").arg(text_of(deck::unit_name(document_.deck(), variable))), {});
    for (const std::string_view unit : deck::usual_units(variable.unit))
      if (unit != deck::unit_name(document_.deck(), variable)) add(text_of(unit), text_of(unit));
  });
  button->setMenu(menu);
  return button;
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
  auto* grid = make_grid();
  for (std::size_t v = 0; v < spec_.variables.size(); ++v) {
    const deck::VariableSpec& variable = spec_.variables[v];
    Row row;
    row.variable = v;
    row.table = table;
    row.name = new QLabel(text_of(variable.name), this);
    row.name->setFont(desktop::ui_font(13, true));
    row.unit = new QLabel(this);
    row.unit->setTextFormat(Qt::PlainText);
    row.unit->setWordWrap(true);
    row.problem = make_text({}, theme.red, this);
    row.problem->setObjectName("problem-" + text_of(variable.name));
    row.help = make_text(text_of(variable.help), theme.muted, this);
    row.grid = grid;
    row.at = grid->rowCount();
    place(row);
    rows_.push_back(row);
  }
  layout->addLayout(grid);
}

/// The four records of listed deviations as one table of 40 elements.
void RecordPage::addListedDiameters(QVBoxLayout* layout) {
  const desktop::Theme& theme = desktop::current_theme();
  auto* table = CellTable::ofListedDiameters(document_, this);
  table->setObjectName("deviations");
  table->setAccessibleName(tr("Diameter deviations of rolling elements 1 to 40"));
  table->installEventFilter(this);
  connect(table, &QTableWidget::currentCellChanged, this, [this, table] { announce(table); });
  layout->addWidget(make_text(tr("Diameter of each rolling element minus the nominal diameter, all "
                                 "40 of the four records. A row or column copied from a "
                                 "spreadsheet and pasted here fills the elements from the current "
                                 "one on; elements that this bearing does not have are pale."),
                              theme.muted, this));
  auto* label = new QLabel(tr("Label of this record"), this);
  auto* line = makeLine(cellOf(0));
  line->setObjectName("recID");
  line->setAccessibleName(tr("Label of this record"));
  label->setBuddy(line);
  layout->addWidget(label);
  layout->addWidget(line);
  layout->addWidget(table);
  auto* grid = new QGridLayout;
  grid->setColumnStretch(0, 1);
  for (std::size_t v = 0; v < spec_.variables.size(); ++v) {
    Row row;
    row.variable = v;
    if (v == 0)
      row.line = line;
    else
      row.table = table;
    row.unit = new QLabel(this);
    row.unit->setTextFormat(Qt::PlainText);
    row.problem = make_text({}, theme.red, this);
    row.problem->setObjectName("problem-" + text_of(spec_.variables[v].name));
    if (v == 1)
      grid->addWidget(row.unit, 0, 0);
    else
      row.unit->hide();
    grid->addWidget(row.problem, static_cast<int>(v) + 1, 0);
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
  if (object == parentWidget()) {
    if (event->type() == QEvent::Resize) fitTo(field->width());
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
      event->ignore();  // the deck's own undo, not the field's
      return true;
    }
  }
  if (event->type() == QEvent::KeyPress && openMenuOf(field, *static_cast<QKeyEvent*>(event)))
    return true;
  if (event->type() == QEvent::KeyPress && field->property("typing").toBool() &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Tab) {
    // A count may make the table that comes next: it has to be there before Tab looks for it.
    if (auto* line = qobject_cast<QLineEdit*>(field)) emit line->editingFinished();
  }
  if (event->type() == QEvent::FocusIn) {
    emit focusMoved(field);
    announce(field);
  }
  if (event->type() == QEvent::FocusOut && lines_ == object) document_.end_step();
  return QWidget::eventFilter(object, event);
}

/// Alt+Down opens what the button behind a field would.
bool RecordPage::openMenuOf(const QWidget* field, const QKeyEvent& key) {
  if (key.key() != Qt::Key_Down || !key.modifiers().testFlag(Qt::AltModifier)) return false;
  for (const Row& row : rows_) {
    QToolButton* button = row.choice != nullptr ? row.choice : row.names;
    if (row.line == nullptr || row.line != field || button == nullptr || button->isHidden())
      continue;
    button->menu()->popup(button->mapToGlobal(button->rect().bottomLeft()));
    return true;
  }
  return false;
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

void RecordPage::syncCombo(Row& row, const QString& value, bool all) {
  const deck::VariableSpec& variable = spec_.variables[row.variable];
  if (all && row.combo->lineEdit() != nullptr) row.combo->lineEdit()->setProperty("typing", false);
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
    row.combo->setToolTip(row.combo->currentText());  // whole, where the page is narrow
  }
}

void RecordPage::syncRow(Row& row, bool all) {
  const deck::VariableSpec& variable = spec_.variables[row.variable];
  const QString value = shown_value(document_, cellOf(row.variable));
  if (row.line != nullptr) {
    if (all) row.line->setProperty("typing", false);
    const bool typing = row.line->property("typing").toBool();
    if ((all || !typing) && row.line->text() != value) row.line->setText(value);
  }
  if (row.combo != nullptr) syncCombo(row, value, all);
  QString unit = QString::fromStdString(unit_of(document_.deck(), variable));
  const QString limits = QString::fromStdString(limits_of(document_.deck(), variable));
  if (row.choice != nullptr) {
    const QString chosen = chosen_unit(variable.unit.si);
    row.choice->setText(chosen.isEmpty() || unit.isEmpty() ? unit : chosen);
    row.choice->setVisible(!unit.isEmpty());
    unit.clear();
  }
  if (!limits.isEmpty()) unit += (unit.isEmpty() ? "" : "   ") + QString("(%1)").arg(limits);
  row.unit->setText(unit);
  const bool told_once = is_diameter_record(record_) && row.variable != 1;
  row.unit->setVisible(!unit.isEmpty() && !told_once);
  showAside(row);
  showProblems(row);
}

/// What a text being typed will be, the value in the other system of units, and whether anything
/// uses it.
void RecordPage::showAside(Row& row) {
  const Cell cell = cellOf(row.variable);
  if (row.other != nullptr) {
    QStringList texts;
    if (row.table == nullptr) texts << typed_value(document_, cell);
    if (shows_other_units_ && row.table == nullptr) texts << in_other_units(document_, cell);
    texts << run_time(document_, cell);
    if (row.combo != nullptr && is_cut(*row.combo)) texts << row.combo->currentText();
    texts.removeAll(QString());
    row.other->setText(texts.isEmpty() ? QString() : "= " + texts.join(" = "));
    row.other->setVisible(!texts.isEmpty());
  }
  if (row.unused == nullptr || row.name == nullptr) return;
  const std::string because = document_.unused_because(cell);
  const bool unused = !because.empty();
  const desktop::Theme& theme = desktop::current_theme();
  row.unused->setText(unused ? tr("Not used now: %1.").arg(QString::fromStdString(because))
                             : QString());
  row.unused->setVisible(unused);
  row.name->setStyleSheet(unused ? QString("color: %1").arg(theme.muted.name()) : QString());
  QFont font = row.name->font();
  font.setBold(!unused);
  font.setItalic(unused);
  row.name->setFont(font);
  QWidget* field = row.line != nullptr ? static_cast<QWidget*>(row.line) : row.combo;
  if (field == nullptr) return;
  QPalette palette = field->palette();
  const QColor colour = unused ? theme.muted : theme.text;
  if (palette.color(QPalette::Text) == colour) return;
  for (const auto role : {QPalette::Text, QPalette::ButtonText}) palette.setColor(role, colour);
  field->setPalette(palette);
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
    const bool one_table = !spec_.repeat.empty() || is_diameter_record(record_);
    if (row.table != nullptr && (!one_table || row.variable == (spec_.repeat.empty() ? 1U : 0U)))
      row.table->sync();
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

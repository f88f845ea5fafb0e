#include "adrinput/cell_table.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/page_parts.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/typed.hpp"
#include "adrinput/unit_choice.hpp"
#include "deck/quantity.hpp"
#include "deck/unit_change.hpp"
#include "desktop/theme.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

/// The fields of a record's page, with labels, units and problems.
namespace adore::adrinput {

void RecordPage::finish(QWidget* field) {
  field->installEventFilter(this);
  field->setFocusPolicy(Qt::StrongFocus);
}

QLineEdit* RecordPage::makeLineEdit(const Cell& cell) {
  const bool text = variable_of(cell)->type == deck::VarType::String;
  auto* line = new ValueLine(text, this);
  connect(line, &QLineEdit::textEdited, this, [this, cell, line](const QString& typed) {
    line->setProperty("typing", true);
    document_.type(cell, typed.toStdString());
  });
  connect(line, &QLineEdit::editingFinished, this, [this, line] {
    line->setProperty("typing", false);
    document_.end_undo_step();
    sync();
  });
  finish(line);
  return line;
}

QComboBox* RecordPage::makeCombo(const Cell& cell) {
  const deck::VariableSpec& variable = *variable_of(cell);
  auto* combo = new ChoiceBox(this);
  const bool open = !typed_code_hint(variable).isEmpty();
  combo->setEditable(open);
  for (const deck::OptionSpec& option : choices_of(variable))
    if (option.code != "n" && option.code != "-n")
      combo->addItem(choice_text(option.code, option.meaning), text_of(option.code));
  connect(combo, &QComboBox::activated, this, [this, combo, cell](int index) {
    document_.end_undo_step();
    document_.edit(cell, combo->itemData(index).toString().toStdString());
    document_.end_undo_step();
    sync(true);
  });
  if (open) {
    combo->setCompleter(nullptr);
    for (const char* any : {"n", "-n"})  // a count is shown with its meaning
      combo->widenForText(choice_text("-100000", meaning_of(variable, any)));
    connect(combo->lineEdit(), &QLineEdit::textEdited, this, [this, combo, cell](const QString& t) {
      combo->lineEdit()->setProperty("typing", true);
      document_.type(cell, t.section(QChar(0x2014), 0, 0).trimmed().toStdString());
    });
    connect(combo->lineEdit(), &QLineEdit::editingFinished, this, [this, combo] {
      combo->lineEdit()->setProperty("typing", false);
      document_.end_undo_step();
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
            [this, table = row.table] { announceFocusedCell(table); });
  } else if (!variable.options.empty() || !variable.option_table.empty()) {
    field = row.combo = makeCombo(cellOf(v));
  } else {
    field = row.line = makeLineEdit(cellOf(v));
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
    side->addWidget(row.names = makeEffectsButton(cellOf(v)));
  // Limits are next to a field; below a table, which may be as wide as the page.
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
  if (row.combo != nullptr && row.combo->isEditable())
    help += " (" + typed_code_hint(variable) + ")";
  row.problem = make_text_label({}, theme.red, this);
  row.problem->setObjectName("problem-" + text_of(variable.name));
  row.value = whole;
  row.help = make_text_label(help, theme.muted, this);
  row.unused = make_text_label({}, theme.muted, this);
  row.unused->setObjectName("unused-" + text_of(variable.name));
  row.grid = grid;
  row.at = grid->rowCount();
  place(row);
  rows_.push_back(row);
}

/// Effects of this deck's motion by name, each can be disabled.
QToolButton* RecordPage::makeEffectsButton(const Cell& cell) {
  auto* button = new QToolButton(this);
  button->setObjectName("effect-names");
  button->setText(tr("Choose"));
  button->setFocusPolicy(Qt::NoFocus);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolTip(tr("Select effects to switch off (Alt+Down in the field)"));
  button->setAccessibleName(tr("Disabled effects"));
  auto* menu = new QMenu(button);
  connect(menu, &QMenu::aboutToShow, this, [this, menu, cell] {
    menu->clear();
    document_.end_undo_step();
    QStringList out;
    for (const QString& name : QString::fromStdString(document_.text(cell)).split(','))
      if (!name.trimmed().isEmpty()) out << name.trimmed();
    QStringList names = out;
    for (const std::string& name : document_.effects())
      if (!names.contains(QString::fromStdString(name))) names << QString::fromStdString(name);
    names.sort();
    if (names.isEmpty())
      menu->addAction(tr("No effects can be switched off: the deck has errors or no motion"))
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
        document_.end_undo_step();
        sync(true);
      });
    }
  });
  button->setMenu(menu);
  return button;
}

/// By mouse, or by Alt+Down in the field: Tab moves from value to value.
QToolButton* RecordPage::makeUnitChoice(const deck::VariableSpec& variable) {
  auto* button = new QToolButton(this);
  button->setObjectName("unit-" + text_of(variable.name));
  button->setFocusPolicy(Qt::NoFocus);
  button->setAutoRaise(true);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolTip(tr(
      "Unit of the displayed value; the unit in the deck does not change (Alt+Down in the field)"));
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
    add(tr("%1, as in deck").arg(text_of(deck::unit_name(document_.deck(), variable))), {});
    for (const std::string_view unit : deck::usual_units(variable.unit))
      if (unit != deck::unit_name(document_.deck(), variable)) add(text_of(unit), text_of(unit));
  });
  button->setMenu(menu);
  return button;
}

QPushButton* RecordPage::makeUnitsButton() {
  auto* button = new QPushButton(tr("Show both unit systems"), this);
  button->setObjectName("other-units");
  button->setToolTip(tr("Show each value in both unit systems (Ctrl+U)"));
  button->setCheckable(true);
  button->setAutoDefault(true);
  connect(button, &QPushButton::clicked, this, &RecordPage::otherUnitsToggled);
  return button;
}

}  // namespace adore::adrinput

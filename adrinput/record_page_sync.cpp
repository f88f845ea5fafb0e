#include "adrinput/cell_table.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/page_parts.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/typed.hpp"
#include "adrinput/unit_choice.hpp"
#include "adrinput/unit_view.hpp"
#include "desktop/theme.hpp"

#include <QLabel>
#include <QPlainTextEdit>
#include <QToolButton>

/// Updates the page of a record from the document.
namespace adore::adrinput {

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
      const bool known = !parse_typed_text(variable, value.toStdString()).problem;
      row.combo->setEditText(known && !meaning.empty() ? choice_text(value.toStdString(), meaning)
                                                       : value);
      show_combo_text_start(row.combo);
    } else {
      // An invalid code of the file is shown unchanged.
      if (index < 0 && !value.isEmpty()) {
        row.combo->addItem(value + " — invalid code", value);
        index = row.combo->count() - 1;
      }
      row.combo->setCurrentIndex(index);
      if (row.combo->isEditable()) {
        row.combo->setEditText(row.combo->itemText(index));
        show_combo_text_start(row.combo);
      }
    }
    row.combo->setToolTip(row.combo->currentText());  // complete on a narrow page
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
  QString unit = display_unit(document_, variable);
  const QString limits = QString::fromStdString(limits_of(document_.deck(), variable));
  if (row.choice != nullptr) {
    row.choice->setText(unit);
    row.choice->setVisible(!unit.isEmpty());
    unit.clear();
  }
  if (!limits.isEmpty()) unit += (unit.isEmpty() ? "" : "   ") + QString("(%1)").arg(limits);
  row.unit->setText(unit);
  const bool told_once = is_diameter_record(record_) && row.variable != 1;
  row.unit->setVisible(!unit.isEmpty() && !told_once);
  showStatusOfRow(row);
  showProblems(row);
}

/// The value of a text being typed, the value in the other unit system, and whether it is used.
void RecordPage::showStatusOfRow(Row& row) {
  const Cell cell = cellOf(row.variable);
  if (row.other != nullptr) {
    QStringList texts;
    if (row.table == nullptr) texts << typed_value_text(document_, cell);
    if (shows_other_units_ && row.table == nullptr) texts << value_in_other_units(document_, cell);
    texts << run_time_text(document_, cell);
    if (row.combo != nullptr && is_text_cut_off(*row.combo)) texts << row.combo->currentText();
    texts.removeAll(QString());
    QString text = texts.isEmpty() ? QString() : "= " + texts.join(" = ");
    const QString none = no_steps_reason(document_, cell);
    if (!none.isEmpty()) text += (text.isEmpty() ? QString() : QString("; ")) + none;
    row.other->setText(text);
    row.other->setVisible(!text.isEmpty());
  }
  if (row.unused == nullptr || row.name == nullptr) return;
  const std::string because = document_.unused_reason(cell);
  const bool unused = !because.empty();
  const desktop::Theme& theme = desktop::current_theme();
  row.unused->setText(unused ? tr("Not used: %1.").arg(QString::fromStdString(because))
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
  QString reason = condition_values_text(document_.deck(), spec_.condition);
  if (!reason.isEmpty()) reason = "Required by " + reason + ".";
  condition_label_->setText(reason);
  condition_label_->setVisible(!reason.isEmpty());
  if (user_lines_edit_ != nullptr) {
    QStringList lines;
    for (const std::string& line : document_.deck().user_lines)
      lines << QString::fromStdString(line);
    if (all && user_lines_edit_->toPlainText() != lines.join('\n')) {
      const QSignalBlocker quiet(user_lines_edit_);
      user_lines_edit_->setPlainText(lines.join('\n'));
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

}  // namespace adore::adrinput

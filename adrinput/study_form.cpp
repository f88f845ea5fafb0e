#include "adrinput/study_form.hpp"

#include "adrinput/qt_text.hpp"
#include "adrinput/study_table.hpp"
#include "adrinput/wheel_guard.hpp"
#include "desktop/theme.hpp"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace adore::adrinput {
namespace {}  // namespace

StudyForm::StudyForm(StudyDocument& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  addGroup(column, "Study");
  for (const StudyTableSpec& spec : study_tables()) addTable(column, spec);
  for (const char* group : {"Samples", "Worst case", "Budget"}) addGroup(column, group);
  column->addStretch(1);
  sync();
}

void StudyForm::addGroup(QBoxLayout* column, std::string_view name) {
  auto* box = new QGroupBox(text_of(name), this);
  auto* form = new QFormLayout(box);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::DontWrapRows);
  for (const StudyField& spec : study_fields()) {
    if (spec.group != name) continue;
    const StudyField* of = &spec;
    QWidget* input = nullptr;
    if (spec.cell == StudyCellType::Choice) {
      auto* list = new QComboBox(box);
      new WheelGuard(list);
      for (const std::string_view choice : spec.choices) list->addItem(text_of(choice));
      connect(list, &QComboBox::activated, this,
              [this, list, of] { document_.set_field(*of, list->currentText().toStdString()); });
      input = list;
    } else if (spec.cell == StudyCellType::Truth) {
      auto* check = new QCheckBox(box);
      connect(check, &QCheckBox::clicked, this,
              [this, of](bool on) { document_.set_field(*of, on ? "true" : "false"); });
      input = check;
    } else {
      auto* line = new QLineEdit(box);
      connect(line, &QLineEdit::textEdited, this,
              [this, of](const QString& text) { document_.set_field(*of, text.toStdString()); });
      input = line;
    }
    input->setObjectName(text_of(spec.key));
    input->setToolTip(text_of(spec.help));
    input->setAccessibleName(text_of(spec.label));
    auto* label = new QLabel(text_of(spec.label), box);
    label->setBuddy(input);
    label->setToolTip(text_of(spec.help));
    if (spec.key == "deck") {
      auto* row = new QWidget(box);
      auto* both = new QHBoxLayout(row);
      both->setContentsMargins(0, 0, 0, 0);
      auto* choose = new QPushButton(tr("Choose …"), row);
      choose->setObjectName("choose-deck");
      choose->setAutoDefault(true);
      connect(choose, &QPushButton::clicked, this, &StudyForm::deckChoiceRequested);
      both->addWidget(input, 1);
      both->addWidget(choose);
      form->addRow(label, row);
    } else {
      form->addRow(label, input);
    }
    fields_.push_back({of, input, label, box});
  }
  column->addWidget(box);
}

void StudyForm::addTable(QBoxLayout* column, const StudyTableSpec& spec) {
  auto* box = new QGroupBox(text_of(spec.title), this);
  box->setToolTip(text_of(spec.help));
  auto* inside = new QVBoxLayout(box);
  auto* table = new StudyTable(document_, spec, box);
  inside->addWidget(table);
  auto* row = new QHBoxLayout;
  auto* remove = new QPushButton(tr("Remove row"), box);
  remove->setObjectName("remove-" + text_of(spec.key));
  remove->setToolTip(tr("Remove the selected row (Ctrl+Delete)"));
  remove->setAutoDefault(true);
  remove->setFocusPolicy(Qt::TabFocus);  // the cell stays the present one
  connect(remove, &QPushButton::clicked, table, &StudyTable::removeCurrentRow);
  auto* hint = new QLabel(text_of(spec.help), box);
  hint->setWordWrap(true);
  row->addWidget(hint, 1);
  row->addWidget(remove);
  inside->addLayout(row);
  column->addWidget(box);
  tables_.push_back(table);
  table_boxes_.push_back(box);
}

void StudyForm::syncField(const Field& field) {
  const QString text = QString::fromStdString(document_.field(*field.spec));
  if (auto* line = qobject_cast<QLineEdit*>(field.input)) {
    // "5, " while typing "5, 50" is not removed; the typed text has the meaning of the value in the
    // file.
    const bool typing = line->hasFocus() &&
                        shown_value(typed_value(field.spec->cell, line->text().toStdString())) ==
                            text.toStdString();
    if (line->text() != text && !typing) line->setText(text);
  } else if (auto* list = qobject_cast<QComboBox*>(field.input)) {
    int at = list->findText(text);
    if (at < 0) {  // content of the file, valid or not
      list->addItem(text);
      at = list->count() - 1;
    }
    list->setCurrentIndex(at);
  } else if (auto* check = qobject_cast<QCheckBox*>(field.input)) {
    check->setChecked(text == "true");
  }
}

void StudyForm::sync() {
  setEnabled(document_.values().has_value());
  if (!document_.values()) return;
  const auto kind = document_.kind();
  std::vector<QGroupBox*> shown;
  for (const Field& field : fields_) {
    syncField(field);
    const bool visible =
        !kind || (field.spec->kinds & only(*kind)) != 0 || !document_.field(*field.spec).empty();
    field.input->setVisible(visible);
    field.label->setVisible(visible);
    if (visible) shown.push_back(field.group);
  }
  for (const Field& field : fields_)
    field.group->setVisible(std::find(shown.begin(), shown.end(), field.group) != shown.end());
  for (std::size_t k = 0; k < tables_.size(); ++k) {
    tables_[k]->sync();
    table_boxes_[k]->setVisible(!kind || (tables_[k]->spec().kinds & only(*kind)) != 0 ||
                                document_.rows(tables_[k]->spec().key) > 0);
  }
}

const StudyForm::Field* StudyForm::fieldOf(const std::string& key) const {
  const Field* best = nullptr;
  for (const Field& field : fields_)
    if (field.spec->key == key || (field.spec->key == "deck" && key == "decks")) best = &field;
  return best;
}

StudyTable* StudyForm::table(std::string_view key) const {
  for (StudyTable* one : tables_)
    if (one->spec().key == key) return one;
  return nullptr;
}

void StudyForm::showProblem(const std::string& key, const QString& sentence) {
  const Field* wrong = fieldOf(key);
  for (const Field& field : fields_) {
    QPalette colours = field.label->palette();
    colours.setColor(QPalette::WindowText, &field == wrong ? desktop::current_theme().red
                                                           : desktop::current_theme().text);
    field.label->setPalette(colours);
    field.input->setToolTip(&field == wrong ? sentence : text_of(field.spec->help));
  }
  const std::string of = key.substr(0, key.find('['));
  for (StudyTable* one : tables_) {
    int row = -1;
    if (one->spec().key == of && key.size() > of.size()) row = std::atoi(&key[of.size() + 1]) - 1;
    one->markRow(row, sentence);
  }
}

bool StudyForm::goTo(const std::string& key) {
  if (const Field* field = fieldOf(key); field != nullptr && !field->input->isHidden()) {
    field->input->setFocus();
    return true;
  }
  const std::string of = key.substr(0, key.find('['));
  if (StudyTable* one = table(of)) {
    one->setFocus();
    if (key.size() > of.size()) one->setCurrentCell(std::atoi(&key[of.size() + 1]) - 1, 0);
    return true;
  }
  return false;
}

}  // namespace adore::adrinput

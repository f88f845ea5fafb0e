#include "adrinput/calculator_dialog.hpp"

#include "adrinput/qt_text.hpp"
#include "adrinput/wheel_guard.hpp"
#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/theme.hpp"

#include <QBoxLayout>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QTableWidget>

#include <algorithm>
#include <cmath>

namespace adore::adrinput {
namespace {

using calculators::SchemaInput;
using calculators::SchemaKind;
using Json = nlohmann::json;

bool is_choice(const SchemaInput& input) {
  return (input.type == "code" || input.type == "true or false") &&
         input.name.find("[]") == std::string::npos;
}

QString scalar_text(const Json& value) {
  if (value.is_number_float())
    return QString::number(value.get<double>(), 'g', QLocale::FloatingPointShortest);
  return text_of(value.is_string() ? value.get<std::string>() : dump_json(value));
}

/// Values at a path ("lands[].race"), lists in lists for each "[]"; null: not given.
Json values_at(const Json& value, const QStringList& path, qsizetype at = 0) {
  if (at == path.size()) return value;
  QString key = path[at];
  if (key == "[]") {
    if (!value.is_array()) return {};
    Json out = Json::array();
    for (const Json& item : value) out.push_back(values_at(item, path, at + 1));
    return out;
  }
  if (!value.is_object()) return {};
  const auto found = value.find(key.toStdString());
  return found == value.end() ? Json() : values_at(*found, path, at + 1);
}

void put(Json& into, const QStringList& path, const Json& value, qsizetype at = 0) {
  if (at == path.size()) {
    into = value;
  } else if (path[at] == "[]") {
    if (!into.is_array()) into = Json::array();
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (into.size() <= i) into.push_back(Json());
      put(into[i], path, value[i], at + 1);
    }
  } else {
    if (!into.is_object()) into = Json::object();
    put(into[path[at].toStdString()], path, value, at + 1);
  }
}

/// "lands[].race" as lands, [], race
QStringList steps_of(const std::string& path) {
  QString text = text_of(path);
  return text.replace("[]", ".[]").split('.', Qt::SkipEmptyParts);
}

QString value_text(const Json& value) {
  if (!value.is_array()) return scalar_text(value);
  QStringList parts;
  const bool rows =
      std::any_of(value.begin(), value.end(), [](const Json& v) { return v.is_array(); });
  for (const Json& item : value) parts << value_text(item);
  return parts.join(rows ? "; " : ", ");
}

Json scalar_of(const QString& text, const SchemaInput& input) {
  const QString word = text.trimmed();
  if (word == "null") return {};
  if (input.type == "true or false" && (word == "true" || word == "false")) return word == "true";
  bool number = false;
  const double value = word.toDouble(&number);
  number = number && std::isfinite(value);  // "inf" is a code
  if (!number || input.type == "code" || input.type == "label" || input.type == "name")
    return word.toStdString();
  bool whole = false;
  const long long count = word.toLongLong(&whole);
  return whole ? Json(count) : Json(value);
}

Json value_of(const QString& text, const SchemaInput& input) {
  const auto depth = text_of(input.name).count("[]");
  if (depth == 0) return scalar_of(text, input);
  Json out = Json::array();
  if (depth > 1) {
    for (const QString& row : text.split(';', Qt::SkipEmptyParts)) {
      Json values = Json::array();
      for (const QString& one : row.split(',')) values.push_back(scalar_of(one, input));
      out.push_back(std::move(values));
    }
    return out;
  }
  for (const QString& one : text.split(',')) out.push_back(scalar_of(one, input));
  return out;
}

QString text_in(const QWidget& editor) {
  if (const auto* list = qobject_cast<const QComboBox*>(&editor)) return list->currentText();
  const auto* line = qobject_cast<const QLineEdit*>(&editor);
  return line == nullptr ? QString() : line->text();
}

/// "required", "default 0.3" ...
QString presence(const SchemaKind& kind, const SchemaInput& input) {
  if (std::find(kind.required.begin(), kind.required.end(), input.name) != kind.required.end())
    return CalculatorDialog::tr("required");
  for (const auto& group : kind.one_of)
    if (std::find(group.begin(), group.end(), input.name) != group.end()) {
      QStringList names;
      for (const std::string& name : group) names << text_of(name);
      return CalculatorDialog::tr("exactly one of %1").arg(names.join(", "));
    }
  if (!input.default_value.is_null())
    return CalculatorDialog::tr("default %1").arg(scalar_text(input.default_value));
  return CalculatorDialog::tr("optional");
}

/// The path without the numbers of list items.
QString schema_path(QString path) {
  static const QRegularExpression number("\\[\\d+\\]");
  return path.replace(number, "[]");
}

}  // namespace

CalculatorDialog::CalculatorDialog(QWidget* parent)
    : QDialog(parent),
      calculator_(new QComboBox(this)),
      kind_(new QComboBox(this)),
      scroll_area_(new QScrollArea(this)),
      help_(new QLabel(this)),
      message_(new QLabel(this)),
      results_(new QTableWidget(0, 4, this)) {
  setObjectName("calculator");
  setWindowTitle(tr("Calculator"));
  desktop::delete_when_done(*this);
  calculator_->setObjectName("calculator-list");
  calculator_->setAccessibleName(tr("Calculator"));
  kind_->setObjectName("kind-list");
  kind_->setAccessibleName(tr("Kind of calculation"));
  for (QComboBox* list : {calculator_, kind_}) new WheelGuard(list);
  for (const calculators::CalculatorInfo& info : calculators::calculator_list())
    if (calculators::family_schema(info.family) != nullptr)
      calculator_->addItem(text_of(info.name));
  for (QLabel* label : {help_, message_}) label->setWordWrap(true);
  message_->setObjectName("calculator-message");
  scroll_area_->setWidgetResizable(true);
  scroll_area_->setVerticalScrollBarPolicy(
      Qt::ScrollBarAlwaysOn);  // the width of the fields is constant
  scroll_area_->setAccessibleName(tr("Inputs"));
  scroll_area_->setMinimumSize(320, 90);
  results_->setMinimumHeight(60);
  results_->setObjectName("calculator-results");
  results_->setAccessibleName(tr("Results"));
  results_->setHorizontalHeaderLabels({tr("Result"), tr("Value"), tr("Unit"), tr("Meaning")});
  results_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  results_->verticalHeader()->hide();
  results_->horizontalHeader()->setStretchLastSection(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* compute_button = buttons->addButton(tr("C&ompute"), QDialogButtonBox::ApplyRole);
  compute_button->setObjectName("compute");
  compute_button->setDefault(true);
  auto* example = buttons->addButton(tr("Fill in &example"), QDialogButtonBox::ActionRole);
  example->setObjectName("example");
  auto* form = new QFormLayout;
  form->addRow(tr("&Calculator:"), calculator_);
  form->addRow(tr("&Kind of calculation:"), kind_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(help_);
  column->addWidget(scroll_area_, 2);
  column->addWidget(message_);
  column->addWidget(results_, 1);
  column->addWidget(buttons);
  connect(calculator_, &QComboBox::currentIndexChanged, this, &CalculatorDialog::showCalculator);
  connect(kind_, &QComboBox::currentIndexChanged, this, &CalculatorDialog::showKind);
  connect(compute_button, &QPushButton::clicked, this, &CalculatorDialog::compute);
  connect(example, &QPushButton::clicked, this, &CalculatorDialog::fillExample);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  showCalculator();
  resize(760, 700);
}

const calculators::CalculatorInfo& CalculatorDialog::calculator() const {
  const auto& all = calculators::calculator_list();
  const std::string name = calculator_->currentText().toStdString();
  return *std::find_if(all.begin(), all.end(), [&](const auto& info) { return info.name == name; });
}

std::size_t CalculatorDialog::kindIndex() const {
  return static_cast<std::size_t>(std::max(0, kind_->currentIndex()));
}

void CalculatorDialog::showCalculator() {
  const calculators::CalculatorInfo& info = calculator();
  help_->setText(text_of(info.help));
  kinds_ = calculators::calculation_kinds(*calculators::family_schema(info.family), info.kind);
  const QSignalBlocker quiet(kind_);
  kind_->clear();
  for (const SchemaKind* kind : kinds_) kind_->addItem(text_of(kind->name));
  showKind();
}

void CalculatorDialog::showKind() {
  fields_.clear();
  clearResults();
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  for (const SchemaInput& input : kind().inputs) addField(*column, input);
  column->addStretch(1);
  scroll_area_->setWidget(page);
  page->show();
  fitPage();
}

void CalculatorDialog::fitPage() {
  QWidget* page = scroll_area_->widget();
  if (page == nullptr) return;
  page->layout()->activate();
  page->setMinimumHeight(page->layout()->totalHeightForWidth(scroll_area_->viewport()->width()));
}

void CalculatorDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fitPage();
}

void CalculatorDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  if (layout() != nullptr) layout()->activate();
  fitPage();
}

void CalculatorDialog::addField(QBoxLayout& column, const SchemaInput& input) {
  QWidget* page = column.parentWidget();
  QWidget* editor = nullptr;
  const QString name = text_of(input.name), needed = presence(kind(), input);
  if (is_choice(input)) {
    auto* list = new QComboBox(page);
    new WheelGuard(list);
    list->addItem(QString());
    if (input.type == "true or false") list->addItems({"true", "false"});
    for (const std::string& code : input.codes) list->addItem(text_of(code));
    if (input.null_meaning) list->addItem("null");
    editor = list;
  } else {
    auto* line = new QLineEdit(page);
    line->setPlaceholderText(needed);
    editor = line;
  }
  const QString hint = tr("%1, %2%3")
                           .arg(text_of(input.value_text()), needed,
                                input.meaning.empty() ? QString() : ". " + text_of(input.meaning));
  editor->setObjectName(name);
  editor->setAccessibleName(name);
  editor->setAccessibleDescription(hint);
  editor->setToolTip(hint);
  auto* label = new QLabel(name + ": " + hint, page);
  label->setBuddy(editor);
  auto* error = new QLabel(page);
  error->setObjectName("error " + name);
  for (QLabel* text : {label, error}) {
    text->setWordWrap(true);
    text->setTextFormat(Qt::PlainText);
  }
  QFont bold = error->font();
  bold.setBold(true);
  error->setFont(bold);
  error->hide();
  for (QWidget* part : {static_cast<QWidget*>(label), editor, static_cast<QWidget*>(error)})
    column.addWidget(part);
  fields_.push_back({&input, editor, error});
}

void CalculatorDialog::fillExample() {
  clearResults();
  const Json example = kind().example;
  for (const Field& field : fields_) {
    const Json value = values_at(example, steps_of(field.input->name));
    const bool is_given =
        !value.is_null() || (field.input->null_meaning && example.contains(field.input->name));
    const QString text = is_given ? value_text(value) : QString();
    if (auto* list = qobject_cast<QComboBox*>(field.editor))
      list->setCurrentIndex(std::max(0, list->findText(text, Qt::MatchFixedString)));
    else if (auto* line = qobject_cast<QLineEdit*>(field.editor))
      line->setText(text);
  }
}

nlohmann::json CalculatorDialog::input() const {
  Json inputs = Json::object();
  for (const Field& field : fields_)
    if (const QString text = text_in(*field.editor); !text.trimmed().isEmpty())
      put(inputs, steps_of(field.input->name), value_of(text, *field.input));
  Json out{{"inputs", std::move(inputs)}};
  if (calculator().kind.empty()) out["kind"] = kind().name;
  return out;
}

void CalculatorDialog::clearResults() {
  message_->clear();
  message_->hide();
  results_->setRowCount(0);
  for (const Field& field : fields_) field.error->hide();
  if (!fields_.empty()) fitPage();
}

void CalculatorDialog::compute() {
  clearResults();
  try {
    showResults(calculators::calculate(calculator().name, input()));
  } catch (const InputError& error) {
    if (error.issues().empty()) showError({}, error.what());
    for (const Issue& issue : error.issues()) {
      QString text = text_of(issue.message);
      if (!issue.remedy.empty()) text += "; " + text_of(issue.remedy);
      showError(text_of(issue.variable), text);
    }
  } catch (const std::exception& error) {
    showError({}, error.what());
  }
}

void CalculatorDialog::showError(const QString& variable, const QString& text) {
  const QString path = schema_path(variable);
  const Field* at = nullptr;
  for (const Field& field : fields_) {
    const QString name = text_of(field.input->name);
    if (name == path || name == path + "[]") at = &field;
    if (at == nullptr && !path.isEmpty() && name.startsWith(path)) at = &field;
  }
  if (at == nullptr) {
    const QString line = variable.isEmpty() ? text : variable + ": " + text;
    message_->setText(message_->text().isEmpty() ? line : message_->text() + "\n" + line);
    message_->show();
    return;
  }
  const QString before = at->error->isHidden() ? QString() : at->error->text() + "\n";
  const QString place = variable.contains('[') ? variable + ": " : QString();
  const bool first = std::all_of(fields_.begin(), fields_.end(),
                                 [](const Field& field) { return field.error->isHidden(); });
  QPalette colors = at->error->palette();
  colors.setColor(QPalette::WindowText, desktop::current_theme().red);
  at->error->setPalette(colors);
  at->error->setText(before + place + text);
  at->error->show();
  fitPage();
  if (!first) return;
  at->editor->setFocus();
  scroll_area_->ensureWidgetVisible(at->editor);
}

void CalculatorDialog::showResults(const nlohmann::json& results) {
  const Json units = results.value("units", Json::object());
  const calculators::SchemaFamily& family = *calculators::family_schema(calculator().family);
  const auto row = [&](const QString& path, const Json& value) {
    const std::string name = schema_path(path).toStdString();
    const std::string in_list = value.is_array() && !name.ends_with("[]") ? name + "[]" : name;
    const auto meaning = std::find_if(family.results.begin(), family.results.end(),
                                      [&](const auto& r) { return r.name == in_list; });
    const std::string unit = units.value(in_list, std::string());
    const int at = results_->rowCount();
    results_->insertRow(at);
    const QStringList cells{
        path,
        value.is_number_float() ? QString::number(value.get<double>(), 'g', 7) : value_text(value),
        unit == "1" ? QString() : text_of(unit),
        meaning == family.results.end() ? QString() : text_of(meaning->meaning)};
    for (int k = 0; k < cells.size(); ++k) {
      results_->setItem(at, k, new QTableWidgetItem(cells[k]));
      results_->item(at, k)->setToolTip(cells[k]);
    }
  };
  const auto add = [&](const auto& again, const QString& path, const Json& value) -> void {
    if (value.is_object()) {
      for (const auto& [key, item] : value.items())
        if (!path.isEmpty() || key != "units")
          again(again, path.isEmpty() ? text_of(key) : path + "." + text_of(key), item);
    } else if (value.is_array() && std::any_of(value.begin(), value.end(),
                                               [](const Json& v) { return v.is_object(); })) {
      for (std::size_t i = 0; i < value.size(); ++i)
        again(again, QString("%1[%2]").arg(path).arg(i), value[i]);
    } else {
      row(path, value);
    }
  };
  add(add, {}, results);
  results_->resizeColumnsToContents();
}

}  // namespace adore::adrinput

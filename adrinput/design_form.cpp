#include "adrinput/design_form.hpp"

#include "adrinput/typed.hpp"
#include "adrinput/wheel_guard.hpp"
#include "base/errors.hpp"
#include "deck/catalogue.hpp"
#include "deck/lookup.hpp"
#include "desktop/spoken_name.hpp"
#include "desktop/theme.hpp"

#include <QAbstractItemView>
#include <QBoxLayout>
#include <QComboBox>
#include <QCompleter>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

#include <algorithm>
#include <exception>
#include <utility>

namespace adore::adrinput {
namespace {

constexpr int kTypingPause = 250;  // ms without a key before a valid text becomes the value
constexpr int kFieldWidth = 84;

QString text_of(const std::string& text) { return QString::fromStdString(text); }

/// "2600" in a field of newtons is "2600 N"; a text with a unit stays.
std::string with_unit(const std::string& typed, const std::string& unit) {
  const std::string plain = normalized_text(typed);
  double number = 0.0;
  if (unit.empty() || deck::parse_real(plain, number)) return typed;
  return plain + " " + (unit == "°" ? "deg" : unit);
}

void paint_invalid(QLineEdit& line, bool invalid) {
  QPalette palette;
  if (invalid) palette.setColor(QPalette::Text, desktop::current_theme().red);
  line.setPalette(palette);
}

/// Reason why there is no bearing of this name, as a sentence.
QString reason_of(const InputError& error, const QString& designation) {
  if (error.issues().empty()) return QString::fromUtf8(error.what());
  const Issue& issue = error.issues().front();
  QString remedy = text_of(issue.remedy);
  if (!remedy.isEmpty()) remedy[0] = remedy[0].toUpper();
  return designation + " " + text_of(issue.message) + ". " + remedy + ".";
}

}  // namespace

DesignForm::DesignForm(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      bearing_field_(new QLineEdit(this)),
      bearing_facts_(new QLabel(this)),
      oil_row_(new QWidget(this)),
      oil_box_(new QComboBox(oil_row_)),
      grid_(new QGridLayout),
      delay_timer_(new QTimer(this)) {
  setObjectName("design-form");
  bearing_field_->setObjectName("design-bearing");
  bearing_field_->setAccessibleName(tr("Bearing designation"));
  bearing_field_->setPlaceholderText(tr("e.g. 7208 B"));
  QStringList all;
  for (const std::string& one : deck::catalogue_designations()) all << text_of(one);
  auto* completer = new QCompleter(all, this);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  bearing_field_->setCompleter(completer);
  connect(bearing_field_, &QLineEdit::editingFinished, this, &DesignForm::applyBearing);
  connect(
      completer, qOverload<const QString&>(&QCompleter::activated), this,
      [this] {
        bearing_field_->setModified(true);
        applyBearing();
      },
      Qt::QueuedConnection);
  completer->popup()->installEventFilter(this);
  bearing_field_->installEventFilter(this);
  auto* more = new QPushButton(tr("&Catalog …"), this);
  more->setObjectName("design-catalogue");
  more->setToolTip(tr("Select a bearing from the catalog and create its deck (Ctrl+N)"));
  more->setAutoDefault(true);
  connect(more, &QPushButton::clicked, this, &DesignForm::catalogRequested);
  auto* name = new QLabel(tr("&Bearing"), this);
  name->setBuddy(bearing_field_);
  bearing_facts_->setObjectName("design-facts");
  bearing_facts_->setWordWrap(true);
  bearing_facts_->setTextFormat(Qt::PlainText);
  oil_box_->setObjectName("design-oil");
  desktop::set_accessible_name(*oil_box_, tr("Oil"));
  oil_box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  oil_box_->setMinimumContentsLength(9);
  oil_box_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* oil_box = new QHBoxLayout(oil_row_);
  oil_box->setContentsMargins(0, 0, 0, 0);
  auto* oil_name = new QLabel(tr("Oil"), oil_row_);
  oil_box->addWidget(oil_name);
  oil_box->addWidget(oil_box_, 1);
  oil_box_->setFocusPolicy(Qt::StrongFocus);
  new WheelGuard(oil_box_);
  connect(oil_box_, &QComboBox::activated, this, [this](int index) {
    const std::vector<design::DesignOil> oils = design::design_oils(document_.deck());
    if (index < 0 || index >= static_cast<int>(oils.size())) return;
    // Each typed letter of a name activates an entry.
    if (design::design_oil_index(document_.deck()) == static_cast<std::size_t>(index)) return;
    document_.change(oils[static_cast<std::size_t>(index)].sets);
  });
  auto* row = new QHBoxLayout;
  row->addWidget(bearing_field_, 1);
  row->addWidget(more);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(0, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 8);
  column->setSpacing(4);
  column->addWidget(name);
  column->addLayout(row);
  column->addWidget(bearing_facts_);
  column->addLayout(grid_);
  column->addStretch(1);
  delay_timer_->setSingleShot(true);
  delay_timer_->setInterval(kTypingPause);
  connect(delay_timer_, &QTimer::timeout, this, &DesignForm::acceptValidFields);
  sync();
}

/// Fields report their end when they lose the focus: not to a form that is no more.
DesignForm::~DesignForm() {
  commitFields();
  bearing_field_->removeEventFilter(this);
  bearing_field_->completer()->popup()->removeEventFilter(this);
  bearing_field_->disconnect(this);
  for (const Field& field : fields_) field.line->disconnect(this);
}

std::vector<Cell> DesignForm::cellsOf(const design::DesignInput& input) const {
  std::vector<Cell> cells;
  for (const std::string& variable : input.variables) {
    const deck::VariableRef ref = deck::find_present_variable(document_.deck(), variable);
    if (ref.record != nullptr) cells.push_back({std::string(ref.record->id), 1, ref.position, 0});
  }
  return cells;
}

QLineEdit* DesignForm::fieldOf(const std::string& variable) const {
  for (const Field& field : fields_)
    if (field.input.variables.front() == variable) return field.line;
  return nullptr;
}

void DesignForm::focusBearing() {
  bearing_field_->setFocus();
  bearing_field_->selectAll();
}

DesignForm::Field DesignForm::makeField(const design::DesignInput& input) {
  Field field{input, new QLabel(this), new QLabel(this), new QLineEdit(this)};
  QLineEdit* line = field.line;
  line->setObjectName(text_of("design-" + input.variables.front()));
  line->setAlignment(Qt::AlignRight);
  line->setFixedWidth(kFieldWidth);
  connect(line, &QLineEdit::textEdited, delay_timer_, qOverload<>(&QTimer::start));
  connect(line, &QLineEdit::editingFinished, this, [this, line] {
    for (Field& one : fields_)
      if (one.line == line) return applyField(one, true);
  });
  return field;
}

/// Fields for the inputs of this type of bearing. Fields that both types have stay: one of them may
/// have the focus.
void DesignForm::rebuild() {
  std::vector<Field> old = std::move(fields_);
  fields_.clear();
  for (const design::DesignInput& input : design::design_inputs(document_.deck())) {
    const auto known = std::find_if(old.begin(), old.end(), [&](const Field& field) {
      return field.input.variables == input.variables;
    });
    fields_.push_back(known == old.end() ? makeField(input) : *known);
    fields_.back().input = input;
    if (known != old.end()) old.erase(known);
  }
  for (const Field& field : old) {
    field.line->disconnect(this);
    for (QWidget* part : {static_cast<QWidget*>(field.line), static_cast<QWidget*>(field.name),
                          static_cast<QWidget*>(field.unit)}) {
      part->hide();
      part->deleteLater();
    }
  }
  for (QLabel* title : findChildren<QLabel*>("design-group")) delete title;
  int row = 0;
  std::string group;
  QWidget* last = bearing_field_;
  const auto next = [&](QWidget* field) { setTabOrder(std::exchange(last, field), field); };
  const auto title = [&](const QString& text) {
    auto* label = new QLabel(text, this);
    label->setObjectName("design-group");
    label->setFont(desktop::ui_font(12, true));
    label->show();
    return label;
  };
  for (const Field& field : fields_) {
    if (field.input.group != group) {
      if (!group.empty()) {  // the oil ends the operation
        grid_->addWidget(oil_row_, row++, 0, 1, 3);
        next(oil_box_);
      }
      group = field.input.group;
      grid_->addWidget(title(text_of(group)), row++, 0, 1, 3);
    }
    field.name->setText(text_of(field.input.label));
    field.unit->setText(text_of(field.input.unit));
    field.line->setAccessibleName(text_of(
        field.input.label + (field.input.unit.empty() ? "" : " [" + field.input.unit + "]")));
    grid_->addWidget(field.name, row, 0);
    grid_->addWidget(field.line, row, 1, Qt::AlignRight);
    grid_->addWidget(field.unit, row++, 2);
    next(field.line);
  }
}

void DesignForm::sync() {
  if (applying_input_) return;
  const std::vector<design::DesignInput> inputs = design::design_inputs(document_.deck());
  const bool same = std::equal(inputs.begin(), inputs.end(), fields_.begin(), fields_.end(),
                               [](const design::DesignInput& input, const Field& field) {
                                 return input.variables == field.input.variables &&
                                        input.label == field.input.label;
                               });
  if (!same) rebuild();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    Field& field = fields_[i];
    field.input = inputs[i];
    const std::vector<Cell> cells = cellsOf(field.input);
    const bool draft = !cells.empty() && document_.has_unparsed_text(cells.front());
    field.line->setEnabled(field.input.why_fixed.empty());
    field.line->setToolTip(field.input.why_fixed.empty()
                               ? tr("%1 in record %2")
                                     .arg(text_of(field.input.variables.front()),
                                          text_of(cells.empty() ? "" : cells.front().record))
                               : tr("Not used: %1.").arg(text_of(field.input.why_fixed)));
    field.line->setPlaceholderText(tr("different"));
    if (field.line->isModified()) continue;  // being typed
    const QString text = draft ? text_of(document_.text(cells.front()))
                               : text_of(design::input_text(document_.deck(), field.input));
    if (field.line->text() != text) field.line->setText(text);
    paint_invalid(*field.line, draft);
  }
  fillOils();
  if (!bearing_field_->isModified()) showBearing();
}

void DesignForm::fillOils() {
  const std::vector<design::DesignOil> oils = design::design_oils(document_.deck());
  const auto now = design::design_oil_index(document_.deck());
  const int count = static_cast<int>(oils.size()) + (now ? 0 : 1);
  if (oil_box_->count() != count) {
    oil_box_->clear();
    for (const design::DesignOil& one : oils) oil_box_->addItem(text_of(one.name));
    if (!now) oil_box_->addItem(tr("as in the records"));
  }
  oil_box_->setCurrentIndex(now ? static_cast<int>(*now) : count - 1);
  oil_box_->setToolTip(now ? oil_box_->currentText() : tr("Records 10.0 to 10.4 and X2"));
}

/// The designation if the deck still has the main dimensions of the catalog.
void DesignForm::showBearing() {
  const deck::Deck& deck = document_.deck();
  const std::string designation = deck.text("runID");
  QString shown, facts;
  try {
    const deck::CatalogueBearing found = deck::find_bearing(designation);
    const deck::Deck made = design::replace_bearing(deck, designation, false);
    const auto inputs = design::design_inputs(deck);
    const bool as_made =
        made.integer("kBrg") == deck.integer("kBrg") &&
        std::all_of(inputs.begin(), inputs.end(), [&](const design::DesignInput& one) {
          return one.group != "Geometry" ||
                 design::input_text(deck, one) == design::input_text(made, one);
        });
    shown = text_of(found.designation);
    const std::vector<std::string> story = deck::describe_catalogue_bearing(found);
    facts = as_made ? text_of(story.front())
                    : tr("%1 with changed geometry").arg(text_of(found.designation));
    QStringList lines;
    for (const std::string& line : story) lines << text_of(line);
    bearing_facts_->setToolTip(lines.join("\n\n"));
    if (as_made) facts += tr(" Internal geometry: ESTIMATED.");
  } catch (const InputError&) {
    facts = tr("%1 (not in the catalog)").arg(text_of(designation));
    bearing_facts_->setToolTip({});
  }
  bearing_field_->setText(shown);
  paint_invalid(*bearing_field_, false);
  bearing_facts_->setText(facts);
}

void DesignForm::applyBearing() {
  if (!bearing_field_->isModified() || applying_input_) return;
  const QString typed = bearing_field_->text().trimmed();
  bearing_field_->setModified(false);
  if (typed.isEmpty()) return sync();
  try {
    const std::string designation = typed.toStdString();
    const bool pristine = document_.path().empty() && !document_.modified() &&
                          !document_.can_undo();  // the example of a new window
    const deck::Deck next = design::replace_bearing(document_.deck(), designation, !pristine);
    bearing_field_->completer()->popup()->hide();
    document_.replace(next, deck::catalogue_deck(deck::find_bearing(designation)));
  } catch (const InputError& error) {
    paint_invalid(*bearing_field_, true);
    bearing_facts_->setText(reason_of(error, typed));
  }
}

void DesignForm::acceptValidFields() {
  for (Field& field : fields_)
    if (field.line->isModified()) applyField(field, false);
}

void DesignForm::commitFields() {
  applyBearing();
  for (Field& field : fields_)
    if (field.line->isModified()) applyField(field, true);
}

/// Enter in the list of designations without a choice there takes the typed one.
bool DesignForm::eventFilter(QObject* object, QEvent* event) {
  QAbstractItemView* list = bearing_field_->completer()->popup();
  if (event->type() == QEvent::KeyPress && list->isVisible() && !list->currentIndex().isValid()) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      list->hide();
      applyBearing();
      return true;
    }
  }
  return QWidget::eventFilter(object, event);
}

void DesignForm::applyField(Field& field, bool finished) {
  delay_timer_->stop();
  if (!field.line->isModified()) return;
  const std::string typed = field.line->text().toStdString();
  const std::string meant = with_unit(typed, field.input.unit);
  const std::vector<Cell> cells = cellsOf(field.input);
  if (cells.empty()) return;
  const bool valid = !document_.parse(cells.front(), meant).problem;
  paint_invalid(*field.line, !valid);
  if (!valid && !finished) return;  // incomplete
  // The text of a field that is being edited is not replaced.
  applying_input_ = true;
  if (cells.size() == 1) {
    document_.edit(cells.front(), valid ? meant : typed);
    if (finished) document_.end_undo_step();
  } else if (valid) {
    std::vector<std::pair<Cell, std::string>> all;
    for (const Cell& cell : cells) all.emplace_back(cell, meant);
    document_.edit_all(all);
  } else {
    document_.edit(cells.front(), typed);
    document_.end_undo_step();
  }
  applying_input_ = false;
  if (!finished) return;
  field.line->setModified(false);
  sync();
}

}  // namespace adore::adrinput

#include "adrinput/find_dialog.hpp"

#include "adrinput/qt_text.hpp"
#include "adrinput/window_words.hpp"
#include "deck/lookup.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/spoken_name.hpp"
#include "runs/run_ending.hpp"

#include <QComboBox>
#include <QCompleter>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <set>

namespace adore::adrinput {
namespace {

constexpr int kChartWidth = 420, kChartHeight = 220;

QComboBox* searched_box(const char* name, const QString& spoken, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  box->setEditable(true);
  box->setInsertPolicy(QComboBox::NoInsert);
  box->completer()->setCompletionMode(QCompleter::PopupCompletion);
  box->completer()->setFilterMode(Qt::MatchContains);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(24);
  desktop::set_accessible_name(*box, spoken);
  return box;
}

QLineEdit* number_edit(const char* name, const QString& spoken, QWidget* parent) {
  auto* edit = new QLineEdit(parent);
  edit->setObjectName(name);
  edit->setAccessibleName(spoken);
  edit->setMaximumWidth(140);
  return edit;
}

/// Numeric variables of the records that the deck has, each once.
std::vector<std::pair<std::string, std::string>> numbers_of(const deck::Deck& deck) {
  std::vector<std::pair<std::string, std::string>> out;
  std::set<std::string_view> seen;
  for (const deck::RecordData& record : deck.records) {
    const deck::RecordSpec* spec = deck::find_record(record.id);
    if (spec == nullptr) continue;
    for (const deck::VariableSpec& one : spec->variables)
      if (one.type != deck::VarType::String && one.options.empty() && one.option_table.empty() &&
          seen.insert(one.name).second)
        out.emplace_back(one.name, one.help);
  }
  return out;
}

desktop::ChartPage page_of(const FindReport& report) {
  desktop::ChartPage page;
  page.title = report.target.name;
  page.x_title = report.unknown.name;
  page.x_unit = report.unknown.unit;
  page.points = true;
  page.log_x = report.outcome.equal_ratios && report.unknown.first > 0.0;
  desktop::ChartCurve curve;
  curve.name = report.target.name;
  for (const FindSample& sample : report.outcome.samples) {
    if (!page.x.empty() && sample.x <= page.x.back()) continue;
    page.x.push_back(sample.x);
    curve.y.push_back(std::isfinite(sample.value) ? sample.value
                                                  : std::numeric_limits<double>::quiet_NaN());
  }
  desktop::ChartPanel panel;
  panel.title = report.target.name;
  panel.unit = report.target.unit;
  panel.curves.push_back(std::move(curve));
  if (report.target.relation != Relation::Least && report.target.relation != Relation::Largest) {
    desktop::ChartCurve target;
    target.name = "target";
    target.dashed = true;
    target.y.assign(page.x.size(), report.target.value);
    panel.curves.push_back(std::move(target));
  }
  page.panels.push_back(std::move(panel));
  for (const FindSolution& one : report.outcome.solutions)
    page.marks.push_back({one.x, fmt::format("{:.5g}", one.x)});
  return page;
}

}  // namespace

FindDialog::FindDialog(Document& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      question_(new QComboBox(this)),
      unknown_(searched_box("find-unknown", tr("Unknown"), this)),
      target_(searched_box("find-target", tr("Target"), this)),
      relation_(new QComboBox(this)),
      solution_(new QComboBox(this)),
      first_(number_edit("find-first", tr("Lower bound"), this)),
      last_(number_edit("find-last", tr("Upper bound"), this)),
      target_value_field_(number_edit("find-value", tr("Target value"), this)),
      unknown_unit_(new QLabel(this)),
      target_unit_(new QLabel(this)),
      answer_(new QLabel(this)),
      find_(new QPushButton(tr("&Find"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      apply_(new QPushButton(tr("&Set in the deck"), this)),
      chart_(new desktop::ChartView(this)) {
  setObjectName("find");
  desktop::delete_when_done(*this);
  setWindowTitle(tr("Find the value of an input"));
  question_->setObjectName("find-question");
  desktop::set_accessible_name(*question_, tr("Question"));
  question_->addItem(tr("Own question"), QString());
  for (const design::FindQuestion& one : design::find_questions()) {
    if (!one.calculator.empty()) continue;
    const QString meaning = text_of(one.meaning);
    question_->addItem(meaning.left(1).toUpper() + meaning.mid(1), text_of(one.name));
  }
  question_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  question_->setMinimumContentsLength(40);
  for (const auto& [name, help] : numbers_of(document_.deck())) {
    unknown_->addItem(text_of(name));
    unknown_->setItemData(unknown_->count() - 1, text_of(help), Qt::ToolTipRole);
  }
  for (const design::FindResultInfo& one : design::find_results()) {
    target_->addItem(text_of(one.id), text_of(one.unit));
    target_->setItemData(target_->count() - 1, text_of(one.meaning), Qt::ToolTipRole);
  }
  relation_->setObjectName("find-relation");
  desktop::set_accessible_name(*relation_, tr("Relation"));
  relation_->addItems({tr("equals"), tr("at least"), tr("at most"), tr("least"), tr("largest")});
  solution_->setObjectName("find-solution");
  desktop::set_accessible_name(*solution_, tr("Solution"));
  answer_->setObjectName("find-answer");
  answer_->setAccessibleName(tr("Answer"));
  answer_->setWordWrap(true);
  answer_->setTextFormat(Qt::PlainText);
  answer_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  find_->setObjectName("find-run");
  find_->setDefault(true);
  cancel_->setObjectName("find-cancel");
  apply_->setObjectName("find-apply");
  chart_->setObjectName("find-chart");
  chart_->setMinimumSize(kChartWidth, kChartHeight);
  chart_->hide();

  auto* grid = new QGridLayout;
  const auto label = [&](const QString& text, QWidget* buddy, int row) {
    auto* out = new QLabel(text, this);
    out->setBuddy(buddy);
    grid->addWidget(out, row, 0);
  };
  label(tr("&Question"), question_, 0);
  grid->addWidget(question_, 0, 1, 1, 5);
  label(tr("&Unknown"), unknown_, 1);
  grid->addWidget(unknown_, 1, 1);
  grid->addWidget(new QLabel(tr("from"), this), 1, 2);
  grid->addWidget(first_, 1, 3);
  auto* to = new QHBoxLayout;
  to->addWidget(new QLabel(tr("to"), this));
  to->addWidget(last_);
  grid->addLayout(to, 1, 4);
  grid->addWidget(unknown_unit_, 1, 5);
  label(tr("&Target"), target_, 2);
  grid->addWidget(target_, 2, 1);
  grid->addWidget(relation_, 2, 2, 1, 2);
  grid->addWidget(target_value_field_, 2, 4);
  grid->addWidget(target_unit_, 2, 5);
  grid->setColumnStretch(1, 1);
  auto* buttons = new QHBoxLayout;
  auto* close = new QPushButton(tr("Close"), this);
  close->setAutoDefault(false);
  buttons->addWidget(find_);
  buttons->addWidget(cancel_);
  buttons->addStretch();
  buttons->addWidget(solution_);
  buttons->addWidget(apply_);
  buttons->addWidget(close);
  auto* column = new QVBoxLayout(this);
  column->addLayout(grid);
  column->addWidget(answer_);
  column->addWidget(chart_, 1);
  column->addStretch(0);
  column->addLayout(buttons);
  resize(720, sizeHint().height());

  connect(question_, &QComboBox::currentIndexChanged, this, &FindDialog::chooseQuestion);
  connect(unknown_, &QComboBox::currentTextChanged, this, &FindDialog::showUnits);
  connect(unknown_, &QComboBox::activated, this, &FindDialog::proposeBounds);
  connect(target_, &QComboBox::currentTextChanged, this, &FindDialog::showUnits);
  connect(relation_, &QComboBox::currentIndexChanged, this, &FindDialog::showUnits);
  connect(find_, &QPushButton::clicked, this, &FindDialog::find);
  connect(cancel_, &QPushButton::clicked, this, [this] { background_task_.stop(); });
  connect(apply_, &QPushButton::clicked, this, &FindDialog::apply);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  question_->setCurrentIndex(1);
  enableButtons();
}

void FindDialog::chooseQuestion(int row) {
  const std::string name = question_->itemData(row).toString().toStdString();
  for (const design::FindQuestion& one : design::find_questions()) {
    if (one.name != name) continue;
    unknown_->setCurrentText(text_of(one.unknown));
    target_->setCurrentText(text_of(one.target));
    relation_->setCurrentIndex(0);
    target_value_field_->setText(text_of(one.value));
    proposeBounds();
  }
}

void FindDialog::showUnits() {
  const std::string name = unknown_->currentText().toStdString();
  const deck::VariableRef ref =
      deck::find_present_variable(document_.deck(), name.substr(0, name.find('[')));
  QString unit;
  if (ref.record != nullptr)
    unit = text_of(document_.deck().units() == deck::UnitSystem::SI ? ref.spec().unit.si
                                                                    : ref.spec().unit.en);
  unknown_unit_->setText(unit == "-" ? QString() : unit);
  const int row = target_->findText(target_->currentText());
  target_unit_->setText(row < 0 ? QString() : target_->itemData(row).toString());
  const bool extremum = relation_->currentIndex() >= static_cast<int>(Relation::Least);
  target_value_field_->setEnabled(!extremum);
}

/// A quarter to four times the value of the deck.
void FindDialog::proposeBounds() {
  showUnits();
  const std::string name = unknown_->currentText().toStdString();
  if (deck::find_present_variable(document_.deck(), name).record == nullptr) return;
  const double value = document_.deck().real(name);
  if (value == 0.0) return;
  const auto [low, high] = std::minmax({0.25 * value, 4.0 * value});
  first_->setText(QString::number(low, 'g', 6));
  last_->setText(QString::number(high, 'g', 6));
}

void FindDialog::find() {
  if (busy()) return;
  design::FindRequest request;
  question_settings_.clear();
  try {
    document_.end_undo_step();  // includes the text being typed
    if (document_.has_errors()) throw InputError("the deck has errors. Correct them first (F8).");
    request.unknown = parse_unknown(fmt::format("{}={}:{}", unknown_->currentText().toStdString(),
                                                first_->text().trimmed().toStdString(),
                                                last_->text().trimmed().toStdString()));
    constexpr std::array<const char*, 5> signs{"=", ">=", "<=", "=least", "=largest"};
    const auto relation = static_cast<std::size_t>(relation_->currentIndex());
    request.target = parse_target(target_->currentText().toStdString() + signs.at(relation) +
                                  (target_value_field_->isEnabled()
                                       ? target_value_field_->text().trimmed().toStdString()
                                       : std::string()));
    request.deck = "deck";
    request.text = deck::write_deck(document_.deck());
    request.in_memory = true;
    for (const auto& [name, value] : document_.options()) request.options.emplace_back(name, value);
    const std::string asked = question_->currentData().toString().toStdString();
    for (const design::FindQuestion& one : design::find_questions())
      if (one.name == asked && one.unknown == request.unknown.name) design::add_sets(one, request);
    question_settings_ = request.sets;
  } catch (const InputError& error) {
    report_.reset();
    return showOutcome(QString::fromStdString(replace_cli_terms(error.what())));
  }
  answer_deck_ = document_.deck();
  report_.reset();
  struct End {
    FindReport report;
    std::string failure;
  };
  auto end = std::make_shared<End>();
  const auto computed = [this](int count) {
    background_task_.report([this, count] {
      if (busy()) answer_->setText(tr("%1 equilibria computed …").arg(count));
    });
  };
  answer_->setText(tr("Computing …"));
  background_task_.start(
      [request = std::move(request), computed, end](std::stop_token stop) {
        try {
          end->report = design::find_in_deck(request, std::move(stop), computed);
        } catch (const std::exception& error) {
          end->failure = replace_cli_terms(error.what());
        }
      },
      [this, end] {
        if (end->failure.empty()) report_ = std::move(end->report);
        showOutcome(QString::fromStdString(end->failure));
      });
  enableButtons();
}

void FindDialog::showOutcome(const QString& failure) {
  solution_->clear();
  answer_text_ = failure.left(1).toUpper() + failure.mid(1);
  chart_->setVisible(report_.has_value());
  if (report_) {
    QStringList lines;
    for (const std::string& line : answer_lines(*report_)) lines << QString::fromStdString(line);
    answer_text_ = lines.join("\n");
    for (const FindSolution& one : report_->outcome.solutions)
      solution_->addItem(QString::number(one.x, 'g', 6) + " " +
                         QString::fromStdString(report_->unknown.unit));
    chart_->showPage(page_of(*report_));
  }
  showAnswer();
  enableButtons();
  if (report_) resize(size().expandedTo(sizeHint()));
  emit finished();
}

void FindDialog::showAnswer() {
  const bool stale = report_ && !(answer_deck_ == document_.deck());
  answer_->setText((stale ? tr("Out of date: the deck has changed.\n") : QString()) + answer_text_);
}

void FindDialog::enableButtons() {
  find_->setEnabled(!busy());
  cancel_->setEnabled(busy());
  apply_->setEnabled(!busy() && solution_->count() > 0);
  solution_->setVisible(solution_->count() > 1);
}

void FindDialog::sync() {
  if (!busy()) showAnswer();
}

void FindDialog::apply() {
  const auto row = static_cast<std::size_t>(std::max(solution_->currentIndex(), 0));
  if (!report_ || row >= report_->outcome.solutions.size()) return;
  auto changes = question_settings_;
  changes.emplace_back(report_->unknown.name, runs::value_text(report_->outcome.solutions[row].x));
  try {
    document_.change(changes);
    answer_deck_ = document_.deck();  // the answer is that of the deck as it is now
    showAnswer();
    emit solutionApplied();
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

}  // namespace adore::adrinput

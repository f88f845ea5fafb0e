#include "adrinput/evaluation.hpp"

#include "adrinput/window_words.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/listing_view.hpp"
#include "listing/print_file.hpp"
#include "listing/print_life.hpp"
#include "runs/effect_costs.hpp"
#include "runs/prepare.hpp"
#include "runs/solution_tables.hpp"
#include "studies/model_errors.hpp"

#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

namespace adore::adrinput {
namespace {

runs::Prepared prepared(const deck::Deck& deck, const std::filesystem::path& path,
                        const RunOptionValues& options) {
  runs::LoadedDeck input;
  input.path = path.empty() ? std::filesystem::path("new deck") : path;
  input.deck = deck;
  input.option_values = options;
  return runs::prepare(std::move(input));
}

std::string key_results(const runs::Prepared& ready, deck::UnitSystem units) {
  namespace unit = results::unit;
  const auto& found = ready.race_result();
  const auto text = [&](double value, const deck::UnitPair& pair) {
    const std::string name(results::unit_name(pair, units));
    const double shown = results::from_si(value, pair, units);
    // Changes below the size of an atom are rounding.
    return desktop::pretty_quantity(std::abs(shown) < desktop::min_axis_span(name) ? 0.0 : shown,
                                    name);
  };
  return fmt::format(
      "Inner race displacement {} axial, {} along y, {} along z. Largest contact load {}, largest "
      "approach {}. Stiffness {} axial, {} along z.",
      text(found.displacement[0], unit::kLength), text(found.displacement[1], unit::kLength),
      text(found.displacement[2], unit::kLength), text(found.max_load, unit::kForce),
      text(found.max_deflection, unit::kLength), text(found.stiffness(0, 0), unit::kStiffness),
      text(found.stiffness(2, 2), unit::kStiffness));
}

std::vector<Finding> findings_of(const runs::Prepared& ready) {
  std::vector<Finding> out = ready.input.warnings;
  for (Finding& one : runs::solution_notes(ready)) out.push_back(std::move(one));
  for (Finding& one : out) {
    one.message = replace_cli_terms(std::move(one.message));
    one.remedy = replace_cli_terms(std::move(one.remedy));
  }
  return out;
}

}  // namespace

Evaluation evaluate_plan(const deck::Deck& deck, const std::filesystem::path& path,
                         const RunOptionValues& options) {
  const runs::Prepared ready = prepared(deck, path, options);
  std::string text = replace_cli_terms(runs::plan_text(ready, runs::plan_with_estimates(ready)));
  const std::string costs = runs::effect_costs_text(ready);
  if (!costs.empty()) text += "\n" + costs;
  if (const auto models = runs::find_model_study(ready.input))
    text += "\n" + runs::model_table(*models);
  return {{}, std::move(text), std::nullopt, findings_of(ready)};
}

Evaluation evaluate_quasi_static(const deck::Deck& deck, const std::filesystem::path& path,
                                 const RunOptionValues& options) {
  deck::Deck still = deck;
  still.set("mode", "-1");  // only the equilibrium, for any mode of the deck
  still.complete();
  const runs::Prepared ready = prepared(still, path, options);
  listing::Report report(ready.bearing.run_id, deck.units());
  if (ready.rollers)
    listing::print_quasi_static(report, *ready.rollers, ready.bearing);
  else
    listing::print_quasi_static(report, ready.statics, ready.bearing);
  listing::print_life(report, ready.life);
  std::string text = report.take();
  std::replace(text.begin(), text.end(), '\f', '\n');
  return {key_results(ready, deck.units()), std::move(text), runs::solution_tables(ready),
          findings_of(ready)};
}

EvaluationPanel::EvaluationPanel(Function function, const QString& invitation, QWidget* parent)
    : QWidget(parent),
      function_(function),
      initial_note_(invitation),
      note_(new QLabel(invitation, this)),
      findings_(new desktop::FindingsBar(this)),
      view_(desktop::make_listing_view(tr("Result"), this)) {
  connect(findings_, &desktop::FindingsBar::chosen, this, &EvaluationPanel::findingChosen);
  note_->setWordWrap(true);
  note_->setObjectName("note");
  view_->setObjectName("text");
  view_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->addWidget(note_);
  layout->addWidget(findings_);
  layout->addWidget(view_, 1);
  layout->setAlignment(note_, Qt::AlignTop);
}

QString EvaluationPanel::text() const { return view_->toPlainText(); }

QString EvaluationPanel::headline() const { return headline_; }

/// The key results; of an older deck with the remark that they are.
void EvaluationPanel::showNote() {
  QString note = headline_;
  if (stale_) note = tr("Out of date: the deck has changed. Compute again. ") + note;
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
}

void EvaluationPanel::invalidateResult() {
  deck_replaced_ = busy();
  if (deck_replaced_) return;  // when it ends
  evaluated_deck_ = {};
  stale_ = false;
  headline_.clear();
  tables_.reset();
  findings_->setFindings({});
  view_->clear();
  view_->hide();
  note_->setText(initial_note_);
  note_->show();
}

void EvaluationPanel::show(const Evaluation& result, bool failed) {
  headline_ = failed ? tr("No result:") : QString::fromStdString(result.headline);
  tables_ = result.tables;
  findings_->setFindings(result.findings);
  view_->setPlainText(QString::fromStdString(result.text));
  view_->show();
  showNote();
}

void EvaluationPanel::setTextAccessibleName(const QString& name) { view_->setAccessibleName(name); }

void EvaluationPanel::start(const deck::Deck& deck, const std::filesystem::path& path,
                            const RunOptionValues& options) {
  if (busy()) return;
  evaluated_deck_ = deck;
  evaluated_options_ = options;
  stale_ = deck_replaced_ = false;
  findings_->setFindings({});
  note_->setText(tr("Computing …"));
  note_->show();
  struct Outcome {
    Evaluation result;
    bool failed = false;
  };
  auto outcome = std::make_shared<Outcome>();
  background_task_.start(
      [function = function_, deck, path, options, outcome](const std::stop_token&) {
        try {
          outcome->result = function(deck, path, options);
        } catch (const std::exception& error) {
          outcome->result.text = replace_cli_terms(error.what());
          outcome->failed = true;
        }
      },
      [this, outcome] {
        if (deck_replaced_)
          invalidateResult();
        else
          show(outcome->result, outcome->failed);
        emit finished();
      });
}

void EvaluationPanel::setDeck(const deck::Deck& deck, const RunOptionValues& options) {
  if (evaluated_deck_.records.empty()) return;  // nothing was computed yet
  const bool stale = !(deck == evaluated_deck_) || options != evaluated_options_;
  if (stale == stale_) return;
  stale_ = stale;
  if (!busy()) showNote();
}

}  // namespace adore::adrinput

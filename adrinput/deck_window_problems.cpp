#include "adrinput/deck_window.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_list.hpp"
#include "adrinput/record_page.hpp"
#include "base/counted.hpp"
#include "base/excerpt.hpp"
#include "desktop/theme.hpp"

#include <QListWidget>
#include <QTabWidget>

#include <algorithm>
#include <utility>

/// The panel of problems, and the commands for the next and previous one.
namespace adore::adrinput {

void DeckWindow::refreshProblems() {
  const desktop::Theme& theme = desktop::current_theme();
  const int selected = problem_list_->currentRow();
  problem_list_->clear();
  int errors = 0, warnings = 0;
  for (const Problem& problem : document_.problems()) {
    const Issue& issue = problem.issue;
    const bool error = issue.severity == Severity::Error;
    errors += error || problem.refused ? 1 : 0;
    warnings += !problem.refused && issue.severity == Severity::Warning ? 1 : 0;
    QString text = error                                 ? tr("Error")
                   : problem.refused                     ? tr("Refused")
                   : issue.severity == Severity::Warning ? tr("Warning")
                                                         : tr("Note");
    if (!issue.record.empty())
      text += (issue.record == kOptionsPage ? QString(", %1") : tr(", record %1"))
                  .arg(QString::fromStdString(issue.record));
    if (!issue.variable.empty()) text += ", " + QString::fromStdString(issue.variable);
    if (!issue.value.empty()) text += " = " + QString::fromStdString(excerpt(issue.value));
    text += ": " + QString::fromStdString(issue.message);
    if (!issue.remedy.empty()) text += "; " + QString::fromStdString(issue.remedy);
    auto* item =
        new QListWidgetItem(state_icon(error ? RecordState::Wrong
                                       : problem.refused || issue.severity == Severity::Warning
                                           ? RecordState::Doubtful
                                           : RecordState::Untouched),
                            text, problem_list_);
    item->setForeground(error ? theme.red : theme.text);
  }
  if (problem_list_->count() == 0) {
    const bool ready = document_.deck_state() == DeckState::Ready;
    auto* item =
        new QListWidgetItem(state_icon(ready ? RecordState::Complete : RecordState::Untouched),
                            ready ? tr("The deck is complete and has no problems.")
                                  : tr("The deck has no errors. Checking that the run can start …"),
                            problem_list_);
    item->setFlags(Qt::ItemIsEnabled);
  }
  problem_list_->setCurrentRow(std::min(selected, problem_list_->count() - 1));
  const auto total = static_cast<int>(document_.problems().size());
  QStringList counts;
  for (const auto& [count, one] : {std::pair(errors, "error"), std::pair(warnings, "warning"),
                                   std::pair(total - errors - warnings, "note")})
    if (count > 0) counts << QString::fromStdString(counted(count, one));
  tabs_->setTabText(0,
                    counts.isEmpty() ? tr("Problems") : tr("Problems (%1)").arg(counts.join(", ")));
}

void DeckWindow::goToProblem(int row) {
  if (row < 0 || row >= static_cast<int>(document_.problems().size())) return;
  const Problem problem = document_.problems()[static_cast<std::size_t>(row)];
  visited_problem_ = problem.issue.text();
  if (problem.page.empty()) return;
  showRecord(problem.page);
  if (problem.cell) record_page_->focusCell(*problem.cell);
}

void DeckWindow::goToFinding(const Finding& finding) {
  const Issue place = issue_of_finding(document_.deck(), finding).value_or(finding);
  const std::optional<Cell> cell = cell_of(place);
  if (place.record.empty()) return;
  const std::vector<std::string> pages = document_.pages();
  if (std::find(pages.begin(), pages.end(), place.record) == pages.end()) return;
  showRecord(place.record);
  if (cell) record_page_->focusCell(*cell);
}

void DeckWindow::goToAdjacentProblem(int by) {
  const auto count = static_cast<int>(document_.problems().size());
  tabs_->setCurrentWidget(problem_list_);
  if (count == 0) return;
  const int here = problem_list_->currentRow();
  // A corrected problem is removed from the list, and the next one is in its row.
  const bool mended =
      by > 0 && here >= 0 && here < count && !visited_problem_.empty() &&
      document_.problems()[static_cast<std::size_t>(here)].issue.text() != visited_problem_;
  const int row = mended ? here : (std::max(here, by > 0 ? -1 : 0) + by + count) % count;
  problem_list_->setCurrentRow(row);
  goToProblem(row);
}

void DeckWindow::nextProblem() { goToAdjacentProblem(1); }
void DeckWindow::previousProblem() { goToAdjacentProblem(-1); }

}  // namespace adore::adrinput

#include "adrplot/cursor_time.hpp"
#include "adrplot/element_curves.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/spectrum_page.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/run_link.hpp"

#include <QProgressDialog>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

/// Time of cursor A and selected element, shared with other windows of the run.
namespace adore::adrplot {

void PlotWindow::makeLink() {
  link_ = new desktop::RunLink(this);
  connect(link_, &desktop::RunLink::told, this, &PlotWindow::applyLinkState);
  connect(view_, &desktop::ChartView::cursorsChanged, this, &PlotWindow::sendCursorTime);
}

/// A user-defined chart belongs to the run of its first curve.
const PlotDocument* PlotWindow::linkedFile() {
  const Document* const doc = document();
  if (doc == nullptr) return nullptr;
  if (doc->own && !doc->own->curves.empty()) return doc->own->curves.front().file;
  if (current_ == formulaDocumentIndex() && !formulas_.empty() && !formulas_.front().inputs.empty())
    return formulas_.front().inputs.front().file.get();
  return doc;
}

/// The windows of another run have another time.
void PlotWindow::joinLink() {
  const PlotDocument* const file = linkedFile();
  motion_.reset();
  std::error_code none;  // results in memory have no file
  const QString folder = file != nullptr && std::filesystem::exists(file->path, none)
                             ? QString::fromStdString(run_folder(file->path).string())
                             : QString();
  if (folder == link_->folder()) return;
  linked_time_.reset();
  stopFollowingElement();
  linked_cursor_ = view_->cursorAbscissa(0);
  link_->join(folder);
}

/// Read once for a page: cursors move with a playing animation.
const RunMotion& PlotWindow::linkedMotion() {
  if (!motion_) {
    const PlotDocument* const file = linkedFile();
    motion_ = file != nullptr && file->motion ? file->motion() : RunMotion{};
  }
  return *motion_;
}

void PlotWindow::sendCursorTime() {
  const double at = view_->cursorAbscissa(0);
  if (taking_ || at == linked_cursor_ || link_->folder().isEmpty()) return;
  linked_cursor_ = at;
  const desktop::ChartPage& page = view_->chartScene().page();
  if (const auto time = time_of_cursor(page, linkedMotion(), at)) {
    linked_time_ = time;
    link_->tell({time, {}});
  } else if (linked_time_ && cursor_at_time(page, linkedMotion(), *linked_time_)) {
    linked_time_.reset();  // the user removed the cursor
  }
}

void PlotWindow::showLinkedTime() {
  if (!linked_time_ || !link_->isActive()) return;
  const auto at = cursor_at_time(view_->chartScene().page(), linkedMotion(), *linked_time_);
  if (!at) return;
  const QScopedValueRollback quiet(taking_, true);
  view_->setCursorAbscissa(0, *at);
  linked_cursor_ = view_->cursorAbscissa(0);
}

void PlotWindow::applyLinkState(const desktop::LinkState& change) {
  if (change.time) linked_time_ = change.time;
  if (change.element) followed_element_ = *change.element;
  if (reading_progress_dialog_ || !document()) return;  // shown with the next page
  if (change.time) showLinkedTime();
  if (change.element) showElement(*change.element);
}

void PlotWindow::emphasizeLinkedElement(desktop::ChartPage& page) const {
  if (const auto& element = link_->state().element; element && link_->isActive())
    (void)emphasize_element(page, *element);
}

/// The same page of its file, if the page of another element is shown.
void PlotWindow::showElement(int number) {
  const Document* const here = document();
  if (!here->on_disk) return showCurrentPage();  // its curves may change
  if (element_of(*here) == 0) {
    desktop::ChartPage page = view_->chartScene().page();
    if (emphasize_element(page, number)) view_->chartScene().setPage(std::move(page), true);
    return;
  }
  if (element_of(*here) == number) return;
  const auto found = std::find_if(documents_.begin(), documents_.end(), [&](const auto& one) {
    return element_of(*one) == number && run_folder(one->path) == run_folder(here->path);
  });
  if (found == documents_.end()) return;
  QTreeWidgetItem* file = tree_->topLevelItem(static_cast<int>(found - documents_.begin()));
  const QScopedValueRollback quiet(taking_, true);
  if (file != nullptr && page_ <= file->childCount()) tree_->setCurrentItem(file->child(page_ - 1));
}

void PlotWindow::sendElement() {
  const Document* const doc = document();
  const int number = doc ? element_of(*doc) : 0;
  if (number > 0 && !taking_ && number != link_->state().element) link_->tell({{}, number});
}

std::vector<const PlotDocument*> PlotWindow::openFiles() const {
  std::vector<const PlotDocument*> out;
  for (const auto& document : documents_)
    if (document->on_disk) out.push_back(document.get());
  return out;
}

desktop::ChartPage PlotWindow::buildPage(const PlotDocument& file, int page) const {
  const auto found = std::find_if(documents_.begin(), documents_.end(),
                                  [&](const auto& one) { return one.get() == &file; });
  if (followed_element_ == 0 || !link_->isActive() || found == documents_.end() ||
      (*found)->on_disk)
    return file.build(page, options_);
  const auto with_note = [this](desktop::ChartPage chart) {
    add_note(chart, fmt::format("Shown for element {}, which is selected in another window.",
                                followed_element_));
    return chart;
  };
  if (const UserChart* const own = (*found)->own.get()) {
    if (const auto other = chart_of_element(*own, followed_element_, openFiles()))
      return with_note(combine_curves(other->curves, other->how, options_));
  } else if (page >= 1 && page <= static_cast<int>(formulas_.size())) {
    std::vector<FormulaChannel> channels = formulas_;
    FormulaChannel& channel = channels[static_cast<std::size_t>(page - 1)];
    if (auto other = formula_of_element(channel, followed_element_, openFiles())) {
      channel = std::move(*other);
      return with_note(formula_document(std::move(channels)).build(page, options_));
    }
  }
  return file.build(page, options_);
}

}  // namespace adore::adrplot

#include "adrplot/cursor_time.hpp"
#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/run_link.hpp"

#include <QProgressDialog>
#include <QScopedValueRollback>
#include <QTreeWidget>

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
  if (reading_progress_dialog_ || !document()) return;  // shown with the next page
  if (change.time) showLinkedTime();
  if (change.element) showElement(*change.element);
}

namespace {

/// Number of the rolling element that a file is of; 0: of another body.
int element_of(const PlotDocument& file) {
  return file.subject.starts_with("rolling element") ? desktop::parse_element_number(file.subject)
                                                     : 0;
}

/// On a page of all elements, the curves of one are shown and drawn thick. False: another page.
bool emphasize_element(desktop::ChartPage& page, int number) {
  const std::string name = "element " + std::to_string(number);
  const auto has_name = [&](const desktop::ChartCurve& curve) { return curve.name == name; };
  if (page.equal_axes || std::none_of(page.panels.begin(), page.panels.end(), [&](auto& panel) {
        return std::any_of(panel.curves.begin(), panel.curves.end(), has_name);
      }))
    return false;
  for (desktop::ChartPanel& panel : page.panels)
    for (desktop::ChartCurve& curve : panel.curves) {
      curve.heavy = has_name(curve);
      if (curve.heavy) curve.hidden = false;
    }
  return true;
}

}  // namespace

void PlotWindow::emphasizeLinkedElement(desktop::ChartPage& page) const {
  if (const auto& element = link_->state().element; element && link_->isActive())
    (void)emphasize_element(page, *element);
}

/// The same page of its file, if the page of another element is shown.
void PlotWindow::showElement(int number) {
  const Document* const here = document();
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

}  // namespace adore::adrplot

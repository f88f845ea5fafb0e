#include "adrinput/deck_window.hpp"
#include "adrinput/design_form.hpp"
#include "adrinput/design_page.hpp"
#include "adrinput/record_list.hpp"
#include "adrinput/record_page.hpp"

#include <QDockWidget>
#include <QScrollArea>
#include <QTabWidget>

#include <utility>

/// The front page in the window. Records, panels and docks have the space when it is left.
namespace adore::adrinput {

QWidget* DeckWindow::makeDesignPage() {
  design_page_ = new DesignPage(document_, this);
  design_page_->hide();
  connect(design_page_, &DesignPage::recordsRequested, this,
          [this] { showRecord(current_record_); });
  connect(design_page_, &DesignPage::catalogRequested, this, &DeckWindow::newFromCatalogue);
  connect(design_page_, &DesignPage::findingChosen, this, &DeckWindow::goToFinding);
  connect(design_page_, &DesignPage::convertedToDynamicDeck, this, [this](bool run) {
    record_page_->sync(true);
    if (run) runDeck();
  });
  connect(list_, &RecordList::designChosen, this, &DeckWindow::showDesign);
  return design_page_;
}

bool DeckWindow::isDesignShown() const {
  return design_page_ != nullptr && !design_page_->isHidden();
}

std::string DeckWindow::currentPage() const {
  return isDesignShown() ? kDesignPage : current_record_;
}

QByteArray DeckWindow::dockState() const {
  return isDesignShown() ? saved_dock_state_ : saveState();
}

void DeckWindow::showDesign() {
  if (isDesignShown()) return design_page_->form().focusBearing();
  document_.end_undo_step();
  saved_dock_state_ = saveState();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->hide();
  tabs_->hide();  // a run, plan or solution shows them
  scroll_area_->hide();
  buttons_->hide();
  design_page_->show();
  list_->setCurrentRecord(kDesignPage);
  design_page_->form().focusBearing();
  emit pageShown();
}

void DeckWindow::hideDesign() {
  if (!isDesignShown()) return;
  design_page_->form().commitFields();
  document_.end_undo_step();
  design_page_->hide();
  scroll_area_->show();
  buttons_->show();
  tabs_->show();
  restoreState(std::exchange(saved_dock_state_, {}));
  hideEmptyPanels();
  if (charts_dock_->property("waiting").toBool()) {  // a solution came meanwhile
    charts_dock_->setProperty("waiting", false);
    showCharts();
  }
  list_->setCurrentRecord(current_record_);
  record_page_->sync(true);
}

}  // namespace adore::adrinput

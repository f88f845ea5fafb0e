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

QWidget* DeckWindow::makeDesign() {
  design_ = new DesignPage(document_, this);
  design_->hide();
  connect(design_, &DesignPage::recordsWanted, this, [this] { showRecord(current_); });
  connect(design_, &DesignPage::catalogueWanted, this, &DeckWindow::newFromCatalogue);
  connect(design_, &DesignPage::findingChosen, this, &DeckWindow::goToFinding);
  connect(design_, &DesignPage::moved, this, [this](bool run) {
    page_->sync(true);
    if (run) runDeck();
  });
  connect(list_, &RecordList::designChosen, this, &DeckWindow::showDesign);
  return design_;
}

bool DeckWindow::designShown() const { return design_ != nullptr && !design_->isHidden(); }

std::string DeckWindow::currentPage() const { return designShown() ? kDesignPage : current_; }

QByteArray DeckWindow::dockState() const { return designShown() ? docks_ : saveState(); }

void DeckWindow::showDesign() {
  if (designShown()) return design_->form().focusBearing();
  document_.end_step();
  docks_ = saveState();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->hide();
  tabs_->hide();  // a run, plan or solution shows them
  scroll_->hide();
  buttons_->hide();
  design_->show();
  list_->setCurrent(kDesignPage);
  design_->form().focusBearing();
  emit pageShown();
}

void DeckWindow::leaveDesign() {
  if (!designShown()) return;
  design_->form().finish();
  document_.end_step();
  design_->hide();
  scroll_->show();
  buttons_->show();
  tabs_->show();
  restoreState(std::exchange(docks_, {}));
  hideEmptyPanels();
  if (charts_dock_->property("waiting").toBool()) {  // a solution came meanwhile
    charts_dock_->setProperty("waiting", false);
    showCharts();
  }
  list_->setCurrent(current_);
  page_->sync(true);
}

}  // namespace adore::adrinput

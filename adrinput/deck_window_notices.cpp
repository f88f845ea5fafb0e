#include "adrinput/compare_dialog.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/design_page.hpp"
#include "adrinput/file_names.hpp"
#include "adrinput/file_watch.hpp"
#include "adrinput/find_dialog.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/search.hpp"
#include "adrinput/settings.hpp"
#include "adrinput/typed.hpp"
#include "adrinput/unit_choice.hpp"
#include "adrinput/unit_view.hpp"
#include "base/input_file.hpp"
#include "deck/quantity.hpp"
#include "deck/templates.hpp"
#include "desktop/dialogs.hpp"

#include <QAction>
#include <QBoxLayout>
#include <QFileDialog>
#include <QMenu>
#include <QStatusBar>

#include <algorithm>
#include <exception>

/// Questions above the form, comparing with other decks, and units.
namespace adore::adrinput {

void DeckWindow::makeNotices(QBoxLayout* column) {
  session_notice_ = new NoticeBar("session-notice", this);
  file_notice_ = new NoticeBar("file-notice", this);
  units_notice_ = new NoticeBar("units-notice", this);
  search_notice_ = new NoticeBar("search-notice", this);
  for (NoticeBar* bar : {session_notice_, file_notice_, units_notice_, search_notice_})
    column->addWidget(bar);
  file_watch_ = new FileWatch(this);
  connect(file_watch_, &FileWatch::fileModified, this, &DeckWindow::checkFile);
}

void DeckWindow::makeCompareMenu(QMenu* file) {
  QMenu* compare = file->addMenu(tr("&Compare with"));
  compare->setObjectName("compare-menu");
  compare->addAction(tr("&Another deck …"), QKeySequence(Qt::CTRL | Qt::Key_K), this,
                     &DeckWindow::askForComparison);
  QAction* saved = compare->addAction(tr("The &saved file"), this, &DeckWindow::compareWithSaved);
  connect(compare, &QMenu::aboutToShow, this,
          [this, saved] { saved->setEnabled(!document_.path().empty()); });
  compare->addSeparator();
  for (const deck::TemplateInfo& info : deck::templates()) {
    const QString name = QString::fromStdString(std::string(info.name));
    compare->addAction(tr("Example %1").arg(name), this, [this, name] {
      compareWith(deck::new_deck(name.toStdString()), tr("the example %1").arg(name));
    });
  }
}

void DeckWindow::makeUnitsMenu(QMenu* view) {
  other_units_ = view->addAction(tr("Show both &unit systems"));
  other_units_->setObjectName("other-units-action");
  other_units_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_U));
  other_units_->setCheckable(true);
  connect(other_units_, &QAction::toggled, this,
          [this](bool on) { record_page_->setOtherUnitsShown(on); });
  QAction* reopen = view->addAction(tr("R&eopen the last deck at startup"));
  reopen->setObjectName("reopen");
  reopen->setCheckable(true);
  reopen->setChecked(settings().value("session/reopen", true).toBool());
  connect(reopen, &QAction::toggled, this,
          [](bool on) { settings().setValue("session/reopen", on); });
}

/// The unit in which values of each kind of quantity are shown; same as the button next to each
/// field.
void DeckWindow::makeUnitChoices(QMenu* view) {
  QMenu* choices = view->addMenu(tr("Show &values in"));
  choices->setObjectName("unit-choices");
  for (const Quantity& quantity : quantities_with_unit_choice()) {
    QMenu* menu = choices->addMenu(quantity.name);
    connect(menu, &QMenu::aboutToShow, this, [this, menu, si = quantity.si] {
      menu->clear();
      const auto add = [&](const QString& text, const QString& unit) {
        QAction* action = menu->addAction(text, this, [this, si, unit] {
          choose_unit(si, unit);
          showUnits();
        });
        action->setCheckable(true);
        action->setChecked(chosen_unit(si) == unit);
      };
      add(tr("as in deck"), {});
      for (const std::string_view unit : deck::usual_units({si, si})) {
        const QString name = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
        add(name, name);
      }
    });
  }
}

/// To the option that would bring the value's record in, with the offer to set it.
void DeckWindow::goToEnablingOption(const Cell& cell) {
  const deck::RecordSpec& spec = *page_record(cell.record);
  const QString name = QString::fromStdString(std::string(variable_of(cell)->name));
  const std::optional<EnablingOption> way = find_enabling_option(document_.deck(), cell.record);
  if (!way) {
    desktop::show_message(
        this,
        tr("%1 is in record %2, which this deck does not have. The record requires %3.")
            .arg(name, record_number(spec), QString::fromStdString(std::string(spec.condition))));
    return;
  }
  const deck::VariableSpec& option = *variable_of(way->option);
  const QString option_name = QString::fromStdString(std::string(option.name));
  const QString code = QString::fromStdString(way->code);
  const QString meaning = QString::fromStdString(meaning_of(option, way->code));
  showRecord(way->option.record);
  record_page_->focusCell(way->option);
  search_notice_->ask(
      (way->enough ? tr("%1 is in record %2, which requires %3 = %4%5.")
                   : tr("%1 is in record %2, which this deck does not have. Set %3 = %4%5 first."))
          .arg(name, record_number(spec), option_name, code,
               meaning.isEmpty() ? QString() : " (" + meaning + ")"),
      {{"set-option", tr("Ad&just %1 to %2").arg(option_name, code),
        [this, way = *way, cell] {
          document_.end_undo_step();
          document_.edit(way.option, way.code);
          document_.end_undo_step();
          record_page_->sync(true);
          if (way.enough || document_.instances(cell.record) > 0)
            goTo(cell);
          else
            goToEnablingOption(cell);
        }},
       {"leave-option", tr("Ignore"), nullptr}});
}

void DeckWindow::showPage(const std::string& record) {
  if (record == kDesignPage) return showDesign();
  const std::vector<std::string> pages = document_.pages();
  if (std::find(pages.begin(), pages.end(), record) != pages.end()) showRecord(record);
}

void DeckWindow::refreshNotices() {
  file_watch_->setPath(document_.path());
  const std::optional<deck::UnitSystem> previous_units = document_.previous_units();
  if (!previous_units) {
    units_notice_->hide();
  } else if (!units_notice_->isVisibleTo(this)) {
    const bool si = document_.deck().units() == deck::UnitSystem::SI;
    units_notice_->ask(tr("The deck is now in %1, but values entered earlier are still in %2.")
                           .arg(si ? tr("SI units") : tr("English units"),
                                si ? tr("English units") : tr("SI units")),
                       {{"convert", tr("C&onvert values"),
                         [this] {
                           document_.convert_values();
                           record_page_->sync(true);
                           record_page_->setFocus();
                           record_page_->focusFirst();
                         }},
                        {"keep-numbers", tr("&Keep numbers"), [this] {
                           document_.keep_numbers();
                           record_page_->focusFirst();
                         }}});
  }
  if (compare_dialog_ != nullptr) compare_dialog_->sync();
  if (find_dialog_ != nullptr) find_dialog_->sync();
}

void DeckWindow::checkFile() {
  const std::filesystem::path path = document_.path();
  std::error_code error;
  if (path.empty()) return;
  const QString name = QString::fromStdString(shortened_path(path));
  if (!std::filesystem::exists(path, error)) {
    file_notice_->ask(
        tr("Another program removed or renamed %1. Saving creates it again.").arg(name),
        {{"file-ok", tr("OK"), nullptr}});
    return;
  }
  if (!document_.changed_on_disk(path)) return file_notice_->hide();
  const bool mine = document_.modified();
  file_notice_->ask(tr("Another program changed %1.").arg(name),
                    {{"reload", mine ? tr("Reload, &discard my changes") : tr("Reloa&d"),
                      [this, path] {
                        const std::string page = currentPage();
                        if (openFile(path)) showPage(page);
                      }},
                     {"keep-mine", tr("Keep m&ine"), [this] { document_.keep_edited_deck(); }},
                     {"compare-file", tr("Co&mpare"), [this] {
                        compareWithSaved();
                        checkFile();  // the question is still open
                      }}});
}

void DeckWindow::restoreDeck(const std::string& bytes, std::function<void()> then) {
  resolveUnsavedChanges([this, bytes, then = std::move(then)] {
    try {
      const std::filesystem::path before = document_.path();
      const std::string page = document_.restore(bytes);
      if (!before.empty() && before != document_.path())
        statusBar()->showMessage(
            tr("%1 was closed").arg(QString::fromStdString(shortened_path(before))), 8000);
      invalidateResults();
      checkNow();
      current_record_.clear();
      buildRecordPage(document_.pages().front());
      showPage(page);
      checkFile();
      then();
    } catch (const std::exception& error) {
      desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  });
}

void DeckWindow::compareWith(deck::Deck other, const QString& name) {
  delete compare_dialog_;
  compare_dialog_ = new CompareDialog(document_, std::move(other), name, this);
  connect(compare_dialog_, &CompareDialog::cellChosen, this, [this](const Cell& cell) {
    if (document_.instances(cell.record) == 0 && cell.record != "12") return;
    showRecord(cell.record);
    record_page_->focusCell(cell);
  });
  compare_dialog_->show();
}

void DeckWindow::compareWithSaved() {
  if (document_.path().empty())
    return desktop::show_message(this, tr("The deck has not been saved yet."));
  compareWithFile(document_.path(), tr("the saved file"));
}

void DeckWindow::compareWithFile(const std::filesystem::path& path, const QString& name) {
  try {
    reject_special_file(path);
    compareWith(deck::read_deck(path).deck, name);
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

void DeckWindow::askForComparison() {
  auto* dialog = new QFileDialog(this, tr("Compare with"), settings().value("folder").toString(),
                                 tr("Decks (*.txt *.TXT *.dat *.DAT);;All files (*)"));
  dialog->setObjectName("compare-open");
  desktop::delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& name) {
    compareWithFile(name.toStdString(), QFileInfo(name).fileName());
  });
  dialog->open();
}

}  // namespace adore::adrinput

#include "adrinput/study_menu.hpp"

#include "adrinput/deck_window.hpp"
#include "adrinput/study_window.hpp"
#include "desktop/dialogs.hpp"

#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>

namespace adore::adrinput {

bool has_study_file_name(const std::filesystem::path& file) {
  return file.extension() == ".json" || file.extension() == ".toml";
}

void DeckWindow::makeStudyMenu() {
  QMenu* studies = menuBar()->addMenu(tr("&Studies"));
  studies->setObjectName("studies");
  StudyWindow::addKindActions(*studies, [this](const QString& kind) { newStudy(kind); });
  studies->addSeparator();
  studies->addAction(tr("&Open a study …"), this, &DeckWindow::openStudy);
}

void DeckWindow::newStudy(const QString& kind) {
  if (!readyToCompute()) return;
  withSavedDeck([this, kind] {
    auto* window = new StudyWindow;
    window->setAttribute(Qt::WA_DeleteOnClose);
    const std::filesystem::path deck = std::filesystem::absolute(document_.path());
    window->newStudy(deck.parent_path() / (kind.toStdString() + ".json"), kind, deck);
    window->show();
  });
}

void DeckWindow::openStudyFile(const std::filesystem::path& file) {
  auto* window = new StudyWindow;
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->show();
  window->openFile(file);
}

void DeckWindow::openStudy() {
  auto* dialog = new QFileDialog(this, tr("Open study"),
                                 QString::fromStdString(document_.path().parent_path().string()),
                                 tr("Studies (*.json *.toml);;All files (*)"));
  dialog->setObjectName("open-study");
  desktop::delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& name) { openStudyFile(name.toStdString()); });
  dialog->open();
}

}  // namespace adore::adrinput

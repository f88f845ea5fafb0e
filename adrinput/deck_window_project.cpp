#include "adrinput/deck_window.hpp"
#include "adrinput/run_panel.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/project.hpp"

#include <QFileDialog>
#include <QInputDialog>

#include <exception>

/// Projects: lists of decks and runs.
namespace adore::adrinput {

void DeckWindow::addToProject() {
  const std::filesystem::path deck = document_.path();
  if (deck.empty()) return desktop::show_message(this, tr("Save the deck first (Ctrl+S)."));
  auto* dialog = new QFileDialog(this, tr("Folder of the project"),
                                 QString::fromStdString(deck.parent_path().string()));
  dialog->setObjectName("project");
  desktop::delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, this, [this, deck](const QString& folder) {
    try {
      desktop::Project project = desktop::Project::open_or_create(folder.toStdString());
      project.add_deck(deck);
      const std::filesystem::path run = runPanel().resultFolder();
      std::error_code none;
      const bool has_run = std::filesystem::exists(run / "RUN.json", none);
      if (has_run) project.add_run(run);
      project.save();
      desktop::show_in_status_bar(this, (has_run ? tr("Added the deck and its run to %1.")
                                                 : tr("Added the deck to %1. It has no run yet."))
                                            .arg(QString::fromStdString(project.file().string())));
    } catch (const std::exception& error) {
      desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  });
  dialog->open();
}

void DeckWindow::askForProject() {
  auto* dialog = new QFileDialog(this, tr("Open project"), {}, desktop::kProjectFile);
  dialog->setObjectName("project");
  desktop::delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& name) {
    QStringList decks;
    std::filesystem::path folder;
    try {
      const desktop::Project project = desktop::Project::open(name.toStdString());
      folder = project.file().parent_path();
      for (const desktop::Project::Entry& deck : project.decks())
        if (!deck.missing) decks << QString::fromStdString(deck.name);
    } catch (const std::exception& error) {
      return desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
    if (decks.isEmpty())
      return desktop::show_message(this,
                                   tr("None of the decks of the project exists on the disk."));
    auto* choice = new QInputDialog(this);
    choice->setObjectName("projectDecks");
    desktop::delete_when_done(*choice);
    choice->setWindowTitle(tr("Deck of the project"));
    choice->setLabelText(tr("Deck:"));
    choice->setComboBoxItems(decks);
    connect(choice, &QInputDialog::textValueSelected, this, [this, folder](const QString& deck) {
      resolveUnsavedChanges([this, folder, deck] { openFile(folder / deck.toStdString()); });
    });
    choice->open();
  });
  dialog->open();
}

}  // namespace adore::adrinput

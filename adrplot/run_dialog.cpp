#include "adrplot/run_dialog.hpp"

#include "desktop/dialogs.hpp"
#include "desktop/listing_view.hpp"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>

#include <exception>

namespace adore::adrplot {

RunDialog::RunDialog(const std::vector<long>& runs, std::function<std::string(long)> about,
                     std::function<std::filesystem::path(long)> files, QWidget* parent)
    : QDialog(parent) {
  setObjectName("runs");
  desktop::delete_when_done(*this);
  setWindowTitle(runs.size() == 1 ? tr("Run %1").arg(runs.front())
                                  : tr("%1 runs").arg(runs.size()));
  resize(760, 460);
  auto* list = new QListWidget(this);
  list->setObjectName("run-list");
  list->setAccessibleName(tr("Runs"));
  list->setMaximumWidth(110);
  for (const long run : runs) list->addItem(QString::number(run));
  list->setVisible(runs.size() > 1);
  auto* text = desktop::make_listing_view(tr("Run details"), this);
  text->setObjectName("run-text");
  auto* both = new QHBoxLayout;
  both->addWidget(list);
  both->addWidget(text, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* open = buttons->addButton(tr("Open plots"), QDialogButtonBox::ActionRole);
  open->setObjectName("open-run");
  open->setToolTip(tr("Open the plots of this run (requires \"keep_files\" in the study)"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(both, 1);
  layout->addWidget(buttons);
  const auto folder_of = [files = std::move(files)](long run) {
    try {
      return files ? files(run) : std::filesystem::path();
    } catch (const std::exception&) {
      return std::filesystem::path();
    }
  };
  connect(list, &QListWidget::currentRowChanged, this,
          [text, open, runs, about = std::move(about), folder_of](int row) {
            if (row < 0) return;
            const long run = runs[static_cast<std::size_t>(row)];
            try {
              text->setPlainText(QString::fromStdString(about(run)));
            } catch (const std::exception& error) {
              text->setPlainText(QString::fromUtf8(error.what()));
            }
            open->setEnabled(!folder_of(run).empty());
          });
  connect(open, &QPushButton::clicked, this, [this, list, runs, folder_of] {
    const auto row = static_cast<std::size_t>(std::max(list->currentRow(), 0));
    emit filesRequested(QString::fromStdString(folder_of(runs[row]).string()));
  });
  list->setCurrentRow(0);
}

}  // namespace adore::adrplot

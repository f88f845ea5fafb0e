#include "adrinput/replace_question.hpp"

#include "adrinput/file_names.hpp"
#include "desktop/dialogs.hpp"

#include <QAbstractButton>
#include <QMessageBox>

#include <utility>

namespace adore::adrinput {

void ask_to_replace(QWidget* parent, const std::filesystem::path& file,
                    std::function<void()> replace) {
  auto* box = new QMessageBox(
      QMessageBox::Warning, "AdrInput",
      QObject::tr(
          "Another program changed %1 after it was opened here. Saving overwrites these changes.")
          .arg(QString::fromStdString(shortened_path(normalized_path(file)))),
      QMessageBox::Save | QMessageBox::Cancel, parent);
  box->setObjectName("changed");
  desktop::delete_when_done(*box);
  box->setDefaultButton(QMessageBox::Cancel);
  QObject::connect(box, &QMessageBox::buttonClicked, parent,
                   [box, replace = std::move(replace)](QAbstractButton* button) {
                     if (box->standardButton(button) == QMessageBox::Save) replace();
                   });
  box->open();
}

}  // namespace adore::adrinput

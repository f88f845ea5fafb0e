#include "adrinput/moving_dialog.hpp"

#include "desktop/dialogs.hpp"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>

namespace adore::adrinput {

MotionAssumptionsDialog::MotionAssumptionsDialog(const std::vector<std::string>& assumptions,
                                                 QWidget* parent)
    : QDialog(parent) {
  setObjectName("moving");
  desktop::delete_when_done(*this);
  setWindowTitle(tr("Make it move"));
  QString html = tr("<p>The deck will simulate motion with these assumptions:</p>") +
                 "<ul style='margin-left:0'>";
  for (const std::string& one : assumptions)
    html += "<li>" + QString::fromStdString(one).toHtmlEscaped() + "</li>";
  html += "</ul>" + tr("<p>You can change all assumptions in the records. Undo with Ctrl+Z.</p>");
  auto* text = new QLabel(html, this);
  text->setObjectName("assumptions");
  text->setTextFormat(Qt::RichText);
  text->setWordWrap(true);
  text->setMinimumWidth(520);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* run = buttons->addButton(tr("Apply and &run"), QDialogButtonBox::AcceptRole);
  QPushButton* apply = buttons->addButton(tr("&Apply to deck"), QDialogButtonBox::AcceptRole);
  run->setObjectName("moving-run");
  apply->setObjectName("moving-apply");
  run->setDefault(true);
  const auto take = [this](bool with_run) {
    accept();
    emit assumptionsAccepted(with_run);
  };
  connect(run, &QPushButton::clicked, this, [take] { take(true); });
  connect(apply, &QPushButton::clicked, this, [take] { take(false); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(text);
  column->addWidget(buttons);
}

}  // namespace adore::adrinput

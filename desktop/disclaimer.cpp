#include "desktop/disclaimer.hpp"

#include "desktop/theme.hpp"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

namespace adore::desktop {

DisclaimerDialog::DisclaimerDialog(const QString& program, QWidget* parent) : QDialog(parent) {
  setWindowTitle(program);
  auto* title = new QLabel(tr("Before you start"), this);
  title->setFont(ui_font(18, true));
  auto* text = new QLabel(
      tr("<p>Adore is free software under the GNU General Public License, version 3 or "
         "later. It comes <b>without any warranty</b>, not even the implied warranty of "
         "fitness for a particular purpose.</p><p>Bearing failures can have serious "
         "consequences. Check every result against experience, tests or a second method "
         "before you rely on it.</p><p>Adore is an <b>independent implementation</b>. "
         "It is not affiliated with or endorsed by the owner of the classic program whose file "
         "formats it reads, and it is not derived from the code of that program.</p>"),
      this);
  text->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(this);
  auto* accept = buttons->addButton(tr("&Accept"), QDialogButtonBox::AcceptRole);
  buttons->addButton(tr("&Decline"), QDialogButtonBox::RejectRole);
  accept->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(24, 20, 24, 18);
  layout->setSpacing(12);
  layout->addWidget(title);
  layout->addWidget(text);
  layout->addWidget(buttons);
  setFixedWidth(520);
}

bool disclaimer_accepted() {
  return QSettings("Adore", "Adore").value("disclaimer/accepted", 0).toInt() >= 1;
}

void remember_disclaimer() { QSettings("Adore", "Adore").setValue("disclaimer/accepted", 1); }

bool ask_for_disclaimer(const QString& program) {
  if (disclaimer_accepted()) return true;
  if (DisclaimerDialog(program).exec() != QDialog::Accepted) return false;
  remember_disclaimer();
  return true;
}

}  // namespace adore::desktop

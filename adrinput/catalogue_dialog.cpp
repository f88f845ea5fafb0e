#include "adrinput/catalogue_dialog.hpp"

#include "base/errors.hpp"
#include "deck/catalogue.hpp"
#include "desktop/dialogs.hpp"

#include <QAbstractItemView>
#include <QBoxLayout>
#include <QCompleter>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QTimer>

#include <algorithm>

namespace adore::adrinput {

CatalogueDialog::CatalogueDialog(QWidget* parent)
    : QDialog(parent), name_(new QLineEdit(this)), story_(new QLabel(this)) {
  setObjectName("catalogue");
  desktop::delete_when_done(*this);
  setWindowTitle(tr("New deck from the catalog"));
  auto* label = new QLabel(tr("&Bearing, e.g. 6205, 7208 B, NU209, 30208 or 22210, or type and "
                              "size, e.g. deep-groove 25x52x15:"),
                           this);
  label->setWordWrap(true);
  label->setBuddy(name_);
  name_->setObjectName("designation");
  name_->setAccessibleName(tr("Bearing designation"));
  QStringList all;
  for (const std::string& designation : deck::catalogue_designations())
    all << QString::fromStdString(designation);
  auto* completer = new QCompleter(all, this);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  name_->setCompleter(completer);
  story_->setObjectName("story");
  story_->setWordWrap(true);
  story_->setTextFormat(Qt::PlainText);
  area_ = new QScrollArea(this);
  area_->setAccessibleName(tr("Description of the bearing"));
  area_->setWidgetResizable(true);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_->setMinimumSize(480, 240);
  area_->setWidget(story_);
  story_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  take_ = buttons->addButton(tr("&Create deck"), QDialogButtonBox::AcceptRole);
  take_->setObjectName("take");
  take_->setDefault(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(label);
  layout->addWidget(name_);
  layout->addWidget(area_, 1);
  layout->addWidget(buttons);
  connect(name_, &QLineEdit::textChanged, this, &CatalogueDialog::look);
  connect(buttons, &QDialogButtonBox::accepted, this, &CatalogueDialog::take);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  look({});
}

QString CatalogueDialog::story() const { return story_->text(); }

void CatalogueDialog::look(const QString& designation) {
  take_->setEnabled(false);
  try {
    const deck::CatalogueBearing found = deck::find_bearing(designation.toStdString());
    QStringList lines;
    for (const std::string& line : deck::catalogue_story(found))
      lines << QString::fromStdString(line);
    story_->setText(lines.join("\n\n"));
    take_->setEnabled(true);
    // The list opens after this, and would hide the description of the bearing and take its Enter.
    QTimer::singleShot(0, this, [list = name_->completer()] { list->popup()->hide(); });
  } catch (const InputError& error) {
    const Issue issue = error.issues().empty() ? Issue{} : error.issues().front();
    QString text = QString::fromStdString(issue.remedy);
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    if (!designation.trimmed().isEmpty())
      text = designation.trimmed() + " " + QString::fromStdString(issue.message) + ". " + text;
    story_->setText(error.issues().empty() ? QString::fromUtf8(error.what()) : text + ".");
  }
  if (isVisible()) makeRoom();
}

/// The description of a bearing ends with unknown values: they must be visible. On a low screen it
/// scrolls.
void CatalogueDialog::makeRoom() {
  const int more = story_->heightForWidth(area_->viewport()->width()) - area_->viewport()->height();
  const QScreen* on = screen();
  constexpr double kShare = 0.9;
  const int most =
      on == nullptr ? height() + more : static_cast<int>(kShare * on->availableGeometry().height());
  if (more > 0 && height() < most) resize(width(), std::min(height() + more, most));
}

void CatalogueDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  makeRoom();
}

void CatalogueDialog::take() {
  const QString text =
      QString::fromStdString(deck::catalogue_deck(deck::find_bearing(name_->text().toStdString())));
  accept();
  emit chosen(text);
}

}  // namespace adore::adrinput

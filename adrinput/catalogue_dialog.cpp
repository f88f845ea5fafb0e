#include "adrinput/catalogue_dialog.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "deck/catalogue.hpp"
#include "desktop/dialogs.hpp"

#include <QAbstractItemView>
#include <QBoxLayout>
#include <QCompleter>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace adore::adrinput {
namespace {

/// Empty: the field is empty. @throws InputError when it is no number
std::optional<double> number_in(const QLineEdit& field) {
  QString text = field.text().trimmed();
  if (text.isEmpty()) return std::nullopt;
  bool ok = false;
  const double value = text.replace(',', '.').toDouble(&ok);
  if (!ok)
    throw InputError(field.accessibleName().toStdString() + " = " + text.toStdString() +
                     ": not a number. Enter a number");
  return value;
}

}  // namespace

QLineEdit* CatalogueDialog::addField(QFormLayout& form, const QString& label, const char* name,
                                     const QString& accessible) {
  auto* field = new QLineEdit(this);
  field->setObjectName(name);
  field->setAccessibleName(accessible);
  field->setMaximumWidth(120);
  form.addRow(label, field);
  connect(field, &QLineEdit::textChanged, this, &CatalogueDialog::updateCandidates);
  return field;
}

CatalogueDialog::CatalogueDialog(QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit(this)),
      candidates_(new QListWidget(this)),
      description_label_(new QLabel(this)) {
  setObjectName("catalogue");
  desktop::delete_when_done(*this);
  setWindowTitle(tr("New deck from the catalog"));
  auto* label =
      new QLabel(tr("&Bearing: designation (6205, 7208 B, NU209, 30208, 22210), type and size "
                    "(deep-groove 25x52x15) or test rig (CWRU-6205-DE):"),
                 this);
  label->setWordWrap(true);
  label->setBuddy(name_);
  name_->setObjectName("designation");
  name_->setAccessibleName(tr("Bearing designation"));
  QStringList all;
  for (const std::string& designation : deck::catalogue_designations())
    all << QString::fromStdString(designation);
  for (const std::string& rig : deck::test_rig_names()) all << QString::fromStdString(rig);
  auto* completer = new QCompleter(all, this);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  name_->setCompleter(completer);
  auto* published = new QFormLayout;
  C_ = addField(*published, tr("Dynamic rating &C [kN]:"), "C", tr("Published dynamic rating"));
  C0_ = addField(*published, tr("Static rating C&0 [kN]:"), "C0", tr("Published static rating"));
  BPFO_ = addField(*published, tr("Frequency factor BP&FO:"), "BPFO",
                   tr("Published fault-frequency factor BPFO"));
  count_ = addField(*published, tr("&Number of elements:"), "count", tr("Number of elements"));
  auto* operating = new QFormLayout;
  radial_ = addField(*operating, tr("&Radial load [N]:"), "radial", tr("Radial load"));
  axial_ = addField(*operating, tr("&Axial load [N]:"), "axial", tr("Axial load"));
  speed_ = addField(*operating, tr("&Speed [rpm]:"), "speed", tr("Speed"));
  temperature_ = addField(*operating, tr("&Temperature [°C]:"), "temperature", tr("Temperature"));
  auto* fields = new QHBoxLayout;
  fields->addLayout(published);
  fields->addLayout(operating);
  candidates_->setObjectName("candidates");
  candidates_->setAccessibleName(tr("Internal geometries that agree with the published values"));
  candidates_->setMaximumHeight(6 * fontMetrics().lineSpacing());
  candidates_->hide();
  description_label_->setObjectName("story");
  description_label_->setWordWrap(true);
  description_label_->setTextFormat(Qt::PlainText);
  scroll_area_ = new QScrollArea(this);
  scroll_area_->setAccessibleName(tr("Description of the bearing"));
  scroll_area_->setWidgetResizable(true);
  scroll_area_->setFrameShape(QFrame::NoFrame);
  scroll_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_area_->setMinimumSize(480, 160);
  scroll_area_->setWidget(description_label_);
  description_label_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  create_button_ = buttons->addButton(tr("Create &deck"), QDialogButtonBox::AcceptRole);
  create_button_->setObjectName("take");
  create_button_->setDefault(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(label);
  layout->addWidget(name_);
  layout->addLayout(fields);
  layout->addWidget(candidates_);
  layout->addWidget(scroll_area_, 1);
  layout->addWidget(buttons);
  connect(name_, &QLineEdit::textChanged, this, &CatalogueDialog::updateCandidates);
  connect(candidates_, &QListWidget::currentRowChanged, this, &CatalogueDialog::showBearing);
  connect(buttons, &QDialogButtonBox::accepted, this, &CatalogueDialog::createDeck);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  updateCandidates();
}

QString CatalogueDialog::descriptionText() const { return description_label_->text(); }

std::optional<design::BearingFacts> CatalogueDialog::publishedFacts() const {
  constexpr double kKilonewton = 1e3;
  design::BearingFacts out;
  out.C = number_in(*C_);
  out.C0 = number_in(*C0_);
  out.BPFO = number_in(*BPFO_);
  const std::optional<double> count = number_in(*count_);
  if (!out.C && !out.C0 && !out.BPFO && !count) return std::nullopt;
  constexpr double kMaxElements = 400.0;
  for (const auto& value : {out.C, out.C0, out.BPFO, count})
    if (value && !(*value > 0.0))
      throw InputError("published values must be above 0. Enter a positive number");
  if (count && (*count > kMaxElements || *count != std::floor(*count)))
    throw InputError("the number of elements must be an integer from 1 to 400");
  if (count) out.count = static_cast<int>(*count);
  if (out.C) *out.C *= kKilonewton;
  if (out.C0) *out.C0 *= kKilonewton;
  const deck::CatalogueBearing named = deck::find_bearing(name_->text().toStdString());
  if (named.standard) {
    out.designation = name_->text().toStdString();
  } else {
    out.type = deck::bearing_type_keyword(named.type);
    out.bore = named.envelope.bore;
    out.outside = named.envelope.outside;
    out.width = named.envelope.width;
    out.contact_angle = named.angle;
  }
  return out;
}

runs::OperatingPoint CatalogueDialog::operatingPoint() const {
  runs::OperatingPoint out;
  out.radial = number_in(*radial_);
  out.axial = number_in(*axial_);
  out.speed = number_in(*speed_);
  out.temperature = number_in(*temperature_);
  return out;
}

void CatalogueDialog::updateCandidates() {
  create_button_->setEnabled(false);
  report_.reset();
  try {
    (void)operatingPoint();
    const std::optional<design::BearingFacts> given = publishedFacts();
    if (given) report_ = design::find_candidates(*given);
    showCandidates();
    showBearing();
    // The list opens after this, and would hide the description of the bearing and take its Enter.
    QTimer::singleShot(0, this, [list = name_->completer()] { list->popup()->hide(); });
  } catch (const InputError& error) {
    showCandidates();
    showError(name_->text(), error);
  }
  if (isVisible()) growToFitDescription();
}

void CatalogueDialog::showCandidates() {
  const QSignalBlocker quiet(candidates_);
  candidates_->clear();
  if (report_)
    for (const design::BearingCandidate& one : report_->candidates) {
      const QString length =
          one.length > 0.0 ? tr(", length %1 mm").arg(one.length * 1e3, 0, 'g', 3) : QString();
      candidates_->addItem(tr("%1 of %2 mm%3, BPFO %4, BPFI %5 (weight %6 %)")
                               .arg(QString::fromStdString(counted(one.count, "element")))
                               .arg(one.diameter * 1e3, 0, 'f', 3)
                               .arg(length)
                               .arg(one.BPFO, 0, 'f', 4)
                               .arg(one.BPFI, 0, 'f', 4)
                               .arg(100.0 * one.weight, 0, 'f', 0));
    }
  candidates_->setVisible(candidates_->count() > 0);
  candidates_->setCurrentRow(0);
}

void CatalogueDialog::showBearing() {
  QStringList lines;
  deck::CatalogueBearing found;
  if (report_ && report_->candidates.empty()) {
    description_label_->setText(QString::fromStdString(design::candidates_text(*report_)));
    return;
  }
  if (report_) {
    found = design::candidate_bearing(*report_, std::max(candidates_->currentRow(), 0) + 1);
    if (!report_->decisive.empty()) lines << QString::fromStdString(report_->decisive);
  } else {
    found = deck::find_bearing(name_->text().toStdString());
  }
  for (const std::string& line : deck::describe_catalogue_bearing(found))
    lines << QString::fromStdString(line);
  description_label_->setText(lines.join("\n\n"));
  create_button_->setEnabled(true);
}

void CatalogueDialog::showError(const QString& designation, const InputError& error) {
  const Issue issue = error.issues().empty() ? Issue{} : error.issues().front();
  QString text = QString::fromStdString(issue.remedy);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  if (!designation.trimmed().isEmpty())
    text = designation.trimmed() + " " + QString::fromStdString(issue.message) + ". " + text;
  description_label_->setText(error.issues().empty() ? QString::fromUtf8(error.what())
                                                     : text + ".");
}

/// The description of a bearing ends with unknown values: they must be visible. On a low screen it
/// scrolls.
void CatalogueDialog::growToFitDescription() {
  layout()->activate();
  const int more = description_label_->heightForWidth(scroll_area_->viewport()->width()) -
                   scroll_area_->viewport()->height();
  const QScreen* on = screen();
  constexpr double kShare = 0.9;
  const int most =
      on == nullptr ? height() + more : static_cast<int>(kShare * on->availableGeometry().height());
  if (more > 0 && height() < most) resize(width(), std::min(height() + more, most));
}

void CatalogueDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  growToFitDescription();
}

void CatalogueDialog::createDeck() {
  try {
    const deck::CatalogueBearing bearing =
        report_ ? design::candidate_bearing(*report_, std::max(candidates_->currentRow(), 0) + 1)
                : deck::find_bearing(name_->text().toStdString());
    const QString text = QString::fromStdString(
        runs::with_operating_point(deck::catalogue_deck(bearing), operatingPoint()));
    accept();
    emit deckCreated(text);
  } catch (const InputError& error) {
    description_label_->setText(QString::fromUtf8(error.what()));
  }
}

}  // namespace adore::adrinput

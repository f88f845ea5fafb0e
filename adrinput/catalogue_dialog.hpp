#pragma once

#include "design/bearing_candidates.hpp"
#include "runs/operating_point.hpp"

#include <QDialog>

#include <optional>

class QFormLayout;
class QLabel;
class QListWidget;
class QScrollArea;
class QLineEdit;
class QPushButton;

namespace adore::adrinput {

/// Creates a deck from 6205, 7208 B, NU209, 30208, 22210 or a public test rig. With published
/// ratings, fault-frequency factors or a number of elements it lists the internal geometries that
/// agree with them. The dialog shows standard and estimated values before the deck is created.
class CatalogueDialog : public QDialog {
  Q_OBJECT
 public:
  explicit CatalogueDialog(QWidget* parent = nullptr);
  [[nodiscard]] QString descriptionText() const;

 signals:
  /// The text of the deck.
  void deckCreated(const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QLineEdit* addField(QFormLayout& form, const QString& label, const char* name,
                      const QString& accessible);
  void updateCandidates();
  /// Empty: no field of published facts has a value. @throws InputError for a field without a
  /// number
  [[nodiscard]] std::optional<design::BearingFacts> publishedFacts() const;
  [[nodiscard]] runs::OperatingPoint operatingPoint() const;
  void showCandidates();
  void showBearing();
  void showError(const QString& designation, const InputError& error);
  void growToFitDescription();
  void createDeck();

  QLineEdit *name_, *C_, *C0_, *BPFO_, *count_, *radial_, *axial_, *speed_, *temperature_;
  QListWidget* candidates_;
  QLabel* description_label_;
  QScrollArea* scroll_area_ = nullptr;
  QPushButton* create_button_;
  std::optional<design::CandidateReport> report_;  ///< of published facts
};

}  // namespace adore::adrinput

#pragma once

#include "adrinput/document.hpp"
#include "deck/difference.hpp"

#include <QDialog>

class QCheckBox;
class QLabel;
class QListWidget;

namespace adore::adrinput {

/// Differences between the deck in the window and another one. Stays open next to the form and
/// follows every change; a row leads to its field.
class CompareDialog : public QDialog {
  Q_OBJECT
 public:
  /// `name`: name of the other deck in sentences: "the saved file".
  CompareDialog(const Document& document, deck::Deck other, const QString& name,
                QWidget* parent = nullptr);

  void sync();
  [[nodiscard]] const std::vector<deck::Difference>& shown() const { return differences_; }

 signals:
  void cellChosen(const adore::adrinput::Cell& cell);

 private:
  void choose(int row);

  const Document& document_;
  deck::Deck other_deck_;
  QString other_deck_name_;
  QLabel* summary_;
  QCheckBox* include_labels_box_;
  QListWidget* list_;
  std::vector<deck::Difference> differences_;
};

}  // namespace adore::adrinput

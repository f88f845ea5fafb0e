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
  [[nodiscard]] const std::vector<deck::Difference>& shown() const { return rows_; }

 signals:
  void chosen(const adore::adrinput::Cell& cell);

 private:
  void choose(int row);

  const Document& document_;
  deck::Deck other_;
  QString name_;
  QLabel* summary_;
  QCheckBox* labels_;
  QListWidget* list_;
  std::vector<deck::Difference> rows_;
};

}  // namespace adore::adrinput

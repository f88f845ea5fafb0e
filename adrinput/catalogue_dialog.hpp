#pragma once

#include <QDialog>

class QLabel;
class QScrollArea;
class QLineEdit;
class QPushButton;

namespace adore::adrinput {

/// Creates a deck from 6205, 7208 B, NU209, 30208 or 22210. The dialog shows standard and estimated
/// values before the deck is created.
class CatalogueDialog : public QDialog {
  Q_OBJECT
 public:
  explicit CatalogueDialog(QWidget* parent = nullptr);
  [[nodiscard]] QString story() const;

 signals:
  /// The text of the deck.
  void chosen(const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void look(const QString& designation);
  void makeRoom();
  void take();

  QLineEdit* name_;
  QLabel* story_;
  QScrollArea* area_ = nullptr;
  QPushButton* take_;
};

}  // namespace adore::adrinput

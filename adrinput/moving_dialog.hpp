#pragma once

#include <QDialog>

#include <string>
#include <vector>

namespace adore::adrinput {

/// Assumptions of a deck of motion, before it replaces the deck.
class MovingDialog : public QDialog {
  Q_OBJECT
 public:
  explicit MovingDialog(const std::vector<std::string>& assumptions, QWidget* parent = nullptr);

 signals:
  /// `run`: save and run it at once.
  void chosen(bool run);
};

}  // namespace adore::adrinput

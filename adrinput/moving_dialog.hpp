#pragma once

#include <QDialog>

#include <string>
#include <vector>

namespace adore::adrinput {

/// Assumptions of a deck of motion, before it replaces the deck.
class MotionAssumptionsDialog : public QDialog {
  Q_OBJECT
 public:
  explicit MotionAssumptionsDialog(const std::vector<std::string>& assumptions,
                                   QWidget* parent = nullptr);

 signals:
  /// `run`: save and run it at once.
  void assumptionsAccepted(bool run);
};

}  // namespace adore::adrinput

#pragma once

#include "adrinput/background.hpp"
#include "adrinput/document.hpp"
#include "design/find.hpp"

#include <QDialog>

#include <optional>
#include <string>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
namespace adore::desktop {
class ChartView;
}  // namespace adore::desktop

namespace adore::adrinput {

/// Inverse calculation on the deck in the window (design/find.hpp): question or unknown and target,
/// the answer in sentences, the target over the unknown as a curve, and a button that sets a
/// solution in the deck. Stays open next to the form. Values are in the units of the deck.
class FindDialog : public QDialog {
  Q_OBJECT
 public:
  explicit FindDialog(Document& document, QWidget* parent = nullptr);

  /// The deck has changed: the answer is marked as out of date.
  void sync();
  [[nodiscard]] const std::optional<FindReport>& report() const { return report_; }
  [[nodiscard]] bool busy() const { return background_task_.busy(); }

 public slots:
  void find();

 signals:
  void finished();
  /// A solution was set in the deck.
  void solutionApplied();

 private:
  void chooseQuestion(int row);
  void showUnits();
  void proposeBounds();
  void showOutcome(const QString& failure);
  void showAnswer();
  void enableButtons();
  void apply();

  Document& document_;
  QComboBox *question_, *unknown_, *target_, *relation_, *solution_;
  QLineEdit *first_, *last_, *target_value_field_;
  QLabel *unknown_unit_, *target_unit_, *answer_;
  QPushButton *find_, *cancel_, *apply_;
  desktop::ChartView* chart_;
  BackgroundTask background_task_;
  std::vector<std::pair<std::string, std::string>>
      question_settings_;  ///< of the question that was asked
  std::optional<FindReport> report_;
  QString answer_text_;  ///< of the answer
  deck::Deck answer_deck_;
};

}  // namespace adore::adrinput

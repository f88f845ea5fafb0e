#pragma once

#include "adrinput/document.hpp"

#include <QWidget>

namespace adore::desktop {
class ChartView;
}
class QPushButton;

namespace adore::adrinput {

class DesignResultsPanel;
class DesignForm;
class DesignSolver;
class DrawingView;

/// Key of the page among the records; no record has this id.
inline constexpr const char* kDesignPage = "design";

/// Front page: inputs at the left, results in the middle, section drawing and load distribution at
/// the right. It shows the deck that the record forms show.
class DesignPage : public QWidget {
  Q_OBJECT
 public:
  explicit DesignPage(Document& document, QWidget* parent = nullptr);
  ~DesignPage() override;

  /// The document has changed.
  void sync();
  [[nodiscard]] DesignForm& form() { return *form_; }
  [[nodiscard]] DesignResultsPanel& resultsPanel() { return *results_panel_; }
  /// Is a result on its way?
  [[nodiscard]] bool computing() const;
  void restyle();

 signals:
  void catalogRequested();
  void recordsRequested();
  /// The deck has become one of motion; `run`: it shall run.
  void convertedToDynamicDeck(bool run);
  void findingChosen(const adore::Finding& finding);

 public slots:
  /// Shows the assumptions of a deck of motion (a dialog named "moving"), then writes it.
  void convertToDynamicDeck();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void compute();
  void draw();
  void showFindings();

  Document& document_;
  DesignForm* form_;
  DesignResultsPanel* results_panel_;
  DrawingView* drawing_;
  desktop::ChartView* load_chart_;
  DesignSolver* solver_;
  deck::Deck drawn_deck_;
};

}  // namespace adore::adrinput

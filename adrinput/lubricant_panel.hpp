#pragma once

#include "deck/deck.hpp"

#include <QWidget>

class QComboBox;
class QLabel;
class QMainWindow;
class QTimer;
namespace adore::desktop {
class ChartView;
}  // namespace adore::desktop

namespace adore::adrinput {

/// Charts of the deck's lubricant (record 10.0) at the deck's temperatures, roughness and records
/// 10.1 and 10.3: traction over slip, viscosity over pressure, film and lambda over speed. Not
/// drawn while hidden.
class LubricantPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LubricantPanel(QWidget* parent = nullptr);
  /// In a dock of `window`, closed at first.
  static LubricantPanel* createInDock(QMainWindow* window);

  /// Draws after a short pause in typing.
  void setDeck(const deck::Deck& deck);
  /// Draws the last deck, without the pause.
  void drawNow();
  [[nodiscard]] desktop::ChartView& chart() { return *chart_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void showPage();

  deck::Deck deck_;
  QComboBox* page_box_ = nullptr;
  desktop::ChartView* chart_ = nullptr;
  QLabel* conditions_ = nullptr;
  QTimer* delay_timer_ = nullptr;
};

}  // namespace adore::adrinput

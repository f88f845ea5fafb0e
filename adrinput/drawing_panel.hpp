#pragma once

#include "adrinput/drawing_view.hpp"

#include <QWidget>

#include <functional>
#include <map>
#include <optional>
#include <string>

class QComboBox;
class QTimer;

namespace adore::adrinput {

/// The live drawing next to the form: follows the field in focus to the view that shows it, and
/// keeps the last valid drawing, pale and with the reason, while the deck cannot be drawn.
class DrawingPanel : public QWidget {
  Q_OBJECT
 public:
  explicit DrawingPanel(QWidget* parent = nullptr);

  /// Draws after a short pause in typing.
  /// Name of a field in a figure; without it number and unit of the deck. Empty: default.
  std::function<QString(const std::string& variable, int instance, int index)> wording;
  /// Updates all names, in the units now displayed.
  void updateNames() { drawNow(); }
  void setDeck(const deck::Deck& deck);
  /// Shows the view that the field belongs to, unless the user chose another one for it.
  void setFocusOn(DrawingFocus focus);
  void chooseView(drawing::View view);
  /// The view that is shown.
  [[nodiscard]] drawing::View view() const;
  [[nodiscard]] DrawingView& drawingView() { return *drawing_view_; }
  /// Draws the last deck, without the pause.
  void drawNow();

 signals:
  void fieldRequested(const QString& variable, int instance, int index);

 private:
  void fillViews();
  void label();
  [[nodiscard]] std::string displayLabel(const std::string& label, const std::string& variable,
                                         int instance, int index) const;

  deck::Deck deck_;
  drawing::View preferred_view_ = drawing::View::CrossSection;  ///< of the field in focus
  std::optional<drawing::View> chosen_view_;  ///< by hand, for as long as preferred_view_ stays
  std::map<drawing::View, drawing::Drawing>
      last_valid_drawings_;           ///< the last that could be drawn, by view
  long long drawn_bearing_type_ = 0;  ///< of bearing, of `last_valid_drawings_`
  QComboBox* view_box_ = nullptr;
  DrawingView* drawing_view_ = nullptr;
  QTimer* delay_timer_ = nullptr;
};

}  // namespace adore::adrinput

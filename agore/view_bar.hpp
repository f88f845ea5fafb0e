#pragma once

#include "agore/view_options.hpp"

#include <QToolBar>

#include <map>

class QToolButton;

namespace adore::agore {

/// One button for each view above the picture; views that the file cannot show are disabled, with
/// the reason as tooltip. Switches of the window follow at the right.
class ViewBar : public QToolBar {
  Q_OBJECT
 public:
  explicit ViewBar(QWidget* parent = nullptr);
  /// A checkable action, as a button at the right.
  void addSwitch(QAction* action, const QString& text);
  /// @param animation null: no file is open
  void sync(View view, const Animation* animation);
  [[nodiscard]] QToolButton* button(View view) const { return buttons_.at(view); }

 signals:
  void chosen(adore::agore::View view);

 private:
  std::map<View, QToolButton*> buttons_;
};

}  // namespace adore::agore

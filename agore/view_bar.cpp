#include "agore/view_bar.hpp"

#include <QAction>
#include <QToolButton>

#include <array>

namespace adore::agore {
namespace {

struct Choice {
  View view;
  const char *text, *key;
};
constexpr std::array<Choice, 10> kChoices{{{View::Bearing, "Bearing", "1"},
                                           {View::Cage, "Cage", "2"},
                                           {View::Pocket, "Pocket", "3"},
                                           {View::Element, "Element", "4"},
                                           {View::OuterRace, "Outer race", "5"},
                                           {View::InnerRace, "Inner race", "6"},
                                           {View::Flange, "Flange", "7"},
                                           {View::Section, "Section", "8"},
                                           {View::Solid, "3D", "9"},
                                           {View::Raceways, "Raceways", "Ctrl+8"}}};

}  // namespace

ViewBar::ViewBar(QWidget* parent) : QToolBar(parent) {
  setObjectName("viewBar");
  setWindowTitle(tr("View bar"));
  setMovable(false);
  setFloatable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  for (const Choice& choice : kChoices) {
    auto* button = new QToolButton(this);
    button->setObjectName(QString("view-%1").arg(QString::fromStdString(view_name(choice.view))));
    button->setText(tr(choice.text));
    button->setAccessibleName(QString::fromStdString(view_title(choice.view)));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::NoFocus);
    connect(button, &QToolButton::clicked, this, [this, view = choice.view] { emit chosen(view); });
    addWidget(button);
    buttons_[choice.view] = button;
  }
  auto* space = new QWidget(this);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  addWidget(space);
}

void ViewBar::addSwitch(QAction* action, const QString& text) {
  auto* button = new QToolButton(this);
  button->setObjectName("switch-" + action->objectName());
  button->setFocusPolicy(Qt::NoFocus);
  button->setDefaultAction(action);
  // The menu has the long name.
  button->setText(text);
  connect(action, &QAction::changed, button, [button, text] { button->setText(text); });
  addWidget(button);
}

void ViewBar::sync(View view, const Animation* animation) {
  for (const Choice& choice : kChoices) {
    QToolButton* button = buttons_.at(choice.view);
    const std::string reason =
        animation != nullptr ? why_not(choice.view, *animation) : std::string("No file is open.");
    button->setEnabled(reason.empty());
    button->setChecked(choice.view == view && reason.empty());
    button->setToolTip(reason.empty() ? QString("%1 (%2)").arg(button->accessibleName(), choice.key)
                                      : QString::fromStdString(reason));
  }
}

}  // namespace adore::agore

#include "desktop/dialog_room.hpp"

#include "desktop/window_place.hpp"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>

#include <algorithm>

namespace adore::desktop {
namespace {

constexpr int kBesideText = 140;  // height of a message's buttons, tick box and margins
constexpr int kWidest = 460;      // of a message's text that scrolls
constexpr int kMinRoom = 80;

QSize room_for(const QWidget& window) {
  return size_within(QSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX), window.screen()->availableSize());
}

/// Top of a window whose lower edge is that of the screen.
int foot_of(const QWidget& window) {
  return window.screen()->availableGeometry().bottom() - window.frameGeometry().height();
}

}  // namespace

bool DialogSizeLimiter::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::Show && event->type() != QEvent::Resize) return false;
  auto* dialog = qobject_cast<QDialog*>(object);
  if (dialog == nullptr || !dialog->isWindow() || dialog->screen() == nullptr) return false;
  if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
    // The box determines its size when shown, and is laid out during this event.
    if (event->type() == QEvent::Resize && box->height() > room_for(*box).height())
      QMetaObject::invokeMethod(
          box, [box] { makeTextScrollable(*box); }, Qt::QueuedConnection);
  } else if (event->type() == QEvent::Show) {
    limitToScreen(*dialog);
  } else if (dialog->isVisible()) {
    // One that was unfolded, as that of printers can be: its buttons stay in sight.
    QMetaObject::invokeMethod(
        dialog,
        [dialog] {
          if (dialog->frameGeometry().bottom() > dialog->screen()->availableGeometry().bottom())
            dialog->move(dialog->x(), foot_of(*dialog));
        },
        Qt::QueuedConnection);
  }
  return false;
}

void DialogSizeLimiter::limitToScreen(QDialog& dialog) {
  const QSize within = dialog.size().boundedTo(room_for(dialog));
  if (within != dialog.size()) dialog.resize(within);
}

void DialogSizeLimiter::makeTextScrollable(QMessageBox& box) {
  auto* label = box.findChild<QLabel*>("qt_msgbox_label", Qt::FindDirectChildrenOnly);
  auto* grid = qobject_cast<QGridLayout*>(box.layout());
  if (label == nullptr || grid == nullptr) return;  // it scrolls already
  int row = 0, column = 0, rows = 1, columns = 1;
  grid->getItemPosition(grid->indexOf(label), &row, &column, &rows, &columns);
  auto* area = new QScrollArea(&box);
  area->setObjectName("message-text");
  area->setAccessibleName("Message");
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFixedHeight(std::max(kMinRoom, room_for(box).height() - kBesideText));
  area->setMinimumWidth(kWidest);
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  area->setWidget(label);
  grid->addWidget(area, row, column, rows, columns);
  // It was placed for its height of before.
  QMetaObject::invokeMethod(
      &box,
      [&box] {
        const int top = box.screen()->availableGeometry().top();
        box.move(box.x(), std::max(top, std::min(box.y(), foot_of(box))));
      },
      Qt::QueuedConnection);
}

}  // namespace adore::desktop

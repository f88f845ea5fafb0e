#pragma once

#include <QCoreApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>
#include <QWindow>

/// Files that a file manager drags over a window and lets go there: the window system's events to
/// the window, which finds the widget below the mouse.
namespace adore::test {

/// Enters, moves and drops at a place of a shown window, as a file manager whose key moves files
/// offers it. @return whether it was taken as a copy, which leaves the files where they are
inline bool drop_on(QWidget& window, const QMimeData& data, QPoint place = {9, 9}) {
  constexpr auto kOffered = Qt::MoveAction | Qt::CopyAction;
  QWindow* const handle = window.windowHandle();
  if (handle == nullptr) return false;
  QDragEnterEvent enter(place, kOffered, &data, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QCoreApplication::sendEvent(handle, &enter);
  QDragMoveEvent move(place, kOffered, &data, Qt::LeftButton, Qt::NoModifier);
  move.ignore();
  QCoreApplication::sendEvent(handle, &move);
  if (!move.isAccepted()) {  // the mouse shows that nothing would happen
    QDragLeaveEvent leave;
    QCoreApplication::sendEvent(handle, &leave);
    return false;
  }
  QDropEvent drop(QPointF(place), kOffered, &data, Qt::LeftButton, Qt::ShiftModifier);
  drop.setDropAction(Qt::MoveAction);
  drop.ignore();
  QCoreApplication::sendEvent(handle, &drop);
  return drop.isAccepted() && drop.dropAction() == Qt::CopyAction;
}

inline bool drop_on(QWidget& window, const QString& folder, const QStringList& names,
                    QPoint place = {9, 9}) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& name : names) urls << QUrl::fromLocalFile(QDir(folder).filePath(name));
  data.setUrls(urls);
  data.setText(urls.isEmpty() ? QString() : urls.front().toLocalFile());  // as file managers do
  return drop_on(window, data, place);
}

/// Places all over a window.
inline QList<QPoint> places_of(const QWidget& window) {
  QList<QPoint> out;
  constexpr int kParts = 8;
  for (int row = 0; row <= kParts; ++row)
    for (int column = 0; column <= kParts; ++column)
      out << QPoint(2 + column * (window.width() - 4) / kParts,
                    2 + row * (window.height() - 4) / kParts);
  return out;
}

}  // namespace adore::test

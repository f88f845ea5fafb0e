#pragma once

#include <QStringList>

#include <functional>

class QWidget;

namespace adore::desktop {

/// Local files that are dropped anywhere on a window are passed to `opened`. Charts, fields and
/// texts in it would take them first: a scene accepts every drag and ignores the drop, a field
/// takes the file name as text. Everything else, such as web links, goes to the fields as usual.
/// Files are copied as far as their owner knows, never moved: a move would delete them. Docks of
/// the window also accept them while they float.
void accept_file_drops(QWidget& window, std::function<void(const QStringList& files)> opened);

}  // namespace adore::desktop

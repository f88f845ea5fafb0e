#pragma once

#include <QStringList>

#include <functional>

class QWidget;

namespace adore::desktop {

/// Local files that are dropped anywhere on a window are handed to `opened`. Charts, fields and
/// texts in it would take them first: a scene takes every drag and drops it on nothing, a field
/// takes a file's name as text. Everything else, as a link of the web, goes to the fields as ever.
/// Files are copied as far as their owner knows, never moved: one that moves deletes them. Docks
/// that the window has when it is shown take them also while they float.
void take_files_anywhere(QWidget& window, std::function<void(const QStringList& files)> opened);

}  // namespace adore::desktop

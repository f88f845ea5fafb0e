#pragma once

class QWidget;

namespace adore::desktop {

/// Files that are dropped anywhere on a window reach its own dragEnterEvent and dropEvent. Charts,
/// fields and texts in it would take them first: a scene takes every drag and drops it on nothing,
/// a field takes a file's name as text.
void take_files_anywhere(QWidget& window);

}  // namespace adore::desktop

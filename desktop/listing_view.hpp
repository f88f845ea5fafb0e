#pragma once

class QPlainTextEdit;
class QString;
class QWidget;

namespace adore::desktop {

/// A view of a listing as PRINT.txt is: fixed pitch, lines unbroken, read only; Tab leaves it.
/// `name` is what a screen reader calls it.
QPlainTextEdit* make_listing_view(const QString& name, QWidget* parent);

}  // namespace adore::desktop

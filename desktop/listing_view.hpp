#pragma once

class QPlainTextEdit;
class QString;
class QWidget;

namespace adore::desktop {

/// A view of a listing such as PRINT.txt: fixed pitch, lines unbroken, read only; Tab leaves it.
/// `name`: accessible name.
QPlainTextEdit* make_listing_view(const QString& name, QWidget* parent);

}  // namespace adore::desktop

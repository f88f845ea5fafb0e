#pragma once

class QPlainTextEdit;
class QWidget;

namespace adore::desktop {

/// A view of a listing as PRINT.txt is: fixed pitch, lines unbroken, read only; Tab leaves it.
QPlainTextEdit* make_listing_view(QWidget* parent);

}  // namespace adore::desktop

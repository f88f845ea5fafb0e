#pragma once

class QComboBox;
class QString;

namespace adore::desktop {

/// Accessible name of a combo box. If the name of boxes is their current text (Qt on Linux takes
/// the name only from a label), the description contains it, too.
void set_accessible_name(QComboBox& box, const QString& name);

}  // namespace adore::desktop

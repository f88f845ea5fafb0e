#pragma once

class QComboBox;
class QString;

namespace adore::desktop {

/// What a screen reader calls a box of choices. Where names of boxes are their present text (Qt on
/// Linux tells the name by a label alone), the description says it, too.
void name_box(QComboBox& box, const QString& name);

}  // namespace adore::desktop

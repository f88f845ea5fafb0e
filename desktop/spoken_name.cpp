#include "desktop/spoken_name.hpp"

#include <QComboBox>

namespace adore::desktop {

void name_box(QComboBox& box, const QString& name) {
  box.setAccessibleName(name);
  box.setAccessibleDescription(name);
}

}  // namespace adore::desktop

#include "desktop/spoken_name.hpp"

#include <QComboBox>

namespace adore::desktop {

void set_accessible_name(QComboBox& box, const QString& name) {
  box.setAccessibleName(name);
  box.setAccessibleDescription(name);
}

}  // namespace adore::desktop

#include "desktop/listing_view.hpp"

#include <QFontDatabase>
#include <QPlainTextEdit>

namespace adore::desktop {

QPlainTextEdit* make_listing_view(const QString& name, QWidget* parent) {
  auto* view = new QPlainTextEdit(parent);
  view->setAccessibleName(name);
  view->setReadOnly(true);
  view->setLineWrapMode(QPlainTextEdit::NoWrap);
  view->setTabChangesFocus(true);
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setFamily("DejaVu Sans Mono");
  font.setStyleHint(QFont::Monospace);
  font.setPixelSize(12);
  view->setFont(font);
  return view;
}

}  // namespace adore::desktop

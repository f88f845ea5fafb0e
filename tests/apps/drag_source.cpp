#include <QApplication>
#include <QDrag>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QUrl>

/// A file manager of one icon: dragging it drags the files that were given.
namespace {

class Icon : public QLabel {
 public:
  using QLabel::QLabel;
  void mousePressEvent(QMouseEvent* event) override { event->accept(); }
  void mouseMoveEvent(QMouseEvent*) override {
    auto* dragged = new QMimeData;
    QList<QUrl> urls;
    for (const QString& name : QCoreApplication::arguments().mid(1))
      urls << QUrl::fromLocalFile(name);
    dragged->setUrls(urls);
    auto* drag = new QDrag(this);  // Qt deletes it
    drag->setMimeData(dragged);
    drag->exec(Qt::CopyAction);
  }
};

}  // namespace

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  Icon icon("drag");
  icon.setWindowTitle("drag-source");
  icon.setAlignment(Qt::AlignCenter);
  icon.setGeometry(1100, 560, 150, 120);
  icon.show();
  return QApplication::exec();
}

#include "desktop/dialogs.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "desktop/image_export.hpp"
#include "desktop/pdf_pages.hpp"
#include "desktop/svg_writer.hpp"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QInputDialog>
#include <QMainWindow>
#include <QMessageBox>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>
#include <QScreen>
#include <QScrollBar>
#include <QSettings>
#include <QStatusBar>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <memory>

namespace adore::desktop {

namespace {

constexpr const char* kTexts = "texts";  ///< of a box of show_message()

/// Messages one under the other, the last ones counted.
QString shown(const QStringList& texts) {
  constexpr qsizetype kMost = 8;
  QString out = texts.mid(0, kMost).join("\n\n");
  if (texts.size() > kMost)
    out += "\n\n" + QObject::tr("And %1.").arg(
                        QString::fromStdString(counted(texts.size() - kMost, "more message")));
  return out;
}

/// The existing message box of a window: keys would not reach the upper one of two.
bool join_message(QWidget* parent, const QString& text, bool error) {
  for (auto* box : parent->findChildren<QMessageBox*>("message", Qt::FindDirectChildrenOnly)) {
    QStringList texts = box->property(kTexts).toStringList();
    if (texts.isEmpty() || !box->isVisible()) continue;
    if (!texts.contains(text)) texts << text;
    box->setProperty(kTexts, texts);
    box->setText(shown(texts));
    if (error) box->setIcon(QMessageBox::Warning);
    return true;
  }
  return false;
}

}  // namespace

void delete_when_done(QDialog& dialog) {
  QObject::connect(&dialog, &QDialog::finished, &dialog, &QObject::deleteLater);
}

void show_message(QWidget* parent, const QString& text, bool error) {
  if (join_message(parent, text, error)) return;
  auto* box =
      new QMessageBox(error ? QMessageBox::Warning : QMessageBox::Information,
                      parent->windowTitle().section(" — ", -1), text, QMessageBox::Ok, parent);
  box->setObjectName("message");
  box->setProperty(kTexts, QStringList{text});
  box->setTextFormat(Qt::PlainText);
  delete_when_done(*box);
  box->open();
}

void show_help(QWidget* parent, const QString& title, const QString& html) {
  constexpr int kWidest = 44;                        // of a line [heights of a letter]
  constexpr QSize kFrame(16, 48), kLeast(240, 160);  // of a window manager
  auto* dialog = new QDialog(parent);
  dialog->setObjectName("help-window");
  delete_when_done(*dialog);
  dialog->setWindowTitle(title);
  auto* browser = new QTextBrowser(dialog);
  browser->setAccessibleName(title);
  browser->setHtml(html);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok, dialog);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  auto* layout = new QVBoxLayout(dialog);
  layout->addWidget(browser, 1);
  layout->addWidget(buttons);

  const QSize screen = (parent->screen()->availableSize() - kFrame).expandedTo(kLeast);
  const QMargins margins = layout->contentsMargins();
  // In addition to the text: frames, and the scroll bar if it does not fit.
  const int beside = margins.left() + margins.right() + 2 * browser->frameWidth() +
                     browser->verticalScrollBar()->sizeHint().width() + 4;
  const int below = margins.top() + margins.bottom() + layout->spacing() +
                    buttons->sizeHint().height() + 2 * browser->frameWidth() + 4;
  QTextDocument text;
  text.setDefaultFont(browser->font());
  text.setHtml(html);
  text.setTextWidth(std::min(screen.width() - beside, kWidest * browser->fontMetrics().height()));
  const QSize wanted(static_cast<int>(text.idealWidth()) + beside,
                     static_cast<int>(text.size().height()) + below);
  dialog->resize(wanted.boundedTo(screen).expandedTo(kLeast));
  dialog->open();
}

void ask_number(QWidget* parent, const QString& title, const QString& label, int value, int low,
                int high, std::function<void(int)> answer) {
  auto* dialog = new QInputDialog(parent);
  dialog->setObjectName("number");
  delete_when_done(*dialog);
  dialog->setWindowTitle(title);
  dialog->setLabelText(label);
  dialog->setInputMode(QInputDialog::IntInput);
  dialog->setIntRange(low, high);
  dialog->setIntValue(value);
  QObject::connect(dialog, &QInputDialog::intValueSelected, parent, std::move(answer));
  dialog->open();
}

void ask_file(QWidget* parent, const QString& app, const QString& title, const QString& names,
              std::function<void(QString)> answer) {
  const QString folder = QSettings("Adore", app).value("open/folder").toString();
  auto* dialog = new QFileDialog(parent, title, folder,
                                 QObject::tr("Result files (%1);;All files (*)").arg(names));
  dialog->setObjectName("open");
  delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::ExistingFile);
  QObject::connect(
      dialog, &QFileDialog::fileSelected, parent,
      [app, answer = std::move(answer)](const QString& name) {
        QSettings("Adore", app).setValue("open/folder", QFileInfo(name).absolutePath());
        answer(name);
      },
      Qt::QueuedConnection);
  dialog->open();
}

void ask_files(QWidget* parent, const QString& app, const QString& title, const QString& names,
               std::function<void(QStringList)> answer) {
  const QString folder = QSettings("Adore", app).value("open/folder").toString();
  auto* dialog = new QFileDialog(parent, title, folder,
                                 QObject::tr("Result files (%1);;All files (*)").arg(names));
  dialog->setObjectName("open");
  delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  QObject::connect(
      dialog, &QFileDialog::filesSelected, parent,
      [app, answer = std::move(answer)](const QStringList& chosen) {
        if (chosen.isEmpty()) return;
        QSettings("Adore", app).setValue("open/folder", QFileInfo(chosen.front()).absolutePath());
        answer(chosen);
      },
      Qt::QueuedConnection);
  dialog->open();
}

void show_in_status_bar(QWidget* window, const QString& text) {
  constexpr int kTold = 6000;  // [ms]
  auto* main = qobject_cast<QMainWindow*>(window);
  if (main != nullptr && main->findChild<QStatusBar*>() != nullptr)
    main->statusBar()->showMessage(text, kTold);
}

void save_picture(QWidget* parent, const QString& app, const QString& fallback,
                  std::function<QImage()> picture, QSizeF size,
                  std::function<void(QPainter&)> draw) {
  auto* dialog = new QFileDialog(parent, QObject::tr("Save picture"), QString(),
                                 QObject::tr("Pictures (*.jpg *.jpeg *.png *.svg *.pdf)"));
  dialog->setObjectName("save");
  delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("jpg");
  dialog->selectFile(proposed_image_name(app, fallback));
  const auto save = [picture = std::move(picture), size,
                     draw = std::move(draw)](const QString& name) {
    const QString suffix = QFileInfo(name).suffix().toLower();
    if (suffix == "svg") return save_bytes(render_svg(size, draw), name.toStdString());
    if (suffix == "pdf") return save_bytes(render_pdf(size, draw), name.toStdString());
    if (suffix != "png" && suffix != "jpg" && suffix != "jpeg")
      throw InputError("a picture cannot be saved as " + name.toStdString() +
                       "; give a name that ends in .png, .jpg, .svg or .pdf");
    save_image(picture(), name.toStdString(), Replace::Anything);
  };
  QObject::connect(dialog, &QFileDialog::fileSelected, parent,
                   [parent, app, fallback, save](const QString& name) {
                     try {
                       save(name);
                       remember_image_name(app, fallback, name);
                       show_in_status_bar(parent, QObject::tr("Saved %1.").arg(name));
                     } catch (const std::exception& error) {
                       show_message(parent, error.what(), true);
                     }
                   });
  dialog->open();
}

void print_page(QWidget* parent, std::function<void(QPainter&, const QRectF&)> draw) {
  auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
  printer->setPageOrientation(QPageLayout::Landscape);
  auto* dialog = new QPrintDialog(printer.get(), parent);
  dialog->setObjectName("print");
  delete_when_done(*dialog);
  QObject::connect(dialog, qOverload<QPrinter*>(&QPrintDialog::accepted), parent,
                   [printer, draw = std::move(draw)](QPrinter*) {
                     QPainter painter(printer.get());
                     draw(painter, QRectF(painter.viewport()));
                   });
  dialog->open();
}

}  // namespace adore::desktop

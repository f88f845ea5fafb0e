#pragma once

#include <QSizeF>
#include <QString>
#include <QStringList>

#include <functional>

class QDialog;
class QImage;
class QPainter;
class QRectF;
class QWidget;

/// Small dialogs of both viewers. None of them blocks: the answer is passed to the given function.
/// A file is read after its dialog has closed.
namespace adore::desktop {

/// Deletes the dialog after all receivers of its answer have run. (Qt::WA_DeleteOnClose deletes it
/// when it closes: before an answer that runs the event loop, such as reading a long file, has
/// returned to the dialog.)
void delete_when_done(QDialog& dialog);

/// A message closed with OK. The box is a child of `parent` named "message"; if one exists already,
/// the text is added to it.
void show_message(QWidget* parent, const QString& text, bool error = false);

/// Rich text in a separate window, a child of `parent` named "help-window": as large as the text if
/// the screen allows, else it scrolls.
void show_help(QWidget* parent, const QString& title, const QString& html);

/// A whole number between `low` and `high`; the dialog is a child of `parent` named "number".
void ask_number(QWidget* parent, const QString& title, const QString& label, int value, int low,
                int high, std::function<void(int)> answer);

/// A result file of one of the names (patterns, blanks between), starting in the folder used last
/// by `app`; the dialog is named "open".
void ask_file(QWidget* parent, const QString& app, const QString& title, const QString& names,
              std::function<void(QString)> answer);

/// The same for several files at once.
void ask_files(QWidget* parent, const QString& app, const QString& title, const QString& names,
               std::function<void(QStringList)> answer);

/// Shows a result for some seconds in the status bar of a window, if it has one.
void show_in_status_bar(QWidget* window, const QString& text);

/// Dialog to save a picture: the remembered name with a running number, free to edit; then saves it
/// and reports failure by message. By `draw`, at `size`, also lines and text: SVG or PDF.
void save_picture(QWidget* parent, const QString& app, const QString& fallback,
                  std::function<QImage()> picture, QSizeF size,
                  std::function<void(QPainter&)> draw);

/// Printer selection, then one page of lines and text: `draw` gets the paper in the printer's dots.
void print_page(QWidget* parent, std::function<void(QPainter&, const QRectF&)> draw);

}  // namespace adore::desktop

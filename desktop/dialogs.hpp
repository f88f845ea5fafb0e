#pragma once

#include <QString>

#include <functional>

class QWidget;
class QImage;

/// The small questions that both viewers ask. None of them blocks: the answer arrives in the
/// function given.
namespace adore::desktop {

/// A message closed with OK. The box is a child of `parent` named "message".
void show_message(QWidget* parent, const QString& text, bool error = false);

/// A whole number between `low` and `high`; the dialog is a child of `parent` named "number".
void ask_number(QWidget* parent, const QString& title, const QString& label, int value, int low,
                int high, std::function<void(int)> answer);

/// A result file of one of the names (patterns, blanks between), starting in the folder used last
/// by `app`; the dialog is named "open".
void ask_file(QWidget* parent, const QString& app, const QString& title, const QString& names,
              std::function<void(QString)> answer);

/// Where to save a picture: the remembered name with a running number, free to edit; then saves it
/// and reports failure by message.
void save_picture(QWidget* parent, const QString& app, const QString& fallback,
                  std::function<QImage()> picture);

/// Printer selection, then one page.
void print_picture(QWidget* parent, std::function<QImage()> picture);

}  // namespace adore::desktop

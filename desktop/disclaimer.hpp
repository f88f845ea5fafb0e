#pragma once

#include <QDialog>

namespace adore::desktop {

/// Accepted once by the user: no warranty (GPL), and an independent implementation.
class DisclaimerDialog : public QDialog {
  Q_OBJECT
 public:
  explicit DisclaimerDialog(const QString& program, QWidget* parent = nullptr);
};

/// Already accepted on this account? The answer is shared by all apps.
bool disclaimer_accepted();
void remember_disclaimer();

/// Shows the dialog unless it was accepted before. False: the user declined, the program should
/// end.
bool ask_for_disclaimer(const QString& program);

}  // namespace adore::desktop

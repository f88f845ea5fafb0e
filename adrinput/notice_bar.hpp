#pragma once

#include <QWidget>

#include <functional>
#include <vector>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace adore::adrinput {

/// A message above the form with buttons to answer it. It does not block; it stays until it is
/// answered or obsolete.
class NoticeBar : public QWidget {
  Q_OBJECT
 public:
  struct Answer {
    QString name;  ///< object name of the button
    QString text;
    std::function<void()> act;
  };
  explicit NoticeBar(const QString& name, QWidget* parent = nullptr);

  /// Shows it; the bar is hidden before an answer acts.
  void ask(const QString& text, std::vector<Answer> answers);
  [[nodiscard]] QString text() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QBoxLayout* buttons_;
  QLabel* label_;
};

}  // namespace adore::adrinput

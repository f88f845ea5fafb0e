#pragma once

#include "base/finding.hpp"

#include <QIcon>
#include <QImage>
#include <QWidget>

#include <functional>
#include <string>
#include <vector>

class QListWidget;
class QToolButton;

namespace adore::desktop {

/// Findings of a run in one line: their number and the worst. A click opens the list; a click on an
/// entry goes to its field, curve or frame. Hidden without findings.
class FindingsBar : public QWidget {
  Q_OBJECT
 public:
  explicit FindingsBar(QWidget* parent = nullptr);

  void setFindings(std::vector<Finding> findings);
  /// Findings of the page or view come first.
  /// @param name "This page": begins the line if one of them is a warning
  void setCurrentPage(std::function<bool(const Finding&)> concerns, const QString& name);
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  [[nodiscard]] QString line() const { return line_; }
  [[nodiscard]] QListWidget& list() { return *list_; }

 public slots:
  void openList();

 signals:
  void chosen(const adore::Finding& finding);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show(int row);
  void fill();
  void elideLine();

  std::vector<Finding> findings_;
  std::function<bool(const Finding&)> concerns_current_page_;
  QString page_name_, line_;
  QToolButton* button_;
  QWidget* popup_;
  QListWidget* list_;
};

/// "Warning (cage, t = 0.012 s): sentence".
[[nodiscard]] QString finding_text(const Finding& finding);

/// A red triangle.
[[nodiscard]] QIcon warning_icon();

/// Number of the element in "ball 3, inner race" or "cage, in the pocket of element 3"; 0: none.
[[nodiscard]] int parse_element_number(const std::string& body);

/// A picture of that size with a line at its bottom for each warning, up to four, those that
/// concern it first. Without warnings: the picture alone.
[[nodiscard]] QImage image_with_findings(QSize size, const std::vector<Finding>& findings,
                                         bool dark, const std::function<QImage(QSize)>& draw,
                                         const std::function<bool(const Finding&)>& concerns = {});

}  // namespace adore::desktop

#pragma once

#include "design/design_summary.hpp"

#include <QString>
#include <QWidget>

#include <map>
#include <optional>
#include <string>
#include <vector>

class QGridLayout;
class QLabel;
class QListWidget;

namespace adore::adrinput {

/// Results of the design page: values in groups, and all findings with their severity. A value that
/// is not computed says so, with its reason as tooltip.
class DesignResultsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit DesignResultsPanel(QWidget* parent = nullptr);

  void setSummary(std::optional<design::DesignSummary> summary, const QString& failure);
  /// The values belong to an older deck: shown pale until the next summary.
  void setStale(bool stale);
  void setFindings(std::vector<Finding> findings);
  [[nodiscard]] const std::optional<design::DesignSummary>& summary() const { return summary_; }
  /// "1.87 GPa" as shown; empty: no such value.
  [[nodiscard]] QString textOf(const std::string& id) const;
  /// Colors of the theme.
  void restyle();

 signals:
  void findingChosen(const adore::Finding& finding);
  /// The rows of the first summary are there, and with them the width of the card.
  void rowsBuilt();

 private:
  void buildRows();
  void fillRows();

  std::optional<design::DesignSummary> summary_;
  QString failure_;
  bool stale_ = false;
  std::vector<Finding> findings_;
  QLabel *state_, *heading_;
  QGridLayout* grid_;
  QListWidget* list_;
  struct Row {
    QLabel *name, *value;
  };
  std::map<std::string, Row> rows_;  ///< by id
};

}  // namespace adore::adrinput

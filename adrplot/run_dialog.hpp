#pragma once

#include <QDialog>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace adore::adrplot {

/// Data of the runs behind a point of a study; named "runs".
class RunDialog : public QDialog {
  Q_OBJECT
 public:
  RunDialog(const std::vector<long>& runs, std::function<std::string(long)> about,
            std::function<std::filesystem::path(long)> files, QWidget* parent);

 signals:
  /// The files of a run are to be opened.
  void filesRequested(const QString& folder);
};

}  // namespace adore::adrplot

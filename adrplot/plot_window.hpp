#pragma once

#include "adrplot/plot_document.hpp"

#include <QMainWindow>

#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QToolBar;
class QTreeWidget;

namespace adore::desktop {
class ChartView;
}

namespace adore::adrplot {

/// AdrPlot's window: files and their pages in a tree, one page as charts, and the buttons that turn
/// pages.
class PlotWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit PlotWindow(QWidget* parent = nullptr);
  ~PlotWindow() override;

  /// Reads a file and shows its first page. False, after a message with the reason, when the file
  /// is refused.
  bool openFile(const std::filesystem::path& path, const results::SolRange& range = {});
  /// The same for results in memory.
  void addFile(results::SolFile file, const results::SolRange& range = {});

  [[nodiscard]] int fileCount() const { return static_cast<int>(documents_.size()); }
  [[nodiscard]] int pageCount() const;
  [[nodiscard]] int currentPage() const { return page_; }  ///< 1-based; 0 while no file is open
  [[nodiscard]] desktop::ChartView& view() { return *view_; }
  void showPage(int number);
  void setAbscissa(Abscissa abscissa);

 public slots:
  void askForFile();
  void previousPage();
  void nextPage();
  void askForPage();
  void reload();
  void print();
  void savePicture();
  void switchTheme();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  struct Document : PlotDocument {
    results::SolRange range;  ///< of the steps that were read
  };
  void addDocument(PlotDocument document, const results::SolRange& range);
  void makeButtons();
  void makeChoices(QToolBar* bar);
  void fillTree();
  void showCurrent();
  void askForRange(const QString& path);
  [[nodiscard]] Document* document();

  std::vector<std::unique_ptr<Document>> documents_;
  int current_ = -1, page_ = 0;
  PageOptions options_;
  desktop::ChartView* view_;
  QTreeWidget* tree_;
  QLabel* note_;
  QComboBox* abscissa_ = nullptr;
  QComboBox* orbit_ = nullptr;
  QAction* orbit_action_ = nullptr;
};

}  // namespace adore::adrplot

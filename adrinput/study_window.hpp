#pragma once

#include "adrinput/study_document.hpp"

#include <QMainWindow>

#include <functional>

class QAction;
class QMenu;
class QPlainTextEdit;
class QScrollArea;
class QTabWidget;
class QTimer;

namespace adore::adrinput {

class NoticeBar;
class StudyForm;
class StudyPanel;

/// The window of a study file: its form or its text on the left; check, plan, run and report on the
/// right.
class StudyWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit StudyWindow(QWidget* parent = nullptr);
  ~StudyWindow() override;

  [[nodiscard]] StudyDocument& document() { return document_; }
  [[nodiscard]] StudyForm& form() { return *form_; }
  [[nodiscard]] QScrollArea& formArea() { return *scroll_area_; }
  [[nodiscard]] StudyPanel& panel() { return *study_panel_; }
  [[nodiscard]] NoticeBar& notice() { return *notice_bar_; }
  /// False, after a message with the reason, when it cannot be read.
  bool openFile(const std::filesystem::path& path);
  /// The example of a kind for a deck; the first save asks for its name.
  void newStudy(const std::filesystem::path& file, const QString& kind,
                const std::filesystem::path& deck);
  void showText(bool text);
  /// Fills a menu with an entry for each kind.
  static void addKindActions(QMenu& menu, const std::function<void(const QString&)>& chosen);

 public slots:
  void save();
  void saveAs();
  void askForFile();
  void askForDeck();
  void plan();
  void run();
  void switchTheme();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void makeMenus();
  void sync();
  void showFinding();
  bool writeTo(const std::filesystem::path& path);
  void saveTo(const std::filesystem::path& path, std::function<void()> then);
  /// Continues with a study that is saved and has no errors.
  void withSavedStudy(std::function<void()> then);
  void confirmLeave(std::function<void()> then);
  void offerUnsaved();

  StudyDocument document_;
  QTabWidget* tabs_ = nullptr;
  QScrollArea* scroll_area_ = nullptr;
  StudyForm* form_ = nullptr;
  QPlainTextEdit* text_ = nullptr;
  StudyPanel* study_panel_ = nullptr;
  NoticeBar* notice_bar_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr;
  QTimer* store_timer_ = nullptr;
  bool close_confirmed_ = false, syncing_ = false;
};

}  // namespace adore::adrinput

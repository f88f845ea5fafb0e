#pragma once

#include "agore/motion_picture.hpp"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>

#include <memory>

class QComboBox;
class QMenu;

namespace adore::agore {

/// The picture in the window; clicking or dragging in the time bar moves to that moment.
class PictureWidget : public QWidget {
  Q_OBJECT
 public:
  explicit PictureWidget(QWidget* parent = nullptr);
  void show(MotionPicture* picture, std::size_t frame, const ViewOptions& options);

 signals:
  void soughtTo(double progress);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  void seek(QPointF position);
  MotionPicture* picture_ = nullptr;
  std::size_t frame_ = 0;
  ViewOptions options_;
};

class AgoreWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit AgoreWindow(QWidget* parent = nullptr);
  ~AgoreWindow() override;

  /// Reads at most `most_frames` frames. False, after a message with the reason, when the file is
  /// refused.
  bool openFile(const std::filesystem::path& path, long most_frames = 1'000'000'000);
  /// The same for an animation in memory.
  void setAnimation(Animation animation);

  [[nodiscard]] std::size_t frameCount() const { return picture_ ? picture_->frames() : 0; }
  [[nodiscard]] std::size_t currentFrame() const { return frame_; }  ///< 0-based
  [[nodiscard]] bool playing() const { return timer_.isActive(); }
  [[nodiscard]] const ViewOptions& options() const { return options_; }
  [[nodiscard]] MotionPicture* picture() { return picture_.get(); }
  void setFrame(std::size_t frame);
  void setView(View view, int element = 0);  ///< element 0: the one shown last
  void setExaggeration(double factor);

 public slots:
  void askForFile();
  void playForward();
  void playBackward();
  void frameForward();
  void frameBackward();
  void pause();
  void print();
  void savePicture();
  void about();
  void switchTheme();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeMenus();
  void makeViewMenu(QMenu* menu);
  QWidget* makeButtons();
  void askForElement(View view);
  void play(int direction);
  void advance();
  void refresh();
  QImage image();

  std::unique_ptr<MotionPicture> picture_;
  PictureWidget* canvas_;
  QComboBox* speed_ = nullptr;
  QTimer timer_;
  QElapsedTimer clock_;
  double pending_ = 0.0;  ///< frames due but not yet shown
  int direction_ = 1;
  std::size_t frame_ = 0;
  int steps_ = 5000;  ///< number of time steps asked for last
  ViewOptions options_;
};

}  // namespace adore::agore

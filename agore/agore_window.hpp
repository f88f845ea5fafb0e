#pragma once

#include "agore/film_dialog.hpp"
#include "agore/motion_picture.hpp"
#include "agore/render.hpp"
#include "desktop/link_message.hpp"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QPointF>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

class QAction;
class QActionGroup;
class QComboBox;
class QMenu;

namespace adore {
struct Finding;
namespace desktop {
class FindingsBar;
class RunLink;
}  // namespace desktop
}  // namespace adore

namespace adore::agore {

class ElementPanel;
class ViewBar;
struct ScenePageOptions;

/// Of its settings and recent files.
inline constexpr const char* kApp = "agore";
inline constexpr const char* kFollow = "follow";

/// The picture in the window; clicking or dragging in the time bar or in a curve moves to that
/// time. The wheel zooms the picture under the pointer, dragging moves it (with Shift in the 3D
/// view, where dragging rotates), a double click shows all of it, a click picks an element.
/// Shift+drag in the time bar or a curve sets the repeated range.
class PictureWidget : public QWidget {
  Q_OBJECT
 public:
  explicit PictureWidget(QWidget* parent = nullptr);
  void show(MotionPicture* picture, std::size_t frame, const ViewOptions& options);

 signals:
  void progressRequested(double progress);
  void frameRequested(std::size_t frame);
  void viewMoved(std::size_t tile, double zoom, QPointF pan);
  void eyeMoved(double yaw, double elevation);
  /// Click on an element, from 0.
  void elementPicked(std::size_t element);
  /// Shift+drag in the time bar or a curve: range that is repeated [s].
  void repeatRangeMarked(double from, double to);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void tell();
  bool seek(QPointF position);
  /// Time at a position on the time bar or a curve; none elsewhere.
  [[nodiscard]] std::optional<double> timeAtPosition(QPointF position) const;
  std::optional<double> repeat_range_start_;
  /// The picture of a view at a position; none: outside all of them.
  [[nodiscard]] std::optional<std::size_t> tileAt(QPointF position) const;
  QPointF drag_from_, pan_from_;
  std::optional<std::size_t> drag_tile_;
  double yaw_from_ = 0.0, elevation_from_ = 0.0;
  bool moved_ = false;          ///< the pointer, since the button was pressed
  bool rotating_view_ = false;  ///< the eye of a 3D view follows the pointer
  MotionPicture* picture_ = nullptr;
  std::size_t frame_ = 0;
  ViewOptions options_;
};

class AgoreWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit AgoreWindow(QWidget* parent = nullptr);
  ~AgoreWindow() override;

  /// Reads at most `most_frames` frames. False, after a message with the reason, if the file is
  /// rejected.
  bool openFile(const std::filesystem::path& path, long most_frames = 1'000'000'000);
  /// Lists the runs of a project in the menu File, and opens the first that is there. False, after
  /// a message, if PROJECT.json is damaged or newer.
  bool openProject(const std::filesystem::path& path);
  /// The same file once more, as far as it has grown, at the same moment and with the same views.
  void reload();
  /// The same for an animation in memory.
  void setAnimation(Animation animation);
  /// Reloads the files whenever a running solver has added steps. At the last frame the view moves
  /// on to the new last one; otherwise the time stays.
  void follow(bool on);

  [[nodiscard]] std::size_t frameCount() const { return picture_ ? picture_->frames() : 0; }
  [[nodiscard]] std::size_t currentFrame() const { return frame_; }  ///< 0-based
  [[nodiscard]] bool playing() const { return timer_.isActive(); }
  [[nodiscard]] const ViewOptions& options() const { return options_; }
  [[nodiscard]] MotionPicture* picture() { return picture_.get(); }
  void setFrame(std::size_t frame);
  void setView(View view, int element = 0);  ///< element 0: the last one
  /// Applies all view options of a command, as --render draws them; false, after a message with the
  /// reason, if this file cannot show them.
  bool applyViewOptions(const ViewOptions& asked);
  void setExaggeration(double factor);
  void setColorQuantity(ColourBy colour);
  void setColorScale(const ColorScaleChoice& scale);
  void setLoadArrowsShown(bool shown);
  void setTrails(bool shown);
  void setShown(const ShownParts& shown);
  /// Values of the element in a panel over the picture.
  void setValuesShown(bool shown);
  [[nodiscard]] ElementPanel& panel() { return *panel_; }
  /// Adds an additional view, or removes all of that kind.
  void setAdditionalView(View view, bool shown);
  void setLoop(bool loop) { loop_ = loop; }
  /// Range that is played, repeated and saved as a movie, by its ends [s]; none: first frame, last
  /// frame. Ends in the wrong order are exchanged.
  void setRepeatRange(std::optional<double> from, std::optional<double> to);
  /// Simulated seconds per second of the clock; 0: frames per second, as chosen.
  void setSlowMotion(double rate);
  /// Writes a movie of the frames from first to last, counted from 1 (0: the last of all), and
  /// reports it in the status bar; false, after a message with the reason, on failure.
  bool writeMovie(const QString& path, int first = 1, int last = 0);
  bool writeMovie(const QString& path, const MovieSettings& choice);
  /// The same for a page with the 3D scene, which a browser plays.
  bool writeScene(const QString& path);
  /// "ball-3d.gif" of a run in the folder "ball".
  [[nodiscard]] QString proposedName(const QString& suffix) const;

 public slots:
  void saveMovie();
  void saveScene();
  void askForFile();
  void askForProject();
  void playForward();
  void playBackward();
  void frameForward();
  void frameBackward();
  void pause();
  void print();
  void savePicture();
  void switchTheme();

 protected:
 private:
  // Linked windows of the run (window_link.cpp).
  void makeLink();
  void joinLink();
  [[nodiscard]] desktop::LinkState currentLinkState() const;
  /// @param by_user else a playing animation or a growing file
  void sendLinkState(bool by_user);
  void applyLinkState(const desktop::LinkState& change);
  void checkForFileChanges();
  /// Replaces the animation by that of a file; the previous picture stays until then.
  void replaceAnimation(Animation animation);
  [[nodiscard]] bool canShow(const Animation& animation) const;
  /// First and last frame of the played range.
  [[nodiscard]] std::pair<std::size_t, std::size_t> playedFrames() const;
  void setRepeatLimit(bool first);
  QAction* add(QMenu* menu, const QString& text, const QString& name, const QKeySequence& key,
               std::function<void()> act);
  void makeMenus();
  void makeMotionMenu(QMenu* menu);
  void addZoomKeys(QMenu* menu);
  void makeViewMenu(QMenu* menu);
  void makeAdditionalViewsMenu(QMenu* menu);
  void makeColourMenus(QMenu* menu);
  void makePartsMenu(QMenu* menu);
  void askForColorLimits();
  void setDefaultColorScale(const ColorScaleChoice& scale);
  void askForMovieFile(const MovieSettings& choice);
  QWidget* makeButtons();
  [[nodiscard]] RenderOptions movieRenderOptions(const MovieSettings& choice) const;
  [[nodiscard]] ScenePageOptions sceneOptions() const;
  /// Range, interval, rate and size as the window plays.
  [[nodiscard]] MovieSettings movieSettings() const;
  [[nodiscard]] int movieFrameRate() const;
  [[nodiscard]] int movieFrameInterval() const;  ///< every how many frames it has a picture
  void askForElement(View view, std::optional<std::size_t> flange_race = {});
  void play(int direction);
  void advance();
  void refresh();
  void sortFindingsForView();
  /// Goes to frame and view of a finding.
  void goToFinding(const Finding& finding);
  void showFrame();
  void showPanel();
  [[nodiscard]] QString pathInFileFolder(const QString& name) const;
  [[nodiscard]] ViewOptions exportViewOptions() const;  ///< of a picture that is not passing by
  [[nodiscard]] bool shows(View view) const;

  std::unique_ptr<MotionPicture> picture_;
  PictureWidget* picture_widget_;
  ViewBar* bar_;
  ElementPanel* panel_;
  desktop::FindingsBar* findings_;
  QWidget* buttons_ = nullptr;
  QComboBox *playback_rate_box_ = nullptr, *slow_motion_box_ = nullptr;
  QTimer timer_;
  QElapsedTimer clock_;
  double pending_frames_ = 0.0;  ///< frames due but not shown yet
  bool loop_ = false;
  double slow_motion_rate_ = 0.0;  ///< simulated seconds per second
  double slow_motion_time_ = 0.0;  ///< simulated time that slow motion has reached [s]
  int direction_ = 1;
  std::size_t frame_ = 0;
  long max_frames_ = 1'000'000'000;  ///< as specified when the file was opened
  QTimer file_check_timer_;
  QAction *follow_action_ = nullptr, *repeat_action_ = nullptr;
  std::string seen_;               ///< modification times of the displayed files
  int rejected_reload_count_ = 0;  ///< checks files that could not replace the displayed ones
  bool writing_movie_ = false;     ///< a movie of the displayed views
  desktop::RunLink* link_ = nullptr;
  desktop::LinkState last_link_state_;  ///< as told or received last
  bool taking_ = false;                 ///< changes now are not of the user
  ViewOptions options_;
};

}  // namespace adore::agore

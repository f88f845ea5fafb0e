#include "agore/agore_window.hpp"

#include "agore/render.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/window_place.hpp"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <exception>

namespace adore::agore {
namespace {
const QString kApp = "agore";
constexpr int kTick = 25;  // [ms] between pictures: 40 a second
}  // namespace

AgoreWindow::AgoreWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowTitle("AGORE");
  desktop::open_at_size(*this, {1320, 820});
  options_.dark = desktop::current_theme().kind == desktop::ThemeKind::Dark;
  setAcceptDrops(true);
  canvas_ = new PictureWidget(this);
  auto* centre = new QWidget(this);
  auto* row = new QHBoxLayout(centre);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(canvas_, 1);
  row->addWidget(makeButtons());
  setCentralWidget(centre);
  makeMenus();
  timer_.setInterval(kTick);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &AgoreWindow::advance);
  connect(canvas_, &PictureWidget::soughtTo, this, [this](double progress) {
    const auto& time = picture_->animation().time;
    const double wanted = time.front() + progress * (time.back() - time.front());
    const auto after = std::lower_bound(time.begin(), time.end(), wanted);
    setFrame(static_cast<std::size_t>(
        std::min<std::ptrdiff_t>(after - time.begin(), std::ssize(time) - 1)));
  });
  refresh();
}

AgoreWindow::~AgoreWindow() = default;

QWidget* AgoreWindow::makeButtons() {
  auto* column = new QWidget(this);
  column->setFixedWidth(136);
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(12, 16, 12, 16);
  layout->setSpacing(8);
  const auto button = [&](const QString& text, const QString& name, const QKeySequence& key,
                          auto slot) {
    auto* b = new QPushButton(text, column);
    b->setObjectName(name);
    b->setShortcut(key);
    b->setFocusPolicy(Qt::NoFocus);
    b->setMinimumHeight(32);
    b->setToolTip(key.toString(QKeySequence::NativeText));
    connect(b, &QPushButton::clicked, this, slot);
    layout->addWidget(b);
  };
  button(tr(">Play"), "play", Qt::Key_Space, [this] { playing() ? pause() : playForward(); });
  button(tr("<Play"), "playBack", Qt::SHIFT | Qt::Key_Space, [this] { playBackward(); });
  button(tr(">Frame"), "frame", Qt::Key_Right, [this] { frameForward(); });
  button(tr("<Frame"), "frameBack", Qt::Key_Left, [this] { frameBackward(); });
  button(tr("Pause"), "pause", Qt::Key_P, [this] { pause(); });
  layout->addSpacing(10);
  layout->addWidget(new QLabel(tr("Frames/second"), column));
  speed_ = new QComboBox(column);
  speed_->setObjectName("speed");
  speed_->setFocusPolicy(Qt::NoFocus);
  for (const int rate : {2, 5, 10, 25, 50, 100, 250, 1000})
    speed_->addItem(QString::number(rate), rate);
  speed_->setCurrentText("25");
  layout->addWidget(speed_);
  layout->addStretch(1);
  button(tr("Print"), "print", QKeySequence::Print, [this] { print(); });
  button(tr("Save"), "save", QKeySequence::Save, [this] { savePicture(); });
  button(tr("Quit"), "quit", Qt::CTRL | Qt::Key_Q, [this] { close(); });
  return column;
}

void AgoreWindow::makeMenus() {
  auto* file = menuBar()->addMenu(tr("&File"));
  file->addAction(tr("&Open..."), QKeySequence::Open, this, &AgoreWindow::askForFile);
  file->addAction(tr("&Quit"), this, &AgoreWindow::close);
  makeViewMenu(menuBar()->addMenu(tr("&View")));
  auto* help = menuBar()->addMenu(tr("&Help"));
  help->addAction(tr("&About AGORE"), this, &AgoreWindow::about);
}

void AgoreWindow::makeViewMenu(QMenu* menu) {
  menu->setObjectName("viewMenu");
  menu->addAction(tr("&Bearing Motion"), this, [this] { setView(View::Bearing); });
  menu->addAction(tr("&Cage Motion"), this, [this] { setView(View::Cage); });
  menu->addAction(tr("&Pocket Interaction..."), this, [this] { askForElement(View::Pocket); });
  menu->addAction(tr("&RE Motion..."), this, [this] { askForElement(View::Element); });
  auto* race = menu->addMenu(tr("R&ace Motion"));
  race->addAction(tr("&Outer"), this, [this] { setView(View::OuterRace); });
  race->addAction(tr("&Inner"), this, [this] { setView(View::InnerRace); });
  auto* flange = menu->addAction(tr("&Flange Interaction (rollers only)"));
  flange->setObjectName("flange");
  flange->setEnabled(false);
  flange->setToolTip(
      tr("Needs a roller bearing, and roller ends and flanges, which SOL8 does not hold."));
  menu->setToolTipsVisible(true);
  menu->addSeparator();
  auto* clearances = menu->addMenu(tr("C&learances"));
  auto* group = new QActionGroup(this);
  for (const double factor : {0.0, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    auto* action = clearances->addAction(factor == 0.0   ? tr("Automatic")
                                         : factor == 1.0 ? tr("To scale")
                                                         : QString("× %1").arg(factor),
                                         this, [this, factor] { setExaggeration(factor); });
    action->setCheckable(true);
    action->setChecked(factor == 0.0);
    group->addAction(action);
  }
  menu->addAction(tr("&Dark/Light"), Qt::CTRL | Qt::Key_D, this, &AgoreWindow::switchTheme);
}

bool AgoreWindow::openFile(const std::filesystem::path& path, long most_frames) {
  try {
    setAnimation(open_motion(path, most_frames));
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  const std::string& note = picture_->animation().file.note;
  if (!note.empty())
    desktop::show_message(this, tr("The file is incomplete: %1. Its %2 complete frames are shown.")
                                    .arg(QString::fromStdString(note))
                                    .arg(frameCount()));
  return true;
}

void AgoreWindow::setAnimation(Animation animation) {
  pause();
  auto fresh = std::make_unique<MotionPicture>(std::move(animation));
  if (options_.element > fresh->animation().file.elements) options_.element = 1;
  if (!why_not(options_.view, fresh->animation()).empty()) options_.view = View::Bearing;
  canvas_->show(fresh.get(), 0, options_);
  picture_ = std::move(fresh);
  frame_ = 0;
  refresh();
}

void AgoreWindow::setFrame(std::size_t frame) {
  if (!picture_) return;
  frame_ = std::min(frame, frameCount() - 1);
  refresh();
}

void AgoreWindow::setView(View view, int element) {
  if (!picture_) return askForFile();
  const std::string reason = why_not(view, picture_->animation());
  if (!reason.empty()) return desktop::show_message(this, QString::fromStdString(reason));
  options_.view = view;
  if (element > 0) options_.element = std::min(element, picture_->animation().file.elements);
  refresh();
}

void AgoreWindow::setExaggeration(double factor) {
  options_.exaggeration = factor;
  refresh();
}

void AgoreWindow::askForElement(View view) {
  if (!picture_) return askForFile();
  const int count = picture_->animation().file.elements;
  const QString what = view == View::Pocket ? tr("Pocket") : tr("Rolling element");
  desktop::ask_number(this, QString::fromStdString(view_title(view)),
                      tr("%1 (1 to %2):").arg(what).arg(count), options_.element, 1, count,
                      [this, view](int number) { setView(view, number); });
}

void AgoreWindow::askForFile() {
  desktop::ask_number(
      this, tr("Open"), tr("Number of time steps to animate (at most what is stored):"), steps_, 1,
      100'000'000, [this](int steps) {
        steps_ = steps;
        desktop::ask_file(
            this, kApp, tr("Open animation file"), "SOL8*",
            [this, steps](const QString& name) { openFile(name.toStdString(), steps); });
      });
}

void AgoreWindow::playForward() { play(1); }
void AgoreWindow::playBackward() { play(-1); }

void AgoreWindow::play(int direction) {
  if (!picture_) return askForFile();
  direction_ = direction;
  // Play at the end starts over.
  if (direction > 0 && frame_ + 1 == frameCount()) setFrame(0);
  if (direction < 0 && frame_ == 0) setFrame(frameCount() - 1);
  pending_ = 0.0;
  clock_.start();
  timer_.start();
}

void AgoreWindow::advance() {
  pending_ += static_cast<double>(clock_.restart()) * 1e-3 * speed_->currentData().toDouble();
  const auto due = static_cast<std::size_t>(pending_);
  if (due == 0) return;
  pending_ -= static_cast<double>(due);
  const std::size_t last = frameCount() - 1;
  const std::size_t left = direction_ > 0 ? last - frame_ : frame_;
  const std::size_t moved = std::min(due, left);
  setFrame(direction_ > 0 ? frame_ + moved : frame_ - moved);
  if (frame_ == (direction_ > 0 ? last : 0)) pause();
}

void AgoreWindow::frameForward() {
  pause();
  if (picture_ && frame_ + 1 < frameCount()) setFrame(frame_ + 1);
}

void AgoreWindow::frameBackward() {
  pause();
  if (frame_ > 0) setFrame(frame_ - 1);
}

void AgoreWindow::pause() { timer_.stop(); }

QImage AgoreWindow::image() { return picture_->image(canvas_->size(), frame_, options_); }

void AgoreWindow::print() {
  if (!picture_) return askForFile();
  pause();
  desktop::print_picture(this, [this] { return image(); });
}

void AgoreWindow::savePicture() {
  if (!picture_) return askForFile();
  pause();
  desktop::save_picture(this, kApp, "bearing.jpg", [this] { return image(); });
}

void AgoreWindow::about() {
  desktop::show_message(this, tr("AGORE shows the motion of a bearing from SOL8 files.\nThe lowest "
                                 "program version whose data sets are accepted is %1.\n\n"
                                 "Part of Adore, free software under the GPL, without warranty.")
                                  .arg(kLowestVersion));
}

void AgoreWindow::switchTheme() {
  using desktop::ThemeKind;
  options_.dark = !options_.dark;
  desktop::apply_theme(options_.dark ? ThemeKind::Dark : ThemeKind::Light);
  refresh();
}

void AgoreWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void AgoreWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  event->acceptProposedAction();
  if (urls.size() > 1) {
    desktop::show_message(this, tr("One animation is shown at a time; drop a single SOL8 file."));
    return;
  }
  openFile(urls.front().toLocalFile().toStdString());
}

void AgoreWindow::refresh() {
  canvas_->show(picture_.get(), frame_, options_);
  for (const char* name : {"play", "playBack", "frame", "frameBack", "pause", "print", "save"})
    findChild<QPushButton*>(name)->setEnabled(picture_ != nullptr);
  if (picture_)
    setWindowTitle(QString::fromStdString(picture_->animation().file.path.filename().string() +
                                          " — " + view_title(options_.view)) +
                   " — AGORE");
}

}  // namespace adore::agore

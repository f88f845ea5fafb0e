#include "agore/agore_window.hpp"

#include "agore/film_dialog.hpp"
#include "agore/render.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/file_drops.hpp"
#include "desktop/mp4_writer.hpp"
#include "desktop/one_window.hpp"
#include "desktop/window_place.hpp"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QImage>
#include <QInputDialog>
#include <QLabel>
#include <QMenuBar>
#include <QProgressDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <exception>
#include <tuple>
#include <utility>

namespace adore::agore {
namespace {
const QString kApp = "agore";
constexpr const char* kScale = "colours/scale";
constexpr int kTick = 16;  // [ms] between pictures: 60 a second
}  // namespace

AgoreWindow::AgoreWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowTitle("AGORE");
  desktop::open_at_size(*this, {1320, 820});
  options_.dark = desktop::current_theme().kind == desktop::ThemeKind::Dark;
  desktop::take_files_anywhere(*this, [this](const QStringList& files) {
    if (files.size() > 1)
      desktop::show_message(this, tr("One animation is shown at a time; drop a single SOL8 file."));
    else
      openFile(files.front().toStdString());
  });
  canvas_ = new PictureWidget(this);
  auto* centre = new QWidget(this);
  auto* row = new QHBoxLayout(centre);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(canvas_, 1);
  makeMenus();
  row->addWidget(makeButtons());
  setCentralWidget(centre);
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
  connect(canvas_, &PictureWidget::soughtFrame, this, &AgoreWindow::setFrame);
  connect(canvas_, &PictureWidget::viewMoved, this,
          [this](std::size_t tile, double zoom, QPointF pan) {
            if (tile == 0) {
              options_.zoom = zoom;
              options_.pan = pan;
            } else if (tile <= options_.beside.size()) {
              options_.beside[tile - 1].zoom = zoom;
              options_.beside[tile - 1].pan = pan;
            }
            showFrame();
          });
  connect(canvas_, &PictureWidget::eyeMoved, this, [this](double yaw, double elevation) {
    options_.yaw = yaw;
    options_.elevation = elevation;
    showFrame();
  });
  try {
    options_.scale =
        scale_named(QSettings("Adore", kApp).value(kScale, "usual").toString().toStdString());
  } catch (const std::exception&) {
    options_.scale = {};  // settings of another program version
  }
  // The foot is there while it says something: its room is the picture's.
  statusBar()->setSizeGripEnabled(false);
  statusBar()->hide();
  connect(statusBar(), &QStatusBar::messageChanged, this,
          [this](const QString& text) { statusBar()->setVisible(!text.isEmpty()); });
  refresh();
}

AgoreWindow::~AgoreWindow() = default;

/// Each button stands for an action of the menus, whose key a hand may hold down.
QWidget* AgoreWindow::makeButtons() {
  auto* column = new QWidget(this);
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(12, 10, 12, 10);
  layout->setSpacing(6);
  const auto button = [&](const QString& text, const QString& name) {
    auto* action = findChild<QAction*>(name + "Action");
    auto* b = new QPushButton(text, column);
    b->setObjectName(name);
    b->setFocusPolicy(Qt::NoFocus);
    b->setMinimumHeight(28);
    b->setToolTip(action->shortcut().toString(QKeySequence::NativeText));
    connect(b, &QPushButton::clicked, action, &QAction::trigger);
    layout->addWidget(b);
  };
  button(tr(">Play"), "play");
  button(tr("<Play"), "playBack");
  button(tr(">Frame"), "frame");
  button(tr("<Frame"), "frameBack");
  button(tr("Pause"), "pause");
  layout->addSpacing(6);
  layout->addWidget(new QLabel(tr("Frames/second"), column));
  speed_ = new QComboBox(column);
  speed_->setObjectName("speed");
  speed_->setAccessibleName(tr("Frames per second"));
  speed_->setFocusPolicy(Qt::NoFocus);
  for (const int rate : {2, 5, 10, 25, 50, 100, 250, 1000})
    speed_->addItem(QString::number(rate), rate);
  speed_->setCurrentText("25");
  layout->addWidget(speed_);
  layout->addWidget(new QLabel(tr("Slow motion"), column));
  slow_motion_ = new QComboBox(column);
  slow_motion_->setObjectName("slow");
  slow_motion_->setAccessibleName(tr("Slow motion against real time"));
  slow_motion_->setFocusPolicy(Qt::NoFocus);
  slow_motion_->addItem(tr("by frames"), 0.0);
  for (const int part : {10, 100, 1000, 5000, 20000})
    slow_motion_->addItem(QString("1/%1").arg(part), 1.0 / part);
  connect(slow_motion_, &QComboBox::currentIndexChanged, this,
          [this] { setSlowMotion(slow_motion_->currentData().toDouble()); });
  layout->addWidget(slow_motion_);
  layout->addStretch(1);
  button(tr("Print"), "print");
  button(tr("Save"), "save");
  button(tr("Quit"), "quit");
  auto* scroll = new QScrollArea(this);  // on low screens
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidgetResizable(true);
  scroll->setWidget(column);
  scroll->setFixedWidth(136);
  return scroll;
}

/// An action that the button of the same name stands for.
QAction* AgoreWindow::add(QMenu* menu, const QString& text, const QString& name,
                          const QKeySequence& key, std::function<void()> act) {
  auto* action = menu->addAction(text, key, this, [act = std::move(act)] { act(); });
  action->setObjectName(name + "Action");
  return action;
}

void AgoreWindow::makeMenus() {
  auto* file = menuBar()->addMenu(tr("&File"));
  file->addAction(tr("&Open..."), QKeySequence::Open, this, &AgoreWindow::askForFile);
  desktop::add_recent_menu(*file, kApp,
                           [this](const QString& name) { openFile(name.toStdString()); });
  file->addAction(tr("Re&load"), Qt::Key_F5, this, &AgoreWindow::reload);
  file->addSeparator();
  add(file, tr("&Save Picture..."), "save", QKeySequence::Save, [this] { savePicture(); });
  file->addAction(tr("Save &Film..."), Qt::CTRL | Qt::Key_E, this, &AgoreWindow::saveFilm);
  add(file, tr("&Print..."), "print", QKeySequence::Print, [this] { print(); });
  file->addSeparator();
  add(file, tr("&Quit"), "quit", Qt::CTRL | Qt::Key_Q, [this] { close(); });
  makeViewMenu(menuBar()->addMenu(tr("&View")));
  makeMotionMenu(menuBar()->addMenu(tr("&Motion")));
  desktop::add_help_menu(
      *this, "AGORE",
      tr("AGORE shows the motion of a bearing from SOL8 or RESULTS.h5.\nThe lowest program version "
         "whose data sets are accepted is %1.")
          .arg(kLowestVersion),
      {{tr("Space, Shift+Space"), tr("play forward (again: pause), backward")},
       {tr("P"), tr("pauses")},
       {tr("Right, Left"), tr("one frame on, back; held down: on and on")},
       {tr("Home, End"), tr("first and last frame")},
       {tr("Up, Down"), tr("next and previous element or pocket, and the segment that holds it")},
       {tr("[, ]"), tr("plays slower, faster")},
       {tr("S"), tr("the next slow motion of the list")},
       {tr("R"), tr("repeats for ever")},
       {tr("1 to 9, Ctrl+7"), tr("the views of the menu")},
       {tr("V"), tr("four views side by side, and one again")},
       {tr("L, T"), tr("race loads and paths of all elements")},
       {tr("C, Shift+C"), tr("the next colouring of the elements, its next scale")},
       {tr("+ or =, -, 0"), tr("zooms the first picture, shows all of it")},
       {tr("Ctrl and an arrow"), tr("moves the first picture, or turns the 3D view")},
       {tr("click or drag in the time bar or a curve"), tr("goes to that moment")},
       {tr("wheel, drag, double click on a picture"), tr("zooms, moves, shows all")},
       {tr("drag, Shift+drag in the 3D view"), tr("turns it, moves it")},
       {tr("Ctrl+E"), tr("saves a film")},
       {tr("F5"), tr("reads the file again, as far as a run has come")}});
}

void AgoreWindow::makeMotionMenu(QMenu* menu) {
  add(menu, tr("&Play, or Pause"), "play", Qt::Key_Space, [this] {
    playing() ? pause() : playForward();
  })->setAutoRepeat(false);
  add(menu, tr("Play &Backward"), "playBack", Qt::SHIFT | Qt::Key_Space, [this] {
    playBackward();
  })->setAutoRepeat(false);
  add(menu, tr("P&ause"), "pause", Qt::Key_P, [this] { pause(); });
  add(menu, tr("One Frame &On"), "frame", Qt::Key_Right, [this] { frameForward(); });
  add(menu, tr("One Frame Bac&k"), "frameBack", Qt::Key_Left, [this] { frameBackward(); });
  menu->addAction(tr("&First Frame"), Qt::Key_Home, this, [this] { setFrame(0); });
  menu->addAction(tr("&Last Frame"), Qt::Key_End, this, [this] {
    if (frameCount() > 0) setFrame(frameCount() - 1);
  });
  menu->addSeparator();
  menu->addAction(tr("&Next Element"), Qt::Key_Up, this,
                  [this] { setView(options_.view, options_.element + 1); });
  menu->addAction(tr("Pre&vious Element"), Qt::Key_Down, this,
                  [this] { setView(options_.view, std::max(1, options_.element - 1)); });
  menu->addSeparator();
  const auto step = [](QComboBox* box, int by) {
    box->setCurrentIndex(std::clamp(box->currentIndex() + by, 0, box->count() - 1));
  };
  menu->addAction(tr("&Slower"), Qt::Key_BracketLeft, this, [this, step] { step(speed_, -1); });
  menu->addAction(tr("Fas&ter"), Qt::Key_BracketRight, this, [this, step] { step(speed_, 1); });
  menu->addAction(tr("Slow &Motion"), Qt::Key_S, this, [this] {
    slow_motion_->setCurrentIndex((slow_motion_->currentIndex() + 1) % slow_motion_->count());
  });
  auto* loop = menu->addAction(tr("&Repeat"));
  loop->setShortcut(Qt::Key_R);
  loop->setCheckable(true);
  connect(loop, &QAction::toggled, this, &AgoreWindow::setLoop);
}

/// What the wheel and the pointer do, by keys, for the first picture.
void AgoreWindow::addZoomKeys(QMenu* menu) {
  static constexpr double kZoom = 1.25, kMostZoom = 200.0, kWay = 0.1, kTurn = 10.0;
  const auto zoom = [this](double factor) {
    const double next = std::clamp(options_.zoom * factor, 1.0, kMostZoom);
    options_.pan = next == 1.0 ? QPointF(0.0, 0.0) : options_.pan * (next / options_.zoom);
    options_.zoom = next;
    showFrame();
  };
  auto* in = menu->addAction(tr("Zoom I&n"), this, [zoom] { zoom(kZoom); });
  in->setShortcuts({Qt::Key_Plus, Qt::Key_Equal});
  menu->addAction(tr("&Zoom Out"), Qt::Key_Minus, this, [zoom] { zoom(1.0 / kZoom); });
  menu->addAction(tr("Show All of I&t"), Qt::Key_0, this, [this] {
    options_.zoom = 1.0;
    options_.pan = {0.0, 0.0};
    options_.yaw = ViewOptions{}.yaw;
    options_.elevation = ViewOptions{}.elevation;
    showFrame();
  });
  auto* moves = menu->addMenu(tr("&Move or Turn"));
  for (const auto& [key, name, x, y] : {std::tuple{Qt::Key_Left, "&Left", -1, 0},
                                        {Qt::Key_Right, "&Right", 1, 0},
                                        {Qt::Key_Up, "&Up", 0, -1},
                                        {Qt::Key_Down, "&Down", 0, 1}})
    moves->addAction(tr(name), Qt::CTRL | key, this, [this, x = x, y = y] {
      if (options_.view == View::Solid) {
        options_.yaw = std::remainder(options_.yaw - kTurn * x, 360.0);
        options_.elevation = std::clamp(options_.elevation + kTurn * y, -89.0, 89.0);
      } else {
        options_.pan += QPointF(kWay * x, kWay * y);
      }
      showFrame();
    });
}

void AgoreWindow::makeViewMenu(QMenu* menu) {
  menu->setObjectName("viewMenu");
  menu->addAction(tr("&Bearing Motion"), Qt::Key_1, this, [this] { setView(View::Bearing); });
  menu->addAction(tr("&Cage Motion"), Qt::Key_2, this, [this] { setView(View::Cage); });
  menu->addAction(tr("&Pocket Interaction..."), Qt::Key_3, this,
                  [this] { askForElement(View::Pocket); });
  menu->addAction(tr("&RE Motion..."), Qt::Key_4, this, [this] { askForElement(View::Element); });
  auto* race = menu->addMenu(tr("R&ace Motion"));
  race->addAction(tr("&Outer"), Qt::Key_5, this, [this] { setView(View::OuterRace); });
  race->addAction(tr("&Inner"), Qt::Key_6, this, [this] { setView(View::InnerRace); });
  auto* flange = menu->addMenu(tr("&Flange Interaction (rollers only)"));
  flange->setObjectName("flange");
  for (const auto& [race_index, name, key] :
       {std::tuple<std::size_t, const char*, QKeySequence>{0, "&Outer Race...", Qt::Key_7},
        {1, "&Inner Race...", Qt::CTRL | Qt::Key_7}})
    flange->addAction(tr(name), key, this, [this, race_index = race_index] {
      if (picture_ && !has_flange(picture_->animation(), race_index, 0) &&
          !has_flange(picture_->animation(), race_index, 1) &&
          why_not(View::Flange, picture_->animation()).empty())
        return desktop::show_message(this, tr("This race has no flange; the other one has."));
      options_.flange_race = race_index;
      askForElement(View::Flange);
    });
  menu->addAction(tr("Axial &Section..."), Qt::Key_8, this,
                  [this] { askForElement(View::Section); });
  menu->addAction(tr("&3D View..."), Qt::Key_9, this, [this] { askForElement(View::Solid); });
  makeBesideMenu(menu->addMenu(tr("Bes&ide")));
  menu->addSeparator();
  addZoomKeys(menu);
  menu->addSeparator();
  makeColourMenus(menu);
  auto* contacts = menu->addAction(tr("Race Loads on All &Elements"));
  contacts->setCheckable(true);
  contacts->setShortcut(Qt::Key_L);
  connect(contacts, &QAction::toggled, this, &AgoreWindow::setContacts);
  auto* trails = menu->addAction(tr("Pat&hs of the Elements"));
  trails->setCheckable(true);
  trails->setShortcut(Qt::Key_T);
  connect(trails, &QAction::toggled, this, &AgoreWindow::setTrails);
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

void AgoreWindow::makeColourMenus(QMenu* menu) {
  auto* colours = menu->addMenu(tr("C&olour Elements by"));
  auto* colour_group = new QActionGroup(this);
  for (const auto& [by, name] : {std::pair{ColourBy::None, "&Nothing"},
                                 {ColourBy::Load, "Contact &Load"},
                                 {ColourBy::Slip, "Largest &Slip"},
                                 {ColourBy::Heat, "Contact &Heat"},
                                 {ColourBy::Temperature, "Contact &Temperature"}}) {
    auto* action = colours->addAction(tr(name), this, [this, by = by] { setColour(by); });
    action->setCheckable(true);
    action->setChecked(by == ColourBy::None);
    colour_group->addAction(action);
  }
  colours->addSeparator();
  colours->addAction(tr("The Ne&xt of These"), Qt::Key_C, this, [colour_group] {
    const auto all = colour_group->actions();
    all[(all.indexOf(colour_group->checkedAction()) + 1) % all.size()]->trigger();
  });
  auto* scales = menu->addMenu(tr("Scale of the Colo&urs"));
  scales->setObjectName("scaleMenu");
  auto* scale_group = new QActionGroup(this);
  for (const auto& [kind, name] : {std::pair{ColourScale::Usual, "&Usual Values of the Run"},
                                   {ColourScale::Run, "Largest of the &Run"},
                                   {ColourScale::Moment, "Largest of This &Moment"}}) {
    auto* action = scales->addAction(tr(name), this, [this, kind = kind] {
      setScale({kind, 0.0, 0.0});
    });
    action->setCheckable(true);
    action->setData(static_cast<int>(kind));
    scale_group->addAction(action);
  }
  auto* limits = scales->addAction(tr("&Limits..."), this, &AgoreWindow::askForLimits);
  limits->setCheckable(true);
  limits->setData(static_cast<int>(ColourScale::Typed));
  scale_group->addAction(limits);
  scales->addSeparator();
  scales->addAction(tr("The Ne&xt Scale"), Qt::SHIFT | Qt::Key_C, this, [this] {
    constexpr int kWithoutAsking = 3;
    setScale(
        {static_cast<ColourScale>((static_cast<int>(options_.scale.kind) + 1) % kWithoutAsking),
         0.0, 0.0});
  });
}

/// In the unit that the file has the values in, which the question names.
void AgoreWindow::askForLimits() {
  refresh();  // the check mark belongs to what is shown
  if (!picture_) return askForFile();
  const Colouring now = colouring(picture_->animation(), frame_, options_.colour);
  if (!now.any())
    return desktop::show_message(this, tr("Choose first what colours the elements (C)."));
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("limits");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Scale of the Colours"));
  const QString unit = now.unit.empty() ? QString() : " [" + QString::fromStdString(now.unit) + "]";
  dialog->setLabelText(tr("Limits of %1%2, low:high").arg(QString::fromStdString(now.title), unit));
  const auto shown = options_.scale.kind == ColourScale::Typed
                         ? options_.scale
                         : ScaleChoice{ColourScale::Typed, now.low, now.high};
  dialog->setTextValue(QString::fromStdString(scale_name(shown)));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
    try {
      setScale(scale_named(text.simplified().toStdString()));
    } catch (const std::exception& error) {
      desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  });
  dialog->open();
}

/// Typed limits are of one quantity, so they are not remembered.
void AgoreWindow::setScale(const ScaleChoice& scale) {
  options_.scale = scale;
  if (scale.kind != ColourScale::Typed)
    QSettings("Adore", kApp).setValue(kScale, QString::fromStdString(scale_name(scale)));
  refresh();
}

void AgoreWindow::makeBesideMenu(QMenu* menu) {
  menu->setObjectName("besideMenu");
  for (const View view : {View::Bearing, View::Cage, View::Pocket, View::Element, View::OuterRace,
                          View::InnerRace, View::Flange, View::Section, View::Solid}) {
    auto* action = menu->addAction(QString::fromStdString(view_title(view)));
    action->setCheckable(true);
    action->setData(static_cast<int>(view));
    connect(action, &QAction::triggered, this,
            [this, view](bool shown) { setBeside(view, shown); });
  }
  menu->addSeparator();
  menu->addAction(tr("&Four Views, or One"), Qt::Key_V, this, [this] {
    if (!picture_) return askForFile();
    const bool one = options_.beside.empty();
    options_.beside.clear();
    if (one)
      for (const View view :
           {View::Bearing, View::Solid, View::Section, View::Pocket, View::Element})
        if (view != options_.view && options_.beside.size() < 3 &&
            why_not(view, picture_->animation()).empty())
          options_.beside.push_back({view});
    refresh();
  });
}

void AgoreWindow::setBeside(View view, bool shown) {
  if (!picture_) return askForFile();
  std::erase_if(options_.beside, [view](const SideView& side) { return side.view == view; });
  if (shown) {
    constexpr std::size_t kMost = 5;
    const std::string reason = why_not(view, picture_->animation());
    if (!reason.empty())
      desktop::show_message(this, QString::fromStdString(reason));
    else if (options_.beside.size() >= kMost)
      desktop::show_message(this, tr("Six views are the most at a time; take one away first."));
    else
      options_.beside.push_back({view});
  }
  refresh();
}

bool AgoreWindow::shows(View view) const {
  return options_.view == view ||
         std::any_of(options_.beside.begin(), options_.beside.end(),
                     [view](const SideView& side) { return side.view == view; });
}

bool AgoreWindow::openFile(const std::filesystem::path& path, long most_frames) {
  try {
    setAnimation(open_motion(path, most_frames));
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  most_frames_ = most_frames;
  desktop::remember_file(kApp, QString::fromStdString(path.string()));
  const std::string &note = picture_->animation().file.note,
                    &gaps = picture_->animation().file.gaps;
  if (note.empty() && !gaps.empty())
    desktop::show_message(this, tr("Of the file %1.").arg(QString::fromStdString(gaps)));
  if (!note.empty())
    desktop::show_message(this, tr("The file is incomplete: %1. Its %2 complete frames are shown.")
                                    .arg(QString::fromStdString(note))
                                    .arg(frameCount()));
  return true;
}

void AgoreWindow::reload() {
  if (!picture_) return askForFile();
  const double moment = picture_->animation().time[frame_];
  const std::filesystem::path path = picture_->animation().file.path;  // the picture goes with it
  if (!openFile(path, most_frames_)) return;
  setFrame(picture_->frameAt(moment));
  desktop::tell_in_foot(this, tr("Read again: %1 frames to %2.")
                                  .arg(frameCount())
                                  .arg(QString::fromStdString(desktop::pretty_quantity(
                                      picture_->animation().time.back(), "s", 5))));
}

void AgoreWindow::setAnimation(Animation animation) {
  pause();
  auto fresh = std::make_unique<MotionPicture>(std::move(animation));
  if (options_.element > fresh->animation().file.elements) options_.element = 1;
  if (!why_not(options_.view, fresh->animation()).empty()) options_.view = View::Bearing;
  std::erase_if(options_.beside, [&fresh](const SideView& side) {
    return !why_not(side.view, fresh->animation()).empty();
  });
  // The canvas lets go of the old one before it dies.
  const auto old = std::exchange(picture_, std::move(fresh));
  frame_ = 0;
  refresh();
}

void AgoreWindow::setFrame(std::size_t frame) {
  if (!picture_) return;
  frame_ = std::min(frame, frameCount() - 1);
  showFrame();
}

void AgoreWindow::setView(View view, int element) {
  if (!picture_) return askForFile();
  const std::string reason = why_not(view, picture_->animation());
  if (!reason.empty()) return desktop::show_message(this, QString::fromStdString(reason));
  const auto beside = std::find_if(options_.beside.begin(), options_.beside.end(),
                                   [view](const SideView& side) { return side.view == view; });
  if (view != options_.view && beside != options_.beside.end()) {  // the two change places
    const SideView first{options_.view, options_.zoom, options_.pan};
    options_.zoom = beside->zoom;
    options_.pan = beside->pan;
    *beside = first;
  } else if (view != options_.view) {  // a place in one view is none in another
    options_.zoom = 1.0;
    options_.pan = {0.0, 0.0};
  }
  options_.view = view;
  if (element > 0) options_.element = std::min(element, picture_->animation().file.elements);
  refresh();
}

void AgoreWindow::setExaggeration(double factor) {
  options_.exaggeration = factor;
  refresh();
}

void AgoreWindow::setColour(ColourBy colour) {
  if (colour != options_.colour && options_.scale.kind == ColourScale::Typed)
    options_.scale = {};  // limits of another quantity
  options_.colour = colour;
  refresh();
}

void AgoreWindow::setContacts(bool shown) {
  options_.contacts = shown;
  refresh();
}

void AgoreWindow::setTrails(bool shown) {
  options_.trails = shown;
  refresh();
}

void AgoreWindow::setSlowMotion(double rate) {
  slow_ = rate;
  speed_->setEnabled(rate == 0.0);
  if (picture_) film_time_ = picture_->animation().time[frame_];
}

void AgoreWindow::askForElement(View view) {
  if (!picture_) return askForFile();
  if (const std::string reason = why_not(view, picture_->animation()); !reason.empty())
    return desktop::show_message(this, QString::fromStdString(reason));
  const int count = picture_->animation().file.elements;
  const QString what = view == View::Pocket ? tr("Pocket") : tr("Rolling element");
  desktop::ask_number(this, QString::fromStdString(view_title(view)),
                      tr("%1 (1 to %2):").arg(what).arg(count), options_.element, 1, count,
                      [this, view](int number) { setView(view, number); });
}

/// The number first, as the classic tool has it. Nobody who only wants to see a run loses steps by
/// it: all that can be held is what is offered, whatever was asked for before.
void AgoreWindow::askForFile() {
  desktop::ask_number(
      this, tr("Open: steps, then the file"),
      tr("Most time steps to animate. Of a run with more, every 2nd, 3rd ... is shown.\n"
         "The file is chosen next."),
      static_cast<int>(results::MotionFile::kMostFrames), 1, 100'000'000, [this](int steps) {
        desktop::ask_file(
            this, kApp, tr("Open animation file"), "SOL8* RESULTS.h5",
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
  film_time_ = picture_->animation().time[frame_];
  clock_.start();
  timer_.start();
}

void AgoreWindow::advance() {
  const double seconds = static_cast<double>(clock_.restart()) * 1e-3;
  const std::size_t last = frameCount() - 1, end = direction_ > 0 ? last : 0;
  if (slow_ > 0.0) {
    // In the simulation's own time, however unequal the frames lie in it.
    const auto& time = picture_->animation().time;
    film_time_ += direction_ * slow_ * seconds;
    const bool over = direction_ > 0 ? film_time_ >= time.back() : film_time_ <= time.front();
    const auto after = std::upper_bound(time.begin(), time.end(), film_time_);
    setFrame(over
                 ? end
                 : static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - time.begin() - 1)));
  } else {
    pending_ += seconds * speed_->currentData().toDouble();
    const auto due = static_cast<std::size_t>(pending_);
    if (due == 0) return;
    pending_ -= static_cast<double>(due);
    const std::size_t left = direction_ > 0 ? last - frame_ : frame_;
    const std::size_t moved = std::min(due, left);
    setFrame(direction_ > 0 ? frame_ + moved : frame_ - moved);
  }
  if (frame_ != end) return;
  if (loop_ && last > 0)
    play(direction_);
  else
    pause();
}

void AgoreWindow::frameForward() {
  pause();
  if (picture_ && frame_ + 1 < frameCount()) setFrame(frame_ + 1);
}

void AgoreWindow::frameBackward() {
  pause();
  if (frame_ > 0) setFrame(frame_ - 1);
}

void AgoreWindow::pause() {
  const bool was = playing();
  timer_.stop();
  if (was) showFrame();  // the finer picture
}

ViewOptions AgoreWindow::stillOptions() const {
  ViewOptions still = options_;
  still.moving = false;
  return still;
}

/// A name in the folder of what is shown, where pictures of it are looked for.
QString AgoreWindow::besideFile(const QString& name) const {
  return desktop::folder_of(picture_->animation().file.path) + "/" + name;
}

void AgoreWindow::print() {
  if (!picture_) return askForFile();
  pause();
  desktop::print_page(this, [this](QPainter& painter, const QRectF& paper) {
    picture_->paintOnPaper(painter, paper, canvas_->size(), frame_, stillOptions());
  });
}

void AgoreWindow::savePicture() {
  if (!picture_) return askForFile();
  pause();
  desktop::save_picture(
      this, kApp, besideFile(proposedName("jpg")),
      [this] { return picture_->image(canvas_->size(), frame_, stillOptions()); },
      [this] { return picture_->svg(canvas_->size(), frame_, stillOptions()); });
}

QString AgoreWindow::proposedName(const QString& suffix) const {
  QString run = QFileInfo(desktop::folder_of(picture_->animation().file.path)).fileName();
  if (run.isEmpty()) run = "bearing";
  const QString what =
      options_.beside.empty() ? QString::fromStdString(view_name(options_.view)) : QString("views");
  return run + "-" + what + (suffix.isEmpty() ? QString() : "." + suffix);
}

int AgoreWindow::filmRate() const {
  constexpr int kSlowRate = 25;
  return slow_ > 0.0 ? kSlowRate : std::max(1, speed_->currentData().toInt() / filmEvery());
}

/// Players show 50 pictures a second; a faster one shows every n-th frame, so that it lasts as long
/// as the window plays.
int AgoreWindow::filmEvery() const {
  constexpr int kMostRate = 50;
  return slow_ > 0.0 ? 1 : (speed_->currentData().toInt() + kMostRate - 1) / kMostRate;
}

RenderOptions AgoreWindow::filmOptions() const {
  RenderOptions render;
  render.view = stillOptions();
  // As seen, but not larger than a film needs to be.
  const QSize size = canvas_->size().boundedTo({1280, 800});
  render.width = size.width() & ~1;
  render.height = size.height() & ~1;
  render.replace = true;
  render.slow = slow_;  // a film plays as the window does
  return render;
}

void AgoreWindow::saveFilm() {
  if (!picture_) return askForFile();
  pause();
  // One picture tells how long all will take; setting it in a file takes 30 ms (picture-speed.md).
  constexpr double kInFile = 0.03;  // [s]
  const RenderOptions render = filmOptions();
  QElapsedTimer clock;
  clock.start();
  (void)picture_->image({render.width, render.height}, frame_, render.view);
  const double each = 1e-9 * static_cast<double>(clock.nsecsElapsed()) + kInFile;
  const auto tell = [this, render, each](std::size_t first, std::size_t last) {
    RenderOptions part = render;
    part.first = static_cast<int>(first) + 1, part.last = static_cast<int>(last) + 1;
    try {
      const auto pictures =
          static_cast<double>(film_frames(*picture_, filmEvery(), filmRate(), part).size());
      const auto seconds = [](double value) {
        return QString::fromStdString(desktop::pretty_quantity(value, "s", 2));
      };
      return std::pair{
          tr("%1 pictures, %2 a second: a film of %3. Writing takes roughly %4.")
                  .arg(pictures)
                  .arg(filmRate())
                  .arg(seconds(pictures / filmRate()), seconds(each * pictures)) +
              (filmEvery() > 1 ? tr(" It has one of every %1 frames; numbered pictures have all.")
                                     .arg(filmEvery())
                               : QString()),
          true};
    } catch (const std::exception& error) {
      return std::pair{QString::fromUtf8(error.what()), false};
    }
  };
  auto* dialog = new FilmDialog(picture_->animation().time, tell, this);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    askForFilmName(static_cast<int>(dialog->first()) + 1, static_cast<int>(dialog->last()) + 1);
  });
  dialog->open();
}

void AgoreWindow::askForFilmName(int first, int last) {
  const QString missing = tr(" after ffmpeg is installed");
  auto* dialog = new QFileDialog(this, tr("Save Film"), proposedName("gif"),
                                 tr("GIF (*.gif);;AVI (*.avi);;MP4%1 (*.mp4);;Numbered pictures, "
                                    "folder (*)")
                                     .arg(desktop::ffmpeg_found() ? QString() : missing));
  dialog->setObjectName("film");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  // What is chosen below is what the name says: "film" and GIF make film.gif, no folder.
  const auto name_as = [this, dialog](const QString& filter) {
    const QString suffix = QRegularExpression("\\*\\.(\\w+)").match(filter).captured(1);
    const QString base =
        QFileInfo(dialog->selectedFiles().value(0, proposedName({}))).completeBaseName();
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(suffix.isEmpty() ? base : base + "." + suffix);
  };
  dialog->selectFile(besideFile(proposedName("gif")));
  name_as(dialog->selectedNameFilter());
  connect(dialog, &QFileDialog::filterSelected, this, name_as);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, dialog, first, last](const QString& name) {
            dialog->hide();  // writing takes its time
            writeFilm(name, first, last);
          });
  dialog->open();
}

bool AgoreWindow::writeFilm(const QString& path, int first, int last) {
  RenderOptions render = filmOptions();
  render.first = first, render.last = last;
  QProgressDialog progress(tr("Writing %1 ...").arg(path), tr("Cancel"), 0,
                           static_cast<int>(frameCount()), this);
  progress.setWindowTitle(tr("Save Film"));
  progress.setWindowModality(Qt::WindowModal);
  progress.setMinimumDuration(500);
  long pictures = 0;
  render.progress = [&progress, &pictures](long done, long total) {
    pictures = done;
    progress.setMaximum(static_cast<int>(total));
    progress.setValue(static_cast<int>(done));
  };
  bool stopped = false;
  render.stop = [&progress, &stopped] { return stopped = progress.wasCanceled(); };
  try {
    // Numbered pictures have no rate.
    const int every = QFileInfo(path).suffix().isEmpty() ? 1 : filmEvery();
    render_movie(*picture_, every, filmRate(), path.toStdString(), render);
    const bool folder = QFileInfo(path).isDir();
    if (stopped)
      desktop::tell_in_foot(this,
                            folder ? tr("Stopped: %1 pictures are in %2.").arg(pictures).arg(path)
                                   : tr("Stopped: no film was saved."));
    else
      desktop::tell_in_foot(
          this, folder
                    ? tr("Saved %1 numbered pictures in %2.").arg(pictures).arg(path)
                    : tr("Saved %1: %2 pictures%3.")
                          .arg(path)
                          .arg(pictures)
                          .arg(every > 1 ? tr(", one of every %1 frames").arg(every) : QString()));
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void AgoreWindow::switchTheme() {
  using desktop::ThemeKind;
  options_.dark = !options_.dark;
  desktop::apply_theme(options_.dark ? ThemeKind::Dark : ThemeKind::Light);
  desktop::remember_theme(desktop::current_theme().kind);
  refresh();
}

void AgoreWindow::showFrame() {
  options_.moving = playing();
  canvas_->show(picture_.get(), frame_, options_);
}

void AgoreWindow::refresh() {
  if (picture_ && shows(View::Flange) &&
      !has_flange(picture_->animation(), options_.flange_race, 0) &&
      !has_flange(picture_->animation(), options_.flange_race, 1))
    options_.flange_race = 1 - options_.flange_race;  // one of them has a flange
  showFrame();
  if (auto* beside = findChild<QMenu*>("besideMenu"))
    for (QAction* action : beside->actions())
      if (action->isCheckable()) {
        const auto view = static_cast<View>(action->data().toInt());
        action->setChecked(std::any_of(options_.beside.begin(), options_.beside.end(),
                                       [view](const SideView& side) { return side.view == view; }));
      }
  for (const char* name : {"play", "playBack", "frame", "frameBack", "pause", "print", "save"})
    findChild<QPushButton*>(name)->setEnabled(picture_ != nullptr);
  if (auto* scales = findChild<QMenu*>("scaleMenu"))
    for (QAction* action : scales->actions())
      if (action->isCheckable())
        action->setChecked(action->data().toInt() == static_cast<int>(options_.scale.kind));
  if (picture_) {
    // Runs are told apart by their folders, as in AdrInput.
    const std::filesystem::path& file = picture_->animation().file.path;
    const auto named = std::filesystem::absolute(file).parent_path().filename() / file.filename();
    setWindowTitle(QString::fromStdString(named.string() + " — " + view_title(options_.view)) +
                   " — AGORE");
  }
}

}  // namespace adore::agore

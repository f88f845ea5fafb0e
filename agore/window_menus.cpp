#include "agore/agore_window.hpp"
#include "agore/view_bar.hpp"
#include "agore/view_scene.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/link_action.hpp"
#include "desktop/spoken_name.hpp"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

/// Menus, keys and buttons of the window.
namespace adore::agore {

/// Each button triggers an action of the menus, whose key may be held down.
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
  playback_rate_box_ = new QComboBox(column);
  playback_rate_box_->setObjectName("speed");
  desktop::set_accessible_name(*playback_rate_box_, tr("Frames per second"));
  playback_rate_box_->setFocusPolicy(Qt::NoFocus);
  for (const int rate : {2, 5, 10, 25, 50, 100, 250, 1000})
    playback_rate_box_->addItem(QString::number(rate), rate);
  playback_rate_box_->setCurrentText("25");
  layout->addWidget(playback_rate_box_);
  layout->addWidget(new QLabel(tr("Slow motion"), column));
  slow_motion_box_ = new QComboBox(column);
  slow_motion_box_->setObjectName("slow");
  desktop::set_accessible_name(*slow_motion_box_, tr("Slow motion"));
  slow_motion_box_->setFocusPolicy(Qt::NoFocus);
  slow_motion_box_->addItem(tr("by frames"), 0.0);
  for (const int part : {10, 100, 1000, 5000, 20000})
    slow_motion_box_->addItem(QString("1/%1").arg(part), 1.0 / part);
  connect(slow_motion_box_, &QComboBox::currentIndexChanged, this,
          [this] { setSlowMotion(slow_motion_box_->currentData().toDouble()); });
  layout->addWidget(slow_motion_box_);
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
  scroll->setVisible(findChild<QAction*>("buttonsAction")->isChecked());
  return scroll;
}

/// An action that is triggered by the button of the same name.
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
  file->addAction(tr("Open Pro&ject..."), Qt::CTRL | Qt::SHIFT | Qt::Key_O, this,
                  &AgoreWindow::askForProject);
  QMenu* runs = file->addMenu(tr("Project R&uns"));
  runs->setObjectName("projectMenu");
  runs->setEnabled(false);
  file->addAction(tr("Re&load"), Qt::Key_F5, this, &AgoreWindow::reload);
  follow_action_ = file->addAction(tr("&Follow a Running Solver"));  // as AdrPlot has it
  follow_action_->setObjectName("followAction");
  follow_action_->setShortcut(Qt::Key_F);
  follow_action_->setCheckable(true);
  connect(follow_action_, &QAction::toggled, this, &AgoreWindow::follow);
  // Only a choice of the user is stored: the command line applies once.
  connect(follow_action_, &QAction::triggered, this,
          [](bool on) { QSettings("Adore", kApp).setValue(kFollow, on); });
  file->addSeparator();
  add(file, tr("&Save Picture..."), "save", QKeySequence::Save, [this] { savePicture(); });
  file->addAction(tr("Save &Movie..."), Qt::CTRL | Qt::Key_E, this, &AgoreWindow::saveMovie);
  file->addAction(tr("Save &3D Scene for Browsers..."), Qt::CTRL | Qt::SHIFT | Qt::Key_E, this,
                  &AgoreWindow::saveScene);
  add(file, tr("&Print..."), "print", QKeySequence::Print, [this] { print(); });
  file->addSeparator();
  add(file, tr("&Quit"), "quit", Qt::CTRL | Qt::Key_Q, [this] { close(); });
  makeViewMenu(menuBar()->addMenu(tr("&View")));
  makeMotionMenu(menuBar()->addMenu(tr("&Motion")));
  desktop::add_help_menu(
      *this, "AGORE",
      tr("AGORE shows the motion of a bearing from SOL8 or RESULTS.h5\n(files of program version "
         "%1 or later).")
          .arg(kLowestVersion),
      {{tr("Space, Shift+Space"), tr("play or pause, play backward")},
       {tr("P"), tr("pause")},
       {tr("Right, Left"), tr("next or previous frame (hold to repeat)")},
       {tr("Home, End"), tr("first or last frame")},
       {tr("Up, Down"), tr("next or previous element or pocket (with its cage segment)")},
       {tr("[, ]"), tr("slower, faster")},
       {tr("S"), tr("next slow-motion factor")},
       {tr("R"), tr("repeat")},
       {tr("A, B, X"), tr("set the start or the end of the repeated range, or remove it")},
       {tr("Shift+drag in the time bar or a curve"), tr("set the repeated range")},
       {tr("1 to 9, Ctrl+7, Ctrl+8"), tr("select a view of the menu View")},
       {tr("V"), tr("four views or one view")},
       {tr("H, G, K"), tr("show or hide the heading, chart or legend")},
       {tr("I, click on an element"), tr("show or hide the values of an element")},
       {tr("W, U"), tr("show or hide the view bar or the control buttons")},
       {tr("L, T"), tr("show race loads or paths of all elements")},
       {tr("C, Shift+C"), tr("next element coloring or color scale")},
       {tr("+ or =, -, 0"), tr("zoom in or out in the first view, or show all")},
       {tr("Ctrl+arrow key"), tr("move the first view, or rotate a 3D view")},
       {tr("click or drag in the time bar or a curve"), tr("go to this time")},
       {tr("wheel, drag, double click on a picture"), tr("zoom, move, show all")},
       {tr("drag, Shift+drag in the 3D view"), tr("rotate, move")},
       {tr("hollow end of the rotation mark of a ball"),
        tr("this end is on the far side of the ball")},
       {tr("band around a curve"), tr("minimum to maximum between stored steps")},
       {tr("Ctrl+E"), tr("save a movie")},
       {tr("Ctrl+Shift+E"), tr("save the 3D scene as a page for a browser")},
       {tr("Ctrl+Shift+O"), tr("open a project and list its runs in the menu File")},
       {tr("F5, F"), tr("reload the file, or follow an active run")}});
}

void AgoreWindow::makeMotionMenu(QMenu* menu) {
  add(menu, tr("&Play or Pause"), "play", Qt::Key_Space, [this] {
    playing() ? pause() : playForward();
  })->setAutoRepeat(false);
  add(menu, tr("Play &Backward"), "playBack", Qt::SHIFT | Qt::Key_Space, [this] {
    playBackward();
  })->setAutoRepeat(false);
  add(menu, tr("P&ause"), "pause", Qt::Key_P, [this] { pause(); });
  add(menu, tr("Ne&xt Frame"), "frame", Qt::Key_Right, [this] { frameForward(); });
  add(menu, tr("Prev&ious Frame"), "frameBack", Qt::Key_Left, [this] { frameBackward(); });
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
  const auto pace = [this, step](int by) {
    if (slow_motion_rate_ == 0.0) return step(playback_rate_box_, by);
    // From one picture per frame to the slowest motion.
    if (by < 0 || slow_motion_box_->currentIndex() > 1) step(slow_motion_box_, -by);
  };
  menu->addAction(tr("&Slower"), Qt::Key_BracketLeft, this, [pace] { pace(-1); });
  menu->addAction(tr("Fas&ter"), Qt::Key_BracketRight, this, [pace] { pace(1); });
  menu->addAction(tr("Slow &Motion"), Qt::Key_S, this, [this] {
    slow_motion_box_->setCurrentIndex((slow_motion_box_->currentIndex() + 1) %
                                      slow_motion_box_->count());
  });
  repeat_action_ = menu->addAction(tr("&Repeat"));
  repeat_action_->setShortcut(Qt::Key_R);
  repeat_action_->setCheckable(true);
  connect(repeat_action_, &QAction::toggled, this, &AgoreWindow::setLoop);
  menu->addAction(tr("Repeat From &Here"), Qt::Key_A, this, [this] { setRepeatLimit(true); });
  menu->addAction(tr("Repeat to H&ere"), Qt::Key_B, this, [this] { setRepeatLimit(false); });
  menu->addAction(tr("&Delete Repeat Range"), Qt::Key_X, this, [this] { setRepeatRange({}, {}); });
}

/// Key commands for mouse wheel and pointer, for the first picture.
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
  menu->addAction(tr("Show En&tire Picture"), Qt::Key_0, this, [this] {
    options_.zoom = 1.0;
    options_.pan = {0.0, 0.0};
    options_.yaw = ViewOptions{}.yaw;
    options_.elevation = ViewOptions{}.elevation;
    showFrame();
  });
  auto* moves = menu->addMenu(tr("&Move or Rotate"));
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
        return desktop::show_message(this, tr("This race has no flange."));
      askForElement(View::Flange, race_index);
    });
  menu->addAction(tr("Axial &Section..."), Qt::Key_8, this,
                  [this] { askForElement(View::Section); });
  menu->addAction(tr("&3D View..."), Qt::Key_9, this, [this] { askForElement(View::Solid); });
  menu->addAction(tr("Racewa&y Contacts"), Qt::CTRL | Qt::Key_8, this,
                  [this] { setView(View::Raceways); });
  makeAdditionalViewsMenu(menu->addMenu(tr("Add&itional Views")));
  makePartsMenu(menu->addMenu(tr("Sho&wn Parts")));
  menu->addSeparator();
  addZoomKeys(menu);
  menu->addSeparator();
  makeColourMenus(menu);
  auto* contacts = menu->addAction(tr("Race Loads on All &Elements"));
  contacts->setObjectName("contactsAction");
  contacts->setCheckable(true);
  contacts->setShortcut(Qt::Key_L);
  connect(contacts, &QAction::toggled, this, &AgoreWindow::setLoadArrowsShown);
  auto* trails = menu->addAction(tr("Element Pat&hs"));
  trails->setObjectName("trailsAction");
  trails->setCheckable(true);
  trails->setShortcut(Qt::Key_T);
  connect(trails, &QAction::toggled, this, &AgoreWindow::setTrails);
  menu->setToolTipsVisible(true);
  menu->addSeparator();
  auto* clearances = menu->addMenu(tr("C&learances"));
  clearances->setObjectName("clearanceMenu");
  auto* group = new QActionGroup(this);
  for (const double factor : {0.0, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    auto* action = clearances->addAction(factor == 0.0   ? tr("Automatic")
                                         : factor == 1.0 ? tr("To scale")
                                                         : QString("× %1").arg(factor),
                                         this, [this, factor] { setExaggeration(factor); });
    action->setCheckable(true);
    action->setChecked(factor == 0.0);
    action->setData(factor);
    group->addAction(action);
  }
  desktop::add_link_action(*menu, *link_, kApp);
  menu->addAction(tr("&Dark/Light"), Qt::CTRL | Qt::Key_D, this, &AgoreWindow::switchTheme);
}

/// Parts of the picture and of the window that leave their space to the bodies when hidden. A
/// choice of the user is stored.
void AgoreWindow::makePartsMenu(QMenu* menu) {
  const auto part = [&](const QString& text, const QString& brief, const char* name, Qt::Key key,
                        std::function<void(bool)> show) {
    QAction* action = menu->addAction(text);
    action->setObjectName(QString(name) + "Action");
    action->setShortcut(key);
    action->setCheckable(true);
    action->setChecked(QSettings("Adore", kApp).value(QString("shown/") + name, true).toBool());
    show(action->isChecked());
    connect(action, &QAction::toggled, this, show);
    connect(action, &QAction::triggered, this,
            [name](bool on) { QSettings("Adore", kApp).setValue(QString("shown/") + name, on); });
    if (!brief.isEmpty()) bar_->addSwitch(action, brief);
  };
  const auto of_picture = [this](bool ShownParts::*which) {
    return [this, which](bool on) {
      if (options_.shown.*which == on) return;
      options_.shown.*which = on;
      showFrame();
    };
  };
  part(tr("&Heading"), tr("Heading"), "heading", Qt::Key_H, of_picture(&ShownParts::heading));
  part(tr("&Chart"), tr("Chart"), "chart", Qt::Key_G, of_picture(&ShownParts::chart));
  part(tr("&Legend"), tr("Legend"), "key", Qt::Key_K, of_picture(&ShownParts::key));
  QAction* values = menu->addAction(tr("V&alues of the Element"));
  values->setObjectName("valuesAction");
  values->setShortcut(Qt::Key_I);
  values->setCheckable(true);
  connect(values, &QAction::toggled, this, &AgoreWindow::setValuesShown);
  bar_->addSwitch(values, tr("Values"));
  part(tr("&View Bar"), {}, "bar", Qt::Key_W, [this](bool on) { bar_->setVisible(on); });
  part(tr("Control &Buttons"), {}, "buttons", Qt::Key_U, [this](bool on) {
    if (buttons_ != nullptr) buttons_->setVisible(on);
  });
}

void AgoreWindow::makeColourMenus(QMenu* menu) {
  auto* colours = menu->addMenu(tr("C&olor Elements by"));
  colours->setObjectName("colourMenu");
  auto* colour_group = new QActionGroup(this);
  for (const auto& [by, name] : {std::pair{ColourBy::None, "&Nothing"},
                                 {ColourBy::Load, "Contact &Load"},
                                 {ColourBy::Slip, "Largest &Slip"},
                                 {ColourBy::Heat, "Contact &Heat"},
                                 {ColourBy::Temperature, "Contact &Temperature"},
                                 {ColourBy::Pressure, "Contact &Pressure"}}) {
    auto* action = colours->addAction(tr(name), this, [this, by = by] { setColorQuantity(by); });
    action->setCheckable(true);
    action->setChecked(by == ColourBy::None);
    action->setData(static_cast<int>(by));
    colour_group->addAction(action);
  }
  colours->addSeparator();
  colours->addAction(tr("Ne&xt Coloring"), Qt::Key_C, this, [colour_group] {
    const auto all = colour_group->actions();
    all[(all.indexOf(colour_group->checkedAction()) + 1) % all.size()]->trigger();
  });
  auto* scales = menu->addMenu(tr("Ran&ge of Colors"));
  scales->setObjectName("scaleMenu");
  auto* scale_group = new QActionGroup(this);
  for (const auto& [kind, name] : {std::pair{ColorScaleKind::Usual, "95 % of the Val&ues"},
                                   {ColorScaleKind::Run, "Range of the &Run"},
                                   {ColorScaleKind::Moment, "Range of This Fra&me"}}) {
    auto* action = scales->addAction(tr(name), this, [this, kind = kind] {
      setDefaultColorScale({kind, 0.0, 0.0});
    });
    action->setCheckable(true);
    action->setData(static_cast<int>(kind));
    scale_group->addAction(action);
  }
  auto* limits = scales->addAction(tr("&Limits..."), this, &AgoreWindow::askForColorLimits);
  limits->setCheckable(true);
  limits->setData(static_cast<int>(ColorScaleKind::Typed));
  scale_group->addAction(limits);
  scales->addSeparator();
  scales->addAction(tr("Ne&xt Scale"), Qt::SHIFT | Qt::Key_C, this, [this] {
    constexpr int kWithoutAsking = 3;
    setDefaultColorScale(
        {static_cast<ColorScaleKind>((static_cast<int>(options_.scale.kind) + 1) % kWithoutAsking),
         0.0, 0.0});
  });
}

void AgoreWindow::makeAdditionalViewsMenu(QMenu* menu) {
  menu->setObjectName("besideMenu");
  for (const View view :
       {View::Bearing, View::Cage, View::Pocket, View::Element, View::OuterRace, View::InnerRace,
        View::Flange, View::Section, View::Solid, View::Raceways}) {
    auto* action = menu->addAction(QString::fromStdString(view_title(view)));
    action->setCheckable(true);
    action->setData(static_cast<int>(view));
    connect(action, &QAction::triggered, this,
            [this, view](bool shown) { setAdditionalView(view, shown); });
  }
  menu->addSeparator();
  menu->addAction(tr("&Four Views or One View"), Qt::Key_V, this, [this] {
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

}  // namespace adore::agore

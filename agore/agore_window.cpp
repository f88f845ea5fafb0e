#include "agore/agore_window.hpp"

#include "agore/element_panel.hpp"
#include "agore/render.hpp"
#include "agore/view_bar.hpp"
#include "agore/view_scene.hpp"
#include "base/errors.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/file_drops.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/menu_keys.hpp"
#include "desktop/one_window.hpp"
#include "desktop/window_place.hpp"
#include "results/run_findings.hpp"

#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <utility>

namespace adore::agore {
namespace {
constexpr const char* kScale = "colours/scale";
constexpr int kTick = 16;  // [ms] between pictures: 60 a second
constexpr std::size_t kMostBeside = 5;
}  // namespace

AgoreWindow::AgoreWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowTitle("AGORE");
  desktop::resize_to_fit_screen(*this, {1320, 820});
  options_.dark = desktop::current_theme().kind == desktop::ThemeKind::Dark;
  desktop::accept_file_drops(*this, [this](const QStringList& files) {
    if (files.size() > 1)
      desktop::show_message(this, tr("Drop one file or one run folder at a time."));
    else
      openFile(files.front().toStdString());
  });
  picture_widget_ = new PictureWidget(this);
  panel_ = new ElementPanel(picture_widget_);
  panel_->hide();
  connect(panel_, &ElementPanel::closed, this, [this] { setValuesShown(false); });
  connect(picture_widget_, &PictureWidget::elementPicked, this, [this](std::size_t element) {
    setView(options_.view, static_cast<int>(element) + 1);
    setValuesShown(true);
  });
  bar_ = new ViewBar(this);
  addToolBar(bar_);
  connect(bar_, &ViewBar::chosen, this, [this](View view) { setView(view); });
  auto* centre = new QWidget(this);
  auto* row = new QHBoxLayout(centre);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* picture = new QVBoxLayout;
  picture->setSpacing(0);
  findings_ = new desktop::FindingsBar(this);
  connect(findings_, &desktop::FindingsBar::chosen, this, &AgoreWindow::goToFinding);
  picture->addWidget(picture_widget_, 1);
  picture->addWidget(findings_);
  row->addLayout(picture, 1);
  makeLink();
  makeMenus();
  buttons_ = makeButtons();
  new desktop::MenuKeys(*this);
  row->addWidget(buttons_);
  setCentralWidget(centre);
  timer_.setInterval(kTick);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &AgoreWindow::advance);
  connect(picture_widget_, &PictureWidget::progressRequested, this, [this](double progress) {
    const auto& time = picture_->animation().time;
    const double wanted = time.front() + progress * (time.back() - time.front());
    const auto after = std::lower_bound(time.begin(), time.end(), wanted);
    setFrame(static_cast<std::size_t>(
        std::min<std::ptrdiff_t>(after - time.begin(), std::ssize(time) - 1)));
  });
  connect(picture_widget_, &PictureWidget::frameRequested, this, &AgoreWindow::setFrame);
  connect(picture_widget_, &PictureWidget::viewMoved, this,
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
  connect(picture_widget_, &PictureWidget::repeatRangeMarked, this, &AgoreWindow::setRepeatRange);
  connect(picture_widget_, &PictureWidget::eyeMoved, this, [this](double yaw, double elevation) {
    options_.yaw = yaw;
    options_.elevation = elevation;
    showFrame();
  });
  try {
    options_.scale =
        parse_color_scale(QSettings("Adore", kApp).value(kScale, "usual").toString().toStdString());
  } catch (const std::exception&) {
    options_.scale = {};  // settings of another program version
  }
  connect(&file_check_timer_, &QTimer::timeout, this, &AgoreWindow::checkForFileChanges);
  follow_action_->setChecked(QSettings("Adore", kApp).value(kFollow, false).toBool());
  // The status bar is visible only with a message: otherwise the picture uses its space.
  statusBar()->setSizeGripEnabled(false);
  statusBar()->hide();
  connect(statusBar(), &QStatusBar::messageChanged, this,
          [this](const QString& text) { statusBar()->setVisible(!text.isEmpty()); });
  refresh();
}

AgoreWindow::~AgoreWindow() = default;

/// In the unit that the file has the values in, which the question names.
void AgoreWindow::askForColorLimits() {
  refresh();  // the check mark shows the displayed state
  if (!picture_) return askForFile();
  const ElementColors now = element_colors(picture_->animation(), frame_, options_.colour);
  if (!now.any()) return desktop::show_message(this, tr("Select element colors first (key C)."));
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("limits");
  desktop::delete_when_done(*dialog);
  dialog->setWindowTitle(tr("Color Scale"));
  const QString unit = now.unit.empty() ? QString() : " [" + QString::fromStdString(now.unit) + "]";
  dialog->setLabelText(
      tr("Limits of %1%2 as low:high").arg(QString::fromStdString(now.title), unit));
  const auto shown = options_.scale.kind == ColorScaleKind::Typed
                         ? options_.scale
                         : ColorScaleChoice{ColorScaleKind::Typed, now.low, now.high};
  dialog->setTextValue(QString::fromStdString(scale_name(shown)));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
    try {
      setColorScale(parse_color_scale(text.simplified().toStdString()));
    } catch (const std::exception& error) {
      desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  });
  dialog->open();
}

void AgoreWindow::setColorScale(const ColorScaleChoice& scale) {
  options_.scale = scale;
  refresh();
}

/// In the menu, for later sessions, too. Typed limits are of one quantity, so they never are.
void AgoreWindow::setDefaultColorScale(const ColorScaleChoice& scale) {
  QSettings("Adore", kApp).setValue(kScale, QString::fromStdString(scale_name(scale)));
  setColorScale(scale);
}

void AgoreWindow::setAdditionalView(View view, bool shown) {
  if (!picture_) return askForFile();
  std::erase_if(options_.beside, [view](const AdditionalView& side) { return side.view == view; });
  if (shown) {
    const std::string reason = why_not(view, picture_->animation());
    if (!reason.empty())
      desktop::show_message(this, QString::fromStdString(reason));
    else if (options_.beside.size() >= kMostBeside)
      desktop::show_message(this, tr("At most six views are possible. Remove a view first."));
    else
      options_.beside.push_back({view});
  }
  refresh();
}

bool AgoreWindow::shows(View view) const {
  return options_.view == view ||
         std::any_of(options_.beside.begin(), options_.beside.end(),
                     [view](const AdditionalView& side) { return side.view == view; });
}

void AgoreWindow::setFrame(std::size_t frame) {
  if (!picture_) return;
  frame_ = std::min(frame, frameCount() - 1);
  showFrame();
}

/// Findings of the body of the view come first.
void AgoreWindow::sortFindingsForView() {
  const View view = options_.view;
  const int element = options_.element;
  findings_->setCurrentPage(
      [view, element](const Finding& one) {
        const auto names = [&](const char* word) {
          return one.body.find(word) != std::string::npos;
        };
        switch (view) {
          case View::Cage:
            return names("cage");
          case View::Pocket:
            return names("cage") || desktop::parse_element_number(one.body) == element;
          case View::Element:
            return desktop::parse_element_number(one.body) == element;
          case View::OuterRace:
            return names("outer race");
          case View::InnerRace:
            return names("inner race");
          default:
            return false;
        }
      },
      tr("This view"));
}

void AgoreWindow::goToFinding(const Finding& finding) {
  if (!picture_) return;
  pause();
  if (finding.time) setFrame(picture_->frameAt(*finding.time));
  const auto go = [&](View view, int element) {
    if (why_not(view, picture_->animation()).empty()) setView(view, element);
  };
  const int element = desktop::parse_element_number(finding.body);
  if (finding.body.starts_with("cage"))
    go(element > 0 ? View::Pocket : View::Cage, element);
  else if (element > 0)
    go(View::Element, element);
  else if (finding.body.find("outer race") != std::string::npos)
    go(View::OuterRace, 0);
  else if (finding.body.find("inner race") != std::string::npos)
    go(View::InnerRace, 0);
  statusBar()->showMessage(desktop::finding_text(finding), 20000);
}

void AgoreWindow::setView(View view, int element) {
  if (!picture_) return askForFile();
  const std::string reason = why_not(view, picture_->animation());
  if (!reason.empty()) return desktop::show_message(this, QString::fromStdString(reason));
  const auto beside =
      std::find_if(options_.beside.begin(), options_.beside.end(),
                   [view](const AdditionalView& side) { return side.view == view; });
  if (view != options_.view && beside != options_.beside.end()) {  // the two change places
    const AdditionalView first{options_.view, options_.zoom, options_.pan};
    options_.zoom = beside->zoom;
    options_.pan = beside->pan;
    *beside = first;
  } else if (view != options_.view) {  // a position in one view has no meaning in another
    options_.zoom = 1.0;
    options_.pan = {0.0, 0.0};
  }
  options_.view = view;
  if (element > 0) options_.element = std::min(element, picture_->animation().file.elements);
  refresh();
}

bool AgoreWindow::applyViewOptions(const ViewOptions& asked) {
  if (!picture_) return false;
  ViewOptions next = asked;
  next.dark = options_.dark;
  next.scale = options_.scale;  // as chosen last
  next.shown = options_.shown;
  try {
    if (next.beside.size() > kMostBeside)
      throw InputError("At most six views are possible. Select fewer views.");
    for (std::size_t i = 0; i <= next.beside.size(); ++i)
      check_view(picture_->animation(), next.tile(i));
  } catch (const InputError& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  options_ = next;
  if (asked.scale == ColorScaleChoice{})
    refresh();
  else
    setColorScale(asked.scale);
  return true;
}

void AgoreWindow::setExaggeration(double factor) {
  options_.exaggeration = factor;
  refresh();
}

void AgoreWindow::setColorQuantity(ColourBy colour) {
  if (colour != options_.colour && options_.scale.kind == ColorScaleKind::Typed)
    options_.scale = {};  // limits of another quantity
  options_.colour = colour;
  refresh();
}

void AgoreWindow::setLoadArrowsShown(bool shown) {
  options_.contacts = shown;
  refresh();
}

void AgoreWindow::setTrails(bool shown) {
  options_.trails = shown;
  refresh();
}

void AgoreWindow::setShown(const ShownParts& shown) {
  options_.shown = shown;
  refresh();
}

void AgoreWindow::setValuesShown(bool shown) {
  findChild<QAction*>("valuesAction")->setChecked(shown);
  showFrame();
}

/// In the upper left corner of the pictures, where neither legend nor color scale is.
void AgoreWindow::showPanel() {
  const bool shown = picture_ && findChild<QAction*>("valuesAction")->isChecked();
  options_.picked = shown;
  if (!shown) return panel_->hide();
  panel_->show(picture_->animation(), frame_, options_.element);
  panel_->move(MotionPicture::pictureAreas(picture_widget_->rect(), 1, options_.shown)
                   .front()
                   .topLeft()
                   .toPoint());
}

void AgoreWindow::askForElement(View view, std::optional<std::size_t> flange_race) {
  if (!picture_) return askForFile();
  if (const std::string reason = why_not(view, picture_->animation()); !reason.empty())
    return desktop::show_message(this, QString::fromStdString(reason));
  const int count = picture_->animation().file.elements;
  const QString what = view == View::Pocket ? tr("Pocket") : tr("Rolling element");
  desktop::ask_number(this, QString::fromStdString(view_title(view)),
                      tr("%1 (1 to %2):").arg(what).arg(count), options_.element, 1, count,
                      [this, view, flange_race](int number) {
                        if (flange_race) options_.flange_race = *flange_race;
                        setView(view, number);
                      });
}

ViewOptions AgoreWindow::exportViewOptions() const {
  ViewOptions still = options_;
  still.moving = still.picked = still.dark = false;  // files and paper are light
  still.span_from = still.span_to = std::nullopt;    // of the window alone
  return still;
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
  showPanel();
  picture_widget_->show(picture_.get(), frame_, options_);
  sendLinkState(!playing());
}

void AgoreWindow::refresh() {
  if (picture_ && shows(View::Flange)) choose_flange_race(picture_->animation(), options_);
  sortFindingsForView();
  showFrame();
  bar_->sync(options_.view, picture_ ? &picture_->animation() : nullptr);
  if (auto* beside = findChild<QMenu*>("besideMenu"))
    for (QAction* action : beside->actions())
      if (action->isCheckable()) {
        const auto view = static_cast<View>(action->data().toInt());
        action->setChecked(
            std::any_of(options_.beside.begin(), options_.beside.end(),
                        [view](const AdditionalView& side) { return side.view == view; }));
      }
  for (const char* name : {"play", "playBack", "frame", "frameBack", "pause", "print", "save"})
    findChild<QPushButton*>(name)->setEnabled(picture_ != nullptr);
  if (auto* scales = findChild<QMenu*>("scaleMenu"))
    for (QAction* action : scales->actions())
      if (action->isCheckable())
        action->setChecked(action->data().toInt() == static_cast<int>(options_.scale.kind));
  // Options of the command line.
  const auto check = [this](const char* menu, double chosen) {
    for (QAction* action : findChild<QMenu*>(menu)->actions())
      if (action->isCheckable()) action->setChecked(action->data().toDouble() == chosen);
  };
  check("colourMenu", static_cast<int>(options_.colour));
  check("clearanceMenu", options_.exaggeration);
  findChild<QAction*>("contactsAction")->setChecked(options_.contacts);
  findChild<QAction*>("trailsAction")->setChecked(options_.trails);
  for (const auto& [name, shown] : {std::pair{"headingAction", options_.shown.heading},
                                    {"chartAction", options_.shown.chart},
                                    {"keyAction", options_.shown.key}})
    findChild<QAction*>(name)->setChecked(shown);
  if (picture_) {
    // Runs are distinguished by their folders, as in AdrInput.
    const std::filesystem::path& file = picture_->animation().file.path;
    const auto named = std::filesystem::absolute(file).parent_path().filename() / file.filename();
    setWindowTitle(QString::fromStdString(named.string() + " — " + view_title(options_.view)) +
                   (file_check_timer_.isActive() ? tr(" (followed)") : QString()) + " — AGORE");
  }
}

}  // namespace adore::agore

#include "adrinput/run_time_bar.hpp"

#include "adrinput/qt_text.hpp"
#include "adrinput/wheel_guard.hpp"
#include "desktop/flow_layout.hpp"
#include "desktop/run_link.hpp"
#include "desktop/stored_rate.hpp"

#include <QBoxLayout>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <exception>

namespace adore::adrinput {
namespace {

constexpr int kReadPause = 25;  // [ms]

/// Changes with each write of the file.
std::string stamp_of(const std::filesystem::path& file) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  if (error) return {};
  const auto size = std::filesystem::file_size(file, error);
  return file.string() + ' ' + std::to_string(time.time_since_epoch().count()) + ' ' +
         std::to_string(error ? 0 : size);
}

}  // namespace

RunTimeBar::RunTimeBar(QWidget* parent)
    : QWidget(parent),
      link_(new desktop::RunLink(this)),
      controls_(new QWidget(this)),
      slider_(new QSlider(Qt::Horizontal, controls_)),
      time_box_(new QDoubleSpinBox(controls_)),
      element_box_(new QSpinBox(controls_)),
      text_(new QLabel(this)),
      delay_timer_(new QTimer(this)) {
  delay_timer_->setSingleShot(true);
  delay_timer_->setInterval(kReadPause);
  connect(delay_timer_, &QTimer::timeout, this, &RunTimeBar::showValues);
  connect(link_, &desktop::RunLink::told, this, &RunTimeBar::applyLinkState);
  auto* row = new desktop::FlowLayout(controls_);
  row->setContentsMargins(0, 0, 0, 0);
  const auto field = [&](const QString& name, QWidget* widget, const char* object,
                         const QString& help) {
    auto* label = new QLabel(name, controls_);
    label->setBuddy(widget);
    widget->setObjectName(object);
    widget->setAccessibleName(name);
    widget->setToolTip(help);
    row->addWidget(label);
    row->addWidget(widget);
  };
  const QString shared = tr("Windows of AdrPlot and AGORE that show this run follow.");
  field(tr("Time"), time_box_, "run-time",
        tr("Time of the values below; the nearest stored step is used. ") + shared);
  time_box_->setKeyboardTracking(false);
  slider_->setObjectName("run-time-slider");
  slider_->setAccessibleName(tr("Stored step"));
  slider_->setToolTip(tr("Stored step of the values below. ") + shared);
  slider_->setMinimumWidth(120);
  slider_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  row->addWidget(slider_);
  field(tr("Element"), element_box_, "run-element",
        tr("Rolling element of the values below. ") + shared);
  for (QWidget* one : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(time_box_),
                       static_cast<QWidget*>(element_box_)})
    new WheelGuard(one);
  text_->setObjectName("run-values");
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 4);
  column->addWidget(controls_);
  column->addWidget(text_);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int step) { chooseStep(static_cast<std::size_t>(step)); });
  connect(time_box_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (values_) chooseStep(values_->step_at(value * time_unit_));
  });
  connect(element_box_, &QSpinBox::valueChanged, this, [this](int number) {
    link_->tell({{}, number});
    delay_timer_->start();
  });
  hide();
}

double RunTimeBar::time() const { return values_ ? values_->times()[step_] : 0.0; }
int RunTimeBar::element() const { return element_box_->value(); }
QString RunTimeBar::text() const { return text_->text(); }

void RunTimeBar::setRun(const std::filesystem::path& results_h5) {
  file_ = results_h5;
  const bool there = !stamp_of(file_).empty();
  if (!there) {
    values_.reset();
    read_stamp_.clear();
    link_->join({});
  }
  const bool visible = isVisible();
  setVisible(there);
  if (visible && there) read();
}

void RunTimeBar::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  read();
}

void RunTimeBar::read() {
  const std::string stamp = stamp_of(file_);
  if (stamp.empty() || stamp == read_stamp_) return;
  read_stamp_ = stamp;
  delay_timer_->stop();
  values_.reset();
  try {
    values_ = std::make_unique<RunMotionValues>(file_);
  } catch (const std::exception& error) {
    controls_->hide();
    text_->setText(tr("Values of the run cannot be shown: %1").arg(text_of(error.what())));
    return link_->join({});
  }
  controls_->show();
  const std::vector<double>& times = values_->times();
  const bool seconds = times.back() >= 10.0;
  time_unit_ = seconds ? 1.0 : 1e-3;
  const double interval = desktop::median_interval(times) / time_unit_;
  constexpr int kDecimalsLimit = 9;
  {
    const QSignalBlocker quiet_time(time_box_), quiet_slider(slider_), quiet_element(element_box_);
    time_box_->setSuffix(seconds ? tr(" s") : tr(" ms"));
    time_box_->setDecimals(
        interval > 0.0
            ? std::clamp(1 - static_cast<int>(std::floor(std::log10(interval))), 0, kDecimalsLimit)
            : 3);
    time_box_->setRange(times.front() / time_unit_, times.back() / time_unit_);
    time_box_->setSingleStep(interval > 0.0 ? interval : 1.0);
    slider_->setRange(0, static_cast<int>(times.size()) - 1);
    slider_->setPageStep(std::max(1, static_cast<int>(times.size()) / 20));
    element_box_->setRange(1, std::max(1, values_->elements()));
  }
  step_ = times.size() - 1;
  showStep();
  showValues();
  std::error_code none;
  const std::filesystem::path place = std::filesystem::canonical(file_, none);
  link_->join(none ? QString() : QString::fromStdString(place.parent_path().string()));
  applyLinkState(link_->state());  // a new run in the same folder keeps the time
}

/// A change of the user in this window.
void RunTimeBar::chooseStep(std::size_t step) {
  if (!values_ || step >= values_->times().size() || step == step_) return showStep();
  step_ = step;
  showStep();
  link_->tell({time(), {}});
  delay_timer_->start();
}

void RunTimeBar::applyLinkState(const desktop::LinkState& change) {
  if (!values_ || change.empty()) return;
  if (change.time) step_ = values_->step_at(*change.time);
  if (change.element && *change.element <= values_->elements()) {
    const QSignalBlocker quiet(element_box_);
    element_box_->setValue(*change.element);
  }
  showStep();
  delay_timer_->start();
}

void RunTimeBar::showStep() {
  if (!values_) return;
  const QSignalBlocker quiet_time(time_box_), quiet_slider(slider_);
  slider_->setValue(static_cast<int>(step_));
  time_box_->setValue(time() / time_unit_);
}

void RunTimeBar::showValues() {
  if (!values_) return;
  QString text = text_of(values_->position(step_));
  try {
    for (const std::string& line : values_->describe(step_, element())) text += ' ' + text_of(line);
  } catch (const std::exception& error) {
    text += ' ' + text_of(error.what());  // the file has been replaced or damaged since
  }
  text_->setText(text);
}

}  // namespace adore::adrinput

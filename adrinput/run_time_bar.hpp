#pragma once

#include "adrinput/run_motion_values.hpp"
#include "desktop/link_message.hpp"

#include <QString>
#include <QWidget>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QSpinBox;
class QTimer;

namespace adore::desktop {
class RunLink;
}

namespace adore::adrinput {

/// Time and rolling element of a run with motion, and its values there. Windows of AdrPlot and
/// AGORE that show this run share both. Hidden without RESULTS.h5.
class RunTimeBar : public QWidget {
  Q_OBJECT
 public:
  explicit RunTimeBar(QWidget* parent = nullptr);

  /// RESULTS.h5 of the shown run; empty: none. It is read when the bar's tab is visible, and again
  /// when the file has changed.
  void setRun(const std::filesystem::path& results_h5);
  [[nodiscard]] desktop::RunLink& link() { return *link_; }
  [[nodiscard]] bool hasValues() const { return values_ != nullptr; }
  [[nodiscard]] double time() const;
  [[nodiscard]] int element() const;
  [[nodiscard]] QString text() const;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void read();
  void applyLinkState(const desktop::LinkState& change);
  void chooseStep(std::size_t step);
  void showStep();
  void showValues();

  std::filesystem::path file_;
  std::string read_stamp_;  ///< name, time and size of the file that was read
  std::unique_ptr<RunMotionValues> values_;
  std::size_t step_ = 0;
  desktop::RunLink* link_;
  QWidget* controls_;
  QSlider* slider_;
  QDoubleSpinBox* time_box_;
  QSpinBox* element_box_;
  QLabel* text_;
  QTimer* delay_timer_;     ///< values are read after the last of several quick changes
  double time_unit_ = 1.0;  ///< of the time field [s]
};

}  // namespace adore::adrinput

#pragma once

#include <QDialog>
#include <QSize>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QFormLayout;
class QSpinBox;

namespace adore::agore {

/// Content of a movie.
struct MovieSettings {
  std::size_t first = 0, last = 0;  ///< frames, from 0
  int every = 1;                    ///< every n-th frame
  int rate = 25;                    ///< pictures per second
  QSize size;                       ///< [pixels]
};

/// Dialog for range, interval of frames, rate and size of a movie; shows length and file size.
class MovieDialog : public QDialog {
  Q_OBJECT
 public:
  /// Description of a movie, and whether it can be written.
  using DescribeMovie = std::function<std::pair<QString, bool>(const MovieSettings& choice)>;
  /// @param start choice that it begins with; its size is that of the window
  /// @param by_time slow motion: pictures at equal steps of time, so that frames have no interval
  MovieDialog(std::vector<double> time, const MovieSettings& start, bool by_time,
              DescribeMovie tell, QWidget* parent);
  [[nodiscard]] MovieSettings choice() const;
  [[nodiscard]] std::size_t first() const { return choice().first; }
  [[nodiscard]] std::size_t last() const { return choice().last; }

 private:
  struct RangeLimitFields {
    QSpinBox* frame = nullptr;
    QDoubleSpinBox* time = nullptr;  ///< [ms]
  };
  RangeLimitFields makeLimitFields(const QString& name, std::size_t frame);
  void addPictureFields(QFormLayout& form, const MovieSettings& start, bool by_time);
  void changed();

  std::vector<double> frame_times_;
  DescribeMovie describe_movie_;
  RangeLimitFields from_, to_;
  QSpinBox *frame_interval_box_ = nullptr, *rate_ = nullptr;
  QComboBox* size_ = nullptr;
  QLabel* length_ = nullptr;
  QPushButton* ok_button_ = nullptr;
};

}  // namespace adore::agore

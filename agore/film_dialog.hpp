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
struct FilmChoice {
  std::size_t first = 0, last = 0;  ///< frames, from 0
  int every = 1;                    ///< every n-th frame
  int rate = 25;                    ///< pictures per second
  QSize size;                       ///< [pixels]
};

/// Dialog for range, interval of frames, rate and size of a movie; shows length and file size.
class FilmDialog : public QDialog {
  Q_OBJECT
 public:
  /// Description of a movie, and whether it can be written.
  using Tell = std::function<std::pair<QString, bool>(const FilmChoice& choice)>;
  /// @param start choice that it begins with; its size is that of the window
  /// @param by_time slow motion: pictures at equal steps of time, so that frames have no interval
  FilmDialog(std::vector<double> time, const FilmChoice& start, bool by_time, Tell tell,
             QWidget* parent);
  [[nodiscard]] FilmChoice choice() const;
  [[nodiscard]] std::size_t first() const { return choice().first; }
  [[nodiscard]] std::size_t last() const { return choice().last; }

 private:
  struct End {
    QSpinBox* frame = nullptr;
    QDoubleSpinBox* time = nullptr;  ///< [ms]
  };
  End makeEnd(const QString& name, std::size_t frame);
  void addPictures(QFormLayout& form, const FilmChoice& start, bool by_time);
  void changed();

  std::vector<double> time_;
  Tell tell_;
  End from_, to_;
  QSpinBox *every_ = nullptr, *rate_ = nullptr;
  QComboBox* size_ = nullptr;
  QLabel* length_ = nullptr;
  QPushButton* ok_ = nullptr;
};

}  // namespace adore::agore

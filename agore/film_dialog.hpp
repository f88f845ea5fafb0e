#pragma once

#include <QDialog>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace adore::agore {

/// Dialog for the range of a movie, by frames or times; shows the resulting length.
class FilmDialog : public QDialog {
  Q_OBJECT
 public:
  /// Description of a range of frames, and whether it can be a movie.
  using Tell = std::function<std::pair<QString, bool>(std::size_t first, std::size_t last)>;
  /// @param part first and last frame that it begins with, from 0
  FilmDialog(std::vector<double> time, std::pair<std::size_t, std::size_t> part, Tell tell,
             QWidget* parent);
  [[nodiscard]] std::size_t first() const;  ///< from 0
  [[nodiscard]] std::size_t last() const;

 private:
  struct End {
    QSpinBox* frame = nullptr;
    QDoubleSpinBox* time = nullptr;  ///< [ms]
  };
  End makeEnd(const QString& name, std::size_t frame);
  void changed();

  std::vector<double> time_;
  Tell tell_;
  End from_, to_;
  QLabel* length_;
  QPushButton* ok_;
};

}  // namespace adore::agore

#pragma once

#include "agore/animation.hpp"

#include <QFrame>

class QLabel;

namespace adore::agore {

/// Values of one element at the frame that is shown, and the fault frequencies of the run, in a
/// corner of the picture.
class ElementPanel : public QFrame {
  Q_OBJECT
 public:
  explicit ElementPanel(QWidget* parent);
  /// Another file: reads the frequencies of its RUN.json.
  void open(const Animation& animation);
  /// @param element from 1
  void show(const Animation& animation, std::size_t frame, int element);
  [[nodiscard]] QString text() const;

 signals:
  void closed();

 private:
  QLabel *title_, *values_, *frequencies_;
};

/// Rows "contact load | 412.3 N | 398.1 N" of an element; values that the run does not have are
/// left out.
struct ElementRow {
  std::string name, outer, inner;  ///< `inner` empty: one value for the element
};
[[nodiscard]] std::vector<ElementRow> element_rows(const Animation& animation, std::size_t frame,
                                                   int element);

/// "BPFO 107.2 Hz, BPFI ...", computed from the motion if the run has that, else nominal; empty: no
/// RUN.json of this run.
[[nodiscard]] std::string fault_frequency_text(const Animation& animation);

}  // namespace adore::agore

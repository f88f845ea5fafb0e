#pragma once

#include "adrinput/background.hpp"
#include "adrinput/evaluation.hpp"
#include "runs/run_scales.hpp"

#include <QObject>

#include <functional>
#include <optional>

namespace adore::adrinput {

/// Determines in the background the scale of dimensionless times in seconds and revolutions.
class TimeScale : public QObject {
  Q_OBJECT
 public:
  explicit TimeScale(QObject* parent = nullptr) : QObject(parent) {}

  /// Called in the thread of this object with the requested deck; without scales if it has none.
  std::function<void(const deck::Deck&, std::optional<runs::RunScales>)> found;

  /// Does nothing while an earlier question is open.
  void ask(const deck::Deck& deck, const RunOptionValues& options);
  [[nodiscard]] bool busy() const { return background_task_.busy(); }

 private:
  BackgroundTask background_task_;
};

}  // namespace adore::adrinput

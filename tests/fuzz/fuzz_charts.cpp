#include "base/errors.hpp"
#include "desktop/study_chart.hpp"
#include "desktop/theme.hpp"
#include "fuzz_pages.hpp"

#include <QImage>
#include <QPainter>

using namespace adore;
using namespace adore::desktop;

/// CHARTS.json: any bytes give pictures that can be drawn and written as tables, or a sentence.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  testing::start_qt();
  try {
    for (const StudyChart& chart : parse_study_charts(
             std::string(reinterpret_cast<const char*>(data), size), "CHARTS.json")) {
      (void)study_chart_csv(chart);
      (void)chart.title();
      if (!chart.has_content()) continue;
      QImage image(480, 300, QImage::Format_RGB32);
      QPainter painter(&image);
      paint_study(chart, painter, image.size(), theme(ThemeKind::Light));
      (void)runs_at(chart, image.size(), QPointF(240, 150));
    }
  } catch (const InputError&) {
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  return testing::change_json(data, size, most, seed);
}

#include "cli/pictures/study_charts.hpp"

#include "desktop/bootstrap.hpp"
#include "desktop/study_chart.hpp"

#include <fmt/format.h>

namespace adore::cli {

void draw_study(const std::filesystem::path& charts, const std::filesystem::path& folder,
                bool quiet) {
  const std::vector<desktop::StudyChart> list = desktop::read_study_charts(charts);
  desktop::ensure_headless_application();
  for (const desktop::StudyChart& chart : list) {
    const std::filesystem::path file = folder / (chart.name + ".png");
    if (save_picture(chart, file) && !quiet) fmt::print("{}\n", file.string());
  }
}

}  // namespace adore::cli

#include "cli/pictures/study_charts.hpp"

#include "base/terminal_text.hpp"
#include "base/write_folder.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/study_chart.hpp"

#include <fmt/format.h>

namespace adore::cli {

void draw_study_charts(const std::filesystem::path& charts, const std::filesystem::path& folder,
                       bool quiet) {
  const std::vector<desktop::StudyChart> list = desktop::read_study_charts(charts);
  desktop::ensure_headless_application();
  // NAME.study itself must not be a link.
  const WriteFolder place = WriteFolder(folder.parent_path()).folder(folder.filename());
  for (const desktop::StudyChart& chart : list) {
    const WritePath file(place, chart.name + ".png");
    if (save_picture(chart, file) && !quiet) print("{}\n", file.path().string());
  }
}

}  // namespace adore::cli

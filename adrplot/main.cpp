#include "adrplot/plot_window.hpp"
#include "adrplot/render.hpp"
#include "base/errors.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/command_line.hpp"
#include "desktop/disclaimer.hpp"

#include <CLI/CLI.hpp>
#include <QTimer>
#include <fmt/core.h>

using namespace adore;

namespace {

int render(int& argc, char** argv, const std::vector<std::filesystem::path>& files,
           const adrplot::RenderOptions& options) {
  if (files.empty())
    throw InputError(
        "--render needs at least one result file (SOL1 to SOL7, RUN.json or SWEEP.csv) to draw");
  const auto app = desktop::make_application(argc, argv, "adrplot", desktop::Display::Headless);
  for (const auto& path : adrplot::render_plots(files, options)) fmt::print("{}\n", path.string());
  return 0;
}

int show(int& argc, char** argv, const std::vector<std::filesystem::path>& files,
         const results::SolRange& range, adrplot::Abscissa abscissa) {
  const auto app = desktop::make_application(argc, argv, "adrplot", desktop::Display::Window);
  if (!desktop::ask_for_disclaimer("AdrPlot")) return 0;
  adrplot::PlotWindow window;
  window.setAbscissa(abscissa);
  window.show();
  for (const auto& file : files) window.openFile(file, range);
  if (files.empty()) QTimer::singleShot(0, &window, &adrplot::PlotWindow::askForFile);
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli(
      "AdrPlot: plots of the result files SOL1 to SOL7, of the quasi-static solution in RUN.json, "
      "and "
      "of SWEEP.csv. Without --render it opens a window.",
      "adrplot");
  std::vector<std::filesystem::path> files;
  adrplot::RenderOptions options;
  std::string size = "1280x800", abscissa = "rev";
  cli.add_option("FILE", files, "result files: SOL1 to SOL7, RUN.json, SWEEP.csv");
  auto* folder =
      cli.add_option("--render", options.folder,
                     "write the pages as PNG into this folder instead of opening a window");
  cli.add_option("--page", options.page, "only this page")
      ->check(CLI::PositiveNumber)
      ->needs(folder);
  cli.add_option("--from", options.range.from, "first stored step, counted from 1")
      ->check(CLI::PositiveNumber);
  cli.add_option("--to", options.range.to, "last stored step (5000 unless given)")
      ->check(CLI::PositiveNumber);
  cli.add_option("--every", options.range.every, "interval of the stored steps")
      ->check(CLI::PositiveNumber);
  cli.add_option("--size", size, "picture size in pixels, WIDTHxHEIGHT")->needs(folder);
  cli.add_flag("--dark", options.dark, "dark colours")->needs(folder);
  cli.add_option("--abscissa", abscissa, "rev or time")->check(CLI::IsMember({"rev", "time"}));
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return cli.exit(error) == 0 ? 0 : 2;
  }
  return desktop::guarded("adrplot", [&] {
    const auto pixels = desktop::parse_size(size);
    options.width = pixels.width;
    options.height = pixels.height;
    options.view.abscissa =
        abscissa == "time" ? adrplot::Abscissa::Time : adrplot::Abscissa::Revolutions;
    if (!options.folder.empty()) return render(argc, argv, files, options);
    return show(argc, argv, files, options.range, options.view.abscissa);
  });
}

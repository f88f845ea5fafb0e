#include "adrplot/plot_window.hpp"
#include "adrplot/render.hpp"
#include "base/ending.hpp"
#include "base/errors.hpp"
#include "base/terminal_text.hpp"
#include "command_line/program.hpp"
#include "command_line/tree.hpp"
#include "desktop/behind.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/command_line.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/disclaimer.hpp"
#include "desktop/one_window.hpp"
#include "desktop/project.hpp"
#include "desktop/theme.hpp"
#include "desktop/window_place.hpp"

#include <QTimer>
#include <fmt/core.h>

#include <optional>

using namespace adore;

namespace {

int render(int& argc, char** argv, const std::vector<std::filesystem::path>& files,
           adrplot::RenderOptions options) {
  if (files.empty())
    throw InputError(
        "--render needs a result file (SOL1 to SOL7, RUN.json or SWEEP.csv) or the folder of a "
        "study");
  for (const auto& file : files)
    if (desktop::opens_as_project(file))
      throw InputError(file.string() + " is a project. --render needs the folders of its runs");
  exit_on_interrupt();
  const auto app = desktop::make_application(argc, argv, "adrplot", desktop::Display::Headless);
  options.tell = [](const std::string& sentence) {
    print(stderr, "adrplot: note: {}\n", sentence);
  };
  for (const auto& path : adrplot::render_plots(files, options)) print("{}\n", path.string());
  return 0;
}

int show(int& argc, char** argv, const std::vector<std::filesystem::path>& files,
         const adrplot::RenderOptions& options, bool follow, bool behind,
         const std::string& project) {
  const auto app = desktop::make_application(argc, argv, "adrplot", desktop::Display::Window);
  std::optional<desktop::OpenWithoutFocusGuard> unasked;
  if (behind) unasked.emplace();
  const QString folder = !project.empty() ? QString::fromStdString(project)
                         : !files.empty() ? desktop::folder_of(files.front())
                                          : QString();
  // Whoever is the second one for a project leaves it to the first.
  const auto left_to_another = [&] {
    QStringList names;
    if (follow) names << "--follow";
    if (behind) names << desktop::kBehind;
    for (const auto& file : files)
      names << QString::fromStdString(std::filesystem::absolute(file).string());
    return !project.empty() && !files.empty() &&
           desktop::send_to_open_window("adrplot", folder, names);
  };
  if (left_to_another() || !desktop::ask_for_disclaimer("AdrPlot")) return 0;
  // For this session: the setting of the window is kept.
  if (options.dark) desktop::apply_theme(desktop::ThemeKind::Dark);
  adrplot::PlotWindow window;
  std::optional<desktop::SingleWindowServer> one;
  if (!files.empty())
    one.emplace("adrplot", folder, nullptr, [&window](QStringList names) {
      const bool grows = names.removeAll("--follow") > 0;
      const bool to_front = names.removeAll(desktop::kBehind) == 0;
      window.showFiles(names, to_front);
      if (grows) window.follow(true);
    });
  if (one && !one->is_listening() && left_to_another()) return 0;  // started at the same moment
  window.setAbscissa(options.view.abscissa);
  window.setSpectrogramCurve(options.view.spectrogram_of);
  window.setDomain(options.view.domain);
  window.setSpectrum(options.view.spectrum);
  const desktop::WindowGeometryStore memory(window, "adrplot");
  window.show();
  for (const auto& file : files) {
    if (std::filesystem::is_directory(file))
      window.openFolder(QString::fromStdString(file.string()), options.range);
    else
      window.openFile(file, options.range);
  }
  if (options.page > window.pageCount() && window.pageCount() > 0)
    desktop::show_message(&window,
                          QString("Page %1 does not exist. The last page of the file is %2.")
                              .arg(options.page)
                              .arg(window.pageCount()),
                          true);
  else if (options.page > 0)
    window.showPage(options.page);
  if (follow) window.follow(true);
  if (files.empty()) QTimer::singleShot(0, &window, &adrplot::PlotWindow::askForFile);
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  const auto program = command_line::make_program(
      "AdrPlot: plots of result files (SOL1 to SOL7, RUN.json, SWEEP.csv) and studies, in a window "
      "or as PNG files.",
      "adrplot");
  CLI::App& cli = *program;
  std::vector<std::filesystem::path> files;
  adrplot::RenderOptions options;
  std::string size = "1280x800", abscissa = "rev", domain = "history", curve, scale, rows, band,
              orders_of, project;
  cli.add_option("FILE", files,
                 "result files (SOL1 to SOL7, RUN.json, SWEEP.csv, ACCURACY.json), study tables "
                 "(RUNS.csv, STUDY.h5), PROJECT.json, or folders of runs, studies and projects")
      ->type_name("PATH");
  CLI::Option* one_window =
      cli.add_option("--project", project, "reuse one window for all files of this folder")
          ->type_name("DIR")
          ->check(CLI::ExistingDirectory)
          ->needs(cli.get_option("FILE"));
  auto* folder = cli.add_option("--render", options.folder,
                                "write the pages as PNG to this folder instead of opening a window")
                     ->type_name("DIR");
  command_line::at_least(
      cli.add_option("--page", options.page, "page to write (in a window: page to show first)"), 1);
  command_line::at_least(
      cli.add_option("--from", options.range.from, "first stored step to plot, counted from 1"), 1);
  command_line::at_least(cli.add_option("--to", options.range.to,
                                        "last stored step to plot (default: end of the file)"),
                         1);
  command_line::at_least(
      cli.add_option("--every", options.range.every, "plot every n-th stored step"), 1);
  cli.add_option("--size", size, "picture size in pixels, WIDTHxHEIGHT")
      ->capture_default_str()
      ->type_name("SIZE")
      ->needs(folder);
  bool follow = false;
  cli.add_flag("--follow", follow, "reload the files while a run is active")->excludes(folder);
  bool behind = false;
  cli.add_flag("--behind", behind, "open in the background without taking focus")->excludes(folder);
  cli.add_flag("--dark", options.dark, "dark theme");
  command_line::one_of(cli.add_option("--abscissa", abscissa, "horizontal axis")
                           ->capture_default_str()
                           ->type_name("WHAT"),
                       {"rev", "time"});
  command_line::one_of(
      cli.add_option("--domain", domain, "chart type")->capture_default_str()->type_name("WHAT"),
      {"history", "spectrum", "spectrogram", "envelope", "orders"});
  cli.add_option(
         "--curve", curve,
         "curve of the spectrogram: name, part of the name, or number on the page (default: "
         "first curve)")
      ->type_name("CURVE");
  command_line::one_of(
      cli.add_option("--scale", scale,
                     "amplitudes of spectra: in units of the curve, in dB of 1 unit, or relative "
                     "to the maximum (default: units, for spectrograms dB)")
          ->type_name("SCALE"),
      {"units", "db", "relative"});
  command_line::one_of(
      cli.add_option("--rows", rows,
                     "vertical axis of spectrograms: time or shaft speed (default: time)")
          ->type_name("WHAT"),
      {"time", "speed"});
  cli.add_option("--band", band,
                 "frequency band of an envelope in Hz, LOW:HIGH (default: the band with the most "
                 "impulsive vibration, or else the strongest modulation)")
      ->type_name("BAND");
  command_line::one_of(
      cli.add_option("--orders-of", orders_of,
                     "part whose revolutions define the orders (default: shaft; without this "
                     "option, envelope spectra have a frequency axis in Hz)")
          ->type_name("PART"),
      {"shaft", "cage", "element"});
  // An existing window accepts only files.
  for (const char* of_first :
       {"--render", "--page", "--from", "--to", "--every", "--abscissa", "--domain", "--curve",
        "--scale", "--rows", "--band", "--orders-of", "--dark"})
    one_window->excludes(cli.get_option(of_first));
  if (const auto over = command_line::parse(cli, argc, argv)) return *over;
  return desktop::run_guarded("adrplot", [&] {
    const auto pixels = desktop::parse_size(size);
    options.width = pixels.width;
    options.height = pixels.height;
    options.view.abscissa =
        abscissa == "time" ? adrplot::Abscissa::Time : adrplot::Abscissa::Revolutions;
    adrplot::parse_domain_options(options.view, domain, curve, scale, rows, band, orders_of);
    if (!options.folder.empty()) return render(argc, argv, files, options);
    return show(argc, argv, files, options, follow, behind, project);
  });
}

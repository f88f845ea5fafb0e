#include "adrplot/render.hpp"
#include "agore/render.hpp"
#include "base/errors.hpp"
#include "cli/commands.hpp"
#include "cli/pictures.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/image_export.hpp"

#include <QChart>
#include <QGraphicsScene>
#include <QImage>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QPainter>
#include <QPen>
#include <QScatterSeries>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>

namespace adore::cli {
namespace {

void print_files(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) fmt::print("{}\n", file.string());
}

void add_plot(CLI::App& app) {
  CLI::App* command = app.add_subcommand("plot", "draw the pages of SOL1-SOL7, a quasi-static RUN.json or SWEEP.csv as PNG files");
  auto files = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>();
  auto options = std::make_shared<adrplot::RenderOptions>();
  auto time = std::make_shared<bool>(false);
  command->add_option("files", *files, "SOL1-SOL7, RUN.json, SWEEP.csv")->required();
  command->add_option("--out", *out, "folder of the pictures")->required();
  command->add_option("--page", options->page, "one page (default: all)");
  command->add_option("--from", options->range.from, "first stored step, counted from 1")
      ->capture_default_str();
  command->add_option("--to", options->range.to, "last stored step")->capture_default_str();
  command->add_option("--every", options->range.every, "interval of stored steps")
      ->capture_default_str();
  command->add_flag("--time", *time, "time as abscissa instead of revolutions");
  command->add_flag("--dark", options->dark, "dark theme");
  command->callback([=] {
    desktop::ensure_headless_application();
    options->folder = *out;
    if (*time) options->view.abscissa = adrplot::Abscissa::Time;
    print_files(adrplot::render_plots({files->begin(), files->end()}, *options));
  });
}

struct AnimateOptions {
  std::string file, out = ".", view = "bearing", race = "inner", movie;
  int frame = 0, every = 1, frames_per_second = 25, element = 1;
  bool dark = false;
};

void animate(const AnimateOptions& options) {
  desktop::ensure_headless_application();
  agore::RenderOptions render;
  render.view.view = agore::view_named(options.view, options.race);
  render.view.element = options.element;
  render.view.dark = options.dark;
  agore::MotionPicture picture = agore::open_animation(options.file);
  const std::filesystem::path folder(options.out);
  if (!options.movie.empty()) {
    const std::filesystem::path film = folder / options.movie;  // an absolute name stays as it is
    agore::render_movie(picture, options.every, options.frames_per_second, film, render);
    print_files({film});
  } else if (options.frame > 0) {
    desktop::make_folder(folder);
    const std::filesystem::path file =
        folder / fmt::format("{}-{}-frame-{:05}.png",
                             std::filesystem::path(options.file).filename().string(), options.view,
                             options.frame);
    agore::render_frame(picture, options.frame, file, render);
    print_files({file});
  } else {
    print_files(agore::render_frames(picture, options.every, folder, render));
  }
}

void add_animate(CLI::App& app) {
  CLI::App* command = app.add_subcommand("animate", "draw frames or a film of SOL8");
  auto options = std::make_shared<AnimateOptions>();
  command->add_option("file", options->file, "SOL8 file")->required();
  command->add_option("--view", options->view, "bearing, cage, pocket, element, race or flange")
      ->capture_default_str();
  command->add_option("--race", options->race, "outer or inner, for the race view")
      ->capture_default_str();
  command
      ->add_option("--element", options->element, "element or pocket of the single-element views")
      ->capture_default_str();
  command->add_option("--frame", options->frame, "one stored frame, counted from 1 (default: all)");
  command->add_option("--every", options->every, "every n-th frame")->capture_default_str();
  command->add_option("--movie", options->movie,
                      "film to write: NAME.avi, or a folder of numbered pictures");
  command->add_option("--fps", options->frames_per_second, "pictures per second of the film")
      ->capture_default_str();
  command->add_option("--out", options->out, "folder of the pictures")->capture_default_str();
  command->add_flag("--dark", options->dark, "dark theme");
  command->callback([=] { animate(*options); });
}

}  // namespace

void add_picture_commands(CLI::App& app, int&) {
  add_plot(app);
  add_animate(app);
}

/// Colours of the methods, repeated after ten; the first seven differ for colour-blind readers too.
constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8c6d00",
                                    "#56b4e9", "#444444", "#e69f00", "#7b3fb3", "#a30d0d"};

bool draw_accuracy_chart(const facade::AccuracyStudy& study, const std::filesystem::path& file) {
  desktop::ensure_headless_application();
  QChart chart;
  chart.setTitle(QString("What accuracy costs: %1 revolutions, reference %2")
                     .arg(QString::number(study.span_revolutions, 'g', 3),
                          QString::fromStdString(study.reference)));
  auto* seconds = new QLogValueAxis;
  seconds->setTitleText("computing time [s]");
  seconds->setLabelFormat("%.0e");
  seconds->setMinorTickCount(8);
  auto* error = new QLogValueAxis;
  error->setTitleText("largest scaled error at the end");
  error->setLabelFormat("%.0e");
  error->setMinorTickCount(8);
  chart.addAxis(seconds, Qt::AlignBottom);
  chart.addAxis(error, Qt::AlignLeft);

  std::map<std::string, QLineSeries*> lines;
  double low_t = 1e300, high_t = 0.0, low_e = 1e300, high_e = 0.0;
  for (const facade::AccuracyRow& row : study.rows) {
    if (!row.failure.empty() || !(row.seconds > 0.0) || !(row.error > 0.0)) continue;
    QLineSeries*& line = lines[row.method];
    if (line == nullptr) {
      line = new QLineSeries;
      line->setName(QString::fromStdString(row.method));
      line->setPointsVisible(true);
      line->setPen(QPen(QColor(kColours[(lines.size() - 1) % std::size(kColours)]), 2.0));
      chart.addSeries(line);
      line->attachAxis(seconds);
      line->attachAxis(error);
    }
    line->append(row.seconds, row.error);
    low_t = std::min(low_t, row.seconds), high_t = std::max(high_t, row.seconds);
    low_e = std::min(low_e, row.error), high_e = std::max(high_e, row.error);
  }
  if (lines.empty()) return false;
  seconds->setRange(low_t / 1.5, high_t * 1.5);
  error->setRange(low_e / 3.0, high_e * 3.0);
  chart.legend()->setAlignment(Qt::AlignRight);

  QGraphicsScene scene;
  scene.addItem(&chart);
  chart.resize(1280, 800);
  scene.setSceneRect(0, 0, 1280, 800);
  QImage image(1280, 800, QImage::Format_RGB32);
  image.fill(Qt::white);
  {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    scene.render(&painter);
  }
  scene.removeItem(&chart);
  desktop::save_image(image, file);
  return true;
}

}  // namespace adore::cli

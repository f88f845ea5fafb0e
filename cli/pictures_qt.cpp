#include "cli/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include <QChart>
#include <QGraphicsScene>
#include <QImage>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QPainter>
#include <QScatterSeries>

#include "adrplot/render.hpp"
#include "agore/render.hpp"
#include "base/errors.hpp"
#include "cli/commands.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/image_export.hpp"

namespace adore::cli {
namespace {

void print_files(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) fmt::print("{}\n", file.string());
}

void add_plot(CLI::App& app) {
  CLI::App* command = app.add_subcommand("plot", "draw the pages of SOL1-SOL7 as PNG files");
  auto files = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>();
  auto options = std::make_shared<adrplot::RenderOptions>();
  auto time = std::make_shared<bool>(false);
  command->add_option("files", *files, "SOL1-SOL7 files")->required();
  command->add_option("--out", *out, "folder of the pictures")->required();
  command->add_option("--page", options->page, "one page (default: all)");
  command->add_option("--from", options->range.from, "first stored step, counted from 1")->capture_default_str();
  command->add_option("--to", options->range.to, "last stored step")->capture_default_str();
  command->add_option("--every", options->range.every, "interval of stored steps")->capture_default_str();
  command->add_flag("--time", *time, "time as abscissa instead of revolutions");
  command->add_flag("--dark", options->dark, "dark theme");
  command->callback([=] {
    desktop::ensure_headless_application();
    options->folder = *out;
    if (*time) options->view.abscissa = adrplot::Abscissa::Time;
    print_files(adrplot::render_plots({files->begin(), files->end()}, *options));
  });
}

void add_animate(CLI::App& app) {
  CLI::App* command = app.add_subcommand("animate", "draw frames or a film of SOL8");
  auto file = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>(".");
  auto options = std::make_shared<agore::RenderOptions>();
  auto view = std::make_shared<std::string>("bearing");
  auto frame = std::make_shared<long>(0);
  auto every = std::make_shared<long>(0);
  auto movie = std::make_shared<std::string>();
  command->add_option("file", *file, "SOL8 file")->required();
  command->add_option("--view", *view, "bearing, cage, pocket, element, race or flange")->capture_default_str();
  command->add_option("--frame", *frame, "one stored frame, counted from 1");
  command->add_option("--every", *every, "every n-th frame as a numbered PNG");
  command->add_option("--movie", *movie, "film to write (.avi)");
  command->add_option("--element", options->element, "element or pocket of the single-element views")->capture_default_str();
  command->add_option("--out", *out, "folder of the pictures")->capture_default_str();
  command->add_flag("--dark", options->dark, "dark theme");
  command->callback([=] {
    desktop::ensure_headless_application();
    options->folder = *out;
    options->view = agore::view_from_name(*view);
    const results::Sol8File data = results::read_sol8(*file);
    if (!data.note.empty()) fmt::print(stderr, "{}: {}\n", *file, data.note);
    if (!movie->empty()) {
      const std::filesystem::path target(*movie);
      agore::render_movie(data, target.is_absolute() ? target : std::filesystem::path(*out) / target, *options);
      return print_files({target.is_absolute() ? target : std::filesystem::path(*out) / target});
    }
    print_files(agore::render_frames(data, *frame, *every, *options));
  });
}

}  // namespace

void add_picture_commands(CLI::App& app, int&) {
  add_plot(app);
  add_animate(app);
}

bool draw_accuracy_chart(const facade::AccuracyStudy& study, const std::filesystem::path& file) {
  desktop::ensure_headless_application();
  QChart chart;
  chart.setTitle(QString("What accuracy costs: %1 revolutions, reference %2")
                     .arg(QString::number(study.span_revolutions, 'g', 3), QString::fromStdString(study.reference)));
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

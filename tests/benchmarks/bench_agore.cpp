#include "agore/motion_picture.hpp"
#include "agore/render.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/mp4_writer.hpp"
#include "tests/support/synthetic_results.hpp"

#include <QApplication>
#include <QPainter>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <sys/resource.h>

/// Frames of AGORE at 1920 x 1080, on one core. Aim: 60 per second with 40 elements (16.7 ms). The
/// column CPU is the processor time of all threads, since Qt uses helper threads for large fills.
/// `film` writes some 100 pictures of 1280 x 800 into one movie; `ffmpeg_ms` is the time of the MP4
/// helper per picture, in addition to the measured time. With ADORE_BENCH_RUN=FOLDER the pictures
/// use RESULTS.h5 of that run, which sections and the 3D view need; otherwise 40 synthetic balls.
using namespace adore;
using agore::View;

namespace {

int zero = 0;
/// Never destroyed: Qt's internal data end later.
void need_application() {
  static const auto* application =
      desktop::make_application(zero, nullptr, "agore", desktop::Display::Headless).release();
  (void)application;
}

agore::MotionPicture& picture() {
  need_application();
  // Never taken down: it would outlive the application.
  static auto& made = *new agore::MotionPicture([] {
    if (const char* run = std::getenv("ADORE_BENCH_RUN"))
      return agore::open_motion(std::filesystem::path(run) / "RESULTS.h5");
    test::SyntheticRun run;
    run.steps = 300;
    run.balls = 40;
    run.ball_radius = 0.0022;
    return agore::prepare(test::synthetic_sol8(run));
  }());
  return made;
}

void frames(benchmark::State& state, agore::ViewOptions options) {
  agore::MotionPicture& shown = picture();
  for (std::size_t i = 0; i <= options.beside.size(); ++i)
    if (!agore::why_not(options.tile(i).view, shown.animation()).empty()) {
      state.SkipWithError("not in this run; name one in ADORE_BENCH_RUN");
      return;
    }
  options.moving = true;
  QImage image(1920, 1080, QImage::Format_RGB32);
  std::size_t frame = 0;
  for (auto _ : state) {
    QPainter painter(&image);
    shown.paint(painter, QRectF(0, 0, 1920, 1080), frame, options);
    frame = (frame + 1) % shown.frames();
  }
}

agore::ViewOptions plain(View view) {
  agore::ViewOptions options;
  options.view = view;
  return options;
}

agore::ViewOptions all_marks() {
  agore::ViewOptions options;
  options.contacts = options.trails = true;
  options.colour = agore::ColourBy::Load;
  return options;
}

/// As where the races move in every frame: nothing of the rings can be kept.
void races_move(benchmark::State& state) {
  agore::MotionPicture& shown = picture();
  QImage image(1920, 1080, QImage::Format_RGB32);
  agore::ViewOptions options;
  std::size_t frame = 0;
  for (auto _ : state) {
    options.pan.setX(options.pan.x() > 0.0 ? 0.0 : 0.001);
    QPainter painter(&image);
    shown.paint(painter, QRectF(0, 0, 1920, 1080), frame, options);
    frame = (frame + 1) % shown.frames();
  }
}

agore::ViewOptions four() {
  agore::ViewOptions options;
  options.beside = {{View::Solid}, {View::Section}, {View::Pocket}};
  return options;
}

BENCHMARK_CAPTURE(frames, bearing, plain(View::Bearing))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frames, bearing_loads_ways_colours, all_marks())
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK(races_move)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frames, cage, plain(View::Cage))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frames, pocket, plain(View::Pocket))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frames, element, plain(View::Element))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frames, inner_race, plain(View::InnerRace))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frames, section, plain(View::Section))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frames, solid, plain(View::Solid))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(frames, four_views, four())
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

double seconds_of_helpers() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void film(benchmark::State& state, const char* name) {
  agore::MotionPicture& shown = picture();
  if (std::string_view(name).ends_with("mp4") && !desktop::has_ffmpeg()) {
    state.SkipWithError("no ffmpeg here");
    return;
  }
  const QTemporaryDir folder;
  const int every = std::max(1, static_cast<int>(shown.frames()) / 100);
  agore::RenderOptions options;
  options.width = 1280;
  options.height = 800;
  options.replace = true;
  long pictures = 0;
  options.progress = [&](long, long total) { pictures = total; };
  const double before = seconds_of_helpers();
  long films = 0;
  for (auto _ : state) {
    agore::render_movie(shown, every, 25, folder.filePath(name).toStdString(), options);
    ++films;
  }
  const auto drawn = static_cast<double>(pictures * films);
  state.counters["pictures"] = static_cast<double>(pictures);
  state.counters["ffmpeg_ms"] = 1e3 * (seconds_of_helpers() - before) / drawn;
}
BENCHMARK_CAPTURE(film, avi, "film.avi")->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(film, gif, "film.gif")->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(film, mp4, "film.mp4")->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(film, png, "pictures")->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();

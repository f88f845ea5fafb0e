#include "adrplot/plot_document.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/chart_scene.hpp"

#include <QApplication>
#include <QPainter>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <sys/resource.h>
#include <vector>

/// A page of three panels with two curves each over 10^6 stored steps, moved along and drawn. Aim:
/// 30 pictures a second (33 ms). With ADORE_BENCH_SOL=FILE also that file (long_sol.py makes one):
/// read once, then every page moved along; `peak_MB` is the most memory of the program so far. The
/// column CPU is the processor time of all threads.
using namespace adore;

namespace {

int zero = 0;
/// Never destroyed: Qt's internal data end later.
void need_application() {
  static const auto* application =
      desktop::make_application(zero, nullptr, "adrplot", desktop::Display::Headless).release();
  (void)application;
}

desktop::ChartPage million(std::size_t steps) {
  desktop::ChartPage page;
  page.title = "A million steps";
  page.x_title = "Time";
  page.x_unit = "s";
  for (std::size_t i = 0; i < steps; ++i) page.x.push_back(1e-6 * static_cast<double>(i));
  for (int p = 0; p < 3; ++p) {
    desktop::ChartPanel panel{"Load", "N", {}};
    for (int c = 0; c < 2; ++c) {
      desktop::ChartCurve curve{c == 0 ? "outer race" : "inner race", {}, {}};
      for (const double t : page.x)
        curve.y.push_back(std::sin(40.0 * t + p) + 0.3 * std::sin(9e4 * t + c));
      panel.curves.push_back(std::move(curve));
    }
    page.panels.push_back(std::move(panel));
  }
  return page;
}

/// Processor time of this thread [ms].
double thread_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Processor time of the window's thread that 95 of 100 pictures keep within, and the longest.
void tell(benchmark::State& state, std::vector<double>& times) {
  const auto at =
      times.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(times.size()));
  std::nth_element(times.begin(), at, times.end());
  state.counters["p95_ms"] = *at;
  state.counters["max_ms"] = *std::max_element(times.begin(), times.end());
}

/// Moves along a page, a hundredth of it for each picture, and draws.
void pan_along(benchmark::State& state, desktop::ChartScene& scene, QSize size) {
  const double first = scene.viewLow(), whole = scene.viewHigh() - first, width = 0.6 * whole;
  QImage image(size, QImage::Format_RGB32);
  double low = 0.0;
  std::vector<double> times;
  for (auto _ : state) {
    const double before = thread_time();
    low = std::fmod(low + 0.01 * whole, whole - width);
    scene.setView(first + low, first + low + width);
    QPainter painter(&image);
    scene.paintPage(painter, QRectF(QPointF(0, 0), QSizeF(size)));
    times.push_back(thread_time() - before);
  }
  tell(state, times);
}

void pan(benchmark::State& state) {
  need_application();
  const QSize size(static_cast<int>(state.range(1)), static_cast<int>(state.range(2)));
  desktop::ChartScene scene;
  scene.setPageSize(size);
  scene.setPage(million(static_cast<std::size_t>(state.range(0))));
  pan_along(state, scene, size);
}
BENCHMARK(pan)
    ->ArgsProduct({{1'000, 2'500, 10'000, 30'000, 100'000, 1'000'000}, {1280}, {800}})
    ->ArgsProduct({{2'500, 1'000'000}, {1920}, {1080}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// The same with extremes between the stored steps, whose areas are looked for where they are seen.
void pan_bands(benchmark::State& state) {
  need_application();
  desktop::ChartPage page = million(static_cast<std::size_t>(state.range(0)));
  page.band_note = "Min–max bands: range of the values between the steps.";
  for (desktop::ChartPanel& panel : page.panels)
    for (desktop::ChartCurve& curve : panel.curves) {
      curve.low = curve.high = curve.y;
      for (double& v : curve.low) v -= 0.05;
      for (double& v : curve.high) v += 0.05;
    }
  const QSize size(static_cast<int>(state.range(1)), static_cast<int>(state.range(2)));
  desktop::ChartScene scene;
  scene.setPageSize(size);
  scene.setPage(std::move(page));
  pan_along(state, scene, size);
}
BENCHMARK(pan_bands)
    ->ArgsProduct({{2'500, 100'000, 1'000'000}, {1280}, {800}})
    ->ArgsProduct({{2'500, 1'000'000}, {1920}, {1080}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// An orbit of this number of points, enlarged to `1 / part` of its width and moved in a circle for
/// more than a revolution, with the readout after each move: precessing points, 500 per revolution,
/// with or without noise. `first_ms` is the picture before the first move, without kept data.
void pan_orbit(benchmark::State& state) {
  need_application();
  desktop::ChartPage page;
  page.title = "Orbit";
  page.equal_axes = true;
  page.x_title = "Y";
  desktop::ChartCurve curve{"mass center", {}, {}};
  std::uint32_t seed = 1;
  for (long i = 0; i < state.range(0); ++i) {
    seed = seed * 1664525U + 1013904223U;
    const double noise = static_cast<double>(state.range(2)) * 0.05 * (seed * 0x1p-32 - 0.5);
    const double a = static_cast<double>(i) * 2.0 * 3.14159265358979 / 500.0;
    const double r = 1.0 + 0.1 * std::sin(0.37 * a) + noise;
    curve.x.push_back(r * std::cos(a));
    curve.y.push_back(r * std::sin(a));
  }
  page.panels = {{"Z", "", {std::move(curve)}}};
  const QSize size(static_cast<int>(state.range(3)), static_cast<int>(state.range(4)));
  const QPointF pointer(0.4 * size.width(), 0.6 * size.height());
  desktop::ChartScene scene;
  scene.setPageSize(size);
  scene.setPage(std::move(page));
  QImage image(size, QImage::Format_RGB32);
  const double half = 0.5 * static_cast<double>(state.range(1)) / 100.0;
  double turn = 0.0;
  const auto draw = [&] {
    const double before = thread_time();
    turn += 0.1;
    const double x = 0.4 * std::cos(turn), y = 0.4 * std::sin(turn);
    scene.setZoom({0.0, 1.0, {std::pair(y - half, y + half), std::pair(x - half, x + half)}});
    benchmark::DoNotOptimize(scene.readoutParts(pointer));
    benchmark::DoNotOptimize(scene.nearestPlanePoint(pointer, 20.0));
    QPainter painter(&image);
    scene.paintPage(painter, QRectF(QPointF(0, 0), QSizeF(size)));
    return thread_time() - before;
  };
  std::vector<double> times;
  state.counters["first_ms"] = draw();
  for (auto _ : state) times.push_back(draw());
  tell(state, times);
}
BENCHMARK(pan_orbit)
    ->ArgsProduct({{1'000'000}, {200, 100, 10}, {0, 1}, {1280}, {800}})
    ->ArgsProduct({{1'000'000}, {200, 100, 10}, {0, 1}, {1920}, {1080}})
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void read_file(benchmark::State& state, const char* path) {
  need_application();
  for (auto _ : state) {
    const adrplot::PlotDocument document = adrplot::open_document(path);
    benchmark::DoNotOptimize(document.build(1, {}));
  }
  state.counters["peak_MB"] = peak_megabytes();
}

void pan_page(benchmark::State& state, const adrplot::PlotDocument& document, int number) {
  desktop::ChartScene scene;
  scene.setPageSize(QSizeF(1280, 800));
  scene.setPage(document.build(number, {}));
  pan_along(state, scene, QSize(1280, 800));
  state.counters["peak_MB"] = peak_megabytes();
}

void benchmarks_of(const char* path) {
  const auto as_asked = [](benchmark::internal::Benchmark* made) {
    made->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
  };
  as_asked(benchmark::RegisterBenchmark("read", read_file, path)->Iterations(1));
  need_application();
  // Read when the first page is measured, so that `read` shows its own memory.
  const auto document = std::make_shared<std::unique_ptr<adrplot::PlotDocument>>();
  const int pages = static_cast<int>(adrplot::open_document(path, {1, 2, 1}).pages.size());
  for (int number = 1; number <= pages; ++number)
    as_asked(benchmark::RegisterBenchmark(("pan_page_" + std::to_string(number)).c_str(),
                                          [path, document, number](benchmark::State& state) {
                                            if (!*document)
                                              *document = std::make_unique<adrplot::PlotDocument>(
                                                  adrplot::open_document(path));
                                            pan_page(state, **document, number);
                                          }));
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (const char* path = std::getenv("ADORE_BENCH_SOL")) benchmarks_of(path);
  benchmark::RunSpecifiedBenchmarks();
}

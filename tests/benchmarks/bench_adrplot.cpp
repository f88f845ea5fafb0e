#include "desktop/bootstrap.hpp"
#include "desktop/chart_scene.hpp"

#include <QApplication>
#include <QPainter>
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

/// A page of three panels with two curves each over 10^6 stored steps, moved along and drawn. Aim:
/// 30 pictures a second (33 ms).
using namespace adore;

namespace {

int zero = 0;
/// Never taken down: what Qt keeps of its own ends later.
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

void pan(benchmark::State& state) {
  need_application();
  desktop::ChartScene scene;
  scene.setPageSize(QSizeF(1280, 800));
  scene.setPage(million(static_cast<std::size_t>(state.range(0))));
  const double whole = scene.viewHigh(), width = 0.6 * whole;
  QImage image(1280, 800, QImage::Format_RGB32);
  double low = 0.0;
  for (auto _ : state) {
    low = std::fmod(low + 0.01 * whole, whole - width);
    scene.setView(low, low + width);
    QPainter painter(&image);
    scene.paintPage(painter, QRectF(0, 0, 1280, 800));
  }
}
BENCHMARK(pan)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

#include "adrinput/deck_window.hpp"
#include "adrinput/record_page.hpp"
#include "deck/templates.hpp"
#include "desktop/bootstrap.hpp"

#include <QApplication>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

/// Waiting times in AdrInput. Aims: start-up below 1 s, a page below 50 ms, a typed letter below 20
/// ms. Measured to the last pixel: the window is drawn into a picture.
using namespace adore;
using adrinput::DeckWindow;

namespace {

int zero = 0;
std::unique_ptr<QApplication> application;

void need_application() {
  if (!application)
    application = desktop::make_application(zero, nullptr, "adrinput", desktop::Display::Headless);
}

/// Lets the window lay itself out and paint, as its event loop would.
void draw(DeckWindow& window) {
  QApplication::processEvents();
  window.repaint();
}

/// From nothing but the program in memory: Qt, fonts, style, window, first page drawn. Once per
/// process, so one iteration.
void start_up(benchmark::State& state) {
  for (auto _ : state) {
    need_application();
    DeckWindow window;
    window.show();
    draw(window);
  }
}
BENCHMARK(start_up)->Iterations(1)->Unit(benchmark::kMillisecond);

void new_window(benchmark::State& state) {
  need_application();
  for (auto _ : state) {
    DeckWindow window;
    window.show();
    draw(window);
  }
}
BENCHMARK(new_window)->Unit(benchmark::kMillisecond);

/// All pages of a deck in turn; the counter `slowest_ms` is the median time of the slowest page.
void change_page(benchmark::State& state, const char* deck) {
  need_application();
  DeckWindow window;
  window.resize(1280, 860);
  window.show();
  window.newDeck(deck);
  draw(window);
  const std::vector<std::string> pages = window.document().pages();
  std::vector<std::vector<double>> times(pages.size());
  for (auto _ : state)
    for (std::size_t i = 0; i < pages.size(); ++i) {
      const auto begin = std::chrono::steady_clock::now();
      window.showRecord(pages[i]);
      draw(window);
      times[i].push_back(
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
              .count());
    }
  double slowest = 0.0;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const auto middle = times[i].begin() + static_cast<long>(times[i].size() / 2);
    std::nth_element(times[i].begin(), middle, times[i].end());
    if (*middle <= slowest) continue;
    slowest = *middle;
    state.SetLabel("slowest: record " + pages[i]);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(pages.size()));
  state.counters["slowest_ms"] = slowest;
}
BENCHMARK_CAPTURE(change_page, ball, "ball")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(change_page, tapered, "tapered-30208")->Unit(benchmark::kMillisecond);

/// One letter more in a field, with every live check that follows at once.
void type_letter(benchmark::State& state) {
  need_application();
  DeckWindow window;
  window.show();
  window.showRecord("5A");
  const auto refs = deck::find_variable("pitchDia");
  const adrinput::Cell cell{std::string(refs[0].record->id), 1, refs[0].position, 0};
  bool longer = false;
  for (auto _ : state) {
    window.document().edit(cell, (longer = !longer) ? "0.0601" : "0.060");
    draw(window);
  }
}
BENCHMARK(type_letter)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  application.reset();
  return 0;
}

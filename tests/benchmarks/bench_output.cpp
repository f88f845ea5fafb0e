#include "results/fortran_format.hpp"
#include "results/load_band.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

/// What a run pays for its files: a look at the loads of every step, and the fields of a stored
/// one.
namespace {

using namespace adore::results;

/// Aim: a microsecond per step.
void look_at_the_loads_of_40_elements(benchmark::State& state) {
  LoadBand band;
  const std::vector<double> outer(40, 1.0), inner(40, 2.0);
  for (auto _ : state) band.look(outer, inner);
  benchmark::DoNotOptimize(band.high(79));
}

/// Fields of SOL1 to SOL7 (digits 7, one before the point) and SOL8 (digits 3).
void fields(benchmark::State& state, int width, int digits, fortran::Scale scale) {
  std::vector<double> values;
  for (int k = 0; k < 256; ++k) values.push_back((k % 3 - 1) * std::exp(0.13 * k - 17.0));
  std::string text;
  for (auto _ : state) {
    text.clear();
    for (const double value : values) fortran::append_real(text, value, width, digits, scale);
    benchmark::DoNotOptimize(text.data());
  }
  state.SetItemsProcessed(state.iterations() * 256);
}
void fields_of_plots(benchmark::State& state) { fields(state, 16, 7, fortran::Scale::One); }
void fields_of_the_animation(benchmark::State& state) {
  fields(state, 10, 3, fortran::Scale::Zero);
}

BENCHMARK(look_at_the_loads_of_40_elements)->Unit(benchmark::kNanosecond);
BENCHMARK(fields_of_plots)->Unit(benchmark::kNanosecond);
BENCHMARK(fields_of_the_animation)->Unit(benchmark::kNanosecond);

}  // namespace

#include "results/fortran_format.hpp"
#include "results/step_band.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

/// Cost of the files of a run: a snapshot per step, and the fields of a stored step.
namespace {

using namespace adore::results;

/// Contacts, flanges, pockets of two surfaces, lands and races. Aim: 50 ns an element.
void look_at_40_rollers(benchmark::State& state) {
  using adore::scene::ExtremeQuantity;
  adore::scene::Look look;
  for (const ExtremeQuantity what :
       {ExtremeQuantity::ContactLoad, ExtremeQuantity::ContactHeat, ExtremeQuantity::ContactSlip})
    look[what].assign(80, 1.0);
  for (const ExtremeQuantity what : {ExtremeQuantity::FlangeForce, ExtremeQuantity::FlangeSlip})
    look[what].assign(160, 2.0);
  look[ExtremeQuantity::PocketForce].assign(80, 3.0);
  look[ExtremeQuantity::LandForce].assign(2, 4.0);
  for (std::size_t k = 8; k < adore::scene::kExtremeQuantityCount; ++k)
    look.values[k].assign(2, 5.0);
  StepBand band;
  for (auto _ : state) band.look(look);
  benchmark::DoNotOptimize(band.high(ExtremeQuantity::FlangeForce, 159));
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

BENCHMARK(look_at_40_rollers)->Unit(benchmark::kNanosecond);
BENCHMARK(fields_of_plots)->Unit(benchmark::kNanosecond);
BENCHMARK(fields_of_the_animation)->Unit(benchmark::kNanosecond);

}  // namespace

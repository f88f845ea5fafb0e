#include "integrators/arrow_matrix.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

// Decomposition and one solution of Newton's matrix of a bearing: nine components per ball and
// fourteen of the cage, as an arrow and as the dense matrix of the same values.
namespace {

using namespace adore::integrators;

std::vector<int> bearing_blocks(int balls) {
  std::vector<int> blocks;
  for (int part = 0; part < 9; ++part)
    for (int i = 0; i < balls; ++i) blocks.push_back(i);
  blocks.insert(blocks.end(), 14, kBorder);
  return blocks;
}

void newton_matrix(benchmark::State& bench, bool as_arrow) {
  const std::vector<int> blocks = bearing_blocks(static_cast<int>(bench.range(0)));
  const int size = static_cast<int>(blocks.size());
  ArrowMatrix values(std::make_shared<ArrowShape>(as_arrow ? blocks : std::vector<int>(), size));
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      const bool apart = blocks[i] != blocks[j] && blocks[i] != kBorder && blocks[j] != kBorder;
      if (!apart) values.at(i, j) = (i == j ? 2.0 : 0.0) + 0.3 * std::sin(1.0 + i + 7.0 * j);
    }
  ArrowMatrix work = values;
  std::vector<double> x(static_cast<std::size_t>(size), 1.0);
  for (auto _ : bench) {
    work.copy_values(values);
    benchmark::DoNotOptimize(work.factor());
    work.solve(x.data());
    benchmark::DoNotOptimize(x.data());
  }
}

void arrow(benchmark::State& bench) { newton_matrix(bench, true); }
void dense(benchmark::State& bench) { newton_matrix(bench, false); }
BENCHMARK(arrow)->Arg(12)->Arg(40);
BENCHMARK(dense)->Arg(12)->Arg(40);

}  // namespace

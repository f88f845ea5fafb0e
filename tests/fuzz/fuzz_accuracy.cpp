#include "adrplot/accuracy_page.hpp"
#include "base/errors.hpp"
#include "fuzz_pages.hpp"
#include "input_file.hpp"

using namespace adore;

/// ACCURACY.json: any bytes give pages or a sentence; every curve of a page fits its axis.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  testing::start_qt();
  const testing::InputFile file(data, size);
  try {
    for (const desktop::ChartPage& page : adrplot::accuracy_pages(file.path()))
      for (const auto& panel : page.panels)
        for (const desktop::ChartCurve& curve : panel.curves)
          demand(curve.y.size() == page.x.size() || !curve.x.empty(), "a curve fits its axis");
  } catch (const InputError&) {
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  return testing::change_json(data, size, most, seed);
}

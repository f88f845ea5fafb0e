#include "base/errors.hpp"
#include "input_file.hpp"
#include "results/static_tables.hpp"
#include "results/sweep_table.hpp"

using namespace adore;
using namespace adore::results;

/// The RUN.json of a quasi-static solution and SWEEP.csv, as the plots read them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const testing::InputFile file(data, size);
  try {
    (void)read_static_tables(file.path());
  } catch (const InputError&) {
  }
  try {
    const SweepTable table = read_sweep(file.path());
    for (const SweepColumn& column : table.columns)
      demand(column.values.size() == table.values.size(), "a value per run in every column");
  } catch (const InputError&) {
  }
  return 0;
}

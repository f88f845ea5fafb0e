#include "input_file.hpp"
#include "refused.hpp"
#include "results/convert.hpp"
#include "results/restart.hpp"

#include <cmath>
#include <sstream>

using namespace adore;
using testing::refused_or;
using namespace adore::results;

namespace {

void check(const FinalState& state) {
  demand(state.step >= 0 && std::isfinite(state.time) && state.time >= 0.0,
         "a run's place in time");
  demand(state.scales.length > 0.0 && state.scales.force > 0.0 && state.scales.time > 0.0,
         "scales divide");
  demand(state.components.size() == state.state.size(), "every component has a name");
  for (const double value : state.state) demand(std::isfinite(value), "a state is finite");
}

}  // namespace

/// FINAL and MASTER with any bytes: a valid start state, or a message. The same for showing and
/// converting any file that is not HDF5.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const testing::InputFile file(data, size);
  refused_or([&] { check(read_final(file.path())); });
  refused_or([&] { check(read_master(file.path()).last); });
  if (size >= 4 && std::string(data, data + 4) == "\x89HDF") return 0;  // fuzz_h5
  std::ostringstream out;
  refused_or([&] { out << describe_file(file.path()); });
  refused_or([&] { convert_file(file.path(), "csv", out); });
  refused_or([&] { convert_file(file.path(), "json", out); });
  return 0;
}

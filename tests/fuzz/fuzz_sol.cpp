#include "base/errors.hpp"
#include "results/channels.hpp"
#include "results/sol_parser.hpp"

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

using namespace adore::results;

/// With any bytes, the readers of SOL1-SOL8 return whole steps or reject the file with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto demand_that = [](bool condition) {
    if (!condition) std::abort();
  };
  try {
    std::istringstream stream(text);
    const SolFile file = read_sol(stream, "input", {1, 1000, 1});
    for (const SolStep& step : file.steps)
      demand_that(step.values.size() == static_cast<std::size_t>(file.header.value_count));
    demand_that(sol_columns(file.header).size() ==
                static_cast<std::size_t>(file.header.value_count));
    // Skipping steps must find the same ones.
    std::istringstream again(text);
    const SolFile every_other = read_sol(again, "input", {2, 1000, 2});
    if (file.note.empty()) demand_that(every_other.steps.size() == file.steps.size() / 2);
  } catch (const adore::InputError&) {
  }
  try {
    std::istringstream stream(text);
    const Sol8File file = read_sol8(stream, "input", {1, 1000, 1});
    for (const Sol8Frame& frame : file.frames)
      demand_that(frame.elements.size() == static_cast<std::size_t>(file.elements));
  } catch (const adore::InputError&) {
  }
  return 0;
}

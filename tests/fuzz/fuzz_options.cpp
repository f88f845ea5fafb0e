#include "base/errors.hpp"
#include "facade/option_file.hpp"

#include <cstdint>
#include <string>

using namespace adore;
using namespace adore::facade;

/// ADORE.json with any bytes: the file is read or its problem has a message, and an unchanged file
/// keeps its text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const OptionFile file = OptionFile::from_text(text);
  if (!file.problem().empty()) return 0;
  for (const auto& [name, value] : file.values()) (void)option_problem(name, value);
  (void)file.with(file.values());
  (void)file.with({});
  return 0;
}

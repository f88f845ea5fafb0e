#include "base/errors.hpp"
#include "h5_mutator.hpp"
#include "results/convert.hpp"
#include "results/results_h5.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>
#include <sys/resource.h>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;

/// RESULTS.h5 with any bytes: every reader returns values of the announced sizes or one message,
/// and failures of the HDF5 library stay in the process that reads. The inputs are files of this
/// program with damaged bookkeeping; most get correct checksums again.
namespace {

/// How the inputs ended, by the sentence without its numbers and names.
struct Outcomes {
  std::map<std::string, long> count;
  long inputs = 0, sums_right = 0;
  ~Outcomes() {
    if (inputs == 0) return;
    struct rusage used {};
    ::getrusage(RUSAGE_CHILDREN, &used);
    std::printf("%ld files, of %ld the checksums were put right; largest reader %ld MiB\n", inputs,
                sums_right, used.ru_maxrss / 1024);
    for (const auto& [what, times] : count) std::printf("%8ld  %s\n", times, what.c_str());
  }
};
Outcomes outcomes;

void read_everything(const std::filesystem::path& path) {
  const H5Reader reader(path);
  (void)reader.step_numbers();
  for (const auto& info : reader.channels())
    demand(reader.read(info.id).size() == reader.steps() * info.size(),
           "a channel has the announced size");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto path = folder() / "RESULTS.h5";
  write_bytes(path, std::string_view(reinterpret_cast<const char*>(data), size));
  ++outcomes.inputs;
  std::string ended = "read to the last value";
  try {
    read_everything(path);
  } catch (const InputError& error) {
    ended = kind_of(error.what());
  }
  ++outcomes.count[ended];
  // Code that uses the reader, now and then.
  if (outcomes.inputs % 16 != 0) return 0;
  try {
    std::ostringstream out;
    out << describe_file(path);
    convert_file(path, "csv", out);
  } catch (const InputError&) {
  }
  return 0;
}

/// Ignores its input: every file is one of this program, damaged by the seed.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t, std::size_t most,
                                               unsigned seed) {
  const auto [bytes, kind, sums_right] = Mutator(seed).file();
  if (sums_right) ++outcomes.sums_right;
  const std::size_t size = std::min(bytes.size(), most);
  std::copy_n(bytes.data(), size, reinterpret_cast<char*>(data));
  return size;
}

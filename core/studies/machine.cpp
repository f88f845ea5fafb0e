#include "base/input_file.hpp"
#include "studies/engine.hpp"

#include <algorithm>
#include <limits>
#include <sched.h>
#include <string>
#include <thread>

namespace adore::studies {
namespace {

double number_in(const char* path) {
  double value = 0.0;
  return InputFile(path) >> value ? value : -1.0;  // "max" is not a number
}

}  // namespace

int usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(1, CPU_COUNT(&set));
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

double available_memory_megabytes() {
  double free = std::numeric_limits<double>::infinity();
  InputFile file("/proc/meminfo");
  std::string name, unit;
  for (double kilobytes = 0.0; file >> name >> kilobytes;) {
    std::getline(file, unit);
    if (name == "MemAvailable:") free = kilobytes * 1024.0 / 1e6;
  }
  const double most = number_in("/sys/fs/cgroup/memory.max"),
               used = number_in("/sys/fs/cgroup/memory.current");
  if (most > 0.0 && used >= 0.0) free = std::min(free, std::max(0.0, most - used) / 1e6);
  return free;
}

}  // namespace adore::studies

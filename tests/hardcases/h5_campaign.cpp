#include "base/errors.hpp"
#include "fuzz/h5_mutator.hpp"
#include "results/h5_file.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

/// h5_campaign COUNT [FIRST_SEED]: reads that many damaged RESULTS.h5, many in one process, where
/// tests/fuzz/fuzz_h5 starts a process for each. A worker has the limits of h5_process.hpp; where
/// it dies, runs out of memory or of time, the same file goes through the reader that users have,
/// which must answer with a sentence. Prints how the files ended. Exit code 1 when one was not
/// answered.
using namespace adore;
using namespace adore::testing;

extern "C" void __gcov_dump() __attribute__((weak));

namespace {

std::atomic<bool> stop{false};
/// What has been read so far is told.
extern "C" void on_interrupt(int) { stop = true; }

constexpr unsigned kBatch = 1000;  ///< files of one worker

const std::array<const char*, 13> kKinds{"read to the last value",
                                         "the HDF5 library failed on it",
                                         "came to no end",
                                         "more memory",
                                         "cannot be opened",
                                         "cannot be read",
                                         "too short",
                                         "holds no bearing results",
                                         "no HDF5 file",
                                         "another way than",
                                         "damaged",
                                         "step number",
                                         "another sentence"};

/// Between worker and parent.
struct Shared {
  std::atomic<unsigned> next{0};  ///< seed of the file being read
  std::atomic<bool> doubtful{
      false};  ///< it ended for want of memory: what was before may have leaked
  std::atomic<long> sums_right{0};
  std::array<std::atomic<long>, kKinds.size()> count{};
};

std::size_t index_of(const std::string& kind) {
  for (std::size_t k = 0; k < kKinds.size(); ++k)
    if (kind == kKinds[k]) return k;
  return kKinds.size() - 1;
}

std::filesystem::path scratch(const char* name) {
  return std::filesystem::path("/dev/shm") /
         (std::string("adore-") + name + "-" + std::to_string(::getpid()));
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void limit() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most =
      pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) + (std::uint64_t{256} << 20);
  const struct rlimit space { most, most }, none{0, 0};
  ::setrlimit(RLIMIT_AS, &space);
  ::setrlimit(RLIMIT_CORE, &none);
}

/// From now on so much time for one file; the timers end the process.
void start_clock() {
  const struct itimerval busy {
    {0, 0}, { 20, 0 }
  }, waiting{{0, 0}, {30, 0}};
  ::setitimer(ITIMER_PROF, &busy, nullptr);
  ::setitimer(ITIMER_REAL, &waiting, nullptr);
}

void read_directly(const std::filesystem::path& path) {
  const results::h5::Quiet quiet;
  results::h5::File file(path);
  const results::h5::Content& content = file.content();
  for (const auto& info : content.channels)
    demand(file.read(info.id, 0, content.steps, 1).size() == content.steps * info.size(),
           "a channel has the announced size");
}

/// Reads files until `last`; whoever dies leaves the seed in `shared`.
[[noreturn]] void work(Shared& shared, unsigned last, const std::filesystem::path& path) {
  limit();
  while (shared.next < last) {
    const Mutant mutant = Mutator(shared.next).file();
    write_file(path, mutant.bytes);
    start_clock();
    std::size_t kind = 0;
    try {
      read_directly(path);
    } catch (const InputError& error) {
      kind = index_of(kind_of(error.what()));
    } catch (const std::bad_alloc&) {
      shared.doubtful = true;
      break;
    } catch (const std::exception&) {
      kind = index_of("damaged");
    }
    ++shared.count[kind];
    if (mutant.sums_right) ++shared.sums_right;
    ++shared.next;
  }
  if (__gcov_dump != nullptr) __gcov_dump();
  ::_exit(0);
}

/// What users are told of the file. @return false when that is no sentence
bool answered(const std::filesystem::path& path, std::string& kind) {
  kind = kKinds[0];
  try {
    const results::H5Reader reader(path);
    for (const auto& info : reader.channels()) (void)reader.read(info.id);
  } catch (const InputError& error) {
    kind = kind_of(error.what());
  } catch (...) {
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s COUNT [FIRST_SEED]\n", argv[0]);
    return 2;
  }
  const unsigned count = static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10));
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 1;
  (void)pristine();
  void* memory =
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 2;
  Shared& shared = *new (memory) Shared;
  shared.next = first;
  const auto path = scratch("h5"), again = scratch("h5-again");
  const auto begin = std::chrono::steady_clock::now();
  long deaths = 0, unanswered = 0;
  std::map<int, long> signals;
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, on_interrupt);
  while (!stop && shared.next < first + count) {
    const unsigned last = std::min(shared.next + kBatch, first + count);
    const pid_t child = ::fork();
    if (child == 0) {
      for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_IGN);
      work(shared, last, path);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (shared.next >= last) continue;
    ++deaths;
    if (WIFSIGNALED(status)) ++signals[WTERMSIG(status)];
    const Mutant mutant = Mutator(shared.next).file();
    write_file(again, mutant.bytes);
    std::string kind;
    if (!answered(again, kind)) {
      ++unanswered;
      std::printf("seed %u was not answered\n", shared.next.load());
    }
    ++shared.count[index_of(kind)];
    if (mutant.sums_right) ++shared.sums_right;
    shared.doubtful = false;
    ++shared.next;
  }
  std::filesystem::remove(path);
  std::filesystem::remove(again);
  struct rusage children {
  }, own{};
  ::getrusage(RUSAGE_CHILDREN, &children);
  ::getrusage(RUSAGE_SELF, &own);
  std::printf(
      "%u files from seed %u on, of %ld the checksums were put right; %.0f s; largest reader "
      "%ld MiB, largest caller %ld MiB\n",
      shared.next.load() - first, first, shared.sums_right.load(),
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
      children.ru_maxrss / 1024, own.ru_maxrss / 1024);
  for (std::size_t k = 0; k < kKinds.size(); ++k)
    if (shared.count[k] > 0) std::printf("%9ld  %s\n", shared.count[k].load(), kKinds[k]);
  std::printf("%ld went through the users' reader a second time:", deaths);
  for (const auto& [number, times] : signals) std::printf(" %ld %s;", times, ::strsignal(number));
  std::printf(" %ld without an answer\n", unanswered);
  return unanswered > 0 ? 1 : 0;
}

#include "user/host.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <new>
#include <sys/mman.h>

namespace adore::user {

template <std::size_t Room>
void BoundedText<Room>::add(const char* more) noexcept {
  if (more == nullptr) return;
  const std::size_t length = ::strnlen(more, Room);
  const std::size_t taken = std::min(length, Room - size);
  lost = lost || taken < length;
  std::memcpy(text.data() + size, more, taken);
  size += taken;
}

template <std::size_t Room>
std::string BoundedText<Room>::take() {
  const std::size_t used = std::min(size, Room);  // a routine may have written here
  std::string out(text.data(), used);
  size = 0;
  lost = false;
  return out;
}

template struct BoundedText<std::size_t{1} << 16>;
template struct BoundedText<std::size_t{1} << 20>;
template struct BoundedText<512>;

namespace {

Host& host_of(void* host) { return *static_cast<Host*>(host); }

std::int32_t read_line(void* host, char* text, std::int32_t size) {
  Host& h = host_of(host);
  HostSharedMemory& b = h.block();
  if (b.mode != ADORE_READ || b.line >= h.lines().size() || text == nullptr || size < 1) return 0;
  const std::string& line = h.lines()[b.line++];
  const std::size_t taken = std::min(line.size(), static_cast<std::size_t>(size) - 1);
  std::memcpy(text, line.data(), taken);
  text[taken] = '\0';
  return 1;
}

std::int32_t read_numbers(void* host, double* values, std::int32_t count) {
  Host& h = host_of(host);
  HostSharedMemory& b = h.block();
  std::int32_t found = 0;
  while (b.mode == ADORE_READ && found < count && b.line < h.lines().size()) {
    const std::vector<double> line = parse_list_directed(h.lines()[b.line]);
    if (line.empty()) break;  // a text: of another routine
    ++b.line;
    for (const double value : line)
      if (found < count) values[found++] = value;
  }
  return found;
}

void print(void* host, const char* text) {
  HostSharedMemory& b = host_of(host).block();
  if (b.mode != ADORE_START && b.mode != ADORE_PRINT) return;
  b.print.add(text);
  b.print.add("\n");
}
void write(void* host, const char* text) {
  HostSharedMemory& b = host_of(host).block();
  if (b.mode == ADORE_START || b.mode == ADORE_STEP) b.write.add(text);
}
void fail(void* host, const char* text) {
  HostSharedMemory& b = host_of(host).block();
  b.fail.size = 0;
  b.fail.add(text);
}

constexpr adore_services kServices{read_numbers, read_line, print, write, fail};

}  // namespace

const adore_services* Host::services() noexcept { return &kServices; }

Host::Host(std::vector<std::string> lines) : lines_(std::move(lines)) {
  void* memory = mmap(nullptr, sizeof(HostSharedMemory), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    throw SolverError("there is not enough memory for the output of user routines");
  block_ = new (memory) HostSharedMemory;
}
Host::~Host() { munmap(block_, sizeof(HostSharedMemory)); }

std::vector<double> parse_list_directed(const std::string& line) {
  std::vector<double> out;
  const char* at = line.data();
  const char* const end = at + line.size();
  const auto number = [&](double& value) {
    std::string word;
    const char* from = at;
    if (from != end && *from == '+') ++from;
    while (from != end && (std::isalnum(static_cast<unsigned char>(*from)) != 0 || *from == '.' ||
                           *from == '-' || *from == '+')) {
      const char c = *from++;
      word += c == 'd' || c == 'D' ? 'e' : c;
    }
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size()) return false;
    at = from;
    return true;
  };
  constexpr int kMost = 100'000;
  while (at != end) {
    if (*at == ' ' || *at == '\t' || *at == ',' || *at == '\r') {
      ++at;
      continue;
    }
    double value = 0.0;
    if (!number(value)) break;
    int repeat = 1;
    if (at != end && *at == '*') {
      ++at;
      if (!(value >= 1.0 && value <= kMost)) break;
      repeat = static_cast<int>(value);
      if (!number(value)) break;
    }
    out.insert(out.end(), static_cast<std::size_t>(repeat), value);
  }
  return out;
}

}  // namespace adore::user

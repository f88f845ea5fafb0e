#include "results/h5_process.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "results/hdf5_handle.hpp"
#include "results/reader_killed.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ADORE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ADORE_SANITIZED 1
#endif
#endif

/// Only with the preset `coverage`: the child then ends normally and writes its coverage.
extern "C" void __gcov_dump() __attribute__((weak));

namespace adore::results::h5 {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kPiece = std::size_t{1} << 17;  ///< values in one answer
constexpr std::size_t kMaxContentBytes = std::size_t{64} << 20, kMaxSentenceLength = 1 << 16;

enum class Kind : std::uint8_t { Refused, Content, Values };

/// Before the bytes of each answer.
struct Head {
  Kind kind = Kind::Refused;
  std::uint64_t bytes = 0;
};

/// Before the channel's name.
struct Request {
  std::uint64_t first = 0, count = 0, every = 1, name = 0;
};

bool send_all(int socket, const void* data, std::size_t count) {
  const char* bytes = static_cast<const char*>(data);
  while (count > 0) {
    const ssize_t sent = ::send(socket, bytes, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool send_answer(int socket, Kind kind, const void* data, std::size_t count) {
  const Head head{kind, count};
  return send_all(socket, &head, sizeof head) && send_all(socket, data, count);
}

Json to_json(const Content& content) {
  Json channels = Json::array();
  for (const H5Reader::ChannelInfo& info : content.channels)
    channels.push_back(
        {info.id, info.label, info.unit, info.frame, info.description, info.dimensions});
  return {content.version, content.run_id, content.steps, content.geometry, channels};
}

Content from_json(const Json& json) {
  Content content;
  content.version = json.at(0).get<std::string>();
  content.run_id = json.at(1).get<std::string>();
  content.steps = json.at(2).get<std::size_t>();
  content.geometry = json.at(3).get<std::map<std::string, double>>();
  for (const Json& row : json.at(4))
    content.channels.push_back({row.at(0).get<std::string>(), row.at(1).get<std::string>(),
                                row.at(2).get<std::string>(), row.at(3).get<std::string>(),
                                row.at(4).get<std::string>(),
                                row.at(5).get<std::vector<std::size_t>>()});
  return content;
}

void limit_memory(const ReaderLimits& limits) {
#ifdef ADORE_SANITIZED
  (void)limits;  // their shadow memory alone is terabytes
#else
  std::uint64_t pages = 0;
  InputFile("/proc/self/statm") >> pages;
  const rlim_t most = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) + limits.memory;
  const struct rlimit space { most, most };
  ::setrlimit(RLIMIT_AS, &space);
#endif
}

/// So much processor time from now on; SIGXCPU ends the process.
void limit_time(const ReaderLimits& limits) {
  struct rusage used {};
  ::getrusage(RUSAGE_SELF, &used);
  const rlim_t soft =
      static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + limits.cpu.count());
  const struct rlimit time { soft, RLIM_INFINITY };
  ::setrlimit(RLIMIT_CPU, &time);
}

/// The child's own surroundings: its parent's handlers, terminal and files are none of its
/// business.
void settle_in(int socket, const ReaderLimits& limits) {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGPIPE})
    std::signal(number, SIG_DFL);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::signal(number, SIG_IGN);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int file : {0, 1, 2})
    if (nowhere >= 0 && file != socket) ::dup2(nowhere, file);
  if (socket > 3) ::close_range(3, static_cast<unsigned>(socket) - 1, 0);
  ::close_range(static_cast<unsigned>(std::max(socket + 1, 3)), ~0U, 0);
  const struct rlimit none { 0, 0 };
  ::setrlimit(RLIMIT_CORE, &none);
  limit_memory(limits);
  limit_time(limits);
}

bool receive_all(int socket, void* data, std::size_t count) {
  char* bytes = static_cast<char*>(data);
  while (count > 0) {
    const ssize_t got = ::recv(socket, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

/// Does what it shall, or says in a sentence why it cannot.
void answer_with(int socket, const std::function<void()>& act) {
  const Hdf5Lock quiet;
  const auto refuse = [&](std::string_view why) {
    return send_answer(socket, Kind::Refused, why.data(), std::min(why.size(), kMaxSentenceLength));
  };
  try {
    act();
  } catch (const InputError& error) {
    refuse(error.what());
  } catch (const std::bad_alloc&) {
    refuse(
        "reading the file needs more memory than a valid file of this size; the file is damaged");
  } catch (const std::exception& error) {
    refuse(fmt::format("the file is damaged ({})", error.what()));
  }
}

/// Answers until the parent closes its end.
void serve(int socket, const std::filesystem::path& path, const ReaderLimits& limits) {
  File file(path);
  const std::vector<std::uint8_t> content = Json::to_cbor(to_json(file.content()));
  if (!send_answer(socket, Kind::Content, content.data(), content.size())) return;
  Request request;
  while (receive_all(socket, &request, sizeof request)) {
    std::string id(request.name, '\0');
    if (!receive_all(socket, id.data(), id.size())) return;
    limit_time(limits);
    const std::vector<double> values = file.read(id, request.first, request.count, request.every);
    if (!send_answer(socket, Kind::Values, values.data(), values.size() * sizeof(double))) return;
  }
}

}  // namespace

ReaderProcess::ReaderProcess(std::filesystem::path path, ReaderLimits limits)
    : ReaderProcess(path, limits, [&](int socket) { serve(socket, path, limits); }) {
  try {
    content_ = from_json(Json::from_cbor(answer(kMaxContentBytes)));
  } catch (const nlohmann::json::exception&) {
    fail("the file is damaged");
  }
}

ReaderProcess::ReaderProcess(std::filesystem::path path, ReaderLimits limits,
                             const std::function<void(int)>& serving)
    : path_(std::move(path)), limits_(limits) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw_reader_killed(
        fmt::format("cannot start a process that reads the file ({})", std::strerror(errno)));
  {
    const std::scoped_lock nobody_inside(hdf5_mutex());
    child_pid_ = ::fork();
  }
  if (child_pid_ == 0) {
    std::construct_at(&hdf5_mutex());  // locked by a thread that is not here
    settle_in(ends[1], limits_);
    answer_with(ends[1], [&] { serving(ends[1]); });
    if (__gcov_dump != nullptr) __gcov_dump();
    ::_exit(0);
  }
  const int reason = errno;
  ::close(ends[1]);
  socket_ = ends[0];
  if (child_pid_ < 0)
    throw_reader_killed(
        fmt::format("cannot start a process that reads the file ({})", std::strerror(reason)));
}

std::string read_in_child_process(const std::filesystem::path& path,
                                  const std::function<std::string()>& reader, std::size_t most,
                                  ReaderLimits limits) {
  ReaderProcess process(path, limits, [&](int socket) {
    const std::string bytes = reader();
    send_answer(socket, Kind::Content, bytes.data(), bytes.size());
  });
  return process.answer(most);
}

ReaderProcess::~ReaderProcess() { end(); }

void ReaderProcess::end() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
  if (child_pid_ <= 0) return;
  if (__gcov_dump == nullptr) ::kill(child_pid_, SIGKILL);
  while (::waitpid(child_pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
  child_pid_ = -1;
}

void ReaderProcess::fail(std::string_view why) {
  end();
  throw InputError(fmt::format("{}: {}", path_.string(), why));
}

void ReaderProcess::throw_reader_killed(std::string_view why) {
  end();
  throw ReaderKilled(fmt::format("{}: {}", path_.string(), why));
}

void ReaderProcess::throw_child_ended() {
  ::close(socket_);  // should it live after all, it ends now
  socket_ = -1;
  int status = 0;
  pid_t gone = 0;
  while ((gone = ::waitpid(child_pid_, &status, 0)) < 0 && errno == EINTR) {
  }
  child_pid_ = -1;
  const int signal = gone > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU)
    fail(fmt::format(
        "reading the file did not end within {} s of processor time; the file is damaged",
        limits_.cpu.count()));
  if (signal == SIGKILL)  // somebody, or the system when memory ends; our limits do not
    throw_reader_killed("the process that read the file was killed; try again");
  fail(signal != 0
           ? fmt::format("the HDF5 library failed to read the file ({}); the file is damaged",
                         ::strsignal(signal))
           : std::string("the HDF5 library failed to read the file; the file is damaged"));
}

void ReaderProcess::receive(char* bytes, std::size_t count) {
  using Clock = std::chrono::steady_clock;
  auto patience = Clock::now() + limits_.silence;
  while (count > 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(patience - Clock::now()).count();
    struct pollfd ready {
      socket_, POLLIN, 0
    };
    const int any = ::poll(&ready, 1, static_cast<int>(std::max<long>(left, 0)));
    if (any < 0 && errno == EINTR) continue;
    if (any == 0)
      throw_reader_killed(
          fmt::format("reading the file did not end within {} s; the file is damaged, or the disk "
                      "does not respond",
                      limits_.silence.count()));
    const ssize_t got = ::recv(socket_, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw_child_ended();
    bytes += got;
    count -= static_cast<std::size_t>(got);
    patience = Clock::now() + limits_.silence;
  }
}

std::string ReaderProcess::answer(std::size_t most) {
  Head head;
  receive(reinterpret_cast<char*>(&head), sizeof head);
  if (head.kind == Kind::Refused) most = kMaxSentenceLength;
  if (head.bytes > most) fail("the file is damaged");
  std::string bytes(head.bytes, '\0');
  receive(bytes.data(), bytes.size());
  if (head.kind == Kind::Refused) fail(bytes);
  return bytes;
}

std::vector<double> ReaderProcess::read(const std::string& id, std::size_t width, std::size_t first,
                                        std::size_t count, std::size_t every) {
  if (socket_ < 0) fail("an earlier attempt to read the file failed; the file is damaged");
  std::vector<double> values;
  values.reserve(count * width);
  const std::size_t rows = std::max<std::size_t>(kPiece / width, 1);
  for (std::size_t done = 0; done < count; done += rows) {
    const Request request{first + done * every, std::min(rows, count - done), every, id.size()};
    if (!send_all(socket_, &request, sizeof request) || !send_all(socket_, id.data(), id.size()))
      throw_child_ended();
    const std::string bytes = answer(request.count * width * sizeof(double));
    if (bytes.size() != request.count * width * sizeof(double)) fail("the file is damaged");
    const std::size_t old = values.size();
    values.resize(old + request.count * width);
    std::memcpy(values.data() + old, bytes.data(), bytes.size());
  }
  return values;
}

}  // namespace adore::results::h5

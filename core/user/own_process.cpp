#include "base/errors.hpp"
#include "user/arguments.hpp"
#include "user/plug_in.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <poll.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <type_traits>
#include <unistd.h>
#include <vector>

/// A plug-in in a process of its own: a child of this one that loads it and answers calls. Both see
/// one block of shared memory at the same address, where the arguments of a call are laid down,
/// pointers and all; one byte through a socket says that it is the other's turn. A first child says
/// which routines there are; the one that works is made at the first call, when all that the
/// services need is there.
namespace adore::user {
namespace {

constexpr std::size_t kArena = std::size_t{64} << 20;  ///< touched only as far as it is used
constexpr std::size_t kText = 1024;

/// At the beginning of the shared memory.
struct Mailbox {
  std::int32_t result = 0;
  bool threw = false;
  std::uint32_t hooks = 0;  ///< bit k: there is a routine k
  char version[kText] = {};
  char text[kText] = {};  ///< what was thrown
};
constexpr std::size_t kArguments = (sizeof(Mailbox) + 63) / 64 * 64;

void put_text(char* to, std::string_view text) {
  const std::size_t n = std::min(text.size(), kText - 1);
  std::memcpy(to, text.data(), n);
  to[n] = '\0';
}
std::string text_of(const char* from) { return {from, ::strnlen(from, kText)}; }

/// Lays the arguments of a call down in the arena, and brings back what was written.
class Parcel {
 public:
  explicit Parcel(char* arena) : arena_(arena) {}

  adore_call& pack(adore_call& call) {
    const auto size = static_cast<std::size_t>(call.size);
    char* there = take(size);
    std::memcpy(there, &call, size);
    there_ = reinterpret_cast<adore_call*>(there);
    if (call.bearing != nullptr) {
      auto* bearing = reinterpret_cast<adore_bearing*>(take(sizeof(adore_bearing)));
      *bearing = *call.bearing;
      there_->bearing = bearing;
    }
    visit_arguments(*there_, Lay{*this});
    return *there_;
  }
  void unpack(adore_call& call) {
    next_ = 0;
    visit_arguments(call, Bring{*this, reinterpret_cast<char*>(&call)});
    call.active = there_->active;
    call.user = there_->user;
  }

 private:
  struct Lay {
    Parcel& of;
    template <class T>
    void in(T*& pointer, std::size_t count) const {
      of.laid_.push_back(nullptr);
      if (pointer == nullptr) return;
      char* to = of.take(count * sizeof(T));
      std::memcpy(to, pointer, count * sizeof(T));
      if constexpr (std::is_same_v<std::remove_const_t<T>, const char*>)  // texts, younger than it
        for (std::size_t k = 0; k < count; ++k) {
          const std::size_t bytes = std::strlen(pointer[k]) + 1;
          char* const text = of.take(bytes);
          std::memcpy(text, pointer[k], bytes);
          reinterpret_cast<const char**>(to)[k] = text;
        }
      pointer = reinterpret_cast<T*>(to);
      of.laid_.back() = to;
    }
    template <class T>
    void out(T*& pointer, std::size_t count, std::size_t, std::size_t) const {
      in(pointer, count);
    }
    void values(double*, std::size_t) const {}
    void flags(std::int32_t*, std::size_t) const {}
  };
  struct Bring {
    Parcel& of;
    char* begin;
    template <class T>
    void in(T*&, std::size_t) const {
      ++of.next_;
    }
    template <class T>
    void out(T*& pointer, std::size_t count, std::size_t, std::size_t) const {
      const char* from = of.laid_[of.next_++];
      if (from != nullptr) std::memcpy(pointer, from, count * sizeof(T));
    }
    template <class T>
    void numbers(T* first, std::size_t count) const {
      std::memcpy(first,
                  reinterpret_cast<char*>(of.there_) + (reinterpret_cast<char*>(first) - begin),
                  count * sizeof(T));
    }
    void values(double* first, std::size_t count) const { numbers(first, count); }
    void flags(std::int32_t* first, std::size_t count) const { numbers(first, count); }
  };

  char* take(std::size_t bytes) {
    char* out = arena_ + at_;
    at_ += (bytes + 63) / 64 * 64;
    if (at_ > kArena)
      throw std::runtime_error("the arguments of the routine are too large for a separate process");
    return out;
  }

  char* arena_;
  std::size_t at_ = kArguments, next_ = 0;
  std::vector<char*> laid_;
  adore_call* there_ = nullptr;
};

class Worker {
 public:
  Worker(std::filesystem::path file, double timeout) : file_(std::move(file)), timeout_(timeout) {
    void* memory = mmap(nullptr, kArena, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED)
      throw SolverError("there is not enough memory for the separate process of a plug-in");
    arena_ = static_cast<char*>(memory);
    new (arena_) Mailbox;
  }
  ~Worker() {
    stop();
    munmap(arena_, kArena);
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  [[nodiscard]] Mailbox& mail() noexcept { return *reinterpret_cast<Mailbox*>(arena_); }

  /// A child that only says what there is.
  void probe() {
    start(true);
    wait_for_turn("loading");
    stop();
    if (mail().threw) throw InputError(text_of(mail().text));
  }
  std::int32_t call(adore_call& call) {
    if (child_ == 0) start(false);
    if (child_ < 0)
      throw std::runtime_error("the separate process of the plug-in ended in an earlier call");
    Parcel parcel(arena_);
    (void)parcel.pack(call);
    const char turn = 1;
    if (write(socket_, &turn, 1) != 1) ended("call");
    wait_for_turn("call");
    parcel.unpack(call);
    if (mail().threw) throw std::runtime_error(text_of(mail().text));
    return mail().result;
  }

 private:
  void start(bool probe) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw SolverError("the socket to the separate process of a plug-in cannot be created");
    const pid_t parent = getpid();
    child_ = fork();
    if (child_ < 0) {
      close(ends[0]), close(ends[1]);
      throw SolverError("the separate process of a plug-in cannot be started");
    }
    if (child_ == 0) {
      close(ends[0]);
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != parent) _exit(0);
      std::signal(SIGINT, SIG_IGN);  // it is the program that is interrupted
      for (const int one : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGPIPE})
        std::signal(one, SIG_DFL);
      serve(ends[1], probe);
      _exit(0);
    }
    close(ends[1]);
    socket_ = ends[0];
  }

  /// The child: loads, then answers one call after the other.
  void serve(int socket, bool probe) noexcept {
    const auto safely = [this](const auto& action) {
      mail().threw = false;
      try {
        action();
      } catch (const std::exception& error) {
        mail().threw = true;
        put_text(mail().text, error.what());
      } catch (...) {
        mail().threw = true;
        put_text(mail().text, "the plug-in threw an object that is not a std::exception");
      }
    };
    PlugIn plug_in;
    safely([&] { plug_in = load_plug_in(file_); });
    char turn = 1;
    if (probe) {
      mail().hooks = 0;
      for (int k = 0; k < static_cast<int>(kHooks); ++k)
        if (plug_in.has(k)) mail().hooks |= 1U << static_cast<unsigned>(k);
      put_text(mail().version, plug_in.version);
      (void)!write(socket, &turn, 1);
      _exit(0);
    }
    while (read(socket, &turn, 1) == 1) {
      auto& call = *reinterpret_cast<adore_call*>(arena_ + kArguments);
      safely([&] { mail().result = plug_in.hooks.at(static_cast<std::size_t>(call.hook))(call); });
      if (write(socket, &turn, 1) != 1) break;
    }
    _exit(0);
  }

  void wait_for_turn(const char* what) {
    pollfd ready{socket_, POLLIN, 0};
    int found = 0;
    do {
      found = poll(&ready, 1, static_cast<int>(1000.0 * timeout_));
    } while (found < 0 && errno == EINTR);
    if (found == 0) {
      stop();
      child_ = -1;
      throw std::runtime_error(
          fmt::format("the {} took more than {:g} s, so the separate process of the plug-in was "
                      "stopped; allow more time with --opt userTimeout=SECONDS",
                      what, timeout_));
    }
    char turn = 0;
    if (read(socket_, &turn, 1) != 1) ended(what);
  }

  [[noreturn]] void ended(const char* what) {
    int status = 0;
    pid_t found = 0;
    do {
      found = waitpid(child_, &status, 0);
    } while (found < 0 && errno == EINTR);
    close(socket_);
    socket_ = -1;
    child_ = -1;
    if (found > 0 && WIFSIGNALED(status))
      throw std::runtime_error(
          fmt::format("the process of the plug-in crashed during the {} (signal {}: {})", what,
                      WTERMSIG(status), strsignal(WTERMSIG(status))));
    throw std::runtime_error(
        fmt::format("the process of the plug-in ended during the {} (exit code {})", what,
                    found > 0 ? WEXITSTATUS(status) : -1));
  }

  void stop() noexcept {
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
    if (child_ > 0) {
      kill(child_, SIGKILL);
      int status = 0;
      while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
      }
    }
    child_ = 0;
  }

  std::filesystem::path file_;
  double timeout_;
  char* arena_ = nullptr;
  pid_t child_ = 0;  ///< -1: it was there, and is no more
  int socket_ = -1;
};

}  // namespace

PlugIn load_in_own_process(const std::filesystem::path& file, double timeout) {
  std::error_code error;
  if (file.extension() == ".json" || !std::filesystem::exists(file, error))
    return load_plug_in(file);  // formulas crash nothing
  std::signal(SIGPIPE, SIG_IGN);
  auto worker = std::make_shared<Worker>(file, timeout);
  try {
    worker->probe();
  } catch (const std::runtime_error& what) {
    if (dynamic_cast<const InputError*>(&what) != nullptr) throw;
    throw InputError(
        fmt::format("the plug-in {} cannot be loaded: {}", file.string(), what.what()));
  }
  PlugIn out;
  out.source = file.string();
  out.version = text_of(worker->mail().version);
  for (std::size_t k = 0; k < kHooks; ++k)
    if ((worker->mail().hooks >> k & 1U) != 0)
      out.hooks[k] = [w = worker.get()](adore_call& call) { return w->call(call); };
  out.keeper = worker;
  return out;
}

}  // namespace adore::user

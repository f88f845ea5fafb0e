#include "user/routine.hpp"

#include "user/arguments.hpp"
#include "user/crash_guard.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <exception>
#include <optional>

namespace adore::user {
namespace {

const char* mode_words(int mode) {
  switch (mode) {
    case ADORE_READ:
      return "reading its lines (mode -1)";
    case ADORE_START:
      return "documenting (mode 0)";
    case ADORE_COMPUTE:
      return "computing (mode 1)";
    case ADORE_PRINT:
      return "printing (mode 2)";
    default:
      return "ending a step (mode 3)";
  }
}

/// No sum of finite numbers is missed; one of huge numbers is looked at again.
bool looks_finite(const double* first, std::size_t count) {
  return std::isfinite(
      Eigen::Map<const Eigen::ArrayXd>(first, static_cast<Eigen::Index>(count)).sum());
}

/// The first number of the answer that is none.
struct NonFinite {
  std::string found;
  void in(const void*, std::size_t) {}
  template <class T>
  void in(T*&, std::size_t) {}
  void flags(std::int32_t*, std::size_t) {}
  void values(double* first, std::size_t count) {
    if (found.empty()) look(first, count, 0, 0, "value");
  }
  void out(double*& first, std::size_t count, std::size_t columns, std::size_t stride) {
    if (first == nullptr || !found.empty()) return;
    if (columns == stride || columns == 0) {
      look(first, count, columns, stride, "entry");
      return;
    }
    for (std::size_t row = 0; row * stride < count; ++row)
      look(first + row * stride, columns, 0, 0, "entry");
  }

 private:
  void look(const double* first, std::size_t count, std::size_t columns, std::size_t stride,
            const char* what) {
    if (count == 0 || looks_finite(first, count)) return;
    for (std::size_t k = 0; k < count; ++k)
      if (!std::isfinite(first[k])) {
        const std::size_t shown = columns > 0 && stride > 0 ? k % stride : k;
        found =
            fmt::format("{} {} of the result is {}, not a finite number", what, shown, first[k]);
        return;
      }
  }
};

/// Is everything that it was asked a number?
struct AskedNumbers {
  bool finite = true;
  template <class T>
  void in(T*& first, std::size_t count) {
    if constexpr (std::is_same_v<std::remove_const_t<T>, double>)
      for (std::size_t k = 0; first != nullptr && k < count; ++k)
        finite = finite && std::isfinite(first[k]);
  }
  template <class T>
  void out(T*&, std::size_t, std::size_t, std::size_t) {}
  void values(double*, std::size_t) {}
  void flags(std::int32_t*, std::size_t) {}
};

}  // namespace

/// What a call was given, or what it answered: bytes, one array after the other.
struct UserRoutine::Copies {
  std::vector<char> self;
  std::vector<std::vector<char>> read, written;

  explicit Copies(adore_call& call) {
    const char* begin = reinterpret_cast<const char*>(&call);
    self.assign(begin, begin + call.size);
    visit_arguments(call, *this);
  }
  template <class T>
  void in(T*& first, std::size_t count) {
    keep(read, first, count);
  }
  template <class T>
  void out(T*& first, std::size_t count, std::size_t, std::size_t) {
    keep(written, first, count);
  }
  void values(double*, std::size_t) {}
  void flags(std::int32_t*, std::size_t) {}

  template <class T>
  static void keep(std::vector<std::vector<char>>& to, T* first, std::size_t count) {
    const char* bytes = reinterpret_cast<const char*>(first);
    to.emplace_back(bytes, bytes == nullptr ? bytes : bytes + count * sizeof(T));
  }
};

namespace {

/// Writes the outputs of a copy back.
struct Restore {
  const std::vector<std::vector<char>>& from;
  std::size_t next = 0;
  template <class T>
  void in(T*&, std::size_t) {}
  template <class T>
  void out(T*& first, std::size_t, std::size_t, std::size_t) {
    const std::vector<char>& bytes = from[next++];
    if (!bytes.empty()) std::memcpy(first, bytes.data(), bytes.size());
  }
  void values(double*, std::size_t) {}
  void flags(std::int32_t*, std::size_t) {}
};

}  // namespace

UserRoutine::UserRoutine(int hook, const PlugIn& plug_in, Host& host, long sample)
    : hook_(hook),
      name_(hook_name(hook)),
      plug_in_(plug_in),
      call_(plug_in.hooks[static_cast<std::size_t>(hook)]),
      host_(host),
      sample_(plug_in.pure ? 0 : sample) {}

std::string UserRoutine::where(const adore_call& call) const {
  std::string out = fmt::format("user routine {} of {}, call {}, {}", name_, plug_in_.source,
                                calls_, mode_words(call.mode));
  if (call.mode > ADORE_START && hook_ != 0 && hook_ != 8)
    out += fmt::format(", at t = {:.9g} s", call.time);
  if (hook_ == 7 && call.mode == ADORE_COMPUTE) {
    constexpr const char* kKinds[] = {"element to race", "element to cage", "cage to race",
                                      "roller to flange", "element to element"};
    const auto& a = reinterpret_cast<const adore_adrx7&>(call);
    out += fmt::format(", {}", kKinds[a.kind]);
    if (a.race >= 0) out += a.race == 0 ? ", outer race" : ", inner race";
  }
  return out;
}

Answer UserRoutine::fail(const adore_call& call, const std::string& what) {
  broken_ = true;
  reason_ = fmt::format("{}: {}", where(call), what);
  return Answer::Failed;
}

std::int32_t UserRoutine::run(adore_call& call) {
  if (!plug_in_.foreign) return call_(call);
  const CallMark mark{name_.c_str(), plug_in_.source.c_str(), calls_, call.time};
  struct CallMarkScope {
    explicit CallMarkScope(const CallMark& mark) { CrashGuard::enter(mark); }
    ~CallMarkScope() { CrashGuard::leave(); }
  } marked(mark);
  return call_(call);
}

std::string UserRoutine::check_repeatability(adore_call& call, const Copies& before) {
  const Copies first(call);
  for (std::size_t k = 0; k < before.read.size(); ++k)
    if (before.read[k] != first.read[k])
      return "the routine changed its input arrays, which belong to the solver; treat them as "
             "read-only";
  std::memcpy(&call, before.self.data(), before.self.size());
  visit_arguments(call, Restore{before.written});
  if (run(call) != 0)
    return "the routine was called twice with the same arguments and failed in the second call; "
           "keep no values between calls";
  const Copies second(call);
  if (first.written != second.written || first.self != second.self)
    return "the routine was called twice with the same arguments and gave different results. The "
           "results must depend on the arguments only: keep no values between calls, and use no "
           "random numbers";
  return {};
}

Answer UserRoutine::ask(adore_call& call, std::int32_t size) {
  if (broken_) return Answer::Failed;
  ++calls_;
  call.abi = ADORE_USER_ABI;
  call.size = size;
  call.hook = hook_;
  call.active = active_ ? 1 : 0;
  call.user = user_;
  call.host = &host_;
  call.services = Host::services();
  call.bearing = call.mode == ADORE_READ ? nullptr : bearing;
  host_.block().mode = call.mode;
  const bool compute = call.mode == ADORE_COMPUTE && hook_ >= 1 && hook_ <= 7;
  const bool twice = compute && sample_ > 0 && (computed_++ < 2 || computed_ % sample_ == 0);
  std::string trouble;
  try {
    std::optional<Copies> before;
    if (twice) before.emplace(call);
    const std::int32_t result = run(call);
    if (result == 1 && compute) {
      reason_ =
          fmt::format("{}: the routine has no result for this state (return value 1)", where(call));
      if (std::string why = host_.block().fail.take(); !why.empty()) reason_ += ": " + why;
      return Answer::Refused;
    }
    if (result != 0) {
      const std::string why = host_.block().fail.take();
      return fail(call,
                  fmt::format("the routine returned {}{}", result, why.empty() ? "" : ": " + why));
    }
    if (twice) trouble = check_repeatability(call, *before);
  } catch (const std::exception& error) {
    return fail(call, fmt::format("the routine failed: {}", error.what()));
  } catch (...) {
    return fail(call, "the routine threw an exception that is not a std::exception");
  }
  if (!trouble.empty()) return fail(call, trouble);
  NonFinite answer;
  visit_arguments(call, answer);
  if (!answer.found.empty()) {
    AskedNumbers asked;
    visit_arguments(call, asked);
    if (asked.finite) return fail(call, answer.found);
    reason_ =
        fmt::format("{}: the state of the solver contains a value that is not finite", where(call));
    return Answer::Refused;
  }
  if (call.mode == ADORE_READ) active_ = call.active != 0;
  user_ = call.user;
  return Answer::Good;
}

}  // namespace adore::user

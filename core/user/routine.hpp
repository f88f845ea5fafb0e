#pragma once

#include "user/host.hpp"
#include "user/plug_in.hpp"

#include <string>
#include <vector>

/// One routine of a plug-in with the checks of what it answers.
namespace adore::user {

enum class Answer : unsigned char {
  Good,
  Refused,  ///< the state is outside of what it knows, or was none: a smaller step may help
  Failed    ///< for good
};

class UserRoutine {
 public:
  UserRoutine(int hook, const PlugIn& plug_in, Host& host, long sample);

  /// Sets the first member but for time and step, and asks. The reason of what is not good stands
  /// in reason().
  Answer ask(adore_call& call, std::int32_t size);
  [[nodiscard]] int hook() const noexcept { return hook_; }
  [[nodiscard]] bool active() const noexcept { return active_; }
  [[nodiscard]] long calls() const noexcept { return calls_; }
  /// A sentence that names routine and call.
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }
  const adore_bearing* bearing = nullptr;

 private:
  struct Copies;
  std::int32_t run(adore_call& call);
  Answer fail(const adore_call& call, const std::string& what);
  [[nodiscard]] std::string where(const adore_call& call) const;
  /// A copy of it is asked the same; what differs, empty: nothing.
  std::string check_repeatability(adore_call& call, const Copies& before);

  int hook_;
  std::string name_;
  const PlugIn& plug_in_;
  const Call& call_;
  Host& host_;
  long sample_, calls_ = 0, computed_ = 0;
  bool active_ = false, broken_ = false;
  void* user_ = nullptr;
  std::string reason_;
};

}  // namespace adore::user

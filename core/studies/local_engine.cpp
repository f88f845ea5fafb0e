#include "base/counted.hpp"
#include "base/write_error.hpp"
#include "studies/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <map>
#include <memory>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/// One process per core. A process that dies takes only its run with it: another one repeats
/// the run. A run whose process crashes gets a record of that. A kill
/// from outside (SIGKILL, SIGTERM ...) is not caused by the run and never becomes a record: the run
/// is repeated after the others, and one that is killed repeatedly stays unfinished. The system
/// kills processes when memory is short, so after SIGKILL fewer of them are used.
namespace adore::studies {
namespace {

using Clock = std::chrono::steady_clock;

/// Part of the free memory that may be planned for.
constexpr double kUsableMemoryShare = 0.8;
constexpr double kMinMegabytes = 64.0;

class Worker {
 public:
  explicit Worker(const EngineRequest& work) {
    std::array<int, 2> in{}, out{};
    if (pipe2(in.data(), O_CLOEXEC) != 0) refuse();
    if (pipe2(out.data(), O_CLOEXEC) != 0) {
      close(in[0]);
      close(in[1]);
      refuse();
    }
    const std::string program = work.program.string(), folder = work.folder.string();
    const std::array<const char*, 5> argv{program.c_str(), "study", "work", folder.c_str(),
                                          nullptr};
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (getppid() != parent) _exit(130);  // it died before that line
      // Ctrl-C goes to everybody at the terminal: the driver alone decides.
      setpgid(0, 0);
      dup2(in[0], STDIN_FILENO);
      dup2(out[1], STDOUT_FILENO);
      execv(program.c_str(), const_cast<char* const*>(argv.data()));
      _exit(127);
    }
    const int reason = errno;
    close(in[0]);
    close(out[1]);
    in_ = in[1];
    out_ = out[0];
    if (pid_ < 0) {
      errno = reason;
      refuse();
    }
  }
  ~Worker() {
    if (in_ >= 0) close(in_);
    if (pid_ > 0) {
      kill(pid_, SIGTERM);
      (void)wait();
    }
    if (out_ >= 0) close(out_);  // last: it may be saying that a run is done
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  [[nodiscard]] int out() const { return out_; }
  [[nodiscard]] const Task* task() const { return task_; }

  /// False when it is dead. SIGPIPE is ignored by the program.
  bool send_task(const Task& task) {
    task_ = &task;
    const std::string line = task_line(task);
    std::size_t sent = 0;
    while (sent < line.size()) {
      const ssize_t n = write(in_, line.data() + sent, line.size() - sent);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      sent += static_cast<std::size_t>(n);
    }
    return true;
  }

  /// Whole lines that it said since; `gone` when its end of the pipe is closed.
  std::vector<std::string> lines(bool& gone) {
    std::array<char, 4096> block{};
    const ssize_t n = read(out_, block.data(), block.size());
    gone = n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN);
    if (n > 0) said_.append(block.data(), static_cast<std::size_t>(n));
    std::vector<std::string> out;
    for (std::size_t end = said_.find('\n'); end != std::string::npos; end = said_.find('\n')) {
      out.push_back(said_.substr(0, end));
      said_.erase(0, end + 1);
    }
    return out;
  }
  void is_free() { task_ = nullptr; }

  /// How it ended, as waitpid tells.
  int wait() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

 private:
  [[noreturn]] static void refuse() {
    throw WriteError(
        fmt::format("no further process can be started: {}; raise the limit of processes and files "
                    "(ulimit -u, -n), or give a smaller number with --workers",
                    std::strerror(errno)));
  }
  pid_t pid_ = -1;
  int in_ = -1, out_ = -1;
  const Task* task_ = nullptr;
  std::string said_;
};

struct Deaths {
  int crashes = 0, kills = 0;
};

class LocalEngine {
 public:
  LocalEngine(const EngineRequest& work, const TaskDone& done, const EngineNews& news)
      : work_(work), done_(done), news_(news), megabytes_(work.megabytes_each) {
    for (const Task& task : work.tasks) waiting_.push_back(&task);
    most_ = work.workers > 0 ? work.workers : usable_cores();
  }

  void run(const std::stop_token& stop) {
    while (!stop.stop_requested() && (!waiting_.empty() || busy() > 0)) {
      distribute_tasks();
      read_messages();
    }
    if (left_ > 0 && !stop.stop_requested())
      throw InputError(
          fmt::format("{} no result, because the process was killed {} times, by a user or by the "
                      "system when memory was short. All other runs are recorded. Continue with "
                      "`adore study resume`; if memory is short, add --workers 1",
                      counted(left_, "run has", "runs have"), kMaxKills));
  }

 private:
  [[nodiscard]] int busy() const {
    return static_cast<int>(std::count_if(workers_.begin(), workers_.end(),
                                          [](const auto& w) { return w->task() != nullptr; }));
  }

  /// One more only where it finds its memory; one always works.
  [[nodiscard]] bool can_start_worker() const {
    if (static_cast<int>(workers_.size()) >= most_) return false;
    return workers_.empty() ||
           available_memory_megabytes() * kUsableMemoryShare > std::max(megabytes_, kMinMegabytes);
  }

  void distribute_tasks() {
    for (const auto& worker : workers_) {
      if (waiting_.empty()) break;
      if (worker->task() == nullptr) send_task(*worker);
    }
    while (!waiting_.empty() && can_start_worker()) {
      workers_.push_back(std::make_unique<Worker>(work_));
      send_task(*workers_.back());
    }
    const bool memory_limits = !waiting_.empty() && static_cast<int>(workers_.size()) < most_;
    std::string note =
        memory_limits ? "memory allows " + counted(workers_.size(), "process", "processes") : "";
    if (kills_ > 0)
      note += fmt::format("{}{} repeated", note.empty() ? "" : ", ", counted(kills_, "killed run"));
    news_(busy(), note);
  }

  void send_task(Worker& worker) {
    const Task* task = waiting_.front();
    waiting_.pop_front();
    (void)worker.send_task(*task);  // read_messages() finds a dead process
  }

  void read_messages() {
    std::vector<pollfd> files;
    for (const auto& worker : workers_) files.push_back({worker->out(), POLLIN, 0});
    constexpr int kPollMilliseconds = 200;  // [ms]
    if (poll(files.data(), files.size(), kPollMilliseconds) <= 0) return;
    std::vector<std::size_t> dead;
    for (std::size_t k = 0; k < files.size(); ++k) {
      if (files[k].revents == 0) continue;
      bool gone = false;
      for (const std::string& line : workers_[k]->lines(gone)) handle_message(*workers_[k], line);
      if (gone) dead.push_back(k);
    }
    for (auto k = dead.rbegin(); k != dead.rend(); ++k) {
      const auto at = workers_.begin() + static_cast<long>(*k);
      std::unique_ptr<Worker> worker = std::move(*at);
      workers_.erase(at);
      handle_death(*worker);
    }
  }

  void handle_message(Worker& worker, const std::string& line) {
    if (line.starts_with("halt ")) throw WriteError(line.substr(5));
    if (!line.starts_with("done ") || worker.task() == nullptr) return;
    const std::optional<Record> record = read_record(work_.folder, worker.task()->key);
    if (!record)
      throw WriteError(fmt::format("{}: the record of the run was written, but it cannot be read",
                                   run_record_path(work_.folder, worker.task()->key).string()));
    megabytes_ = std::max(megabytes_, record->memory_megabytes);
    worker.is_free();
    done_(*record);
  }

  void handle_death(Worker& worker) {
    const Task* task = worker.task();
    const int status = worker.wait();
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
      throw InputError(fmt::format("{} cannot be started", work_.program.string()));
    if (task == nullptr) return;
    // Its record may have been written before it died.
    if (const std::optional<Record> record = read_record(work_.folder, task->key)) {
      done_(*record);
      return;
    }
    Deaths& deaths = deaths_[task->key];
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    const bool outside = signal == SIGKILL || signal == SIGTERM || signal == SIGINT ||
                         signal == SIGHUP || (signal == 0 && WEXITSTATUS(status) == 130);
    ++(outside ? deaths.kills : deaths.crashes);
    if (outside) ++kills_;
    // Memory may have been the reason: one fewer as long as there are several.
    if (signal == SIGKILL &&
        available_memory_megabytes() * kUsableMemoryShare < std::max(megabytes_, kMinMegabytes) &&
        most_ > 1)
      --most_;
    if (outside) {
      if (deaths.kills < kMaxKills)
        waiting_.push_back(task);
      else
        ++left_;
      return;
    }
    if (deaths.crashes < kMaxCrashes) {
      waiting_.push_front(task);
      return;
    }
    Record record;
    record.key = task->key;
    record.exit_code = 1;
    record.values.assign(read_job(work_.folder).quantities.size(),
                         std::numeric_limits<double>::quiet_NaN());
    record.message = fmt::format(
        "the process of this run ended with {}, {}. This is a bug in Adore. Repeat the run "
        "with --retry-failed",
        signal != 0 ? fmt::format("signal {} ({})", signal, strsignal(signal))
                    : fmt::format("exit code {}", WEXITSTATUS(status)),
        counted(deaths.crashes, "time"));
    write_record(work_.folder, record);
    done_(record);
  }

  const EngineRequest& work_;
  const TaskDone& done_;
  const EngineNews& news_;
  std::deque<const Task*> waiting_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::map<std::string, Deaths> deaths_;
  int most_ = 1;
  long kills_ = 0, left_ = 0;  ///< deaths from outside; runs given up for them
  double megabytes_;
};

}  // namespace

void run_local(const EngineRequest& work, const TaskDone& done, const EngineNews& news,
               const std::stop_token& stop) {
  LocalEngine(work, done, news).run(stop);
}

}  // namespace adore::studies

#pragma once

#include "results/h5_file.hpp"

#include <chrono>
#include <functional>
#include <sys/types.h>

/// A separate process that reads one RESULTS.h5, or another HDF5 file. Effects of a crafted
/// file does to the HDF5 library (crash, endless loop, gigabytes of memory) happens there, within
/// limits, and reach the caller as one sentence. The child has only this file open,
/// writes nothing, and ends with its Process or when its parent dies.
namespace adore::results::h5 {

struct ReaderLimits {
  std::chrono::seconds silence{30};             ///< without an answer
  std::chrono::seconds cpu{20};                 ///< of processor time for one answer
  std::size_t memory = std::size_t{256} << 20;  ///< beyond what the parent has mapped [bytes]
};

class ReaderProcess {
 public:
  /// Opens the file in a new process. @throws InputError with the file's error, or
  /// the end of the process; ReaderKilled when the cause is not the file.
  explicit ReaderProcess(std::filesystem::path path, ReaderLimits limits = {});
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;
  ~ReaderProcess();

  [[nodiscard]] const Content& content() const noexcept { return content_; }
  /// As File::read(), in pieces. The caller has checked steps against content(). @throws InputError
  [[nodiscard]] std::vector<double> read(const std::string& id, std::size_t width,
                                         std::size_t first, std::size_t count, std::size_t every);

 private:
  friend std::string read_in_child_process(const std::filesystem::path& path,
                                           const std::function<std::string()>& reader,
                                           std::size_t most, ReaderLimits limits);
  /// A process that answers at its end of the socket. @throws ReaderKilled
  ReaderProcess(std::filesystem::path path, ReaderLimits limits,
                const std::function<void(int)>& serving);
  [[nodiscard]] std::string answer(std::size_t most);
  void receive(char* bytes, std::size_t count);
  [[noreturn]] void fail(std::string_view why);
  [[noreturn]] void throw_reader_killed(std::string_view why);  ///< @throws ReaderKilled
  /// Its end of the socket is closed: reports how it ended.
  [[noreturn]] void throw_child_ended();
  void end();

  std::filesystem::path path_;
  ReaderLimits limits_;
  pid_t child_pid_ = -1;
  int socket_ = -1;
  Content content_;
};

/// Result of `reader` for another kind of HDF5 file, in such a process: at most `most` bytes.
/// @throws InputError naming the file, as Process()
[[nodiscard]] std::string read_in_child_process(const std::filesystem::path& path,
                                                const std::function<std::string()>& reader,
                                                std::size_t most, ReaderLimits limits = {});

}  // namespace adore::results::h5

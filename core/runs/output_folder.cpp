#include "runs/output_folder.hpp"

#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/own_files.hpp"
#include "base/write_folder.hpp"
#include "results/restart.hpp"
#include "results/results_h5.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <fcntl.h>
#include <iterator>
#include <set>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

constexpr const char* kDefaultNames[] = {"PRINT.txt", "FINAL", "MASTER",   "SOL1",      "SOL2",
                                         "SOL3",      "SOL4",  "SOL5",     "SOL6",      "SOL7",
                                         "SOL8",      "SOL9",  "RUN.json", "RESULTS.h5"};

std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size() && i < 4; ++i) out += (i > 0 ? ", " : "") + names[i];
  if (names.size() > 4) out += fmt::format(" and {} more", names.size() - 4);
  return out;
}

constexpr std::string_view kLockPrefix = "process ";

/// Is the open file empty, or what an earlier process left as its lock?
bool is_lock(int descriptor) {
  struct stat status {};
  char start[kLockPrefix.size()];
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return false;
  const ssize_t size = ::pread(descriptor, start, sizeof start, 0);
  return size == 0 ||
         (size > 0 && kLockPrefix.starts_with({start, static_cast<std::size_t>(size)}));
}

std::string whoami() {
  char host[256] = "this machine";
  ::gethostname(host, sizeof host - 1);
  const std::time_t now = std::time(nullptr);
  return fmt::format("{}{} on {}, since {:%Y-%m-%d %H:%M:%S} UTC\n", kLockPrefix, ::getpid(), host,
                     fmt::gmtime(now));
}

[[noreturn]] void refuse_folder(const fs::path& folder, int error, std::string_view elsewhere) {
  throw InputError(
      fmt::format("{}: nothing can be written into this folder ({}); make the folder writable, "
                  "free some disk space, or {}",
                  folder.string(), std::generic_category().message(error), elsewhere));
}

/// The default file names, those of this run, and those that the earlier run lists.
std::set<std::string> candidates(const Outputs& outputs) {
  std::set<std::string> out(outputs.names.begin(), outputs.names.end());
  out.insert(std::begin(kDefaultNames), std::end(kDefaultNames));
  const auto add = [&](const std::string& name) {
    if (!name.empty() && name.find('/') == std::string::npos) out.insert(name);
  };
  try {
    InputFile stream(outputs.folder / "RUN.json");
    if (is_written_by_adore(outputs.folder / "RUN.json")) {
      const auto json = parse_json(std::string(std::istreambuf_iterator<char>(stream), {}), "");
      for (const auto& name : json.at("files")) add(name.get<std::string>());
    }
  } catch (const std::exception&) {
    // The default names will do.
  }
  for (const std::string& name : std::set<std::string>(out)) {
    if (!is_written_by_adore(outputs.folder / name)) continue;
    try {
      for (const results::MasterFileEntry& file : results::read_master(outputs.folder / name).files)
        add(file.name);
    } catch (const InputError&) {
      // No MASTER.
    }
  }
  return out;
}

/// Results of an earlier run in the folder.
std::vector<std::string> earlier_results(const Outputs& outputs) {
  std::vector<std::string> out;
  for (const std::string& name : candidates(outputs)) {
    std::error_code error;
    if (!fs::is_symlink(outputs.folder / name, error) && is_written_by_adore(outputs.folder / name))
      out.push_back(name);
  }
  return out;
}

/// Does `name` match `pattern`, where X is any letter or digit?
bool matches(const std::string& name, const std::string& pattern) {
  if (name.size() != pattern.size()) return false;
  const std::size_t stem = pattern.size() - 6;
  return name.compare(0, stem, pattern, 0, stem) == 0 &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(stem), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0; });
}

}  // namespace

FolderLock::FolderLock(WriteFolder folder, std::string_view elsewhere)
    : folder_(std::move(folder)) {
  const fs::path path = folder_.path() / kName;
  for (;;) {
    const int descriptor = folder_.open_lock(kName);
    if (descriptor < 0 && (errno == ELOOP || errno == EMLINK || errno == EINVAL || errno == ENXIO))
      throw InputError(
          fmt::format("{}: this name is reserved for the lock file of a run, but the file is a "
                      "link or not a regular file; remove the file, or {}",
                      path.string(), elsewhere));
    if (descriptor < 0) refuse_folder(folder_.path(), errno, elsewhere);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      if (error == EINTR) {
        ::close(descriptor);
        continue;
      }
      if (error == EWOULDBLOCK) {
        std::string who(400, '\0');
        const ssize_t size = ::pread(descriptor, who.data(), who.size(), 0);
        who.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
        who = who.substr(0, who.find('\n'));
        ::close(descriptor);
        throw InputError(fmt::format(
            "{}: another run is writing into this folder ({}); wait until that run ends, or {}",
            folder_.path().string(), who.empty() ? "started by an unknown process" : who,
            elsewhere));
      }
      ::close(descriptor);  // a file system without locks
      return;
    }
    struct stat here {
    }, there{};
    if (::fstat(descriptor, &here) == 0 &&
        ::fstatat(folder_.descriptor(), kName, &there, AT_SYMLINK_NOFOLLOW) == 0 &&
        here.st_dev == there.st_dev && here.st_ino == there.st_ino) {
      descriptor_ = descriptor;
      break;
    }
    ::close(descriptor);  // its owner removed it at that moment
  }
  if (!is_lock(descriptor_)) {
    ::close(descriptor_);
    throw InputError(
        fmt::format("{}: this name is reserved for the lock file of a run, but the file is not a "
                    "lock file; rename the file, or choose another folder with --out",
                    path.string()));
  }
  const std::string who = whoami();
  if (::ftruncate(descriptor_, 0) != 0 ||
      ::pwrite(descriptor_, who.data(), who.size(), 0) != static_cast<ssize_t>(who.size()))
    return;  // a full disk: the lock still works
}

bool FolderLock::is_free(const fs::path& lock) noexcept {
  const int descriptor = ::open(lock.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool free = is_lock(descriptor) && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return free;
}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  folder_.remove(kName);
  ::close(descriptor_);
}

void check_writable(const fs::path& folder, std::string_view elsewhere) {
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
    refuse_folder(folder, errno, elsewhere);
}

ResultsExist::ResultsExist(const fs::path& folder, const std::vector<std::string>& names)
    : InputError(fmt::format(
          "{}: the folder contains results of an earlier run ({}); continue that run with "
          "--continue, replace its results with --overwrite, or choose another folder with --out",
          folder.string(), joined(names))) {}

void check_names(const Outputs& outputs) {
  std::vector<Issue> issues;
  for (const std::string& name : outputs.names) {
    const fs::path path = outputs.folder / name;
    Issue issue;
    issue.file = path.string();
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (!fs::exists(status)) continue;
    const bool input =
        std::any_of(outputs.inputs.begin(), outputs.inputs.end(), [&](const fs::path& one) {
          std::error_code ignored;
          return fs::equivalent(one, path, ignored);
        });
    if (input) {
      issue.message = "this output file would replace an input file of the run";
      issue.remedy =
          "rename the input file, choose another output name on record 2.3, or choose another "
          "folder with --out";
    } else if (fs::is_symlink(status)) {
      issue.message = fmt::format("this output file is a symbolic link to {}",
                                  fs::read_symlink(path, error).string());
      issue.remedy = "remove the link, or choose another folder with --out";
    } else if (!fs::is_regular_file(status)) {
      issue.message = "this output file exists and is not a regular file";
      issue.remedy =
          "choose another output name on record 2.3, or choose another folder with --out";
    } else if ((fs::file_size(path, error) > 0 ||
                (status.permissions() & (fs::perms::owner_exec | fs::perms::group_exec |
                                         fs::perms::others_exec)) != fs::perms::none) &&
               !is_written_by_adore(path)) {
      issue.message = "this output file exists and was not written by this program";
      issue.remedy =
          "move the file away, choose another output name on record 2.3, or choose another folder "
          "with --out";
    } else if (write_protected(path)) {
      issue.message = "this output file is write-protected and was not changed";
      issue.remedy = "make the file writable (chmod u+w), or choose another folder with --out";
    } else {
      continue;
    }
    issues.push_back(issue);
  }
  if (!issues.empty()) throw InputError(std::move(issues));
}

void check_room(const Outputs& outputs, bool overwrite) {
  check_names(outputs);
  if (overwrite) return;
  const std::vector<std::string> found = earlier_results(outputs);
  if (!found.empty()) throw ResultsExist(outputs.folder, found);
}

void remove_leftovers(const Outputs& outputs, const WriteFolder& folder) {
  std::vector<std::string> patterns;
  const std::string unfinished_path = results::H5Writer::unfinished_path("RESULTS.h5").string();
  patterns.push_back(temporary_pattern(unfinished_path));
  for (const std::string& name : outputs.names) patterns.push_back(temporary_pattern(name));
  std::error_code error;
  std::vector<std::string> found{unfinished_path};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path(), error)) {
    const std::string name = entry.path().filename().string();
    for (const std::string& pattern : patterns)
      if (matches(name, pattern)) found.push_back(name);
  }
  for (const std::string& name : found) folder.remove(name);
}

fs::path make_room(const Outputs& outputs, const WriteFolder& folder) {
  std::vector<std::string> away;
  const std::vector<std::string> found = earlier_results(outputs);
  remove_leftovers(outputs, folder);
  for (const std::string& name : found)
    if (std::find(outputs.names.begin(), outputs.names.end(), name) == outputs.names.end())
      away.push_back(name);
  fs::path moved_to;
  if (!away.empty()) {
    const WriteFolder earlier = folder.new_folder("earlier");
    moved_to = earlier.path();
    for (const std::string& name : away) folder.rename(name, earlier, name);
  }
  for (const std::string& name : outputs.names) folder.remove(name);
  return moved_to;
}

}  // namespace adore::runs

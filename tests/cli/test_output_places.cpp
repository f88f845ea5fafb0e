#include "cli/driver.hpp"

#include <map>
#include <set>
#include <sys/stat.h>

/// Generated: every output of every command is made a link, a pipe, a hard link, a folder or a file
/// of another program. Nothing outside the named folder may change (decision 830).
using namespace adore;
using namespace adore::test;

namespace {

enum class Obstacle : unsigned char { Link, Pipe, HardLink, Directory, ForeignFile };
constexpr std::array kObstacles{Obstacle::Link, Obstacle::Pipe, Obstacle::HardLink,
                                Obstacle::Directory, Obstacle::ForeignFile};
constexpr std::array kNames{"link", "pipe", "hard link", "folder", "foreign file"};

struct Command {
  std::string words;               ///< run in the folder; of `adore`, or beginning with "agore"
  std::vector<std::string> ready;  ///< commands that make its inputs
};

const std::string kSweep =
    R"({"adore_study": 1, "kind": "sweep", "deck": "DATA.txt", "set": {"mode": -1},
        "variables": [{"name": "appLoadX", "list": [500, 600]}],
        "quantities": ["largest_contact_load_N"]})";

Result run_in(const fs::path& folder, const std::string& words) {
  std::string line = command_line(words);
  for (const std::string app : {"agore", "adrplot", "adrinput"})
    if (words.starts_with(app + " ")) line = program(app).string() + words.substr(app.size());
  return run_shell("cd " + folder.string() + " && timeout 120 " + line + " 2>&1");
}

void prepare(const fs::path& folder, const Command& command) {
  REQUIRE(run_in(folder, "new ball --out DATA.txt").code == 0);
  write(folder / "s.json", kSweep);
  for (const std::string& words : command.ready) {
    const Result made = run_in(folder, words);
    INFO(words << ": " << made.out);
    REQUIRE(made.code == 0);
  }
}

/// Files and folders below a folder, by their path in it.
std::set<std::string> listed(const fs::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    out.insert(fs::relative(entry.path(), folder).string());
  return out;
}

/// Those, with what changes when a file is replaced or changed in place.
std::map<std::string, std::array<long, 3>> states(const fs::path& folder) {
  std::map<std::string, std::array<long, 3>> out;
  for (const std::string& name : listed(folder)) {
    struct stat now {};
    REQUIRE(::lstat((folder / name).c_str(), &now) == 0);
    out[name] = {static_cast<long>(now.st_ino), now.st_mtim.tv_sec, now.st_mtim.tv_nsec};
  }
  return out;
}

/// A folder whose content must stay: one file that obstacles lead to.
struct Victim {
  Folder folder;
  fs::path file = folder / "precious";
  struct stat before {};
  Victim() {
    write(file, "precious\n");
    REQUIRE(::stat(file.c_str(), &before) == 0);
  }
  [[nodiscard]] bool untouched() const {
    struct stat now {};
    return ::stat(file.c_str(), &now) == 0 && now.st_ino == before.st_ino &&
           now.st_mode == before.st_mode && read(file) == "precious\n" &&
           listed(folder.path()).size() == 1;
  }
};

void put(const fs::path& place, Obstacle obstacle, const Victim& victim) {
  fs::create_directories(place.parent_path());
  fs::remove_all(place);
  switch (obstacle) {
    case Obstacle::Link:
      fs::create_symlink(victim.file, place);
      break;
    case Obstacle::Pipe:
      REQUIRE(::mkfifo(place.c_str(), 0600) == 0);
      break;
    case Obstacle::HardLink:
      fs::create_hard_link(victim.file, place);
      break;
    case Obstacle::Directory:
      fs::create_directories(place / "kept");
      break;
    case Obstacle::ForeignFile:
      write(place, "precious\n");
      break;
  }
}

/// Is the obstacle as put() made it?
bool stands(const fs::path& place, Obstacle obstacle) {
  const fs::file_status status = fs::symlink_status(place);
  switch (obstacle) {
    case Obstacle::Link:
      return fs::is_symlink(status);
    case Obstacle::Pipe:
      return fs::is_fifo(status);
    case Obstacle::Directory:
      return fs::is_directory(place / "kept");
    default:
      return fs::is_regular_file(status) && read(place) == "precious\n";
  }
}

/// Checks what a command did that met an obstacle.
void try_obstacle(const fs::path& ready, const Command& command, const std::string& name,
                  Obstacle obstacle) {
  const Folder folder;
  fs::copy(ready, folder.path(), fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  const Victim victim;
  put(folder / name, obstacle, victim);
  const Result run = run_in(folder.path(), command.words);
  INFO(command.words << ", " << name << " is a " << kNames.at(static_cast<std::size_t>(obstacle))
                     << ": exit " << run.code << "\n"
                     << run.out);
  CHECK(victim.untouched());
  CHECK((run.code == 0 || run.code == 2));
  // Refused and left, or its name was not needed; a hard link may be replaced by a new file.
  if (obstacle != Obstacle::HardLink) CHECK(stands(folder / name, obstacle));
  if (run.code == 2) CHECK(contains(run.out, fs::path(name).filename().string()));
}

/// A folder of the outputs is a link to a folder of the user.
void try_linked_folder(const fs::path& ready, const Command& command, const std::string& name) {
  const Folder folder;
  fs::copy(ready, folder.path(), fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  const Victim victim;
  fs::create_directories((folder / name).parent_path());
  fs::remove_all(folder / name);
  fs::create_directory_symlink(victim.folder.path(), folder / name);
  const Result run = run_in(folder.path(), command.words);
  INFO(command.words << ", " << name << " is a link to a folder: exit " << run.code << "\n"
                     << run.out);
  // The folder that the command line names may be a link; no other.
  const bool named = contains(" " + command.words + " ", "--out " + name + " ") ||
                     contains(" " + command.words + " ", "--render " + name + " ");
  if (!named) CHECK(victim.untouched());
  CHECK(read(victim.file) == "precious\n");
}

void try_all(const Command& command) {
  const Folder ready;
  prepare(ready.path(), command);
  std::set<std::string> files, folders;
  {
    const Folder folder;
    fs::copy(ready.path(), folder.path(), fs::copy_options::recursive);
    const auto before = states(folder.path());
    const Result run = run_in(folder.path(), command.words);
    INFO(command.words << ": " << run.out);
    REQUIRE(run.code == 0);
    std::set<std::string> kinds;
    for (const auto& [name, state] : states(folder.path())) {
      const auto old = before.find(name);
      const bool is_folder = fs::is_directory(folder / name);
      if (old != before.end() && (is_folder || old->second == state)) continue;
      // Records of runs, pages and frames: one of each kind.
      std::string kind;
      for (const char c : name) kind += std::isxdigit(static_cast<unsigned char>(c)) != 0 ? '#' : c;
      if (is_folder)
        folders.insert(name);
      else if (kinds.insert(kind).second)
        files.insert(name);
    }
  }
  REQUIRE_FALSE(files.empty());
  for (const std::string& name : files)
    for (const Obstacle obstacle : kObstacles) try_obstacle(ready.path(), command, name, obstacle);
  for (const std::string& name : folders) try_linked_folder(ready.path(), command, name);
}

}  // namespace

TEST_CASE("outputs of runs: no obstacle leads a write to another place", "[cli]") {
  try_all({"run DATA.txt --quiet --until 0.002rev --out r", {}});
  try_all({"run DATA.txt --quiet --overwrite --set mode=-1 --out r",
           {"run DATA.txt --quiet --set mode=-1 --out r"}});
}

TEST_CASE("outputs of sweeps: no obstacle leads a write to another place", "[cli]") {
  try_all({"run DATA.txt --quiet --set mode=-1 --set appLoadX=500:600:2 --out r", {}});
}

TEST_CASE("outputs of studies: no obstacle leads a write to another place", "[cli][slow]") {
  try_all({"study plan s.json", {}});
  try_all({"study run s.json --workers 1 --quiet", {}});
  try_all({"study report s.json", {"study run s.json --workers 1 --quiet"}});
}

TEST_CASE("outputs of commands for files: no obstacle leads a write to another place", "[cli]") {
  const std::string run = "run DATA.txt --quiet --set mode=-1 --out r";
  try_all({"new tapered --out OTHER.txt", {}});
  try_all({"study new sweep --out other.json", {}});
  try_all({"study new sweep --out other.toml", {}});
  try_all({"convert r/RUN.json --to csv --out run.csv", {run}});
  try_all({"convert r/RUN.json --to json --out copy.json", {run}});
  try_all({"user new adrx7 --out u", {}});
  try_all({"validate " + (source_dir() / "tests/reference/A_hertz_point.json").string() +
               " --quiet --report report.json",
           {}});
}

TEST_CASE("outputs of pictures: no obstacle leads a write to another place", "[cli][slow]") {
  if (contains(run_adore("plot none --out none").out, "ADORE_WITH_QT")) return;  // no pictures
  const std::string run = "run DATA.txt --quiet --until 0.002rev --out r";
  try_all({"plot r/SOL7 --page 1 --out p", {run}});
  try_all({"animate r --frame 1 --out p", {run}});
  try_all({"animate r --movie film.gif", {run}});
  try_all({"animate r --movie film.avi", {run}});
  try_all({"animate r --html scene.html", {run}});
}

TEST_CASE("outputs of accuracy studies: no obstacle leads a write to another place",
          "[cli][slow]") {
  try_all({"accuracy DATA.txt --methods rkf3 --tols 1e-3 --turns 0.01 --budget 2 --out a", {}});
}

TEST_CASE("outputs of the apps: no obstacle leads a write to another place", "[cli][slow]") {
  if (!fs::exists(program("agore"))) return;  // a build without the apps
  const std::string run = "run DATA.txt --quiet --until 0.002rev --out r";
  try_all({"agore r/SOL8 --render p", {run}});
  try_all({"agore r/SOL8 --render p --movie film.gif", {run}});
  try_all({"adrplot r/SOL7 --page 1 --render p", {run}});
  try_all({"adrinput s.json --render p", {}});
}

TEST_CASE("study folder that is a link → rejected", "[cli]") {
  const Folder folder;
  prepare(folder.path(), {});
  const Victim victim;
  fs::create_directory_symlink(victim.folder.path(), folder / "s.study");
  for (const char* words : {"study plan s.json", "study run s.json --quiet"}) {
    const Result run = run_in(folder.path(), words);
    INFO(run.out);
    CHECK(run.code == 2);
    CHECK(contains(run.out, "s.study"));
    CHECK(contains(run.out, "symbolic link"));
    CHECK(victim.untouched());
  }
}

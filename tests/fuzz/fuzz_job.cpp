#include "refused.hpp"
#include "studies/job.hpp"
#include "studies/study_table_read.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

using namespace adore;
using testing::refused_or;
using namespace adore::studies;
namespace fs = std::filesystem;

namespace {

/// A folder of this process, removed at its end.
class JobFolder {
 public:
  JobFolder() {
    std::string pattern = (fs::temp_directory_path() / "adore_fuzz_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) std::abort();
    path_ = pattern;
  }
  ~JobFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  JobFolder(const JobFolder&) = delete;
  JobFolder& operator=(const JobFolder&) = delete;
  [[nodiscard]] const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// Text behind "=== NAME" up to the next such line; empty: none.
std::string section(const std::string& all, const std::string& name) {
  const std::string mark = "=== " + name + "\n";
  const std::size_t at = all.find(mark);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + mark.size(), end = all.find("\n=== ", begin);
  return all.substr(begin, end == std::string::npos ? end : end + 1 - begin);
}

}  // namespace

/// The folder of a study: job.json, tasks.jsonl, RUNS.csv and a record, behind lines "=== NAME".
/// Any bytes are understood or rejected; nothing leaves the folder.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const JobFolder folder;
  const std::string all(reinterpret_cast<const char*>(data), size);
  const std::string key(32, '7');
  for (const char* name : {"job.json", "tasks.jsonl", "RUNS.csv"})
    write(folder.path() / name, section(all, name));
  write(run_record_path(folder.path(), key), section(all, "record"));
  std::size_t decks = 1;
  refused_or([&] {
    const Job job = read_job(folder.path());
    decks = job.decks.size();
    for (const Job::BaseDeck& base : job.decks)
      demand(base.deck.lexically_normal().string().starts_with(
                 folder.path().lexically_normal().string()),
             "a deck of the job is in its folder");
  });
  refused_or([&] {
    for (const Task& task : read_tasks(folder.path() / "tasks.jsonl", decks)) {
      demand(task.key.size() == 32, "a key has 32 digits");
      demand(task.point.deck < decks, "a run has one of the decks");
    }
  });
  refused_or([&] { (void)read_record(folder.path(), key); });
  refused_or([&] {
    const StudyTable table = read_study_table(folder.path() / "RUNS.csv");
    (void)charts_of_table(table);
    (void)run_text(table, 1);
  });
  refused_or([&] { (void)run_text(folder.path(), 1); });
  refused_or([&] { (void)run_files_folder(folder.path(), 1); });
  return 0;
}

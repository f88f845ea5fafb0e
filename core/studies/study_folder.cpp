#include "studies/study_folder.hpp"

#include "base/input_file.hpp"
#include "base/own_files.hpp"
#include "base/write_error.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace adore::studies {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFirstBytes = 1024;

constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kBeginnings{
    {{"job.json", "{\n \"adore_job\":"},
     {"tasks.jsonl", "{\"run\":"},
     {"RUNS.csv", "run,exit,"},
     {"TIMES.csv", "run,key,"},
     {"STUDY.h5", "\x89HDF"},
     {"CHARTS.json", "[\n {\n  \""},
     {"CHARTS.json", "[]"},
     {"current.json", "{\"job\":"}}};

void check_own(const WriteFolder& folder, const std::string& name) {
  const WritePath place(folder, name);
  check_writable_file(place);
  InputFile stream(place.path());
  if (!stream) return;
  std::string first(kFirstBytes, '\0');
  stream.read(first.data(), static_cast<std::streamsize>(first.size()));
  first.resize(static_cast<std::size_t>(stream.gcount()));
  if (first.empty() || is_study_file(name, first)) return;
  throw WriteError(
      fmt::format("{}: this file was not written by a study. Move it to another folder.",
                  place.path().string()));
}

}  // namespace

WriteFolder open_study_folder(const fs::path& folder) {
  return WriteFolder(folder.parent_path()).folder(folder.filename());
}

bool is_study_file(const std::string& name, std::string_view first_bytes) {
  bool known = false;
  for (const auto& [file, beginning] : kBeginnings) {
    if (name != file) continue;
    known = true;
    if (first_bytes.starts_with(beginning)) return true;
  }
  if (known) return false;
  const std::string_view line = first_bytes.substr(0, first_bytes.find('\n'));
  if (name == "REPORT.txt")
    return line.find(" done, ") != std::string_view::npos && line.ends_with(" open");
  // Records of runs, and copies of decks.
  return first_bytes.starts_with("{\"adore_run\":") ||
         detect_file_type(first_bytes) == AdoreFileType::Deck;
}

void write_into_study(const WriteFolder& folder, const std::string& name,
                      std::string_view content) {
  write_into_study(folder, name, [&](const TextSink& write) { write(content); });
}

void write_into_study(const WriteFolder& folder, const std::string& name,
                      const std::function<void(const TextSink&)>& produce) {
  check_own(folder, name);
  write_file_atomically({folder, name}, produce);
}

}  // namespace adore::studies

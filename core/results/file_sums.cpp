#include "results/file_sums.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/own_files.hpp"
#include "base/word_checksum.hpp"
#include "results/results_h5.hpp"
#include "results/run_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace adore::results {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using State = FileCheck::State;

/// checksum() or word_checksum().
using Sum = std::uint64_t (*)(std::string_view, std::uint64_t) noexcept;

/// Of at most `bytes` bytes. Finished files have sums of words; earlier versions, and MASTER of
/// text files, sums of bytes.
FileChecksum sum_of_start(const fs::path& path, std::uintmax_t bytes, Sum sum) {
  InputFile stream(path);
  if (!stream)
    throw InputError(fmt::format("{}: the file cannot be opened; check its name and permissions",
                                 path.string()));
  FileChecksum out{path.filename().string(), 0, checksum({})};
  std::string block(std::size_t{1} << 16, '\0');
  while (out.bytes < bytes) {
    const auto most =
        static_cast<std::streamsize>(std::min<std::uintmax_t>(block.size(), bytes - out.bytes));
    stream.read(block.data(), most);
    const auto count = static_cast<std::size_t>(stream.gcount());
    if (count == 0) break;
    out.sum = sum(std::string_view(block).substr(0, count), out.sum);
    out.bytes += count;
  }
  return out;
}

std::string hex(std::uint64_t sum) { return fmt::format("{:016x}", sum); }

/// Whether the file has this length and checksum.
FileCheck compare(const fs::path& path, std::uintmax_t bytes, const std::string& sum) {
  FileCheck out{path, State::Damaged, {}};
  std::error_code error;
  if (!fs::exists(path, error)) {
    out.state = State::Missing;
    out.detail = "the file is missing";
    return out;
  }
  try {
    const FileChecksum found = file_checksum(path);
    if (found.bytes != bytes)
      out.detail = fmt::format("the file has {} bytes, but the run wrote {}", found.bytes, bytes);
    else if (hex(found.sum) != sum && hex(sum_of_start(path, UINTMAX_MAX, checksum).sum) != sum)
      out.detail =
          fmt::format("the file ({} bytes) has the checksum {}, but the run stored the checksum {}",
                      bytes, hex(found.sum), sum);
    else
      out = {path, State::Intact, fmt::format("{} bytes", bytes)};
  } catch (const InputError& refused) {
    out.detail = refused.what();
  }
  return out;
}

/// The checksum of RUN.json over its own text.
FileCheck check_summary(const fs::path& path, const std::string& text, const Json& json) {
  FileCheck out{path, State::Unchecked,
                "an earlier version of Adore wrote this file without a checksum"};
  const auto measured = json.find("measured");
  if (measured == json.end() || !measured->is_object() || !measured->contains(kOwnChecksum))
    return out;
  const Json& stored = measured->at(kOwnChecksum);
  const bool same = stored.is_string() && stored.get<std::string>() == run_json_checksum(text);
  out.state = same ? State::Intact : State::Damaged;
  out.detail = same ? fmt::format("{} bytes", text.size())
                    : "the content of the file does not match the checksum in the file";
  return out;
}

/// The parts that MASTER names: of a run that was not finished.
void check_parts(const fs::path& folder, std::vector<FileCheck>& out) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (read_file_type(entry.path()) != AdoreFileType::Master) continue;
    try {
      const MasterState master = read_master(entry.path());
      out.push_back({entry.path(), State::Intact, "checksum in the file"});
      const auto saved = master.averages.find(kLastSaved);
      for (const MasterFileEntry& file : master.files) {
        const fs::path path = folder / file.name;
        if (!file.sum) continue;
        if (!fs::exists(path, error)) {
          out.push_back({path, State::Missing, "the file is missing"});
          continue;
        }
        std::string damage;
        try {
          damage = describe_file_damage(
              file, path, static_cast<long>(saved == master.averages.end() ? -1.0 : saved->second));
        } catch (const InputError& refused) {
          damage = refused.what();
        }
        out.push_back({path, damage.empty() ? State::Intact : State::Damaged,
                       damage.empty() ? fmt::format("up to step {}", master.last.step) : damage});
      }
    } catch (const InputError& refused) {
      out.push_back({entry.path(), State::Damaged, refused.what()});
    }
  }
}

bool verify_one(const fs::path& folder, std::vector<FileCheck>& out) {
  const fs::path summary = folder / "RUN.json";
  std::error_code error;
  if (!fs::exists(summary, error)) {
    const std::size_t before = out.size();
    check_parts(folder, out);
    return out.size() > before;
  }
  Json json;
  std::string text;
  try {
    text = read_text_file(summary);
    json = parse_json<Json>(text, summary.string());
    out.push_back(check_summary(summary, text, json));
  } catch (const InputError& refused) {
    out.push_back({summary, State::Damaged, refused.what()});
  }
  const Json measured = json.is_object() ? json.value("measured", Json()) : Json();
  const Json sums = measured.is_object() ? measured.value("checksums", Json()) : Json();
  if (!sums.is_object() || sums.empty()) {
    check_parts(folder, out);
    return true;
  }
  for (const auto& [name, item] : sums.items()) {
    const bool plain = name.find('/') == std::string::npos;
    if (!plain || !item.is_object() || !item.value("bytes", Json()).is_number_unsigned() ||
        !item.value("checksum", Json()).is_string()) {
      out.push_back({summary, State::Damaged, "the list of checksums is damaged"});
      continue;
    }
    out.push_back(compare(folder / name, item.at("bytes").get<std::uintmax_t>(),
                          item.at("checksum").get<std::string>()));
  }
  return true;
}

}  // namespace

FileChecksum file_checksum(const fs::path& path) {
  return sum_of_start(path, UINTMAX_MAX, word_checksum);
}

namespace {

/// checksum_of_values() or word_checksum_of_values().
using SumOfValues = std::uint64_t (*)(std::span<const double>, std::uint64_t) noexcept;

std::uint64_t sum_of_steps_by(SumOfValues sum_of, const H5Reader& file, std::size_t rows) {
  constexpr std::size_t kRows = 256;
  std::vector<std::string> names{"step", "time", "step_size", "shaft_rotation"};
  for (const H5Reader::ChannelInfo& channel : file.channels()) names.push_back(channel.id);
  std::uint64_t total = 0;
  for (const std::string& name : names) {
    std::uint64_t sum = checksum(name);
    for (std::size_t first = 0; first < rows; first += kRows)
      sum = sum_of(file.read(name, first, std::min(kRows, rows - first)), sum);
    total += sum;
  }
  return total;
}

}  // namespace

std::uint64_t steps_checksum(const H5Reader& file, std::size_t rows) {
  return sum_of_steps_by(word_checksum_of_values, file, rows);
}

std::string describe_file_damage(const MasterFileEntry& file, const fs::path& path,
                                 long last_step) {
  if (!file.sum) return {};
  constexpr const char* kDiffers =
      "the part of the file up to the last checkpoint has the checksum {}, but the run stored the "
      "checksum {}";
  if (file.role == "RESULTS") {
    const H5Reader reader(path);
    const std::vector<long> steps = reader.step_numbers();
    const auto rows = static_cast<std::size_t>(
        std::upper_bound(steps.begin(), steps.end(), last_step) - steps.begin());
    const std::uint64_t sum = steps_checksum(reader, rows);
    const bool same = sum == *file.sum ||
                      sum_of_steps_by(checksum_of_values, reader, rows) == *file.sum;  // earlier
    return same ? std::string() : fmt::format(kDiffers, hex(sum), hex(*file.sum));
  }
  const FileChecksum found = sum_of_start(path, file.bytes, checksum);
  if (found.bytes < file.bytes)
    return fmt::format("the file has {} bytes, but had {} at the last checkpoint of the run",
                       found.bytes, file.bytes);
  return found.sum == *file.sum ? std::string()
                                : fmt::format(kDiffers, hex(found.sum), hex(*file.sum));
}

std::vector<FileCheck> verify_run(const fs::path& folder) {
  std::vector<FileCheck> out;
  bool any = verify_one(folder, out);
  std::error_code error;
  std::vector<fs::path> below;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (fs::is_directory(entry.symlink_status(error)) &&
        fs::exists(entry.path() / "RUN.json", error) &&
        !entry.path().filename().string().starts_with("earlier-"))
      below.push_back(entry.path());
  std::sort(below.begin(), below.end());
  for (const fs::path& run : below) any = verify_one(run, out) || any;
  if (!any)
    throw InputError(
        fmt::format("{}: there is no run in this folder (no RUN.json and no MASTER); "
                    "give the folder of a run, a sweep or a study",
                    folder.string()));
  return out;
}

}  // namespace adore::results

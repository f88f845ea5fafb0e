#include "results/run_findings.hpp"

#include "base/checksum.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "results/h5_layout.hpp"
#include "results/h5_process.hpp"
#include "results/run_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace adore::results {
namespace fs = std::filesystem;
namespace {

using h5::Handle;

/// Bytes of the list: attributes of HDF5 hold 64 kB.
constexpr std::size_t kMaxFindingsBytes = 60000;

std::string read_findings_text(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
  const Handle type(H5Aget_type(attribute)), space(H5Aget_space(attribute));
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 ||
      H5Sget_simple_extent_npoints(space) != 1 || size > kMaxFindingsBytes)
    throw InputError("the stored findings must be one text string in JSON format");
  std::string text(size, '\0');
  if (H5Aread(attribute, type, text.data()) < 0)
    throw InputError("the list of findings cannot be read");
  return text;
}

}  // namespace

FindingsText findings_text(std::span<const Finding> findings) {
  std::vector<Finding> known;
  for (const Finding& one : findings) {
    const FindingKind* kind = find_finding_kind(one.code);
    const bool before = kind != nullptr && !one.time &&
                        ((kind->origin == "check" && one.severity != Severity::Note) ||
                         kind->origin == "statics" || kind->origin == "plan");
    if (!before) continue;
    known.push_back(one);
    known.back().file = fs::path(one.file).filename().string();
  }
  FindingsText out;
  out.list = dump_json(findings_json(known));
  if (out.list.size() > kMaxFindingsBytes) {
    std::erase_if(known, [](const Finding& one) { return one.severity == Severity::Note; });
    out.list = dump_json(findings_json(known));
  }
  while (out.list.size() > kMaxFindingsBytes) {
    known.resize(known.size() / 2);
    out.list = dump_json(findings_json(known));
  }
  out.sum = fmt::format("{:016x}", checksum(out.list));
  return out;
}

std::vector<Finding> stored_findings(const fs::path& results_h5) {
  reject_special_file(results_h5);
  const auto read = [&] {
    const Handle file(H5Fopen(results_h5.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ,
                              h5::file_access_properties()));
    if (!file.valid()) throw InputError("the file cannot be opened");
    const Handle root(H5Gopen2(file, "/", H5P_DEFAULT));
    const std::string text = read_findings_text(root, FindingsText::kList);
    if (!text.empty() &&
        read_findings_text(root, FindingsText::kSum) != fmt::format("{:016x}", checksum(text)))
      throw InputError("the list of findings is damaged: it does not match its checksum");
    return text;
  };
  const std::string text = h5::read_in_child_process(results_h5, read, kMaxFindingsBytes);
  return text.empty() ? std::vector<Finding>{}
                      : read_findings(parse_json(text, results_h5.string()));
}

std::vector<Finding> run_findings(const fs::path& run) {
  if (run.empty()) return {};
  std::error_code error;
  const fs::path folder = fs::is_directory(run, error) ? run : run.parent_path();
  const auto list = read_run_member(folder / "RUN.json", "findings");
  if (list.is_array()) return read_findings(list);
  if (const auto notes = read_run_member(folder / "RUN.json", "notes"); notes.is_array()) {
    std::vector<Finding> out;
    for (const auto& note : notes)
      if (note.is_string() && out.size() < kMostFindings)
        out.push_back(make_finding("deck.note", note.get<std::string>()));
    return out;
  }
  try {
    if (fs::exists(folder / "RESULTS.h5", error)) return stored_findings(folder / "RESULTS.h5");
  } catch (const InputError&) {
  }
  return {};
}

}  // namespace adore::results

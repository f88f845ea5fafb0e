#include "runs/run_files.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"
#include "dynamics/effect_catalogue.hpp"
#include "results/continuation.hpp"
#include "results/file_sums.hpp"
#include "runs/user_session.hpp"
#include "scene/user_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

int cages(const Prepared& prepared) {
  return prepared.bearing.cage ? prepared.bearing.cage->segments.count : 0;
}

}  // namespace

listing::RaceFrictionModel race_friction_model(const Prepared& prepared) {
  using listing::RaceFrictionModel;
  if (!prepared.plan.has(scene::Effect::RaceTraction)) return RaceFrictionModel::None;
  const auto& user = prepared.options.system.user;
  if (user && user->traction_of(tribology::TractionKind::ElementRace) != nullptr)
    return RaceFrictionModel::OfUser;
  return prepared.bearing.lubrication ? RaceFrictionModel::Film : RaceFrictionModel::Curve;
}

RunFiles::RunFiles(const Prepared& prepared, RunPlace place)
    : prepared_(prepared),
      initial_bearing_(prepared.bearing),
      control_(prepared.control),
      place_(std::move(place)),
      units_(prepared.input.deck.units()),
      channels_(dynamics::energy_terms()) {}

const WriteFolder& RunFiles::folder() const {
  demand(place_.folder.has_value(), "a run that writes files needs an open output folder");
  return *place_.folder;
}

fs::path RunFiles::sol_path(std::size_t number) const {
  return place_.path / control_.sol_files[number - 1];
}

WritePath RunFiles::sol_write_path(std::size_t number) const {
  return place(control_.sol_files[number - 1]);
}

Outputs RunFiles::outputs() const {
  Outputs out;
  out.folder = place_.path;
  out.inputs = {prepared_.input.path, prepared_.input.path.parent_path() / "ADORE.json"};
  out.names = {"PRINT.txt", "RUN.json"};
  if (!control_.dynamic) return out;
  for (std::size_t k = 0; k < control_.monitored.size() && k < 6; ++k)
    out.names.push_back(control_.sol_files[k]);
  out.names.push_back(control_.sol_files[6]);
  if (writes_animation()) out.names.push_back(control_.sol_files[7]);
  if (writes_sol9()) out.names.push_back("SOL9");
  if (prepared_.options.results_h5) out.names.push_back("RESULTS.h5");
  out.names.push_back(control_.final_file);
  out.names.push_back(control_.master_file);
  return out;
}

void RunFiles::check() const {
  listing::PrintFile::check(path("PRINT.txt"), prepared_.bearing.run_id);
  const auto check = [&](std::size_t number, int index) {
    results::SolWriter::check(sol_path(number),
                              results::make_sol_header(prepared_.bearing, index, units_));
  };
  for (std::size_t k = 0; k < control_.monitored.size() && k < 6; ++k)
    check(k + 1, control_.monitored[k]);
  check(7, 0);
  if (prepared_.options.results_h5)
    results::H5Writer::check(path("RESULTS.h5"), initial_bearing_, channels_);
  if (writes_animation()) results::Sol8Writer::check(sol_path(8), prepared_.bearing, units_);
}

void RunFiles::verify_checksums(const results::MasterState& master) const {
  const auto saved = master.averages.find(results::kLastSaved);
  const long last = saved == master.averages.end() ? 0 : static_cast<long>(saved->second);
  for (const results::MasterFileEntry& file : master.files) {
    const std::string damage = results::describe_file_damage(file, path(file.name), last);
    if (damage.empty()) continue;
    throw InputError(
        fmt::format("{}: the file is damaged: {}; restore it, or run the deck again with "
                    "--overwrite (`adore verify {}` checks all files)",
                    path(file.name).string(), damage, place_.path.string()));
  }
}

std::pair<long, double> RunFiles::last_stored_step(std::uintmax_t print_bytes) const {
  // RESULTS.h5 has the steps of SOL7 and SOL8.
  std::pair<long, double> out = results::last_stored_step(sol_path(7));
  const auto take = [&out](const std::pair<long, double>& other) {
    out = {std::max(out.first, other.first), std::max(out.second, other.second)};
  };
  if (writes_animation()) take(results::last_stored_step(sol_path(8)));
  take(listing::PrintFile::last_stored_step(path("PRINT.txt"), print_bytes));
  return out;
}

bool RunFiles::writes_sol9() const { return prepared_.user && prepared_.user->active(9); }

bool RunFiles::writes_animation() const { return control_.animate && !no_animation(); }

void RunFiles::open_listing() {
  written.push_back(path("PRINT.txt"));
  print = listing::PrintFile::create(place("PRINT.txt"), prepared_.bearing.run_id, units_);
}

std::optional<std::string> RunFiles::no_animation() const {
  if (!control_.animate) return {};
  return results::sol8_refusal(prepared_.bearing.element_count(), cages(prepared_));
}

void RunFiles::open(bool continued, std::uintmax_t print_bytes, std::uintmax_t sol9_bytes) {
  written.push_back(path("PRINT.txt"));
  print = continued
              ? listing::PrintFile::continue_after(place("PRINT.txt"), prepared_.bearing.run_id,
                                                   units_, print_bytes)
              : listing::PrintFile::create(place("PRINT.txt"), prepared_.bearing.run_id, units_);
  const auto open = [&](std::size_t number, int index) {
    const results::SolHeader header = results::make_sol_header(prepared_.bearing, index, units_);
    written.push_back(sol_path(number));
    return continued ? results::SolWriter::continue_after(sol_write_path(number), header, units_,
                                                          steps.plotted)
                     : results::SolWriter::create(sol_write_path(number), header, units_);
  };
  for (std::size_t k = 0; k < control_.monitored.size() && k < 6; ++k)
    element_writers_.push_back(open(k + 1, control_.monitored[k]));
  sol7_writer_ = open(7, 0);
  for (results::SolWriter& file : element_writers_) file.collect();
  sol7_writer_->collect();
  if (prepared_.options.results_h5) {
    written.push_back(path("RESULTS.h5"));
    std::vector<Finding> known = prepared_.input.warnings;
    std::erase_if(known, [&](const Finding& one) {  // a value without effect changes no byte
      const auto names = [&](const deck::NoPart& idle) { return idle.variable == one.variable; };
      return std::any_of(prepared_.no_part.begin(), prepared_.no_part.end(), names);
    });
    for (Finding& note : solution_notes(prepared_)) known.push_back(std::move(note));
    constexpr int kBlock = results::H5Writer::kBlock;
    all = continued ? results::H5Writer::continue_after(place("RESULTS.h5"), initial_bearing_,
                                                        channels_, steps.saved, kBlock, known)
                    : results::H5Writer::create(place("RESULTS.h5"), initial_bearing_, channels_,
                                                kBlock, known);
  }
  print->set_friction_model(race_friction_model(prepared_));
  if (prepared_.user && !prepared_.user->version().empty())
    print->set_heading_version(program_version(prepared_.user.get()));
  if (writes_sol9()) {
    written.push_back(path("SOL9"));
    user = continued ? results::GrowingFile::open_for_append(place("SOL9"), sol9_bytes)
                     : results::GrowingFile::create(place("SOL9"));
    const std::string text = prepared_.user->take_sol9_text();
    if (!continued)
      user->append(fmt::format("  {}{}  SOL9, written by user routine ADRX9 of {}\n{}",
                               kFileVersion,
                               program_version(prepared_.user.get()).substr(kProgramVersion.size()),
                               prepared_.user->source(), text));
  }
  if (!writes_animation()) return;
  written.push_back(sol_path(8));
  sol8_writer_ = continued
                     ? results::Sol8Writer::continue_after(sol_write_path(8), prepared_.bearing,
                                                           units_, steps.animated)
                     : results::Sol8Writer::create(sol_write_path(8), prepared_.bearing, units_);
  sol8_writer_->collect();
}

RunFiles::StepTargets RunFiles::claim_targets(long step, bool always) {
  const auto meets = [&](int every, long& last) {
    if (!(always || due(step, every)) || last == step) return false;
    last = step;
    return true;
  };
  return {meets(control_.plot_every, steps.plotted),
          control_.animate && meets(control_.animate_every, steps.animated),
          meets(control_.print_every, steps.printed), meets(control_.life_every, steps.lived)};
}

bool RunFiles::will_save(long step, bool always) const {
  const bool meets =
      due(step, control_.plot_every) || (control_.animate && due(step, control_.animate_every));
  return all && (always || meets) && steps.saved != step;
}

void RunFiles::store(const StepTargets& where, const scene::Snapshot& at,
                     const results::StepRecord& record) {
  if (where.plot) {
    for (results::SolWriter& file : element_writers_) file.write(record);
    sol7_writer_->write(record);
  }
  if (where.animate && sol8_writer_) sol8_writer_->write(at);
  if (saves(where, at.step)) {
    all->write(record);
    steps.saved = at.step;
  }
  constexpr std::chrono::milliseconds kFlushInterval{100};
  if (std::chrono::steady_clock::now() - last_flush_time_ >= kFlushInterval) flush_sol_files();
}

void RunFiles::flush_sol_files() {
  for (results::SolWriter& file : element_writers_) file.flush();
  if (sol7_writer_) sol7_writer_->flush();
  if (sol8_writer_) sol8_writer_->flush();
  last_flush_time_ = std::chrono::steady_clock::now();
}

void RunFiles::flush() {
  flush_sol_files();
  if (all) all->flush();
}

void RunFiles::close() {
  flush_sol_files();
  if (all) all->close();
}

std::vector<results::MasterFileEntry> RunFiles::master_entries() const {
  std::vector<results::MasterFileEntry> out;
  const auto add = [&](const std::string& role, const results::GrowingFile& file) {
    out.push_back({role, file.path().filename().string(), file.bytes(), file.sum()});
  };
  add("PRINT", print->file());
  for (std::size_t k = 0; k < element_writers_.size(); ++k)
    add(fmt::format("SOL{}", k + 1), element_writers_[k].file());
  add("SOL7", sol7_writer_->file());
  if (sol8_writer_) add("SOL8", sol8_writer_->file());
  if (user) add("SOL9", *user);
  if (all) out.push_back({"RESULTS", "RESULTS.h5", 0, all->sum()});
  return out;
}

}  // namespace adore::runs

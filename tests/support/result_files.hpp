#pragma once

#include "results/sol_writer.hpp"
#include "support/synthetic_results.hpp"

#include <filesystem>
#include <fstream>
#include <string>

namespace adore::test {

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Writes synthetic results as the solver would.
inline std::string sol_text(const results::SolFile& file) {
  std::string text = results::format_sol_header(file.header);
  for (const auto& step : file.steps) results::append_sol_step(text, step);
  return text;
}

inline std::string sol8_text(const results::Sol8File& file) {
  std::string text = results::format_sol8_header(file);
  for (const auto& frame : file.frames) results::append_sol8_frame(text, frame);
  return text;
}

}  // namespace adore::test

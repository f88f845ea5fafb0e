#include "cli/text_io.hpp"

#include "base/errors.hpp"
#include "base/terminal_text.hpp"
#include "cli/export.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <iostream>

namespace adore::cli {

std::string read_standard_input(std::size_t most) {
  std::string text, block(1 << 16, '\0');
  while (std::cin.read(block.data(), static_cast<std::streamsize>(block.size())) ||
         std::cin.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(std::cin.gcount()));
    if (text.size() > most)
      throw InputError(fmt::format(
          "standard input contains more than {} MiB; give the name of a file instead", most >> 20));
  }
  return text;
}

std::string write_text(const std::string& out, const std::string& name, std::string_view text,
                       const std::vector<std::filesystem::path>& inputs) {
  if (out.empty() || out == kStream) {
    print_text(stdout, text);
    return {};
  }
  std::filesystem::path path(out);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) path /= name;
  write_export(path, text, inputs);
  return path.string();
}

}  // namespace adore::cli

#include "cli/export.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/terminal_text.hpp"
#include "base/write_folder.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <locale>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <utility>

namespace adore::cli {
namespace {

namespace fs = std::filesystem;

/// Beginning of exports of one kind: heading of a CSV file, first key of a JSON file.
std::string_view beginning(std::string_view text) {
  if (text.substr(0, 1) != "{") return text.substr(0, text.find('\n'));
  return text.substr(0, text.find(':'));
}

/// Passes the output on in pieces.
class PieceBuffer : public std::streambuf {
 public:
  explicit PieceBuffer(TextSink sink) : sink_(std::move(sink)) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }

 protected:
  int_type overflow(int_type c) override {
    sync();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  int sync() override {
    const std::string_view piece(pbase(), static_cast<std::size_t>(pptr() - pbase()));
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    if (!piece.empty()) sink_(piece);
    return 0;
  }

 private:
  TextSink sink_;
  std::array<char, 1 << 16> buffer_{};
};

/// May an export that begins like this go there? @throws InputError
void check_place(const fs::path& path, std::string_view start,
                 const std::vector<fs::path>& inputs) {
  std::error_code error;
  for (const fs::path& input : inputs)
    if (fs::equivalent(input, path, error))
      throw InputError(
          fmt::format("--out {}: this is the input file; give another file", path.string()));
  const fs::file_status status = fs::symlink_status(path, error);
  if (write_protected(path))
    throw InputError(fmt::format(
        "--out {}: the file is write-protected; give another file, or make it writable (chmod u+w)",
        path.string()));
  if (fs::is_regular_file(status) && fs::file_size(path, error) > 0) {
    std::string old(start.size() + 1, '\0');
    InputFile stream(path);
    stream.read(old.data(), static_cast<std::streamsize>(old.size()));
    old.resize(static_cast<std::size_t>(stream.gcount()));
    if (start.empty() || beginning(old) != start)
      throw InputError(
          fmt::format("--out {}: the file exists and is not an export of this type; give another "
                      "file, or remove this file first",
                      path.string()));
  } else if (fs::is_symlink(status)) {
    throw InputError(
        fmt::format("--out {}: this is a symbolic link to {}; give the name of the file itself",
                    path.string(), fs::read_symlink(path, error).string()));
  }
}

}  // namespace

void check_export(const fs::path& path, std::string_view text,
                  const std::vector<fs::path>& inputs) {
  check_place(path, beginning(text), inputs);
}

void write_export(const fs::path& path, std::string_view text,
                  const std::vector<fs::path>& inputs) {
  check_export(path, text, inputs);
  write_file_atomically(path, text);
}

void print_export(const std::function<void(std::ostream&)>& produce) {
  const auto put = [](std::string_view text) {
    print_text(stdout, text);
    if (std::ferror(stdout) != 0)
      throw std::system_error(errno, std::generic_category(), "standard output");
  };
  std::string rest;  // of a line: a letter of several bytes must not be cut
  PieceBuffer buffer([&](std::string_view piece) {
    const std::size_t end = piece.rfind('\n');
    if (end == std::string_view::npos) {
      rest += piece;
      return;
    }
    put(rest.append(piece.substr(0, end + 1)));
    rest = piece.substr(end + 1);
  });
  std::ostream out(&buffer);
  out.imbue(std::locale::classic());
  out.exceptions(std::ios::badbit);
  produce(out);
  out.flush();
  put(rest);
}

void write_export(const fs::path& path, const std::function<void(std::ostream&)>& produce,
                  const std::vector<fs::path>& inputs) {
  write_file_atomically(path, [&](const TextSink& write) {
    // The first bytes decide whether the file may be replaced. Nothing is written before the export
    // is complete.
    std::string start;
    bool checked = false;
    const auto check = [&] {
      check_place(path, beginning(start), inputs);
      write(start);
      checked = true;
    };
    PieceBuffer buffer([&](std::string_view piece) {
      if (checked) return write(piece);
      start += piece;
      if (beginning(start).size() < start.size()) check();
    });
    std::ostream out(&buffer);
    out.imbue(std::locale::classic());
    out.exceptions(std::ios::badbit);  // exceptions of a sink propagate to the caller
    produce(out);
    out.flush();
    if (!checked) check();
  });
}

}  // namespace adore::cli

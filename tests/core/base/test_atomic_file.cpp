#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/kept_copy.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = adore::test::binary_dir() / ("atomic_file_test_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

std::string content_of(const fs::path& path) { return adore::test::bytes_of(path); }

std::size_t count_files(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("an atomic write creates and replaces a file and leaves nothing else behind",
          "[unit][base]") {
  const Folder folder;
  const fs::path file = folder.path / "deck.txt";
  adore::write_file_atomically(file, "first");
  CHECK(content_of(file) == "first");
  const std::string binary("a\0b\r\n", 5);
  adore::write_file_atomically(file, binary);
  CHECK(content_of(file) == binary);
  adore::write_file_atomically(file, "");
  CHECK(content_of(file).empty());
  CHECK(count_files(folder.path) == 1);
}

TEST_CASE("an atomic write takes pieces, and replaces nothing when their source fails",
          "[unit][base]") {
  const Folder folder;
  const fs::path file = folder.path / "table.csv";
  adore::write_file_atomically(file, [](const adore::TextSink& write) {
    for (const char* piece : {"a", "", "b\n"}) write(piece);
  });
  CHECK(content_of(file) == "ab\n");
  const auto broken = [](const adore::TextSink& write) {
    write("half of a");
    throw adore::InputError("the source is damaged");
  };
  CHECK_THROWS_AS(adore::write_file_atomically(file, broken), adore::InputError);
  CHECK(content_of(file) == "ab\n");
  CHECK(count_files(folder.path) == 1);
}

TEST_CASE("an atomic write keeps permissions and follows a symbolic link", "[unit][base]") {
  const Folder folder;
  const fs::path file = folder.path / "real.txt";
  adore::write_file_atomically(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(file, folder.path / "link.txt");
  adore::write_file_atomically(folder.path / "link.txt", "new");
  CHECK(content_of(file) == "new");
  CHECK(fs::is_symlink(folder.path / "link.txt"));
  CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("an atomic write that cannot succeed says which path, why and what to do",
          "[unit][base]") {
  const Folder folder;
  const auto message = [](const fs::path& path) -> std::string {
    try {
      adore::write_file_atomically(path, "text");
    } catch (const adore::InputError& error) {
      return error.what();
    }
    return {};
  };
  CHECK_THAT(message(folder.path / "missing" / "deck.txt"),
             Catch::Contains("deck.txt") && Catch::Contains("create the folder"));
  CHECK_THAT(message(folder.path), Catch::Contains("give the name of a file"));
  CHECK_THAT(message("/dev/full/deck.txt"), Catch::Contains("cannot be written"));
  CHECK_THAT(message(""), Catch::Contains("cannot be written"));
  CHECK(count_files(folder.path) == 0);
  const fs::path kept = folder.path / "kept.txt";
  adore::write_file_atomically(kept, "master");
  fs::permissions(kept, fs::perms::owner_read);
  CHECK_THAT(message(kept), Catch::Contains("write-protected"));
  fs::create_symlink(kept, folder.path / "link.txt");
  CHECK_THAT(message(folder.path / "link.txt"), Catch::Contains("write-protected"));
  CHECK(content_of(kept) == "master");
}

TEST_CASE("a kept copy replaces no earlier copy, and the same text is kept once", "[unit][base]") {
  const Folder folder;
  const fs::path file = folder.path / "DATA.txt";
  CHECK(adore::keep_copy(file, "first") == folder.path / "DATA.txt.bak");
  CHECK(adore::keep_copy(file, "second") == folder.path / "DATA.txt.bak2");
  CHECK(adore::keep_copy(file, "first") == folder.path / "DATA.txt.bak");
  fs::create_directory(folder.path / "DATA.txt.bak3");
  fs::create_symlink(folder.path / "nowhere", folder.path / "DATA.txt.bak4");
  CHECK(adore::keep_copy(file, "") == folder.path / "DATA.txt.bak5");
  CHECK(content_of(folder.path / "DATA.txt.bak") == "first");
  CHECK(content_of(folder.path / "DATA.txt.bak2") == "second");
  CHECK(content_of(folder.path / "DATA.txt.bak5").empty());
  CHECK(count_files(folder.path) == 5);
}

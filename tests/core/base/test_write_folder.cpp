#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/kept_copy.hpp"
#include "base/terminal_text.hpp"
#include "base/write_folder.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <sys/stat.h>
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

TEST_CASE("atomic write: file created or replaced, no other files left", "[unit][base]") {
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

TEST_CASE("atomic write: source of the pieces fails → file unchanged", "[unit][base]") {
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

TEST_CASE("write_file_atomically(): permissions of an existing file → kept, except execution",
          "[unit][base]") {
  const Folder folder;
  const fs::path file = folder.path / "real.txt";
  adore::write_file_atomically(file, "old");
  fs::permissions(file, fs::perms::owner_all);
  adore::write_file_atomically(file, "new");
  CHECK(content_of(file) == "new");
  CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

namespace {

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const adore::InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("WriteFolder: the named folder may be a link; links below it are not followed",
          "[unit][base]") {
  const Folder folder;
  const fs::path real = folder.path / "real", victim = folder.path / "victim";
  fs::create_directories(real);
  fs::create_directories(victim);
  std::ofstream(victim / "file") << "precious";
  fs::create_directory_symlink(real, folder.path / "named");
  const adore::WriteFolder named(folder.path / "named");
  adore::write_file_atomically({named, "a.txt"}, "a");
  adore::write_file_atomically({named.folder("b/c"), "a.txt"}, "deep");
  CHECK(content_of(real / "a.txt") == "a");
  CHECK(content_of(real / "b/c/a.txt") == "deep");

  fs::create_directory_symlink(victim, real / "link");
  fs::create_symlink(victim / "file", real / "f");
  fs::create_symlink("nowhere", real / "dangling");
  fs::create_hard_link(victim / "file", real / "hard");
  REQUIRE(::mkfifo((real / "pipe").c_str(), 0600) == 0);
  using Catch::Contains;
  for (const char* path : {"link", "link/x", "b/../../victim", "..", "f"})
    CHECK_THAT(refusal([&] { (void)named.folder(path); }),
               Contains("symbolic link") || Contains("not a folder below"));
  CHECK_THAT(refusal([&] { (void)named.folder("a.txt"); }), Contains("remove the file"));
  for (const char* name : {"f", "dangling"}) {
    CHECK_THAT(refusal([&] {
                 adore::write_file_atomically({named, name}, "x");
               }),
               Contains("symbolic link") && Contains(name));
    CHECK_THAT(refusal([&] { (void)named.open_own(name); }), Contains("symbolic link"));
    CHECK(named.open_lock(name) == -1);
  }
  CHECK_THAT(refusal([&] {
               adore::write_file_atomically({named, "pipe"}, "x");
             }),
             Contains("pipe or a device"));
  CHECK_THAT(refusal([&] { (void)named.create("pipe"); }), Contains("not a regular file"));
  CHECK_THAT(refusal([&] { (void)named.create("b"); }), Contains("not a regular file"));
  CHECK_THAT(refusal([&] { (void)named.open_own("pipe"); }), Contains("not a regular file"));
  CHECK_THAT(refusal([&] { (void)named.open_own("hard"); }), Contains("hard link"));
  CHECK(named.open_lock("hard") == -1);
  CHECK(named.open_lock("pipe") == -1);
  for (const char* name : {"../victim/file", "a/b", "", ".."})
    CHECK(refusal([&] { adore::write_file_atomically({named, name}, "x"); }) != "no error");
  // A new file takes the name of a link or a hard link; their targets stay.
  for (const char* name : {"f", "hard"}) ::close(named.create(name));
  adore::write_file_atomically({named, "hard"}, "new");
  CHECK(content_of(victim / "file") == "precious");
  CHECK(content_of(real / "hard") == "new");
  CHECK_FALSE(fs::exists(folder.path / "nowhere"));

  // The folder is open: its name may lead elsewhere meanwhile.
  fs::remove(folder.path / "named");
  fs::create_directory_symlink(victim, folder.path / "named");
  adore::write_file_atomically({named, "late.txt"}, "late");
  CHECK(content_of(real / "late.txt") == "late");
  CHECK(count_files(victim) == 1);
}

TEST_CASE("WriteFolder: a folder or file of a third user → refused", "[unit][base]") {
  if (::geteuid() != 0) return;  // only root can give files away
  const Folder folder;
  fs::create_directories(folder.path / "other");
  std::ofstream(folder.path / "file") << "x";
  const adore::WriteFolder named(folder.path);
  REQUIRE(::chown((folder.path / "other").c_str(), 12345, 12345) == 0);
  REQUIRE(::chown((folder.path / "file").c_str(), 12345, 12345) == 0);
  CHECK_THAT(refusal([&] { (void)named.folder("other"); }),
             Catch::Contains("the owner is user 12345"));
  CHECK_THAT(refusal([&] { (void)named.open_own("file"); }),
             Catch::Contains("the owner is user 12345"));
  // The owner of the named folder is trusted with what is in it.
  REQUIRE(::chown(folder.path.c_str(), 12345, 12345) == 0);
  const adore::WriteFolder theirs(folder.path);
  (void)theirs.folder("other");
  ::close(theirs.open_own("file"));
}

TEST_CASE("InputFile and read_text_file(): pipes and devices → refused, links → followed",
          "[unit][base]") {
  const Folder folder;
  REQUIRE(::mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  std::ofstream(folder.path / "file") << "text";
  fs::create_symlink("file", folder.path / "link");
  for (const fs::path& path : {folder.path / "pipe", fs::path("/dev/zero")}) {
    CHECK_THAT(refusal([&] { (void)adore::read_text_file(path); }),
               Catch::Contains("pipe or a device"));
    CHECK_THAT(refusal([&] { const adore::InputFile file(path); }),
               Catch::Contains("pipe or a device"));
  }
  CHECK(adore::read_text_file(folder.path / "link") == "text");
  CHECK_THAT(refusal([&] { (void)adore::read_text_file(folder.path / "link", 3); }),
             Catch::Contains("the file has 4 bytes"));
  CHECK_FALSE(adore::InputFile(folder.path / "missing"));
  CHECK_FALSE(adore::InputFile(folder.path));
}

TEST_CASE("escape_for_terminal(): control characters → visible, letters and line ends → kept",
          "[unit][base]") {
  using adore::escape_for_terminal;
  CHECK(escape_for_terminal("\x1b[31mred\x07\b\x7f") == "\\x1b[31mred\\x07\\x08\xef\xbf\xbd");
  CHECK(escape_for_terminal("a\r\nb\tc\rd") == "a\r\nb\tc\\x0dd");
  CHECK(escape_for_terminal("\xc2\x9b"
                            "31m") ==
        "\xef\xbf\xbd"
        "31m");
  CHECK(escape_for_terminal("\x9b"
                            "31m") ==
        "\xef\xbf\xbd"
        "31m");
  for (const char* kept : {"\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80 µm °C", "n\xff", ""})
    CHECK(escape_for_terminal(kept) == kept);
}

TEST_CASE("atomic write: failure → message with path, reason and remedy", "[unit][base]") {
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
  CHECK_THAT(message(folder.path / "link.txt"), Catch::Contains("symbolic link"));
  CHECK(content_of(kept) == "master");
}

TEST_CASE("kept copy: earlier copies are never replaced, equal text is kept once", "[unit][base]") {
  const Folder folder;
  const fs::path file = folder.path / "DATA.txt";
  CHECK(adore::write_backup_copy(file, "first") == folder.path / "DATA.txt.bak");
  CHECK(adore::write_backup_copy(file, "second") == folder.path / "DATA.txt.bak2");
  CHECK(adore::write_backup_copy(file, "first") == folder.path / "DATA.txt.bak");
  fs::create_directory(folder.path / "DATA.txt.bak3");
  fs::create_symlink(folder.path / "nowhere", folder.path / "DATA.txt.bak4");
  CHECK(adore::write_backup_copy(file, "") == folder.path / "DATA.txt.bak5");
  CHECK(content_of(folder.path / "DATA.txt.bak") == "first");
  CHECK(content_of(folder.path / "DATA.txt.bak2") == "second");
  CHECK(content_of(folder.path / "DATA.txt.bak5").empty());
  CHECK(count_files(folder.path) == 5);
}

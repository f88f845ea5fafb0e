#include "cli/driver.hpp"

/// The scripts of the top folder, in a copy with programs that leave a trace when they are called.
using namespace adore;
using namespace adore::test;

TEST_CASE("scripts: --help and unknown options → no work done", "[cli]") {
  const Folder folder;
  for (const std::string name : {"run.sh", "test.sh", "setup.sh"})
    fs::copy_file(source_dir() / name, folder / name);
  // Programs of the first steps of all three.
  fs::create_directories(folder / "bin");
  for (const std::string program : {"dpkg-query", "apt-get", "sudo", "cmake", "ninja", "git"}) {
    write(folder / "bin" / program,
          "#!/bin/sh\ntouch " + (folder / "began").string() + "\nexit 7\n");
    fs::permissions(folder / "bin" / program, fs::perms::owner_all);
  }
  const std::string here = "cd / && PATH=" + (folder / "bin").string() + ":$PATH ";
  for (const std::string name : {"run.sh", "test.sh", "setup.sh"}) {
    INFO(name);
    const std::string script = (folder / name).string();
    for (const std::string option : {"--help", "-h"}) {
      const Result told = run_shell(here + script + " " + option + " 2>/dev/null");
      CHECK(told.code == 0);
      CHECK(told.out.find("./" + name) != std::string::npos);
      CHECK_FALSE(fs::exists(folder / "began"));
    }
    for (const std::string option : {"--hepl", "x", "''"}) {
      INFO(option);
      const Result told = run_shell(here + script + " " + option + " 2>&1");
      CHECK(told.code == 2);
      CHECK(told.out.find("unknown option") != std::string::npos);
      CHECK_FALSE(fs::exists(folder / "began"));
    }
    // Without options the scripts begin: the trace works.
    CHECK(run_shell(here + script + " 2>&1").code != 0);
    CHECK(fs::exists(folder / "began"));
    fs::remove(folder / "began");
  }
}

#include "base/own_files.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

using namespace adore;

TEST_CASE("own_files: first bytes → type of the file; name and version → own file", "[unit]") {
  struct Case {
    std::string bytes;
    AdoreFileType sort;
    bool own;
  };
  using S = AdoreFileType;
  const std::string hdf5 = "\x89HDF\r\n\x1a\n";
  const std::vector<Case> cases{
      {"'Rec 1', 2, 1\n", S::Deck, false},
      {"\fAdore 0.9.0     run", S::Listing, true},
      {"  Adore0.9.0       run\n  Rolling Element 1$\n", S::Plot, true},
      {"  Adore0.9.0       run\n     8     9\n", S::Animation, true},
      {"  Adore0.9.0", S::Unknown, true},  // cut by a full disk
      {"Adore 0.9.0 FINAL: run\n", S::Final, true},
      {"Adore 0.9.0 MASTER: run\n", S::Master, true},
      {"{\n  \"program\": \"Adore 0.9.0\",", S::RunJson, true},
      {hdf5 + std::string(3000, '\0') + "Adore 0.9.0", S::ResultsH5, true},
      {"rpm2 [rpm],exit,time_s,message\n", S::SweepTable, true},
      // What others write.
      {"", S::Unknown, false},
      {"#!/bin/sh\necho Adore 0.9.0\n", S::Unknown, false},
      {"  ADORE 7.1        run\n  Rolling Element 1$\n", S::Plot, false},
      {"  Adore my notes\n  costs $\n", S::Plot, false},
      {"\fAll about Adore\n", S::Listing, false},
      {"Adore my cat: FINAL: \n", S::Final, false},
      {"{\"program\": \"another\"}", S::Json, false},
      {"{\"text\": \"a longer one, in which somebody quotes us\", \"program\": \"Adore 0.9.0\"}",
       S::RunJson, false},
      {hdf5 + "another program", S::ResultsH5, false},
      {"run,exit,message and more\n", S::SweepTable, false},
  };
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("adore-own-" + std::to_string(::getpid()));
  for (const Case& one : cases) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << one.bytes;
    INFO(one.bytes.substr(0, 60));
    CHECK(read_file_type(path) == one.sort);
    CHECK(is_written_by_adore(path) == one.own);
    CHECK(describe_file_type(one.sort).empty() == (one.sort == S::Unknown));
    CHECK(file_type_usage_hint(one.sort).empty() == (one.sort == S::Unknown));
  }
  std::filesystem::remove(path);
  CHECK_FALSE(is_written_by_adore(path));
  CHECK_FALSE(is_written_by_adore(std::filesystem::temp_directory_path()));
}

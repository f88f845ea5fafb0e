#pragma once

#include "core/results/synthetic.hpp"
#include "results/results_h5.hpp"

#include <catch2/catch.hpp>
#include <hdf5.h>

#include <filesystem>
#include <map>
#include <string>

/// RESULTS.h5 made by hand, for the views that rest on it.
namespace adore::test {

/// RESULTS.h5 of eight balls over 31 steps, or fewer.
inline void write_run(const testing::TemporaryFolder& folder, long last = 30) {
  using namespace adore::testing;
  const bearing::Bearing bearing = make_bearing(8);
  results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
  results::H5Writer h5 = results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  for (long step = 0; step <= last; ++step) h5.write(recorder.record(make_snapshot(bearing, step)));
  h5.close();
}

/// Sizes of its bearing, in place of those that it has.
inline void write_sizes(const std::filesystem::path& file,
                        const std::map<std::string, double>& sizes) {
  const hid_t h5 = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  REQUIRE(h5 >= 0);
  const hid_t group = H5Gopen2(h5, "geometry", H5P_DEFAULT), scalar = H5Screate(H5S_SCALAR);
  for (const auto& [name, value] : sizes) {
    if (H5Aexists(group, name.c_str()) > 0) H5Adelete(group, name.c_str());
    const hid_t size =
        H5Acreate2(group, name.c_str(), H5T_IEEE_F64LE, scalar, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(size, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(size);
  }
  H5Sclose(scalar);
  H5Gclose(group);
  H5Fclose(h5);
}

}  // namespace adore::test

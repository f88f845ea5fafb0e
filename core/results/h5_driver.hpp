#pragma once

#include "base/write_folder.hpp"
#include "results/hdf5_handle.hpp"

#include <string>

/// How RESULTS.h5 reaches the disk: a file driver for HDF5 under which the file on the disk is at
/// every moment one that any HDF5 program opens, whenever the process is killed or the disk is
/// full.
///
/// HDF5's single-writer mode orders what it writes so that nothing is referred to before it is
/// there, but marks the file as open and leaves the length in its first block (the superblock)
/// behind. This driver passes on every write in its order, and keeps that block free of the mark
/// and the length right. After the first write that fails it lets nothing more through and reports
/// success to the library (which would crash at exit with data it cannot get rid of): the file is
/// then as if the process had been killed there, and the caller asks for write_error().
namespace adore::results::h5 {

/// Makes files that are opened with this access list use the driver. Their names are looked up in
/// `folder`, and links are not followed.
void use_safe_driver(const Handle& access, const WriteFolder& folder);

/// errno of the first write to an open file that failed; 0: all is well. Held writes are passed on
/// before.
[[nodiscard]] int write_error(const Handle& file);

/// While it exists, raw data of an open file may wait in the caller's memory, so that consecutive
/// parts reach the file in one write. It is passed on before any other access to the file, so the
/// order of the writes stays the same.
/// @pre raw data is written from memory that outlives this object without change
class HeldWrites {
 public:
  explicit HeldWrites(const Handle& file);
  ~HeldWrites();
  HeldWrites(const HeldWrites&) = delete;
  HeldWrites& operator=(const HeldWrites&) = delete;

 private:
  void* driver_file_ = nullptr;
};

/// The bytes of a file as the library hands them out, with the first block in order: it takes the
/// mark away and leaves the checksum as it was.
void clear_open_mark(std::string& bytes);

}  // namespace adore::results::h5

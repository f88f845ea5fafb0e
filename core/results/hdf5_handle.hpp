#pragma once

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

/// A little RAII over the HDF5 C interface; only the RESULTS.h5 sources include it.
namespace adore::results::h5 {

/// Held by whoever is in the library: not every build of it knows threads, and a process that is
/// forked while another thread is inside would never get in.
inline std::recursive_mutex& hdf5_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// While it exists, only this thread uses the library, which prints no error stack to the terminal.
/// A nested one costs only a lock: destructors of handles are quiet anyway, and a block of
/// stored steps destroys hundreds.
class Hdf5Lock {
 public:
  Hdf5Lock() : lock_(hdf5_mutex()) {
    if (depth()++ > 0) return;
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Lock() {
    if (--depth() == 0) H5Eset_auto2(H5E_DEFAULT, function_, data_);
  }
  Hdf5Lock(const Hdf5Lock&) = delete;
  Hdf5Lock& operator=(const Hdf5Lock&) = delete;

 private:
  /// Of the thread that holds the lock; the library's error stack is its own in each thread, too.
  static int& depth() {
    static int depth = 0;
    return depth;
  }

  std::scoped_lock<std::recursive_mutex> lock_;
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// An HDF5 identifier of any kind, released when it goes.
class Handle {
 public:
  Handle() = default;
  explicit Handle(hid_t id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { reset(); }
  void reset() {
    if (id_ < 0) return;
    const Hdf5Lock quiet;
    switch (H5Iget_type(id_)) {
      case H5I_FILE:
        H5Fclose(id_);
        break;
      case H5I_GROUP:
        H5Gclose(id_);
        break;
      case H5I_DATASET:
        H5Dclose(id_);
        break;
      case H5I_DATASPACE:
        H5Sclose(id_);
        break;
      case H5I_DATATYPE:
        H5Tclose(id_);
        break;
      case H5I_ATTR:
        H5Aclose(id_);
        break;
      case H5I_GENPROP_LST:
        H5Pclose(id_);
        break;
      default:
        break;
    }
    id_ = H5I_INVALID_HID;
  }
  operator hid_t() const {
    return id_;
  }  // NOLINT(google-explicit-constructor): it stands for the identifier
  [[nodiscard]] bool valid() const { return id_ >= 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

/// Text of `width` bytes, padded with zeros. Declared ASCII where it is: programs that read ASCII
/// alone (Octave) take such texts and leave those of UTF-8.
inline Handle string_datatype(std::size_t width, std::string_view text) {
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type, std::max<std::size_t>(width, 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
  return type;
}

/// Deepest entry of the library's error stack.
inline std::string last_error() {
  std::string text = "unknown reason";
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_DOWNWARD,
      [](unsigned, const H5E_error2_t* error, void* data) -> herr_t {
        if (error->desc != nullptr && *error->desc != '\0')
          *static_cast<std::string*>(data) = error->desc;
        return 0;
      },
      &text);
  return text;
}

}  // namespace adore::results::h5

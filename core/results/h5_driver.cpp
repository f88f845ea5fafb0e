#include "results/h5_driver.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>
#include <vector>

namespace adore::results::h5 {
namespace {

/// The first block of a file of format 2 or 3, offsets of eight bytes: HDF5 file format
/// specification 3.0, section II.A.
constexpr std::size_t kSuperblock = 48, kFlags = 11, kEnd = 28, kSum = 44;
using Superblock = std::array<unsigned char, kSuperblock>;
constexpr std::array<unsigned char, 8> kSignature{0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};

/// Checksum of HDF5 metadata: Bob Jenkins' lookup3 of 2006 (public domain) over bytes.
std::uint32_t checksum(const unsigned char* bytes, std::size_t length) {
  std::uint32_t a = 0xdeadbeef + static_cast<std::uint32_t>(length), b = a, c = a;
  const auto word = [](const unsigned char* p, std::size_t count) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(count, 4); ++i)
      out |= static_cast<std::uint32_t>(p[i]) << (8 * i);
    return out;
  };
  for (; length > 12; length -= 12, bytes += 12) {
    a += word(bytes, 4), b += word(bytes + 4, 4), c += word(bytes + 8, 4);
    a -= c, a ^= std::rotl(c, 4), c += b;
    b -= a, b ^= std::rotl(a, 6), a += c;
    c -= b, c ^= std::rotl(b, 8), b += a;
    a -= c, a ^= std::rotl(c, 16), c += b;
    b -= a, b ^= std::rotl(a, 19), a += c;
    c -= b, c ^= std::rotl(b, 4), b += a;
  }
  if (length == 0) return c;
  a += word(bytes, length);
  if (length > 4) b += word(bytes + 4, length - 4);
  if (length > 8) c += word(bytes + 8, length - 8);
  c ^= b, c -= std::rotl(b, 14);
  a ^= c, a -= std::rotl(c, 11);
  b ^= a, b -= std::rotl(a, 25);
  c ^= b, c -= std::rotl(b, 16);
  a ^= c, a -= std::rotl(c, 4);
  b ^= a, b -= std::rotl(a, 14);
  c ^= b, c -= std::rotl(b, 24);
  return c;
}

template <class Number>
void put(unsigned char* at, Number value) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    at[i] = static_cast<unsigned char>(value >> (8 * i));
}

struct File {
  H5FD_t head{};  ///< the library's part comes first
  int descriptor = -1;
  haddr_t allocated = 0;  ///< end of what the library has given away
  haddr_t size = 0;       ///< of the file
  int error = 0;
  bool writing = false, has_superblock = false;
  Superblock superblock{};  ///< as it is in the file
  dev_t device = 0;
  ino_t inode = 0;
  bool may_hold = false;               ///< HeldWrites exists
  std::vector<struct iovec> held;      ///< consecutive parts of raw data that wait
  haddr_t held_from = 0, held_to = 0;  ///< their place

  /// Takes a part of raw data that may wait. @return whether it is taken
  bool hold(haddr_t at, const void* data, std::size_t count) {
    constexpr std::size_t kMaxParts = 512;  // below the limit of the system, 1024
    if (!may_hold) return false;
    if (at != held_to || held.size() >= kMaxParts) {
      pass_on();
      held_from = at;
    }
    held.push_back({const_cast<void*>(data), count});
    held_to = at + count;
    return true;
  }

  /// Writes the parts that wait.
  void pass_on() {
    if (held.empty()) return;
    if (error == 0 && announce(allocated)) write_parts(held_from);
    held.clear();
    held_from = held_to = 0;
  }

  void write_parts(haddr_t at) {
    for (struct iovec* part = held.data(); part != held.data() + held.size();) {
      const auto left = static_cast<int>(held.data() + held.size() - part);
      const ssize_t n = ::pwritev(descriptor, part, left, static_cast<off_t>(at));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return failed();
      at += static_cast<haddr_t>(n);
      size = std::max(size, at);
      auto done = static_cast<std::size_t>(n);
      for (; part != held.data() + held.size() && done >= part->iov_len; ++part)
        done -= part->iov_len;
      if (done == 0) continue;
      part->iov_base = static_cast<char*>(part->iov_base) + done;
      part->iov_len -= done;
    }
  }

  void failed() {
    if (error == 0) error = errno != 0 ? errno : EIO;
  }

  bool write(haddr_t at, const void* data, std::size_t count) {
    const char* from = static_cast<const char*>(data);
    while (count > 0) {
      const ssize_t n = ::pwrite(descriptor, from, count, static_cast<off_t>(at));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return failed(), false;
      from += n;
      at += static_cast<haddr_t>(n);
      count -= static_cast<std::size_t>(n);
    }
    size = std::max(size, at);
    return true;
  }

  bool resize(haddr_t to) {
    if (::ftruncate(descriptor, static_cast<off_t>(to)) != 0) return failed(), false;
    size = to;
    return true;
  }

  /// The first block with no mark of an open file, and with this end of the file.
  static Superblock clean(Superblock block, haddr_t end) {
    block[kFlags] = 0;
    put(block.data() + kEnd, static_cast<std::uint64_t>(end));
    put(block.data() + kSum, checksum(block.data(), kSum));
    return block;
  }

  static bool is_superblock(const Superblock& block) {
    return std::equal(kSignature.begin(), kSignature.end(), block.begin()) &&
           (block[8] == 2 || block[8] == 3) && block[9] == 8 && block[10] == 8;
  }

  /// The length stored in the file follows the released parts, before any part after the old
  /// end is referred to.
  bool announce(haddr_t end) {
    if (end > size && !resize(end)) return false;
    if (!has_superblock) return true;
    const Superblock next = clean(superblock, end);
    if (next == superblock) return true;
    if (!write(0, next.data(), next.size())) return false;
    superblock = next;
    return true;
  }

  void load_superblock() {
    Superblock block{};
    if (::pread(descriptor, block.data(), block.size(), 0) != static_cast<ssize_t>(block.size()) ||
        !is_superblock(block))
      return;
    superblock = block;
    has_superblock = true;
  }
};

File& file_of(H5FD_t* head) { return *reinterpret_cast<File*>(head); }
const File& file_of(const H5FD_t* head) { return *reinterpret_cast<const File*>(head); }

/// Entry of the driver in the access list, for the lookup of names.
struct Place {
  int folder = -1;
};

/// The file was made before (PendingFile): nothing is created or emptied here.
H5FD_t* open_file(const char* name, unsigned flags, hid_t access, haddr_t) {
  const auto* place = static_cast<const Place*>(H5Pget_driver_info(access));
  if (place == nullptr || (flags & (H5F_ACC_TRUNC | H5F_ACC_CREAT)) != 0) return nullptr;
  const int how = (flags & H5F_ACC_RDWR) != 0 ? O_RDWR : O_RDONLY;
  auto file = std::make_unique<File>();
  file->descriptor = ::openat(place->folder, name, how | O_NOFOLLOW | O_CLOEXEC);
  if (file->descriptor < 0) return nullptr;
  struct stat status {};
  if (::fstat(file->descriptor, &status) != 0) {
    ::close(file->descriptor);
    return nullptr;
  }
  file->size = static_cast<haddr_t>(status.st_size);
  file->device = status.st_dev;
  file->inode = status.st_ino;
  file->writing = (flags & H5F_ACC_RDWR) != 0;
  file->load_superblock();
  return &file.release()->head;
}

herr_t close_file(H5FD_t* head) {
  file_of(head).pass_on();
  ::close(file_of(head).descriptor);
  delete &file_of(head);
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  const File &one = file_of(a), &two = file_of(b);
  if (one.device != two.device) return one.device < two.device ? -1 : 1;
  return one.inode < two.inode ? -1 : one.inode > two.inode ? 1 : 0;
}

/// No accumulator: metadata goes out in the order in which the library gives it.
herr_t features(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA |
           H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t get_allocated(const H5FD_t* head, H5FD_mem_t) { return file_of(head).allocated; }
herr_t set_allocated(H5FD_t* head, H5FD_mem_t, haddr_t end) {
  file_of(head).allocated = end;
  return 0;
}
haddr_t get_size(const H5FD_t* head, H5FD_mem_t) { return file_of(head).size; }

herr_t get_handle(H5FD_t* head, hid_t, void** handle) {
  *handle = &file_of(head);
  return 0;
}

herr_t read_file(H5FD_t* head, H5FD_mem_t, hid_t, haddr_t at, std::size_t count, void* buffer) {
  File& file = file_of(head);
  file.pass_on();
  char* to = static_cast<char*>(buffer);
  haddr_t from = at;
  for (std::size_t left = count; left > 0;) {
    const ssize_t n = ::pread(file.descriptor, to, left, static_cast<off_t>(from));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return -1;
    if (n == 0) {  // behind the end of the file
      std::memset(to, 0, left);
      break;
    }
    to += n;
    from += static_cast<haddr_t>(n);
    left -= static_cast<std::size_t>(n);
  }
  // A file of an older version of this program whose writer was killed: without mark and old
  // length.
  if (file.has_superblock && at < kSuperblock) {
    const Superblock block = File::clean(file.superblock, file.size);
    const std::size_t first = static_cast<std::size_t>(at),
                      some = std::min(count, kSuperblock - first);
    std::memcpy(buffer, block.data() + first, some);
  }
  return 0;
}

herr_t write_file(H5FD_t* head, H5FD_mem_t type, hid_t, haddr_t at, std::size_t count,
                  const void* buffer) {
  File& file = file_of(head);
  if (file.error != 0) return 0;
  if (type == H5FD_MEM_DRAW && at != 0 && file.hold(at, buffer, count)) return 0;
  file.pass_on();
  if (file.error != 0) return 0;
  if (at != 0 || count < kSuperblock) {
    if (file.announce(file.allocated)) file.write(at, buffer, count);
    return 0;
  }
  Superblock block{};
  std::memcpy(block.data(), buffer, block.size());
  if (File::is_superblock(block)) {
    file.has_superblock = true;
    file.superblock = block;      // of the library: never equal to what announce() makes of it ...
    file.superblock[kFlags] = 1;  // ... so that it is written
    if (!file.announce(file.allocated)) return 0;
    at += kSuperblock;
    count -= kSuperblock;
    buffer = static_cast<const char*>(buffer) + kSuperblock;
  }
  if (count > 0) file.write(at, buffer, count);
  return 0;
}

herr_t truncate_file(H5FD_t* head, hid_t, hbool_t) {
  File& file = file_of(head);
  file.pass_on();
  if (file.error != 0 || !file.writing || file.allocated == file.size) return 0;
  if (file.announce(file.allocated) && file.size > file.allocated) file.resize(file.allocated);
  return 0;
}

herr_t accept_lock(H5FD_t*, hbool_t) { return 0; }  // the folder of a run is locked
herr_t accept_unlock(H5FD_t*) { return 0; }

hid_t driver() {
  static H5FD_class_t table = [] {
    H5FD_class_t t{};
    t.name = "adore";
    t.maxaddr = (static_cast<haddr_t>(1) << 63) - 1;
    t.fc_degree = H5F_CLOSE_WEAK;
    t.fapl_size = sizeof(Place);
    t.open = open_file;
    t.close = close_file;
    t.cmp = compare;
    t.query = features;
    t.get_eoa = get_allocated;
    t.set_eoa = set_allocated;
    t.get_eof = get_size;
    t.get_handle = get_handle;
    t.read = read_file;
    t.write = write_file;
    t.truncate = truncate_file;
    t.lock = accept_lock;
    t.unlock = accept_unlock;
    constexpr H5FD_mem_t kMap[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(kMap), std::end(kMap), std::begin(t.fl_map));
    return t;
  }();
  static const hid_t id = H5FDregister(&table);
  return id;
}

}  // namespace

void use_safe_driver(const Handle& access, const WriteFolder& folder) {
  const Place place{folder.descriptor()};
  H5Pset_driver(access, driver(), &place);
}

void clear_open_mark(std::string& bytes) {
  Superblock block{};
  if (bytes.size() < block.size()) return;
  std::memcpy(block.data(), bytes.data(), block.size());
  if (!File::is_superblock(block)) return;
  block = File::clean(block, bytes.size());
  std::memcpy(bytes.data(), block.data(), block.size());
}

namespace {

/// Null where the library has lost the file.
File* driver_file(const Handle& file) {
  void* handle = nullptr;
  if (H5Fget_vfd_handle(file, H5P_DEFAULT, &handle) < 0) return nullptr;
  return static_cast<File*>(handle);
}

}  // namespace

int write_error(const Handle& file) {
  File* const of_driver = driver_file(file);
  if (of_driver == nullptr) return EIO;
  of_driver->pass_on();
  return of_driver->error;
}

HeldWrites::HeldWrites(const Handle& file) : driver_file_(driver_file(file)) {
  if (driver_file_ != nullptr) static_cast<File*>(driver_file_)->may_hold = true;
}

HeldWrites::~HeldWrites() {
  if (driver_file_ == nullptr) return;
  File& file = *static_cast<File*>(driver_file_);
  file.pass_on();
  file.may_hold = false;
}

}  // namespace adore::results::h5

#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

/// The bookkeeping blocks of an HDF5 file and their checksums, so that tests can damage a file
/// behind its checksums' back. HDF5 File Format Specification 3.0: every block of the newer format
/// starts with four letters and ends with Bob Jenkins' lookup3 sum of what is before.
namespace adore::testing {

/// lookup3 "hashlittle" (Bob Jenkins, 2006, public domain) with start value 0, byte by byte.
inline std::uint32_t lookup3(std::string_view bytes) {
  const auto rotated = [](std::uint32_t x, unsigned k) { return (x << k) | (x >> (32 - k)); };
  std::uint32_t a = 0xdeadbeefU + static_cast<std::uint32_t>(bytes.size()), b = a, c = a;
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4 && at + k < bytes.size(); ++k)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    return value;
  };
  std::size_t at = 0;
  for (; bytes.size() - at > 12; at += 12) {
    a += word(at);
    b += word(at + 4);
    c += word(at + 8);
    a -= c, a ^= rotated(c, 4), c += b;
    b -= a, b ^= rotated(a, 6), a += c;
    c -= b, c ^= rotated(b, 8), b += a;
    a -= c, a ^= rotated(c, 16), c += b;
    b -= a, b ^= rotated(a, 19), a += c;
    c -= b, c ^= rotated(b, 4), b += a;
  }
  if (at == bytes.size()) return c;
  a += word(at);
  b += word(at + 4);
  c += word(at + 8);
  c ^= b, c -= rotated(b, 14);
  a ^= c, a -= rotated(c, 11);
  b ^= a, b -= rotated(a, 25);
  c ^= b, c -= rotated(b, 16);
  a ^= c, a -= rotated(c, 4);
  b ^= a, b -= rotated(a, 14);
  c ^= b, c -= rotated(b, 24);
  return c;
}

struct H5Block {
  std::string kind;
  std::size_t at = 0, size = 0;  ///< with the checksum, the last four bytes
};

/// Every block whose checksum is right, found by trying all lengths.
inline std::vector<H5Block> h5_blocks(const std::string& file) {
  constexpr std::size_t kLongest = 2048;
  constexpr std::array<std::string_view, 16> kKinds = {
      "OHDR", "OCHK", "FRHP", "FHDB", "FHIB", "BTHD", "BTIN", "BTLF",
      "EAHD", "EAIB", "EASB", "EADB", "FAHD", "FADB", "FSHD", "FSSE"};
  std::vector<H5Block> out;
  const auto add = [&](std::string_view kind, std::size_t at, std::size_t longest) {
    for (std::size_t size = 8; size + 4 <= longest && at + size + 4 <= file.size(); ++size) {
      const std::string_view before = std::string_view(file).substr(at, size);
      std::uint32_t stored = 0;
      std::memcpy(&stored, file.data() + at + size, 4);
      if (stored == 0 || stored != lookup3(before)) continue;
      out.push_back({std::string(kind), at, size + 4});
      return;
    }
  };
  add("superblock", 0, 64);
  for (std::size_t at = 8; at + 12 < file.size(); ++at)
    for (const std::string_view kind : kKinds)
      if (file[at] == kind[0] && file.compare(at, 4, kind) == 0) add(kind, at, kLongest);
  return out;
}

inline void set_checksum(std::string& file, const H5Block& block) {
  if (block.at + block.size > file.size()) return;
  const std::uint32_t sum = lookup3(std::string_view(file).substr(block.at, block.size - 4));
  std::memcpy(file.data() + block.at + block.size - 4, &sum, 4);
}

}  // namespace adore::testing

// Numbers and texts as a string of bytes, which are read in the order in which they were written.
#pragma once

#include <cstddef>
#include <cstring>
#include <string>

namespace hawser {

class BytesWriter {
 public:
  // Seven bits a byte, the lowest first.
  void count(std::size_t n) {
    for (; n > 0x7f; n >>= 7) bytes += static_cast<char>(0x80 | (n & 0x7f));
    bytes += static_cast<char>(n);
  }
  void real(double x) { bytes.append(reinterpret_cast<const char*>(&x), sizeof x); }
  void text(const std::string& text) {
    count(text.size());
    bytes += text;
  }

  std::string bytes;
};

// The bytes must outlive it.
class BytesReader {
 public:
  explicit BytesReader(const std::string& bytes) : bytes_(bytes) {}

  bool at_end() const { return at_ == bytes_.size(); }
  std::size_t count() {
    std::size_t n = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_[at_++]);
      n |= static_cast<std::size_t>(byte & 0x7f) << shift;
      if (byte <= 0x7f) return n;
    }
  }
  double real() {
    double x = 0;
    std::memcpy(&x, bytes_.data() + at_, sizeof x);
    at_ += sizeof x;
    return x;
  }
  std::string text() {
    const std::size_t size = count();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace hawser

// Classic NetCDF formats: a big-endian header with dimensions, attributes and variables, then the contiguous
// values of each variable. Version 2 has 64-bit offsets, version 5 also 64-bit counts.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "netcdf.hpp"

namespace hawser::io {
namespace {

enum Type { kByte = 1, kChar, kShort, kInt, kFloat, kDouble, kUByte, kUShort, kUInt, kInt64, kUInt64 };

size_t size_of(std::uint64_t type) {
  switch (type) {
    case kByte:
    case kChar:
    case kUByte:
      return 1;
    case kShort:
    case kUShort:
      return 2;
    case kInt:
    case kFloat:
    case kUInt:
      return 4;
    case kDouble:
    case kInt64:
    case kUInt64:
      return 8;
    default:
      throw std::runtime_error("a variable has an unknown type");
  }
}

class Header {
 public:
  explicit Header(const std::string& bytes) : bytes_(bytes) {
    need(4);
    version_ = static_cast<unsigned char>(bytes[3]);
    if (version_ != 1 && version_ != 2 && version_ != 5) throw std::runtime_error("its version is unknown");
    at_ = 4;
  }
  std::uint64_t number(size_t size) {
    need(size);
    const std::uint64_t value = bits(at_, size);
    at_ += size;
    return value;
  }
  std::uint64_t count() { return number(version_ == 5 ? 8 : 4); }
  std::uint64_t place() { return number(version_ == 1 ? 4 : 8); }
  std::string name() {
    const std::uint64_t length = count();
    need(length);
    std::string text = bytes_.substr(at_, length);
    skip(length);
    return text;
  }
  void skip_attributes() {
    number(4);
    for (std::uint64_t n = count(); n > 0; --n) {
      name();
      const size_t size = size_of(number(4));
      const std::uint64_t values = count();
      need(values);
      skip(values * size);
    }
  }
  // Unsigned integer of `size` bytes.
  std::uint64_t bits(std::uint64_t at, size_t size) const {
    std::uint64_t value = 0;
    for (size_t i = 0; i < size; ++i) value = value << 8 | static_cast<unsigned char>(bytes_[at + i]);
    return value;
  }
  void need(std::uint64_t size) const { need(at_, size); }
  void need(std::uint64_t at, std::uint64_t size) const {
    if (at > bytes_.size() || size > bytes_.size() - at) throw std::runtime_error("it is cut short");
  }

 private:
  // Skips `size` bytes and the padding to a multiple of four.
  void skip(std::uint64_t size) {
    const std::uint64_t filled = (size + 3) / 4 * 4;
    need(filled);
    at_ += filled;
  }
  const std::string& bytes_;
  int version_ = 0;
  std::uint64_t at_ = 0;
};

double value_of(const Header& file, std::uint64_t at, std::uint64_t type) {
  const std::uint64_t bits = file.bits(at, size_of(type));
  switch (type) {
    case kByte:
      return static_cast<std::int8_t>(bits);
    case kShort:
      return static_cast<std::int16_t>(bits);
    case kInt:
      return static_cast<std::int32_t>(bits);
    case kInt64:
      return static_cast<double>(static_cast<std::int64_t>(bits));
    case kFloat: {
      const auto narrow = static_cast<std::uint32_t>(bits);
      float value = 0;
      std::memcpy(&value, &narrow, sizeof value);
      return value;
    }
    case kDouble: {
      double value = 0;
      std::memcpy(&value, &bits, sizeof value);
      return value;
    }
    default:
      return static_cast<double>(bits);
  }
}

}  // namespace

std::map<std::string, NetcdfVariable> read_netcdf_classic(const std::string& bytes,
                                                          const std::vector<std::string>& names) {
  Header file(bytes);
  file.count();  // number of records
  std::vector<std::pair<std::string, std::uint64_t>> dimensions;
  file.number(4);
  for (std::uint64_t n = file.count(); n > 0; --n) {
    std::string name = file.name();
    dimensions.emplace_back(std::move(name), file.count());
  }
  file.skip_attributes();
  std::map<std::string, NetcdfVariable> out;
  file.number(4);
  for (std::uint64_t n = file.count(); n > 0; --n) {
    const std::string name = file.name();
    NetcdfVariable v;
    std::uint64_t values = 1;
    for (std::uint64_t rank = file.count(); rank > 0; --rank) {
      const std::uint64_t id = file.count();
      if (id >= dimensions.size()) throw std::runtime_error("a variable has an unknown dimension");
      v.dimensions.push_back(dimensions[id].first);
      v.shape.push_back(dimensions[id].second);
      values *= dimensions[id].second;
      if (values > bytes.size()) throw std::runtime_error("it is cut short");
    }
    file.skip_attributes();
    const std::uint64_t type = file.number(4);
    file.count();  // size in bytes
    const std::uint64_t at = file.place();
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    const size_t size = size_of(type);
    file.need(at, values * size);
    for (std::uint64_t i = 0; i < values; ++i)
      if (type == kChar)
        v.texts.emplace_back(1, bytes[at + i]);
      else
        v.values.push_back(value_of(file, at + i * size, type));
    out[name] = std::move(v);
  }
  return out;
}

}  // namespace hawser::io

// Bytes of a value: its kind, its line counted from that of the value around it, then its text, or the number
// of its items with the items, of a map each after its key.
#include "hawser/model/packed_value.hpp"

#include <string>
#include <utility>

#include "hawser/model/schema.hpp"

namespace hawser::model {
namespace {

using Kind = Value::Kind;

constexpr int kQuoted = 8;  // added to the kind

class Packing {
 public:
  std::string bytes;

  void put(const Value& v, int line) {
    bytes += static_cast<char>(static_cast<int>(v.kind) + (v.quoted ? kQuoted : 0));
    put(static_cast<std::size_t>(v.line - line));
    if (v.kind == Kind::scalar) return put(v.text);
    put(v.items.size());
    for (std::size_t i = 0; i < v.items.size(); ++i) {
      if (v.kind == Kind::map) put(v.keys[i]);
      put(v.items[i], v.line);
    }
  }

 private:
  // Seven bits a byte, the lowest first.
  void put(std::size_t n) {
    for (; n > 0x7f; n >>= 7) bytes += static_cast<char>(0x80 | (n & 0x7f));
    bytes += static_cast<char>(n);
  }
  void put(const std::string& text) {
    put(text.size());
    bytes += text;
  }
};

class Unpacking {
 public:
  explicit Unpacking(const std::string& bytes) : bytes_(bytes) {}

  Value value(int line) {
    Value v;
    const int kind = bytes_[at_++];
    v.kind = static_cast<Kind>(kind % kQuoted);
    v.quoted = kind >= kQuoted;
    v.line = line + static_cast<int>(number());
    if (v.kind == Kind::scalar) {
      v.text = text();
      return v;
    }
    const std::size_t items = number();
    v.items.reserve(items);
    if (v.kind == Kind::map) v.keys.reserve(items);
    for (std::size_t i = 0; i < items; ++i) {
      if (v.kind == Kind::map) v.keys.push_back(text());
      v.items.push_back(value(v.line));
    }
    return v;
  }

 private:
  std::size_t number() {
    std::size_t n = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_[at_++]);
      n |= static_cast<std::size_t>(byte & 0x7f) << shift;
      if (byte <= 0x7f) return n;
    }
  }
  std::string text() {
    const std::size_t size = number();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

void pack(Value& v) {
  Packing packing;
  packing.put(v, v.line);
  Value out;
  out.kind = Kind::packed;
  out.line = v.line;
  out.text = std::move(packing.bytes);
  out.text.shrink_to_fit();
  v = std::move(out);
}

Value unpacked(const Value& v) { return v.kind == Kind::packed ? Unpacking(v.text).value(v.line) : v; }

Entry::Entry(const Value& map, std::size_t i) : at_(&map.items[i]) {
  if (at_->kind != Kind::packed) return;
  const auto own = std::make_shared<Value>(unpacked(*at_));
  if (map.schema && map.schema->type == Key::Type::names)
    check_again(*own, map.schema->keys[0], map.where + "." + map.keys[i]);
  own_ = own;
  at_ = own_.get();
}

Entry find_entry(const Value& map, std::string_view name) {
  if (map.kind == Kind::packed) {
    const auto open = std::make_shared<const Value>(unpacked(map));
    const Value* found = open->find(name);
    return found ? Entry(std::shared_ptr<const Value>(open, found)) : Entry();
  }
  for (std::size_t i = 0; i < map.keys.size(); ++i)
    if (map.keys[i] == name) return Entry(map, i);
  return {};
}

}  // namespace hawser::model

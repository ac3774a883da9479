// Bytes of a value: its kind, its line counted from that of the value around it, then its text, or the number
// of its items with the items, of a map each after its key.
#include "hawser/model/packed_value.hpp"

#include <utility>

#include "hawser/base/packed_bytes.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::model {
namespace {

using Kind = Value::Kind;

constexpr int kQuoted = 8;  // added to the kind

void write(const Value& v, int line, BytesWriter& to) {
  to.count(static_cast<std::size_t>(static_cast<int>(v.kind) + (v.quoted ? kQuoted : 0)));
  to.count(static_cast<std::size_t>(v.line - line));
  if (v.kind == Kind::scalar) return to.text(v.text);
  to.count(v.items.size());
  for (std::size_t i = 0; i < v.items.size(); ++i) {
    if (v.kind == Kind::map) to.text(v.keys[i]);
    write(v.items[i], v.line, to);
  }
}

Value read(BytesReader& from, int line) {
  Value v;
  const int kind = static_cast<int>(from.count());
  v.kind = static_cast<Kind>(kind % kQuoted);
  v.quoted = kind >= kQuoted;
  v.line = line + static_cast<int>(from.count());
  if (v.kind == Kind::scalar) {
    v.text = from.text();
    return v;
  }
  const std::size_t items = from.count();
  v.items.reserve(items);
  if (v.kind == Kind::map) v.keys.reserve(items);
  for (std::size_t i = 0; i < items; ++i) {
    if (v.kind == Kind::map) v.keys.push_back(from.text());
    v.items.push_back(read(from, v.line));
  }
  return v;
}

}  // namespace

void pack(Value& v) {
  BytesWriter to;
  write(v, v.line, to);
  Value out;
  out.kind = Kind::packed;
  out.line = v.line;
  out.text = std::move(to.bytes);
  out.text.shrink_to_fit();
  v = std::move(out);
}

Value unpacked(const Value& v) {
  if (v.kind != Kind::packed) return v;
  BytesReader from(v.text);
  return read(from, v.line);
}

Entry::Entry(const Value& map, std::size_t i) : at_(&map.items[i]) {
  if (at_->kind != Kind::packed) return;
  const auto value = std::make_shared<Value>(unpacked(*at_));
  if (map.schema && map.schema->type == Key::Type::map_by_name)
    check_again(*value, map.schema->keys[0], map.where + "." + map.keys[i]);
  owned_ = value;
  at_ = owned_.get();
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

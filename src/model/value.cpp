// Look-up of values in the tree of a case file by key, and file lines of dotted keys for error messages.
#include "hawser/model/value.hpp"

#include <charconv>
#include <stdexcept>

#include "hawser/model/packed_value.hpp"

namespace hawser::model {

const Value* Value::find(std::string_view key) const {
  if (kind != Kind::map) return nullptr;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (keys[i] == key) return &items[i];
  return nullptr;
}

const Value& Value::operator[](std::string_view key) const {
  if (const Value* v = find(key)) return *v;
  throw std::out_of_range("no key '" + std::string(key) + "'");
}

std::vector<std::pair<double, double>> Value::rows() const {
  std::vector<std::pair<double, double>> out;
  for (const Value& row : items) out.emplace_back(row.items[0].number, row.items[1].number);
  return out;
}

int Value::line_of(std::string_view path) const {
  const Value* v = this;
  Value open;  // an entry that was packed
  int line_found = line;
  while (!path.empty()) {
    const Value* next = nullptr;
    if (path.front() == '[') {
      const std::size_t close = path.find(']');
      if (close == std::string_view::npos) break;
      std::size_t index = 0;
      std::from_chars(path.data() + 1, path.data() + close, index);
      if (v->kind == Kind::list && index < v->items.size()) next = &v->items[index];
      path.remove_prefix(close + 1);
    } else {
      const std::size_t end = std::min(path.find_first_of(".["), path.size());
      next = v->find(path.substr(0, end));
      path.remove_prefix(end);
    }
    if (!path.empty() && path.front() == '.') path.remove_prefix(1);
    if (!next) break;
    if (next->kind == Kind::packed) {
      open = unpacked(*next);
      next = &open;
    }
    v = next;
    if (v->given && v->line != 0) line_found = v->line;
  }
  return line_found;
}

}  // namespace hawser::model

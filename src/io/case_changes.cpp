// Look-up of a changed key in the document and the schema at once, and messages for keys that do not exist.
#include "hawser/io/case_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "hawser/advice/case_changes.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/yaml_document.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {
namespace {

using model::Key;
using model::Value;
using Type = Key::Type;
using Kind = Value::Kind;

struct Step {
  std::string name;  // empty: an index of a list
  std::size_t index = 0;
};

class Change {
 public:
  Change(const std::string& text, const std::string& file) : text_(text), file_(file) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      refuse("", "is not KEY=VALUE; write for example --set dynamics.duration=600");
    key_ = text.substr(0, text.find_last_not_of(" \t=", equals) + 1);
    given_ = text.substr(equals + 1);
    if (given_.find_first_not_of(" \t") == std::string::npos)
      refuse("", "has nothing after the '='; 'null' removes a key");
    read_steps();
    try {
      value_ = parse_yaml(given_, "");
    } catch (const InputError&) {
      refuse("", "{} is not a YAML value: {}", model::quote(given_), why_no_value());
    }
    mark(value_);
  }

  // Applies the change and returns its note.
  std::string make(Value& root) {
    Value* parent = nullptr;
    Value* at = &root;
    const Key* key = &model::case_schema();
    std::string path;
    bool added = false;
    for (const Step& step : steps_) {
      parent = at;
      key = &form(*key, step);
      const std::size_t before = at->items.size();
      at = step.name.empty() ? &item(*at, *key, step.index, path) : &entry(*at, *key, step.name, path);
      added = added || parent->items.size() > before;
      key = key->type == Type::map    ? &*std::find_if(key->keys.begin(), key->keys.end(),
                                                       [&](const Key& k) { return k.name == step.name; })
            : key->type == Type::vec3 ? key
                                      : &key->keys[0];
    }
    const std::string note = advice::value_set(path, given_, added ? nullptr : at);
    if (value_.kind == Kind::null)
      remove(*parent, *at, path);
    else
      *at = value_;
    return note;
  }

 private:
  template <class... Args>
  [[noreturn]] void refuse(const std::string& path, fmt::format_string<Args...> why, Args&&... args) const {
    throw InputError("{} with --set {}: {}{}{}", file_, text_, path, path.empty() ? "" : ": ",
                     fmt::format(why, std::forward<Args>(args)...));
  }

  // Parses the value as that of a key, for the hints of the YAML parser.
  std::string why_no_value() const {
    try {
      parse_yaml("value: " + given_ + "\n", "");
      return "it would be one within braces, {" + given_ + "}";
    } catch (const InputError& e) {  // ":1: what is wrong"
      const std::string why = e.what();
      return why.substr(why.find(' ') + 1);
    }
  }

  static void mark(Value& v) {
    v.line = model::kBySet;
    for (Value& x : v.items) mark(x);
  }

  // Splits key_ into steps_.
  void read_steps() {
    std::size_t at = 0;
    const auto wrong = [&](const std::string& why) {
      refuse("", "{}; a key is written as lines.riser.sections[0].length", why);
    };
    while (at < key_.size()) {
      if (key_[at] == '[') {
        const std::size_t end = key_.find(']', at);
        const std::string digits = end == std::string::npos ? "" : key_.substr(at + 1, end - at - 1);
        if (digits.empty() || digits.size() > 6 ||
            digits.find_first_not_of("0123456789") != std::string::npos)
          wrong("brackets hold the number of a place in a list, from 0");
        if (steps_.empty()) wrong("the key begins with a bracket");
        steps_.push_back({"", static_cast<std::size_t>(std::stoi(digits))});
        at = end + 1;
        if (at < key_.size() && key_[at] != '.' && key_[at] != '[') wrong("a '.' is missing after a bracket");
      } else {
        if (!steps_.empty() && key_[at] == '.') ++at;
        const std::size_t end = std::min(key_.find_first_of(".[", at), key_.size());
        if (end == at) wrong("a name is missing in the key");
        steps_.push_back({key_.substr(at, end - at), 0});
        at = end;
      }
    }
    if (key_.back() == '.') wrong("the key ends with a '.'");
  }

  // The alternative of a key into which the step leads.
  static const Key& form(const Key& key, const Step& step) {
    if (key.type != Type::one_of) return key;
    for (const Key& k : key.keys) {
      const bool list = k.type == Type::list || k.type == Type::vec3;
      if (step.name.empty() ? list : k.type == Type::map || k.type == Type::map_by_name) return k;
    }
    return key;
  }

  static std::string kind_of_value(const Value& v) {
    return v.kind == Kind::scalar ? model::quote(v.text) : v.kind == Kind::list ? "a list" : "a map of keys";
  }

  Value& entry(Value& v, const Key& key, const std::string& name, std::string& path) const {
    if (key.type == Type::list || key.type == Type::vec3)
      refuse(path, "is a list: give a place in it, '{}[0]', not '{}'", path, name);
    if (key.type != Type::map && key.type != Type::map_by_name)
      refuse(path, "is {}, which has no keys", model::describe(key));
    std::vector<std::string> known;
    for (const Key& k : key.keys) known.push_back(k.name);
    if (key.type == Type::map_by_name) known = v.keys;
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      std::string meant = model::did_you_mean(name, known);
      if (const std::string below = key.type == Type::map ? model::place_below(key, name) : "";
          !below.empty())
        meant = fmt::format("; did you mean '{}{}{}'?", path, path.empty() ? "" : ".", below);
      if (key.type == Type::map_by_name && name.find('/') != std::string::npos)
        meant =
            "; a part of a farm's platform changes at all its places, by 'farm.of.' before its key, or "
            "'farm[1].of.' for the second entry of 'farm'";
      known.resize(std::min<std::size_t>(known.size(), 20));
      refuse(path, "{} '{}'{} ({}: {})", key.type == Type::map_by_name ? "there is no" : "unknown key", name,
             meant, key.type == Type::map_by_name ? "there are" : "allowed",
             known.empty() ? "none" : model::enumerate(known, "and"));
    }
    if (v.kind == Kind::null) v.kind = Kind::map;
    if (v.kind != Kind::map)
      refuse(path, "the file has {} here, which has no key '{}'; give the whole: --set '{}={{{}: ...}}'",
             kind_of_value(v), name, path, name);
    path += (path.empty() ? "" : ".") + name;
    const auto at = std::find(v.keys.begin(), v.keys.end(), name);
    if (at != v.keys.end()) return opened(v.items[at - v.keys.begin()]);
    v.keys.push_back(name);
    Value& added = v.items.emplace_back();
    added.line = model::kBySet;
    return added;
  }

  Value& item(Value& v, const Key& key, std::size_t index, std::string& path) const {
    if (key.type == Type::map) refuse(path, "is no list but has keys: {}.{}", path, key.keys[0].name);
    if (key.type != Type::list && key.type != Type::vec3 && key.type != Type::map_by_name)
      refuse(path, "is {}, not a list", model::describe(key));
    if (v.kind != (key.type == Type::map_by_name ? Kind::map : Kind::list))
      refuse(path, "{}",
             v.kind == Kind::null ? std::string("is not in the file; give the whole list")
                                  : fmt::format("the file has {} here, not a list", kind_of_value(v)));
    if (index >= v.items.size())
      refuse(path, "has no [{}]: there are {}, from [0] to [{}]", index, v.items.size(), v.items.size() - 1);
    path += key.type == Type::map_by_name ? "." + v.keys[index] : fmt::format("[{}]", index);
    return opened(v.items[index]);
  }

  static Value& opened(Value& v) {
    if (v.kind == Kind::packed) v = model::unpacked(v);
    return v;
  }

  void remove(Value& parent, const Value& v, const std::string& path) const {
    if (parent.kind != Kind::map) refuse(path, "'null' removes keys, not entries of lists");
    const auto at = &v - parent.items.data();
    parent.items.erase(parent.items.begin() + at);
    parent.keys.erase(parent.keys.begin() + at);
  }

  const std::string &text_, &file_;
  std::string key_, given_;
  std::vector<Step> steps_;
  Value value_;
};

}  // namespace

std::vector<std::string> change_document(Value& root, const std::vector<std::string>& changes,
                                         const std::string& file) {
  std::vector<std::string> notes;
  for (const std::string& text : changes) notes.push_back(Change(text, file).make(root));
  return notes;
}

}  // namespace hawser::io

// Schema of the case file, the single source of the checker, the key tables of the user guide and the JSON
// Schema for editors. A new key is one line in src/model/schema_<subject>.cpp, which names the field of the
// case (case.hpp) that it fills; src/model/schema_build.hpp describes the notation.
#pragma once

#include <fmt/core.h>

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <vector>

#include "hawser/model/units.hpp"
#include "hawser/model/value.hpp"

namespace hawser::model {

// Value::line of values set by --set.
inline constexpr int kBySet = -1;
// Value::number of an arc length given as 'end_b'.
inline constexpr double kEndB = std::numeric_limits<double>::infinity();

struct Bounds {
  std::optional<double> above, at_least, at_most;  // SI (angles: rad)
};

// Keys that belong together; at most one group of a map may be used.
struct Group {
  std::vector<std::string> keys;
  std::vector<std::string> needed;  // keys that must be present if the group is used

  Group(const char* key) : keys{key}, needed{key} {}
  Group(std::vector<std::string> k, std::vector<std::string> n) : keys(std::move(k)), needed(std::move(n)) {}
};

// Type-checked reference to a struct of the case (case.hpp) that keys fill.
class Target {
 public:
  template <class T>
  Target(T& o) : at_(&o), type_(&typeid(T)) {}
  template <class T>
  T& as() const {
    if (*type_ != typeid(T)) throw std::logic_error("a key is bound to a field of another struct");
    return *static_cast<T*>(at_);
  }

 private:
  void* at_;
  const std::type_info* type_;
};
// Stores a checked value in a field of the target.
using Put = std::function<void(const Target&, const Value&)>;

struct Key {
  enum class Type {
    number,
    integer,
    boolean,
    word,         // one of `words`
    text,         // any text (a file name, a title)
    name,         // letters, digits, '_', '-', '+', blanks
    reference,    // name of an entry of the top-level map `refers`
    vec3,         // list of three numbers
    list,         // keys[0] describes its items
    map,          // with the keys `keys`
    map_by_name,  // map from names of the user's choice to keys[0]
    one_of        // alternatives `keys`, distinguished by their form: number, word, list, map
  };

  std::string name;
  Type type = Type::map;
  std::string about;  // one line
  Dimension unit = Dimension::none;
  Bounds bounds;
  std::vector<std::string> words;
  std::vector<double> meanings;  // numbers or enumerators of `words`
  std::string refers;
  std::optional<std::string> fallback;  // default, as it would be written in the file
  std::string fallback_note;            // default in words, if it depends on other keys
  bool required = false;
  bool fixed_in_restart = false;  // this key and all keys below must not change in a restart
  std::vector<Key> keys;
  std::size_t min_items = 0, max_items = 0;  // of lists and names; 0: no limit
  std::vector<Group> groups;
  bool group_required = false;  // one of the groups must be used
  // Fields that the key fills. If empty, keys of a map fill the enclosing struct; other keys are read by hand
  // (src/io/case_reader*.cpp).
  std::vector<Put> fields;
};

// The whole case file: a map.
const Key& case_schema();

// "a number [m]", "'auto' or a number [s]", "a list of 3 numbers [m]", ...
std::string describe(const Key& key);

// Place of a key called `name` below a key (ignoring letter case): "sections[0].length" for a line; the
// shallowest one, not below names of the user's choice. Empty: none, or in the key itself.
std::string place_below(const Key& key, std::string_view name);

// Names that references may use besides the entries of the document, by top-level map.
using MoreNames = std::map<std::string, std::vector<std::string>>;
// Check `root` against the schema, fill in defaults (Value::given = false), set Value::number in SI,
// resolve references. Throws InputError "file:line: dotted.key: ..." at the first fault.
void check_structure(Value& root, const Key& schema, const std::string& file, const MoreNames& more = {});

// The same for a value that was found to be right, whose dotted key is `where`.
void check_again(Value& v, const Key& key, const std::string& where);

// Stores v in the fields of `target` that its key and the keys below fill. given: only values from the file,
// no defaults.
void take(const Value& v, const Target& target, bool given = false);

// A well-formed but inadmissible value; the case reader converts it to an InputError.
struct Refusal : std::runtime_error {
  Refusal(const Value& at, std::string where, const std::string& text);
  int line;
  std::string where;  // dotted key
};
// Throw a Refusal of this value or of another key on its line. Here and below the text is literal or an fmt
// format string.
[[noreturn]] void refuse(const Value& v, const std::string& text);
template <class First, class... More>
[[noreturn]] void refuse(const Value& v, fmt::format_string<First, More...> text, First&& first,
                         More&&... more) {
  refuse(v, fmt::format(text, std::forward<First>(first), std::forward<More>(more)...));
}
[[noreturn]] void refuse_key(const Value& at, const std::string& key, const std::string& text);
template <class First, class... More>
[[noreturn]] void refuse_key(const Value& at, const std::string& key, fmt::format_string<First, More...> text,
                             First&& first, More&&... more) {
  refuse_key(at, key, fmt::format(text, std::forward<First>(first), std::forward<More>(more)...));
}

// refusal() returns "file:line: key: text"; fail() throws it as an InputError.
std::string refusal(const std::string& file, int line, const std::string& key, const std::string& text);
[[noreturn]] void fail(const std::string& file, int line, const std::string& key, const std::string& text);
template <class First, class... More>
[[noreturn]] void fail(const std::string& file, int line, const std::string& key,
                       fmt::format_string<First, More...> text, First&& first, More&&... more) {
  fail(file, line, key, fmt::format(text, std::forward<First>(first), std::forward<More>(more)...));
}

// Values of all keys below v that are fixed_in_restart, by dotted key, as text: numbers in SI, keys of maps
// in alphabetical order. v must be checked.
std::map<std::string, std::string> fixed_values(const Value& v);
// The part of the tree of a case file that line_of() and fixed_values() read: entries on another line of the
// file than the entry around them, and values that are fixed_in_restart. v: a checked value.
Value without_values(const Value& v);
// A checked value as such a text.
std::string value_text(const Value& v);

// The key tables (Markdown) and the JSON Schema (draft 2020-12), which the build writes to build/docs.
std::string schema_markdown();
std::string schema_json();

// Allowed characters of a name as a regular expression for the JSON Schema, and the corresponding test.
const char* name_pattern();
bool is_name(std::string_view text);

}  // namespace hawser::model

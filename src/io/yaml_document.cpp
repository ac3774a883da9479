#include "hawser/io/yaml_document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>

#include "hawser/base/error.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {
namespace {

using model::Value;

class Converter {
 public:
  explicit Converter(const std::string& file) : file_(file) {}

  Value convert(const YAML::Node& node, int line, const std::string& path, int depth) {
    constexpr int kDeepest = 40;
    constexpr int kMost = 1'000'000;
    if (depth > kDeepest) model::fail(file_, line, path, "is nested too deeply");
    if (++count_ > kMost) model::fail(file_, line, path, "has too many entries");
    Value v;
    v.line = line;
    switch (node.Type()) {
      case YAML::NodeType::Undefined:
      case YAML::NodeType::Null:
        v.kind = Value::Kind::null;
        break;
      case YAML::NodeType::Scalar:
        v.kind = Value::Kind::scalar;
        v.text = node.Scalar();
        v.quoted = node.Tag() == "!";
        break;
      case YAML::NodeType::Sequence: {
        v.kind = Value::Kind::list;
        std::size_t i = 0;
        for (const YAML::Node& item : node)
          v.items.push_back(convert(item, line_of(item, line), fmt::format("{}[{}]", path, i++), depth + 1));
        break;
      }
      case YAML::NodeType::Map:
        convert_map(node, v, path, depth);
        break;
    }
    return v;
  }

  static int line_of(const YAML::Node& node, int otherwise) {
    const YAML::Mark m = node.Mark();
    return m.line < 0 ? otherwise : m.line + 1;
  }

 private:
  void convert_map(const YAML::Node& node, Value& v, const std::string& path, int depth) {
    v.kind = Value::Kind::map;
    std::set<std::string> seen;
    for (const auto& entry : node) {
      const int line = line_of(entry.first, v.line);
      if (!entry.first.IsScalar()) model::fail(file_, line, path, "has an entry whose key is no plain word");
      const std::string key = entry.first.Scalar();
      const std::string below = path.empty() ? key : path + "." + key;
      if (!seen.insert(key).second)
        model::fail(file_, line, below, fmt::format("is given twice (first in line {})", v.line_of(key)));
      Value value = convert(entry.second, line, below, depth + 1);
      v.keys.push_back(key);
      v.items.push_back(std::move(value));
    }
  }

  const std::string& file_;
  int count_ = 0;
};

}  // namespace

model::Value parse_yaml(const std::string& text, const std::string& file) {
  if (text.find('\0') != std::string::npos) model::fail(file, 1, "", "is no text file: it holds zero bytes");
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    if (documents.empty()) model::fail(file, 1, "", "the file is empty");
    if (documents.size() > 1)
      model::fail(file, Converter::line_of(documents[1], 1), "",
                  "a second YAML document begins here; a case file holds one");
    return Converter(file).convert(documents[0], Converter::line_of(documents[0], 1), "", 0);
  } catch (const YAML::Exception& e) {
    const int line = e.mark.line < 0 ? 1 : e.mark.line + 1;
    model::fail(file, line, "",
                fmt::format("this is not valid YAML at column {}: {}", std::max(e.mark.column, 0) + 1,
                            e.msg.empty() ? "the text breaks off" : e.msg));
  }
}

}  // namespace hawser::io

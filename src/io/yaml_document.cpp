// Tree from the events of the YAML parser. YAML::LoadAll is not used: some invalid files make it loop for
// ever.
#include "hawser/io/yaml_document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"
#include "yaml_faults.hpp"

namespace hawser::io {
namespace {

using model::Value;

constexpr std::size_t kDeepest = 40;
constexpr long kMostNodes = 1'000'000;

int line_of(const YAML::Mark& m) { return std::max(m.line, 0) + 1; }

class TreeBuilder final : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const std::string& file) : file_(file) {}

  Value take() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { leaf(Value(), mark, anchor, 1); }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    Value v;
    v.kind = Value::Kind::scalar;
    v.text = text;
    v.quoted = tag == "!";
    leaf(std::move(v), mark, anchor, 1);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end())  // the anchored value is still being built
      model::fail(file_, line_of(mark), path(), "is an alias of something that holds it");
    count_nodes(known->second.nodes, line_of(mark));
    leaf(known->second.value, mark, 0, 0);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(Value::Kind::list, mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(Value::Kind::map, mark, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Frame {
    Value value;
    YAML::anchor_t anchor = 0;
    long nodes_before = 0;
    std::string key;  // of the current map entry
    int key_line = 0;
    bool has_key = false;
    std::map<std::string, int> key_lines;
  };
  struct Anchor {
    Value value;
    long nodes = 0;
  };

  std::string path() const {
    std::string p;
    for (const Frame& f : stack_) {
      if (f.value.kind == Value::Kind::list)
        p += fmt::format("[{}]", f.value.items.size());
      else if (f.has_key)
        p += (p.empty() ? "" : ".") + f.key;
    }
    return p;
  }

  void count_nodes(long n, int line) {
    nodes_ += n;
    if (nodes_ + kept_ > kMostNodes)
      model::fail(file_, line, path(), "has too many entries, or aliases of them: more than {:g}",
                  static_cast<double>(kMostNodes));
  }

  void open(Value::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (stack_.size() >= kDeepest) model::fail(file_, line_of(mark), path(), "is nested too deeply");
    if (expects_key()) no_key(line_of(mark));
    Frame f;
    f.value.kind = kind;
    f.value.line = line_of(mark);
    f.anchor = anchor;
    f.nodes_before = nodes_;
    count_nodes(1, f.value.line);
    stack_.push_back(std::move(f));
  }

  void close() {
    Frame f = std::move(stack_.back());
    stack_.pop_back();
    f.value.items.shrink_to_fit();
    f.value.keys.shrink_to_fit();
    if (f.anchor) {
      const long nodes = nodes_ - f.nodes_before;
      kept_ += nodes;  // each anchor that contains others keeps a copy of them
      count_nodes(0, f.value.line);
      anchors_[f.anchor] = {f.value, nodes};
    }
    add(std::move(f.value));
  }

  void leaf(Value v, const YAML::Mark& mark, YAML::anchor_t anchor, long nodes) {
    v.line = line_of(mark);
    count_nodes(nodes, v.line);
    if (anchor) anchors_[anchor] = {v, 1};
    add(std::move(v));
  }

  bool expects_key() const {
    return !stack_.empty() && stack_.back().value.kind == Value::Kind::map && !stack_.back().has_key;
  }
  [[noreturn]] void no_key(int line) const {
    model::fail(file_, line, path(), "has an entry whose key is no plain word");
  }

  void add(Value v) {
    if (stack_.empty()) {
      root_ = std::move(v);
      return;
    }
    Frame& f = stack_.back();
    if (f.value.kind == Value::Kind::list) {
      f.value.items.push_back(std::move(v));
    } else if (!f.has_key) {
      if (v.kind != Value::Kind::scalar) no_key(v.line);
      f.key = v.text;
      f.key_line = v.line;
      f.has_key = true;
      const auto [first, is_new] = f.key_lines.emplace(f.key, f.key_line);
      if (!is_new) model::fail(file_, f.key_line, path(), "is given twice (first in line {})", first->second);
    } else {
      v.line = f.key_line;
      const std::string& names = stack_.front().key;
      if (stack_.size() == 2 && (names == "lines" || names == "bodies") && v.kind == Value::Kind::map)
        model::pack(v);
      f.value.keys.push_back(std::move(f.key));
      f.value.items.push_back(std::move(v));
      f.has_key = false;
    }
  }

  const std::string& file_;
  Value root_;
  std::vector<Frame> stack_;
  std::map<YAML::anchor_t, Anchor> anchors_;
  long nodes_ = 0, kept_ = 0;
};

// Rejects a document at its first event.
class NoDocument final : public YAML::EventHandler {
 public:
  explicit NoDocument(const std::string& file) : file_(file) {}
  void OnDocumentStart(const YAML::Mark& mark) override {
    model::fail(file_, line_of(mark), "",
                "a second YAML document begins here; a case file holds one (is this line indented less than "
                "the first?)");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
  }
  void OnMapEnd() override {}

 private:
  const std::string& file_;
};

// The parser reads up to the closing bracket before it reports the opening one, and keeps all it reads.
// Brackets in quotes and comments count as well; valid files do not leave so many open there.
void refuse_deep_brackets(const std::string& text, const std::string& file) {
  std::size_t open = 0;
  int line = 1;
  for (const char c : text) {
    line += c == '\n';
    if ((c == ']' || c == '}') && open > 0) --open;
    if ((c == '[' || c == '{') && ++open > kDeepest)
      model::fail(file, line, "", "is nested too deeply: more than {} brackets are open here", kDeepest);
  }
}

// Translates messages of the parser into the user's terms.
std::string in_words(const std::string& message) {
  static constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"illegal map value",
       "a colon stands where no key can be; text that holds a colon and a blank needs quotes ('Case 3: a "
       "line')"},
      {"end of map flow not found", "a comma or a closing } is missing before this place"},
      {"end of sequence flow not found", "a comma or a closing ] is missing before this place"},
      {"end of map not found",
       "this does not go on what stands before it; is a colon, a comma or a quote missing?"},
      {"end of sequence not found",
       "the entries of this list begin with '- ' in one column, but this does not"},
      {"illegal flow end", "a bracket closes none that is open"},
      {"unknown token", "no value begins with this character; put text that does in quotes"},
      {"the referenced anchor is not defined",
       "'*' begins the name of an anchor, and there is none of this name; put text that begins so in quotes"},
      {"bad character found while scanning hex number",
       "a backslash within double quotes begins a special character; use single quotes, or / in paths"},
      {"unknown escape character",
       "a backslash within double quotes begins a special character; use single quotes, or / in paths"}};
  for (const auto& [library_text, text] : kWords)
    if (message.starts_with(library_text)) return std::string(text);
  return message.empty() ? "the text breaks off" : message;
}

}  // namespace

model::Value parse_yaml(const std::string& text, const std::string& file) {
  if (text.find('\0') != std::string::npos) model::fail(file, 1, "", "is no text file: it holds zero bytes");
  refuse_deep_brackets(text, file);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    TreeBuilder tree(file);
    if (!parser.HandleNextDocument(tree)) model::fail(file, 1, "", "the file is empty");
    NoDocument second(file);
    parser.HandleNextDocument(second);
    if (const auto fault = find_open_quote(text)) model::fail(file, fault->line, "", fault->text);
    return tree.take();
  } catch (const YAML::Exception& e) {
    const int line = e.mark.line < 0 ? 1 : e.mark.line + 1;
    if (const auto fault = find_yaml_fault(text, line)) model::fail(file, fault->line, "", fault->text);
    model::fail(file, line, "", "this is not valid YAML at column {}: {}", std::max(e.mark.column, 0) + 1,
                in_words(e.msg));
  }
}

}  // namespace hawser::io

// The checked tree of a case file into model::Case. Form, units, references and defaults are the
// schema's; here are names for numbers, and what takes the knowledge of whether a key was given.
#include "hawser/io/case_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/io/case_changes.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/io/input_file.hpp"
#include "hawser/io/yaml_document.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/cut_lines.hpp"
#include "hawser/model/doubts.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {
namespace {

using model::Case;
using model::Value;
namespace fs = std::filesystem;

void read_all(const Value& root, const CaseSource& source, const SectionLengths& lengths, Case& c) {
  const auto each = [&root](const char* key, auto&& read) {
    const Value& v = root[key];
    for (std::size_t i = 0; i < v.items.size(); ++i) read(v.keys[i], v.items[i]);
  };
  c.title = root["title"].text;
  c.environment = read_environment(root["environment"], source, c.notes);
  each("line_types", [&](const std::string& name, const Value& v) {
    const model::LineType& t = c.line_types.emplace_back(read_line_type(name, v, source, c.environment));
    if (t.kind == model::LineKind::cable && t.minimum_bend_radius > 0)
      c.notes.push_back(
          "line_types." + name +
          ".minimum_bend_radius: a type with 'bending: false' has no curvature to compare it with");
  });
  const Value* time = root.find("dynamics");
  const double duration = time ? (*time)["duration"].number : 0;
  each("bodies", [&](const std::string& name, const Value& v) {
    c.bodies.push_back(read_body(name, v, source, duration, c));
  });
  each("volumes",
       [&](const std::string& name, const Value& v) { c.volumes.push_back(read_volume(name, v, source)); });
  each("joints", [&](const std::string& name, const Value& v) {
    c.joints.push_back({name, vec(v, "start"), v["rigid"].number != 0});
  });
  OtherRuns others(source);
  each("lines", [&](const std::string& name, const Value& v) {
    c.lines.push_back(read_line(name, v, source, root.find("start"), lengths, others, c));
  });
  for (model::Body& b : c.bodies)
    if (b.on)
      b.on->at = arc((*root.find("bodies"))[b.name]["on"].find("at"), 0,
                     model::length_of(c.lines[static_cast<std::size_t>(c.line_index(b.on->line))]));
  each("links",
       [&](const std::string& name, const Value& v) { c.links.push_back(read_link(name, v, source, c)); });
  read_supports(root["supports"], source, c);
  read_contact(root["contact"], source, c.contact);
  read_statics(root["statics"], c.statics);
  for (const Value& v : root["stages"].items) c.stages.push_back(v.text);
  if (time) c.dynamics = read_dynamics(*time);
  const std::vector<Value>& events = root["events"].items;
  for (std::size_t i = 0; i < events.size(); ++i)
    c.events.push_back(read_event(events[i], fmt::format("events[{}]", i), source, c));
  read_output(root["output"], source, c);
}

// What can only be judged when all of it is read.
void examine(Case& c) {
  for (const model::Issue& i : model::check(c)) c.refuse(i.key, i.text);
  check_bed(c);
  for (std::string& n : model::doubt_notes(c)) c.notes.push_back(std::move(n));
}

Case read_document(const std::string& text, const std::string& path, const ReadingNews& news, MPI_Comm comm,
                   const CaseChanges& changes) {
  Case c;
  c.text = text, c.file = path, c.changes = changes;
  c.path = fs::absolute(path).lexically_normal().string();
  c.directory = fs::path(c.path).parent_path().string();
  const auto tree = std::make_shared<Value>(parse_yaml(text, path));
  const Value& root = *tree;
  c.change_notes = change_document(*tree, changes, path);
  model::check_structure(*tree, model::case_schema(), path);
  if (const Value* title = root.find("title"); news.title)
    news.title(title && !title->text.empty() ? title->text : c.path);
  const CaseSource source{path, c.directory, comm};
  read_all(root, source, {}, c);
  c.tree = tree;
  examine(c);
  return model::with_cuts(std::move(c));
}

}  // namespace

model::Case with_lengths(const Case& c, const SectionLengths& lengths, MPI_Comm comm) {
  Case out;
  out.text = c.text, out.file = c.file, out.path = c.path, out.directory = c.directory;
  out.tree = c.tree, out.changes = c.changes, out.change_notes = c.change_notes;
  const CaseSource source{c.file, c.directory, comm};
  read_all(*c.tree, source, lengths, out);
  examine(out);
  return model::with_cuts(std::move(out));
}

model::Case read_case_text(const std::string& text, const std::string& path, const ReadingNews& news,
                           MPI_Comm comm, const CaseChanges& changes) {
  try {
    return read_document(text, path, news, comm, changes);
  } catch (const InputError& e) {
    // What is wrong may be in another line of the file than what was changed.
    const std::string why = e.what();
    if (changes.empty() || why.find("--set") != std::string::npos) throw;
    throw InputError(fmt::format("{} (the case is changed by --set {})", why, fmt::join(changes, " --set ")));
  }
}

model::Case read_case(const std::string& path, const ReadingNews& news, MPI_Comm comm,
                      const CaseChanges& changes) {
  if (const std::string why = unreadable(path, "case", kMostCase); !why.empty())
    model::fail(path, 0, "", why);
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) {
    if (in && fs::file_size(path, error) == 0 && !error) model::fail(path, 1, "", "the file is empty");
    model::fail(path, 0, "", "cannot be read");
  }
  return read_case_text(text.str(), path, news, comm, changes);
}

}  // namespace hawser::io

// The checked tree of a case file into model::Case. Form, units, references and defaults are the
// schema's; here are names for numbers, and what takes the knowledge of whether a key was given.
#include "hawser/io/case_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_changes.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/io/input_file.hpp"
#include "hawser/io/yaml_document.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/cut_lines.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {
namespace {

using model::Case;
using model::Value;
namespace fs = std::filesystem;

// First what the schema binds to fields, then by hand what is more than copying: files, what depends on other
// parts of the case, and what is made of several keys.
void read_all(const Value& root, const CaseSource& source, const SectionLengths& lengths, Case& c) try {
  model::take(root, c);
  const auto each = [&root](const char* key, auto&& read) {
    const Value& v = root[key];
    for (std::size_t i = 0; i < v.items.size(); ++i) read(v.keys[i], v.items[i]);
  };
  finish_environment(root["environment"], source, c.environment, c.notes);
  each("line_types", [&](const std::string& name, const Value& v) {
    const model::LineType& t = c.line_types.emplace_back(read_line_type(name, v, c.environment));
    if (t.kind == model::LineKind::cable && t.minimum_bend_radius > 0)
      c.notes.push_back(
          "line_types." + name +
          ".minimum_bend_radius: a type with 'bending: false' has no curvature to compare it with");
  });
  for (std::size_t i = 0; i < c.bodies.size(); ++i)
    finish_body(root["bodies"].items[i], source, c.bodies[i], c);
  for (std::size_t i = 0; i < c.volumes.size(); ++i)
    finish_volume(root["volumes"].items[i], source, c.volumes[i]);
  OtherRuns others(source);
  for (std::size_t i = 0; i < c.lines.size(); ++i)
    finish_line(root["lines"].items[i], root.find("start"), lengths, others, c, c.lines[i]);
  for (model::Body& b : c.bodies)
    if (b.on) to_length(b.on->at, length_of(c, b.on->line));
  for (std::size_t i = 0; i < c.links.size(); ++i) finish_link(root["links"].items[i], c.links[i], c);
  read_supports(root["supports"], c);
  finish_contact(root["contact"], c.contact);
  for (std::size_t i = 0; i < c.events.size(); ++i) finish_event(root["events"].items[i], c.events[i], c);
  finish_output(root["output"], source, c);
} catch (const model::Refusal& r) {
  model::fail(source.file, r.line, r.where, r.what());
}

// What can only be judged when all of it is read.
void examine(Case& c) {
  for (const model::Issue& i : model::check(c)) c.refuse(i.key, i.text);
  check_bed(c);
  // What can change all results first, then what the reader has noted, then the rest.
  using advice::Effect;
  std::vector<std::string> notes = advice::input_notes(c, Effect::all, Effect::all);
  notes.insert(notes.end(), c.notes.begin(), c.notes.end());
  c.notes = std::move(notes);
  for (std::string& n : advice::input_notes(c, Effect::part)) c.notes.push_back(std::move(n));
}

Case read_document(const std::string& text, const std::string& path, const ReadProgress& read_progress,
                   MPI_Comm comm, const CaseChanges& changes) {
  Case c;
  c.text = text;
  c.file = path;
  c.changes = changes;
  c.path = fs::absolute(path).lexically_normal().string();
  c.directory = fs::path(c.path).parent_path().string();
  const auto tree = std::make_shared<Value>(parse_yaml(text, path));
  const Value& root = *tree;
  c.change_notes = change_document(*tree, changes, path);
  model::check_structure(*tree, model::case_schema(), path);
  if (const Value* title = root.find("title"); read_progress.title)
    read_progress.title(title && !title->text.empty() ? title->text : c.path);
  c.inputs = {c.path};
  const CaseSource source{path, c.directory, comm, &c.inputs};
  read_all(root, source, {}, c);
  c.tree = tree;
  examine(c);
  return model::with_cuts(std::move(c));
}

}  // namespace

model::Case with_lengths(const Case& c, const SectionLengths& lengths, MPI_Comm comm) {
  Case out;
  out.text = c.text;
  out.file = c.file;
  out.path = c.path;
  out.directory = c.directory;
  out.tree = c.tree;
  out.changes = c.changes;
  out.change_notes = c.change_notes;
  out.inputs = {c.path};
  const CaseSource source{c.file, c.directory, comm, &out.inputs};
  read_all(*c.tree, source, lengths, out);
  examine(out);
  return model::with_cuts(std::move(out));
}

model::Case read_case_text(const std::string& text, const std::string& path,
                           const ReadProgress& read_progress, MPI_Comm comm, const CaseChanges& changes) {
  try {
    return read_document(text, path, read_progress, comm, changes);
  } catch (const InputError& e) {
    // What is wrong may be in another line of the file than what was changed.
    const std::string why = e.what();
    if (changes.empty() || why.find("--set") != std::string::npos) throw;
    throw InputError("{} (the case is changed by --set {})", why, fmt::join(changes, " --set "));
  }
}

model::Case read_case(const std::string& path, const ReadProgress& read_progress, MPI_Comm comm,
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
  return read_case_text(text.str(), path, read_progress, comm, changes);
}

}  // namespace hawser::io

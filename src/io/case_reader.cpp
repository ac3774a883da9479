// Conversion of the checked tree of a case file to model::Case. Form, units, references and defaults belong
// to the schema; this file resolves names and handles keys whose presence matters.
#include "hawser/io/case_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "hawser/advice/cut_lines.hpp"
#include "hawser/advice/input_warnings.hpp"
#include "hawser/advice/limits.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_changes.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/io/input_file.hpp"
#include "hawser/io/yaml_document.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/cut_lines.hpp"
#include "hawser/model/packed_value.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {
namespace {

using model::Case;
using model::Value;
namespace fs = std::filesystem;

// First copies the keys that the schema binds to fields, except those of bodies and lines, then handles
// files, dependencies on other parts of the case, and values made from several keys.
void read_all(const Value& root, const CaseSource& source, const SectionLengths& lengths, Case& c) try {
  model::take(root, c);
  finish_environment(root["environment"], source, c.environment, c.notes);
  read_objects(root, root.find("start"), source, lengths, true, c);
  finish_contact(root["contact"], c.contact);
  for (std::size_t i = 0; i < c.events.size(); ++i) finish_event(root["events"].items[i], c.events[i], c);
  finish_output(root["output"], source, c);
} catch (const model::Refusal& r) {
  model::fail(source.file, r.line, r.where, r.what());
}

// Checks that need the complete case.
void examine(Case& c) {
  for (const model::Issue& i : model::check(c)) c.refuse(i.key, i.text);
  check_bed(c);
  // Order: notes on faults that can change all results, then the reader's notes, then the rest.
  using advice::Effect;
  std::vector<std::string> notes = advice::input_notes(c, Effect::all, Effect::all);
  notes.insert(notes.end(), c.notes.begin(), c.notes.end());
  for (std::string& n : advice::input_notes(c, Effect::part)) notes.push_back(std::move(n));
  c.notes = model::notes_by_place(c, std::move(notes));
}

// Reads the tree of a document. Collective.
Case read_tree(model::CaseDocument document, const SectionLengths& lengths, MPI_Comm comm) {
  Case c(std::move(document));
  read_all(*c.tree, {c.file, c.directory, comm, &c.inputs}, lengths, c);
  examine(c);
  c = model::with_cuts(std::move(c));
  for (std::string& note : advice::parts_of_cut_lines(c)) c.notes.push_back(std::move(note));
  return c;
}

Case read_document(std::string text, const std::string& path, const ReadProgress& read_progress,
                   MPI_Comm comm, const CaseChanges& changes) {
  model::CaseDocument c;
  c.file = path;
  c.changes = changes;
  c.path = fs::absolute(path).lexically_normal().string();
  c.directory = fs::path(c.path).parent_path().string();
  const auto tree = std::make_shared<Value>(parse_yaml(text, path));
  const Value& root = *tree;
  // Rank 0 writes it to the results; on the others its memory is free before the case is built.
  if (rank_of(comm) == 0) c.text = std::move(text);
  std::string().swap(text);
  c.inputs = {c.path};
  const CaseSource source{path, c.directory, comm, &c.inputs};
  CaseChanges changes_of_case;
  std::copy_if(changes.begin(), changes.end(), std::back_inserter(changes_of_case),
               [](const std::string& change) { return !changes_platform(change); });
  c.change_notes = change_document(*tree, changes_of_case, path);
  c.farm = read_farm(root, source, changes, c.change_notes);
  model::check_structure(*tree, model::case_schema(), path, c.farm ? names_of(*c.farm) : model::MoreNames());
  if (const Value* title = root.find("title"); read_progress.title)
    read_progress.title(title && !title->text.empty() ? title->text : c.path);
  c.tree = tree;
  return read_tree(std::move(c), {}, comm);
}

}  // namespace

// Platforms come first because objects of the file itself may be attached to them. Entries of bodies and
// lines are unpacked once here, for the keys that the schema binds to fields and for the others.
void read_objects(const Value& root, const Value* start_of_case, const CaseSource& source,
                  const SectionLengths& lengths, bool sea, Case& c) {
  const Value& bodies = root["bodies"];
  const Value& lines = root["lines"];
  c.bodies.reserve(bodies.keys.size());
  for (const std::string& name : bodies.keys) c.bodies.emplace_back().name = name;
  c.lines.reserve(lines.keys.size());
  for (const std::string& name : lines.keys) c.lines.emplace_back().name = name;
  const std::size_t volumes = c.volumes.size();
  const std::size_t links = c.links.size();
  const Value& types = root["line_types"];
  for (std::size_t i = 0; i < types.items.size(); ++i) {
    const auto same = [&](const model::LineType& t) { return t.name == types.keys[i]; };
    if (std::any_of(c.line_types.begin(), c.line_types.end(), same)) continue;  // also in the farm's file
    const model::LineType& t =
        c.line_types.emplace_back(read_line_type(types.keys[i], types.items[i], c.environment));
    if (t.kind == model::LineKind::cable && t.minimum_bend_radius > 0)
      c.notes.push_back(advice::bend_radius_without_bending(t.name));
  }
  place_platforms(root, source, lengths, c);
  for (std::size_t i = 0; i < bodies.keys.size(); ++i) {
    const model::Entry v(bodies, i);
    model::take(*v, c.bodies[i]);
    finish_body(*v, source, c.bodies[i], c);
    if (sea) finish_body_in_sea(*v, source, c.bodies[i], c);
  }
  for (std::size_t i = 0; i < volumes; ++i) finish_volume(root["volumes"].items[i], source, c.volumes[i]);
  OtherRuns others(source);
  for (std::size_t i = 0; i < lines.keys.size(); ++i) {
    const model::Entry v(lines, i);
    model::take(*v, c.lines[i]);
    finish_line(*v, start_of_case, lengths, others, c, c.lines[i]);
  }
  for (std::size_t i = 0; i < bodies.keys.size(); ++i)
    if (model::Body& b = c.bodies[i]; b.ride) to_length(b.ride->at, length_of(c, b.ride->line));
  for (std::size_t i = 0; i < links; ++i) finish_link(root["links"].items[i], c.links[i], c);
  read_supports(root["supports"], c);
}

namespace {
constexpr const char* kEmpty = "the file is empty";
}

CaseText case_text(const std::string& path) {
  if (std::string why = unreadable(path, "case", kMostCase); !why.empty()) return {"", std::move(why)};
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in && (text << in.rdbuf())) return {text.str(), ""};
  return {"", in && fs::file_size(path, error) == 0 && !error ? kEmpty : "cannot be read"};
}

model::Case with_lengths(const Case& c, const SectionLengths& lengths, MPI_Comm comm) {
  return read_tree(c, lengths, comm);
}

model::Case read_case_text(std::string text, const std::string& path, const ReadProgress& read_progress,
                           MPI_Comm comm, const CaseChanges& changes) {
  try {
    return read_document(std::move(text), path, read_progress, comm, changes);
  } catch (const InputError& e) {
    // The fault may be on another line than the change.
    const std::string why = e.what();
    if (changes.empty() || why.find("--set") != std::string::npos) throw;
    throw InputError("{} (the case is changed by --set {})", why, fmt::join(changes, " --set "));
  }
}

model::Case read_case(const std::string& path, const ReadProgress& read_progress, MPI_Comm comm,
                      const CaseChanges& changes) {
  auto [text, fault] = case_text(path);
  if (!fault.empty()) model::fail(path, fault == kEmpty ? 1 : 0, "", fault);
  return read_case_text(std::move(text), path, read_progress, comm, changes);
}

}  // namespace hawser::io

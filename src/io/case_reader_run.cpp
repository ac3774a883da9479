// `statics`, `dynamics` and `output`: what is computed of a case, and what is kept of it.
#include <algorithm>
#include <filesystem>

#include "hawser/io/case_values.hpp"
#include "hawser/io/old_results.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/nearest.hpp"

namespace hawser::io {

using model::Value;
namespace fs = std::filesystem;

void read_statics(const Value& v, model::Statics& to) {
  if (v.kind != Value::Kind::map) {
    to.enabled = v.number != 0;
    return;
  }
  to.enabled = v["enabled"].number != 0;
  to.tolerance = v["tolerance"].number;
  to.max_iterations = static_cast<int>(v["max_iterations"].number);
  const Value& relaxation = v["dynamic_relaxation"];
  to.relaxation = relaxation.is("always")  ? model::Relaxation::always
                  : relaxation.is("never") ? model::Relaxation::never
                                           : model::Relaxation::automatic;
  to.relaxation_steps = static_cast<int>(v["relaxation_steps"].number);
  to.contact_friction = v["contact_friction"].number != 0;
}

model::Dynamics read_dynamics(const Value& v) {
  model::Dynamics d;
  d.enabled = true;
  d.duration = v["duration"].number;
  d.step = v["step"].number;  // 0 for 'auto'
  d.max_step = number(v, "max_step");
  d.min_step = number(v, "min_step");
  d.resolve_impacts = v["resolve_impacts"].number != 0;
  d.rho_infinity = v["rho_infinity"].number;
  d.tolerance = v["tolerance"].number;
  d.error_tolerance = number(v, "error_tolerance");
  return d;
}

void read_output(const Value& v, const CaseSource& source, model::Case& c) {
  model::Output& o = c.output;
  o.file = v.has("file") ? source.absolute(v["file"].text)
                         : (fs::path(c.directory) / fs::path(c.path).stem()).string() + ".h5";
  const std::string extension = fs::path(o.file).extension().string();
  if (extension != ".h5")  // nor can a case or a mesh be overwritten
    source.bad(v["file"], "output.file", "must end in .h5, found " + model::quote(v["file"].text));
  o.every = number(v, "every");
  o.checkpoint_every = number(v, "checkpoint_every");
  o.history_every = number(v, "history_every");
  o.single_precision = v["single_precision"].number != 0;
  o.touchdowns = v["touchdowns"].number != 0;
  o.statistics = v["statistics"].number != 0;
  o.statistics_from = v["statistics_from"].number;
  // What is there is kept under another name, in place of what had that.
  for (const model::Line& l : c.lines)
    for (const std::string& replaced : {o.file, kept_name(o.file)})
      if (std::error_code same; l.left && fs::equivalent(l.left->file, replaced, same))
        source.bad(v.has("file") ? v["file"] : v, "output.file",
                   replaced + " is the run that line '" + l.name +
                       "' starts from, and would be overwritten; give another 'file'");
  const std::vector<Value>& formats = v["format"].items;
  const auto lists = [&](const char* w) {
    return std::any_of(formats.begin(), formats.end(), [&](const Value& f) { return f.is(w); });
  };
  o.xdmf = lists("xdmf");
  if (!lists("hdf5"))
    source.bad(v["format"], "output.format",
               "xdmf only describes the numbers of an hdf5 file; list hdf5 as well");
  for (const Value& h : v["histories"].items) {
    model::HistoryPoint p;
    if (h.has("body")) {
      p.body = h["body"].text;
      p.name = h.has("name") ? h["name"].text : p.body;
      o.histories.push_back(p);
      continue;
    }
    p.line = h["line"].text;
    p.at = arc(h.find("at"), 0, model::length_of(c.lines[static_cast<std::size_t>(c.line_index(p.line))]));
    p.name = h.has("name") ? h["name"].text : p.line + "@" + h["at"].text;
    o.histories.push_back(p);
  }
  for (const Value& w : v["clearances"].items) {
    model::Clearance k;
    k.line = w["line"].text;
    if (w.has("other_line")) k.other_line = w["other_line"].text;
    if (w.has("volume")) k.volume = w["volume"].text;
    k.name = w.has("name") ? w["name"].text : k.line + " to " + k.other_line + k.volume;
    o.clearances.push_back(k);
  }
  o.clashes = read_clash_output(v["clashes"]);
}

}  // namespace hawser::io

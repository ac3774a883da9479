// The checked tree of a case file into model::Case. Form, units, references and defaults are the
// schema's; here are names for numbers, and what takes the knowledge of whether a key was given.
#include "hawser/io/case_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/io/case_changes.hpp"
#include "hawser/io/case_reader_parts.hpp"
#include "hawser/io/input_file.hpp"
#include "hawser/io/old_results.hpp"
#include "hawser/io/yaml_document.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/doubts.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {
namespace {

using model::Case;
using model::Value;
using Kind = Value::Kind;
namespace fs = std::filesystem;

class Reader {
 public:
  Reader(const Value& root, const CaseSource& source, Case& c, const SectionLengths& lengths = {})
      : root_(root), source_(source), c_(c), lengths_(lengths) {}

  void read() {
    c_.title = root_["title"].text;
    c_.environment = read_environment(root_["environment"], source_, c_.notes);
    each("line_types", [&](const std::string& name, const Value& v) {
      const model::LineType& t = c_.line_types.emplace_back(read_line_type(name, v, source_, c_.environment));
      if (t.kind == model::LineKind::cable && t.minimum_bend_radius > 0)
        c_.notes.push_back(
            "line_types." + name +
            ".minimum_bend_radius: a type with 'bending: false' has no curvature to compare it with");
    });
    each("bodies", [&](const std::string& name, const Value& v) { c_.bodies.push_back(body(name, v)); });
    each("volumes", [&](const std::string& name, const Value& v) { c_.volumes.push_back(volume(name, v)); });
    each("joints", [&](const std::string& name, const Value& v) {
      c_.joints.push_back({name, vec(v, "start"), v["rigid"].number != 0});
    });
    each("lines", [&](const std::string& name, const Value& v) { c_.lines.push_back(line(name, v)); });
    read_supports(root_["supports"], source_, c_);
    for (model::Body& b : c_.bodies)
      if (b.on)
        b.on->at = arc((*root_.find("bodies"))[b.name]["on"].find("at"), 0,
                       model::length_of(c_.lines[static_cast<std::size_t>(c_.line_index(b.on->line))]));
    contact(root_["contact"]);
    statics(root_["statics"]);
    if (const Value* d = root_.find("dynamics")) dynamics(*d);
    output(root_["output"]);
  }

 private:
  template <class F>
  void each(const std::string& key, F&& f) {
    const Value& v = root_[key];
    for (std::size_t i = 0; i < v.items.size(); ++i) f(v.keys[i], v.items[i]);
  }

  static double number(const Value& v, const char* key, double otherwise = 0) {
    const Value* x = v.find(key);
    return x ? x->number : otherwise;
  }
  static Vec3 vec(const Value& v, const char* key) {
    const Value* x = v.find(key);
    return x ? as_vec3(*x) : Vec3(Vec3::Zero());
  }
  Vec3 unit_vec(const Value& v, const char* key, const std::string& path) const {
    return read_direction(v, key, path, source_);
  }

  static model::HarmonicMotion harmonic(const Value& h) {
    return {vec(h, "amplitude"), vec(h, "rotation_amplitude_deg"), h["period"].number, vec(h, "phase_deg"),
            vec(h, "rotation_phase_deg")};
  }

  model::Drift drift(const Value& v, const std::string& path) const {
    model::Drift d;
    d.offset = vec(v, "offset"), d.rotation = vec(v, "rotation_deg");
    if (const Value* h = v.find("harmonic")) d.harmonic = harmonic(*h);
    if (const Value* t = v.find("table")) d.table = read_motion_table(*t, path + ".table", source_, c_.notes);
    d.ramp = v["ramp"].number;
    return d;
  }

  model::Body body(const std::string& name, const Value& v) const {
    model::Body b;
    b.name = name;
    b.position = vec(v, "position");
    b.rotation = vec(v, "rotation_deg");
    if (const Value* f = v.find("floating")) {
      model::BodyMass& o = b.mass.emplace();
      o.mass = (*f)["mass"].number, o.weight = (*f)["weight"].number != 0;
      o.inertia = vec(*f, "inertia"), o.products = vec(*f, "products_of_inertia");
      o.centre = vec(*f, "centre_of_mass");
      o.velocity = vec(*f, "velocity"), o.angular_velocity = vec(*f, "angular_velocity");
      o.stiffness = vec(*f, "stiffness"), o.damping = vec(*f, "damping");
      o.turning_stiffness = vec(*f, "turning_stiffness"), o.turning_damping = vec(*f, "turning_damping");
    }
    if (const Value* on = v.find("on")) b.on = model::Ride{(*on)["line"].text, 0};
    const Value* m = v.find("motion");
    if (!m) return b;
    const std::string path = "bodies." + name + ".motion";
    b.ramp = number(*m, "ramp");
    if (const Value* d = m->find("drift")) b.drift = drift(*d, path + ".drift");
    if (const Value* h = m->find("harmonic")) {
      b.motion = harmonic(*h);
    } else if (const Value* t = m->find("table")) {
      b.motion = read_motion_table(*t, path + ".table", source_, c_.notes);
    } else if (const Value* rao = m->find("rao")) {
      const Value* d = root_.find("dynamics");
      b.motion = read_rao(*rao, path + ".rao", c_.environment, b, d ? (*d)["duration"].number : 0, source_,
                          c_.notes);
      if (!(*m)["ramp"].given) b.ramp = c_.environment.water.waves.ramp;
    } else if (m->has("velocity") || m->has("rotation")) {
      model::ConstantMotion steady;
      steady.velocity = vec(*m, "velocity");
      if (const Value* r = m->find("rotation")) {
        steady.axis = unit_vec(*r, "axis", path + ".rotation");
        steady.rate = (*r)["rate"].number;
      }
      b.motion = steady;
    }
    return b;
  }

  model::Volume volume(const std::string& name, const Value& v) const {
    model::Volume o;
    o.name = name;
    if (const Value* shape = v.find("shape")) {
      o.shape = read_shape(*shape, "volumes." + name + ".shape", source_);
    } else {
      o.mesh = source_.absolute(v["mesh"].text);
      o.scale = v["scale"].number;
      o.closed = v["closed"].text == "required";
      o.sign = read_sign(v["sign"].text);
      o.smooth = v["smooth"].number != 0 &&
                 (o.sign == model::SignTest::automatic || o.sign == model::SignTest::pseudonormal);
      if (!o.smooth && v["smooth"].number != 0 && v["smooth"].given)
        source_.bad(v["smooth"], "volumes." + name + ".smooth",
                    "with 'sign: " + v["sign"].text + "' facets are flat; say 'smooth: false' or nothing");
      o.crease_angle = v["crease_angle_deg"].number;
    }
    if (v.has("body")) o.body = v["body"].text;
    if (const Value* a = v.find("active")) {
      if (a->kind == Kind::map) {
        const Value& box = (*a)["box"];
        o.active_box = model::Box{as_vec3(box.items[0]), as_vec3(box.items[1])};
      } else {
        o.active_part = a->text;
      }
    }
    const Value& k = v["normal_stiffness"];
    const auto basis = [&](const char* key, model::StiffnessBasis b) {
      if (const Value* x = k.find(key)) o.basis = b, o.normal_stiffness = x->number;
    };
    basis("per_point", model::StiffnessBasis::per_point);
    basis("per_length", model::StiffnessBasis::per_length);
    basis("per_area", model::StiffnessBasis::per_area);
    const std::string key = "volumes." + name;
    o.allowed_penetration = number(k, "allowed_penetration");
    if (k.has("table")) {
      o.force_table = read_force_table(k["table"], key + ".normal_stiffness.table", source_);
      o.normal_stiffness = o.force_table->largest_slope();
      o.basis = k["per"].is("point")    ? model::StiffnessBasis::per_point
                : k["per"].is("length") ? model::StiffnessBasis::per_length
                                        : model::StiffnessBasis::per_area;
      if (v.has("smoothing"))
        source_.bad(v["smoothing"], key + ".smoothing",
                    "a force table defines the whole law, so there is nothing to smooth");
    }
    o.smoothing = number(v, "smoothing", -1);
    o.relative_damping = v["relative_damping"].number;
    const Value& f = v["friction"];
    if (f.kind == Kind::map) {
      o.friction = read_friction(f, key + ".friction", source_);
    } else {
      o.friction.axial = o.friction.lateral = f.number;
    }
    return o;
  }

  model::End end(const Value& v, const std::string& path) const {
    model::End e;
    if (v.kind != Kind::map) return e;
    e.kind = v.has("anchor")  ? model::EndKind::anchor
             : v.has("joint") ? model::EndKind::joint
                              : model::EndKind::body;
    e.at = vec(v, v.has("anchor") ? "anchor" : "at");
    if (v.has("body")) e.body = v["body"].text;
    if (v.has("joint")) e.body = v["joint"].text, e.at = c_.joint(e.body).start;
    if (v.has("direction")) e.direction = unit_vec(v, "direction", path);
    e.clamped = v["clamped"].number != 0;
    e.rotational_stiffness = number(v, "rotational_stiffness");
    if (v.has("no_contact_within")) e.no_contact_within = v["no_contact_within"].number;
    return e;
  }

  static double arc(const Value* v, double otherwise, double length) {
    if (!v) return otherwise;
    if (v->is("end_a")) return 0;
    if (v->is("end_b")) return length;
    return v->number;
  }

  model::Line line(const std::string& name, const Value& v) {
    const std::string path = "lines." + name;
    model::Line l;
    l.name = name;
    for (std::size_t i = 0; i < v["sections"].items.size(); ++i)
      l.sections.push_back(section(v["sections"].items[i], fmt::format("{}.sections[{}]", path, i)));
    const double length = model::length_of(l);
    l.end_a = end(v["end_a"], path + ".end_a");
    l.end_b = end(v["end_b"], path + ".end_b");
    const Value& start = v["start"];
    if (const Value* other = root_.find("start"); other && !start.given) {
      l.left = others_.shape(*other, "start", name, false);
      if (l.left) {
        l.start = model::Start::other_run;
        check_left_shape(l, (*other)["from"], path, source_, c_.notes);
      } else {
        c_.notes.push_back(path + ": is not in " + (*other)["from"].text + ", and starts by itself");
      }
    } else if (start.kind == Kind::map && start.has("from")) {
      l.start = model::Start::other_run;
      l.left = others_.shape(start, path + ".start", start.has("line") ? start["line"].text : name, true);
      check_left_shape(l, start["from"], path + ".start", source_, c_.notes);
    } else if (start.kind == Kind::map) {
      l.start = model::Start::points;
      for (const Value& p : start["points"].items) l.points.push_back(as_vec3(p));
    } else {
      l.start = start.is("catenary")   ? model::Start::catenary
                : start.is("hanging")  ? model::Start::hanging
                : start.is("straight") ? model::Start::straight
                                       : model::Start::automatic;
    }
    for (std::size_t i = 0; i < v["buried"].items.size(); ++i)
      l.buried.push_back(buried(v["buried"].items[i], length, l));
    if (const Value* t = v.find("target"))
      l.target = read_target(*t, path + ".target", v["sections"], source_);
    read_temperature_change(v["temperature_change"], path + ".temperature_change", source_, l);
    for (const Value& m : v["masses"].items)
      l.masses.push_back({arc(m.find("at"), 0, length), m["mass"].number, m["volume"].number,
                          m["drag_area"].number, m["Ca"].number});
    const std::vector<Value>& stiffeners = v["bend_stiffeners"].items;
    for (std::size_t i = 0; i < stiffeners.size(); ++i)
      read_bend_stiffener(stiffeners[i], fmt::format("{}.bend_stiffeners[{}]", path, i),
                          arc(stiffeners[i].find("at"), 0, length), length, source_, l);
    for (std::size_t i = 0; i < v["loads"].items.size(); ++i)
      load(v["loads"].items[i], fmt::format("{}.loads[{}]", path, i), static_cast<int>(i), length, l);
    return l;
  }

  model::Buried buried(const Value& v, double length, const model::Line& l) const {
    model::Buried b;
    b.from = arc(v.find("from"), 0, length), b.to = arc(v.find("to"), length, length);
    double end = 0, thick = 0;
    for (const model::Section& s : l.sections) {
      if (end <= b.from) thick = c_.line_type(s.type).contact_diameter;
      end += s.length;
    }
    b.axial = v["resistance"]["axial"].number, b.normal = v["resistance"]["normal"].number;
    const Value& m = v["mobilisation_length"];
    b.axial_length = number(m, "axial", 0.01 * thick), b.normal_length = number(m, "normal", 0.1 * thick);
    return b;
  }

  model::Section section(const Value& v, const std::string& path) const {
    model::Section s;
    s.type = v["type"].text;
    s.length = v["length"].number;
    s.grading = v["grading"].number;
    double n = number(v, "elements");
    if (const Value* h = v.find("element_length")) n = elements_for(s.length, h->number, s.grading);
    constexpr double kMost = 1e6;
    if (!(n <= kMost))
      source_.bad(v["element_length"], path + ".element_length",
                  fmt::format("makes {:.3g} elements of this section; the limit is {:.0e}", n, kMost));
    s.elements = static_cast<int>(n);
    if (const auto found = lengths_.find(path); found != lengths_.end()) s.length = found->second;
    return s;
  }

  // Fewest elements of which none is longer than h: lengths are a geometric series, last over first g.
  static double elements_for(double length, double h, double g) {
    double n = std::max(1.0, std::ceil(length / h * (1 - 1e-12)));
    const auto longest = [&](double count) {
      if (count < 2 || g == 1) return length / count;
      const double q = std::pow(g, 1 / (count - 1));
      const double first = length * std::expm1(std::log(q)) / std::expm1(count * std::log(q));
      return first * std::max(1.0, g);
    };
    for (int i = 0; i < 60 && n < 1e8 && longest(n) > h * (1 + 1e-9); ++i)
      n = std::max(n + 1, std::ceil(n * longest(n) / h * (1 - 1e-3)));
    return n;
  }

  void load(const Value& v, const std::string& path, int order, double length, model::Line& l) const {
    if (v.has("per_length")) {
      const double to = v.has("to") ? arc(v.find("to"), 0, length) : -1;
      l.loads.push_back({vec(v, "per_length"), arc(v.find("from"), 0, length), to, v["ramp"].number, order});
      return;
    }
    if (!v.has("force") && !v.has("moment"))
      source_.bad(v, path, "a point load needs 'force', 'moment' or both");
    l.point_loads.push_back(
        {arc(v.find("at"), 0, length), vec(v, "force"), vec(v, "moment"), v["ramp"].number, order});
  }

  void contact(const Value& v) {
    c_.contact.method = v["method"].is("line")  ? model::ContactMethod::line
                        : v["method"].is("gap") ? model::ContactMethod::gap
                                                : model::ContactMethod::nodes;
    c_.contact.warned_penetration = v["penetration_warning"].number;
    c_.contact.rolling = v["rolling"].number != 0;
    if (c_.contact.rolling && c_.contact.method != model::ContactMethod::line)
      source_.bad(v["rolling"], "contact.rolling", "needs 'method: line'; nodes touch without turning");
    const auto chosen = [&](const char* key, bool& all, std::vector<std::string>& names) {
      all = v[key].kind != Kind::list;
      for (const Value& n : v[key].items)
        if (std::find(names.begin(), names.end(), n.text) == names.end()) names.push_back(n.text);
    };
    chosen("lines", c_.contact.all_lines, c_.contact.lines);
    chosen("volumes", c_.contact.all_volumes, c_.contact.volumes);
    c_.contact.between_lines = read_between_lines(v["between_lines"], source_);
  }

  void statics(const Value& v) {
    if (v.kind != Kind::map) {
      c_.statics.enabled = v.number != 0;
      return;
    }
    c_.statics.enabled = v["enabled"].number != 0;
    c_.statics.tolerance = v["tolerance"].number;
    c_.statics.max_iterations = static_cast<int>(v["max_iterations"].number);
    const Value& relaxation = v["dynamic_relaxation"];
    c_.statics.relaxation = relaxation.is("always")  ? model::Relaxation::always
                            : relaxation.is("never") ? model::Relaxation::never
                                                     : model::Relaxation::automatic;
    c_.statics.relaxation_steps = static_cast<int>(v["relaxation_steps"].number);
    c_.statics.contact_friction = v["contact_friction"].number != 0;
  }

  void dynamics(const Value& v) {
    model::Dynamics& d = c_.dynamics;
    d.enabled = true;
    d.duration = v["duration"].number;
    d.step = v["step"].number;  // 0 for 'auto'
    d.max_step = number(v, "max_step");
    d.min_step = number(v, "min_step");
    d.resolve_impacts = v["resolve_impacts"].number != 0;
    d.rho_infinity = v["rho_infinity"].number;
    d.tolerance = v["tolerance"].number;
    d.error_tolerance = number(v, "error_tolerance");
  }

  void output(const Value& v) {
    model::Output& o = c_.output;
    o.file = v.has("file") ? source_.absolute(v["file"].text)
                           : (fs::path(c_.directory) / fs::path(c_.path).stem()).string() + ".h5";
    const std::string extension = fs::path(o.file).extension().string();
    if (extension != ".h5")  // nor can a case or a mesh be overwritten
      source_.bad(v["file"], "output.file", "must end in .h5, found " + model::quote(v["file"].text));
    o.every = number(v, "every");
    o.checkpoint_every = number(v, "checkpoint_every");
    o.history_every = number(v, "history_every");
    o.touchdowns = v["touchdowns"].number != 0;
    o.statistics = v["statistics"].number != 0;
    o.statistics_from = v["statistics_from"].number;
    // What is there is kept under another name, in place of what had that.
    for (const model::Line& l : c_.lines)
      for (const std::string& replaced : {o.file, kept_name(o.file)})
        if (std::error_code same; l.left && fs::equivalent(l.left->file, replaced, same))
          source_.bad(v.has("file") ? v["file"] : v, "output.file",
                      replaced + " is the run that line '" + l.name +
                          "' starts from, and would be overwritten; give another 'file'");
    const std::vector<Value>& formats = v["format"].items;
    const auto lists = [&](const char* w) {
      return std::any_of(formats.begin(), formats.end(), [&](const Value& f) { return f.is(w); });
    };
    o.xdmf = lists("xdmf");
    if (!lists("hdf5"))
      source_.bad(v["format"], "output.format",
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
      p.at =
          arc(h.find("at"), 0, model::length_of(c_.lines[static_cast<std::size_t>(c_.line_index(p.line))]));
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

  const Value& root_;
  const CaseSource& source_;
  Case& c_;
  const SectionLengths lengths_;
  OtherRuns others_{source_};
};

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
  c.notes = change_document(*tree, changes, path);
  model::check_structure(*tree, model::case_schema(), path);
  if (const Value* title = root.find("title"); news.title)
    news.title(title && !title->text.empty() ? title->text : c.path);
  const CaseSource source{path, c.directory, comm};
  Reader(root, source, c).read();
  c.tree = tree;
  examine(c);
  return c;
}

}  // namespace

model::Case with_lengths(const Case& c, const SectionLengths& lengths, MPI_Comm comm) {
  Case out;
  out.text = c.text, out.file = c.file, out.path = c.path, out.directory = c.directory;
  out.tree = c.tree, out.changes = c.changes;
  const CaseSource source{c.file, c.directory, comm};
  Reader(*c.tree, source, out, lengths).read();
  examine(out);
  // Of the command line; all others are of the lengths that were given.
  for (const std::string& n : c.notes)
    if (n.find("--set") != std::string::npos) out.notes.push_back(n);
  return out;
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

// An entry of `lines`: sections, ends, the shape it starts from, and what is on it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/io/case_values.hpp"
#include "hawser/model/check.hpp"

namespace hawser::io {

using model::Value;

namespace {

model::Feed feed(const Value& v, const std::string& path, const SectionLengths& lengths) {
  model::Feed f = read_feed_law(v);
  f.stock = v["stock"].number;
  if (const auto found = lengths.find(path + ".stock"); found != lengths.end()) f.stock = found->second;
  if (v.has("speed_table"))
    for (const Value& row : v["speed_table"].items)
      f.speed.emplace_back(row.items[0].number, row.items[1].number);
  return f;
}

model::End end(const Value& v, const std::string& path, const CaseSource& source,
               const SectionLengths& lengths, const model::Case& c) {
  model::End e;
  if (v.kind != Value::Kind::map) return e;
  e.kind = v.has("anchor")  ? model::EndKind::anchor
           : v.has("joint") ? model::EndKind::joint
                            : model::EndKind::body;
  e.at = vec(v, v.has("anchor") ? "anchor" : "at");
  if (v.has("body")) e.body = v["body"].text;
  if (v.has("joint")) e.body = v["joint"].text, e.at = c.joint(e.body).start;
  if (v.has("direction")) e.direction = read_direction(v, "direction", path, source);
  e.clamped = v["clamped"].number != 0;
  e.rotational_stiffness = number(v, "rotational_stiffness");
  if (v.has("no_contact_within")) e.no_contact_within = v["no_contact_within"].number;
  if (v.has("feed")) e.feed = feed(v["feed"], path + ".feed", lengths);
  return e;
}

model::Buried buried(const Value& v, double length, const model::Line& l, const model::Case& c) {
  model::Buried b;
  b.from = arc(v.find("from"), 0, length), b.to = arc(v.find("to"), length, length);
  double end = 0, thick = 0;
  for (const model::Section& s : l.sections) {
    if (end <= b.from) thick = c.line_type(s.type).contact_diameter;
    end += s.length;
  }
  b.axial = v["resistance"]["axial"].number, b.normal = v["resistance"]["normal"].number;
  const Value& m = v["mobilisation_length"];
  b.axial_length = number(m, "axial", 0.01 * thick), b.normal_length = number(m, "normal", 0.1 * thick);
  return b;
}

// Fewest elements of which none is longer than h: lengths are a geometric series, last over first g.
double elements_for(double length, double h, double g) {
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

model::Section section(const Value& v, const std::string& path, const CaseSource& source,
                       const SectionLengths& lengths) {
  model::Section s;
  s.type = v["type"].text;
  s.length = v["length"].number;
  s.grading = v["grading"].number;
  double n = number(v, "elements");
  if (const Value* h = v.find("element_length")) n = elements_for(s.length, h->number, s.grading);
  constexpr double kMost = 1e6;
  if (!(n <= kMost))
    source.bad(v["element_length"], path + ".element_length",
               fmt::format("makes {:.3g} elements of this section; the limit is {:.0e}", n, kMost));
  s.elements = static_cast<int>(n);
  if (const auto found = lengths.find(path); found != lengths.end()) s.length = found->second;
  return s;
}

void load(const Value& v, const std::string& path, int order, double length, const CaseSource& source,
          model::Line& l) {
  if (v.has("per_length")) {
    const double to = v.has("to") ? arc(v.find("to"), 0, length) : -1;
    l.loads.push_back({vec(v, "per_length"), arc(v.find("from"), 0, length), to, v["ramp"].number, order});
    return;
  }
  if (!v.has("force") && !v.has("moment"))
    source.bad(v, path, "a point load needs 'force', 'moment' or both");
  l.point_loads.push_back(
      {arc(v.find("at"), 0, length), vec(v, "force"), vec(v, "moment"), v["ramp"].number, order});
}

// The shape it starts from: its own `start`, or the one of the whole case (`whole`, may be null).
void read_start(const Value& start, const std::string& path, const CaseSource& source, const Value* whole,
                OtherRuns& others, model::Case& c, model::Line& l) {
  if (whole && !start.given) {
    l.left = others.shape(*whole, "start", l.name, false);
    if (l.left) {
      l.start = model::Start::other_run;
      check_left_shape(l, (*whole)["from"], path, source, c.notes);
    } else {
      c.notes.push_back(path + ": is not in " + (*whole)["from"].text + ", and starts by itself");
    }
  } else if (start.kind == Value::Kind::map && start.has("from")) {
    l.start = model::Start::other_run;
    l.left = others.shape(start, path + ".start", start.has("line") ? start["line"].text : l.name, true);
    check_left_shape(l, start["from"], path + ".start", source, c.notes);
  } else if (start.kind == Value::Kind::map) {
    l.start = model::Start::points;
    for (const Value& p : start["points"].items) l.points.push_back(as_vec3(p));
  } else {
    l.start = start.is("catenary")   ? model::Start::catenary
              : start.is("hanging")  ? model::Start::hanging
              : start.is("straight") ? model::Start::straight
                                     : model::Start::automatic;
  }
}

}  // namespace

model::Line read_line(const std::string& name, const Value& v, const CaseSource& source, const Value* whole,
                      const SectionLengths& lengths, OtherRuns& others, model::Case& c) {
  const std::string path = "lines." + name;
  model::Line l;
  l.name = name;
  for (std::size_t i = 0; i < v["sections"].items.size(); ++i)
    l.sections.push_back(
        section(v["sections"].items[i], fmt::format("{}.sections[{}]", path, i), source, lengths));
  const double length = model::length_of(l);
  l.end_a = end(v["end_a"], path + ".end_a", source, lengths, c);
  l.end_b = end(v["end_b"], path + ".end_b", source, lengths, c);
  read_start(v["start"], path, source, whole, others, c, l);
  for (std::size_t i = 0; i < v["buried"].items.size(); ++i)
    l.buried.push_back(buried(v["buried"].items[i], length, l, c));
  if (const Value* t = v.find("target")) l.target = read_target(*t, path + ".target", v["sections"], source);
  read_temperature_change(v["temperature_change"], path + ".temperature_change", source, l);
  for (const Value& m : v["masses"].items)
    l.masses.push_back({arc(m.find("at"), 0, length), m["mass"].number, m["volume"].number,
                        m["drag_area"].number, m["Ca"].number});
  const std::vector<Value>& stiffeners = v["bend_stiffeners"].items;
  for (std::size_t i = 0; i < stiffeners.size(); ++i)
    read_bend_stiffener(stiffeners[i], fmt::format("{}.bend_stiffeners[{}]", path, i),
                        arc(stiffeners[i].find("at"), 0, length), length, source, l);
  for (std::size_t i = 0; i < v["loads"].items.size(); ++i)
    load(v["loads"].items[i], fmt::format("{}.loads[{}]", path, i), static_cast<int>(i), length, source, l);
  return l;
}

}  // namespace hawser::io

// Entries of `lines`: elements of sections, loads, start shapes, and arc lengths relative to the line's
// length. model/take.cpp copies all other keys, as bound in model/schema_lines.cpp.
#include <algorithm>
#include <cmath>

#include "hawser/advice/start_shape.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/model/check.hpp"

namespace hawser::io {

using model::refuse;
using model::Value;

namespace {

void finish_end(const Value& v, const SectionLengths& lengths, const model::Case& c, model::End& e) {
  if (e.kind == model::EndKind::joint) e.at = c.joint(e.carrier).start;
  if (!e.feed) return;
  const auto found = lengths.find(v["feed"]["stock"].where);
  if (found != lengths.end()) e.feed->stock = found->second;
}

void finish_buried(const Value& v, double length, const model::Line& l, const model::Case& c,
                   model::Buried& b) {
  to_length(b.from, length);
  to_length(b.to, length);
  if (!v.has("to")) b.to = length;
  double end = 0, thick = 0;
  for (const model::Section& s : l.sections) {
    if (end <= b.from) thick = c.line_type(s.type).contact_diameter;
    end += s.length;
  }
  if (!(b.axial_length > 0)) b.axial_length = 0.01 * thick;
  if (!(b.normal_length > 0)) b.normal_length = 0.1 * thick;
}

// Smallest number of elements no longer than h in a geometric series with ratio g of last to first.
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

void finish_section(const Value& v, const SectionLengths& lengths, model::Section& s) {
  if (const Value* h = v.find("element_length")) {
    constexpr double kMost = 1e6;
    const double n = elements_for(s.length, h->number, s.grading);
    if (!(n <= kMost)) refuse(*h, "makes {:.3g} elements of this section; the limit is {:.0e}", n, kMost);
    s.elements = static_cast<int>(n);
  }
  if (const auto found = lengths.find(v.where); found != lengths.end()) s.length = found->second;
}

void load(const Value& v, int order, double length, model::Line& l) {
  if (v.has("per_length")) {
    const double to = v.has("to") ? arc(v.find("to"), 0, length) : -1;
    l.loads.push_back({vec(v, "per_length"), arc(v.find("from"), 0, length), to, v["ramp"].number, order});
    return;
  }
  if (!v.has("force") && !v.has("moment")) refuse(v, "a point load needs 'force', 'moment' or both");
  l.point_loads.push_back(
      {arc(v.find("at"), 0, length), vec(v, "force"), vec(v, "moment"), v["ramp"].number, order});
}

void finish_bend_stiffener(const Value& v, double length, model::BendStiffener& b) {
  if (!v.has("towards")) b.towards_a = v["at"].is("end_b");
  to_length(b.at, length);
}

// Length target: the condition, and the section whose length is adjusted.
void finish_target(const Value& v, const Value& sections, model::LengthTarget& t) {
  if (t.kind == model::LengthTarget::Kind::laid_length && v["at"].given)
    refuse(v["at"], "does not apply to 'laid_length', which is that of the whole line; remove it");
  const auto length = [&](int i) { return sections.items[i]["length"].number; };
  const int count = static_cast<int>(sections.items.size());
  for (int i = 1; i < count; ++i)
    if (length(i) > length(t.section)) t.section = i;
  if (const Value* s = v.find("section")) {
    if (s->number > count) refuse(*s, "there is no section {:g}; the line has {}", s->number, count);
    t.section = static_cast<int>(s->number) - 1;
  }
  const double given = length(t.section);
  if (!v.has("between")) {
    t.min_length = 0.5 * given;
    t.max_length = 1.5 * given;
  }
  if (!(t.min_length < given && given < t.max_length))
    refuse(v["between"],
           "the search begins with the length of section {}, {:g} m, which is not between {:g} and {:g} m",
           t.section + 1, given, t.min_length, t.max_length);
}

}  // namespace

void finish_start(const Value& line, const Value* start_of_case, OtherRuns& others, model::Case& c,
                  model::Line& l) {
  const Value& start = line["start"];
  if (start_of_case && !start.given) {
    l.previous_shape = others.shape(*start_of_case, l.name, false);
    if (!l.previous_shape) {
      c.notes.push_back(advice::not_in_other_run(l.name, (*start_of_case)["from"].text));
      return;
    }
    l.start = model::Start::other_run;
    check_previous_shape(l, (*start_of_case)["from"], "lines." + l.name, others.parted(), c.notes);
  } else if (start.has("from")) {
    l.start = model::Start::other_run;
    l.previous_shape = others.shape(start, start.has("line") ? start["line"].text : l.name, true);
    check_previous_shape(l, start["from"], start.where, others.parted(), c.notes);
  }
}

void finish_line(const Value& v, const Value* start_of_case, const SectionLengths& lengths, OtherRuns& others,
                 model::Case& c, model::Line& l) {
  const auto each = [&v](const char* key, auto& list, auto&& finish) {
    for (std::size_t i = 0; i < list.size(); ++i) finish(v[key].items[i], list[i]);
  };
  each("sections", l.sections, [&](const Value& x, auto& s) { finish_section(x, lengths, s); });
  const double length = model::length_of(l);
  finish_end(v["end_a"], lengths, c, l.end_a);
  finish_end(v["end_b"], lengths, c, l.end_b);
  finish_start(v, start_of_case, others, c, l);
  each("buried", l.buried, [&](const Value& x, auto& b) { finish_buried(x, length, l, c, b); });
  if (l.target) finish_target(v["target"], v["sections"], *l.target);
  for (model::PointMass& m : l.masses) to_length(m.at, length);
  each("bend_stiffeners", l.bend_stiffeners,
       [&](const Value& x, auto& b) { finish_bend_stiffener(x, length, b); });
  const std::vector<Value>& loads = v["loads"].items;
  for (std::size_t i = 0; i < loads.size(); ++i) load(loads[i], static_cast<int>(i), length, l);
}

}  // namespace hawser::io

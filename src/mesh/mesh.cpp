// Nodes and elements of a case: elements with the lengths of model/line_nodes.cpp, joints, ends tied to
// floating bodies, nodes where tension may jump, and bodies that ride on lines.
#include "hawser/mesh/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <unordered_map>

#include "hawser/model/case.hpp"
#include "hawser/model/line_nodes.hpp"

namespace hawser {
namespace {

// True if an event releases this end.
bool released(const model::Case& c, const model::Line& line, LineEnd line_end) {
  return std::any_of(c.events.begin(), c.events.end(), [&](const model::Event& e) {
    return e.action.kind == model::Action::Kind::release && e.action.line == line.name &&
           e.action.line_end == line_end;
  });
}

// Nodes with properties that do not follow from the elements beside them.
class SpecialNodes {
 public:
  explicit SpecialNodes(Mesh& mesh) : mesh_(mesh) {}
  // To be changed.
  Node& at(int n) {
    const auto place = nodes_.find(n);
    return place != nodes_.end() ? place->second : nodes_.emplace(n, mesh_.node(n)).first->second;
  }
  void store() const { mesh_.set(nodes_); }

 private:
  Mesh& mesh_;
  std::map<int, Node> nodes_;
};

// An end of a joint that rotates (the last one), or else the first end, shares its position with the other
// ends; in a rigid joint the others that rotate are tied to it. Ends that are released later are tied to one
// that is not, and have separate unknowns after the release.
void join(const model::Case& c, const Mesh& m, SpecialNodes& special) {
  std::unordered_map<std::string, std::vector<std::pair<size_t, LineEnd>>> ends_of;  // by joint
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const LineEnd end : kLineEnds)
      if (const model::End& e = c.lines[l].end(end); e.kind == model::EndKind::joint)
        ends_of[e.carrier].emplace_back(l, end);
  for (const model::Joint& joint : c.joints) {
    std::vector<int> ends, leaving;
    for (const auto& [l, end] : ends_of[joint.name]) {
      (released(c, c.lines[l], end) ? leaving : ends).push_back(m.lines[l].end_node(end));
    }
    int first = -1;
    for (int n : ends)
      if (first < 0 || m.node(n).rotates) first = n;
    for (int n : ends)
      if (n != first) {
        Node& node = special.at(n);
        (joint.rigid && node.rotates ? node.tied_to : node.pinned_to) = first;
      }
    for (int n : leaving) special.at(n).tied_to = first;
  }
}

// Ties ends to floating bodies, including ends that events attach to one.
void tie(const model::Case& c, const Mesh& m, SpecialNodes& special) {
  for (const model::Event& e : c.events) {
    const model::Action& a = e.action;
    if (a.kind != model::Action::Kind::attach || !c.floats(c.body_index(a.body))) continue;
    const LineSpan& span = m.lines[c.line_index(a.line)];
    special.at(span.end_node(a.line_end)).tied_to = m.body_node(c.body_index(a.body));
  }
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const LineEnd end : kLineEnds) {
      const model::End& e = c.lines[l].end(end);
      if (e.kind != model::EndKind::body || !c.floats(c.body_index(e.carrier))) continue;
      special.at(m.lines[l].end_node(end)).tied_to = m.body_node(c.body_index(e.carrier));
    }
}

void mark_two_sided(const model::Case& c, const Mesh& m, SpecialNodes& special) {
  const std::span<const EvenPart> parts = m.parts();
  for (size_t p = 1; p < parts.size(); ++p)
    if (parts[p].line == parts[p - 1].line && parts[p].shape->type != parts[p - 1].shape->type)
      special.at(parts[p].first_node).two_sided = true;
  for (size_t l = 0; l < c.lines.size(); ++l) {
    const LineSpan& span = m.lines[l];
    const auto attach = [&](double at) {
      const int n = m.nearest_node(static_cast<int>(l), at);
      if (n > span.first_node && n < span.first_node + span.nodes - 1) special.at(n).two_sided = true;
    };
    for (const model::PointMass& p : c.lines[l].masses) attach(p.at);
    for (const model::PointLoad& p : c.lines[l].point_loads) attach(p.at);
    for (const model::Event& e : c.events)  // events that depend on the tension there
      if (e.cause.kind == model::Cause::Kind::tension && e.cause.line == c.lines[l].name) attach(e.cause.arc);
  }
}

}  // namespace

Mesh build_mesh(const model::Case& c) {
  Mesh m;
  const auto places = model::fixed_places(c);
  m.lines.reserve(c.lines.size());
  for (size_t i = 0; i < c.lines.size(); ++i) {
    const auto& line = c.lines[i];
    LineSpan span;
    span.first_node = m.nodes();
    span.first_element = m.elements();
    m.begin_line();
    PartShape part;
    if (line.temperature_change.size() > 1) part.rows = m.add(line.temperature_change);
    double start = 0;  // m, arc length of the beginning of the section
    const auto sections = model::progressions(line, places[i]);
    for (size_t s = 0; s < sections.size(); ++s) {
      const model::Section& section = line.sections[s];
      part.type = 0;
      while (c.line_types[part.type].name != section.type) ++part.type;
      const model::LineType& type = c.line_types[part.type];
      part.beam = type.kind == model::LineKind::beam;
      part.free_strain = part.rows < 0 ? model::thermal_strain(type, line, 0, 0) : type.thermal_expansion;
      part.along = 0;
      part.start = start;
      start += section.length;
      for (const model::Progression& lengths : sections[s]) {
        part.lengths = lengths;
        part.section_end = &lengths == &sections[s].back() ? start : 0;
        part.along = m.add(static_cast<int>(i), part);
      }
    }
    span.nodes = m.nodes() - span.first_node;
    span.elements = m.elements() - span.first_element;
    span.length = start;
    m.lines.push_back(span);
    m.line_names.push_back(line.name);
  }
  SpecialNodes special(m);
  join(c, m, special);
  mark_two_sided(c, m, special);
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    const bool has_node = c.bodies[b].mass.has_value();
    m.bodies.push_back(has_node ? c.bodies[b].name : "");
    if (!has_node) continue;
    const int group = static_cast<int>(m.lines.size()) + m.body_nodes();
    m.add(Node{group, 0, 0, true, static_cast<int>(b)});
  }
  m.shrink_to_fit();
  tie(c, m, special);
  special.store();
  for (size_t b = 0; b < c.bodies.size(); ++b)
    if (const auto& ride = c.bodies[b].ride)
      m.rides.emplace_back(static_cast<int>(b), m.nearest_node(c.line_index(ride->line), ride->at));
  return m;
}

Runs<double> largest_of_types(const Mesh& mesh, const std::vector<double>& values) {
  Runs<double> out;
  auto part = mesh.parts().begin();
  for (int l = 0; l < std::ssize(mesh.lines); ++l) {
    double largest = 0;
    for (; part != mesh.parts().end() && part->line == l; ++part)
      largest = std::max(largest, values[part->shape->type]);
    out.push_back(largest);
  }
  return out;
}

void Mesh::shrink_to_fit() {
  MeshTable::shrink_to_fit();
  line_names.shrink_to_fit();
  bodies.shrink_to_fit();
}

int Mesh::body_node(int body) const {
  const auto bodies_after = std::views::iota(line_nodes(), nodes());
  const auto at = std::ranges::lower_bound(bodies_after, body, {}, [&](int n) { return node(n).body; });
  return at != bodies_after.end() && node(*at).body == body ? *at : -1;
}

int Mesh::frame_node(int body) const {
  for (const auto& [rider, node] : rides)
    if (rider == body) return node;
  return body_node(body);
}

int Mesh::nearest_node(int line, double s) const {
  const LineSpan& span = lines[line];
  const auto arc = [&](int n) { return node(n).arc; };
  const auto all = std::views::iota(span.first_node, span.first_node + span.nodes);
  const auto after = std::ranges::lower_bound(all, s, {}, arc);
  if (after == all.begin()) return *after;
  if (after == all.end()) return *(after - 1);
  return std::abs(arc(*after) - s) < std::abs(arc(*(after - 1)) - s) ? *after : *(after - 1);
}

std::string Mesh::place(int node) const {
  const Node n = this->node(node);
  if (n.body >= 0) return "body " + bodies[n.body];
  return fmt::format("line {}, arc length {:.6g} m", line_names[n.line], n.arc);
}

}  // namespace hawser

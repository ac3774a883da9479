// Nodes and elements of a case: elements with the lengths of model/line_nodes.cpp, joints, ends tied to
// floating bodies, nodes where tension may jump, and bodies that ride on lines.
#include "hawser/mesh/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "hawser/model/case.hpp"
#include "hawser/model/line_nodes.hpp"

namespace hawser {
namespace {

// True if an event releases this end.
bool released(const model::Case& c, const model::Line& line, bool at_b) {
  return std::any_of(c.events.begin(), c.events.end(), [&](const model::Event& e) {
    return e.action.kind == model::Action::Kind::release && e.action.line == line.name &&
           e.action.at_b == at_b;
  });
}

// An end of a joint that rotates (the last one), or else the first end, shares its position with the other
// ends; in a rigid joint it carries the others that rotate. An end that stays carries those that are released
// later, which then have unknowns of their own.
void join(const model::Case& c, Mesh& m) {
  std::unordered_map<std::string, std::vector<std::pair<size_t, bool>>> ends_of;  // by joint: line, its end B
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const bool b : {false, true})
      if (const model::End& e = c.lines[l].end(b); e.kind == model::EndKind::joint)
        ends_of[e.body].emplace_back(l, b);
  for (const model::Joint& joint : c.joints) {
    std::vector<int> ends, leaving;
    for (const auto& [l, b] : ends_of[joint.name]) {
      const LineSpan& span = m.lines[l];
      (released(c, c.lines[l], b) ? leaving : ends).push_back(span.first_node + (b ? span.nodes - 1 : 0));
    }
    int first = -1;
    for (int n : ends)
      if (first < 0 || m.nodes[n].rotates) first = n;
    for (int n : ends)
      if (n != first) {
        Node& node = m.nodes[n];
        (joint.rigid && node.rotates ? node.tied_to : node.pinned_to) = first;
      }
    for (int n : leaving) m.nodes[n].tied_to = first;
  }
}

// Ties ends to floating bodies, including ends that events attach to one.
void tie(const model::Case& c, Mesh& m) {
  for (const model::Event& e : c.events) {
    const model::Action& a = e.action;
    if (a.kind != model::Action::Kind::attach || !c.floats(c.body_index(a.body))) continue;
    const LineSpan& span = m.lines[c.line_index(a.line)];
    m.nodes[span.first_node + (a.at_b ? span.nodes - 1 : 0)].tied_to = m.body_node(c.body_index(a.body));
  }
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const bool last : {false, true}) {
      const model::End& e = c.lines[l].end(last);
      if (e.kind != model::EndKind::body || !c.floats(c.body_index(e.body))) continue;
      const int n = m.lines[l].first_node + (last ? m.lines[l].nodes - 1 : 0);
      m.nodes[n].tied_to = m.body_node(c.body_index(e.body));
    }
}

void mark_two_sided(const model::Case& c, Mesh& m) {
  for (size_t e = 1; e < m.elements.size(); ++e)
    if (m.elements[e].line == m.elements[e - 1].line && m.elements[e].type != m.elements[e - 1].type)
      m.nodes[m.elements[e].first].two_sided = true;
  for (size_t l = 0; l < c.lines.size(); ++l) {
    const LineSpan& span = m.lines[l];
    const auto attach = [&](double at) {
      const int n = m.nearest_node(static_cast<int>(l), at);
      if (n > span.first_node && n < span.first_node + span.nodes - 1) m.nodes[n].two_sided = true;
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
  size_t elements = 0;
  for (const model::Line& line : c.lines)
    for (const model::Section& s : line.sections) elements += s.elements;
  m.elements.reserve(elements);
  m.nodes.reserve(elements + c.lines.size() + c.bodies.size());
  for (size_t i = 0; i < c.lines.size(); ++i) {
    const auto& line = c.lines[i];
    LineSpan span;
    span.first_node = static_cast<int>(m.nodes.size());
    span.first_element = static_cast<int>(m.elements.size());
    const int number = static_cast<int>(i);
    m.nodes.push_back({number, 0, 0, false});
    const auto lengths = model::element_lengths(line, places[i]);
    for (size_t s = 0; s < lengths.size(); ++s) {
      const model::Section& section = line.sections[s];
      int type = 0;
      while (c.line_types[type].name != section.type) ++type;
      const bool beam = c.line_types[type].kind == model::LineKind::beam;
      const double start = m.nodes.back().arc;
      double along = 0;
      for (const double l : lengths[s]) {
        along += l;
        const int a = static_cast<int>(m.nodes.size()) - 1;
        m.nodes.push_back({number, start + along, 0, false});
        const double at = m.nodes[a].arc;
        m.elements.push_back(
            {number, a, a + 1, type, l, beam, model::thermal_strain(c.line_types[type], line, at, at + l)});
        for (int n : {a, a + 1}) {
          m.nodes[n].tributary += 0.5 * l;
          m.nodes[n].rotates |= beam;
        }
      }
      m.nodes.back().arc = start + section.length;
    }
    span.nodes = static_cast<int>(m.nodes.size()) - span.first_node;
    span.elements = static_cast<int>(m.elements.size()) - span.first_element;
    span.length = m.nodes.back().arc;
    span.name = line.name;
    m.lines.push_back(span);
  }
  join(c, m);
  mark_two_sided(c, m);
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    m.bodies.push_back(c.bodies[b].name);
    if (!c.bodies[b].mass) continue;
    const int group = static_cast<int>(m.lines.size() + m.nodes.size()) - m.line_nodes();
    m.nodes.push_back({group, 0, 0, true, static_cast<int>(b)});
  }
  tie(c, m);
  for (size_t b = 0; b < c.bodies.size(); ++b)
    if (const auto& on = c.bodies[b].on)
      m.rides.emplace_back(static_cast<int>(b), m.nearest_node(c.line_index(on->line), on->at));
  return m;
}

int Mesh::body_node(int body) const {
  const auto at = std::lower_bound(nodes.begin() + line_nodes(), nodes.end(), body,
                                   [](const Node& n, int wanted) { return n.body < wanted; });
  return at != nodes.end() && at->body == body ? static_cast<int>(at - nodes.begin()) : -1;
}

int Mesh::frame_node(int body) const {
  for (const auto& [rider, node] : rides)
    if (rider == body) return node;
  return body_node(body);
}

int Mesh::nearest_node(int line, double s) const {
  const LineSpan& span = lines[line];
  int best = span.first_node;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n)
    if (std::abs(nodes[n].arc - s) < std::abs(nodes[best].arc - s)) best = n;
  return best;
}

std::string Mesh::place(int node) const {
  const Node& n = nodes[node];
  if (n.body >= 0) return "body " + bodies[n.body];
  return fmt::format("line {}, arc length {:.6g} m", lines[n.line].name, n.arc);
}

}  // namespace hawser

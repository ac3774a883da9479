// The class ElementErrors: estimates of errors from long elements, by the formulas of
// docs/theory/element-length.md.
#include "hawser/record/element_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/angle_between.hpp"
#include "hawser/record/line_extremes.hpp"

namespace hawser::record {
namespace {

constexpr double kWarned = 0.02;            // of the largest tension or moment, for sag and bends
constexpr double kRecommendedError = 0.01;  // error of elements of the recommended length

// Relative error at the end of a cubic of length x decay, of the value shown, for a moment that decays as
// exp(-s/decay); and the length for which it is kRecommendedError.
double wrong_inside(double x) { return x * x / (12 + 4.2 * x); }
constexpr double kRecommendedInside = 0.37;
// The same where nodal forces give the moment: at ends and attachments.
double wrong_at_end(double x) { return x * x * x * x / (1440 + 144 * x * x); }
constexpr double kRecommendedAtEnd = 2.1;
// The same where a smooth bend on a volume begins.
double wrong_at_liftoff(double x) { return 0.06 * x / (1 + 0.3 * x); }
constexpr double kRecommendedAtLiftoff = 0.18;
constexpr double kLongAtLiftoff = 1;  // x from which it is estimated

// Excess over a curve of radius R [m] of a straight element that touches it p [m] before a node where it
// turns by `turn`: p turn²/2 - R turn³/6.
double excess(double p, double turn, double R) { return turn * turn * (0.5 * p - std::min(R * turn, p) / 6); }

constexpr double kEqual = 1e-6;  // relative difference of forces that count as equal

constexpr int kNodesTag = 76;

// A volume of a floating body gives way to a longer line.
bool holds_all_volumes(const model::Case& c) {
  return std::ranges::none_of(c.volumes,
                              [&](const model::Volume& v) { return c.floats(c.body_index(v.body)); });
}

}  // namespace

ElementErrors::ElementErrors(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                             const Feeders* feeders, const LinePairs* pairs)
    : case_(c),
      mesh_(mesh),
      feeders_(feeders),
      volumes_are_held_(holds_all_volumes(c)),
      comm_(comm),
      lines_(mesh) {
  bool shares = false;
  for (const int l : lines_.lines()) {
    lines_[l].held = c.holds_both_ends(c.lines[l]);
    shares |= lines_[l].held && c.contact.takes_part(c.lines[l]);
  }
  if (pairs && on_any_rank(comm, shares)) pairs_ = pairs;
  LineOwners lines = line_owners(mesh);
  uncut_ = std::move(lines.uncut);
  const int rank = rank_of(comm);
  for (const int l : lines.cut) {
    const LineSpan& line = mesh.mesh->lines[l];
    const int owner = mesh.owner[line.first_node];
    for (int n = line.first_node; n < line.first_node + line.nodes; ++n) {
      if (owner != rank && mesh.owner[n] == rank) shared_[owner].send.push_back(mesh.find(n));
      if (owner == rank && mesh.owner[n] != rank)
        shared_[mesh.owner[n]].receive.push_back(static_cast<int>(cut_nodes_) + n - line.first_node);
    }
    if (owner != rank) continue;
    cut_.push_back(l);
    cut_nodes_ += static_cast<size_t>(line.nodes);
  }
}

const model::LineType& ElementErrors::type(const Element& e) const { return case_.line_types[e.type]; }

double ElementErrors::arc(const LineSpan& line, int node) const {
  return mesh_.mesh->node(line.first_node + node).arc;
}

ElementErrors::At ElementErrors::node(size_t n, const Kinematics& state, const Values& values) const {
  const auto value = [n](std::span<const double> field) { return field.empty() ? 0 : field[n]; };
  const double moment = value(values.moment);
  return {state.x[n],
          value(values.tension),
          std::isnan(moment) ? 0 : std::abs(moment),
          !values.pressed.empty() && values.pressed[n],
          values.supported[n],
          mesh_.node(n).two_sided,
          !values.on_volume.empty() && values.on_volume[n],
          !values.on_line.empty() && values.on_line[n]};
}

void ElementErrors::declare(Declarations& to) {
  const std::vector<Field>& fields = to.contents.fields;
  tension_ = find_field(fields, "effective_tension");
  moment_ = find_field(fields, "bending_moment");
  for (size_t f = 0; f < fields.size(); ++f)
    if (fields[f].contact_with != advice::ContactWith::nothing)
      touches_.push_back({static_cast<int>(f), fields[f].components, fields[f].contact_with});
}

void ElementErrors::output(const Snapshot& s) {
  Values v{s.field(tension_), s.field(moment_), {}, {}};
  v.pressed.resize(mesh_.owned, false);
  v.supported.resize(mesh_.owned, false);
  v.on_volume.resize(mesh_.owned, false);
  v.on_line.resize(mesh_.owned, false);
  for (const TouchField& f : touches_)
    for (size_t n = 0, c = static_cast<size_t>(f.components); n < v.supported.size(); ++n)
      for (size_t k = 0; k < c; ++k)
        if (s.values[f.index][n * c + k] != 0) {
          v.supported[n] = true;
          if (f.with != advice::ContactWith::seabed) v.pressed[n] = true;
          if (f.with == advice::ContactWith::volume) v.on_volume[n] = true;
          if (f.with == advice::ContactWith::line) v.on_line[n] = true;
        }
  if (pairs_) {
    ActiveContacts contacts;
    pairs_->active_contacts(contacts);
    for (const ActiveContact& c : contacts) v.contacts.push_back({c.line, c.other_line, c.force});
  }
  update(s.at, v);
}

std::vector<Warning> ElementErrors::warnings(const std::vector<io::SummaryRow>& summary) {
  PerLine<double> bent(mesh_, HUGE_VAL);
  for (const io::SummaryRow& r : summary)
    if (r.quantity == "max bending moment") bent[case_.line_index(r.line)] = r.value;
  std::vector<Warning> out;
  for (size_t i = 0; i < summary.size(); ++i)
    if (const io::SummaryRow& r = summary[i]; is_largest_tension(case_, r))
      for (std::string& w : warnings(case_.line_index(r.line), r.value, bent[case_.line_index(r.line)]))
        out.push_back({std::move(w), i});
  return out;
}

void ElementErrors::update(const Kinematics& state, const Values& values) {
  const auto inside = feeders_ ? feeders_->inside() : std::vector<std::array<int, 2>>();
  std::vector<Element> elements;
  std::vector<OverLines> over_lines;
  const auto update_line = [&](int l, const At* nodes_of_line) {
    const LineSpan& line = mesh_.mesh->lines[l];
    elements.clear();
    for (int e = 0; e < line.elements; ++e) elements.push_back(mesh_.mesh->element(line.first_element + e));
    const std::span<const At> nodes(nodes_of_line, static_cast<size_t>(line.nodes));
    const auto [at_a, at_b] = inside.empty() ? std::array<int, 2>{} : inside[l];
    const InState s{line, nodes, elements, at_a, line.elements - at_b, state.time};
    update_sag(s, lines_[l], over_lines);
    if (!state.ends_step()) update_lifts(s, lines_[l].lift);
    if (!values.moment.empty()) update_bends(s, lines_[l]);
  };
  std::vector<At> nodes;
  for (const int l : uncut_) {
    const LineSpan& line = mesh_.mesh->lines[l];
    const auto first = static_cast<size_t>(mesh_.find(line.first_node));
    nodes.clear();
    for (size_t n = first; n < first + static_cast<size_t>(line.nodes); ++n)
      nodes.push_back(node(n, state, values));
    update_line(l, nodes.data());
  }
  nodes.clear();
  for (const int l : cut_) {
    const LineSpan& line = mesh_.mesh->lines[l];
    for (int n = line.first_node; n < line.first_node + line.nodes; ++n) {
      const int local = mesh_.find(n);
      nodes.push_back(mesh_.owns(local) ? node(static_cast<size_t>(local), state, values) : At{});
    }
  }
  exchange<At>(
      comm_, kNodesTag, shared_, [&](int n) { return node(static_cast<size_t>(n), state, values); },
      [&](int place, const At& at) { nodes[place] = at; });
  size_t first = 0;
  for (const int l : cut_) {
    update_line(l, nodes.data() + first);
    first += static_cast<size_t>(mesh_.mesh->lines[l].nodes);
  }
  if (pairs_) update_over_lines(over_lines, values.contacts);
}

// The curve within a straight element is longer by theta²/24 of its length, with theta the turn across the
// element. The line has this additional slack; its effect on the tension follows from the shape.
void ElementErrors::update_sag(const InState& s, OfLine& worst, std::vector<OverLines>& over_lines) const {
  const std::span<const At> nodes = s.nodes;
  const std::span<const Element> elements = s.elements;
  const int first = s.first;
  const int last = s.last;
  const auto chord = [&](int i) { return Vec3((nodes[i + 1].x - nodes[i].x).normalized()); };
  // Turn at a node caused by the loads of the line alone; -1: other loads act.
  const auto turn = [&](int n) {
    const bool plain = n > first && n < last && !nodes[n].supported && !nodes[n].two_sided;
    return plain ? angle_between(chord(n - 1), chord(n)) : -1;
  };
  double extension = 0, compliance = 0, largest = 0, tension = HUGE_VAL;
  Worst candidate;
  for (int i = first; i < last;) {
    int end = i;  // end of the hanging part
    Vec3 chord_sum = Vec3::Zero();
    const auto hangs = [&](int e) { return !nodes[e].supported || !nodes[e + 1].supported; };
    for (; end < last && hangs(end); ++end) chord_sum += elements[end].length * chord(end);
    double length = 0;
    for (int k = i; k < end; ++k) length += elements[k].length;
    for (int k = i; k < std::max(end, i + 1); ++k) {
      const Element& e = elements[k];
      const double pull = 0.5 * (nodes[k].tension + nodes[k + 1].tension);
      compliance += e.length * std::max(pull, 0.0) / type(e).EA;
      if (end == i) continue;  // on the bed
      tension = std::min(tension, std::max(pull, 0.0));
      compliance += e.length * (chord(k) - chord_sum / length).squaredNorm();
      const double a = turn(k);
      const double b = turn(k + 1);
      const double theta = std::min(a < 0 ? b : a, b < 0 ? a : b);
      if (e.beam || theta < 0) continue;  // cubics follow the sag
      const double more = e.length * theta * theta / 24;
      extension += more;
      if (more <= largest) continue;
      largest = more;
      candidate = {0, arc(s.line, k) + 0.5 * e.length, s.time, theta, e.length};
    }
    i = std::max(end, i + 1);
  }
  if (!(compliance > 0) || tension == HUGE_VAL) return;
  candidate.error = extension / compliance * tension;
  if (candidate.error > worst.sag.error) worst.sag = candidate;
  if (!worst.held) return;
  auto [over_volumes, of_lines] = corners(s);
  over_volumes.error = over_volumes.excess / compliance * tension;
  over_volumes.own_error = over_volumes.error;
  if (volumes_are_held_ && over_volumes.error > worst.corner.error) worst.corner = over_volumes;
  const bool yields = !volumes_are_held_ && std::ranges::any_of(nodes, &At::on_volume);
  const int l = static_cast<int>(&s.line - mesh_.mesh->lines.data());
  if (pairs_ && !yields && std::ranges::any_of(nodes, &At::on_line))
    over_lines.push_back({l, of_lines, tension, compliance});
}

// The exact curve goes straight to an edge of radius R and bends along it. An element outside the edge turns
// by a and b at its nodes and touches at the fraction b/(a + b) of its length, by its balance of moments.
// Between elements that both touch, the curve is an arc tangent to both, and each has half of the turn.
ElementErrors::Corners ElementErrors::corners(const InState& s) const {
  const auto& [line, nodes, elements, first, last, time] = s;
  const bool along_elements = case_.contact.method == model::ContactMethod::line;
  const auto on_volume = [&](int i) {
    return along_elements && nodes[i].on_volume && nodes[i + 1].on_volume;
  };
  const auto touches = [&](int i) { return on_volume(i) || (nodes[i].on_line && nodes[i + 1].on_line); };
  const auto chord = [&](int i) { return Vec3((nodes[i + 1].x - nodes[i].x).normalized()); };
  Corners out;
  double largest_over_volumes = 0;
  double largest_over_lines = 0;
  for (int i = first + 1; i + 1 < last; ++i) {
    const Element& e = elements[i];
    if (e.beam || !touches(i) || nodes[i].two_sided || nodes[i + 1].two_sided) continue;
    const Vec3 before = chord(i - 1);
    const Vec3 along = chord(i);
    const Vec3 after = chord(i + 1);
    if (!(before.cross(along).dot(along.cross(after)) > 0)) continue;  // no bend to one side
    const bool shared_a = touches(i - 1);
    const bool shared_b = touches(i + 1);
    const double a = angle_between(before, along) * (shared_a ? 0.5 : 1);
    const double b = angle_between(along, after) * (shared_b ? 0.5 : 1);
    const double radius = 0.5 * type(e).contact_diameter;
    const double to_a = e.length * b / (a + b);
    const double more = excess(to_a, a, shared_a ? HUGE_VAL : radius) +
                        excess(e.length - to_a, b, shared_b ? HUGE_VAL : radius);
    const bool of_volume = on_volume(i);
    Worst& worst = of_volume ? out.over_volumes : out.over_lines;
    double& largest = of_volume ? largest_over_volumes : largest_over_lines;
    const double sum = worst.excess + more;
    if (more > largest) {
      largest = more;
      const bool smooth = shared_a && shared_b;
      worst = {.arc = arc(line, i) + 0.5 * e.length,
               .time = time,
               .turn = a + b,
               .length = e.length,
               .recommended = smooth ? 0 : advice::kOfContactRadius * radius,
               .over_line = !of_volume};
    }
    worst.excess = sum;
  }
  return out;
}

// Two lines that press on each other share the length that both have in excess: with T the tension, d the
// excess and S = T dl/dT the compliance of each, both tensions change by the fraction sum(T d)/sum(T S),
// because the work of a displacement of their contact vanishes. Of several lines the one that presses most
// counts. If that is not held or slack, it yields to the excess.
void ElementErrors::update_over_lines(const std::vector<OverLines>& local,
                                      const std::vector<LineContact>& contacts) {
  std::map<std::pair<int, int>, double> forces;
  for (const LineContact& c : contacts) forces[{c.line, c.other}] += c.force;
  std::vector<LineContact> pairs;
  for (const auto& [pair, force] : forces) pairs.push_back({pair.first, pair.second, force});
  forces.clear();
  for (const LineContact& c : gather_all(comm_, pairs)) forces[{c.line, c.other}] += c.force;
  std::map<int, LineContact> pressing;      // by line
  for (const auto& [pair, force] : forces)  // other lines of one line in ascending order
    for (const auto& [line, other] : {pair, std::pair(pair.second, pair.first)}) {
      LineContact& most = pressing.try_emplace(line, LineContact{line, other, force}).first->second;
      if (force > (1 + kEqual) * most.force) most = {line, other, force};
    }
  std::map<int, OverLines> lines;
  for (const OverLines& l : gather_all(comm_, local)) lines[l.line] = l;
  for (OverLines l : local) {
    const auto by = pressing.find(l.line);
    if (by == pressing.end()) continue;
    const auto at = lines.find(by->second.other);
    if (at == lines.end() || !(at->second.tension > 0)) continue;
    const OverLines o = at->first == l.line ? OverLines() : at->second;  // a line that touches itself
    const double work = l.tension * l.compliance + o.tension * o.compliance;
    const double own = l.tension * l.corner.excess / work;
    if (!(own > kRecommendedError)) continue;  // its elements are short enough
    l.corner.own_error = l.tension * own;
    l.corner.error = l.tension * (own + o.tension * o.corner.excess / work);
    Worst& worst = lines_[l.line].corner;
    if (l.corner.error > worst.error) worst = l.corner;
  }
}

// Above the liftoff point the static tension of a cable grows by its submerged weight times the height. An
// element with one end on the bed assigns half its weight to each end, wherever the line leaves the bed
// between them; two elements further on the tension has the whole error.
void ElementErrors::update_lifts(const InState& s, Worst& worst) const {
  const auto& [line, nodes, elements, first, last, time] = s;
  if (!case_.lines[&line - mesh_.mesh->lines.data()].loads.empty()) return;
  for (int n = first; n <= last; ++n) {
    // Friction of a volume or line changes the tension, and a bend over them is no touchdown.
    if (!nodes[n].supported || nodes[n].pressed) continue;
    for (const int side : {-1, 1}) {
      if (n + 2 * side < first || n + 2 * side > last) continue;
      if (nodes[n + side].supported || nodes[n + 2 * side].supported) continue;
      const int i = side > 0 ? n : n - 1;
      const Element& next = elements[i];
      const Element& after = elements[i + side];
      if (next.beam || after.beam || next.type != after.type) continue;
      if (nodes[n + side].two_sided) continue;
      const double weight =
          case_.environment.gravity * advice::mass_in_water(case_, type(next), nodes[n].x.z());
      // Nodal tension is the mean of the adjacent elements. The tension of the hanging elements follows from
      // the upper node, and from it that of the elements below and of the one on the bed.
      const At& lies = nodes[n];
      const At& low = nodes[n + side];
      const At& high = nodes[n + 2 * side];
      const double hanging = high.tension - 0.5 * weight * (high.x.z() - low.x.z());
      const double leaving = 2 * low.tension - hanging;
      const double lying = std::max(2 * lies.tension - leaving, 0.0);
      const double error = std::abs(high.tension - lying - weight * (high.x.z() - lies.x.z()));
      if (error > worst.error)
        worst = {.error = error, .arc = arc(line, n), .time = time, .length = next.length, .weight = weight};
    }
  }
}

// At a support, clamp or attachment the moment of a beam under tension has a peak that decays like
// exp(-s/decay), decay = sqrt(EI/T), to both sides. In a smooth bend there is no peak, but where a volume
// begins to bend the line the moment changes its slope within an element.
void ElementErrors::update_bends(const InState& s, OfLine& of_line) const {
  const auto& [line, nodes, elements, first, last, time] = s;
  const bool held = of_line.held && volumes_are_held_;
  Worst& worst = of_line.bend;
  for (int n = first; n <= last; ++n) {
    const At& values = nodes[n];
    if (values.moment <= worst.error || !(values.tension > 0)) continue;
    const bool at_end = n == first || n == last || values.two_sided;
    Worst smallest{.error = HUGE_VAL};  // over both sides
    Worst liftoff;
    bool continues = false;  // the line is on the volume on one side
    for (const int side : {-1, 1}) {
      const int i = side < 0 ? n - 1 : n;
      if (i < first || i >= last) continue;
      const Element& e = elements[i];
      const bool on_volume = values.on_volume && nodes[n + side].on_volume;
      const double decay = std::sqrt(std::max(type(e).EI2, type(e).EI3) / values.tension);
      const double x = e.length / decay;
      const bool falls = e.beam && nodes[n + side].moment < values.moment * std::exp(-0.5 * std::min(x, 1.0));
      const double error = falls ? values.moment * (at_end ? wrong_at_end(x) : wrong_inside(x)) : 0;
      Worst of_side{.error = error, .arc = arc(line, n), .time = time, .length = e.length, .decay = decay};
      of_side.held = values.on_volume && x > kLongAtLiftoff && held;
      of_side.recommended = decay * (at_end ? kRecommendedAtEnd : kRecommendedInside);
      if (error < smallest.error) smallest = of_side;
      if (!falls && on_volume) continues = true;
      if (!falls || !values.on_volume || at_end || x <= kLongAtLiftoff) continue;
      liftoff = of_side;
      liftoff.error = values.moment * wrong_at_liftoff(x);
      liftoff.recommended = decay * kRecommendedAtLiftoff;
    }
    if (smallest.error > worst.error && smallest.error < HUGE_VAL) worst = smallest;
    if (continues && liftoff.error > worst.error) worst = liftoff;
  }
}

std::vector<std::string> ElementErrors::warnings(int line, double largest_tension,
                                                 double largest_moment) const {
  const std::string name = mesh_.mesh->line_names[line];
  auto [held, sag, corner, bend, lift] = lines_[line];
  std::vector<std::string> out;
  if (sag.error > kWarned * largest_tension) {
    sag.recommended = sag.length * std::sqrt(kRecommendedError * largest_tension / sag.error);
    out.push_back(advice::sags_between_nodes(name, sag, largest_tension));
  }
  const double fraction = kRecommendedError * largest_tension / corner.own_error;
  if (corner.error > kWarned * largest_tension && fraction < 1) {
    // Over a sharp edge the excess is proportional to the length, on a smooth bend to its square.
    corner.recommended = corner.recommended > 0 ? std::max(corner.length * fraction, corner.recommended)
                                                : corner.length * std::sqrt(fraction);
    out.push_back(advice::longer_over_contact(name, corner, largest_tension));
  }
  // The error is at most half an element's weight; a larger one has another cause.
  lift.recommended = lift.weight > 0 ? 2 * kRecommendedError * largest_tension / lift.weight : HUGE_VAL;
  if (lift.error > kWarned * largest_tension && lift.recommended < lift.length)
    out.push_back(advice::leaves_bed_within(name, lift, largest_tension));
  if (bend.error > kWarned * largest_moment)
    out.push_back(advice::moment_between_nodes(name, bend, largest_moment));
  return out;
}

}  // namespace hawser::record

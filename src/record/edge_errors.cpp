// The class EdgeErrors: tangential components of contact forces on cables, summed along each line.
#include "hawser/record/edge_errors.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "hawser/base/mpi.hpp"
#include "hawser/math/angle_between.hpp"
#include "hawser/record/line_extremes.hpp"

namespace hawser::record {
namespace {

constexpr double kAllowed = 0.005;  // of the tension
constexpr double kAllowedOverLines = 0.02;
constexpr double kInside = 0.3;     // fraction of errors within the contact that counts
constexpr double kLeft = 0.0025;    // error of elements of the recommended length
constexpr double kEvenly = 0.5;     // of a turn: with both neighbours above it the line follows a smooth bend
constexpr double kWide = 0.8;       // rad, turn of a beam within elements of length sqrt(EI/T)
constexpr double kStraight = 1e-4;  // rad

constexpr int kTag = 75;

double allowed(bool over_line) { return over_line ? kAllowedOverLines : kAllowed; }

// N, contact force at a node without friction.
Vec3 normal_force(std::span<const double> force, std::span<const double> friction, size_t n) {
  if (force.empty()) return Vec3::Zero();
  return Eigen::Map<const Vec3>(force.data() + 3 * n) - Eigen::Map<const Vec3>(friction.data() + 3 * n);
}

// True if elements without bending stiffness of the line may have contact.
bool is_cable_in_contact(const model::Case& c, const model::Line& line) {
  const auto is_cable = [&](const model::Section& s) {
    return c.line_type(s.type).kind != model::LineKind::beam;
  };
  return c.contact.takes_part(line) && std::any_of(line.sections.begin(), line.sections.end(), is_cable);
}

}  // namespace

EdgeErrors::EdgeErrors(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh)
    : comm_(comm),
      case_(c),
      mesh_(mesh),
      neighbours_(static_cast<size_t>(mesh.owned)),
      lines_(mesh),
      passages_(mesh, {0, -HUGE_VAL}) {
  const int rank = rank_of(comm);
  const std::span<const NodeRanks::Run> owners = mesh.owner.runs();
  for (const int l : lines_.lines()) {
    if (!is_cable_in_contact(c, c.lines[l])) continue;
    const LineSpan& line = mesh.mesh->lines[l];
    const int end = line.first_node + line.nodes;
    const auto first = static_cast<int>(pieces_.size());
    std::set<int> others;
    for (size_t r = mesh.owner.run_of(line.first_node); r < owners.size() && owners[r].first < end; ++r) {
      if (owners[r].rank != rank) others.insert(owners[r].rank);
      pieces_.push_back({l, owners[r].rank, std::max(line.first_node, owners[r].first),
                         std::min(end, mesh.owner.end(r)) - 1});
    }
    for (int i = first; i < static_cast<int>(pieces_.size()); ++i) {
      if (const int owner = pieces_[i].rank; owner != rank)
        shared_[owner].receive.push_back(i);
      else
        for (const int other : others) shared_[other].send.push_back(i);
    }
  }
  const auto has_pieces = [this](int line) {
    const auto at = std::lower_bound(pieces_.begin(), pieces_.end(), line,
                                     [](const NodesOfLine& p, int l) { return p.line < l; });
    return at != pieces_.end() && at->line == line;
  };
  for (const LocalElement& l : mesh.elements) {
    const Element& e = mesh.element(l);
    if (e.beam || !has_pieces(e.line)) continue;
    const auto add = [&](int node, int Neighbours::*side, int other) {
      if (node >= mesh.owned) return;
      Neighbours& n = neighbours_[node];
      n.*side = other;
      n.length = std::max(n.length, e.length);
    };
    add(l.first, &Neighbours::after, l.second);
    add(l.second, &Neighbours::before, l.first);
  }
}

// Without friction contact forces are normal to a sliding line. On the straight elements of a cable they are
// normal to each element and therefore have a tangential component at a node where the line turns: with t the
// mean of both directions, (T_after - T_before) cos(angle/2) + F.t = 0. A surface that supports a line end-on
// has such a component as well; it is limited to what a turn can cause. In an impact the part that
// may accelerate the node is excluded.
std::vector<PressedTurn> EdgeErrors::turns(const Kinematics& state, const Values& v) const {
  std::vector<PressedTurn> out;
  for (size_t n = 0; n < neighbours_.size(); ++n) {
    const Neighbours& beside = neighbours_[n];
    if (beside.before < 0 || beside.after < 0) continue;
    const Vec3 of_volumes = normal_force(v.force, v.friction, n);
    const Vec3 of_lines = normal_force(v.line_force, v.line_friction, n);
    const Vec3 F = of_volumes + of_lines;
    if (F.isZero(0)) continue;
    const Vec3 a = (state.x[n] - state.x[beside.before]).normalized();
    const Vec3 b = (state.x[beside.after] - state.x[n]).normalized();
    const double angle = angle_between(a, b);
    const double tension = std::max({v.before[n], v.after[n], 0.0});
    const double limit = tension * (1 - std::cos(angle));
    const Vec3 along = (a + b).normalized();
    const int node = mesh_.global[n];
    const double mass_per_length = type_at(node).mass_per_length;
    const double inertia = state.moves() ? mass_per_length * beside.length * state.a[n].norm() : 0;
    const double tangential = std::max(std::abs(F.dot(along)) - inertia, 0.0);
    const double tension_change =
        angle > kStraight
            ? std::copysign(std::min(tangential / std::max(std::cos(0.5 * angle), 1e-3), limit), F.dot(along))
            : 0;
    const double transverse_transit_time =
        tension > 0 && !of_volumes.isZero(0) ? beside.length * std::sqrt(mass_per_length / tension) : 0;
    out.push_back({node, angle, tension_change, tension, beside.length, transverse_transit_time,
                   of_lines.squaredNorm() > of_volumes.squaredNorm()});
  }
  return out;
}

const model::LineType& EdgeErrors::type_at(int node) const {
  const LineSpan& line = mesh_.mesh->lines[mesh_.mesh->node(node).line];
  return case_.line_types[mesh_.mesh->element(line.first_element + node - line.first_node).type];
}

void EdgeErrors::update(const Kinematics& state, const Values& values) {
  std::vector<PressedPart> of_pieces(pieces_.size());
  size_t piece = 0;
  for (const PressedTurn& turn : turns(state, values)) {
    while (pieces_[piece].last < turn.node) ++piece;
    of_pieces[piece] = joined(of_pieces[piece], PressedPart(turn));
  }
  for (size_t i = 0; i < pieces_.size(); ++i) {
    const NodesOfLine& p = pieces_[i];
    if (p.rank != rank_of(comm_)) continue;
    const auto from = static_cast<size_t>(mesh_.find(p.first));
    const size_t to = from + static_cast<size_t>(p.last - p.first) + 1;
    for (size_t n = from; n < to; ++n)
      of_pieces[i].tension = std::max({of_pieces[i].tension, values.before[n], values.after[n]});
  }
  exchange<PressedPart>(
      comm_, kTag, shared_, [&](int i) { return of_pieces[i]; },
      [&](int i, const PressedPart& part) { of_pieces[i] = part; });
  for (size_t i = 0; i < pieces_.size();) {
    const int line = pieces_[i].line;
    PressedPart of_line;
    for (; i < pieces_.size() && pieces_[i].line == line; ++i) of_line = joined(of_line, of_pieces[i]);
    lines_[line].tension = std::max(lines_[line].tension, of_line.tension);
    if (!of_line.pressed) continue;
    update_worst(line, of_line, state.time);
  }
}

// The tensions on both sides of a contact differ by the sum over the nodes between them. Within the contact
// errors alternate between elements, and only a fraction counts.
void EdgeErrors::update_worst(int line, const PressedPart& of_line, double time) {
  OfLine& w = lines_[line];
  if (of_line.transverse_transit_time > 0) passages_[line] = {of_line.transverse_transit_time, time};
  SumRange inside = of_line.inside;
  SumRange outside = of_line.outside;
  inside.add(0);
  outside.add(0);
  outside.add(of_line.sum);
  const double error = std::max(outside.width(), kInside * inside.width());
  const bool over_line = of_line.worst.over_line;
  if (!(error * allowed(w.at.over_line) > w.at.error * allowed(over_line))) return;
  const PressedTurn& worst_turn = of_line.worst;
  w.at = {.error = error,
          .arc = mesh_.mesh->node(worst_turn.node).arc,
          .time = time,
          .turn = worst_turn.angle,
          .length = worst_turn.length,
          .held = case_.holds_both_ends(case_.lines[line]),
          .over_line = over_line};
  w.turn_of_element = worst_turn.angle + std::max(of_line.before, of_line.after);
  const bool evenly = std::min(of_line.before, of_line.after) > kEvenly * worst_turn.angle;
  const double of_edge = advice::kOfContactRadius * 0.5 * type_at(worst_turn.node).contact_diameter;
  w.at.recommended = evenly || of_edge >= worst_turn.length
                         ? worst_turn.length * std::sqrt(kLeft * of_line.tension / error)
                         : of_edge;
  w.sharp_turn = evenly || over_line ? 0 : w.turn_of_element;
}

std::string EdgeErrors::warning(int line, double largest) const {
  return warning(mesh_.mesh->line_names[line], lines_[line], largest);
}

std::string EdgeErrors::warning(const std::string& name, const OfLine& w, double largest) {
  if (!exceeds(w, largest)) return {};
  const double turned = w.turn_of_element / kWide;
  return advice::turns_on_edge(name, w.at, largest,
                               largest * w.at.length * w.at.length * std::max(turned * turned, 0.25),
                               w.sharp_turn);
}

bool EdgeErrors::exceeds(const OfLine& w, double largest) {
  return w.at.error > allowed(w.at.over_line) * largest;
}

void EdgeErrors::declare(Declarations& to) {
  const auto needed = [&](const char* name) {
    to.every_step.insert(name);
    return find_field(to.contents.fields, name);
  };
  force_ = needed("contact_force");
  friction_ = needed("friction_force");
  line_force_ = needed("line_contact_force");
  line_friction_ = needed("line_friction_force");
  before_ = needed("effective_tension_before");
  after_ = needed("effective_tension_after");
}

void EdgeErrors::step(const Snapshot& s) {
  if (before_ < 0 || after_ < 0) return;
  update(s.at, {s.field(force_), s.field(friction_), s.field(before_), s.field(after_), s.field(line_force_),
                s.field(line_friction_)});
}

// One reduction for all lines.
void EdgeErrors::output(const Snapshot&) {
  struct Found {
    int line = 0;
    OfLine worst;
  };
  std::vector<Found> found;  // by the rank that owns the first node of a line
  for (const int line : lines_.lines()) {
    OfLine& w = lines_[line];
    if (w.reported || !exceeds(w, w.tension)) continue;
    w.reported = true;
    if (owns_line(mesh_, line)) found.push_back({line, w});
  }
  if (!on_any_rank(comm_, !found.empty())) return;
  std::vector<Found> all;
  GatherPlan(comm_, static_cast<int>(found.size())).gather_on_first(found.data(), all);
  std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.line < b.line; });
  for (const Found& f : all)
    new_warnings_.push_back(warning(mesh_.mesh->line_names[f.line], f.worst, f.worst.tension));
}

std::vector<std::string> EdgeErrors::remarks() { return std::exchange(new_warnings_, {}); }

std::vector<Warning> EdgeErrors::warnings(const std::vector<io::SummaryRow>& summary) {
  std::vector<Warning> out;
  for (size_t i = 0; i < summary.size(); ++i)
    if (const io::SummaryRow& r = summary[i]; is_largest_tension(case_, r))
      if (std::string text = warning(case_.line_index(r.line), r.value); !text.empty())
        out.push_back({std::move(text), i});
  return out;
}

}  // namespace hawser::record

// Start positions of every line from start_line.hpp, rotations with least twist along it, ties of the ends of
// lines (hold_ends), and start of floating bodies.
#include "hawser/solve/start_shape.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "hawser/advice/start_shape.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/solve/laid_places.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "start_crossings.hpp"
#include "start_line.hpp"
#include "start_share.hpp"

namespace hawser {
namespace {

using Surfaces = std::vector<std::shared_ptr<const Surface>>;

// Angle (rad) between a given direction and that of the shape, from which a note is written.
constexpr double kAgainst = 0.75 * M_PI;

// Computes missing tangents (of a slack end) from the positions of the neighbours.
void repair(LineStart& s) {
  for (size_t i = 0; i < s.x.size(); ++i) {
    if (s.tangent[i].norm() > 0) continue;
    const Vec3 d = s.x[std::min(i + 1, s.x.size() - 1)] - s.x[i > 0 ? i - 1 : 0];
    s.tangent[i] = d.norm() > 0 ? Vec3(d.normalized()) : Vec3::UnitX();
  }
}

// Axes with the first along t and the second horizontal.
Quat axes_along(const Vec3& t) {
  const Vec3 side = std::abs(t.z()) > 0.999 ? Vec3::UnitY() : Vec3::UnitZ();
  Mat3 m;
  m.col(0) = t;
  m.col(1) = (std::abs(t.z()) > 0.999 ? Vec3(side - side.dot(t) * t) : Vec3(side.cross(t))).normalized();
  m.col(2) = m.col(0).cross(m.col(1));
  return Quat(m);
}

bool rigid(const model::Case& c, const model::End& e) {
  return e.kind == model::EndKind::joint && c.joint(e.carrier).rigid;
}

// True if the line would go into the ground if its end at x, on the ground, had the direction opposite to
// this one.
bool opposite_is_below_ground(const model::Case& c, LineEnd line_end, const Vec3& x, const Vec3& given) {
  const model::Environment& e = c.environment;
  const double height = e.seabed.present  ? model::height_above_bed(e.seabed, x)
                        : e.water.present ? x.z() - (e.water.surface - e.water.depth)
                                          : HUGE_VAL;
  const double outwards = line_end == LineEnd::B ? -given.z() : given.z();
  return outwards > 0 && height < 1e-3 * std::abs(x.z() - e.water.surface);
}

// Adds a note if an end is clamped against the direction that the line would have there.
void warn_of_direction(const model::Case& c, const model::Line& line, LineEnd line_end, const Vec3& x,
                       const Vec3& unclamped, const Vec3& given, std::vector<std::string>& notes) {
  const double turn = std::acos(std::clamp(unclamped.dot(given), -1.0, 1.0));
  if (turn < kAgainst || opposite_is_below_ground(c, line_end, x, given)) return;
  notes.push_back(advice::against_direction(line, line_end, turn));
}

// Positions and tangents of a given line.
LineStart shape_of(const model::Case& c, const model::Line& line, const Bodies& bodies, const Mesh& g,
                   const LineSpan& span) {
  LineStart shape = line.end_a.feed || line.end_b.feed ? line_start_fed(c, line, bodies, g, span)
                    : line.starts_by_itself() && !line.buried.empty()
                        ? line_start_from_soil(c, line, bodies, g, span)
                        : line_start(c, line, bodies, g, span);
  repair(shape);
  if (line.starts_by_itself() && line.buried.empty()) lift(c.environment.seabed, shape);
  return shape;
}

// Sets the directions of clamped ends, and the axes of all nodes.
void turn(const model::Case& c, const model::Line& line, const Bodies& bodies, LineStart& shape,
          std::vector<std::string>& notes) {
  repair(shape);
  const auto clamp_direction = [&](LineEnd line_end) {
    const model::End& e = line.end(line_end);
    if (!(e.clamped || rigid(c, e)) || !e.direction) return;
    const Vec3 given = start_pose(c, bodies, e).rotation * e.direction->normalized();
    Vec3& tangent = line_end == LineEnd::B ? shape.tangent.back() : shape.tangent.front();
    if (line.starts_by_itself())
      warn_of_direction(c, line, line_end, line_end == LineEnd::B ? shape.x.back() : shape.x.front(),
                        tangent.normalized(), given, notes);
    tangent = given;
  };
  clamp_direction(LineEnd::A);
  clamp_direction(LineEnd::B);
  std::vector<Quat>& q = shape.q;
  if (q.empty()) {
    q.push_back(axes_along(shape.tangent[0]));
    for (size_t i = 1; i < shape.x.size(); ++i)
      q.push_back((minimal_rotation(shape.tangent[i - 1], shape.tangent[i]) * q.back()).normalized());
  } else {  // the tangent of a clamped end may have changed
    for (size_t i = 0; i < q.size(); ++i)
      q[i] = (minimal_rotation(q[i] * Vec3::UnitX(), shape.tangent[i]) * q[i]).normalized();
  }
}

// Shape of a part of a given line.
LineStart part_of(const StartedLine& started, const model::Line& line, int nodes) {
  LineStart shape = started.shape;
  const auto first = started.mesh->nearest_node(0, line.from);
  const auto last = first + nodes;
  const auto take = [&](auto& values) {
    values.erase(values.begin() + last, values.end());
    values.erase(values.begin(), values.begin() + first);
  };
  take(shape.x);
  take(shape.tangent);
  take(shape.q);
  return shape;
}

// Start shapes of the lines that this rank needs.
class Starts {
 public:
  // Collective.
  Starts(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, const Bodies& bodies,
         const Surfaces& surfaces)
      : comm_(comm),
        c_(c),
        mesh_(mesh),
        bodies_(bodies),
        lines_(model::given_lines(c)),
        at_(lines_.size(), -1) {
    std::vector<bool> required(lines_.size(), false);
    std::vector<int> line_of(c.lines.size());  // given line of each line
    for (size_t g = 0; g < lines_.size(); ++g)
      for (int l = lines_[g].first; l < lines_[g].first + lines_[g].parts; ++l)
        line_of[l] = static_cast<int>(g);
    for (int n = 0; n < mesh.nodes(); ++n)
      if (mesh.node(n).body < 0) required[line_of[mesh.node(n).line]] = true;
    for (size_t l = 0; l < c.lines.size(); ++l)  // all ranks have all feeders
      if (c.lines[l].end_a.feed || c.lines[l].end_b.feed) required[line_of[l]] = true;
    if (ranks_of(comm) > 1) required = with_groups(c, lines_, boxes(), required);
    on_each_rank(comm, [&] {
      for (size_t g = 0; g < lines_.size(); ++g)
        if (required[g]) begin(g);
    });
    std::sort(started_.begin(), started_.end(),
              [](const StartedLine& a, const StartedLine& b) { return a.number < b.number; });
    for (size_t k = 0; k < started_.size(); ++k) at_[line_of[started_[k].number]] = static_cast<int>(k);
    lay(surfaces);
  }

  std::vector<std::string> take_notes() { return std::move(notes_); }

  // Calls visit(line, shape) for each line whose shape is known, in the order of the case.
  template <class Visit>
  void each(const Visit& visit) {
    for (size_t g = 0; g < lines_.size(); ++g) {
      if (at_[g] < 0) continue;
      StartedLine& started = started_[at_[g]];
      for (size_t l = lines_[g].first, end = l + lines_[g].parts; l < end; ++l)
        visit(l, c_.lines[l].given ? part_of(started, c_.lines[l], mesh_.mesh->lines[l].nodes)
                                   : std::move(started.shape));
    }
  }

 private:
  // Computes the start shape of a given line unless that has been done.
  void begin(size_t g) {
    if (at_[g] >= 0) return;
    const int first = lines_[g].first;
    const model::Line& line = c_.lines[first];
    StartedLine started{&line, mesh_.mesh, mesh_.mesh->lines[first], {}, first, owns_line(mesh_, first)};
    if (line.given) {
      model::Case alone;
      alone.line_types = c_.line_types;
      alone.lines = {*line.given};
      meshes_.push_back(build_mesh(alone));
      started.line = line.given.get();
      started.mesh = &meshes_.back();
      started.span = started.mesh->lines.front();
    }
    started.shape = shape_of(c_, *started.line, bodies_, *started.mesh, started.span);
    at_[g] = static_cast<int>(started_.size());
    started_.push_back(std::move(started));
  }

  // Box of each given line in plan, enlarged by the largest radius. Each rank computes the shapes of the
  // lines that it owns. Empty if the case has no contact between lines. Collective.
  std::vector<Box> boxes() {
    if (!c_.contact.between_lines.enabled) return {};
    double radius = 0;
    for (const model::LineType& t : c_.line_types) radius = std::max(radius, 0.5 * t.contact_diameter);
    std::vector<double> ends(4 * lines_.size(), -HUGE_VAL);  // -x, -y, x, y at the most
    on_each_rank(comm_, [&] {
      for (size_t g = 0; g < lines_.size(); ++g) {
        if (!owns_line(mesh_, lines_[g].first)) continue;
        begin(g);
        Box box;
        for (const Vec3& x : started_.back().shape.x) box.add(x);
        box = box.grown(radius);
        Eigen::Map<Eigen::Vector4d>(ends.data() + 4 * g) << -box.lo.head<2>(), box.hi.head<2>();
      }
    });
    all_reduce(comm_, MPI_MAX, ends);
    std::vector<Box> out;
    for (size_t g = 0; g < lines_.size(); ++g)
      out.push_back({Vec3(-ends[4 * g], -ends[4 * g + 1], 0), Vec3(ends[4 * g + 2], ends[4 * g + 3], 0)});
    return out;
  }

  // Raises lines over volumes and over each other, and sets the axes of their nodes. Collective.
  void lay(const Surfaces& surfaces) {
    constexpr int kMaxNotes = 3;
    std::vector<StartNote> volume_passages, over_lines, turned;
    on_each_rank(comm_, [&] {
      volume_passages = lay_over_volumes(c_, bodies_, surfaces, started_);
      over_lines = lay_over_each_other(c_, started_);
      for (StartedLine& started : started_) {
        std::vector<std::string> notes;
        turn(c_, *started.line, bodies_, started.shape, notes);
        for (std::string& n : notes)
          if (started.counted) turned.push_back({started.number, 0, std::move(n)});
      }
    });
    const auto add = [&](std::vector<StartNote> notes, int limit, std::string (*more)(size_t)) {
      FirstNotes first = first_notes(comm_, std::move(notes), limit);
      std::move(first.texts.begin(), first.texts.end(), std::back_inserter(notes_));
      if (first.more > 0) notes_.push_back(more(static_cast<size_t>(first.more)));
    };
    add(std::move(volume_passages), kMaxNotes, advice::more_start_over_volumes);
    add(std::move(over_lines), kMaxNotes, advice::more_start_over_lines);
    add(std::move(turned), std::numeric_limits<int>::max(), nullptr);
  }

  MPI_Comm comm_;
  const model::Case& c_;
  const LocalMesh& mesh_;
  const Bodies& bodies_;
  std::vector<model::GivenLine> lines_;
  std::vector<int> at_;  // of each given line: index into started_; -1: this rank does without its shape
  std::vector<StartedLine> started_;
  std::deque<Mesh> meshes_;  // of lines that are cut
  std::vector<std::string> notes_;
};

// The end at which the twist of a line of beams is held if neither end is clamped; a joint only if
// no other end is held.
std::optional<LineEnd> twist_end(const model::Case& c, const model::Line& line) {
  if (line.end_a.clamped || line.end_b.clamped || rigid(c, line.end_a) || rigid(c, line.end_b))
    return std::nullopt;
  const LineEnd first = line.end_a.kind == model::EndKind::joint ? LineEnd::B : LineEnd::A;
  for (const LineEnd end : {first, opposite(first)})
    if (line.end(end).kind != model::EndKind::free &&
        c.line_type(line.end_section(end).type).kind == model::LineKind::beam)
      return end;
  return std::nullopt;
}

// Ties the held ends of a line.
void hold_ends(const model::Case& c, const LocalMesh& mesh, size_t l, StartShape& out) {
  const Mesh& g = *mesh.mesh;
  const model::Line& line = c.lines[l];
  const model::Line& given = line.as_given();
  const LineSpan& span = g.lines[l];
  // The bed's friction holds a laid line whose ends are both free, but nothing holds its twist.
  if (given.end_a.kind == model::EndKind::free && given.end_b.kind == model::EndKind::free &&
      line.from == 0 && c.statics.enabled && model::laid_with_friction(c, given) &&
      g.node(span.first_node).rotates)
    if (const int local_node = mesh.find(span.first_node); local_node >= 0) {
      TiedNode s;
      s.position_mask = 0;
      s.rotation_mask = 1;
      s.node = local_node;
      out.tied.push_back(s);
    }
  const std::optional<LineEnd> twist = twist_end(c, given);
  for (const LineEnd end : kLineEnds) {
    const model::End& e = line.end(end);
    if (e.kind == model::EndKind::free) continue;
    const bool cut = e.kind == model::EndKind::joint && given.end(end).carrier != e.carrier;
    if (cut) continue;
    const int node = span.end_node(end);
    const bool joint = e.kind == model::EndKind::joint;
    if (const int local_node = mesh.find(node); joint && local_node >= 0)
      out.state.x[local_node] = e.at;  // exactly where the other ends at the joint are
    if (joint && (end != twist || !g.node(node).rotates)) continue;
    TiedNode s;
    if (joint) s.position_mask = 0;
    s.body = e.kind == model::EndKind::body ? c.body_index(e.carrier) : -1;
    s.at = e.at;
    if (const int frame = g.node(node).tied_to; frame >= 0 && c.floats(s.body)) {
      s.at -= c.bodies[s.body].mass->centre;
      s.body = -1;
      s.frame = mesh.find(frame);
    }
    if (g.node(node).rotates) {
      if (e.clamped) {
        s.rotation_mask = 7;
        s.rotation = out.ends[l][end_index(end)];
      } else if (end == twist) {
        s.rotation_mask = 1;
      }
    }
    if (const int local_node = mesh.find(node); local_node >= 0) {
      s.node = local_node;
      out.tied.push_back(s);
    }
  }
}

// Ties ends that follow a frame of the mesh: at rigid joints, and at joints that release an end.
void tie_to_joints(const model::Case& c, const LocalMesh& mesh, StartShape& out) {
  const Mesh& g = *mesh.mesh;
  for (int n = 0; n < mesh.nodes(); ++n) {
    const int global = mesh.global[n];
    const int frame = mesh.frame_of(n);
    if (frame < 0 || g.node(g.node(global).tied_to).body >= 0) continue;
    const Node& node = g.node(global);
    const LineSpan& span = g.lines[node.line];
    const model::Line& line = c.lines[node.line];
    TiedNode s;
    s.node = n;
    s.frame = frame;
    if (mesh.rotates(n) && mesh.rotates(frame) &&
        rigid(c, global == span.first_node ? line.end_a : line.end_b)) {
      s.rotation_mask = 7;
      s.rotation = out.state.q[frame].conjugate() * out.state.q[n];
    }
    out.tied.push_back(s);
  }
}

void start_bodies(const model::Case& c, const LocalMesh& mesh, const Bodies& bodies, State& state) {
  for (int n = 0; n < mesh.nodes(); ++n) {
    const int body = mesh.node(n).body;
    if (body < 0) continue;
    const RigidBodyState s = floating_start(*c.bodies[body].mass, bodies.pose(body, 0));
    state.x[n] = s.x;
    state.q[n] = s.q;
    state.v[n] = s.v;
    state.w[n] = s.w;
  }
}

}  // namespace

StartShape start_shape(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, const Bodies& bodies,
                       const Surfaces& surfaces) {
  const Mesh& g = *mesh.mesh;
  StartShape out;
  out.state = State(mesh.nodes());
  out.ends.assign(c.lines.size(), {Quat::Identity(), Quat::Identity()});
  Starts starts(comm, c, mesh, bodies, surfaces);
  out.notes = starts.take_notes();
  const bool with_bed = model::static_bed_friction(c);
  std::vector<std::vector<Vec3>> places(with_bed ? c.lines.size() : 0);  // by line
  starts.each([&](size_t l, LineStart shape) {
    const model::Line& line = c.lines[l];
    const LineSpan& span = g.lines[l];
    const std::vector<Quat>& q = shape.q;
    out.ends[l] = {start_pose(c, bodies, line.end_a).rotation.conjugate() * q.front(),
                   start_pose(c, bodies, line.end_b).rotation.conjugate() * q.back()};
    for (int i = 0; i < span.nodes; ++i) {
      const int local_node = mesh.find(span.first_node + i);
      if (local_node < 0) continue;
      const size_t n = local_node;
      const size_t k = i;
      out.state.x[n] = shape.x[k];
      if (mesh.rotates(local_node)) out.state.q[n] = q[k];
    }
    hold_ends(c, mesh, l, out);
    if (with_bed) places[l] = std::move(shape.x);
  });
  if (with_bed) {
    const std::vector<std::vector<Vec3>> laid = laid_places(c, g, places);
    out.any_laid = on_any_rank(comm, std::any_of(laid.begin(), laid.end(), [](const auto& line) {
                                 return !line.empty() && line.front().allFinite();
                               }));
    out.laid.assign(static_cast<size_t>(mesh.nodes()), Vec3::Zero());
    for (size_t l = 0; l < laid.size(); ++l)
      for (size_t i = 0; i < laid[l].size(); ++i)
        if (const int local_node = mesh.find(g.lines[l].first_node + static_cast<int>(i)); local_node >= 0)
          out.laid[local_node] = laid[l][i];
  }
  tie_to_joints(c, mesh, out);
  start_bodies(c, mesh, bodies, out.state);
  return out;
}

}  // namespace hawser

// The class Histories: nodes around each point, and rows of points and bodies.
#include "hawser/record/histories.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

#include "hawser/base/mpi.hpp"
#include "hawser/math/declination.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/terms/line_volume_contact.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser::record {
namespace {

const std::vector<io::ResultField> kBody = {{"position", "m", 3},
                                            {"rotation_vector", "rad", 3},
                                            {"roll", "rad", 1},
                                            {"pitch", "rad", 1},
                                            {"yaw", "rad", 1},
                                            {"velocity", "m/s", 3},
                                            {"angular_velocity", "rad/s", 3},
                                            {"acceleration", "m/s2", 3},
                                            {"angular_acceleration", "rad/s2", 3},
                                            {"force", "N", 3},
                                            {"moment", "N m", 3}};

const std::vector<io::ResultField> kVolume = {{"force", "N", 3}, {"moment", "N m", 3}};

// Points closer than this fraction of the line's length coincide.
constexpr double kSamePlace = 1e-9;

// Of the two rotation vectors of a rotation that are shorter than a full turn, the nearer to `start`.
Vec3 rotation_vector(const Quat& q, const Vec3& start) {
  const Vec3 shorter = log_so3(q);
  const double angle = shorter.norm();
  if (!(angle > 0)) return shorter;
  const Vec3 longer = (1 - 2 * M_PI / angle) * shorter;
  return (longer - start).norm() < (shorter - start).norm() ? longer : shorter;
}

// Roll, pitch and yaw of the rotation Rz(yaw) Ry(pitch) Rx(roll); yaw within half a turn of `start`.
Vec3 roll_pitch_yaw(const Quat& q, double start) {
  const Mat3 R = q.toRotationMatrix();
  const double yaw = std::atan2(R(1, 0), R(0, 0));
  return {std::atan2(R(2, 1), R(2, 2)), std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2))),
          start + std::remainder(yaw - start, 2 * M_PI)};
}

}  // namespace

void Histories::find_shown(const std::vector<Field>& fields) {
  for (size_t f = 0; f < fields.size(); ++f) {
    if (fields[f].history == Field::History::yes) shown_.push_back(f);
    if (fields[f].history == Field::History::after_end_columns) shown_last_.push_back(f);
  }
  section_ = SectionFields::find(fields);
}

Histories::Point Histories::body_history(const std::string& body, io::ResultSeries& series) const {
  Point p;
  p.body = subject_.model.body_index(body);
  series.columns = kBody;
  for (const std::string& component : load_components(p.body)) {
    series.columns.push_back({component + "_force", "N", 3});
    series.columns.push_back({component + "_moment", "N m", 3});
  }
  return p;
}

Histories::Point Histories::line_history(const model::HistoryPoint& history, Declarations& to,
                                         io::ResultSeries& series) const {
  const std::vector<io::ResultField>& fields = to.contents.fields;
  const int line = subject_.model.line_index(history.line);
  const LineSpan& span = subject_.mesh().lines[line];
  Point p = point_of(line, history.at);
  const double arc = std::clamp(history.at, 0.0, span.length);
  const bool at_end = std::min(arc, span.length - arc) <= kSamePlace * span.length;
  if (at_end && p.nodes[0] >= 0) p.end = ends_.end_at(p.nodes[0]);
  for (const Field& f : fields)
    if (f.history != Field::History::no) to.every_step.insert(f.name);
  std::vector<io::ResultField>& columns = series.columns;
  columns = {{"position", "m", 3}, {"velocity", "m/s", 3}};
  for (const size_t f : shown_) columns.push_back(fields[f]);
  if (at_end)
    for (const io::ResultField& f : to.contents.end_fields)
      columns.push_back({"end_" + f.name, f.unit, f.components});
  for (const size_t f : shown_last_) columns.push_back(fields[f]);
  columns.push_back({"acceleration", "m/s2", 3});
  if (at_end)
    for (const char* angle : {"end_declination", "end_azimuth"}) columns.push_back({angle, "deg", 1});
  return p;
}

void Histories::declare(Declarations& to) {
  find_shown(to.contents.fields);
  for (const auto& h : subject_.model.output.histories) {
    io::ResultSeries series{h.name, {}};
    Point& p = points_.emplace_back();
    if (!h.body.empty()) {
      p = body_history(h.body, series);
    } else if (!h.volume.empty()) {
      p.volume = h.volume;
      series.columns = kVolume;
    } else {
      p = line_history(h, to, series);
    }
    size_t& columns = columns_.emplace_back(0);
    for (const io::ResultField& f : series.columns) columns += static_cast<size_t>(f.components);
    to.contents.series.push_back(std::move(series));
  }
  std::vector<int> ranks;
  for (const Point& p : points_) ranks.push_back(p.nodes[0] >= 0 || p.nodes[1] >= 0);
  all_reduce(subject_.comm(), MPI_SUM, ranks);
  for (size_t i = 0; i < points_.size(); ++i) points_[i].shared = ranks[i] > 1 || !points_[i].volume.empty();
}

Histories::Point Histories::point_of(int line, double arc) const {
  const Mesh& mesh = subject_.mesh();
  const LineSpan& span = mesh.lines[line];
  const auto s = [&](int n) { return mesh.node(n).arc; };
  const double same = kSamePlace * span.length;
  // The last node at or before the point.
  const auto nodes = std::views::iota(span.first_node, span.first_node + span.nodes);
  const auto after = std::ranges::upper_bound(nodes, arc + same, {}, s);
  const int node = after == nodes.begin() ? span.first_node : *(after - 1);
  Point p;
  if (node != nodes.back() && arc > s(node) + same) {
    const double w = (arc - s(node)) / (s(node + 1) - s(node));
    p.weights = {1 - w, w};
  }
  const LocalMesh& local = subject_.local();
  for (size_t k = 0; k < 2; ++k) {
    if (p.weights[k] == 0) continue;
    const int n = local.find(node + static_cast<int>(k));
    if (!local.owns(n)) continue;
    p.nodes[k] = n;
    const auto& places = ends_.places();
    for (size_t i = 0; i < places.size(); ++i)
      if (places[i].node == n) p.places[k] = static_cast<int>(i);
  }
  return p;
}

double Histories::facing(int field, const SectionForce& s, const Quat& q, double fallback) const {
  const std::array<int, 5> of_beams = section_.of_beams();
  const bool known = field >= 0 && s.beam && std::ranges::find(of_beams, field) != of_beams.end();
  return known ? section_.value(field, s, q) : fallback;
}

// Contribution of node `side` of a point. Where section forces jump at a node the point is on one side of it.
std::vector<double> Histories::node_row(const Point& p, size_t side, const Snapshot& s) const {
  const Kinematics& at = s.at;
  const size_t n = p.nodes[side];
  const bool between = p.weights[1] > 0;
  const EndForces::SectionNode* place = p.places[side] >= 0 ? &ends_.places()[p.places[side]] : nullptr;
  const auto value_of = [&](int field) { return s.values[field][n]; };
  std::vector<double> row;
  const auto vector = [&](const auto& v) { row.insert(row.end(), v.begin(), v.end()); };
  const auto show = [&](const std::vector<size_t>& fields) {
    for (const size_t field : fields) {
      const int f = static_cast<int>(field);
      const int near = side == 0 ? section_.after : section_.before;
      if (between && (f == section_.tension || f == section_.before || f == section_.after))
        row.push_back(value_of(near));
      else if (between && f == section_.wall)
        row.push_back(value_of(section_.wall) + value_of(near) - value_of(section_.tension));
      else if (between && place)
        row.push_back(facing(f, place->sides[side == 0 ? 1 : 0], at.q[n], value_of(f)));
      else
        row.push_back(value_of(f));
    }
  };
  vector(at.x[n]);
  vector(at.v[n]);
  show(shown_);
  if (p.end >= 0)
    for (const auto& e : s.ends) vector(std::span(e).subspan(3 * static_cast<size_t>(p.end), 3));
  show(shown_last_);
  vector(at.a[n]);
  if (p.end >= 0) {
    const Vec3 along(s.ends[1].data() + 3 * p.end);
    row.push_back(degrees(declination(along)));
    row.push_back(degrees(std::atan2(along.y(), along.x())));
  }
  for (double& v : row) v *= p.weights[side];
  return row;
}

// Empty on ranks that own none of the nodes.
std::vector<double> Histories::line_row(const Point& p, const Snapshot& s) const {
  std::vector<double> row;
  for (size_t k = 0; k < 2; ++k) {
    if (p.nodes[k] < 0) continue;
    const std::vector<double> part = node_row(p, k, s);
    row.resize(part.size());
    for (size_t i = 0; i < part.size(); ++i) row[i] += part[i];
  }
  return row;
}

// "other" is the remainder of the total force: lines, their contact with the body, and links.
std::vector<std::string> Histories::load_components(int body) const {
  std::vector<std::string> out;
  if (!subject_.model.floats(body)) return out;
  for (const ReportsBodyForces* term : subject_.system.with<ReportsBodyForces>())
    for (std::string& component : term->load_components(body)) out.push_back(std::move(component));
  if (!out.empty()) out.push_back("other");
  return out;
}

// Empty on ranks that do not own the body.
std::vector<double> Histories::body_row(int body, const Snapshot& s) const {
  const Kinematics& at = s.at;
  const auto p = body_pose(subject_.bodies, subject_.local(), body, at);
  const int rank = rank_of(subject_.comm());
  if (!p || (!subject_.bodies.floats(body) && rank != 0)) return {};
  std::array<Vec3, 2> force{Vec3::Zero(), Vec3::Zero()};
  if (const auto* floating = subject_.term<RigidBodies>(); floating && subject_.model.floats(body))
    force = floating->force_on(body, at);
  std::vector<double> row;
  const model::Body& b = subject_.model.bodies[static_cast<size_t>(body)];
  for (const Vec3& x :
       {p->position, rotation_vector(p->rotation, b.rotation), roll_pitch_yaw(p->rotation, model::heading(b)),
        p->velocity, p->angular_velocity, p->acceleration, p->angular_acceleration, force[0], force[1]})
    row.insert(row.end(), x.begin(), x.end());
  if (!subject_.model.floats(body)) return row;
  const auto add = [&row](const BodyForce& f) {
    row.insert(row.end(), f.force.begin(), f.force.end());
    row.insert(row.end(), f.moment.begin(), f.moment.end());
  };
  BodyForce other{force[0], force[1]};
  const size_t motion = row.size();
  for (const ReportsBodyForces* term : subject_.system.with<ReportsBodyForces>())
    for (const BodyForce& f : term->forces_on(body, at)) {
      add(f);
      other.force -= f.force;
      other.moment -= f.moment;
    }
  if (row.size() > motion) add(other);
  return row;
}

// Part of this rank.
std::vector<double> Histories::volume_row(const std::string& volume, const Kinematics& state) const {
  std::array<Vec3, 2> sum{Vec3::Zero(), Vec3::Zero()};
  const LineVolumeContact* contact = subject_.term<LineVolumeContact>();
  for (int v = 0; contact && v < contact->volumes(); ++v)
    if (contact->volume_name(v) == volume) sum = contact->reaction(v, state);
  std::vector<double> row;
  for (const Vec3& x : sum) row.insert(row.end(), x.begin(), x.end());
  return row;
}

void Histories::rows(const Snapshot& s, Rows& to) {
  for (size_t i = 0; i < points_.size(); ++i) {
    const Point& p = points_[i];
    std::vector<double> row = p.body >= 0        ? body_row(p.body, s)
                              : p.volume.empty() ? line_row(p, s)
                                                 : volume_row(p.volume, s.at);
    if (!p.shared) {
      to.add(std::move(row));
      continue;
    }
    row.resize(columns_[i], 0.0);
    to.add_part(std::move(row));
  }
}

}  // namespace hawser::record

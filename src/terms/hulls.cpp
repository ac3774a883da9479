// The class Hulls: hull surfaces from the volumes of the case, sea pressure on them, its work and potential.
#include "hawser/terms/hulls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "hawser/geometry/mesh_split.hpp"
#include "hawser/geometry/primitives.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {
namespace {

// The head is linear along edges. An edge of length L underestimates the mean head of a wave of wave number k
// by (k L)²/12, which is 0.2 % if the wave is this many edges long.
constexpr double kEdgesInWave = 40;
constexpr std::size_t kMostTriangles = 200000;

// Mean wave number, weighted by energy, 1/m.
double mean_number(const WaveField& waves) {
  double sum = 0, energy = 0;
  for (const WaveComponent& c : waves.components()) {
    sum += c.amplitude * c.amplitude * c.number;
    energy += c.amplitude * c.amplitude;
  }
  return energy > 0 ? sum / energy : 0;
}

}  // namespace

HullSurface hull_surface(const model::Case& c, int body, const VolumeFacets& facets, double longest) {
  const model::BodyMass& m = *c.bodies[body].mass;
  HullSurface out;
  for (const std::string& name : m.hull->volumes) {
    const auto has_name = [&name](const model::Volume& v) { return v.name == name; };
    const size_t v =
        static_cast<size_t>(std::find_if(c.volumes.begin(), c.volumes.end(), has_name) - c.volumes.begin());
    if (v >= facets.size()) throw std::logic_error("a hull without the triangles of its volumes");
    TriangleMesh mesh = c.volumes[v].shape ? facets_of_volume(*c.volumes[v].shape) : facets[v]->copy();
    split_edges(mesh, longest, kMostTriangles);
    const int first = static_cast<int>(out.corners.size());
    for (const Vec3& corner : mesh.vertices) out.corners.push_back(corner - m.centre);
    for (const auto& t : mesh.triangles) out.add({first + t[0], first + t[1], first + t[2]});
  }
  return out;
}

Hulls::Hulls(const model::Case& c, const LocalMesh& mesh, const VolumeFacets& facets)
    : sea_(sea_of(c)), load_components_(c.bodies.size()) {
  const double number = mean_number(sea_.waves);
  for (size_t b = 0; b < c.bodies.size(); ++b)
    if (c.bodies[b].mass && c.bodies[b].mass->hull) {
      load_components_[b] = {"buoyancy"};
      if (number > 0 && c.bodies[b].mass->hull->wave_pressure) load_components_[b].push_back("froude_krylov");
    }
  for (int n = 0; n < mesh.owned; ++n) {
    const int global = mesh.global[n];
    const int body = mesh.mesh->node(global).body;
    if (body < 0 || load_components_[static_cast<size_t>(body)].empty()) continue;
    Hull& hull = list_.emplace_back();
    hull.in_waves = load_components_[static_cast<size_t>(body)].size() > 1;
    const double longest = hull.in_waves ? 2 * M_PI / (kEdgesInWave * number) : HUGE_VAL;
    hull.surface = hull_surface(c, body, facets, longest);
    hull.node = n;
    hull.block = mesh.block[n];
    hull.global = global;
    hull.body = body;
    constexpr double kDeep = 1e6;  // m
    const double volume = displaced_volumes(hull.surface, kDeep, {}).x();
    hull.full_buoyancy = sea_.density * sea_.gravity * volume;
  }
}

const std::vector<double>& Hulls::heads(const Hull& hull, const Kinematics& state) const {
  if (hull.known && hull.time == state.time) return hull.heads;
  const double since = state.time - start_time_;
  const RigidBodyState& s = hull.start;
  const Vec3 centre = s.x + since * s.v;
  const Mat3 R = (s.q * exp_so3(since * s.w)).toRotationMatrix();
  hull.heads.resize(hull.surface.corners.size());
  for (size_t i = 0; i < hull.heads.size(); ++i)
    hull.heads[i] = sea_.wave_head(centre + R * hull.surface.corners[i], state.time);
  hull.time = state.time;
  hull.known = true;
  return hull.heads;
}

HullPressure Hulls::pressure(const Hull& hull, const Kinematics& state, bool waves, bool tangent) const {
  std::span<const double> now;
  if (waves && hull.in_waves && state.moves()) now = heads(hull, state);
  return hull_pressure(hull.surface, sea_.density * sea_.gravity, sea_.surface, now,
                       floating_state(state, hull.node), tangent);
}

// Commit, energy and outputs need the forces of the same accepted state, so the last result is kept.
const Hulls::Forces& Hulls::forces(const Hull& hull, const Kinematics& state) const {
  const RigidBodyState s = floating_state(state, hull.node);
  Forces& known = hull.forces;
  if (known.time == state.time && known.phase == state.phase && known.step == state.step && known.x == s.x &&
      known.q.coeffs() == s.q.coeffs())
    return known;
  known = {state.time, state.step, state.phase, s.x, s.q, pressure(hull, state, false, false), {}};
  if (!hull.in_waves || !state.moves()) return known;
  const Vec6 f = known.still_water.f - pressure(hull, state, true, false).f;
  known.waves = {f.head<3>(), s.q * f.tail<3>()};
  return known;
}

void Hulls::prepare(const Kinematics& from, double) {
  start_time_ = from.time;
  for (Hull& hull : list_) {
    hull.start = floating_state(from, hull.node);
    hull.known = false;
    hull.forces = {};
    // At the start of the motion waves start to act.
    if (hull.has_waves && from.ends_step()) continue;
    hull.waves = forces(hull, from).waves;
    hull.has_waves = true;
  }
}

void Hulls::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Hull& hull : list_) {
    const HullPressure p = pressure(hull, trial, true, assembler.needs_tangent());
    const int blocks[2] = {hull.block, hull.block + 1};
    assembler.add(blocks, p.f, p.K);
  }
}

void Hulls::commit(const Kinematics& accepted) {
  for (Hull& hull : list_) {
    const RigidBodyState s = floating_state(accepted, hull.node);
    const BodyForce now = forces(hull, accepted).waves;
    if (accepted.moves() && hull.has_waves)
      hull.work += 0.5 * ((now.force + hull.waves.force).dot(s.x - hull.start.x) +
                          (now.moment + hull.waves.moment).dot(log_so3(s.q * hull.start.q.conjugate())));
    hull.waves = now;
    hull.has_waves = true;
  }
  start_time_ = accepted.time;
}

Energy Hulls::energy(const Kinematics& state) const {
  Energy e;
  for (const Hull& hull : list_) {
    e.work += hull.work;
    e.by_water += hull.work;
    e.potential += forces(hull, state).still_water.potential;
  }
  return e;
}

double Hulls::dead_load() const {
  double sum = 0;
  for (const Hull& hull : list_) sum += hull.full_buoyancy;
  return sum;
}

// Round-off of a sum over the triangles, each with a pressure force of at most the full buoyancy.
double Hulls::round_off(const Kinematics&, double) const {
  const double eps = std::numeric_limits<double>::epsilon();
  double sum = 0;
  for (const Hull& hull : list_)
    sum += std::pow(eps * hull.full_buoyancy, 2) * static_cast<double>(hull.surface.triangles.size());
  return sum;
}

std::vector<std::string> Hulls::load_components(int body) const {
  return load_components_[static_cast<size_t>(body)];
}

std::vector<BodyForce> Hulls::forces_on(int body, const Kinematics& state) const {
  for (const Hull& hull : list_) {
    if (hull.body != body) continue;
    const RigidBodyState s = floating_state(state, hull.node);
    const Forces& now = forces(hull, state);
    std::vector<BodyForce> out = {{-now.still_water.f.head<3>(), -(s.q * now.still_water.f.tail<3>())}};
    if (hull.in_waves) out.push_back(now.waves);
    return out;
  }
  return {};
}

namespace {

struct Kept {
  double work = 0;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("work", "J", self.work);
    each("force of waves", "N", self.force);
    each("moment of waves", "N m", self.moment);
  }
};

}  // namespace

std::vector<CheckpointKind> Hulls::checkpoint_kinds() const {
  return {checkpoint_kind<Kept>("hull in water")};
}

std::vector<CheckpointRecord> Hulls::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (const Hull& hull : list_)
    if (range.has(hull.global))
      out.push_back(record_of(hull.global, 0, Kept{hull.work, hull.waves.force, hull.waves.moment}));
  return out;
}

void Hulls::restore(const std::vector<CheckpointRecord>& records) {
  for (Hull& hull : list_) {
    hull.work = 0;
    hull.known = hull.has_waves = false;
    const auto kept = find_entry<Kept>(records, hull.global);
    if (!kept) continue;
    hull.work = kept->work;
    hull.waves = {kept->force, kept->moment};
    hull.has_waves = true;
  }
}

}  // namespace hawser

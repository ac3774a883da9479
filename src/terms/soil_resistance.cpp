// The class SoilResistance: soil resistance at each buried node of a line, force and tangent, stored energy
// and friction work, output field and checkpoint. The soil law is in kernels/buried_soil.hpp.
#include "hawser/terms/soil_resistance.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "hawser/base/mpi.hpp"

namespace hawser {
namespace {

// Angle [rad] between the directions of the springs and the line at which statics stops. It changes a force
// by this fraction, which is the tolerance of statics.
constexpr double kTurned = 1e-8;

// Sums the soil springs of the buried parts of the half elements at each owned node.
std::vector<SoilResistance::BuriedNode> places_of(const LocalMesh& mesh, const model::Case& c,
                                                  const std::vector<int>& held) {
  std::vector<BuriedSoil> soil(static_cast<size_t>(mesh.owned));
  std::vector<double> length(soil.size(), 0);
  for (const LocalElement& e : mesh.elements) {
    const Element& g = mesh.element(e);
    const model::Line& line = c.lines[g.line];
    const double from = mesh.mesh->node(g.first).arc;
    const double half = 0.5 * g.length;
    for (const bool second : {false, true}) {
      const int node = second ? e.second : e.first;
      if (node >= mesh.owned) continue;
      for (const model::Buried& b : line.buried) {
        const double start = from + (second ? half : 0);
        const double overlap = std::min(start + half, b.to) - std::max(start, b.from);
        if (!(overlap > 0)) continue;
        soil[node].axial += overlap * b.axial;
        soil[node].normal += overlap * b.normal;
        soil[node].axial_length += overlap * b.axial_length;
        soil[node].normal_length += overlap * b.normal_length;
        length[node] += overlap;
      }
    }
  }
  for (const int n : held)
    if (n < mesh.owned) length[n] = 0;
  std::vector<SoilResistance::BuriedNode> out;
  for (size_t n = 0; n < soil.size(); ++n) {
    if (!(length[n] > 0)) continue;
    soil[n].axial_length /= length[n];
    soil[n].normal_length /= length[n];
    out.push_back({static_cast<int>(n), soil[n]});
  }
  return out;
}

}  // namespace

double buried_length(const model::Line& line, double from, double to) {
  double buried = 0;
  for (const model::Buried& b : line.buried)
    buried += std::max(0.0, std::min(to, b.to) - std::max(from, b.from));
  return buried;
}

SoilResistance::SoilResistance(MPI_Comm comm, const LocalMesh& mesh, const Kinematics& start,
                               std::vector<BuriedNode> places)
    : comm_(comm), mesh_(mesh), line_(mesh) {
  for (const BuriedNode& place : places) {
    Point& p = points_.emplace_back();
    p.node = place.node;
    p.block = mesh.block[place.node];
    p.soil = place.soil;
    p.at = start.x[place.node];
  }
  turn_to(start);
}

SoilResistance::SoilResistance(MPI_Comm comm, const LocalMesh& mesh, const model::Case& c,
                               const Kinematics& start, const std::vector<int>& held)
    : SoilResistance(comm, mesh, start, places_of(mesh, c, held)) {}

void SoilResistance::prepare(const Kinematics& from, double h) {
  if (h > 0) turn_to(from);
}

double SoilResistance::turn_to(const Kinematics& state, double fraction) {
  double largest = 0;
  for (Point& p : points_) {
    const Vec3 now = line_.tangent(state, p.node);
    const Vec3 turn = now - p.tangent;
    // Assigned directly for a full turn, so that the result does not depend on the old direction.
    p.tangent = fraction < 1 ? Vec3((p.tangent + fraction * turn).normalized()) : now;
    largest = std::max(largest, turn.norm());
  }
  return largest;
}

// If the line turns back with its springs, so that the turn decreases by less than a quarter of what was
// expected, the next turns are half as large.
bool SoilResistance::adapt_stiffness(const Kinematics& equilibrium) {
  if (equilibrium.moves()) return false;
  double turn = turn_to(equilibrium, turn_fraction_);
  all_reduce(comm_, MPI_MAX, turn);
  if (!(turn <= (1 - 0.25 * turn_fraction_) * turn_)) turn_fraction_ *= 0.5;
  turn_ = turn;
  return turn > kTurned;
}

void SoilResistance::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Point& p : points_) {
    const BuriedForce s = pull(p, trial);
    assembler.add(p.block, -s.force, &s.stiffness);
  }
}

// The work of the trapezoidal rule that the springs do not store is friction work.
void SoilResistance::commit(const Kinematics& accepted) {
  for (Point& p : points_) {
    const BuriedForce s = pull(p, accepted);
    const Vec3& x = accepted.x[p.node];
    if (accepted.moves()) p.friction_work -= 0.5 * (s.force + p.force).dot(x - p.at) + (s.stored - p.stored);
    p.at = x;
    p.slip = s.slip;
    p.force = s.force;
    p.stored = s.stored;
  }
  turn_fraction_ = 1;
  turn_ = HUGE_VAL;
  if (!accepted.moves()) turn_to(accepted);  // statics with friction commits its phases
}

// In statics the energy of the trial, which the line search reduces.
Energy SoilResistance::energy(const Kinematics& state) const {
  Energy e;
  for (const Point& p : points_) {
    e.friction += p.friction_work;
    e.strain += state.ends_step() ? p.stored : pull(p, state).potential;
  }
  return e;
}

void SoilResistance::fields(FieldRegistry& registry) const {
  registry.add({{.name = "soil_force", .unit = "N", .components = 3, .is_support_force = true},
                [this](const Kinematics&, std::span<double> out) {
                  std::fill(out.begin(), out.end(), 0.0);
                  for (const Point& p : points_)
                    for (int c = 0; c < 3; ++c) out[3 * p.node + c] = p.force[c];
                }});
}

std::vector<CheckpointKind> SoilResistance::checkpoint_kinds() const {
  return {checkpoint_kind<Point>("points")};
}

std::vector<CheckpointRecord> SoilResistance::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> records;
  for (const Point& p : points_)
    if (range.has(mesh_.global[p.node])) records.push_back(record_of(mesh_.global[p.node], 0, p));
  return records;
}

void SoilResistance::restore(const std::vector<CheckpointRecord>& records) {
  std::unordered_map<int, size_t> at;
  for (size_t i = 0; i < points_.size(); ++i) at[mesh_.global[points_[i].node]] = i;
  for (const CheckpointRecord& r : records) {
    const auto point = at.find(r.node);
    if (point == at.end()) continue;
    Point& p = points_[point->second];
    const Point kept = entry<Point>(r);
    p.at = kept.at;
    p.slip = kept.slip;
    p.force = kept.force;
    p.stored = kept.stored;
    p.friction_work = kept.friction_work;
  }
}

}  // namespace hawser

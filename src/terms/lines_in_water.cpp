// The class LinesInWater: forces, tangent, energy and history; water motion at the nodes, forces on beams and
// balls, work, wall tension. The formula is in kernels/morison_formula.hpp, groups of four cables in
// lines_in_water_cables.cpp.
#include "hawser/terms/lines_in_water.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/terms/force_round_off.hpp"
#include "hawser/terms/line_mass.hpp"

namespace hawser {

LinesInWater::LinesInWater(const LocalMesh& mesh, Sea sea, std::vector<WetElement> pieces,
                           std::vector<Ball> balls)
    : mesh_(mesh), sea_(std::move(sea)), pieces_(std::move(pieces)), balls_(std::move(balls)) {
  group();
}

Vec3 LinesInWater::wave_place(const Kinematics& state, size_t node) const {
  if (state.time > start_time_ && node < start_.size())
    return start_[node] + (state.time - start_time_) * speed_[node];
  return node < place_.size() ? place_[node] : state.x[node];
}

const std::vector<WaveMotion>& LinesInWater::waves(const Kinematics& state) const {
  if (wave_known_ && wave_time_ == state.time && wave_.size() == state.x.size()) return wave_;
  wave_.resize(state.x.size());
  for (size_t n = 0; n < state.x.size(); ++n) wave_[n] = sea_.waves_at(wave_place(state, n), state.time);
  wave_time_ = state.time;
  wave_known_ = true;
  return wave_;
}

Water LinesInWater::water(const Kinematics& state, size_t node) const {
  const Water without_waves = sea_.without_waves_at(state.x[node].z(), state.time);
  return sea_.waves.none() || !state.moves() ? without_waves : without_waves + waves(state)[node];
}

void LinesInWater::update_water(const Kinematics& state) const {
  water_.resize(moving() ? state.x.size() : 1);
  if (!moving()) water_.front().surface = sea_.surface;
  for (size_t n = 0; moving() && n < state.x.size(); ++n) water_[n] = water(state, n);
}

WaterEnds LinesInWater::ends(const WetElement& p, const Kinematics& k, const Water& first,
                             const Water& second) const {
  const size_t i = static_cast<size_t>(p.element.first);
  const size_t j = static_cast<size_t>(p.element.second);
  WaterEnds e;
  e.x1 = k.x[i];
  e.x2 = k.x[j];
  e.water1 = first;
  e.water2 = second;
  e.motion = p.beam ? mass_ends(p.element, k) : MassEnds{k.a[i], k.a[j], k.v[i], k.v[j]};
  return e;
}

void LinesInWater::add_element(const WetElement& p, const Kinematics& trial, Assembler& assembler) const {
  if (p.idle) return;
  const bool tangent = assembler.needs_tangent();
  const bool convex = assembler.convex();
  const size_t i = static_cast<size_t>(p.element.first);
  const size_t j = static_cast<size_t>(p.element.second);
  const int first = mesh_.block[i];
  const int second = mesh_.block[j];
  if (p.beam) {
    const int blocks[] = {first, first + 1, second, second + 1};
    const WaterEnds e = ends(p, trial);
    Vec12 f;
    if (tangent) {
      Mat12 K, C, M;
      beam_water_tangent(p.section, e, convex, f, K, C, M);
      assembler.add(blocks, f, K, C, M);
    } else {
      beam_water_force(p.section, e, f);
      assembler.add(blocks, f);
    }
  } else {
    const int blocks[] = {first, second};
    const CableInWater e{trial.x[i], trial.x[j], trial.v[i],  trial.v[j],
                         trial.a[i], trial.a[j], water_at(i), water_at(j)};
    Vec6 f;
    if (tangent) {
      Mat6 K, C, M;
      cable_water_tangent(p.section, e, convex, f, K, C, M);
      assembler.add(blocks, f, K, C, M);
    } else {
      cable_water_force(p.section, e, f);
      assembler.add(blocks, f);
    }
  }
}

void LinesInWater::evaluate(const Kinematics& trial, Assembler& assembler) {
  update_from_feeders(&FedLine::predicted);
  update_water(trial);
  const bool tangent = assembler.needs_tangent();
  for (const CableQuad& q : quads_) add_quad(q, trial, assembler);
  for (const int b : beams_) add_element(pieces_[static_cast<size_t>(b)], trial, assembler);
  for (const Ball& b : balls_) {
    const size_t n = static_cast<size_t>(b.node);
    Vec3 r;
    Mat3 k, c, m;
    ball_water(b.ball, trial.x[n], trial.v[n], trial.a[n], water_at(n), r, tangent ? &k : nullptr, &c, &m);
    if (tangent)
      assembler.add(mesh_.block[n], r, &k, &c, &m);
    else
      assembler.add(mesh_.block[n], r);
  }
}

LinesInWater::FlowLoads LinesInWater::flow_loads(const Kinematics& state) const {
  update_water(state);
  FlowLoads out;
  out.force.assign(static_cast<size_t>(mesh_.element_ghost_blocks_end), Vec3::Zero());
  out.place = out.force;
  for (int n = 0; n < mesh_.element_ghosts_end; ++n) {
    const size_t node = static_cast<size_t>(n);
    const size_t block = static_cast<size_t>(mesh_.block[node]);
    out.place[block] = state.x[node];
    if (mesh_.rotates(n)) out.place[block + 1] = state.q[node] * Vec3::UnitX();
  }
  // Elements inside a feeder are not in the water.
  const auto put = [&](const WetElement& p, const WaterForce& force) {
    const double L = p.section.length;
    for (int j = 0; j < 4; j += p.beam ? 1 : 2) {
      const int node = j < 2 ? p.element.first : p.element.second;
      const int block = mesh_.block[static_cast<size_t>(node)] + j % 2;
      out.force[static_cast<size_t>(block)] += (j % 2 ? L : 1) * force.force[j];
    }
  };
  for (const CableQuad& q : quads_) {
    WaterForce all[4];
    const unsigned known = flow_of_quad(q, state, all);
    for (int i = 0; i < q.count; ++i) {
      const WetElement& p = pieces_[static_cast<size_t>(q.piece[i])];
      if (p.element.counted && !p.idle)
        put(p, known >> i & 1 ? all[i] : flow_force_on_line(p.section, ends(p, state), false, sea_.surface));
    }
  }
  for (const int b : beams_) {
    const WetElement& p = pieces_[static_cast<size_t>(b)];
    if (p.element.counted && !p.idle)
      put(p, flow_force_on_line(p.section, ends(p, state), true, sea_.surface));
  }
  for (const Ball& b : balls_) {
    const size_t n = static_cast<size_t>(b.node);
    WaterBall floating;
    floating.buoyancy = b.ball.buoyancy;
    floating.radius = b.ball.radius;
    Water still_water;
    still_water.surface = sea_.surface;
    Vec3 f, up;
    ball_water(b.ball, state.x[n], state.v[n], state.a[n], water_at(n), f, nullptr, nullptr, nullptr);
    ball_water(floating, state.x[n], state.v[n], state.a[n], still_water, up, nullptr, nullptr, nullptr);
    out.force[static_cast<size_t>(mesh_.block[n])] += up - f;
  }
  return out;
}

// Statics calls this before every iteration, because the line search needs the work of forces without a
// potential since then.
void LinesInWater::prepare(const Kinematics& from, double) {
  if (!sea_.waves.none()) {
    if (!from.ends_step() || place_.empty()) place_.assign(from.x.begin(), from.x.end());
    start_.assign(from.x.begin(), from.x.end());
    speed_.assign(from.v.begin(), from.v.end());
    start_time_ = from.time;
    wave_known_ = false;
  }
  update_from_feeders(&FedLine::length);
  // At the start of the motion waves start to act and accelerations jump, so the flow of the last commit is
  // not valid.
  if (!from.ends_step() || flow_loads_.place.empty() || feeders_) flow_loads_ = flow_loads(from);
}

void LinesInWater::commit(const Kinematics& accepted) {
  update_from_feeders(&FedLine::length);
  if (feeders_) feeders_->add_work(fed_buoyancy(accepted));
  FlowLoads now = flow_loads(accepted);
  if (accepted.moves() && !flow_loads_.place.empty()) work_ += work(flow_loads_, now);
  flow_loads_ = std::move(now);
  if (sea_.waves.none()) return;
  std::vector<Vec3> places(accepted.x.size());
  for (size_t n = 0; n < places.size(); ++n) places[n] = wave_place(accepted, n);
  place_.swap(places);
  start_time_ = accepted.time;
}

// In statics the work of forces without a potential since the last iteration counts as potential.
Energy LinesInWater::energy(const Kinematics& state) const {
  Energy e;
  // The potential is that of still water; waves do work.
  Water still_water;
  still_water.surface = sea_.surface;
  for (const WetElement& p : pieces_)
    if (p.element.counted && !p.idle)
      e.potential += water_potential(p.section, ends(p, state, still_water, still_water), p.beam);
  for (const Ball& b : balls_) {
    const size_t n = static_cast<size_t>(b.node);
    e.potential += ball_potential(b.ball, state.x[n], still_water);
  }
  if (!state.moves() && !flow_loads_.place.empty()) e.potential -= work(flow_loads_, flow_loads(state));
  e.work = e.by_water = work_;
  return e;
}

double LinesInWater::work(const FlowLoads& from, const FlowLoads& to) {
  double sum = 0;
  for (size_t i = 0; i < to.place.size(); ++i)
    sum += 0.5 * (to.force[i] + from.force[i]).dot(to.place[i] - from.place[i]);
  return sum;
}

double LinesInWater::dead_load() const {
  double sum = 0;
  for (const WetElement& p : pieces_)
    if (p.element.counted && !p.idle) sum += p.section.length * p.section.buoyancy;
  for (const Ball& b : balls_) sum += b.ball.buoyancy;
  return sum;
}

double LinesInWater::round_off(const Kinematics& state, double h) const {
  if (h <= 0) return 0;
  double sum = 0;
  for (const WetElement& p : pieces_)
    if (p.element.counted)
      sum += inertia_round_off(state, p.element, p.section.added_normal * p.section.length, h);
  return sum;
}

void LinesInWater::element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const {
  const WetElement* p = of_element(pieces_, e);
  if (!p || p->idle) return;
  const size_t i = static_cast<size_t>(e.first);
  const size_t j = static_cast<size_t>(e.second);
  const Water first = water(state, i);
  const Water second = water(state, j);
  if (p->beam) {
    Vec12 force;
    beam_water_force(p->section, ends(*p, state, first, second), force);
    add_ends(force, f);
  } else {
    Vec6 force;
    cable_water_force(p->section,
                      {state.x[i], state.x[j], state.v[i], state.v[j], state.a[i], state.a[j], first, second},
                      force);
    add_ends(force, f);
  }
}

// True wall tension (Sparks 1984): T_wall = T_effective + p_i A_i - p_e A_e. At a change of type it is that
// of the type with the larger one.
void LinesInWater::fields(FieldRegistry& registry) const {
  const std::string effective = "effective_tension";
  const auto& all = registry.sources();
  if (walls_.empty() ||
      std::none_of(all.begin(), all.end(), [&](const FieldSource& f) { return f.name == effective; }))
    return;
  registry.add({{.name = "wall_tension",
                 .unit = "N",
                 .history = Field::History::after_end_columns,
                 .statistics = true,
                 .report = Field::Report::table,
                 .order = 10},
                [this](const Kinematics& k, std::span<double> out) {
                  std::vector<double> weight(out.size(), 0);
                  std::vector<double> sum(out.size(), 0);
                  for (const WetElement& p : pieces_) {
                    const Wall& wall = walls_[static_cast<size_t>(mesh_.element(p.element).type)];
                    for (const int node : {p.element.first, p.element.second}) {
                      if (node >= mesh_.owned) continue;
                      const size_t n = static_cast<size_t>(node);
                      const double depth = sea_.surface - k.x[n].z();
                      const double external = sea_.density * sea_.gravity * std::max(depth, 0.0);
                      const double internal = wall.pressure + wall.contents * sea_.gravity * depth;
                      const double more = wall.inside * internal - wall.outside * external;
                      if (mesh_.node(n).two_sided) {
                        if (weight[n] == 0 || std::abs(out[n] + more) > std::abs(out[n] + sum[n]))
                          sum[n] = more;
                        weight[n] = 1;
                        continue;
                      }
                      weight[n] += 1 / p.section.length;
                      sum[n] += more / p.section.length;
                    }
                  }
                  for (size_t n = 0; n < out.size(); ++n)
                    if (weight[n] > 0) out[n] += sum[n] / weight[n];
                },
                effective});
}

namespace {
enum WaterRecord { kWaterSums, kWavePlaces };
constexpr int kOwn = -1;  // key of a node's own record; others are 1 + a neighbouring mesh node

struct KeptPosition {
  Vec3 position = Vec3::Zero();  // m
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("position", "m", self.position);
  }
};
}  // namespace

// The sums of a rank are stored at its first node; a restart adds those of all ranks. The positions at which
// the waves of the committed state were evaluated are stored at each node with those of its neighbours, which
// another rank may own.
std::vector<CheckpointKind> LinesInWater::checkpoint_kinds() const {
  return {checkpoint_kind<WorkDone>("sums of a rank"), checkpoint_kind<KeptPosition>("places of waves")};
}

std::vector<CheckpointRecord> LinesInWater::checkpoint_records(NodeRange range) const {
  if (mesh_.owned == 0) return {};
  std::vector<CheckpointRecord> out;
  if (range.has(mesh_.global[0])) out.push_back(record_of(mesh_.global[0], 0, WorkDone{work_}, kWaterSums));
  if (place_.empty()) return out;
  const auto put = [&](int node, int key, const Vec3& x) {
    const int global = mesh_.global[static_cast<size_t>(node)];
    if (range.has(global)) out.push_back(record_of(global, key, KeptPosition{x}, kWavePlaces));
  };
  for (int n = 0; n < mesh_.owned; ++n) put(n, kOwn, place_[static_cast<size_t>(n)]);
  for (const WetElement& p : pieces_)
    for (const auto& [node, other] :
         {std::pair{p.element.first, p.element.second}, {p.element.second, p.element.first}})
      if (node < mesh_.owned)
        put(node, 1 + mesh_.global[static_cast<size_t>(other)], place_[static_cast<size_t>(other)]);
  return out;
}

// The restored state is committed, so its waves are those at the stored positions (wave_place).
void LinesInWater::restore(const std::vector<CheckpointRecord>& records) {
  work_ = 0;
  flow_loads_ = {};
  start_.clear();
  place_.clear();
  wave_known_ = false;
  for (const CheckpointRecord& r : records) {
    if (r.kind == kWaterSums) {
      work_ += entry<WorkDone>(r).work;
      continue;
    }
    place_.resize(static_cast<size_t>(mesh_.nodes()), Vec3::Zero());
    const int n = mesh_.find(r.key == kOwn ? r.node : r.key - 1);
    if (n >= 0) place_[static_cast<size_t>(n)] = entry<KeptPosition>(r).position;
  }
}

}  // namespace hawser

// The tangent of a time step with feeders equals finite differences: controlled by speed, by an exact
// constant tension, by a dead band.
#include "hawser/terms/feeders.hpp"

#include <optional>

#include "hawser/geometry/surface.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_pairs.hpp"
#include "hawser/terms/line_volume_contact.hpp"
#include "support/step_tangent.hpp"
#include "support/taylor_cases.hpp"

namespace hawser::test::feeders_test {
namespace {

enum class Kind { cable, beam, yields };
enum class On { nothing, lines, roller };

model::Case fed(const model::Feed& a, const model::Feed& b, Kind kind) {
  model::Case c;
  c.environment.gravity = 9.81;
  model::LineType t;
  t.name = "rope";
  t.kind = model::LineKind::cable;
  t.mass_per_length = 2;
  t.EA = 300;
  t.stiffness_damping = 0.05;
  if (kind != Kind::cable) {
    t.kind = model::LineKind::beam;
    t.EI2 = 9;
    t.EI3 = 12;
    t.GJ = 8;
    t.stiffness_damping = 0;
  }
  if (kind == Kind::yields) {
    t.EI2 = 12;
    t.plastic_bending =
        std::make_shared<PlasticBending>(std::vector<PlasticBending::Row>{{0.1, 1.2}, {0.4, 3}, {2, 6}});
  }
  c.line_types.push_back(t);
  model::Line l;
  l.name = "rope";
  l.sections = {{"rope", 9, 9, 1}};
  l.end_a.kind = l.end_b.kind = model::EndKind::anchor;
  l.end_b.at = Vec3(4, 1, 0.5);
  l.end_a.feed = a;
  l.end_b.feed = b;
  c.lines.push_back(l);
  return c;
}

// Adds two crossing lines: one at the feed point of end A, one at the joint beside it.
void cross(model::Case& c) {
  model::LineType t = c.line_types.front();
  t.name = "across";
  t.kind = model::LineKind::cable;
  c.line_types.push_back(t);
  for (const char* name : {"at the feed point", "at a joint"}) {
    model::Line l;
    l.name = name;
    l.sections = {{"across", 3, 3, 1}};
    l.end_a.kind = l.end_b.kind = model::EndKind::free;
    c.lines.push_back(l);
  }
}

constexpr double kRadius = 0.2;  // m

LinePairOptions rough() {
  LinePairOptions o;
  o.general.basis = model::StiffnessBasis::per_length;
  o.general.normal_stiffness = 2000;
  o.general.smoothing = 0.01;
  o.general.relative_damping = 0.1;
  o.general.friction = 0.3;
  o.general.mobilisation_length = 0.05;
  return o;
}

struct Rig {
  model::Case c;
  Mesh mesh;
  std::unique_ptr<System> system;
  Feeders* feeders = nullptr;

  LinePairs* contact = nullptr;
  LineVolumeContact* on_roller = nullptr;

  explicit Rig(model::Case of) : c(std::move(of)), mesh(build_mesh(c)) {
    system =
        std::make_unique<System>(PETSC_COMM_SELF, local_mesh(mesh, NodeRanks::all_of(mesh.nodes()), 0, 1));
    auto structure = std::make_unique<LineStructure>(system->mesh(), c);
    auto mass = std::make_unique<LineMass>(system->mesh(), c);
    auto owned = std::make_unique<Feeders>(system->mesh(), c);
    feeders = owned.get();
    system->add(std::move(owned));
    system->add(std::move(structure));
    system->add(std::move(mass));
    if (c.lines.size() > 1) {
      const std::vector<LinePairType> types(c.line_types.size(), {kRadius, 2});
      auto between = std::make_unique<LinePairs>(PETSC_COMM_SELF, system->mesh(), types, rough());
      contact = between.get();
      system->add(std::move(between));
    }
    system->tie(feeders->with_held({}), {});
  }

  void put_on(const std::shared_ptr<const Surface>& roller) {
    ContactVolume v;
    v.surface = roller;
    v.settings.name = "roller";
    v.settings.basis = model::StiffnessBasis::per_length;
    v.settings.normal_stiffness = 2000;
    v.settings.smoothing = 0.01;
    v.settings.relative_damping = 0.1;
    v.settings.friction = {0.3, 0.3, 0, 4e3};
    auto term = std::make_unique<LineVolumeContact>(
        system->mesh(), std::make_shared<const Bodies>(), std::vector{v},
        std::vector<LineContactElement>(static_cast<size_t>(mesh.elements()), {kRadius, 2}));
    on_roller = term.get();
    system->add(std::move(term));
  }
};

// Across the middle of the element at the feed point of end A, with a penetration of 5 cm when this element
// has the length L.
struct Roller {
  static constexpr double kRadius = 0.3;  // m
  Vec3 middle, along;

  static AxisShape axis(const Rig& r, const Kinematics& state) {
    const Feeder& f = r.feeders->all().front();
    const LocalElement& e = *r.feeders->at_feed_point(f);
    AxisEnds ends = element_axis(state, r.mesh.element(static_cast<size_t>(e.global)), e.first, e.second);
    ends.length = r.feeders->predicted_feed_point(f, state).length;
    return AxisShape(ends);
  }
  Roller(const Rig& r, const Kinematics& start) {
    const AxisShape shape = axis(r, start);
    const Vec3 chord = (shape.point(1) - shape.point(0)).normalized();
    along = chord.cross(Vec3(0.2, -0.3, 1)).normalized();
    middle = shape.point(0.5) - (kRadius + test::feeders_test::kRadius - 0.05) * along.cross(chord);
  }
  std::shared_ptr<const Surface> surface() const {
    return std::make_shared<CylinderSurface>(middle - 2 * along, middle + 2 * along, kRadius);
  }
  double depth(const AxisShape& shape) const {
    double most = 0;
    for (int k = 0; k <= 1000; ++k) {
      const Vec3 y = shape.point(k / 1000.0) - middle;
      most = std::max(most, kRadius + test::feeders_test::kRadius - (y - y.dot(along) * along).norm());
    }
    return most;
  }
};

// The crossing lines, pressed into the rope between its nodes 2 and 3 and at node 3.
void lay_across(State& s) {
  const Vec3 chord = s.x[3] - s.x[2];
  const Vec3 across = Vec3(-0.3, 1, 0.1).normalized();
  const Vec3 away = chord.cross(across).normalized();
  for (const int line : {0, 1})
    for (int k = 0; k < 4; ++k)
      s.x[static_cast<size_t>(10 + 4 * line + k)] = s.x[2] + (line ? 1.0 : 0.6) * chord + (k - 1.3) * across +
                                                    (line ? -1 : 1) * (2 * kRadius - 0.1) * away;
}

TEST(Feeders, TheTangentIsTheDerivativeByTheIncrements) {
  model::Feed speed, exact, band, limited;
  speed.stock = exact.stock = band.stock = limited.stock = 2;
  speed.speed = {{0, 0.5}, {1, 2.5}};
  exact.tension = 30;
  band.tension = 30;
  band.min_tension = 20;
  band.max_tension = 40;
  band.speed_per_tension = 0.02;
  limited = band;
  limited.max_speed = 0.01;
  const Vec3 towards(4, 1, 0.5);
  const Quat along = minimal_rotation(Vec3::UnitX(), towards.normalized());
  std::vector<std::tuple<model::Feed, Kind, On>> cases;
  for (const Kind kind : {Kind::cable, Kind::beam, Kind::yields})
    for (const model::Feed& a : {speed, exact, band, limited}) cases.push_back({a, kind, On::nothing});
  for (const model::Feed& a : {speed, exact, band}) cases.push_back({a, Kind::cable, On::lines});
  for (const model::Feed& a : {speed, band}) cases.push_back({a, Kind::beam, On::lines});
  for (model::Feed a : {speed, exact, band}) {
    a.stock = 2.3;  // the element at the feed point is shorter than the element of the mesh
    for (const Kind kind : {Kind::cable, Kind::beam}) cases.push_back({a, kind, On::roller});
  }
  for (const auto& [a, kind, on] : cases) {
    const bool beam = kind != Kind::cable;
    const bool crossed = on == On::lines;
    const bool smooth = on == On::nothing;
    model::Case c = fed(a, speed, kind);
    if (crossed) cross(c);
    Rig r(c);
    r.feeders->clamp(std::vector<std::array<Quat, 2>>(c.lines.size(), {along, along}));
    const LocalMesh& mesh = r.system->mesh();
    constexpr double h = 0.1;
    AlphaState from;
    from.s.resize(mesh.nodes());
    for (int n = 0; n < 10; ++n) {
      const size_t i = static_cast<size_t>(n);
      // Nodes 0 to 2 are inside the first volume, 7 to 9 inside the second.
      const double s = std::clamp(n - 2, 0, 5) / 5.0;
      from.s.x[i] = s * towards;
      if (beam) from.s.q[i] = along;
      if (n <= 2 || n >= 7) continue;
      from.s.x[i] += 0.1 * noise3(n, 1);
      from.s.v[i] = noise3(n, 2);
      from.s.a[i] = 3 * noise3(n, 3);
      if (!beam) continue;
      from.s.q[i] = along * exp_so3(0.2 * noise3(n, 6));
      from.s.w[i] = noise3(n, 7);
      from.s.alpha[i] = 3 * noise3(n, 8);
    }
    // So long that the line is in tension: the chord is longer than the unstretched length of 5 m.
    for (Vec3& x : from.s.x) x *= 1.4;
    if (crossed) lay_across(from.s);
    for (Feeder& f : r.feeders->all()) {
      f.tied.at *= 1.4;
      f.resting = false;
    }
    r.system->tie(r.feeders->with_held({}), {});
    std::optional<Roller> roller;
    if (on == On::roller) {
      roller.emplace(r, from.s.at_rest());
      r.put_on(roller->surface());
    }
    alpha_start(mesh, from);
    r.system->update_couplings(from.s.after_step(h), h);
    r.system->prepare(from.s.after_step(h), h);
    std::vector<double> u(3 * static_cast<size_t>(mesh.blocks()), 0);
    std::vector<double> d = u;
    std::vector<int> moving{3, 4, 5, 6};
    for (int n = 10; n < mesh.nodes(); ++n) moving.push_back(n);
    for (const int n : moving)
      for (int k = 0; k < (mesh.rotates(n) ? 6 : 3); ++k) {
        const size_t i = 3 * static_cast<size_t>(mesh.block[static_cast<size_t>(n)]) + static_cast<size_t>(k);
        u[i] = 0.05 * noise3(n, k < 3 ? 4 : 9)[k % 3];
        d[i] = noise3(n, k < 3 ? 5 : 10)[k % 3];
      }
    StepTangent step(*r.system, from, h, u);
    // Friction has kinks, and curves bend sharply at a yield circle.
    const double e = !smooth ? 1e-5 : kind == Kind::yields ? 2e-4 : 1e-3;
    const double error = step.error(d, e);
    EXPECT_LT(error, smooth ? 1e-8 : 1e-6)
        << a.tension << ' ' << a.max_speed << ' ' << static_cast<int>(kind);
    constexpr const char* kNames[] = {"cable", "beam", "beam that yields"};
    printf("  %s%s, tension %g, at most %g m/s: error %.1e\n", kNames[static_cast<int>(kind)],
           crossed  ? " over others"
           : roller ? " on a roller"
                    : "",
           a.tension, a.max_speed, error);
    if (smooth) continue;
    const double deep = roller ? roller->depth(Roller::axis(r, step.trial().after_step(h))) : 0;
    step.commit();
    if (roller) {
      const double depth = r.on_roller->largest_penetration().depth;
      printf("  %.4f m deep, the axis %.4f m\n", depth, deep);
      EXPECT_NEAR(depth, deep, 0.02 * deep);
      continue;
    }
    EXPECT_GE(r.contact->active_count(), 3) << beam;  // of both elements at the joint
    EXPECT_GT(r.contact->friction_force(), 10) << beam;
  }
}

}  // namespace
}  // namespace hawser::test::feeders_test

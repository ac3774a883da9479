// The tangent of a time step with feeders: by speed, by a tension that is kept exactly, by a dead band.
#include "hawser/terms/feeders.hpp"

#include "hawser/math/so3.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/model/case.hpp"
#include "hawser/solve/generalized_alpha.hpp"
#include "support/taylor_cases.hpp"

namespace hawser::test::feeders_test {
namespace {

enum class Kind { cable, beam, yields };

model::Case fed(const model::Feed& a, const model::Feed& b, Kind kind) {
  model::Case c;
  c.environment.gravity = 9.81;
  model::LineType t;
  t.name = "rope", t.kind = model::LineKind::cable, t.mass_per_length = 2, t.EA = 300,
  t.stiffness_damping = 0.05;
  if (kind != Kind::cable)
    t.kind = model::LineKind::beam, t.EI2 = 9, t.EI3 = 12, t.GJ = 8, t.stiffness_damping = 0;
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
  l.end_a.feed = a, l.end_b.feed = b;
  c.lines.push_back(l);
  return c;
}

struct Rig {
  model::Case c;
  Mesh mesh;
  std::unique_ptr<System> system;
  Feeders* feeders = nullptr;

  explicit Rig(model::Case of) : c(std::move(of)), mesh(build_mesh(c)) {
    system = std::make_unique<System>(PETSC_COMM_SELF,
                                      local_mesh(mesh, std::vector<int>(mesh.nodes.size(), 0), 0, 1));
    auto structure = std::make_unique<StructureTerm>(system->mesh(), c);
    auto mass = std::make_unique<LineMassTerm>(system->mesh(), c);
    auto f = std::make_unique<Feeders>(system->mesh(), c);
    feeders = f.get();
    structure->fed_by(feeders), mass->fed_by(feeders);
    system->add(std::move(structure)), system->add(std::move(mass)), system->add(std::move(f));
    system->support(feeders->with_held({}), {});
  }
};

TEST(Feeders, TheTangentIsTheDerivativeByTheIncrements) {
  model::Feed speed, exact, band, limited;
  speed.stock = exact.stock = band.stock = limited.stock = 2;
  speed.speed = {{0, 0.5}, {1, 2.5}};
  exact.tension = 30;
  band.tension = 30, band.least = 20, band.most = 40, band.speed_per_tension = 0.02;
  limited = band, limited.max_speed = 0.01;
  const Vec3 towards(4, 1, 0.5);
  const Quat along = minimal_rotation(Vec3::UnitX(), towards.normalized());
  for (const Kind kind : {Kind::cable, Kind::beam, Kind::yields})
    for (const model::Feed& a : {speed, exact, band, limited}) {
      const bool beam = kind != Kind::cable;
      Rig r(fed(a, speed, kind));
      r.feeders->clamp({{along, along}});
      const LocalMesh& mesh = r.system->mesh();
      const AlphaCoefficients alpha(0.8);
      constexpr double h = 0.1;
      AlphaState from;
      from.s.resize(mesh.nodes());
      for (int n = 0; n < mesh.nodes(); ++n) {
        const size_t i = static_cast<size_t>(n);
        // Nodes 0 to 2 are inside the one, 7 to 9 inside the other.
        const double s = std::clamp(n - 2, 0, 5) / 5.0;
        from.s.x[i] = s * towards;
        if (beam) from.s.q[i] = along;
        if (n <= 2 || n >= 7) continue;
        from.s.x[i] += 0.1 * noise3(n, 1), from.s.v[i] = noise3(n, 2), from.s.a[i] = 3 * noise3(n, 3);
        if (!beam) continue;
        from.s.q[i] = along * exp_so3(0.2 * noise3(n, 6));
        from.s.w[i] = noise3(n, 7), from.s.alpha[i] = 3 * noise3(n, 8);
      }
      // So long that it pulls: the chord is beyond the unstretched length of 5 m.
      for (Vec3& x : from.s.x) x *= 1.4;
      for (Feeder& f : r.feeders->list()) f.support.at *= 1.4, f.resting = false;
      r.system->support(r.feeders->with_held({}), {});
      alpha_start(mesh, from);
      r.system->prepare(from.s.view(h), h);
      AlphaState to = from;
      std::vector<double> u(3 * static_cast<size_t>(mesh.blocks()), 0), d = u;
      const int components = beam ? 6 : 3;
      for (int n = 3; n < 7; ++n)
        for (int k = 0; k < components; ++k) {
          const size_t i =
              3 * static_cast<size_t>(mesh.block[static_cast<size_t>(n)]) + static_cast<size_t>(k);
          u[i] = 0.05 * noise3(n, k < 3 ? 4 : 9)[k % 3], d[i] = noise3(n, k < 3 ? 5 : 10)[k % 3];
        }
      VecHandle x = r.system->create_vector(), y = r.system->create_vector(), res = r.system->create_vector();
      const auto at = [&](double step) {
        std::vector<double> w = u;
        for (size_t i = 0; i < w.size(); ++i) w[i] += step * d[i];
        alpha_trial(mesh, r.system->supports(), alpha, h, from, w, to);
        r.system->residual(to.s.view(h), res.get());
        const PetscScalar* p = nullptr;
        VecGetArrayRead(res.get(), &p);
        const std::vector<double> out(p, p + w.size());
        VecRestoreArrayRead(res.get(), &p);
        return out;
      };
      at(0);
      MatHandle J = r.system->create_matrix();
      r.system->tangent(to.s.view(h), alpha_weights(alpha, h), u, false, J.get());
      PetscScalar* p = nullptr;
      VecGetArray(x.get(), &p);
      std::copy(d.begin(), d.end(), p);
      VecRestoreArray(x.get(), &p);
      MatMult(J.get(), x.get(), y.get());
      const PetscScalar* q = nullptr;
      VecGetArrayRead(y.get(), &q);
      const std::vector<double> Jd(q, q + d.size());
      VecRestoreArrayRead(y.get(), &q);
      const double e = kind == Kind::yields ? 2e-4 : 1e-3;  // curves bend fast at a yield circle
      const auto b1 = at(e), b2 = at(-e), c1 = at(2 * e), c2 = at(-2 * e);
      double off = 0, size = 0;
      for (int n = 3; n < 7; ++n)
        for (int k = 0; k < components; ++k) {
          const size_t i =
              3 * static_cast<size_t>(mesh.block[static_cast<size_t>(n)]) + static_cast<size_t>(k);
          off = std::max(off, std::abs((8 * (b1[i] - b2[i]) - (c1[i] - c2[i])) / (12 * e) - Jd[i]));
          size = std::max(size, std::abs(Jd[i]));
        }
      EXPECT_LT(off, 1e-8 * size) << a.tension << ' ' << a.max_speed << ' ' << static_cast<int>(kind);
      constexpr const char* kNames[] = {"cable", "beam", "beam that yields"};
      printf("  %s, tension %g, at most %g m/s: error %.1e\n", kNames[static_cast<int>(kind)], a.tension,
             a.max_speed, off / size);
    }
}

}  // namespace
}  // namespace hawser::test::feeders_test

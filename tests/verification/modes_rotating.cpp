// Small vibrations of a rotating cantilever, flapwise (out of the plane of rotation) and lagwise (in it).
#include <gtest/gtest.h>

#include <cstdio>
#include <stdexcept>

#include "support/modal.hpp"
#include "support/rig.hpp"

namespace hawser::modes_rotating_test {

using namespace hawser::test;

namespace {

// A system that rotates steadily about an axis through the origin at angular velocity `Omega` [rad/s].
//
// With the rotation R(t), a node is at x = R (X + xi) and its rotation is R Q exp(phi). At R = 1 and to first
// order
//   v = Om x (X + xi) + xi',  a = Om x (Om x (X + xi)) + 2 Om x xi' + xi''
//   w = exp(-phi) W + phi',   alpha = W x phi' + phi'',             W = Q' Om, all in material axes,
// so  K_eff = K + C G1 + M G2,  C_eff = C + M G3,  M_eff = M  with, by nodes,
//   G1 = [Om],  G2 = [Om]²,  G3 = 2 [Om]  on positions;  G1 = [W],  G2 = 0,  G3 = [W]  on rotations.
struct SteadyRotation {
  run::Simulation& s;
  Vec3 Omega;

  void move() {
    State& z = s.state();
    for (size_t i = 0; i < z.x.size(); ++i) {
      z.v[i] = Omega.cross(z.x[i]);
      z.a[i] = Omega.cross(z.v[i]);
      z.w[i] = z.q[i].conjugate() * Omega;
      z.alpha[i].setZero();
    }
  }

  ModalMatrices matrices() {
    move();
    ModalMatrices m = modal_matrices(s.system(), s.state().at_rest());
    const auto n = static_cast<Eigen::Index>(m.dof.size());
    Eigen::MatrixXd G1 = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd G2 = G1;
    Eigen::MatrixXd G3 = G1;
    const LocalMesh& mesh = s.local();
    for (int node = 0; node < mesh.owned; ++node) {
      const int b = mesh.block[static_cast<size_t>(node)];
      const Mat3 position = hat(Omega);
      const Mat3 rotation = hat(s.state().w[static_cast<size_t>(node)]);
      put(m, b, position, G1);
      put(m, b, position * position, G2);
      put(m, b, 2 * position, G3);
      put(m, b + 1, rotation, G1);
      put(m, b + 1, rotation, G3);
    }
    m.K += m.C * G1 + m.M * G2;
    m.C += m.M * G3;
    return m;
  }

  // Relative equilibrium: Newton on the residual with the accelerations of the rotation, which change little.
  int settle() {
    VecHandle r = s.system().create_vector();
    VecHandle u = s.system().create_vector();
    MatHandle J = s.system().create_matrix();
    KspHandle ksp;
    check(KSPCreate(PETSC_COMM_WORLD, ksp.out()));
    configure_linear_solver(ksp.get(), s.system(), "verification_");
    std::vector<double> local(3 * static_cast<size_t>(s.local().blocks()), 0);
    const std::vector<double> zero(local);
    State next = s.state();
    for (int it = 0; it < 60; ++it) {
      move();
      s.system().prepare(s.state().at_rest(), 0);
      s.system().residual(s.state().at_rest(), r.get());
      if (s.system().norms(r.get()).small(1e-12)) return it;
      s.system().tangent(s.state().at_rest(), {}, zero, false, J.get());
      check(KSPSetOperators(ksp.get(), J.get(), J.get()));
      check(KSPSolve(ksp.get(), r.get(), u.get()));
      check(VecScale(u.get(), -1));
      s.system().gather_with_ghosts(u.get(), local);
      retract(s.local(), s.state(), local.data(), next);
      s.state().x = next.x;
      s.state().q = next.q;
    }
    throw std::runtime_error("no relative equilibrium");
  }

 private:
  static void put(const ModalMatrices& m, int block, const Mat3& value, Eigen::MatrixXd& G) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int r = m.row(block, i);
        const int c = m.row(block, j);
        if (r >= 0 && c >= 0) G(r, c) = value(i, j);
      }
  }
};

struct Blade {
  std::vector<double> flap, lag;
  double damping = 0;  // largest |real part| over imaginary part: there is no damping
};

// A blade of length 1, EI = m = 1 along x, hub radius 0, rotating about z. EA = 1e7 stands for inextensible.
Blade blade(double eta, int elements) {
  model::LineType t = beam_type(1e7, 1, 1, 1);
  t.rotary_inertia = Vec3(1e-5, 1e-9, 1e-9);
  model::Case c = one_line(t, 1, elements, clamp(Vec3::Zero(), Vec3::UnitX()), {});
  c.lines[0].start = model::Start::straight;
  run::Simulation s(PETSC_COMM_WORLD, c);
  SteadyRotation turning{s, Vec3(0, 0, eta)};
  turning.settle();
  const ModalMatrices m = turning.matrices();
  Blade out;
  // The plane of rotation is a plane of symmetry: the motions (z, rotation about x and y) and (x, y, rotation
  // about z) are uncoupled.
  auto part = [&](bool out_of_plane) {
    const Eigen::MatrixXd B = components(
        m, [&](int block, int axis) { return (block % 2 == 0 ? axis == 2 : axis != 2) == out_of_plane; });
    const auto found = oscillations(restricted(m.K, B), restricted(m.C, B), restricted(m.M, B));
    for (size_t i = 0; i < 5; ++i) {
      (out_of_plane ? out.flap : out.lag).push_back(found.at(i).imag());
      out.damping = std::max(out.damping, std::abs(found[i].real()) / found[i].imag());
    }
  };
  part(true);
  part(false);
  return out;
}

}  // namespace

// mu = omega sqrt(m L⁴/EI) at eta = Omega sqrt(m L⁴/EI): Wright, Smith, Thresher & Wang (1982), J. Appl.
// Mech. 49, here by Chebyshev collocation, N = 36.
TEST(Modes, RotatingCantilever) {
  struct {
    double eta;
    std::vector<double> flap, lag;
  } const rows[] = {
      {0,
       {3.5160154536, 22.0344916, 61.6972144239, 120.901916058, 199.85953012},
       {3.5160154536, 22.0344916, 61.6972144239, 120.901916058, 199.85953012}},
      {1,
       {3.68164692664, 22.1810111729, 61.8417625968, 121.050921889, 200.011574183},
       {3.54323638675, 22.1584579033, 61.833676917, 121.046791326, 200.009074312}},
      {2,
       {4.13731973978, 22.6149219831, 62.2731841135, 121.496694718, 200.466923207},
       {3.62179715462, 22.5263112005, 62.2410592747, 121.480232249, 200.456946251}},
      {3,
       {4.79727865049, 23.3202636867, 62.9849674865, 122.235547137, 201.223245337},
       {3.74351204758, 23.1264934311, 62.9134813, 122.198727424, 201.200880873}},
      {4,
       {5.58500148426, 24.2733494088, 63.9667604989, 123.261484902, 202.276712063},
       {3.89772261445, 23.9415014467, 63.8415730439, 123.196565132, 202.237158413}},
      {5,
       {6.44954482395, 25.4460803743, 65.205040527, 124.566421184, 203.622082166},
       {4.07389597758, 24.9500101486, 65.0130549208, 124.466032662, 203.560684676}},
      {6,
       {7.36037308855, 26.809081702, 66.6839143926, 126.140452594, 205.252813589},
       {4.26322553973, 26.129042495, 66.4134356793, 125.997673711, 205.165098119}},
      {8,
       {9.25683766298, 29.9953819115, 70.2929621949, 130.049031693, 209.338513263},
       {4.65714972047, 28.9088729634, 69.8362408362, 129.80273743, 209.185594952}},
      {10,
       {11.2023277813, 33.6403658638, 74.6492946023, 134.884101407, 214.460953545},
       {5.04897491771, 32.1196857931, 73.9764637207, 134.512902029, 214.227684008}},
      {12,
       {13.1701505568, 37.6031123627, 79.6144784986, 140.53435448, 220.536322005},
       {5.42704944603, 35.6369760131, 78.7049247925, 140.021086944, 220.209603159}},
  };
  for (const auto& r : rows) {
    const Blade b = blade(r.eta, 20);
    double flap = 0, lag = 0;
    for (size_t i = 0; i < 5; ++i) {
      flap = std::max(flap, std::abs(b.flap[i] / r.flap[i] - 1));
      lag = std::max(lag, std::abs(b.lag[i] / r.lag[i] - 1));
    }
    std::printf(
        "rotating cantilever eta %4.1f: first 5 flap within %.2e, lag within %.2e (20 elements), damping "
        "%.1e\n",
        r.eta, flap, lag, b.damping);
    EXPECT_LT(flap, 5e-3) << "eta " << r.eta;
    EXPECT_LT(lag, 5e-3) << "eta " << r.eta;
    EXPECT_LT(b.damping, 1e-6);
  }
}

}  // namespace hawser::modes_rotating_test

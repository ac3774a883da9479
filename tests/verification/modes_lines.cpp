// Natural frequencies of lines at rest against closed forms: tensioned beams, hanging chain, vertical riser,
// sagged cable.
#include <gtest/gtest.h>

#include <cstdio>

#include "hawser/kernels/catenary.hpp"
#include "support/modal.hpp"
#include "support/rig.hpp"

namespace hawser::modes_lines_test {

using namespace hawser::test;

namespace {

// Largest relative error of the first `count` frequencies; each has `multiplicity` equal modes.
double frequency_error(const std::vector<double>& omega, const std::vector<double>& exact, int count,
                       int multiplicity) {
  double worst = 0;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < multiplicity; ++k)
      worst = std::max(
          worst,
          std::abs(omega[static_cast<size_t>(multiplicity * i + k)] / exact[static_cast<size_t>(i)] - 1));
  return worst;
}

std::vector<double> frequencies(run::Simulation& s) {
  const ModalMatrices m = modal_matrices(s.system(), s.state().at_rest());
  return natural_frequencies(m.K, m.M);
}

// Unstretched length that a weight w [N/m] and a tension T at the lower end stretch to L in a vertical line.
double unstretched(double L, double T, double w, double EA) {
  double L0 = L;
  for (int i = 0; i < 20; ++i) L0 = L - (T * L0 + 0.5 * w * L0 * L0) / EA;
  return L0;
}

}  // namespace

// Tensioned Euler-Bernoulli beam: transcendental equations, checked by Chebyshev collocation to 1e-8. Hz.
TEST(Modes, TensionedBeam) {
  struct {
    const char* name;
    bool clamped;
    std::vector<double> f;
  } const rows[] = {{"pinned", false, {0.32240943187263577, 0.6805626114965263, 1.1044343269725434}},
                    {"clamped", true, {0.3690247388322743, 0.7779182720268524, 1.2579536977179369}}};
  const double L = 50, T = 1e5, EA = 1e11;
  for (const auto& r : rows) {
    const model::LineType t = beam_type(EA, 1e6, 1e6, 100);
    double error[2];
    for (int i = 0; i < 2; ++i) {
      model::End a = anchor(Vec3::Zero());
      model::End b = anchor(Vec3(L, 0, 0));
      if (r.clamped) {
        a = clamp(a.at, Vec3::UnitX());
        b = clamp(b.at, Vec3::UnitX());
      }
      model::Case c = one_line(t, unstretched(L, T, 0, EA), 10 << i, a, b);
      run::Simulation s(PETSC_COMM_WORLD, c);
      s.solve_statics();
      std::vector<double> omega;
      for (double f : r.f) omega.push_back(2 * M_PI * f);
      error[i] = frequency_error(frequencies(s), omega, 3, 2);
    }
    std::printf("tensioned beam, %s: first 3 frequencies within %.2e %.2e (10, 20 elements)\n", r.name,
                error[0], error[1]);
    EXPECT_LT(error[1], 1e-3);
  }
}

// Zeros of J0: omega_n = j_n/2 sqrt(g/L), here g = 9.81, L = 10.
TEST(Modes, HangingChain) {
  const std::vector<double> exact{1.1909350769091904, 2.733692939922684, 4.285561621936849,
                                  5.8394888265660105};
  double error[2];
  for (int i = 0; i < 2; ++i) {
    model::Case c = one_line(cable_type(1e8, 1), 10, 20 << i, anchor(Vec3::Zero()), {});
    c.environment.gravity = 9.81;
    run::Simulation s(PETSC_COMM_WORLD, c);
    s.solve_statics();
    error[i] = frequency_error(frequencies(s), exact, 3, 2);
  }
  std::printf("hanging chain: first 3 frequencies within %.2e %.2e (20, 40 elements)\n", error[0], error[1]);
  EXPECT_LT(error[1], 5e-3);
}

// Held at both ends, tension 100 kN at the lower one, 600 N/m, 150 kg/m, 300 m. Cable by Bessel functions,
// riser (EI = 2e7 N m², pinned) by Chebyshev collocation.
TEST(Modes, VerticalCableAndRiser) {
  const std::vector<double> cable{0.36021971121025215, 0.7222126680579809, 1.0838280130088025};
  const std::vector<double> riser{0.3633503983713026, 0.743847975352001, 1.1523732179300605};
  const double L = 300, T = 1e5, m = 150, w = 600, EA = 1e12;
  for (bool bends : {false, true}) {
    const model::LineType t = bends ? beam_type(EA, 2e7, 2e7, m) : cable_type(EA, m);
    model::Case c =
        one_line(t, unstretched(L, T, w, EA), bends ? 20 : 40, anchor(Vec3::Zero()), anchor(Vec3(0, 0, L)));
    c.environment.gravity = w / m;
    run::Simulation s(PETSC_COMM_WORLD, c);
    s.solve_statics();
    const double error = frequency_error(frequencies(s), bends ? riser : cable, 3, 2);
    std::printf("vertical %s: first 3 frequencies within %.2e\n",
                bends ? "riser, 20 beams" : "cable, 40 elements", error);
    EXPECT_LT(error, 5e-3);
  }
}

// Irvine & Caughey (1974), Proc. R. Soc. A 341: symmetric in-plane modes, Omega = omega l sqrt(m/H), lambda²
// = (m g l/H)² l EA/(H Le). The theory assumes a flat parabola: the sag is 1/160 of the span.
TEST(Modes, SaggedCable) {
  struct {
    double lambda2;
    std::vector<double> symmetric;
  } const rows[] = {{1, {3.267886207620111, 9.429602888986565, 15.708999311145325}},
                    {10, {4.225833283147767, 9.477636678493196, 15.718696958294755}},
                    {39.47841760435743, {6.283185307179586, 9.718272546111004, 15.755960858324455}},
                    {100, {8.159295885441594, 10.931721654181933, 15.873408309379286}},
                    {400, {8.877714707158677, 15.109726606016936, 19.596175811818206}}};
  const double l = 100, H = 1e5, ratio = 0.05;  // ratio = m g l/H
  const double m = ratio * H / (9.81 * l);
  const double w = 9.81 * m;
  const double Le = l * (1 + ratio * ratio / 8);
  const int n = 60;
  for (const auto& r : rows) {
    const double EA = r.lambda2 * H * Le / (l * ratio * ratio);
    // Unstretched length for which the tension is H.
    double low = 0.5 * l;
    double high = 1.1 * l;
    for (int i = 0; i < 100; ++i) {
      const double L = 0.5 * (low + high);
      const double x = catenary_chord(Vec3(H, 0, -0.5 * w * L), Vec3(0, 0, -w), L, EA).x();
      (x < l ? low : high) = L;
    }
    model::Case c = one_line(cable_type(EA, m), low, n, anchor(Vec3::Zero()), anchor(Vec3(l, 0, 0)));
    c.environment.gravity = 9.81;
    run::Simulation s(PETSC_COMM_WORLD, c);
    s.solve_statics();
    const ModalMatrices a = modal_matrices(s.system(), s.state().at_rest());
    // Symmetric modes: both halves move equally, x opposite, z equal.
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(a.dof.size()), n - 1);
    for (int i = 1; i < n / 2; ++i) {
      const int x = i - 1;
      const int z = n / 2 - 1 + i - 1;
      B(a.row(i, 0), x) = 1;
      B(a.row(n - i, 0), x) = -1;
      B(a.row(i, 2), z) = 1;
      B(a.row(n - i, 2), z) = 1;
    }
    B(a.row(n / 2, 2), n - 2) = 1;
    std::vector<double> exact;
    for (double O : r.symmetric) exact.push_back(O / l * std::sqrt(H / m));
    const std::vector<double> omega = natural_frequencies(restricted(a.K, B), restricted(a.M, B));
    const double error = frequency_error(omega, exact, 3, 1);
    std::printf("sagged cable lambda² %5.1f: first 3 symmetric frequencies within %.2e (60 elements)\n",
                r.lambda2, error);
    EXPECT_LT(error, 5e-3) << "lambda² " << r.lambda2;
  }
}

}  // namespace hawser::modes_lines_test

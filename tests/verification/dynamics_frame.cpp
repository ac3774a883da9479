// A right-angled cantilever loaded out of its plane at the elbow (Simo & Vu-Quoc 1988) against spectral
// elements.
#include <algorithm>

#include "verification/dynamics_rig.hpp"

namespace hawser::test::dynamics_frame_test {
namespace {

// (t, elbow, tip), m: spectral elements of order 10 and 12, which differ by less than 2e-5 m up to 30 s.
constexpr double kPath[][7] = {
    {1.0, 9.9458038844, 0.0228816104, 0.951314752, 9.9969829213, 9.9766114006, 0.0540318465},
    {2.0, 8.988885405, 0.2673888251, 4.1152448114, 10.1062606252, 9.3078499947, 0.0692636439},
    {3.0, 7.9508795229, 0.2396606448, 5.5016698851, 10.7884973694, 8.9384995588, 1.5072078414},
    {4.0, 8.4356046047, -0.4276578985, 4.6420665195, 10.4419816063, 9.2937585651, 3.5089340935},
    {5.0, 9.1482022395, -0.7642699285, 3.1114168909, 9.4593217421, 8.9375252408, 5.4793981229},
    {6.0, 9.4210365178, -0.7783453961, 2.5406883738, 8.7763513463, 8.1816397525, 6.9133544902},
    {7.0, 9.6225663906, -0.7270877647, 2.45767848, 8.9735780441, 7.5591003755, 8.0060240635},
    {8.0, 9.8061026684, -0.3268238555, 1.6333173073, 10.0232058537, 7.3551703145, 7.9605547929},
    {9.0, 9.9091229759, 0.7593385135, -0.6698971939, 9.9984644677, 7.386021609, 6.7682841259},
    {10.0, 9.2276329629, 1.6287947126, -3.0959698791, 10.0043205052, 8.0297225348, 4.4631196138},
    {15.0, 9.9677917512, 0.4062305343, 0.1598484538, 7.793269747, 2.7132205655, -9.2044031142},
    {20.0, 9.4696220282, 0.7823384572, -2.6019417748, 14.0930023764, 9.0431971513, 0.496027387},
    {25.0, 7.3972254939, 0.3996018728, 6.0540531524, 6.6276091256, 10.3496695418, 6.6378144027},
    {30.0, 9.8742294038, -1.3329010169, -0.223686811, 8.2634456087, 8.4989877975, 0.1685385543}};
constexpr double kEnergy = 114.8803442;  // J, after the load has ended; of the same solution

struct Frame {
  double tip = 0, elbow = 0;     // m, largest error up to 10 s
  double late = 0;               // m, largest error of the tip up to 30 s
  double low = 1e300, high = 0;  // J, energy from 2 s on
};

Frame frame(int per_leg, double h, double rho, double until) {
  const double L = 10.0 / per_leg;
  BeamChain::Piece along_x{{L, 1e6, 1e3, 1e3, 1e3, 1e6, 0}, Vec3(20, 10, 10), 1};
  BeamChain::Piece along_y = along_x;
  static const Mat3 axes_y{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};  // columns y, -x, z
  along_y.axes = &axes_y;
  std::vector<Vec3> nodes{Vec3::Zero()};
  std::vector<BeamChain::Piece> pieces;
  for (int i = 1; i <= per_leg; ++i) {
    nodes.push_back({i * L, 0, 0});
    pieces.push_back(along_x);
  }
  for (int i = 1; i <= per_leg; ++i) {
    nodes.push_back({10, i * L, 0});
    pieces.push_back(along_y);
  }
  BeamChain chain(nodes, pieces);
  System& system = chain.system();
  system.add(std::make_unique<TimedLoad>(system.mesh(), per_leg, Vec3::UnitZ(), Vec3::Zero(), [](double t) {
    return t < 1 ? 50 * t : t < 2 ? 50 * (2 - t) : 0.0;
  }));
  TiedNode root;
  root.rotation_mask = 7;
  system.tie({root}, {});
  DynamicsSettings settings;
  settings.step.fixed = h;
  settings.rho_infinity = rho;
  Dynamics d(system, settings);
  d.start(chain.state);
  Frame out;
  size_t next = 0;
  integrate(d, until, 1, [&](const StepInfo& i) {
    if (i.time > 2 + 1e-9) {
      const double e = total(system.energy(d.committed_kinematics()));
      out.low = std::min(out.low, e);
      out.high = std::max(out.high, e);
    }
    if (next == std::size(kPath) || std::abs(i.time - kPath[next][0]) > 1e-6) return;
    const double* p = kPath[next++];
    const auto& x = d.committed().s.x;
    const double tip = (x.back() - Vec3(p[4], p[5], p[6])).norm();
    out.late = std::max(out.late, tip);
    if (i.time > 10 + 1e-6) return;
    out.tip = std::max(out.tip, tip);
    out.elbow = std::max(out.elbow, (x[static_cast<size_t>(per_leg)] - Vec3(p[1], p[2], p[3])).norm());
  });
  EXPECT_GE(next, 10u);
  return out;
}

void show(int n, double h, double rho, const Frame& f) {
  printf(
      "frame, 2 x %d elements, h = %.4f s, rho = %.2f: tip off by %.4f m, elbow %.4f m (to 10 s), tip %.4f m "
      "later; energy %.5f to %.5f J\n",
      n, h, rho, f.tip, f.elbow, f.late, f.low, f.high);
}

TEST(Dynamics, RightAngleFrame) {
  const Frame coarse = frame(10, 0.005, 0.9, 10);
  const Frame fine = frame(20, 0.005, 0.9, 10);
  const Frame finest = frame(40, 0.0025, 0.9, 30);
  show(10, 0.005, 0.9, coarse);
  show(20, 0.005, 0.9, fine);
  show(40, 0.0025, 0.9, finest);
  for (const Frame& f : {coarse, fine, finest}) {
    EXPECT_LT(f.tip, 0.15);
    EXPECT_LT(f.elbow, 0.15);
    EXPECT_GT(f.low, 0.995 * kEnergy);
    EXPECT_LT(f.high, 1.005 * kEnergy);
    EXPECT_LT(f.high - f.low, 1e-4 * kEnergy);
  }
  // The error falls with the square of the element length.
  EXPECT_LT(fine.tip, 0.3 * coarse.tip);
  EXPECT_LT(finest.tip, 0.3 * fine.tip);
  EXPECT_LT(finest.late, 0.02);
}

}  // namespace
}  // namespace hawser::test::dynamics_frame_test

// Friction law of a point: against published formulas and paths, the continuous law, and closed forms.
#include "hawser/kernels/friction_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "hawser/math/so3.hpp"

namespace hawser::friction_law_test {
namespace {

// The plane z = 0, line along x.
Friction<double> flat(const FrictionLaw& law, double N, double a, double l) {
  return friction<double>(law, N, {a, l, 0}, {0, 0, 1}, {1, 0, 0});
}

// N = 1000, mu = (0.3, 0.8), d = (0.01, 0.04): OMAE2006-92155 eqs (6)-(10) with radial return, independently
// evaluated in double precision. The reference force resists: opposite to the force on the point.
const FrictionLaw kPaper{0.3, 0.8, 0, 0.01, 0.04, FrictionReturn::radial, FrictionSpring::michalopoulos};

TEST(FrictionLaw, PaperFormula) {
  struct Row {
    double a, l, fa, fl;
  };
  const Row rows[] = {{0.002, 0, 60, 0},
                      {0, 0.01, 0, 200},
                      {0.01, 0, 300, 0},
                      {0, 0.04, 0, 800},
                      {0.006, 0, 180, 0},
                      {0.006, 0.03, 56.50901902147329, 753.4535869529773},
                      {0.002, 0.01, 18.836339673824433, 251.1511956509924},
                      {0.005, 0.02, 51.44957554275265, 548.7954724560284},
                      {0.007, 0.03, 68.16888468192553, 779.0729677934346},  // slides from here on
                      {0.02, 0.05, 111.41720290623111, 742.7813527082074},
                      {-0.003, 0.06, -14.981285083167672, 799.0018711022758}};
  for (const Row& r : rows) {
    const Friction<double> f = flat(kPaper, 1000, r.a, r.l);
    EXPECT_NEAR(f.force.x(), -r.fa, 1e-9);
    EXPECT_NEAR(f.force.y(), -r.fl, 1e-9);
    const double R = std::hypot(r.a / 0.01, r.l / 0.04);
    EXPECT_EQ(f.slides, R > 1);
    EXPECT_NEAR((f.slip * std::max(R, 1.0) - Vec3(r.a, r.l, 0)).norm(), 0, 1e-15);
  }
}

struct PathRow {
  double U[2], f[2], origin[2], work;
};

FrictionLaw with(FrictionLaw law, FrictionReturn return_rule) {
  law.return_rule = return_rule;
  return law;
}

// Work by the trapezoidal rule.
void expect_path(const FrictionLaw& law, int increments, const std::vector<PathRow>& rows, double tolerance) {
  Vec3 slip = Vec3::Zero(), U = Vec3::Zero(), force = Vec3::Zero();
  double work = 0;
  for (const PathRow& row : rows) {
    const Vec3 d = (Vec3(row.U[0], row.U[1], 0) - U) / increments;
    for (int i = 0; i < increments; ++i) {
      const Friction<double> f = friction<double>(law, 1000, slip + d, {0, 0, 1}, {1, 0, 0});
      work -= 0.5 * (f.force + force).dot(d);
      slip = f.slip;
      force = f.force;
    }
    U = {row.U[0], row.U[1], 0};
    EXPECT_NEAR(force.x(), -row.f[0], tolerance * 1000);
    EXPECT_NEAR(force.y(), -row.f[1], tolerance * 1000);
    EXPECT_NEAR(U.x() - slip.x(), row.origin[0], 0.02 * tolerance);
    EXPECT_NEAR(U.y() - slip.y(), row.origin[1], 0.02 * tolerance);
    EXPECT_NEAR(work, row.work, tolerance * row.work + 1e-14);
  }
}

// The same path with radial return and with return to the nearest point; the tables are an independent
// evaluation of the paper's equations, in double precision with nearest points of forty digits.
TEST(FrictionLaw, PaperPathOneStepALeg) {
  expect_path(kPaper, 1,
              {{{0.006, 0.0}, {180.0, 0.0}, {0.0, 0.0}, 0.54},
               {{0.006, 0.03}, {56.50901902147329, 753.4535869529773}, {0.0, 0.0}, 11.84180380429466},
               {{0.02, 0.03},
                {166.41005886756875, 665.6402354702749},
                {0.010636708224309553, 0.01595506233646433},
                13.402237349517954},
               {{-0.02, 0.03},
                {-272.70895009510326, 333.3848337605079},
                {-0.010065035816968009, 0.02544546523671805},
                15.528215174068643},
               {{-0.02, -0.05},
                {-39.16708155928443, -793.152650448142},
                {-0.015339623229414533, -0.014609405010667063},
                33.91892784157401},
               {{0.0, 0.0},
                {217.23968167015445, 551.7288912845186},
                {-0.009728053572052746, -0.009264965147713692},
                29.664059863592122}},
              1e-12);
  expect_path(with(kPaper, FrictionReturn::associated), 1,
              {{{0.006, 0.0}, {180.0, 0.0}, {0.0, 0.0}, 0.54},
               {{0.006, 0.03}, {56.509019021473296, 753.45358695297728}, {0.0, 0.0}, 11.841803804294659},
               {{0.02, 0.03},
                {78.627494420877101, 772.03439011988724},
                {0.012642598469126566, 0.0029094429105634668},
                12.787759398391112},
               {{-0.02, 0.03},
                {-101.46558297823162, 752.85405625207378},
                {-0.01179077026982067, 0.007158442351839556},
                13.244521169538202},
               {{-0.02, -0.05},
                {-7.7489361664970686, -799.73308430934237},
                {-0.018971939946833797, -0.010211942992484008},
                15.119682291828946},
               {{0.0, 0.0},
                {212.88267998996559, 563.67659481287612},
                {-0.0097054448968039426, -0.0096368786275244185},
                11.269607492651975}},
              1e-12);
}

TEST(FrictionLaw, PaperPathTenStepsALeg) {
  expect_path(kPaper, 10,
              {{{0.006, 0.0}, {180.0, 0.0}, {0.0, 0.0}, 0.54},
               {{0.006, 0.03}, {56.50901902147329, 753.4535869529773}, {0.0, 0.0}, 15.304011567002503},
               {{0.02, 0.03},
                {208.37374780541083, 575.53302815098},
                {0.010319279769251627, 0.019973111498392666},
                17.136592151397867},
               {{-0.02, 0.03},
                {-295.36980921964425, 140.01081359002268},
                {-0.010009859635122857, 0.02822418248661691},
                22.635038090768095},
               {{-0.02, -0.05},
                {-24.25846431851841, -797.3802746891471},
                {-0.016913364989281785, -0.011953147975558652},
                77.44290796758501},
               {{0.0, 0.0},
                {223.50698124805086, 533.6307792780967},
                {-0.009758533698585085, -0.008737065918102511},
                64.63415838440208}},
              1e-12);
  expect_path(with(kPaper, FrictionReturn::associated), 10,
              {{{0.006, 0.0}, {180.0, 0.0}, {0.0, 0.0}, 0.54},
               {{0.006, 0.03}, {56.509019021473296, 753.45358695297728}, {0.0, 0.0}, 15.304011567002504},
               {{0.02, 0.03},
                {79.787785724823702, 771.18740999003865},
                {0.012589720997229965, 0.0031410305183224033},
                16.30675488339827},
               {{-0.02, 0.03},
                {-104.90874311748931, 749.49063885048349},
                {-0.011691417330716539, 0.0077406364771379792},
                18.613226241132948},
               {{-0.02, -0.05},
                {-1.3949648715488472, -799.99135138883826},
                {-0.019814034837567917, -0.010006917206424487},
                46.544583691309257},
               {{0.0, 0.0},
                {208.67881813049624, 574.74648085280885},
                {-0.0096824376610348994, -0.010000320746994489},
                29.263729003448466}},
              1e-12);
}

// A thousand steps per leg: the table with the same steps, and the exact continuum (ordinary differential
// equations of the slip, to 1e-12; work in the limit of 1e5 steps) to 1e-3 of N, since the return is of first
// order: the table itself is 0.46 N off on the fourth leg, 1.5e-3 of the force there.
TEST(FrictionLaw, PaperPathThousandStepsALeg) {
  expect_path(kPaper, 1000,
              {{{0.006, 0.0}, {180.0, 0.0}, {0.0, 0.0}, 0.5400000000000003},
               {{0.006, 0.03}, {56.50901902147329, 753.4535869529773}, {0.0, 0.0}, 15.352586978417166},
               {{0.02, 0.03},
                {216.28266176203843, 554.3961534009742},
                {0.010276808880899444, 0.020653724197141135},
                17.23869908475268},
               {{-0.02, 0.03},
                {-297.79635490471225, 96.7868128930033},
                {-0.01000463878141893, 0.02878177762236587},
                22.890918725279278},
               {{-0.02, -0.05},
                {-21.318015856241953, -797.9776313209254},
                {-0.01725949082837473, -0.011531392646941266},
                78.7549574990276},
               {{0.0, 0.0},
                {214.3741749402908, 559.6425088686182},
                {-0.00971332174664765, -0.009509053072605541},
                65.79606785778077}},
              1e-11);
  expect_path(with(kPaper, FrictionReturn::associated), 1000,
              {{{0.006, 0.0}, {180.0, 0.0}, {0.0, 0.0}, 0.54},
               {{0.006, 0.03}, {56.509019021473296, 753.45358695297728}, {0.0, 0.0}, 15.352586978417171},
               {{0.02, 0.03},
                {79.93965529071557, 771.07556170787975},
                {0.012582887397280618, 0.0031712271950933046},
                16.35928104939259},
               {{-0.02, 0.03},
                {-105.56336304291345, 748.83673406131011},
                {-0.011673235774389452, 0.0078496058613514063},
                18.698973753863574},
               {{-0.02, -0.05},
                {-0.044900209932856189, -799.99999103987172},
                {-0.019994013306348065, -0.010000007168100819},
                46.891870689442947},
               {{0.0, 0.0},
                {206.79424429112619, 579.570050774803},
                {-0.0096717212938121149, -0.010164886395682981},
                29.597765204981003}},
              1e-11);
  expect_path(kPaper, 1000,
              {{{0.006, 0.0}, {180.0, 0.0}, {0.0, 0.0}, 0.5400000000000016},
               {{0.006, 0.03}, {56.50901902147329, 753.4535869529773}, {0.0, 0.0}, 15.352591756941342},
               {{0.02, 0.03},
                {216.3698159397399, 554.1542681332817},
                {0.010276363696982614, 0.020661137502549966},
                17.23930107738766},
               {{-0.02, 0.03},
                {-297.8171822576171, 96.3300235512911},
                {-0.010004594486768499, 0.0287876064925192},
                22.892832333284396},
               {{-0.02, -0.05},
                {-21.286306363183407, -797.9836507884115},
                {-0.017263280778210894, -0.011527075931020779},
                78.76354995037966},
               {{0.0, 0.0},
                {214.25514465833777, 559.9665576518164},
                {-0.009712698462703864, -0.009519234063801604},
                65.80545273062825}},
              1e-3);
}

// A hundred thousand steps per leg: rounding accumulates, mostly in the nearest points of the reference.
TEST(FrictionLaw, PaperPathHundredThousandStepsALeg) {
  expect_path(kPaper, 100000,
              {{{0.006, 0}, {180.0, 0.0}, {0.0, 0.0}, 0.5400000000000016},
               {{0.006, 0.03}, {56.50901902147329, 753.4535869529773}, {0.0, 0.0}, 15.352591756941342},
               {{0.02, 0.03},
                {216.36894373341167, 554.1566898362083},
                {0.010276368149854297, 0.020661063321485023},
                17.23930107738766},
               {{-0.02, 0.03},
                {-297.81697441266294, 96.33459290294401},
                {-0.010004594928760534, 0.02878754819087689},
                22.892832333284396},
               {{-0.02, -0.05},
                {-21.28662366320246, -797.9835905994111},
                {-0.01726324284830673, -0.011527119100819966},
                78.76354995037966},
               {{0, 0},
                {214.2563377636171, 559.9633113576738},
                {-0.009712704714776673, -0.009519131997029995},
                65.80545273062825}},
              1e-9);
  expect_path(with(kPaper, FrictionReturn::associated), 100000,
              {{{0.006, 0}, {180.0, 0.0}, {0.0, 0.0}, 0.5400000000000016},
               {{0.006, 0.03}, {56.50901902147329, 753.4535869529773}, {0.0, 0.0}, 15.352591756941342},
               {{0.02, 0.03},
                {79.94124890258962, 771.0743867695869},
                {0.012582815797070775, 0.0031715439181480634},
                16.359297540558824},
               {{-0.02, 0.03},
                {-105.57036632228082, 748.8297113232198},
                {-0.011673042463520699, 0.007850768785317399},
                18.69909186503235},
               {{-0.02, -0.05},
                {-0.04081478144637809, -799.999992577888},
                {-0.01999455802989594, -0.010000005923925671},
                46.893905586483136},
               {{0, 0},
                {206.77467853641363, 579.6196896424104},
                {-0.00967160868094147, -0.010166600538934456},
                29.600712659867778}},
              1e-8);
}

// Fraction of a leg in which the point sticks, to one of a thousand steps; the first two legs have no
// sliding.
TEST(FrictionLaw, PartOfALegThatSticks) {
  const double U[][2] = {{0, 0},        {0.006, 0},     {0.006, 0.03}, {0.02, 0.03},
                         {-0.02, 0.03}, {-0.02, -0.05}, {0, 0}};
  const double sticks[] = {
      1, 1, 0.043884162690105484, 0.4861818151508692, 0.030309837687016325, 0.629077832454264};
  Vec3 slip = Vec3::Zero();
  for (int leg = 0; leg < 6; ++leg) {
    const Vec3 d = Vec3(U[leg + 1][0] - U[leg][0], U[leg + 1][1] - U[leg][1], 0) / 1000;
    int stuck = 0, slid = 0;
    for (int i = 0; i < 1000; ++i) {
      const Friction<double> f = friction<double>(kPaper, 1000, slip + d, {0, 0, 1}, {1, 0, 0});
      slip = f.slip;
      slid += f.slides;
      stuck += !f.slides;
      EXPECT_TRUE(f.slides || slid == 0) << leg;  // sliding continues to the end of the leg
    }
    EXPECT_NEAR(stuck / 1000., sticks[leg], 1e-3) << leg;
  }
}

// A closed path around a rectangle inside the stick ellipse (R up to 0.87). With springs, given by length or
// stiffness, the net work is zero for any lengths; the paper's law gains 5.37558 J in one direction (78 % of
// the stored energy) and loses it in the other.
TEST(FrictionLaw, ClosedLoopInsideStick) {
  const auto loop = [](const FrictionLaw& law, bool anticlockwise) {
    std::vector<Vec3> corners{{0, 0, 0}, {0.006, 0, 0}, {0.006, 0.025, 0}, {0, 0.025, 0}, {0, 0, 0}};
    if (!anticlockwise) std::reverse(corners.begin(), corners.end());
    Vec3 slip = Vec3::Zero();
    double work = 0;
    for (size_t c = 1; c < corners.size(); ++c) {
      // Gauss-Legendre on 400 pieces of each leg: the force is smooth there.
      const int pieces = 400;
      const Vec3 d = (corners[c] - corners[c - 1]) / pieces;
      for (int i = 0; i < pieces; ++i)
        for (const double x : {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)}) {
          const Friction<double> f =
              friction<double>(law, 1000, corners[c - 1] + (i + x) * d, {0, 0, 1}, {1, 0, 0});
          EXPECT_FALSE(f.slides);
          work -= (x == 0.5 ? 4.0 : 2.5) / 9 * f.force.dot(d);
        }
      slip = friction<double>(law, 1000, slip + corners[c] - corners[c - 1], {0, 0, 1}, {1, 0, 0}).slip;
    }
    EXPECT_LT(slip.norm(), 1e-17);
    return work;
  };
  FrictionLaw springs = kPaper;
  springs.spring = FrictionSpring::elliptic;
  for (const FrictionReturn return_rule : {FrictionReturn::radial, FrictionReturn::associated})
    for (const bool way : {true, false}) {
      EXPECT_LT(std::abs(loop(with(springs, return_rule), way)), 1e-12);
      EXPECT_LT(std::abs(loop({0.3, 0.8, 2e4, 0, 0, return_rule}, way)), 1e-12);
    }
  EXPECT_NEAR(loop(kPaper, true), 5.375583661277789, 1e-8);
  EXPECT_NEAR(loop(kPaper, false), -5.375583661277789, 1e-8);
  const Vec3 far = flat(kPaper, 1000, 0.006, 0.025).force;  // at the farthest corner
  EXPECT_NEAR(std::hypot(far.x() / 300, far.y() / 800), 0.8663861725581729, 1e-12);
}

// Associated return: the nearest point on the slip surface in the norm of the springs, against a search.
TEST(FrictionLaw, AssociatedReturnIsNearest) {
  const FrictionLaw lengths{0.3, 0.8, 0, 0.01, 0.04, FrictionReturn::associated};
  const FrictionLaw springs{0.3, 0.8, 3e4, 0, 0, FrictionReturn::associated};
  for (const FrictionLaw& law : {lengths, springs})
    for (const Vec3& trial :
         {Vec3(0.012, 0.005, 0), Vec3(0.3, -0.4, 0), Vec3(-1e-6, 0.05, 0), Vec3(0.5, 0, 0)}) {
      const Friction<double> f = friction<double>(law, 1000, trial, {0, 0, 1}, {1, 0, 0});
      ASSERT_TRUE(f.slides);
      const double on = std::pow(f.force.x() / 300, 2) + std::pow(f.force.y() / 800, 2);
      EXPECT_NEAR(on, 1, 1e-13);
      const bool by_length = law.stiffness == 0;
      const double ka = by_length ? 300 / 0.01 : 3e4;
      const double kl = by_length ? 800 / 0.04 : 3e4;
      const double da = 300 / ka;
      const double dl = 800 / kl;
      const auto far = [&](double a, double l) {
        return ka * std::pow(a - trial.x(), 2) + kl * std::pow(l - trial.y(), 2);
      };
      double best = 1e300;
      for (int i = 0; i < 100000; ++i) {
        const double t = 2 * std::numbers::pi * i / 100000;
        best = std::min(best, far(da * std::cos(t), dl * std::sin(t)));
      }
      const double found = far(f.slip.x(), f.slip.y());
      EXPECT_LE(found, best * (1 + 1e-12));
      EXPECT_NEAR(found, best, 1e-6 * best);
    }
}

// With isotropic friction the two returns are equal.
TEST(FrictionLaw, ReturnsAgreeWhereIsotropic) {
  for (const double lateral : {0.4, 0.4 + 1e-13}) {
    const FrictionLaw law{0.4, lateral, 0, 0.01, 0.01};
    const Friction<double> a = flat(law, 700, 0.03, -0.02);
    const Friction<double> b = flat(with(law, FrictionReturn::associated), 700, 0.03, -0.02);
    EXPECT_LT((a.force - b.force).norm(), 1e-9);
  }
}

TEST(FrictionLaw, CoefficientsFallWithSpeed) {
  FrictionLaw law{0.5, 0.6, 1e5, 0, 0};
  law.axial_kinetic = 0.3;
  law.lateral_kinetic = 0.2;
  law.blend_speed = 0.1;
  const Coulomb<double> still = coulomb_at(law, 0.0);
  const Coulomb<double> slow = coulomb_at(law, 0.01);
  const Coulomb<double> fast = coulomb_at(law, 1e4);
  EXPECT_EQ(still.axial, 0.5);
  EXPECT_EQ(still.lateral, 0.6);
  EXPECT_NEAR(slow.axial, 0.3 + 0.2 / std::numbers::e, 1e-15);
  EXPECT_NEAR(fast.lateral, 0.2, 1e-15);
  const Friction<double> f =
      friction<double, double>(law, fast, 1000, 1000, {0.5, 0, 0}, {0, 0, 1}, {1, 0, 0});
  EXPECT_NEAR(f.force.x(), -300, 1e-9);
}

// Isotropic steady circle of radius rho: the force lags behind the motion by asin(d/rho) and does the work 2
// pi rho mu N sqrt(1 - (d/rho)²) per turn. With steps of an angle h the displacement is a chord, and the lag
// behind it is asin(d/rho cos(h/2)) exactly: d sin h = 2 rho sin(h/2) sin(lag). Work by the force at the end
// of each step.
TEST(FrictionLaw, SteadyCircle) {
  const FrictionLaw law{0.5, 0.5, 0, 0.01, 0.01};
  const double rho = 0.05, N = 1000, exact = 153.90597961942368;
  for (const int steps : {1000, 20000}) {
    Vec3 slip = Vec3::Zero();
    double work = 0, lag = 0, behind_the_circle = 0;
    const auto at = [&](int i) {
      const double t = 2 * std::numbers::pi * i / steps;
      return Vec3(rho * std::cos(t), rho * std::sin(t), 0);
    };
    for (int i = 1; i <= 3 * steps; ++i) {
      const Vec3 d = at(i) - at(i - 1);
      const Friction<double> f = friction<double>(law, N, slip + d, {0, 0, 1}, {1, 0, 0});
      if (i > 2 * steps) work -= f.force.dot(d);
      slip = f.slip;
      lag = d.cross(f.force).z() / (d.norm() * f.force.norm());  // sine
      behind_the_circle = -at(i).dot(f.force) / (rho * f.force.norm());
    }
    const double h = 2 * std::numbers::pi / steps;
    EXPECT_NEAR(lag, 0.2 * std::cos(h / 2), 1e-12);
    EXPECT_NEAR(lag, 0.2, 1e-3 * 0.2);
    EXPECT_NEAR(work, exact, 2e-6 * exact);
    // Relative to the tangent of the circle at the end of a step the lag is larger by half a step.
    EXPECT_NEAR(behind_the_circle, std::sin(std::asin(lag) + h / 2), 1e-12);
    if (steps > 1000) {
      EXPECT_NEAR(behind_the_circle, 0.2, 1e-3 * 0.2);
    }
  }
}

TEST(FrictionLaw, SpringsAndEllipse) {
  const FrictionLaw law{0.3, 0.8, 1e5, 0, 0};
  Friction<double> f = flat(law, 1000, 0.001, -0.002);  // sticks: 100 and 200 N are inside
  EXPECT_NEAR((f.force - Vec3(-100, 200, 0)).norm(), 0, 1e-10);
  EXPECT_FALSE(f.slides);
  f = flat(law, 1000, 0.005, 0.01);  // 500 and 1000 N: sqrt((5/3)² + (5/4)²) = 25/12
  EXPECT_NEAR((f.force - Vec3(-240, -480, 0)).norm(), 0, 1e-10);
  EXPECT_NEAR((f.slip - Vec3(0.0024, 0.0048, 0)).norm(), 0, 1e-15);
  EXPECT_TRUE(f.slides);
  f = flat({0.3, 0, 1e5, 0, 0}, 1000, 0.005, 0.01);  // no friction across
  EXPECT_NEAR((f.force - Vec3(-300, 0, 0)).norm(), 0, 1e-10);
  f = flat({0.3, 0.3, 1e5, 0, 0}, 1000, 0.003, 0.004);
  EXPECT_NEAR((f.force - Vec3(-180, -240, 0)).norm(), 0, 1e-10);
  EXPECT_EQ(flat(law, 0, 0.005, 0.01).force.norm(), 0);
}

// Both laws with equal lengths agree with the isotropic branch.
TEST(FrictionLaw, IsotropicIsTheLimit) {
  for (double s : {0.004, 0.03}) {
    const Friction<double> a = flat({0.4, 0.4, 0, 0.01, 0.01}, 700, s, 0.5 * s);
    const Friction<double> b = flat({0.4, 0.4 + 1e-13, 0, 0.01, 0.01}, 700, s, 0.5 * s);
    EXPECT_LT((a.force - b.force).norm(), 1e-8);
    const Friction<double> c = flat({0.4, 0.4, 3e4, 0, 0}, 700, s, 0.5 * s);
    const Friction<double> d = flat({0.4, 0.4 + 1e-13, 3e4, 0, 0}, 700, s, 0.5 * s);
    EXPECT_LT((c.force - d.force).norm(), 1e-8);
  }
}

TEST(FrictionLaw, SlipTurnsWithTheNormal) {
  const Vec3 from = Vec3(1, 2, -1).normalized();
  const Vec3 to = Vec3(1, 1.5, 0.3).normalized();
  const Vec3 slip = 0.01 * from.cross(Vec3(0.3, -0.4, 1)).normalized();
  const Vec3 turned = transport_slip<double>(slip, from, to);
  EXPECT_NEAR(turned.dot(to), 0, 1e-16);
  EXPECT_LT((turned - minimal_rotation(from, to) * slip).norm(), 1e-16);
  EXPECT_LT((transport_slip<double>(slip, from, from) - slip).norm(), 1e-18);
  EXPECT_TRUE(transport_slip<double>(slip, from, -from).allFinite());
}

}  // namespace
}  // namespace hawser::friction_law_test

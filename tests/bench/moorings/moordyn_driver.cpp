// Runs a deck of MoorDyn 2 whose coupled points all make the same prescribed motion, through MoorDyn's C
// interface, for tests/bench/beside_moordyn.py, which compiles it against a libmoordyn of the user's:
//
//   c++ -O3 -march=native moordyn_driver.cpp /path/to/libmoordyn.so -Wl,-rpath,/path/to -o driver
//   ./driver DECK SECONDS STEP RAMP OUTPUT [AX AY AZ PERIOD]...
//
// Offsets are the sum of A sin(2 pi t/PERIOD), times half a cosine over RAMP. MoorDyn keeps velocities
// constant during a call, so it is called once per step with the mean velocity of the step. OUTPUT has a row
// every 0.1 s: time, force on the first coupled point, tension of the last segment there (FairTen), largest
// curvature of all lines.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

// The part of MoorDyn's C interface (MoorDyn2.h, Line.h) that is used here.
extern "C" {
void* MoorDyn_Create(const char* deck);
int MoorDyn_SetVerbosity(void* system, int verbosity);
int MoorDyn_NCoupledDOF(void* system, unsigned int* n);
int MoorDyn_Init(void* system, const double* x, const double* xd);
int MoorDyn_Step(void* system, const double* x, const double* xd, double* f, double* t, double* dt);
int MoorDyn_GetNumberPoints(void* system, unsigned int* n);
void* MoorDyn_GetPoint(void* system, unsigned int number);
int MoorDyn_GetPointType(void* point, int* type);
int MoorDyn_GetPointPos(void* point, double* position);
int MoorDyn_GetNumberLines(void* system, unsigned int* n);
void* MoorDyn_GetLine(void* system, unsigned int number);
int MoorDyn_GetLineNumberNodes(void* line, unsigned int* n);
int MoorDyn_GetLineNodeCurv(void* line, unsigned int i, double* curvature);
int MoorDyn_GetLineFairTen(void* line, double* tension);
int MoorDyn_Close(void* system);
}

int main(int argc, char** argv) {
  if (argc < 6 || (argc - 6) % 4 != 0) {
    std::fprintf(stderr, "see the head of this source\n");
    return 2;
  }
  const double seconds = std::atof(argv[2]);
  const double ramp = std::atof(argv[4]);
  double step = std::atof(argv[3]);
  std::vector<double> motion;
  for (int k = 6; k < argc; ++k) motion.push_back(std::atof(argv[k]));
  const auto offset = [&](double t, std::size_t axis) {
    double sum = 0;
    for (std::size_t k = 0; k < motion.size(); k += 4)
      sum += motion[k + axis] * std::sin(2 * M_PI * t / motion[k + 3]);
    return t < ramp ? sum * (1 - std::cos(M_PI * t / ramp)) / 2 : sum;
  };
  void* system = MoorDyn_Create(argv[1]);
  if (system == nullptr) return 1;
  unsigned int n = 0, points = 0, lines = 0;
  MoorDyn_SetVerbosity(system, 3);
  MoorDyn_NCoupledDOF(system, &n);
  MoorDyn_GetNumberPoints(system, &points);
  MoorDyn_GetNumberLines(system, &lines);
  std::vector<double> rest;
  std::vector<double> x(n);
  std::vector<double> v(n, 0.0);
  std::vector<double> f(n);
  for (unsigned int i = 1; i <= points; ++i) {
    int type = 0;
    double at[3];
    MoorDyn_GetPointType(MoorDyn_GetPoint(system, i), &type);
    MoorDyn_GetPointPos(MoorDyn_GetPoint(system, i), at);
    if (type < 0) rest.insert(rest.end(), at, at + 3);  // coupled
  }
  if (rest.size() != n || MoorDyn_Init(system, rest.data(), v.data()) != 0) return 1;
  std::FILE* out = std::fopen(argv[5], "w");
  if (out == nullptr) return 1;
  const long steps = std::lround(seconds / step);
  const long every = std::max(1L, std::lround(0.1 / step));
  for (long i = 0; i < steps; ++i) {
    double t = static_cast<double>(i) * step;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = offset(t, axis);
      const double speed = (offset(t + step, axis) - from) / step;
      for (std::size_t k = axis; k < n; k += 3) {
        x[k] = rest[k] + from;
        v[k] = speed;
      }
    }
    if (MoorDyn_Step(system, x.data(), v.data(), f.data(), &t, &step) != 0 || !std::isfinite(f[0])) return 3;
    if ((i + 1) % every != 0) continue;
    double bend = 0, tension = 0;
    for (unsigned int l = 1; l <= lines; ++l) {
      unsigned int nodes = 0;
      MoorDyn_GetLineNumberNodes(MoorDyn_GetLine(system, l), &nodes);
      for (unsigned int k = 0; k < nodes; ++k) {
        double curvature = 0;
        MoorDyn_GetLineNodeCurv(MoorDyn_GetLine(system, l), k, &curvature);
        bend = std::max(bend, curvature);
      }
    }
    MoorDyn_GetLineFairTen(MoorDyn_GetLine(system, 1), &tension);
    std::fprintf(out, "%.6f %.9g %.9g %.9g\n", t, std::hypot(f[0], f[1], f[2]), tension, bend);
  }
  std::fclose(out);
  MoorDyn_Close(system);
}

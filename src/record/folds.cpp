// The class Folds: detection of folded elements and the duration of their effect.
#include "hawser/record/folds.hpp"

#include <array>
#include <cmath>

#include "hawser/base/mpi.hpp"

namespace hawser::record {
namespace {

// Chord over arc of a quarter circle: an element bent more sharply is folded.
const double kFolded = 2 * std::sqrt(2.0) / M_PI;
constexpr double kEqual = 1 - 1e-9;  // of the largest tension: a tension that is equal to it

}  // namespace

Folds::Folds(const model::Case& c, const LocalMesh& mesh, const Feeders* feeders)
    : mesh_(mesh), folds_(mesh.elements.size()), worst_(mesh) {
  const auto inside = feeders ? feeders->inside() : std::vector<std::array<int, 2>>();
  for (size_t i = 0; i < folds_.size(); ++i) {
    const Element& e = mesh.element(mesh.elements[i]);
    const model::LineType& t = c.line_types[e.type];
    const auto line = static_cast<size_t>(e.line);
    const bool fed = !inside.empty() && inside[line][0] + inside[line][1] > 0;
    if (!e.beam && !fed) folds_[i].round_trip_time = 2 * t.wave_time(mesh.mesh->lines[line].length);
  }
}

void Folds::update(const Kinematics& state, std::span<const double> before, std::span<const double> after) {
  for (size_t i = 0; i < folds_.size(); ++i) {
    Fold& f = folds_[i];
    if (f.round_trip_time == 0) continue;
    const LocalElement& l = mesh_.elements[i];
    const Element& e = mesh_.element(l);
    const auto a = static_cast<size_t>(l.first);
    const auto b = static_cast<size_t>(l.second);
    const double ratio = (state.x[b] - state.x[a]).norm() / (e.length * (1 + e.free_strain));
    if (ratio < kFolded) {
      f.ratio = std::min(f.ratio, ratio);
      f.waves_end = HUGE_VAL;
    }
    if (f.waves_end <= state.time) {
      f.ratio = 1;
      f.waves_end = 0;
    }
    if (f.waves_end == 0 || ratio <= 1) continue;
    if (f.waves_end == HUGE_VAL) f.waves_end = state.time + f.round_trip_time;
    const bool first = l.first < mesh_.owned;
    const double tension = first ? after[a] : before[b];
    const size_t n = first ? a : b;
    Worst& w = worst_[e.line];
    if (tension > w.tension) w = {tension, state.time, mesh_.node(n).arc, f.ratio};
  }
}

void Folds::gather(MPI_Comm comm) {
  worst_.take_largest(comm, [](const Worst& w) { return w.tension; });
}

std::string Folds::warning(int line, const std::string& name, double largest_tension) const {
  const Worst& w = worst_[line];
  return w.tension > kEqual * largest_tension ? advice::folded_peak(name, w) : "";
}

}  // namespace hawser::record

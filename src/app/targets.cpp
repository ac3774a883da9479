// Trials of the search for lengths: what a line with a target has at rest, the search of each, and the
// sentences about what was found.
#include "hawser/app/targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/app/end_forces.hpp"
#include "hawser/app/simulation.hpp"
#include "hawser/app/touchdown.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/math/declination.hpp"
#include "hawser/math/root_search.hpp"
#include "hawser/model/check.hpp"

namespace hawser::app {
namespace {

using model::LengthTarget;
using Kind = LengthTarget::Kind;

constexpr double kTolerance = 1e-7;  // of the tension, of the length, rad
// Of the length: as near as both sides of a search come. What statics leaves undetermined there.
constexpr double kNarrow = 1e-10, kCoarse = 1e-5;
constexpr double kFirstStep = 0.02, kNextStep = 1e-3;  // of the length
constexpr int kMostTrials = 500;

// Tension [N] and declination [rad] at end A and end B of every line, on every rank.
std::vector<double> ends_of(MPI_Comm comm, Simulation& sim, const Kinematics& at) {
  const LocalMesh& local = sim.local();
  std::vector<Vec3> carried(static_cast<size_t>(local.nodes()), Vec3::Zero());
  const FieldRegistry fields = sim.system().fields();
  for (const FieldSource& f : fields.sources()) {
    if (f.name != "seabed_force" && f.name != "soil_force" && f.name != "contact_force" &&
        f.name != "line_contact_force")
      continue;
    std::vector<double> values(3 * static_cast<size_t>(local.owned));
    f.fill(at, values);
    for (size_t n = 0; n < static_cast<size_t>(local.owned); ++n)
      carried[n] += Eigen::Map<const Vec3>(values.data() + 3 * n).cwiseAbs();
  }
  sim.system().spread(carried);
  EndForces ends(sim.system());
  ends.evaluate(at, carried);
  std::vector<double> out(4 * sim.mesh().lines.size(), 0);
  for (const EndForces::Place& p : ends.places()) {
    if (p.end < 0) continue;
    const SectionForce& s = p.at_end();
    out[2 * static_cast<size_t>(p.end)] = s.tension();
    out[2 * static_cast<size_t>(p.end) + 1] = declination(s.direction);
  }
  MPI_Allreduce(MPI_IN_PLACE, out.data(), static_cast<int>(out.size()), MPI_DOUBLE, MPI_SUM, comm);
  return out;
}

// What the line has of what its target is about.
double reached(const LengthTarget& t, size_t line, double length, const std::vector<double>& ends,
               const std::vector<Touchdown>& down) {
  if (t.kind == Kind::tension || t.kind == Kind::declination)
    return ends[4 * line + (t.at_a ? 0 : 2) + (t.kind == Kind::tension ? 0 : 1)];
  if (t.kind == Kind::laid_length) return down[line].laid;
  const auto& point = t.at_a ? down[line].from_a : down[line].from_b;
  // A line that hangs altogether touches down where its other end is, one that lies altogether at this end.
  if (!point) return (down[line].laid > 0) == t.at_a ? 0 : length;
  return point->arc;
}

std::string value_text(const LengthTarget& t, double value) {
  switch (t.kind) {
    case Kind::tension:
      return fmt::format("{:.6g} N", value);
    case Kind::declination:
      return fmt::format("{:.6g} deg", degrees(value));
    default:
      return fmt::format("{:.6g} m", value);
  }
}

std::string name_of(const LengthTarget& t) {
  const char* end = t.at_a ? "end A" : "end B";
  switch (t.kind) {
    case Kind::tension:
      return fmt::format("tension at {}", end);
    case Kind::declination:
      return fmt::format("declination at {}", end);
    case Kind::touchdown:
      return fmt::format("arc length of the first touchdown point from {}", end);
    default:
      return "laid length";
  }
}

// One line's search.
class Sought {
 public:
  Sought(const model::Case& c, size_t line)
      : line_(line),
        t_(*c.lines[line].target),
        key_(fmt::format("lines.{}.sections[{}]", c.lines[line].name, t_.section)),
        given_(c.lines[line].sections[static_cast<size_t>(t_.section)].length),
        rest_(model::length_of(c.lines[line]) - given_) {
    begin(given_, kFirstStep * given_);
  }

  const std::string& key() const { return key_; }
  double length() const { return length_; }
  bool met() const { return met_; }

  // The next trial; a line that is met stays as it is.
  void choose() { length_ = search_.next(); }
  // What the trial has brought. Whether it has parted from a target that was met.
  bool see(const std::vector<double>& ends, const std::vector<Touchdown>& down) {
    const bool was = met_;
    value_ = reached(t_, line_, rest_ + length_, ends, down), good_ = length_;
    const double scale = t_.kind == Kind::tension       ? t_.value
                         : t_.kind == Kind::declination ? 1
                                                        : rest_ + length_;
    const double off = std::abs(value_ - t_.value);
    near_ = off <= kCoarse * scale;
    met_ = off <= kTolerance * scale || (narrow() && near_);
    return was && !met_;
  }
  void go_on() { search_.tell(value_ - t_.value); }
  void fail(const std::string& why) { search_.fail(), why_ = why; }
  // From what was last reached on.
  void again() { length_ = good_, begin(length_, kNextStep * length_); }
  // No way on: nothing found, or a jump over it.
  bool stuck() const { return search_.exhausted() || (narrow() && !near_); }

  std::string found(const model::Case& c, int trials) const {
    return fmt::format(
        "line {}: section {} is {:.6f} m long ({:g} m in the case), so that the {} is {} (found in "
        "{} statics)",
        c.lines[line_].name, t_.section + 1, length_, given_, name_of(t_), value_text(t_, value_), trials);
  }
  // Why no length does it. For one line.
  [[noreturn]] void refuse(const model::Case& c) const {
    const auto& seen = search_.seen();
    std::string text =
        fmt::format("no length of section {} between {:g} and {:g} m was found that gives {} as the {}",
                    t_.section + 1, t_.least, t_.most, value_text(t_, t_.value), name_of(t_));
    if (!seen.empty()) {
      const auto at = [&](const std::pair<double, double>& s) {
        return fmt::format("{} at {:.6g} m", value_text(t_, s.second + t_.value), s.first);
      };
      const auto [low, high] = std::minmax_element(
          seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
      text += narrow() ? fmt::format("; it jumps over that at {:.9g} m", length_)
                       : fmt::format("; of the lengths tried, {:.6g} to {:.6g} m, it was between {} and {}",
                                     seen.front().first, seen.back().first, at(*low), at(*high));
    }
    if (!why_.empty()) text += "; beyond these: " + why_;
    c.refuse(fmt::format("lines.{}.target", c.lines[line_].name), text);
  }

 private:
  void begin(double from, double step) {
    // A longer line is expected to have less tension, to hang more steeply and to lie more.
    const bool falls = t_.kind == Kind::tension || (t_.kind == Kind::declination && !t_.at_a) ||
                       (t_.kind == Kind::touchdown && t_.at_a);
    search_ = RootSearch(from, falls ? -step : step, t_.least, t_.most);
  }

  bool narrow() const { return search_.bracketed() && search_.width() < kNarrow * length_; }

  size_t line_;
  LengthTarget t_;
  std::string key_;
  double given_, rest_;  // m, of the section as given, of the other sections
  RootSearch search_{1, 1, 0, 2};
  double length_ = 0, value_ = 0, good_ = 0;  // m; its value; m, with which statics was found last
  bool met_ = false, near_ = false;
  std::string why_;
};

}  // namespace

bool has_targets(const model::Case& c) {
  return std::any_of(c.lines.begin(), c.lines.end(), [](const auto& l) { return l.target.has_value(); });
}

MetTargets meet_targets(MPI_Comm comm, const model::Case& c, const std::vector<LoadedVolume>& volumes,
                        const std::function<void(const StaticsReport&)>& told) {
  std::vector<Sought> all;
  for (size_t l = 0; l < c.lines.size(); ++l)
    if (c.lines[l].target) all.emplace_back(c, l);
  // All at once, as if lines did not pull at each other. Where they do: one after the other, round and round.
  bool together = true;
  size_t turn = 0;
  for (int trial = 1; trial <= kMostTrials; ++trial) {
    const auto moves = [&](const Sought& s) { return !s.met() && (together || &s == &all[turn]); };
    io::SectionLengths lengths;
    for (Sought& s : all) {
      if (moves(s)) s.choose();
      lengths[s.key()] = s.length();
    }
    std::string why;
    bool parted = false;
    try {
      MetTargets out{io::with_lengths(c, lengths, comm), {}};
      Simulation sim(comm, out.model, surfaces(volumes), skeletons(out.model, volumes));
      sim.solve_statics(told);
      const Kinematics at = sim.state().view(0);
      const std::vector<double> ends = ends_of(comm, sim, at);
      const std::vector<Touchdown> down = touchdowns(comm, out.model, sim.local(), at);
      for (Sought& s : all) parted |= s.see(ends, down);
      if (std::all_of(all.begin(), all.end(), [](const Sought& s) { return s.met(); })) {
        for (const Sought& s : all) out.found.push_back(s.found(c, trial));
        return out;
      }
    } catch (const InputError& e) {
      why = e.what();
    } catch (const SolveError& e) {
      if (trial == 1) throw;  // of the case as it is given
      why = e.what();
    }
    bool stuck = false;
    for (Sought& s : all) {
      if (!moves(s)) continue;
      if (why.empty())
        s.go_on();
      else
        s.fail(why);
      stuck |= s.stuck();
      if (s.stuck() && (!together || all.size() == 1)) s.refuse(c);
    }
    const bool apart = together && all.size() > 1 && (parted || stuck);
    if (apart)
      for (Sought& s : all) s.again();
    if (apart || (!together && all[turn].met())) {
      together = false;
      do turn = (turn + 1) % all.size();
      while (all[turn].met());
      all[turn].again();
    }
  }
  throw SolveError(
      "statics: the targets of the lines do not settle together: the length that one needs changes with "
      "those "
      "of the others; give fewer lines a target");
}

MetTargets with_lengths_of(const model::Case& c, const std::string& results, MPI_Comm comm) {
  MetTargets out{c, {}};
  io::SectionLengths lengths;
  try {
    io::h5::quiet();
    const io::h5::Id file = io::h5::open_read(results);
    const auto names = io::h5::read_texts(file, "lines/name");
    const auto first = io::h5::read_array(file, "lines/first_node").values;
    const auto arc = io::h5::read_array(file, "nodes/arc_length").values;
    for (const model::Line& l : c.lines) {
      const auto at = std::find(names.begin(), names.end(), l.name);
      if (!l.target || at == names.end()) continue;
      size_t node = static_cast<size_t>(first.at(static_cast<size_t>(at - names.begin())));
      for (int i = 0; i < l.target->section; ++i)
        node += static_cast<size_t>(l.sections[static_cast<size_t>(i)].elements);
      const size_t last =
          node + static_cast<size_t>(l.sections[static_cast<size_t>(l.target->section)].elements);
      const double length = arc.at(last) - arc.at(node);
      lengths[fmt::format("lines.{}.sections[{}]", l.name, l.target->section)] = length;
      out.found.push_back(
          fmt::format("line {}: section {} is {:.6f} m long, as the run found that this one goes on from",
                      l.name, l.target->section + 1, length));
    }
    out.model = io::with_lengths(c, lengths, comm);
    out.model.output.file = c.output.file;
  } catch (const std::exception&) {
    return {c, {}};
  }
  return out;
}

}  // namespace hawser::app

// Trials of the search for lengths that meet the targets of all lines at rest.
#include "hawser/run/targets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hawser/advice/lengths.hpp"
#include "hawser/advice/run.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/length_search.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {
namespace {

constexpr int kMostTrials = 500;

// True if statics has to find the initial stock of this feeder.
bool keeps_tension(const model::Case& c, const model::End& end) {
  return c.statics.enabled && end.feed && end.feed->tension > 0;
}

std::vector<LengthSearch> all_searches(const model::Case& c) {
  std::vector<LengthSearch> out;
  int feeder = 0;
  for (size_t l = 0; l < c.lines.size(); ++l) {
    if (c.lines[l].target) out.emplace_back(c, l);
    for (const LineEnd line_end : kLineEnds) {
      const model::End& end = c.lines[l].end(line_end);
      if (keeps_tension(c, end)) out.emplace_back(c, l, line_end, feeder);
      feeder += end.feed.has_value();
    }
  }
  return out;
}

// The searches for all lengths of a case. They start together, as if lines did not interact. If a target is
// lost again or a search fails, they continue one at a time, in a cycle.
class Searches {
 public:
  explicit Searches(const model::Case& c) : case_(c), all_(all_searches(c)) {}

  const std::vector<LengthSearch>& all() const { return all_; }
  bool met() const {
    return std::all_of(all_.begin(), all_.end(), [](const LengthSearch& s) { return s.met(); });
  }
  const LengthSearch& worst() const {
    return *std::max_element(all_.begin(), all_.end(), [](const LengthSearch& a, const LengthSearch& b) {
      return a.error() < b.error();
    });
  }
  // The lengths of the next trial.
  io::SectionLengths choose() {
    io::SectionLengths lengths;
    for (LengthSearch& s : all_) {
      if (varies(s)) s.choose();
      lengths[s.key()] = s.length();
    }
    return lengths;
  }
  // The trial found this equilibrium.
  void update(const AtRest& now) {
    for (LengthSearch& s : all_) target_missed_ |= s.update(now);
  }
  // Ends a trial after update().
  void add_values() {
    end_trial([](LengthSearch& s) { s.add_value(); });
  }
  // Ends a trial that found no equilibrium.
  void add_failure(const std::string& why) {
    end_trial([&](LengthSearch& s) { s.add_failure(why); });
  }

 private:
  bool varies(const LengthSearch& s) const { return !s.met() && (together_ || &s == &all_[turn_]); }

  // add: adds the result of the trial to a search. Throws InputError if a search has failed and no other is
  // left to try.
  template <class Add>
  void end_trial(Add add) {
    const bool alone = !together_ || all_.size() == 1;
    bool failed = false;
    for (LengthSearch& s : all_) {
      if (!varies(s)) continue;
      add(s);
      failed |= s.failed();
      if (s.failed() && alone) s.end_without_length(case_);
    }
    const bool separate = !alone && (target_missed_ || failed);
    target_missed_ = false;
    if (separate) {
      together_ = false;
      for (LengthSearch& s : all_) s.restart();
    }
    if (!met() && (separate || (!together_ && all_[turn_].met()))) next_turn();
  }
  void next_turn() {
    do turn_ = (turn_ + 1) % all_.size();
    while (all_[turn_].met());
    all_[turn_].restart();
  }

  const model::Case& case_;
  std::vector<LengthSearch> all_;
  bool together_ = true, target_missed_ = false;
  size_t turn_ = 0;  // index of the search that continues alone
};

}  // namespace

bool has_targets(const model::Case& c) {
  return std::any_of(c.lines.begin(), c.lines.end(), [&](const model::Line& l) {
    return l.target || keeps_tension(c, l.end_a) || keeps_tension(c, l.end_b);
  });
}

MetTargets meet_targets(MPI_Comm comm, const model::Case& c, const std::vector<LoadedVolume>& volumes,
                        const std::function<void(const StaticsReport&)>& progress,
                        const std::function<void(const std::string&)>& tried) {
  Searches searches(c);
  for (int trial = 1; trial <= kMostTrials; ++trial) {
    const io::SectionLengths lengths = searches.choose();
    std::string failure;
    try {
      MetTargets out{io::with_lengths(c, lengths, comm), {}};
      Simulation sim(comm, out.model, surfaces(volumes), skeletons(out.model, volumes),
                     volume_facets(volumes));
      Events(comm, sim).solve_stages([&](StartsFrom from) { sim.solve_statics(progress, from); });
      searches.update(at_rest(comm, sim));
      if (tried) tried(advice::length_trial(trial, searches.worst().now(c)));
      if (searches.met()) {
        for (const LengthSearch& s : searches.all()) out.sentences.push_back(s.solved_sentence(c, trial));
        return out;
      }
    } catch (const WrongPlaces&) {
      throw;
    } catch (const InputError& e) {
      failure = e.what();
    } catch (const SolveError& e) {
      if (trial == 1) throw;  // error of the case as given
      failure = e.what();
    }
    if (failure.empty())
      searches.add_values();
    else
      searches.add_failure(failure);
  }
  throw SolveError(advice::targets_do_not_settle());
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
      for (int i = 0; i < l.target->section; ++i) node += static_cast<size_t>(l.sections[i].elements);
      const size_t last = node + static_cast<size_t>(l.sections[l.target->section].elements);
      const double length = arc.at(last) - arc.at(node);
      lengths[fmt::format("lines.{}.sections[{}]", l.name, l.target->section)] = length;
      out.sentences.push_back(advice::length_of_other_run(l.name, l.target->section, length));
    }
    out.model = io::with_lengths(c, lengths, comm);
    out.model.output.file = c.output.file;
  } catch (const std::exception&) {
    return {c, {}};
  }
  return out;
}

}  // namespace hawser::run

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

const LengthSearch& worst(const std::vector<LengthSearch>& all) {
  return *std::max_element(all.begin(), all.end(), [](const LengthSearch& a, const LengthSearch& b) {
    return a.error() < b.error();
  });
}

}  // namespace

bool has_targets(const model::Case& c) {
  return std::any_of(c.lines.begin(), c.lines.end(), [&](const model::Line& l) {
    return l.target || keeps_tension(c, l.end_a) || keeps_tension(c, l.end_b);
  });
}

MetTargets meet_targets(MPI_Comm comm, const model::Case& c, const std::vector<LoadedVolume>& volumes,
                        const std::function<void(const StaticsReport&)>& progress,
                        const std::function<void(const std::string&)>& tried) {
  std::vector<LengthSearch> all = all_searches(c);
  // First all lengths together, as if lines did not interact; if they do, cyclically one by one.
  bool together = true;
  size_t turn = 0;
  for (int trial = 1; trial <= kMostTrials; ++trial) {
    const auto moves = [&](const LengthSearch& s) { return !s.met() && (together || &s == &all[turn]); };
    io::SectionLengths lengths;
    for (LengthSearch& s : all) {
      if (moves(s)) s.choose();
      lengths[s.key()] = s.length();
    }
    std::string why;
    bool parted = false;
    try {
      MetTargets out{io::with_lengths(c, lengths, comm), {}};
      Simulation sim(comm, out.model, surfaces(volumes), skeletons(out.model, volumes),
                     volume_facets(volumes));
      Events(comm, sim).solve_stages([&](bool falls) { sim.solve_statics(progress, falls); });
      const AtRest now = at_rest(comm, sim);
      for (LengthSearch& s : all) parted |= s.update(now);
      if (tried) tried(advice::length_trial(trial, worst(all).now(c)));
      if (std::all_of(all.begin(), all.end(), [](const LengthSearch& s) { return s.met(); })) {
        for (const LengthSearch& s : all) out.found.push_back(s.found(c, trial));
        return out;
      }
    } catch (const WrongPlaces&) {
      throw;
    } catch (const InputError& e) {
      why = e.what();
    } catch (const SolveError& e) {
      if (trial == 1) throw;  // error of the case as given
      why = e.what();
    }
    bool stuck = false;
    for (LengthSearch& s : all) {
      if (!moves(s)) continue;
      if (why.empty())
        s.go_on();
      else
        s.fail(why);
      stuck |= s.stuck();
      if (s.stuck() && (!together || all.size() == 1)) s.end_without_length(c);
    }
    const bool apart = together && all.size() > 1 && (parted || stuck);
    if (apart)
      for (LengthSearch& s : all) s.restart();
    const bool some = std::any_of(all.begin(), all.end(), [](const LengthSearch& s) { return !s.met(); });
    if (some && (apart || (!together && all[turn].met()))) {
      together = false;
      do turn = (turn + 1) % all.size();
      while (all[turn].met());
      all[turn].restart();
    }
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
      out.found.push_back(advice::length_of_other_run(l.name, l.target->section, length));
    }
    out.model = io::with_lengths(c, lengths, comm);
    out.model.output.file = c.output.file;
  } catch (const std::exception&) {
    return {c, {}};
  }
  return out;
}

}  // namespace hawser::run

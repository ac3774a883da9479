// The class PlatformWater: checkpoint records of platforms.
#include <algorithm>
#include <stdexcept>

#include "hawser/terms/platform_water.hpp"

namespace hawser {
namespace {

struct KeptRate {
  double time = 0;
  Vec3 velocity = Vec3::Zero(), turning = Vec3::Zero();
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("time", "s", self.time);
    each("velocity", "m/s", self.velocity);
    each("rate of turning", "rad/s", self.turning);
  }
};

struct KeptWork {
  double damping = 0, waves = 0, damping_power = 0, wave_power = 0;
  double lag_step = 0;
  WavePose slow;
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("work of damping", "J", self.damping);
    each("work of waves", "J", self.waves);
    each("power of damping", "W", self.damping_power);
    each("power of waves", "W", self.wave_power);
    each("step of the memory's table", "s", self.lag_step);
    WavePose::quantities(self.slow, each);
  }
};

}  // namespace

std::vector<CheckpointKind> PlatformWater::checkpoint_kinds() const {
  return {checkpoint_kind<KeptRate>("velocities of a group of platforms"),
          checkpoint_kind<KeptWork>("sums of a group of platforms")};
}

// Each body has records of its whole group, because after a restart another rank may own the others.
std::vector<CheckpointRecord> PlatformWater::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  const auto is_written = [&](const Platform& p) { return p.owned && range.has(p.node); };
  for (const Group& g : groups_) {
    if (std::none_of(g.platforms.begin(), g.platforms.end(), is_written)) continue;
    const auto n = static_cast<Eigen::Index>(g.platforms.size());
    CheckpointRecord rates{0, 0, {}, 0};
    CheckpointRecord sums{0, 0, {}, 1};
    for (const Past& past : g.past)
      for (Eigen::Index i = 0; i < n; ++i)
        put(KeptRate{past.time, past.rate.segment<3>(6 * i), past.rate.segment<3>(6 * i + 3)}, rates.values);
    for (const Platform& p : g.platforms)
      put(KeptWork{p.damping_work, p.wave_work, p.power.damping, p.power.waves, g.lag_step, p.slow},
          sums.values);
    for (const Platform& p : g.platforms) {
      if (!is_written(p)) continue;
      rates.node = sums.node = p.node;
      out.push_back(rates);
      out.push_back(sums);
    }
  }
  return out;
}

void PlatformWater::restore(const std::vector<CheckpointRecord>& records) {
  for (Group& g : groups_) {
    g.past.clear();
    g.lags.clear();
    g.lag_step = 0;
    g.is_cached = false;
    const auto owned =
        std::find_if(g.platforms.begin(), g.platforms.end(), [](const Platform& p) { return p.owned; });
    const CheckpointRecord* rates = find_record(records, owned->node);
    const CheckpointRecord* sums = find_record(records, owned->node, 0, 1);
    if (!rates || !sums) continue;
    const size_t n = g.platforms.size();
    const std::vector<KeptRate> past = entries<KeptRate>(*rates);
    const std::vector<KeptWork> work = entries<KeptWork>(*sums);
    if (past.size() % n != 0 || work.size() != n)
      throw std::invalid_argument("a record of the checkpoint is of a group of another size");
    g.lag_step = work.front().lag_step;
    for (size_t k = 0; k < past.size(); k += n) {
      Eigen::VectorXd rate(6 * n);
      for (size_t i = 0; i < n; ++i) rate.segment<6>(6 * i) << past[k + i].velocity, past[k + i].turning;
      add_past(g, past[k].time, std::move(rate));
    }
    for (size_t i = 0; i < n; ++i) {
      Platform& p = g.platforms[i];
      p.damping_work = work[i].damping;
      p.wave_work = work[i].waves;
      p.power = {work[i].damping_power, work[i].wave_power};
      if (!(p.follow_period > 0) || g.past.empty()) continue;
      p.slow = work[i].slow;
      turn(p);
    }
    if (!g.past.empty()) g.slow_time = g.past.back().time;
  }
}

}  // namespace hawser

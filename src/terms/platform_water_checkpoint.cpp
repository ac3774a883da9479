// The class PlatformWater: checkpoint records of platforms.
#include "hawser/base/mpi.hpp"
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
  SlowPose slow;
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("work of damping", "J", self.damping);
    each("work of waves", "J", self.waves);
    each("power of damping", "W", self.damping_power);
    each("power of waves", "W", self.wave_power);
    each("step of the memory's table", "s", self.lag_step);
    each("slow place and heading", "m, rad", self.slow.place);
    each("their velocity", "m/s, rad/s", self.slow.drift);
    each("filtered place and heading", "m, rad", self.slow.filtered);
    each("their rate", "m/s, rad/s", self.slow.rate);
    each("place and heading", "m, rad", self.slow.last);
  }
};

}  // namespace

std::vector<CheckpointKind> PlatformWater::checkpoint_kinds() const {
  return {checkpoint_kind<KeptRate>("velocities of a platform"),
          checkpoint_kind<KeptWork>("sums of a platform")};
}

std::vector<CheckpointRecord> PlatformWater::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (const Group& g : groups_)
    for (size_t i = 0; i < g.platforms.size(); ++i) {
      const Platform& p = g.platforms[i];
      if (!p.owned || !range.has(p.node)) continue;
      CheckpointRecord rates{p.node, 0, {}, 0};
      for (const Past& past : g.past) {
        const Vec6 body_rate = past.rate.segment<6>(6 * static_cast<Eigen::Index>(i));
        put(KeptRate{past.time, body_rate.head<3>(), body_rate.tail<3>()}, rates.values);
      }
      out.push_back(std::move(rates));
      const KeptWork work{p.damping_work, p.wave_work, p.power.damping, p.power.waves, g.lag_step, p.slow};
      out.push_back(record_of(p.node, 0, work, 1));
    }
  return out;
}

void PlatformWater::restore(const std::vector<CheckpointRecord>& records) {
  for (Group& g : groups_) {
    const auto n = static_cast<Eigen::Index>(g.platforms.size());
    std::vector<double> slow(static_cast<size_t>(15 * n + 1), 0);  // the last: step of the memory's table
    std::vector<double> past;  // for each state, its time and 6 n velocities
    const size_t row = static_cast<size_t>(1 + 6 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      Platform& p = g.platforms[static_cast<size_t>(i)];
      if (!p.owned) continue;
      if (const auto kept = find_entry<KeptWork>(records, p.node, 0, 1)) {
        p.damping_work = kept->damping;
        p.wave_work = kept->waves;
        p.power = {kept->damping_power, kept->wave_power};
        if (i == 0) slow.back() = kept->lag_step;
        Eigen::Map<Eigen::Matrix<double, 15, 1>>(&slow[static_cast<size_t>(15 * i)]) << kept->slow.place,
            kept->slow.drift, kept->slow.filtered, kept->slow.rate, kept->slow.last;
      }
      const CheckpointRecord* rates = find_record(records, p.node);
      if (!rates) continue;
      const std::vector<KeptRate> kept = entries<KeptRate>(*rates);
      past.resize(row * kept.size(), 0);
      for (size_t k = 0; k < kept.size(); ++k) {
        double* state = &past[row * k];
        if (i == 0) state[0] = kept[k].time;
        Eigen::Map<Vec6>(state + 1 + 6 * i) << kept[k].velocity, kept[k].turning;
      }
    }
    unsigned long size = past.size();
    MPI_Allreduce(MPI_IN_PLACE, &size, 1, MPI_UNSIGNED_LONG, MPI_MAX, comm_);
    past.resize(size, 0);
    if (size > 0) all_reduce(comm_, MPI_SUM, past);
    all_reduce(comm_, MPI_SUM, slow);
    g.past.clear();
    g.lags.clear();
    g.lag_step = slow.back();
    g.is_cached = false;
    for (size_t k = 0; k < size; k += row) {
      Eigen::VectorXd rate = Eigen::Map<const Eigen::VectorXd>(&past[k + 1], 6 * n);
      add_past(g, past[k], std::move(rate));
    }
    if (!(size > 0)) continue;
    g.slow_time = g.past.back().time;
    for (Eigen::Index i = 0; i < n; ++i) {
      Platform& p = g.platforms[static_cast<size_t>(i)];
      if (!(p.follow_period > 0)) continue;
      const double* kept = &slow[static_cast<size_t>(15 * i)];
      p.slow = {Vec3(kept), Vec3(kept + 3), Vec3(kept + 6), Vec3(kept + 9), Vec3(kept + 12)};
      turn(p);
    }
  }
}

}  // namespace hawser

// The class FeederNodes: division of the element at a feed point or its merging with the next one, and the
// motion of the node between them (docs/theory/feeders.md#released-and-absorbed-nodes).
#include "hawser/run/feeder_nodes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "hawser/advice/lengths.hpp"
#include "hawser/advice/restart.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/terms/line_structure.hpp"

namespace hawser::run {
namespace {

// kRelease: length of the element at the feed point just after the release of a node, relative to the element
// behind it. kAbsorb: its relative length at which a node is absorbed. The difference prevents an oscillating
// feeder from releasing and absorbing a node repeatedly.
constexpr double kRelease = 0.5, kAbsorb = 0.4;

std::string key(const Feeder& f, const char* quantity) {
  return fmt::format("feeder.{}.{}", f.name, quantity);
}

// Value on all ranks from the ranks that know it.
double of_all(MPI_Comm comm, bool known, double value) {
  double out = known ? value : -HUGE_VAL;
  return all_reduce(comm, MPI_MAX, out);
}

}  // namespace

void FeederNodes::agree() {
  if (!feeders_) return;
  std::vector<Feeder*> by_tension;
  std::vector<double> values;  // four for each of them
  for (Feeder& f : feeders_->all()) {
    if (!f.feed.speed.empty()) continue;
    by_tension.push_back(&f);
    if (feeders_->at_feed_point(f))
      values.insert(values.end(), {f.length, f.speed, f.length_rate, f.resting ? 1.0 : 0.0});
    else
      values.insert(values.end(), 4, -HUGE_VAL);
  }
  if (by_tension.empty()) return;
  all_reduce(sim_.system().comm(), MPI_MAX, values);
  for (size_t k = 0; k < by_tension.size(); ++k) {
    Feeder& f = *by_tension[k];
    f.length = values[4 * k];
    f.speed = values[4 * k + 1];
    f.length_rate = values[4 * k + 2];
    f.resting = values[4 * k + 3] > 0.5;
  }
}

void FeederNodes::transfer_node() {
  if (!feeders_) return;
  const double time = sim_.dynamics().committed().s.time;
  for (Feeder& f : feeders_->all()) {
    const Transfer due = due_transfer(f, time);
    if (due == Transfer::release) release_node(f);
    if (due == Transfer::absorb) absorb_node(f);
  }
}

FeederNodes::Transfer FeederNodes::due_transfer(const Feeder& f, double time) const {
  const Feeders& all = *feeders_;
  const double mesh_length = all.element_length(f, f.feed_point);
  refuse_all_out(f, time);
  if (f.feed_point > 0 && f.length >= mesh_length + kRelease * all.element_length(f, f.feed_point - 1))
    return Transfer::release;
  if (!(f.length <= kAbsorb * mesh_length)) return Transfer::none;
  refuse_all_in(f, time);
  return Transfer::absorb;
}

void FeederNodes::transfer_node(Feeder& f, int feed_point, double length,
                                const std::optional<Dynamics::Moved>& moved) {
  sim_.dynamics().transfer_node(
      [&] {
        if (feed_point != f.feed_point)
          sim_.system().find<LineStructure>()->transfer_node(sim_.system().comm(), f.index,
                                                             feed_point < f.feed_point);
        f.feed_point = feed_point;
        f.length = length;
        if (!f.feed.speed.empty()) f.offset = length - model::fed_by(f.feed, f.time).length;
        feeders_->update_feed_point(f);
        return moved;
      },
      [&] { return feeders_->with_held(sim_.system().tied_nodes().nodes()); });
}

// The held node is released with its material: at the position where the free part has its unstretched length
// and the strain of the whole element (of a beam on the cubic between its ends), and from there to its
// equilibrium position; velocity and acceleration are interpolated between the ends.
Dynamics::Moved FeederNodes::released(const Feeder& f, const Kinematics& k, const LocalElement& e) const {
  const Feeders& all = *feeders_;
  const double fraction = all.element_length(f, f.feed_point) / f.length;  // measured from the free end
  const size_t i = e.node_at(f.line_end);
  const size_t j = e.node_at(opposite(f.line_end));
  const FeedPoint feed_point = all.feed_point(f, k);
  const Feeders::Flow flow = all.flow(feed_point, k, e, f.line_end);
  const Vec3 a = k.a[i] + flow.acceleration;
  Dynamics::Moved m;
  m.node = all.node(f, f.feed_point);
  m.free = true;
  m.x = k.x[j] - fraction * flow.chord;
  m.v = k.v[j] + fraction * (flow.velocity - k.v[j]);
  m.a = k.a[j] + fraction * (a - k.a[j]);
  if (f.beam) {
    // Material rates: frames rotate along the bent line, and the outgoing material moves along it.
    const Vec3 turn = log_so3(k.q[j].conjugate() * k.q[i]);
    const Vec3 flows = -(feed_point.speed / feed_point.length) * turn;
    const double towards = (f.line_end == LineEnd::B ? 1 : -1) * flow.chord.norm();
    const Vec3 from = towards * (k.q[j] * Vec3::UnitX());
    const Vec3 to = towards * (k.q[i] * Vec3::UnitX());
    const double s = fraction;
    const double r = 1 - fraction;
    m.x = r * r * (1 + 2 * s) * k.x[j] + s * s * (1 + 2 * r) * k.x[i] + s * r * (r * from - s * to);
    const Vec3 along = 6 * s * r * (k.x[i] - k.x[j]) + r * (r - 2 * s) * from + s * (s - 2 * r) * to;
    const Quat q = k.q[j] * exp_so3(fraction * turn);
    m.q =
        (minimal_rotation(q * Vec3::UnitX(), (f.line_end == LineEnd::B ? along : Vec3(-along)).normalized()) *
         q)
            .normalized();
    m.w = r * k.w[j] + s * (k.w[i] + flows);
    m.alpha = r * k.alpha[j] + s * k.alpha[i];
  }
  return m;
}

void FeederNodes::release_node(Feeder& f) {
  const Feeders& all = *feeders_;
  const int node = all.node(f, f.feed_point);
  const double mesh_length = all.element_length(f, f.feed_point);
  std::optional<Dynamics::Moved> moved;
  if (const LocalElement* e = all.at_feed_point(f))
    moved = released(f, sim_.dynamics().committed_kinematics(), *e);
  if (!f.beam) return transfer_node(f, f.feed_point - 1, f.length - mesh_length, moved);
  const double before = feeder_force(f);
  transfer_node(f, f.feed_point - 1, f.length - mesh_length, moved);
  // Two elements represent a bent line better than one, and their length differs by about 1e-7; the
  // unstretched length takes the difference, so that the force on the feeder is continuous.
  const double more = (before - feeder_force(f)) * (f.length + mesh_length) / f.beam_section.EA;
  if (moved) {
    const Kinematics k = sim_.dynamics().committed_kinematics();
    const size_t n = sim_.local().find(node);
    moved->x = k.x[n];
    moved->q = k.q[n];
  }
  transfer_node(f, f.feed_point, f.length - more, moved);
}

// Force on the feeder, N, on all ranks.
double FeederNodes::feeder_force(const Feeder& f) {
  record::EndForces ends(sim_.system(), feeders_);
  ends.evaluate(sim_.dynamics().committed_kinematics(),
                std::vector<Vec3>(static_cast<size_t>(sim_.local().nodes()), Vec3::Zero()));
  return ends.at_feeders()[f.index];
}

// The first free node enters the feeder. The bend there becomes straight; the unstretched length keeps the
// mean strain of the two elements.
FeederNodes::Absorbed FeederNodes::absorbed(const Feeder& f, const Kinematics& k) const {
  const Feeders& all = *feeders_;
  const int held = all.node(f, f.feed_point);
  const int absorbed = all.node(f, f.feed_point + 1);
  const int next = all.node(f, f.feed_point + 2);
  const LocalMesh& local = sim_.local();
  const double lengths[2] = {f.length, all.element_length(f, f.feed_point + 1)};
  const double sum = lengths[0] + lengths[1];
  Absorbed out;
  const int at[3] = {local.find(held), local.find(absorbed), local.find(next)};
  const bool known = at[0] >= 0 && at[1] >= 0 && at[2] >= 0;
  if (known) {
    const size_t i = at[0];
    const size_t j = at[1];
    const size_t n = static_cast<size_t>(at[2]);
    // Contribution of bending to the strain of an element's chord.
    const auto bow = [&](size_t a, size_t b) {
      if (f.line_end == LineEnd::B) std::swap(a, b);
      return f.beam ? beam_bow({}, {k.x[a], k.x[b], k.q[a], k.q[b]}) : 0.0;
    };
    const double strain = ((k.x[j] - k.x[i]).norm() + lengths[0] * bow(i, j) + (k.x[n] - k.x[j]).norm() +
                           lengths[1] * bow(j, n)) /
                          sum;
    out.length = (k.x[n] - k.x[i]).norm() / (strain - bow(i, n));
    out.moved = {absorbed, k.x[i], k.v[i], k.a[i], k.q[i], k.w[i], k.alpha[i], false};
  }
  out.length = of_all(sim_.system().comm(), known, out.length);
  return out;
}

void FeederNodes::absorb_node(Feeder& f) {
  const Absorbed node = absorbed(f, sim_.dynamics().committed_kinematics());
  transfer_node(f, f.feed_point + 1, node.length, node.moved);
}

void FeederNodes::refuse_all_out(const Feeder& f, double time) const {
  if (f.feed_point == 0 && f.length >= feeders_->element_length(f, 0))
    throw SolveError(advice::stock_runs_out(f.name, time));
}

void FeederNodes::refuse_all_in(const Feeder& f, double time) const {
  const Feeders& all = *feeders_;
  int others = 0;  // elements inside another feeder of the line
  for (const Feeder& o : feeders_->all())
    if (o.line == f.line && o.line_end != f.line_end) others = o.feed_point;
  if (f.feed_point + 2 + others >= all.elements(f))
    throw SolveError(advice::all_hauled_in(f.name, time, sim_.model().lines[f.line].given != nullptr));
}

void FeederNodes::shift(Feeder& f, double paid_out) {
  Feeders& all = *feeders_;
  State& state = sim_.state();
  const auto put = [&](const std::optional<Dynamics::Moved>& moved) {
    const int n = moved ? sim_.local().find(moved->node) : -1;
    if (n >= 0) {
      state.x[n] = moved->x;
      state.q[n] = moved->q;
    }
    sim_.system().update_ghosts(state);
  };
  const auto set = [&](int feed_point, double length) {
    f.feed_point = feed_point;
    f.length = length;
    f.offset = length - (f.feed.speed.empty() ? 0 : model::fed_by(f.feed, f.time).length);
    all.update_feed_point(f);
  };
  set(f.feed_point, f.length + paid_out);
  for (;;) {
    const Transfer due = due_transfer(f, f.time);
    if (due == Transfer::none) break;
    if (due == Transfer::release) {
      const double mesh_length = all.element_length(f, f.feed_point);
      std::optional<Dynamics::Moved> moved;
      if (const LocalElement* e = all.at_feed_point(f)) moved = released(f, state.at_rest(), *e);
      put(moved);
      set(f.feed_point - 1, f.length - mesh_length);
    } else {
      const double next = all.element_length(f, f.feed_point + 1);
      put(absorbed(f, state.at_rest()).moved);
      set(f.feed_point + 1, f.length + next);
    }
  }
  f.outside_at_start = all.outside(f);
  System& system = sim_.system();
  system.tie(all.with_held(system.tied_nodes().nodes()), BodyMotion(system.tied_nodes().motion()));
}

void FeederNodes::save(io::Checkpoint& to) const {
  if (!feeders_) return;
  double work = feeders_->work();
  all_reduce(sim_.system().comm(), MPI_SUM, work);
  to.scalars["feeders.work"] = work;
  for (const Feeder& f : feeders_->all()) {
    to.scalars[key(f, "feed_point")] = f.feed_point;
    to.scalars[key(f, "length")] = f.length;
    to.scalars[key(f, "speed")] = f.speed;
    to.scalars[key(f, "length_rate")] = f.length_rate;
    to.scalars[key(f, "resting")] = f.resting;
    to.scalars[key(f, "outside at the start")] = f.outside_at_start;
    // Exact offset: a changed table may pay out differently from here on, but not before.
    to.scalars[key(f, "offset")] = f.offset;
  }
}

void FeederNodes::restore(const io::Checkpoint& from, const std::string& path) {
  const auto refuse = [&](const std::string& why) { return InputError(advice::cannot_continue(path, why)); };
  size_t in_checkpoint = 0;
  size_t in_case = feeders_ ? feeders_->all().size() : 0;
  for (const auto& [name, value] : from.scalars)
    in_checkpoint += name.starts_with("feeder.") && name.ends_with(".feed_point");
  if (in_checkpoint != in_case) throw refuse(advice::other_number_of_feeds(in_checkpoint, in_case));
  if (!feeders_) return;
  const int rank = rank_of(sim_.system().comm());
  feeders_->set_work(rank == 0 ? from.scalars.at("feeders.work") : 0);
  for (Feeder& f : feeders_->all()) {
    if (!from.scalars.count(key(f, "feed_point"))) throw refuse(advice::not_fed_in_checkpoint(f.name));
    const auto take = [&](const char* quantity) { return from.scalars.at(key(f, quantity)); };
    const double feed_point = take("feed_point");
    if (!(feed_point >= 0 && feed_point < feeders_->elements(f)) || !(take("length") > 0))
      throw refuse(advice::damaged_checkpoint("the feed point of " + f.name, feed_point));
    f.feed_point = static_cast<int>(feed_point);
    f.length = take("length");
    f.speed = take("speed");
    f.length_rate = take("length_rate");
    f.resting = take("resting") > 0;
    f.time = from.time;
    f.outside_at_start = take("outside at the start");
    // A changed speed table continues from the current length.
    f.offset = take("offset");
    if (!f.feed.speed.empty() && std::abs(f.offset + model::fed_by(f.feed, f.time).length - f.length) > 1e-9)
      f.offset = f.length - model::fed_by(f.feed, f.time).length;
    feeders_->update_feed_point(f);
  }
  System& system = sim_.system();
  system.tie(feeders_->with_held(system.tied_nodes().nodes()), BodyMotion(system.tied_nodes().motion()));
}

}  // namespace hawser::run

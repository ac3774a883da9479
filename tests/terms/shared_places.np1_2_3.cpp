// Places that lines share, on any number of ranks: the lengths without contact are the same as on one rank,
// and the same after a restart from a checkpoint.
#include "hawser/terms/shared_places.hpp"

#include "support/rig.hpp"

namespace hawser::test::shared_places_ranks {
namespace {

TEST(SharedPlacesOnRanks, KnowTheSame) {
  model::Case c = one_line(cable_type(1e6, 1), 20, 40, anchor({0, 0, 0}), anchor({20, 0, 0}));
  for (const double y : {3.0, 6.0}) {
    c.lines.push_back(c.lines[0]);
    c.lines.back().name = "to " + std::to_string(y);
    c.lines.back().end_b = anchor({19, y, 0});
  }
  for (model::Line& l : c.lines) l.start = model::Start::straight;
  c.contact.between_lines.self = false;
  const auto of = [&](MPI_Comm comm) {
    Simulation sim(comm, c);
    const std::vector<SharedPlace> ends = {{{0}, {41}}, {{0}, {82}}, {{41}, {82}}};
    SharedPlaces places(comm, sim.local(), ContactRadii({0.1}), ends, {});
    // Statics may restore its start before the first update, when nothing is known.
    for (int k = 0; k < places.size(); ++k) EXPECT_NO_THROW(places.restore(places.kept(k)));
    places.update(sim.state().at_rest(), true);
    std::vector<double> out;
    for (int k = 0; k < places.size(); ++k) out.push_back(places.free_length(k));
    // The records of a place that one rank saved reach the other ranks.
    std::vector<SharedPlaces::Kept> kept;
    for (int k = 0; k < places.size(); ++k)
      if (sim.local().owns(sim.local().find(ends[static_cast<size_t>(k)].one.node)))
        kept.push_back(places.kept(k));
    places.forget();
    for (const auto& k : kept) places.restore(k);
    places.update(sim.state().at_rest(), false);
    for (int k = 0; k < places.size(); ++k) EXPECT_EQ(places.free_length(k), out[static_cast<size_t>(k)]);
    return out;
  };
  const std::vector<double> all = of(PETSC_COMM_WORLD);
  const std::vector<double> one = of(PETSC_COMM_SELF);
  EXPECT_EQ(all, one);
  EXPECT_GT(one[0], 0.2);
  EXPECT_GT(one[0], one[1]);  // a smaller angle gives a larger length
}

}  // namespace
}  // namespace hawser::test::shared_places_ranks

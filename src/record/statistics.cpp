// The class Statistics: statistics of nodes precede those at stations in the file.
#include "hawser/record/statistics.hpp"

#include "hawser/terms/feeders.hpp"

namespace hawser::record {

void Statistics::declare(Declarations& to) {
  const std::vector<Field>& fields = to.contents.fields;
  const size_t owned = subject_.local().owned;
  const double from = subject_.model.output.statistics_from;
  nodes_.emplace(fields, owned, from);
  stations_.emplace(subject_.comm(), subject_.local(), subject_.term<Feeders>(), fields);
  at_stations_.emplace(stations_->fields(), owned, from);
  for (const Field& f : nodes_->fields()) to.every_step.insert(f.name);
  to.contents.statistics = nodes_->fields();
  to.contents.statistics.insert(to.contents.statistics.end(), stations_->fields().begin(),
                                stations_->fields().end());
}

void Statistics::step(const Snapshot& s) {
  nodes_->add(s.step.time, s.values);
  at_stations_->add(s.step.time, stations_->at(s.values));
}

void Statistics::write(io::ResultsFile& file) {
  size_t place = 0;
  for (const NodeStatistics* s : {&*nodes_, &*at_stations_})
    for (size_t f = 0; f < s->fields().size(); ++f) file.write_statistics(place++, s->table(f));
}

void Statistics::save(io::Checkpoint& to) {
  nodes_->save(to);
  at_stations_->save(to);
}

void Statistics::restore(const io::Checkpoint& from) {
  nodes_->restore(from);
  at_stations_->restore(from);
}

}  // namespace hawser::record

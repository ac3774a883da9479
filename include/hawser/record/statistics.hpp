// Statistics of node fields over all steps, at nodes and at stations of fed lines.
#pragma once

#include <optional>

#include "hawser/record/node_statistics.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/stations.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class Statistics : public Recording {
 public:
  // The subject must outlive the object.
  explicit Statistics(const Subject& subject) : subject_(subject) {}

  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  void write(io::ResultsFile& file) override;
  void save(io::Checkpoint& to) override;
  void restore(const io::Checkpoint& from) override;

 private:
  const Subject& subject_;
  // Created by declare().
  std::optional<NodeStatistics> nodes_, at_stations_;
  std::optional<Stations> stations_;
};

}  // namespace hawser::record

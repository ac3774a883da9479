// Points of contact with their forces at outputs, of all terms that have some. Each rank has those that it
// counts.
#pragma once

#include <vector>

#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/terms/contact_resultant.hpp"

namespace hawser {
class BodyContactTerm;
class LinePairs;
class LineVolumeContact;
}  // namespace hawser

namespace hawser::record {

// True when anything of the case can touch.
bool can_touch(const Subject& subject);
// Of the volumes that lines touch, in the order of their term: which of the case each is.
std::vector<int> volumes_of_lines(const Subject& subject);

class ContactPoints : public Recording {
 public:
  // The subject outlives it.
  explicit ContactPoints(const Subject& subject);

  void declare(Declarations& to) override { to.contents.contact_points = true; }
  void points(const Snapshot& s, io::ContactRows& to) override;

 private:
  const LineVolumeContact* line_volumes_;  // null: none of its kind
  const LinePairs* line_pairs_;            // likewise
  const BodyContactTerm* bodies_;          // likewise
  std::vector<int> volumes_;
};

}  // namespace hawser::record

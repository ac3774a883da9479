// Points of contact and their forces at outputs, from all contact terms. Each rank records the points that it
// counts.
#pragma once

#include <vector>

#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/terms/contact_resultant.hpp"

namespace hawser {
class BodyContact;
class LinePairs;
class LineVolumeContact;
}  // namespace hawser

namespace hawser::record {

// True if the case has contact of any kind.
bool can_touch(const Subject& subject);
// Index in the case of each volume of LineVolumeContact, in the order of that term.
std::vector<int> case_indices_of_volumes(const Subject& subject);

class ContactPoints : public Recording {
 public:
  // The subject must outlive the recording.
  explicit ContactPoints(const Subject& subject);

  void declare(Declarations& to) override { to.contents.contact_points = true; }
  void points(const Snapshot& s, io::ContactRows& to) override;

 private:
  // Null: the case has no such contact.
  const LineVolumeContact* line_volumes_;
  const LinePairs* line_pairs_;
  const BodyContact* bodies_;
  std::vector<int> volumes_;  // case_indices_of_volumes()
};

}  // namespace hawser::record

// Contact points of the accepted state, gathered from the three contact terms.
#include "hawser/record/contact_points.hpp"

#include <algorithm>

#include "hawser/terms/body_contact.hpp"
#include "hawser/terms/line_pairs.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {

bool can_touch(const Subject& s) {
  return s.term<LineVolumeContact>() || s.term<LinePairs>() || s.term<BodyContact>();
}

std::vector<int> case_indices_of_volumes(const Subject& subject) {
  std::vector<int> out;
  const auto* term = subject.term<LineVolumeContact>();
  const auto& volumes = subject.model.volumes;
  for (int v = 0; term && v < term->volumes(); ++v) {
    const auto at = std::find_if(volumes.begin(), volumes.end(),
                                 [&](const model::Volume& o) { return o.name == term->volume_name(v); });
    out.push_back(static_cast<int>(at - volumes.begin()));
  }
  return out;
}

ContactPoints::ContactPoints(const Subject& subject)
    : line_volumes_(subject.term<LineVolumeContact>()),
      line_pairs_(subject.term<LinePairs>()),
      bodies_(subject.term<BodyContact>()),
      volumes_(case_indices_of_volumes(subject)) {}

void ContactPoints::points(const Snapshot& s, io::ContactRows& to) {
  ContactResultants all;
  if (line_volumes_) line_volumes_->resultants(s.at, all);
  for (ContactResultant& r : all) r.volume = volumes_[r.volume];
  if (line_pairs_) line_pairs_->resultants(s.at, all);
  if (bodies_) bodies_->resultants(all);
  for (const ContactResultant& r : all)
    to.push_back({r.line, r.other_line, r.volume, r.other_volume, r.place, r.force});
}

}  // namespace hawser::record

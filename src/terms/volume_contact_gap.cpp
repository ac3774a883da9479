// Gap springs: each node's along the normal of the surface that was nearest at the start.
#include <algorithm>

#include "hawser/terms/volume_contact.hpp"

namespace hawser {

bool VolumeContact::locate_gap(Pair& pair, const Vec3& y, ContactTrial& trial) const {
  const History& h = pair.history;
  if (!h.paired) return false;
  trial.point = y;
  trial.gap = h.direction.dot(y - h.anchor) - nodes_[static_cast<size_t>(pair.node)].radius;
  trial.normal = h.direction;
  trial.curvature.setZero();
  return trial.gap < pair.law.normal.smoothing;
}

void VolumeContact::choose_gap(Pair& pair, const Vec3& y) const {
  const size_t k = static_cast<size_t>(pair.volume);
  const Box& box = boxes_[k];
  // Anywhere on the surface; a plane's box is of no size to speak of.
  const double far = distance(box, y) + std::min(box.extent().norm(), 1e6) + pair.touch;
  const auto p = volumes_[k].surface->query(y, far, -1);
  if (!p) return;
  pair.history.paired = true;
  pair.history.direction = p->normal;
  pair.history.anchor = y - p->distance * p->normal;
}

}  // namespace hawser

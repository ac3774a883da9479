// The class ContactVolumes: checks at construction, and intervals at ends of lines without contact. Poses are
// in contact_volumes_bodies.cpp, stiffness in contact_volumes_automatic_stiffness.cpp.
#include "hawser/terms/contact_volumes.hpp"

#include <algorithm>
#include <stdexcept>

namespace hawser {

ContactVolumes::ContactVolumes(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                               std::vector<ContactVolume> volumes, MPI_Comm comm)
    : mesh_(mesh), bodies_(std::move(bodies)), volumes_(std::move(volumes)), comm_(comm) {
  if (!bodies_) bodies_ = std::make_shared<const Bodies>();
  for (const ContactVolume& v : volumes_) {
    if (!v.surface) throw std::invalid_argument("volume " + v.settings.name + " has no surface");
    if (v.body >= bodies_->size())
      throw std::invalid_argument("volume " + v.settings.name + " has no such body");
    if (v.settings.basis == model::StiffnessBasis::automatic || !(v.settings.normal_stiffness > 0))
      throw std::invalid_argument("volume " + v.settings.name + " has no contact stiffness");
    boxes_.push_back(v.surface->bounds());
    committed_.push_back(v.settings.normal_stiffness);
  }
  reported_ = committed_;
  poses_.resize(bodies_->size() + 1);
  for (int b = 0; b < bodies_->size(); ++b) poses_[b + 1] = bodies_->pose(b, 0.0);
  start_poses_ = poses_;
}

void ContactVolumes::exclude_ends(std::vector<ExcludedEnds> ends) {
  excluded_ends_ = std::move(ends);
  std::sort(excluded_ends_.begin(), excluded_ends_.end(), [](const ExcludedEnds& a, const ExcludedEnds& b) {
    return std::pair(a.line, a.volume) < std::pair(b.line, b.volume);
  });
}

ActiveInterval ContactVolumes::takes_part(int line, int volume, double from, double to) const {
  if (at(volume).off) return {1, 0};
  const std::pair key(line, volume);
  const auto excluded =
      std::lower_bound(excluded_ends_.begin(), excluded_ends_.end(), key,
                       [](const ExcludedEnds& l, auto k) { return std::pair(l.line, l.volume) < k; });
  if (excluded == excluded_ends_.end() || std::pair(excluded->line, excluded->volume) != key) return {};
  const double end = mesh_.mesh->lines[line].length - excluded->end_b;
  const double span = to - from;
  // A single point, or an interval.
  if (!(span > 0)) return from >= excluded->end_a && from <= end ? ActiveInterval{} : ActiveInterval{1, 0};
  return {std::max(0.0, (excluded->end_a - from) / span), std::min(1.0, (end - from) / span)};
}

advice::VolumeLaw ContactVolumes::law_of(int volume) const {
  const model::Volume& v = settings(volume);
  return {v.name, v.basis, v.normal_stiffness, v.force_table != nullptr, automatic(volume)};
}

}  // namespace hawser

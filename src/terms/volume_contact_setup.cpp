// What VolumeContact is made from, and what it shows and keeps.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "hawser/terms/volume_contact.hpp"

namespace hawser {

VolumeContact::VolumeContact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                             std::vector<ContactVolume> volumes, std::vector<ContactNode> nodes,
                             NodeContact model, MPI_Comm comm)
    : Contact(mesh, std::move(bodies), std::move(volumes), comm),
      mesh_(*mesh.mesh),
      model_(model),
      nodes_(std::move(nodes)),
      line_(mesh) {
  const size_t owned = static_cast<size_t>(mesh.owned);
  if (nodes_.size() != owned)
    throw std::invalid_argument("contact needs one ContactNode for each owned node");
  accounts_.resize(owned);
  element_.assign(owned, 0);
  for (size_t i = 0; i < owned; ++i) {
    global_.push_back(mesh.global[i]);
    block_.push_back(mesh.block[i]);
    tributary_.push_back(mesh.mesh->nodes[static_cast<size_t>(mesh.global[i])].tributary);
  }
  for (const LocalElement& e : mesh.elements) {
    const size_t first = static_cast<size_t>(e.first), second = static_cast<size_t>(e.second);
    const double length = mesh.mesh->elements[static_cast<size_t>(e.global)].length;
    if (first < owned) element_[first] = std::max(element_[first], length);
    if (second < owned) element_[second] = std::max(element_[second], length);
  }
}

double VolumeContact::thickest() const {
  double most = 0;
  for (const ContactNode& n : nodes_) most = std::max(most, n.radius);
  return most;
}

ContactLaw VolumeContact::node_law(int node, int volume) const {
  const size_t n = static_cast<size_t>(node);
  const model::Volume& v = volumes_[static_cast<size_t>(volume)].settings;
  const double diameter = 2 * nodes_[n].radius;
  double share = 1;  // of the node: what turns the basis into N/m
  if (v.basis == model::StiffnessBasis::per_length) share = tributary_[n];
  if (v.basis == model::StiffnessBasis::per_area) share = tributary_[n] * diameter;
  return law(v, share, diameter, nodes_[n].mass);
}

bool VolumeContact::left_out(int node, int volume) const {
  if (left_out_.empty()) return false;
  const Node& n = mesh_.nodes[static_cast<size_t>(global_[static_cast<size_t>(node)])];
  return takes_part(mesh_, n.line, volume, n.arc, n.arc).none();
}

// In dynamics of the committed state. Statics asks for trials: its line search goes down this energy.
Energy VolumeContact::energy(const Kinematics& at) const {
  Energy e;
  for (const Pair& p : pairs_) {
    if (at.step > 0) {
      e.strain += p.history.potential;
      continue;
    }
    const size_t n = static_cast<size_t>(p.node);
    Pair pair = p;
    ContactTrial trial;
    const Vec3 y = pose_of(p.volume, at).to_body(at.x[n]);
    if (locate(pair, y, 0.5 * element_[n], trial))
      e.strain += normal_force(applied(p.law).normal, trial.gap, 0).potential;
  }
  for (const Account& a : accounts_) e.friction += a.friction, e.damping += a.damping, e.work += a.work;
  return e;
}

void VolumeContact::fields(FieldRegistry& registry) const {
  // Sums (or the largest) over the volumes of `value` of a committed pair.
  const auto scalar = [this](auto value, bool largest) {
    return [this, value, largest](const Kinematics&, std::span<double> out) {
      std::fill(out.begin(), out.end(), 0.0);
      for (const Pair& p : pairs_) {
        double& o = out[static_cast<size_t>(p.node)];
        o = largest ? std::max(o, value(p.history)) : o + value(p.history);
      }
    };
  };
  const auto vector = [this](auto value) {
    return [this, value](const Kinematics& at, std::span<double> out) {
      std::fill(out.begin(), out.end(), 0.0);
      for (const Pair& p : pairs_) {
        const Vec3 f = pose_of(p.volume, at).rotation * value(p.history);
        for (int c = 0; c < 3; ++c) out[static_cast<size_t>(3 * p.node + c)] += f[c];
      }
    };
  };
  registry.add({"contact_force", "N", 3, vector([](const History& h) { return h.force; })});
  registry.add(
      {"contact_normal_force", "N", 1, scalar([](const History& h) { return h.normal_force; }, false)});
  registry.add({"friction_force", "N", 3, vector([](const History& h) { return h.friction; })});
  registry.add({"penetration", "m", 1, scalar([](const History& h) { return h.depth; }, true)});
}

namespace {
enum Kind { kPoints, kSums };  // keys of points: volumes, those of second walls behind them

}  // namespace

std::vector<HistoryKind> VolumeContact::history() const {
  return {history_kind<History>("points"), history_kind<Account>("sums of a node")};
}

std::vector<HistoryRecord> VolumeContact::save() const {
  std::vector<HistoryRecord> records;
  for (size_t n = 0; n < accounts_.size(); ++n)
    if (!accounts_[n].empty()) records.push_back(record_of(global_[n], 0, accounts_[n], kSums));
  for (const Pair& p : pairs_)
    if (p.history.touches || p.history.paired)
      records.push_back(
          record_of(global_[static_cast<size_t>(p.node)], p.volume + p.slot * volumes(), p.history, kPoints));
  return records;
}

void VolumeContact::restore(const std::vector<HistoryRecord>& records) {
  std::unordered_map<int, int> local;
  for (size_t n = 0; n < global_.size(); ++n) local[global_[n]] = static_cast<int>(n);
  pairs_.clear();
  accounts_.assign(accounts_.size(), {});
  for (const HistoryRecord& r : records) {
    const auto found = local.find(r.node);
    if (found == local.end()) continue;
    if (r.kind == kSums) {
      accounts_[static_cast<size_t>(found->second)] = entry<Account>(r);
      continue;
    }
    if (r.key < 0 || r.key >= SurfaceWalls::kMost * volumes())
      throw std::invalid_argument("a contact record of the checkpoint does not fit this case");
    Pair& p = pairs_.emplace_back();
    p.node = found->second;
    p.volume = r.key % volumes(), p.slot = r.key / volumes();
    p.history = entry<History>(r);
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) {
    return std::array{a.node, a.volume, a.slot} < std::array{b.node, b.volume, b.slot};
  });
}

Penetration VolumeContact::largest_penetration() const {
  Penetration p;
  for (size_t n = 0; n < accounts_.size(); ++n)
    if (accounts_[n].depth > p.depth)
      p = {accounts_[n].depth, global_[n], accounts_[n].volume, accounts_[n].time};
  return p;
}

}  // namespace hawser

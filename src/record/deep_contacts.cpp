// The class DeepContacts: comparison of contacts with the acceptable depth of their volumes, and warnings.
#include "hawser/record/deep_contacts.hpp"

#include <algorithm>

#include "hawser/advice/limits.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/record/contact_points.hpp"
#include "hawser/terms/automatic_stiffness.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {
namespace {

const char* const kRecords = "deep contacts of lines";  // key in a checkpoint

}  // namespace

DeepContacts::DeepContacts(const Subject& subject)
    : subject_(subject),
      contact_(subject.term<LineVolumeContact>()),
      volumes_(case_indices_of_volumes(subject)) {}

void DeepContacts::put(const Deepest& d, PerLine& to) {
  Deepest& deepest = to[d.line];
  if (d.factor > deepest.factor) deepest = d;
}

bool DeepContacts::in_impact(const ActiveContact& at, const Snapshot& s) const {
  const model::Case& c = subject_.model;
  const model::Volume& volume = c.volumes[volumes_[at.volume]];
  if (volume.basis != model::StiffnessBasis::automatic) return false;
  double heaviest = 0;  // kg/m
  for (const model::Section& section : c.lines[at.line].sections)
    heaviest = std::max(heaviest, c.line_type(section.type).mass_per_length);
  return resolves_impact(s.step.h, contact_period(contact_->stiffness(at.volume), heaviest));
}

void DeepContacts::step(const Snapshot& s) {
  const model::Case& c = subject_.model;
  for (const ActiveContact& at : s.volume_contacts()) {
    const int volume = volumes_[at.volume];
    const model::Line& line = c.lines[at.line];
    const double acceptable = advice::acceptable_penetration(c, line, c.volumes[volume]);
    if (!(at.depth > acceptable)) continue;
    const bool impact = in_impact(at, s);
    const double factor =
        at.depth / (impact ? advice::acceptable_impact_penetration(c, line, c.volumes[volume]) : acceptable);
    if (factor > 1)
      put({at.line, volume, factor, at.depth, s.step.time, 0.5 * (at.from + at.to),
           contact_->stiffness(at.volume), impact, contact_->has_largest_stiffness(at.volume)},
          of_rank_);
  }
}

std::vector<io::SummaryRow> DeepContacts::summary() {
  std::vector<Deepest> local;
  for (const auto& [line, deepest] : of_rank_) local.push_back(deepest);
  of_run_.clear();
  for (const Deepest& d : gather_all(subject_.comm(), local)) put(d, of_run_);
  return {};
}

std::vector<Warning> DeepContacts::warnings(const std::vector<io::SummaryRow>& summary) {
  const model::Case& c = subject_.model;
  std::vector<Warning> out;
  for (const auto& [line, d] : of_run_) {
    if (!owns_line(subject_.local(), line)) continue;
    const std::string& name = c.lines[line].name;
    const auto row = std::find_if(summary.begin(), summary.end(), [&](const io::SummaryRow& r) {
      return r.quantity == "max penetration" && r.line == name;
    });
    out.push_back({advice::penetration_warning(c, {name, d.depth, d.time, d.arc_length}, c.volumes[d.volume],
                                               {d.stiffness, d.impact > 0, d.stiffest > 0}),
                   row == summary.end() ? Warning::kWholeRun : static_cast<size_t>(row - summary.begin())});
  }
  return out;
}

// At the first node of the line that this rank owns: it owns the first node of each element that it counts.
void DeepContacts::save(io::Checkpoint& to) {
  io::TermCheckpoint& kept = to.records[kRecords];
  kept.kinds = {checkpoint_kind<Deepest>("deepest contact")};
  const LocalMesh& mesh = subject_.local();
  for (const auto& [line, deepest] : of_rank_) {
    const auto owned_end = mesh.global.begin() + mesh.owned;
    const int node = *std::lower_bound(mesh.global.begin(), owned_end, mesh.mesh->lines[line].first_node);
    kept.records.push_back(record_of(node, 0, deepest));
  }
}

void DeepContacts::restore(const io::Checkpoint& from) {
  const auto at = from.records.find(kRecords);
  if (at == from.records.end()) return;
  for (const CheckpointRecord& r : at->second.records) put(entry<Deepest>(r), of_rank_);
}

}  // namespace hawser::record

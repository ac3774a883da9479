// List of all recordings. Their order determines that of the series in the results file, which continued runs
// rely on, and of warnings about the whole run. EdgeErrors precedes TensionPeaks, which uses its tensions of
// the same step.
//
// Where a new history belongs:
// - A quantity at nodes or elements: as a field of its force term (Field). Histories takes it at the points
//   of lines that a case names.
// - Numbers of one force term, such as the force of each link: as HasSeries of the term. TermHistory writes
//   them.
// - A load component on a floating body: as ReportsBodyForces of the term. Histories puts it beside
//   the motion.
// - Numbers that need several terms, the whole state, or a memory of earlier steps: as a new Recording.
#include <utility>

#include "hawser/record/bodies_below_bed.hpp"
#include "hawser/record/clash_report.hpp"
#include "hawser/record/clearances.hpp"
#include "hawser/record/contact_points.hpp"
#include "hawser/record/deep_contacts.hpp"
#include "hawser/record/edge_errors.hpp"
#include "hawser/record/element_errors.hpp"
#include "hawser/record/energy_audit.hpp"
#include "hawser/record/histories.hpp"
#include "hawser/record/line_extremes.hpp"
#include "hawser/record/node_fields.hpp"
#include "hawser/record/pipe_strength.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/statistics.hpp"
#include "hawser/record/step_histories.hpp"
#include "hawser/record/support_log.hpp"
#include "hawser/record/support_settlement.hpp"
#include "hawser/record/tension_peaks.hpp"
#include "hawser/record/utilisation.hpp"
#include "hawser/record/water_errors.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/line_pairs.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {

Recordings recordings(const Subject& s, NodeFields& fields) {
  const model::Case& c = s.model;
  Recordings out;
  const auto add = [&out](auto recording) -> auto& {
    auto& added = *recording;
    out.all.push_back(std::move(recording));
    return added;
  };
  auto energy = std::make_unique<EnergyAudit>(s, fields);
  out.energy = energy.get();
  add(std::make_unique<Histories>(s, fields.end_forces()));
  add(std::make_unique<Clearances>(s));
  const Utilisation& utilisation = add(std::make_unique<Utilisation>(c, s.local()));
  add(std::make_unique<ElementErrors>(s.comm(), c, s.local(), s.term<Feeders>(), s.term<LinePairs>()));
  const EdgeErrors* edges = c.volumes.empty() && !s.term<LinePairs>()
                                ? nullptr
                                : &add(std::make_unique<EdgeErrors>(s.comm(), c, s.local()));
  add(std::make_unique<TensionPeaks>(s, edges, energy->figures()));
  add(std::make_unique<LineExtremes>(s, utilisation));
  if (s.term<LineVolumeContact>()) add(std::make_unique<DeepContacts>(s));
  if (SupportSettlement::possible(s)) add(std::make_unique<SupportSettlement>(s));
  if (c.output.statistics) add(std::make_unique<Statistics>(s));
  add(std::make_unique<WaterErrors>(c, s.system));
  add(std::make_unique<PipeStrength>(s));
  if (BodiesBelowBed::possible(s)) add(std::make_unique<BodiesBelowBed>(s));
  if (can_touch(s)) add(std::make_unique<ContactPoints>(s));
  if (ClashReport::enabled(s)) add(std::make_unique<ClashReport>(s));
  if (!c.supports.empty()) add(std::make_unique<SupportLog>(s));
  if (c.output.touchdowns && c.environment.seabed.present) add(std::make_unique<TouchdownHistory>(s));
  add(std::make_unique<TermHistory>(s));
  add(std::make_unique<FeederHistory>(s));
  add(std::move(energy));
  add(std::make_unique<StepHistory>(s));
  return out;
}

}  // namespace hawser::record

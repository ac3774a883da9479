// Names of energies and audit numbers in a checkpoint.
#include "hawser/record/audit_checkpoint.hpp"

#include <array>
#include <string>
#include <type_traits>
#include <utility>

#include "hawser/base/mpi.hpp"

namespace hawser::record {
namespace {

constexpr std::pair<const char*, double Energy::*> kEnergies[] = {
    {"kinetic", &Energy::kinetic},       {"strain", &Energy::strain},    {"potential", &Energy::potential},
    {"friction", &Energy::friction},     {"damping", &Energy::damping},  {"work", &Energy::work},
    {"unresolved", &Energy::unresolved}, {"by_water", &Energy::by_water}};

// Visits each number of an audit with its name.
template <class AnAudit, class Each>
void numbers(AnAudit& a, Each&& each) {
  each("audit.brought_in", a.brought_in);
  each("audit.error", a.error);
  each("audit.at_start", a.initial_kinetic);
  each("audit.worked", a.absolute_work);
  each("audit.set_free", a.released_strain);
  each("audit.there", a.largest_energy);
  each("audit.held", a.largest_strain);
  each("audit.least_error", a.smallest_error);
  each("audit.taken", a.dissipated);
  each("audit.remains", a.remaining);
  each("audit.most_remains", a.largest_remaining);
  each("audit.least_by_water", a.smallest_by_water);
  for (const auto& [name, l] :
       {std::pair{"audit.made.", &a.largest_gain}, {"audit.lost.", &a.largest_loss}}) {
    const std::string prefix = name;
    each(prefix + "value", l->value);
    each(prefix + "time", l->time);
    each(prefix + "step", l->step);
  }
  for (const auto& [name, s] :
       {std::pair{"audit.climb.", &a.largest_step_gain}, {"audit.worst.", &a.worst}}) {
    const std::string prefix = name;
    each(prefix + "value", s->value);
    each(prefix + "time", s->time);
    each(prefix + "length", s->length);
    each(prefix + "node", s->node);
    each(prefix + "touch", s->with);
  }
}

}  // namespace

void save_audit(const Energy& start, const Audit& audit, io::Checkpoint& to) {
  for (const auto& [name, member] : kEnergies) {
    to.scalars[std::string("audit.start.") + name] = start.*member;
    to.scalars[std::string("audit.now.") + name] = audit.now.*member;
  }
  numbers(audit,
          [&](const std::string& name, const auto& value) { to.scalars[name] = static_cast<double>(value); });
}

void restore_audit(const io::Checkpoint& from, Energy& start, Audit& audit) {
  const auto get = [&](const std::string& name) {
    const auto at = from.scalars.find(name);
    return at == from.scalars.end() ? 0.0 : at->second;
  };
  for (const auto& [name, member] : kEnergies) {
    start.*member = get(std::string("audit.start.") + name);
    audit.now.*member = get(std::string("audit.now.") + name);
  }
  numbers(audit, [&]<class T>(const std::string& name, T& value) {
    if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(static_cast<int>(get(name)));
    else
      value = static_cast<T>(get(name));
  });
}

Energy sum_of(MPI_Comm comm, Energy e) {
  std::array<double, std::size(kEnergies)> v;
  for (size_t i = 0; i < v.size(); ++i) v[i] = e.*kEnergies[i].second;
  all_reduce(comm, MPI_SUM, v);
  for (size_t i = 0; i < v.size(); ++i) e.*kEnergies[i].second = v[i];
  return e;
}

}  // namespace hawser::record

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

// Visits each number of an audit, and of the energies from which it counts, with its name.
template <class AnEnergy, class AnAudit, class Each>
void numbers(AnEnergy& start, AnAudit& a, Each&& each) {
  for (const auto& [name, member] : kEnergies) {
    each(std::string("audit.start.") + name, start.*member);
    each(std::string("audit.now.") + name, a.now.*member);
  }
  each("audit.brought_in", a.brought_in);
  each("audit.error", a.error);
  each("audit.initial_kinetic", a.initial_kinetic);
  each("audit.absolute_work", a.absolute_work);
  each("audit.released_strain", a.released_strain);
  each("audit.largest_energy", a.largest_energy);
  each("audit.largest_strain", a.largest_strain);
  each("audit.smallest_error", a.smallest_error);
  each("audit.dissipated", a.dissipated);
  each("audit.remaining", a.remaining);
  each("audit.largest_remaining", a.largest_remaining);
  each("audit.smallest_by_water", a.smallest_by_water);
  for (const auto& [name, l] :
       {std::pair{"audit.largest_gain.", &a.largest_gain}, {"audit.largest_loss.", &a.largest_loss}}) {
    const std::string prefix = name;
    each(prefix + "value", l->value);
    each(prefix + "time", l->time);
    each(prefix + "step", l->step);
  }
  for (const auto& [name, s] :
       {std::pair{"audit.largest_step_gain.", &a.largest_step_gain}, {"audit.worst.", &a.worst}}) {
    const std::string prefix = name;
    each(prefix + "value", s->value);
    each(prefix + "time", s->time);
    each(prefix + "length", s->length);
    each(prefix + "node", s->node);
    each(prefix + "with", s->with);
  }
}

}  // namespace

void save_audit(const Energy& start, const Audit& audit, io::Checkpoint& to) {
  numbers(start, audit,
          [&](const std::string& name, const auto& value) { to.scalars[name] = static_cast<double>(value); });
}

bool has_audit(const io::Checkpoint& c) {
  const Energy start{};
  const Audit audit{};
  bool complete = true;
  numbers(start, audit,
          [&](const std::string& name, const auto&) { complete = complete && c.scalars.count(name) > 0; });
  return complete;
}

void restore_audit(const io::Checkpoint& from, Energy& start, Audit& audit) {
  numbers(start, audit, [&]<class T>(const std::string& name, T& value) {
    const double number = from.scalars.at(name);
    if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(static_cast<int>(number));
    else
      value = static_cast<T>(number);
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

// Node fields of an accepted state: those of the force terms, corrected at line ends and where a volume
// presses between nodes.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "hawser/record/contact_peaks.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/section_fields.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

// Fields that a recording needs after every step, or those of outputs as well.
enum class FieldsFilled { every_step, all };

class NodeFields {
 public:
  // The subject must outlive the object.
  explicit NodeFields(const Subject& subject);

  // Position, velocity and the fields of terms. Others may be appended; then call begin() with those needed
  // at every step.
  std::vector<Field>& fields() { return fields_; }
  void begin(const std::set<std::string>& every_step);
  const std::vector<io::ResultField>& end_fields() const { return end_fields_; }

  // Collective.
  void fill(const Kinematics& state, FieldsFilled which);
  // After fill() of the same state with those of every step: computes the remaining fields. False: nothing
  // was done, because a complete fill() is needed.
  bool complete(const Kinematics& state);

  Values& values() { return values_; }  // by field and owned node
  const Values& values() const { return values_; }
  const Values& ends() const { return ends_; }  // by end field and owned end, in file order
  const EndForces& end_forces() const { return end_forces_; }

 private:
  void fill_field(size_t f, const Kinematics& state);
  void correct_ends(const Kinematics& state);

  const Subject& subject_;
  FieldRegistry registry_;
  std::vector<Field> fields_;
  std::vector<io::ResultField> end_fields_;
  std::vector<char> every_step_;  // by field of the registry
  std::vector<int> onto_;         // by registry field: index in values_ of the field it starts from; -1: none
  bool only_every_step_ = false;  // correct_ends() changes only fields of every step
  EndForces end_forces_;
  ContactPeaks peaks_;
  Values values_, ends_;
  SectionFields section_;
  std::vector<int> support_fields_;  // indices in values_ of the contact forces
};

}  // namespace hawser::record

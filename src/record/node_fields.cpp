// The class NodeFields: list of fields, those needed at every step, and corrections at line ends. A term
// computes the values (fill_field); Recorder::write_output passes them to io::ResultsFile::write_output.
#include "hawser/record/node_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "hawser/math/declination.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {
namespace {

// Tension on one side of a node, where the sides may differ (correct_ends).
FieldSource tension_of_side(const char* name, const std::string& tension) {
  return {{.name = name,
           .unit = "N",
           .history = Field::History::yes,
           .statistics = true,
           .extreme = "effective tension",
           .smallest = true,
           .order = 1},
          [](const Kinematics&, std::span<double>) {},
          tension};
}

// Fields of the state, position and velocity, precede those of the terms.
constexpr size_t kStateFields = 2;

// Fields of ends; the last only with beams.
const io::ResultField kEnds[] = {{"force", "N", 3}, {"direction", "", 3}, {"moment", "N m", 3}};

}  // namespace

NodeFields::NodeFields(const Subject& subject)
    : subject_(subject),
      registry_(subject.system.fields()),
      end_forces_(subject.system, subject.term<Feeders>()),
      peaks_(subject.model, subject.system) {
  fields_ = {{"position", "m", 3}, {"velocity", "m/s", 3}};
  const auto& all = registry_.sources();
  const std::string tension = "effective_tension";
  const std::string before = tension + "_before";
  const std::string after = tension + "_after";
  if (std::any_of(all.begin(), all.end(), [&](const Field& f) { return f.name == tension; }))
    for (const std::string& side : {before, after}) registry_.add(tension_of_side(side.c_str(), tension));
  fields_.insert(fields_.end(), all.begin(), all.end());
  peaks_.find(fields_);
  section_ = SectionFields::find(fields_);
  for (const FieldSource& f : registry_.sources())
    onto_.push_back(f.onto.empty() ? -1 : find_field(fields_, f.onto));
  for (size_t f = 0; f < fields_.size(); ++f)
    if (fields_[f].is_support_force) support_fields_.push_back(static_cast<int>(f));
  ends_.resize(section_.moment >= 0 ? 3 : 2);
  end_fields_.assign(kEnds, kEnds + ends_.size());
}

void NodeFields::begin(const std::set<std::string>& every_step) {
  const size_t owned = subject_.local().owned;
  for (const Field& f : fields_) values_.emplace_back(owned * static_cast<size_t>(f.components));
  // End forces need the tension and the contact forces on a line.
  for (const FieldSource& s : registry_.sources())
    every_step_.push_back(s.is_support_force || s.name == "effective_tension" ||
                          every_step.count(s.name) > 0);
  const auto in_every_step = [this](int f) { return f < 0 || every_step_[f - kStateFields]; };
  const std::array<int, 5> of_beams = section_.of_beams();
  only_every_step_ = in_every_step(section_.tension) && in_every_step(section_.declination) &&
                     in_every_step(section_.wall) && std::ranges::all_of(of_beams, in_every_step);
}

void NodeFields::fill(const Kinematics& state, FieldsFilled which) {
  const size_t owned = subject_.local().owned;
  for (size_t n = 0; n < owned; ++n)
    for (size_t k = 0; k < 3; ++k) {
      values_[0][3 * n + k] = state.x[n][static_cast<Eigen::Index>(k)];
      values_[1][3 * n + k] = state.v[n][static_cast<Eigen::Index>(k)];
    }
  for (size_t f = 0; f < every_step_.size(); ++f)
    if (which == FieldsFilled::all || every_step_[f]) fill_field(f, state);
  correct_ends(state);
}

bool NodeFields::complete(const Kinematics& state) {
  if (!only_every_step_) return false;
  for (size_t f = 0; f < every_step_.size(); ++f)
    if (!every_step_[f]) fill_field(f, state);
  return true;
}

void NodeFields::fill_field(size_t f, const Kinematics& state) {
  std::vector<double>& values = values_[f + kStateFields];
  if (onto_[f] >= 0) values = values_[onto_[f]];
  registry_.sources()[f].fill(state, values);
}

// Element tension is that at mid-element, and element moments exclude the load along the element. At line
// ends, and where tension may jump, the values are those of the forces there (docs/theory/end-forces.md).
// Wall tension changes with effective tension; the pressures are already those of the node.
void NodeFields::correct_ends(const Kinematics& state) {
  const LocalMesh& local = subject_.local();
  std::vector<Vec3> support_forces(static_cast<size_t>(local.nodes()), Vec3::Zero());
  for (const int f : support_fields_)
    for (size_t n = 0; n < static_cast<size_t>(local.owned); ++n)
      support_forces[n] += Eigen::Map<const Vec3>(values_[f].data() + 3 * n).cwiseAbs();
  if (!support_fields_.empty()) subject_.system.update_ghosts(support_forces);
  end_forces_.evaluate(state, support_forces);

  for (auto& e : ends_) e.clear();
  for (const EndForces::SectionNode& p : end_forces_.places()) {
    const size_t n = p.node;
    const auto larger = [&p](auto&& value_of) {
      const double a = value_of(p.sides[0]);
      const double b = value_of(p.sides[1]);
      return std::abs(a) > std::abs(b) ? a : b;
    };
    const auto put = [&](int field, double value) {
      return field < 0 ? 0 : std::exchange(values_[field][n], value);
    };
    put(section_.before, p.sides[0].tension());
    put(section_.after, p.sides[1].tension());
    const Vec3& first = p.sides[0].direction;
    const Vec3& second = p.sides[1].direction;
    put(section_.declination,
        degrees(declination(p.line_end ? p.at_line_end().direction : Vec3(first + second))));
    const double tension = larger([](const SectionForce& s) { return s.tension(); });
    const double middle = put(section_.tension, tension);
    if (section_.wall >= 0) values_[section_.wall][n] += tension - middle;
    if (p.sides[0].beam || p.sides[1].beam)
      for (const int f : section_.of_beams())
        put(f, larger([&](const SectionForce& s) { return section_.value(f, s, state.q[n]); }));
    if (!p.line_end) continue;
    const SectionForce& s = p.at_line_end();
    const Vec3 rows[] = {p.sign() * s.force, s.direction, p.sign() * s.moment};
    for (size_t f = 0; f < ends_.size(); ++f) ends_[f].insert(ends_[f].end(), rows[f].begin(), rows[f].end());
  }
  peaks_.fill(state, values_);
}

}  // namespace hawser::record

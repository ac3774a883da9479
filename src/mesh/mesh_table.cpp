// Nodes and elements from a table of even parts.
#include "hawser/mesh/mesh_table.hpp"

#include <algorithm>
#include <utility>

#include "hawser/math/last_not_after.hpp"
#include "hawser/model/temperature_rows.hpp"

namespace hawser {
namespace {

constexpr int kStride = 64;  // elements between two stored sums of lengths

// Neighbours in an explicit list of elements that form one even part.
bool goes_on(const EvenPart& p, const Element& e) {
  return p.shape->rows < 0 && p.shape->lengths.ratio == 1 && p.line == e.line && p.shape->type == e.type &&
         p.shape->beam == e.beam && p.shape->lengths.length == e.length &&
         p.shape->free_strain == e.free_strain && p.first_node + p.elements == e.first;
}

// The sums of SharedShape, m.
std::vector<double> sums_of(const PartShape& shape) {
  std::vector<double> sums;
  double along = shape.along;
  for (int k = 0; k < shape.lengths.elements; ++k) {
    if (k % kStride == 0) sums.push_back(along);
    along += shape.lengths.element_length(k);
  }
  sums.push_back(along);
  return sums;
}

}  // namespace

double MeshTable::add(int line, const PartShape& shape) {
  auto at = shapes_->find(shape);
  if (at == shapes_->end()) {
    std::vector<double> sums = sums_of(shape);
    const double end = shape.section_end > 0 ? shape.section_end : shape.start + sums.back();
    at = shapes_->emplace(shape, SharedShape{shape, end, std::move(sums)}).first;
  }
  const int elements = shape.lengths.elements;
  parts_.push_back({elements_, nodes_ - 1, line, elements, &at->second});
  elements_ += elements;
  nodes_ += elements;
  return at->second.sums.back();
}

int MeshTable::add(TemperatureRows rows) {
  rows_.push_back(std::move(rows));
  return static_cast<int>(rows_.size()) - 1;
}

void MeshTable::add(const Node& node) { special_.emplace_back(nodes_++, node); }

void MeshTable::add(const Element& e) {
  if (!parts_.empty() && goes_on(parts_.back(), e)) {
    ++parts_.back().elements;
  } else {
    PartShape shape;
    shape.type = e.type;
    shape.beam = e.beam;
    shape.lengths.length = e.length;
    shape.free_strain = e.free_strain;
    const auto shared = shapes_->try_emplace(shape, SharedShape{shape, 0, {}}).first;
    parts_.push_back({.first_element = elements_,
                      .first_node = e.first,
                      .line = e.line,
                      .elements = 1,
                      .shape = &shared->second});
  }
  ++elements_;
}

void MeshTable::set(const std::map<int, Node>& changed) {
  std::vector<std::pair<int, Node>> all(changed.begin(), changed.end());
  std::copy_if(special_.begin(), special_.end(), std::back_inserter(all),
               [&](const auto& special) { return !changed.contains(special.first); });
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  all.shrink_to_fit();
  special_ = std::move(all);
}

double MeshTable::arc_of(const EvenPart& part, int k) const {
  if (k == part.elements) return part.shape->end;
  const int from = k / kStride;
  double along = part.shape->sums[from];
  for (int i = from * kStride; i < k; ++i) along += part.element_length(i);
  return part.shape->start + along;
}

Node MeshTable::node_at(int n) const {
  const auto special = std::lower_bound(special_.begin(), special_.end(), n,
                                        [](const auto& o, int node) { return o.first < node; });
  if (special != special_.end() && special->first == n) return special->second;
  const auto at = last_not_after(parts_, n, &EvenPart::first_node);
  const EvenPart& part = *at;
  const int k = n - part.first_node;
  Node out{.line = part.line, .arc = arc_of(part, k)};
  const auto join = [&out](const EvenPart& p, int element) {
    out.tributary += 0.5 * p.element_length(element);
    out.rotates |= p.shape->beam;
  };
  if (k > 0)
    join(part, k - 1);
  else if (at != parts_.begin() && (at - 1)->line == part.line)
    join(*(at - 1), (at - 1)->elements - 1);
  if (k < part.elements) join(part, k);
  return out;
}

Element MeshTable::element_at(int e) const {
  const EvenPart& part = part_of(e);
  const int k = e - part.first_element;
  const PartShape& shape = *part.shape;
  const double length = part.element_length(k);
  double strain = shape.free_strain;
  if (shape.rows >= 0) {
    const double from = arc_of(part, k);
    strain *= model::mean_temperature_change(rows_[static_cast<size_t>(shape.rows)], from, from + length);
  }
  return {part.line, part.first_node + k, part.first_node + k + 1, shape.type, length, shape.beam, strain};
}

const EvenPart& MeshTable::part_of(int element) const {
  return *last_not_after(parts_, element, &EvenPart::first_element);
}

double MeshTable::length_of(int element) const {
  const EvenPart& part = part_of(element);
  return part.element_length(element - part.first_element);
}

double MeshTable::longest_element() const {
  double longest = 0;
  for (const EvenPart& p : parts_)
    for (const int k : {0, p.elements - 1}) longest = std::max(longest, p.element_length(k));
  return longest;
}

bool MeshTable::any_beam() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const EvenPart& p) { return p.shape->beam; });
}

bool MeshTable::any_cable() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const EvenPart& p) { return !p.shape->beam; });
}

bool MeshTable::any_rotates() const {
  return any_beam() || std::any_of(special_.begin(), special_.end(),
                                   [](const auto& special) { return special.second.rotates; });
}

}  // namespace hawser

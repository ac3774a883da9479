// The seabed, and lines on it and embedded in it, for the term suite.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "hawser/geometry/height_grid.hpp"
#include "hawser/terms/bed_contact.hpp"
#include "hawser/terms/soil_resistance.hpp"
#include "support/taylor_contact.hpp"

namespace hawser::test {

// A seabed that is rotated and moved with the model. It is curved, so that slope and curvature affect the
// result. Distances are those of the original bed.
class PlacedSurface final : public Surface {
 public:
  PlacedSurface(std::shared_ptr<const Surface> bed, const Vec3& origin, const Quat& turn)
      : bed_(std::move(bed)), origin_(origin), turn_(turn) {}
  std::optional<SurfacePoint> query(const Vec3& y, double most, int hint) const override {
    auto s = bed_->query(turn_.conjugate() * (y - origin_), most, hint);
    if (!s) return s;
    const Mat3 R = turn_.toRotationMatrix();
    s->normal = R * s->normal;
    s->point = origin_ + R * s->point;
    s->curvature = R * s->curvature * R.transpose();
    return s;
  }
  Box bounds() const override { return Box::everything(); }

 private:
  std::shared_ptr<const Surface> bed_;
  Vec3 origin_;
  Quat turn_;
};

// Hills and hollows of some metres. The radii of curvature go down to a few times the contact radius.
inline std::shared_ptr<const HeightGrid> hilly() {
  std::vector<double> x, z;
  for (int i = 0; i <= 24; ++i) x.push_back(i - 8);
  for (const double b : x)
    for (const double a : x)
      z.push_back(0.2 * std::sin(0.9 * a + 0.5) * std::cos(0.7 * b) + 0.1 * a - 0.05 * b);
  return std::make_shared<const HeightGrid>(x, x, z);
}

// A seabed below the nodes, sloping or of a grid, each node in its own state (kHistory): with a spring; with
// a table, in whose bends and steep parts the nodes are; with suction on the rising nodes; or in the first
// stage of statics, with friction under a normal force that does not depend on the trial. Points half way
// along the elements take states between those of the nodes.
enum class Soil { spring, table, sticky, laid };
inline BedContact& add_seabed(SuiteModel& m, const Placement& at, double axial, double lateral,
                              bool curved = false, Soil soil = Soil::spring, bool between = false) {
  static const std::vector<ContactForceTable::Row> rows{{2 * mm, 60}, {4.5 * mm, 500}, {20 * mm, 1000}};
  static const ContactForceTable table(rows);
  const LocalMesh& l = m.system->mesh();
  const Quat slope = at.rotation * exp_so3({0.2, -0.1, 0.4});
  const Vec3 origin = at.point({1, 2, 3});
  const BedContact::Plane plane{origin, slope * Vec3::UnitZ()};
  const auto bed = hilly();
  BedContact::PointLaw law;
  law.radius = kContactRadius;
  law.law.normal.stiffness = kNormalStiffness;
  law.law.normal.smoothing = 1 * mm;
  law.law.normal.damping = 500;
  if (soil == Soil::sticky) law.suction = {300, 10 * mm};
  if (soil == Soil::table) law.law.normal = {0.7 * table.largest_slope(), 0, 500, &table, 0.7};
  FrictionLaw& friction = law.law.friction;
  friction.axial = axial;
  friction.lateral = lateral;
  friction.axial_length = 2 * mm;
  friction.lateral_length = 3 * mm;
  const BedContact::PointLaws laws{std::vector<BedContact::PointLaw>(static_cast<size_t>(l.owned), law),
                                   std::vector<BedContact::PointLaw>(between ? l.elements.size() : 0, law)};
  auto term = curved ? std::make_unique<BedContact>(
                           l, std::make_shared<const PlacedSurface>(bed, origin, slope), laws)
                     : std::make_unique<BedContact>(l, plane, laws);
  BedContact& seabed = *term;
  m.system->add(std::move(term));
  Trial& t = m.trial;
  State before = t.from;
  before.time = t.from.time - t.h;
  for (int n = 0; n < l.nodes(); ++n) {
    const int g = l.global[static_cast<size_t>(n)];
    const NodeHistory& s = kHistory[g];
    const auto where = [&](double gap, double slip) -> Vec3 {
      const Vec3 flat = place(ContactOn::plane, g, gap, slip);
      if (!curved) return origin + slope * flat;
      const auto h = bed->at(flat.x(), flat.y());
      const Vec3 normal = Vec3(-h.slope.x(), -h.slope.y(), 1).normalized();
      return origin + slope * (Vec3(flat.x(), flat.y(), h.z) + flat.z() * normal);
    };
    before.x[static_cast<size_t>(n)] = where(s.before, g == 1 ? -0.02 * mm : -0.5 * mm);
    m.put(n, where(s.before, 0), where(s.gap, s.slip), s.speed * (at.rotation * noise3(g, 9)));
  }
  m.system->prepare(at_end(before, t.h), t.h);
  m.system->commit(at_end(t.from, t.h));
  if (soil == Soil::laid) {
    t.h = 0;
    std::vector<Vec3> places = t.from.x;  // inside the slip ellipse and outside it
    for (int n = 0; n < l.nodes(); ++n)
      places[static_cast<size_t>(n)] -=
          2.5 * mm * (at.rotation * noise3(l.global[static_cast<size_t>(n)], 13));
    seabed.lay(places, t.from.at_rest(), false);
    seabed.press_by_contact(t.from.at_rest());
  }
  m.system->prepare(at_end(t.from, t.h), t.h);
  t.length = 0.2 * mm;
  return seabed;
}

inline std::vector<SuiteCase> seabed_cases() {
  std::vector<SuiteCase> out;
  for (const bool curved : {false, true})
    for (const auto& [axial, lateral, friction] :
         {std::tuple{0.0, 0.0, "smooth"}, {0.3, 0.3, "isotropic"}, {0.2, 0.5, "anisotropic"}})
      for (const auto& [soil, kind] : {std::pair{Soil::spring, ""},
                                       {Soil::table, "table, "},
                                       {Soil::sticky, "suction, "},
                                       {Soil::laid, "laid, "}})
        out.push_back(
            {std::string("seabed, ") + (curved ? "grid, " : "") + kind + friction,
             [axial = axial, lateral = lateral, curved, soil = soil](MPI_Comm comm, const Placement& at) {
               auto m = std::make_unique<SuiteModel>(comm, at);
               add_seabed(*m, at, axial, lateral, curved, soil);
               return m;
             }});
  // Some nodes come to the start of a table or to the release of suction, where there is no tangent: springs
  // only.
  for (const auto& [axial, lateral, friction] :
       {std::tuple{0.0, 0.0, "smooth"}, {0.3, 0.3, "isotropic"}, {0.2, 0.5, "anisotropic"}})
    out.push_back({std::string("seabed, half way along too, ") + friction,
                   [axial = axial, lateral = lateral](MPI_Comm comm, const Placement& at) {
                     auto m = std::make_unique<SuiteModel>(comm, at);
                     add_seabed(*m, at, axial, lateral, false, Soil::spring, true);
                     return m;
                   }});
  // Nodes at which the soil sticks, yields along, yields across, and yields in both directions, after a step
  // that left some slip.
  out.push_back({"buried", [](MPI_Comm comm, const Placement& at) {
                   auto m = std::make_unique<SuiteModel>(comm, at);
                   const LocalMesh& l = m->system->mesh();
                   Trial& t = m->trial;
                   State laid = t.from;
                   laid.time = t.from.time - t.h;
                   std::vector<SoilResistance::BuriedNode> places;
                   for (int n = 0; n < l.nodes(); ++n) {
                     const size_t i = static_cast<size_t>(n);
                     const int g = l.global[i];
                     laid.x[i] -= 1 * mm * (at.rotation * noise3(g, 11));
                     if (n < l.owned)
                       places.push_back({n, {200, 300, g % 2 ? 0.01 : 1.0, g % 4 < 2 ? 0.02 : 1.0}});
                   }
                   m->system->add(
                       std::make_unique<SoilResistance>(PETSC_COMM_WORLD, l, at_end(laid, t.h), places));
                   m->system->prepare(at_end(laid, t.h), t.h);
                   m->system->commit(at_end(t.from, t.h));
                   m->system->prepare(at_end(t.from, t.h), t.h);
                   return m;
                 }});
  return out;
}

}  // namespace hawser::test

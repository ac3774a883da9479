// Abscissae and weights of Gauss-Legendre quadrature with 2, 3 and 4 points (Abramowitz and Stegun 1964,
// table 25.4).
#pragma once

namespace hawser {

// centred: abscissae on -1 to 1; unit: the same on 0 to 1; weight: their sum is 1.
template <int n>
struct GaussPoints;

template <>
struct GaussPoints<2> {
  static constexpr double centred[2] = {-0.57735026918962576451, 0.57735026918962576451};
  static constexpr double unit[2] = {0.21132486540518711775, 0.78867513459481288225};
  static constexpr double weight[2] = {0.5, 0.5};
};

template <>
struct GaussPoints<3> {
  static constexpr double centred[3] = {-0.77459666924148337704, 0, 0.77459666924148337704};
  static constexpr double unit[3] = {0.11270166537925831148, 0.5, 0.88729833462074168852};
  static constexpr double weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
};

template <>
struct GaussPoints<4> {
  static constexpr double centred[4] = {-0.86113631159405257522, -0.33998104358485626480,
                                        0.33998104358485626480, 0.86113631159405257522};
  static constexpr double unit[4] = {0.06943184420297371239, 0.33000947820757186760, 0.66999052179242813240,
                                     0.93056815579702628761};
  static constexpr double weight[4] = {0.17392742256872692869, 0.32607257743127307131, 0.32607257743127307131,
                                       0.17392742256872692869};
};

}  // namespace hawser

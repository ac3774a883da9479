// Removal of triangles listed more than once and of pieces without thickness.
//
// Triangles with the same three corners are copies, whatever their orientation. An odd number of copies
// counts as one (in the surface modulo 2 all others cancel). An even number may stand for one, a region of
// the surface written twice, or for none, a fin on the body or a wall in it whose two sides coincide. This is
// decided for whole patches of such triangles, joined two by two, from the rest of the mesh along their rim:
// if it ends there, the patch is needed and one copy stays; if it continues without the patch, both copies of
// the fin or wall are removed. An isolated patch stays once if it has an inside, such as an open hull written
// two-sided, and is removed if it has none, such as a sheet.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct DuplicateResult {
  int copies = 0;        // removed triangles of which another copy stays
  int back_to_back = 0;  // triangles removed with all their copies
};
// Keeps the order of triangles; of copies the first one with the majority's orientation remains.
DuplicateResult drop_duplicates(TriangleMesh& mesh);

// Removes pieces without open edges that lie in one plane to within `thickness` [m]: sheets with different
// triangles on their two sides. Returns their number.
int drop_flat_pieces(TriangleMesh& mesh, double thickness);

}  // namespace hawser

// Triangles that a file lists more than once, and pieces without thickness: what of them is the surface.
//
// Triangles on the same three corners are copies, whichever way they face. An odd number of copies counts as
// one (in the surface modulo 2 all others cancel). An even number may mean one, a region of the surface that
// was written twice, or none, a fin on the body or a wall in it whose two sides lie on each other. That is
// decided for whole patches of such triangles, joined two by two, by what the rest of the mesh does along
// their rim: it ends there (the patch is needed, one copy stays), or it goes on without the patch (a fin or a
// wall: both go). A patch that the rest does not touch stays once if it has an inside behind it, as an open
// hull written two-sided has, and goes if it has none: a sheet.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

struct DuplicateResult {
  int copies = 0;        // triangles excluded from which another copy stays
  int back_to_back = 0;  // triangles excluded with all their copies
};
// The order of those that stay is kept; of copies the first of those that face the way most of them do.
DuplicateResult drop_duplicates(TriangleMesh& mesh);

// Pieces without open edges that lie in one plane, to within `thickness` [m] of it, are dropped: sheets whose
// sides are cut into other triangles each. Returns how many.
int drop_flat_pieces(TriangleMesh& mesh, double thickness);

}  // namespace hawser

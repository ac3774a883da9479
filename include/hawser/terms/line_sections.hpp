// Sections of elements from their line types, for the kernels of beams and cables.
#pragma once

#include "hawser/kernels/beam.hpp"
#include "hawser/kernels/cable.hpp"
#include "hawser/mesh/mesh.hpp"

namespace hawser {

namespace model {
struct Case;
}

// Section of a beam with the contribution of bend stiffeners.
BeamSection beam_section(const Mesh& mesh, const model::Case& c, const Element& e);
CableSection cable_section(const model::Case& c, const Element& e);

}  // namespace hawser

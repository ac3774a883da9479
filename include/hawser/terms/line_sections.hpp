// Sections of elements by their line types, as the kernels of beams and cables take them.
#pragma once

#include "hawser/kernels/beam.hpp"
#include "hawser/kernels/cable.hpp"
#include "hawser/mesh/mesh.hpp"

namespace hawser {

namespace model {
struct Case;
}

// With what bend stiffeners add to the element.
BeamSection beam_section(const Mesh& mesh, const model::Case& c, const Element& e);
CableSection cable_section(const model::Case& c, const Element& e);

}  // namespace hawser

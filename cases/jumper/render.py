"""Pictures of the jumper, coloured by curvature.

    scripts/render cases/jumper/jumper.xdmf out/

The options of scripts/render.py apply, for example --field effective_tension, or --at 30 35 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From the side, the jumper drawn 1 m thick; at rest and with the vessel at both ends of its way.
main(field="curvature", diameter=1.0, direction=[0.0, 1.0, -0.1], focus=[-45.0, 0.0, -48.0], height=104.0,
     size=[640, 560], columns=3, at=[0.0, 87.5, 101.0])

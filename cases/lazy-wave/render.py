"""Pictures of the cable, coloured by curvature.

    scripts/render cases/lazy-wave/lazy-wave.xdmf out/

The options of scripts/render.py apply, for example --field effective_tension, or --at 30 35 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From the side, the cable drawn 1 m thick; at rest and with the hang-off high and low.
main(field="curvature", diameter=1.0, direction=[0.0, 1.0, -0.1], focus=[76.0, 0.0, -47.0], height=86.0,
     size=[1000, 480], columns=1, at=[0.0, 51.0, 57.0])

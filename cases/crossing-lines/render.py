"""Pictures of the hose on the wire, coloured by its bending moment.

    scripts/render cases/crossing-lines/crossing-lines.xdmf out/

The options of scripts/render.py apply, for example --field effective_tension, or --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# 12 m about the crossing, from the side and above.
main(field="bending_moment", diameter=0.2, direction=[-1.0, 0.6, -0.45], focus=[0.0, 0.0, 0.2], height=7.0,
     size=[1200, 600], pictures=1)

"""Pictures of the pipe on the roller, coloured by its bending moment.

    scripts/render cases/roller/roller.xdmf out/

The options of scripts/render.py apply, for example --field effective_tension, or --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# 6 m about the roller, seen along its axis and a little from above.
main(field="bending_moment", diameter=0.2, direction=[-0.25, 1.0, -0.3], focus=[0.0, 0.0, 0.2], height=5.0,
     size=[1200, 500], pictures=1)

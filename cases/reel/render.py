"""Pictures of the reel: the drum and the hose on it, coloured by effective tension.

    scripts/render cases/reel/reel.xdmf out/
    scripts/with-display pvpython cases/reel/render.py cases/reel/reel.xdmf out/     (the same)

The options of scripts/render.py apply, for example --field penetration, or --at 30 200 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# The picture is 19 m high: the reel's flanges (12.8 m) and the first few metres of the hanging hose. The camera looks
# across the axis, so that neither flange hides the turns; the mesh's edges show the reel turning.
main(diameter=0.85, direction=[-1.0, -0.28, -0.3], focus=[0.0, 0.0, -1.5], height=19.0, edges=True, columns=2)

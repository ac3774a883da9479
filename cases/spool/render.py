"""Pictures of the hose on its reel, coloured by its tension.

    scripts/render cases/spool/spool.xdmf out/

The options of scripts/render.py apply, for example --at 300 400 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(diameter=0.85, direction=[-1.0, 0.3, -0.3], focus=[0.0, 0.0, -1.0], height=14.0, size=[600, 600],
     at=[300, 400, 558])

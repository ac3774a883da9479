"""Pictures of the pull-in: the wire and the cable in the J-tube, which is drawn translucent, coloured by effective tension.

    scripts/render cases/jtube/jtube.xdmf out/ --at 0 60 120

The options of scripts/render.py apply.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# Lines are drawn 2.5 times as thick as they are; the cable of 0.16 m still fits into the bore of 0.5 m.
main(direction=[-0.15, 1.0, -0.12], focus=[7.5, 0.0, -8.0], height=46.0, size=[640, 800], factor=2.5, opacity=0.25, no_sea=True)

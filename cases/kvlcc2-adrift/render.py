"""Pictures of the tanker that drifts against a hawser.

    scripts/render cases/kvlcc2-adrift/kvlcc2-adrift.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

main(direction=[0.0, -0.35, -1.0], focus=[0.0, 25.0, 0.0], height=190.0, size=[900, 420], at=[0, 300, 450], columns=1)

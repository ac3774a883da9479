"""Pictures of the module that comes off the boat, and of the one that goes through the surface.

    scripts/render cases/lift/catlines.xdmf out/
    scripts/render cases/lift/splash.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From the side, a little from above: on the deck, as the slings come tight, and up.
if "catlines" in os.path.basename(sys.argv[1]):
    main(direction=[-0.3, 1.0, -0.2], focus=[0, 0, 11.5], height=28.0, size=[760, 680], at=[0, 9.75, 30], columns=3,
         factor=2)
else:
    main(direction=[-0.3, 1.0, -0.2], focus=[0, 0, -4.0], height=40.0, size=[420, 620], at=[20, 50, 70, 130],
         factor=3)

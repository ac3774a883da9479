"""Pictures of the module that comes off the boat, and of the one that goes through the surface.

    scripts/render cases/lift/catlines.xdmf out/
    scripts/render cases/lift/splash.xdmf out/

The options of scripts/render.py apply, for example --at 5 40 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From the side, a little from above: on the deck, as it lifts off, and up.
if "catlines" in os.path.basename(sys.argv[1]):
    main(direction=[-0.3, 1.0, -0.2], focus=[0, 0, 9.5], height=23.0, size=[760, 620], at=[0, 12, 30], columns=3,
         factor=2)
else:
    main(direction=[-0.3, 1.0, -0.1], focus=[0, 0, 1.0], height=32.0, size=[420, 620], at=[20, 50, 70, 130],
         factor=3)

"""Pictures of the hose and the stern of the ship, coloured by effective tension.

    scripts/render cases/offloading-hose/offloading-hose.xdmf out/                 (with contact)
    scripts/render cases/offloading-hose/offloading-hose-no-contact.xdmf out/      (without)

The options of scripts/render.py apply, for example --at 90 140 for certain times.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import main  # noqa: E402

# From above the port quarter, the hose drawn 2 m thick: stowed, on its way, arriving, and where it ends.
main(diameter=2.0, direction=[0.8, 1.0, -0.8], focus=[-12.0, -130.0, -5.0], height=190.0, size=[1000, 800],
     columns=2, at=[0.0, 100.0, 200.0, 300.0], range=[-6.0, 10.0])

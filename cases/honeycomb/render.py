"""The farm from above and the cable between two turbines from the side, in one picture, coloured by effective tension.

    scripts/render cases/honeycomb/honeycomb.xdmf out/

Writes out/honeycomb.png; the options of scripts/render.py apply to both, for example --at 20 for another time.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import below_each_other  # noqa: E402

common = dict(at=[55.0], columns=1)
views = [dict(diameter=12.0, direction=[0.25, 1.0, -0.75], focus=[1800.0, 500.0, -120.0], height=2500.0, size=[1500, 620], range=[0.0, 3000.0]),
         dict(diameter=4.0, direction=[0.0, 1.0, -0.12], focus=[725.0, 0.0, -40.0], height=470.0, size=[1500, 420], range=[0.0, 30.0])]
print(below_each_other(sys.argv[1:], common, views))

"""Two pictures in one, coloured by effective tension: the farm from the west, and one of its floats.

    scripts/render cases/farm/farm.xdmf out/

Writes out/farm.png; the options of scripts/render.py apply to both pictures, for example --at 20 for another time.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from render import below_each_other, pv  # noqa: E402

DEPTH = 120.0  # m


def sea(west, south, east, north):
    """Draws seabed and still water within these limits, m."""

    def add(view):
        for z, colour, opacity in [(-DEPTH - 8, [0.86, 0.80, 0.68], 1.0), (0.0, [0.35, 0.60, 0.85], 0.22)]:
            plane = pv.Plane(Origin=[west, south, z], Point1=[east, south, z], Point2=[west, north, z])
            shown = pv.Show(plane, view)
            shown.DiffuseColor = shown.AmbientColor = colour
            shown.Ambient, shown.Diffuse, shown.Opacity = 0.7, 0.3, opacity

    return add


common = dict(at=[55.0], range=[0.0, 1300.0], columns=1)
# From the west, as the wind blows: all of it, the chains drawn 14 m thick, and the float in the middle of the second row.
views = [dict(diameter=14.0, direction=[1.0, 0.12, -0.55], focus=[620.0, 3080.0, -30.0], height=2560.0, size=[1500, 430],
              scenery=sea(-850, -850, 2350, 7600)),
         dict(diameter=4.0, direction=[1.0, 0.3, -0.42], focus=[1390.0, 3695.0, 25.0], height=660.0, size=[1500, 690],
              scenery=sea(840, 3180, 1950, 4320))]
print(below_each_other(sys.argv[1:], common, views))

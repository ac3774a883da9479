"""Colour maps suitable for all kinds of colour vision."""
import matplotlib
import numpy as np

# Name, label, and whether the map is for signed values.
MAPS = (("viridis", "Viridis", False), ("cividis", "Cividis", False), ("PuOr_r", "Purple to orange, for both signs", True))
STEPS = 256


def maps():
    """[{name, label, signed, colours: 'rrggbb...'}]"""
    found = []
    for name, label, signed in MAPS:
        rgb = np.rint(255 * matplotlib.colormaps[name](np.linspace(0, 1, STEPS))[:, :3]).astype(np.uint8)
        found.append({"name": name, "label": label, "signed": signed, "colours": rgb.tobytes().hex()})
    return found

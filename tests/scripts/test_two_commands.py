#!/usr/bin/env python3
"""scripts/run and scripts/test share one build: the second compiles nothing that the first has compiled."""
import json
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def preset(name):
    """Cache variables of a preset, including inherited ones."""
    presets = {p["name"]: p for p in json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]}
    own = presets[name]
    return {**(preset(own["inherits"]) if "inherits" in own else {}), **own.get("cacheVariables", {})}


def defaults():
    """The options of CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text()
    return dict(re.findall(r'^option\((\w+) "[^"]*" (ON|OFF)\)', text, re.M))


def configured(script):
    """Preset and variables that a script passes to CMake at its first configuration."""
    line = next(l for l in (ROOT / "scripts" / script).read_text().splitlines() if "cmake --preset" in l)
    return re.search(r'--preset "?(\$?\w+)"?', line)[1], dict(re.findall(r"-D(\w+)=(\w+)", line))


class OneBuild(unittest.TestCase):
    def test_both_configure_the_same_build(self):
        known = {**defaults(), **preset("native")}
        name, given = configured("run")
        self.assertEqual((name, given), ("native", {}))
        name, given = configured("test")
        self.assertEqual(name, "$preset")
        self.assertIn("preset=native build=build ", (ROOT / "scripts/test").read_text())
        self.assertTrue(given)
        for variable, value in given.items():
            self.assertEqual(known[variable], value, variable)


if __name__ == "__main__":
    unittest.main()

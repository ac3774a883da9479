"""The JSON Schema of case files, for editors, against a JSON Schema library."""
import copy
import json
import os
import re
import unittest

from support import ROOT, run

try:
    import yaml
    from jsonschema import Draft202012Validator
except ImportError as missing:
    raise SystemExit(f"{missing}: scripts/install-deps installs python3-yaml and python3-jsonschema for Debian's python3")

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
SCHEMA = json.loads(run(HAWSER, "schema", "--json").stdout)


class Loader(yaml.SafeLoader):
    """YAML as read by the program (YAML 1.2): 'on' and '12:30' are words, 1e6 is a number."""


Loader.yaml_implicit_resolvers = {}
for tag, form, first in [
        ("bool", r"true|True|TRUE|false|False|FALSE", "tTfF"),
        ("int", r"[-+]?[0-9]+", "-+0123456789"),
        ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+.0123456789"),
        ("null", r"~|null|Null|NULL|", ["~", "n", "N", ""])]:
    Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{form})$"), list(first))


def parts(node):
    """All maps of the schema."""
    if isinstance(node, dict):
        yield node
        node = list(node.values())
    if isinstance(node, list):
        for child in node:
            yield from parts(child)


def load(path):
    return yaml.load(path.read_text("utf-8"), Loader)


class Schema(unittest.TestCase):
    def faults(self, case):
        return [f"{'.'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in Draft202012Validator(SCHEMA).iter_errors(case)]

    def test_is_a_schema_whose_references_lead_somewhere(self):
        Draft202012Validator.check_schema(SCHEMA)
        references = {part["$ref"] for part in parts(SCHEMA) if "$ref" in part}
        self.assertGreater(len(references), 20)
        self.assertEqual([r for r in references if not r.startswith("#/$defs/") or r[8:] not in SCHEMA["$defs"]], [])

    def test_every_kind_of_unit_is_in_the_guide(self):
        guide = run(HAWSER, "schema").stdout
        self.assertEqual(run(HAWSER, "schema", "--markdown").stdout, guide)
        rows = {line.split("|")[1].strip() for line in guide[guide.index("## Units"):].splitlines() if line.startswith("| ")}
        kinds = {part["$ref"][8:].replace("_", " ") for part in parts(SCHEMA) if "$ref" in part} - {"name"}
        self.assertIn("pressure", kinds)
        self.assertEqual(sorted(kinds - rows), [])

    def test_shipped_cases(self):
        cases = sorted((ROOT / "cases").glob("*/*.yaml"))
        self.assertGreater(len(cases), 10)
        for path in cases + [ROOT / "tests/data/bad/base.yml"]:
            with self.subTest(path=path.name):
                self.assertEqual(self.faults(load(path)), [])

    def test_units_as_the_program_reads_them(self):
        accepted = {"pressure": ["2 bar", "1e5", "0.3 MPa"], "moment of inertia": ["2 t m2", "3 kgm²", "4 kg·m^2"],
                    "damping of a point": ["2 kN s/m", "2 kNs/m"], "damping of turning": ["3 kN m s/rad", "3 kNms/rad"],
                    "stiffness against turning": ["3 kNm/deg", "2 N m/rad"], "density": ["1.025 t/m3"], "volume": ["2 m3"],
                    "area": ["2 m^2"], "temperature change": ["20 K", "5 °C"], "thermal expansion": ["1.2e-5 1/K"]}
        for kind, texts in accepted.items():
            definition = Draft202012Validator({"$ref": f"#/$defs/{kind.replace(' ', '_')}", "$defs": SCHEMA["$defs"]})
            for text in texts:
                self.assertTrue(definition.is_valid(text), f"{text} is a {kind}")
            for text in ["2 furlong", "two", "2 bar m"]:
                self.assertFalse(definition.is_valid(text), f"{text} is no {kind}")

    def test_broken_cases(self):
        sound = load(ROOT / "cases/offloading-hose/offloading-hose.yaml")

        def broken(change):
            case = copy.deepcopy(sound)
            change(case)
            self.assertNotEqual(self.faults(case), [])

        kind = next(iter(sound["line_types"]))
        line = next(iter(sound["lines"]))
        broken(lambda c: c.pop("lines") and c.update(line={}))                           # an unknown key
        broken(lambda c: c["line_types"][kind].update(contents_pressure="2 furlong"))  # a unit of another kind
        broken(lambda c: c["line_types"][kind].update(outer_diameter=-1))                # out of range
        broken(lambda c: c["lines"][line].pop("sections"))  # a required key
        broken(lambda c: c["lines"][line].update(sections=[]))                           # too few
        broken(lambda c: c["dynamics"].update(duration="long"))                          # no number
        broken(lambda c: c["dynamics"].update({"step:0.1": None}))                       # a blank is missing
        broken(lambda c: c.update(hawser=2))                                             # no such version
        for name in ["unknown_key", "diameter_negative", "vec_two", "boolean_word", "two_motions"]:
            with self.subTest(name=name):
                self.assertNotEqual(self.faults(load(ROOT / f"tests/data/bad/{name}.yaml")), [])


if __name__ == "__main__":
    unittest.main()

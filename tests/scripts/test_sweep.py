"""Every key of the schema with NaN, far too large values or other forms: each is refused in a sentence or accepted;
a third of the values for each key; with HAWSER_FULL all, and accepted cases are also run."""
import os
import unittest
from pathlib import Path

import sweep
from support import ROOT

HAWSER = os.environ.get("HAWSER", str(ROOT / "build/hawser"))
CHECKER = Path(HAWSER).parent / "tests/check_many"


class Sweep(unittest.TestCase):
    def test_every_key(self):
        full = bool(os.environ.get("HAWSER_FULL"))
        complaints, codes = sweep.sweep(HAWSER, CHECKER, runs=full, share=1 if full else 3)
        self.assertEqual(complaints, [])
        self.assertGreater(codes[2], 3000 if full else 1000)
        self.assertGreater(codes[0], 300 if full else 100)

    def test_what_is_wrong_is_found(self):
        """NaN in printed output, and places of keys in a case."""
        self.assertTrue(sweep.NO_NUMBER.search("note: the density is inf t/m³"))
        self.assertTrue(sweep.NO_NUMBER.search("by -nan %"))
        self.assertFalse(sweep.NO_NUMBER.search("information, nanometres, res/inf.txt"))
        schema = {"type": "object", "properties": {"a": {"type": "number"}, "b": {"anyOf": [{"type": "string"}, {
            "type": "array", "items": {"type": "object", "properties": {"c": {}}}}]}}}
        self.assertEqual(list(sweep.keys_of(schema)), [("a",), ("b",), ("b", "[]", "c")])
        found = list(sweep.places_of(schema, {"b": [{"c": "1"}]}))
        self.assertEqual(found, [(("a",), ("a",), False), (("b",), ("b",), True), (("b", "[]", "c"), ("b", 0, "c"), True)])
        self.assertEqual(sweep.changed({"b": [{"c": "1"}]}, ("b", 0, "c"), "nan"), "{b: [{c: nan}]}\n")


if __name__ == "__main__":
    unittest.main()

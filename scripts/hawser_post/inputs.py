"""Input in a report: line types, lines with their sections and ends, and other parts of the case, as written with
their units, plus defaults."""
from .results import dictionary
from .sections import lengths, part, sections_of, length_key

LONGEST = 80  # characters of a value
# Properties of line types in the order of the table: key, unit.
PROPERTIES = (("outer_diameter", "m"), ("contact_diameter", "m"), ("displaced_diameter", "m"), ("drag_diameter", "m"),
              ("inner_diameter", "m"), ("mass_per_length", "kg/m"), ("EA", "N"), ("EI2", "N m²"), ("EI3", "N m²"), ("GJ", "N m²"),
              ("GA", "N"), ("stiffness_damping", "s"), ("thermal_expansion", "1/K"), ("breaking_load", "N"),
              ("minimum_bend_radius", "m"), ("Cd_normal", ""), ("Cd_axial", ""), ("Ca_normal", ""), ("Ca_axial", ""),
              ("contents_density", "kg/m³"), ("contents_pressure", "Pa"))


def words(value):
    """A value of the case as text: lists of maps as 'thickness 3 mm, density 900; thickness 40 mm, ...'."""
    if isinstance(value, dict):
        return ", ".join(f"{key} {words(v)}" for key, v in value.items())
    if isinstance(value, list) and any(isinstance(v, dict) for v in value):
        return "; ".join(map(words, value))
    if isinstance(value, list):
        return "[" + ", ".join(map(words, value)) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    return "" if value is None else f"{value:g}" if isinstance(value, float) else str(value)


def shortened(text):
    return text if len(text) <= LONGEST else text[: LONGEST - 3] + "..."


def rows_of(value, path=()):
    """Keys with their paths and their values as text; nested keys in separate rows."""
    if isinstance(value, dict) and value:
        for key, inner in value.items():
            yield from rows_of(inner, (*path, key))
    elif path:
        yield ".".join(path), shortened("" if value == {} else words(value))


def with_defaults(given, read, path=()):
    """Rows of given keys, followed by marked rows of nonempty defaults."""
    for key, value in given.items():
        if isinstance(value, dict) and value:
            yield from with_defaults(value, dictionary(read.get(key)), (*path, key))
        else:
            yield from rows_of(value, (*path, key))
    for key, value in read.items():
        if key not in given and value not in ({}, []):
            yield from ((name, f"{text} (default)") for name, text in rows_of(value, (*path, key)))


def line_types(results):
    """Table of line types in the case, one row per key, with nested keys such as 'pipe.wall_thickness'."""
    read = part(results, "line_types")
    types = {name: dict(with_defaults(keys, dictionary(read.get(name))))
             for name, keys in dictionary(results.given.get("line_types")).items()}
    keys = list(dict.fromkeys(key for values in types.values() for key in values))
    return ["key", *types], [[key, *(values.get(key, "") for values in types.values())] for key in keys]


def properties(results):
    """Table of properties used for line types: given, from the library, or derived; without properties that are 0
    for all."""
    types = dictionary(results.as_read.get("line_types"))
    rows = [[f"{key} [{unit}]" if unit else key, *(float(values[key]) for values in types.values())]
            for key, unit in PROPERTIES if any(values.get(key) for values in types.values())]
    return ["computed with", *types], rows


def sections(results):
    """Table of sections and ends of lines; a section length found by a target is included."""
    head, rows = ["line", "section", "length", "type", "end A", "end B"], []
    known = {line.name: line for line in results.lines}
    for name, line in dictionary(results.given.get("lines")).items():
        ends = [end_words(line.get(key)) for key in ("end_a", "end_b")]
        found = {length_key(results, name): lengths(results, known[name])} if name in known else {}
        for k, (section, written) in enumerate(zip(sections_of(results, name), line.get("sections", []))):
            given = length_words(written["length"])
            length = f"{found[k][k]:.6g} m found by the target (given: {given})" if k in found else given
            rows.append([name if k == 0 else "", str(k + 1), length, section["type"], *(ends if k == 0 else ["", ""])])
    return head, rows


def length_words(text):
    """A length as written; a bare number is in m."""
    try:
        float(text)
    except ValueError:
        return text
    return f"{text} m"


def end_words(end):
    """Short description of a line end."""
    if not isinstance(end, dict):
        return str(end or "")
    clamped = ", clamped" if end.get("clamped") in ("true", "True", "TRUE") else ""
    for key, before in (("anchor", "anchored at "), ("body", "on "), ("joint", "joint ")):
        if key in end:
            at = f" at {words(end['at'])}" if "at" in end else ""
            return f"{before}{words(end[key])}{at}{clamped}"
    return ", ".join(end)


def on_lines(results):
    """Table of other items of lines: masses, bend stiffeners, end springs, loads, targets."""
    rows = []
    for name, line in dictionary(results.given.get("lines")).items():
        rest = {key: value for key, value in line.items() if key != "sections"}
        for end in ("end_a", "end_b"):
            kept = {k: v for k, v in dictionary(rest.get(end)).items() if k not in ("anchor", "body", "joint", "at", "clamped")}
            rest.pop(end, None)
            rest.update({end: kept} if kept else {})
        for key, value in rest.items():
            if isinstance(value, list) and any(isinstance(v, dict) for v in value):  # one row per entry
                rows += [[name, f"{key}[{k}]", shortened(words(v))] for k, v in enumerate(value)]
            else:
                rows += [[name, *row] for row in rows_of(value, (key,))]
    return ["line", "key", "value"], rows


def echo(results, name):
    """Rows of a part of the case, such as its environment: one per key or list entry, with its path."""
    given, read = results.given.get(name), results.keys.get(name)
    if isinstance(given, list):
        return [name, "value"], [[f"[{k}]", shortened(words(v))] for k, v in enumerate(given)]
    if given is not None and not isinstance(given, dict):
        return [name, "value"], [[name, words(given)]]
    if read is None or read == {}:
        return [name, "value"], []
    if not isinstance(read, dict):
        return [name, "value"], [[name, f"{words(read)} (default)"]]
    return [name, "value"], [list(row) for row in with_defaults(given or {}, read)]

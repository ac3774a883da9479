"""What a report shows of the case file, with its units: line types, sections and ends of lines, any other part."""
from .sections import lengths, part, sections_of, sought

LONGEST = 80  # letters of a value


def words(value):
    """A value of the case file as text: lists of maps as 'thickness 3 mm, density 900; thickness 40 mm, ...'."""
    if isinstance(value, dict):
        return ", ".join(f"{key} {words(v)}" for key, v in value.items())
    if isinstance(value, list) and any(isinstance(v, dict) for v in value):
        return "; ".join(map(words, value))
    if isinstance(value, list):
        return "[" + ", ".join(map(words, value)) + "]"
    return "" if value is None else str(value).lower() if isinstance(value, bool) else str(value)


def rows_of(value, path=()):
    """Keys with their paths, and their values as text; those below each other one by one."""
    if isinstance(value, dict) and value:
        for key, inner in value.items():
            yield from rows_of(inner, (*path, str(key)))
    elif path:
        text = "" if value == {} else words(value)
        yield ".".join(path), text if len(text) <= LONGEST else text[: LONGEST - 3] + "..."


def line_types(results):
    """The line types as the case file has them: a row for each key, 'pipe.wall_thickness' for those of its maps."""
    types = {k: dict(rows_of(v)) for k, v in part(results, "line_types").items() if isinstance(v, dict)}
    keys = list(dict.fromkeys(key for values in types.values() for key in values))
    return ["key", *map(str, types)], [[key, *(values.get(key, "") for values in types.values())] for key in keys]


def sections(results):
    """The lines as the case file has them: sections and ends; of a section with the length that a target has found that
    one."""
    head, rows = ["line", "section", "length", "type", "end A", "end B"], []
    known = {line.name: line for line in results.lines}
    for name, line in part(results, "lines").items():
        if not isinstance(line, dict):
            continue
        ends = [end_words(line.get(key)) for key in ("end_a", "end_b")]
        found = {sought(results, name): lengths(results, known[name])} if name in known else {}
        for k, section in enumerate(sections_of(results, name)):
            given = length_words(section.get("length", ""))
            length = f"{found[k][k]:.6g} m found by the target (given: {given})" if k in found else given
            rows.append([str(name) if k == 0 else "", str(k + 1), length, str(section.get("type", "")),
                         *(ends if k == 0 else ["", ""])])
    return head, rows


def length_words(value):
    return f"{value} m" if isinstance(value, (int, float)) else str(value)


def end_words(end):
    """An end of a line in a few words."""
    if not isinstance(end, dict):
        return str(end or "")
    clamped = ", clamped" if end.get("clamped") else ""
    for key, before in (("anchor", "anchored at "), ("body", "on "), ("joint", "joint ")):
        if key in end:
            at = f" at {end['at']}" if "at" in end else ""
            return f"{before}{end[key]}{at}{clamped}"
    return ", ".join(map(str, end))


def echo(results, name):
    """A part of the case file, such as its environment: a row for each key, with its path."""
    return [name, "value"], [list(row) for row in rows_of(part(results, name))]

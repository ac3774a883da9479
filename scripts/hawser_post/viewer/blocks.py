"""Arrays packed for a browser as integer multiples of a step, stored as differences, compressed if that halves the
size.

A block is the text 'hwb1', the length of its header (4 bytes, little-endian), the header (JSON) and the bytes of the
values. Members of the header:

    kind      'steps' (below), or 'float32', 'float64', 'uint32': the values, byte 0 of all, then byte 1 of all, ...
    rows, columns
    deflated  whether the bytes are compressed (zlib)
    step, offset, order, planes    for 'steps': a value is offset + step k with an integer k >= 0; k = -1 is NaN. Stored
              are differences of k, order[0] times between rows, order[1] times between columns, in 32 bits with
              wrap-around, mapped to 2 d or -2 d - 1: byte 0 of all, then byte 1 of all, ..., `planes` bytes
"""
import json
import zlib

import numpy as np

MOST_STEPS = 2**30
ORDERS = ((1, 2), (2, 1), (1, 1), (0, 2), (0, 1), (1, 0))
SAMPLE = 200_000  # values used to choose the order


def packed(header, data):
    """A block, compressed if that halves it."""
    small = zlib.compress(data, 6)
    header["deflated"] = 2 * len(small) <= len(data)
    text = json.dumps(header, separators=(",", ":")).encode()
    return b"hwb1" + len(text).to_bytes(4, "little") + text + (small if header["deflated"] else data)


def plain(values, kind):
    """A block with unpacked values."""
    values = np.atleast_2d(np.asarray(values, np.dtype(kind).newbyteorder("<")))
    bytes_of = np.ascontiguousarray(values).view(np.uint8).reshape(-1, values.dtype.itemsize)
    return packed({"kind": kind, "rows": values.shape[0], "columns": values.shape[1]}, bytes_of.T.tobytes())


def differences(k, order):
    k = k.copy()
    for _ in range(order[0]):
        k[1:] -= k[:-1].copy()
    for _ in range(order[1]):
        k[:, 1:] -= k[:, :-1].copy()
    return k


def bytes_of(k, order):
    """Byte planes of the differences, and their number."""
    d = differences(k, order)
    folded = ((d << 1) ^ (d >> 31)).view(np.uint32)
    count = max(1, (int(folded.max(initial=0)).bit_length() + 7) // 8)
    return b"".join(((folded >> np.uint32(8 * i)) & np.uint32(255)).astype(np.uint8).tobytes() for i in range(count)), count


def steps(values, step):
    """A block with values to half a `step`, larger if the values would need too many steps."""
    values = np.atleast_2d(np.asarray(values, float))
    finite = np.isfinite(values)
    low = float(values.min(where=finite, initial=np.inf))
    high = float(values.max(where=finite, initial=-np.inf))
    if not low <= high:
        low = high = 0.0
    step = max(step, (high - low) / MOST_STEPS, np.finfo(float).tiny)
    k = np.full(values.shape, -1, np.int32)
    k[finite] = np.rint((values[finite] - low) / step)
    rows = max(1, SAMPLE // max(1, k.shape[1]))
    sizes = [len(zlib.compress(bytes_of(k[:rows], order)[0], 3)) for order in ORDERS]
    order = ORDERS[int(np.argmin(sizes))]
    data, planes = bytes_of(k, order)
    return packed({"kind": "steps", "rows": k.shape[0], "columns": k.shape[1], "step": step, "offset": low, "order": order,
                   "planes": planes}, data)


def shares(values, parts=65000):
    """A block with values to half of a 65000th of their range."""
    finite = np.asarray(values, float)
    finite = finite[np.isfinite(finite)]
    return steps(values, float(np.ptp(finite)) / parts if finite.size else 1.0)


def unpacked(block):
    """Values of a block, as decoded by the browser."""
    length = int.from_bytes(block[4:8], "little")
    header = json.loads(block[8 : 8 + length])
    data = block[8 + length :]
    data = zlib.decompress(data) if header["deflated"] else data
    shape = header["rows"], header["columns"]
    if header["kind"] != "steps":
        kind = np.dtype(header["kind"]).newbyteorder("<")
        return np.ascontiguousarray(np.frombuffer(data, np.uint8).reshape(kind.itemsize, -1).T).view(kind).reshape(shape)
    folded = np.zeros(shape, np.uint32)
    for i, plane in enumerate(np.frombuffer(data, np.uint8).reshape(header["planes"], *shape)):
        folded |= plane.astype(np.uint32) << np.uint32(8 * i)
    k = (folded >> np.uint32(1)).view(np.int32) ^ -(folded & np.uint32(1)).view(np.int32)
    for axis in (1, 0):
        for _ in range(header["order"][axis]):
            k = np.cumsum(k, axis=axis, dtype=np.int32)
    return np.where(k < 0, np.nan, header["offset"] + header["step"] * k)

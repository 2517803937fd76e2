"""EXT_meshopt_compression: the three codecs and the three filters of its specification."""
import math
import struct


def decode(data, mode, name_of_filter, count, stride):
    """The uncompressed bytes of a buffer view: count elements of stride bytes."""
    if mode == "ATTRIBUTES":
        return FILTERS[name_of_filter](attributes(data, count, stride), stride)
    indices = triangles(data, count) if mode == "TRIANGLES" else index_sequence(data, count)
    return struct.pack("<%d%s" % (count, {2: "H", 4: "I"}[stride]), *indices)


def unzigzag(v):
    return v >> 1 if v % 2 == 0 else -((v + 1) >> 1)


class Bytes:
    """Bytes read one after the other."""

    def __init__(self, data, position):
        self.data, self.position = data, position

    def take(self, count):
        self.position += count
        return self.data[self.position - count:self.position]

    def byte(self):
        return self.take(1)[0]

    def varint(self):
        """Seven bits in each byte, the lowest first; the top bit says that more follow."""
        value, shift = 0, 0
        while True:
            byte = self.byte()
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value


# Attributes: blocks of elements; in a block, one run of deltas for each byte of the element; in a run, groups of 16.

def attributes(data, count, stride):
    assert data[0] == 0xA0
    source = Bytes(data, 1)
    previous = list(data[len(data) - stride:])  # the tail ends with the element before the first
    block_size = min(8192 // stride // 16 * 16, 256)
    out = bytearray()
    for first in range(0, count, block_size):
        size = min(block_size, count - first)
        columns = []
        for k in range(stride):
            column = []
            for delta in delta_run(source, size):
                previous[k] = (previous[k] + unzigzag(delta)) % 256
                column.append(previous[k])
            columns.append(column)
        for element in zip(*columns):
            out += bytes(element)
    return bytes(out)


def delta_run(source, size):
    groups = (size + 15) // 16
    header = source.take((groups + 3) // 4)
    deltas = []
    for group in range(groups):
        deltas += delta_group(source, header[group // 4] >> group % 4 * 2 & 3)
    return deltas[:size]


def delta_group(source, kind):
    """16 deltas of 0, 2, 4 or 8 bits, the first in the highest bits; one of all ones stands for a byte behind them."""
    if kind == 0:
        return [0] * 16
    if kind == 3:
        return list(source.take(16))
    bits = 2 * kind
    packed = int.from_bytes(source.take(2 * bits), "big")
    short = [packed >> bits * (15 - i) & (1 << bits) - 1 for i in range(16)]
    return [source.byte() if delta == (1 << bits) - 1 else delta for delta in short]


# Triangles: edges and vertices seen last are named by their rank, new vertices count up from 0.

def triangles(data, count):
    assert data[0] == 0xE1
    codes, source, table = data[1:1 + count // 3], Bytes(data, 1 + count // 3), data[len(data) - 16:]
    edges, vertices, out = [(None, None)] * 16, [None] * 16, []  # the latest is at index 0
    new, last = 0, 0

    def push(queue, entry):
        queue.insert(0, entry)
        queue.pop()

    for code in codes:
        if code < 0xF0:
            a, b = edges[code >> 4]
            z = code & 15
            if z == 0:
                c, new = new, new + 1
            elif z < 13:
                c = vertices[z]
            else:
                last = c = last + {13: -1, 14: 1}[z] if z < 15 else last + unzigzag(source.varint())
            if z == 0 or z >= 13:
                push(vertices, c)
            push(edges, (c, b))
            push(edges, (a, c))
        else:
            free_a = code == 0xFF
            pair = table[code & 15] if code < 0xFE else source.byte()
            if code >= 0xFE and pair == 0:
                new = 0
            y, z = pair >> 4, pair & 15
            known = list(vertices)  # ranks count from before this triangle
            a, b, c = None, None, None
            if not free_a:
                a, new = new, new + 1
            if y == 0:
                b, new = new, new + 1
            elif y < 15:
                b = known[y - 1]
            if z == 0:
                c, new = new, new + 1
            elif z < 15:
                c = known[z - 1]
            if free_a:
                last = a = last + unzigzag(source.varint())
            if y == 15:
                last = b = last + unzigzag(source.varint())
            if z == 15:
                last = c = last + unzigzag(source.varint())
            push(vertices, a)
            if y in (0, 15):
                push(vertices, b)
            if z in (0, 15):
                push(vertices, c)
            push(edges, (b, a))
            push(edges, (c, b))
            push(edges, (a, c))
        out += [a, b, c]
    return out


def index_sequence(data, count):
    """Differences to either of two indices before: the lowest bit says to which."""
    assert data[0] == 0xD1
    source, last, out = Bytes(data, 1), [0, 0], []
    for _ in range(count):
        value = source.varint()
        last[value & 1] += unzigzag(value >> 1)
        out.append(last[value & 1])
    return out


# Filters, over whole elements.

def round_half_away(x):
    return int(x + 0.5) if x >= 0 else -int(0.5 - x)


def unfiltered(data, stride):
    return data


def exponential(data, stride):
    """An exponent in the upper 8 bits, a mantissa in the lower 24, both signed."""
    out = []
    for (word,) in struct.iter_unpack("<i", data):
        mantissa = word & 0xFFFFFF
        out.append(math.ldexp(mantissa - (mantissa >> 23 << 24), word >> 24))
    return struct.pack("<%df" % len(out), *out)


def octahedral(data, stride):
    layout, largest = ("<4b", 127) if stride == 4 else ("<4h", 32767)
    out = bytearray()
    for x, y, one, w in struct.iter_unpack(layout, data):
        x, y = x / one, y / one
        z = 1 - abs(x) - abs(y)
        fold = max(-z, 0)
        x, y = x - math.copysign(fold, x), y - math.copysign(fold, y)
        length = math.sqrt(x * x + y * y + z * z)
        out += struct.pack(layout, *(round_half_away(v / length * largest) for v in (x, y, z)), w)
    return bytes(out)


def quaternion(data, stride):
    out = bytearray()
    for x, y, z, code in struct.iter_unpack("<4h", data):
        scale = 1 / math.sqrt(2) / (code | 3)
        x, y, z = x * scale, y * scale, z * scale
        w = math.sqrt(max(0.0, 1 - x * x - y * y - z * z))
        largest, result = code & 3, [0] * 4
        for k, v in enumerate((w, x, y, z)):
            result[(largest + k) % 4] = round_half_away(v * 32767)
        out += struct.pack("<4h", *result)
    return bytes(out)


FILTERS = {"NONE": unfiltered, "EXPONENTIAL": exponential, "OCTAHEDRAL": octahedral, "QUATERNION": quaternion}

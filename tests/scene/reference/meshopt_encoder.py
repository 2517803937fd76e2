"""Streams that meshopt.py decodes to given content; of the codes that fit, any may be taken."""


def zigzag(v):
    return 2 * v if v >= 0 else -2 * v - 1


def varint(v):
    return bytes([v]) if v < 128 else bytes([v & 127 | 128]) + varint(v >> 7)


def attributes(rng, data, stride):
    out, previous = bytearray([0xA0]), bytes(stride)
    block = min(8192 // stride // 16 * 16, 256) * stride
    if rng.random() < 0.5:
        previous = data[:stride]
    tail = bytes(max(32 - stride, 0)) + previous
    for first in range(0, len(data), block):
        content = data[first:first + block]
        for k in range(stride):
            column = previous[k:k + 1] + content[k::stride]
            deltas = [(b - a + 128) % 256 - 128 for a, b in zip(column, column[1:])]
            out += delta_run(rng, [zigzag(d) for d in deltas])
        previous = content[-stride:]
    return bytes(out) + tail


def delta_run(rng, deltas):
    deltas = deltas + [0] * (-len(deltas) % 16)
    groups = [deltas[i:i + 16] for i in range(0, len(deltas), 16)]
    kinds = [rng.choice([kind for kind in range(4) if kind > 0 or not any(group)]) for group in groups]
    header = bytearray((len(groups) + 3) // 4)
    for i, kind in enumerate(kinds):
        header[i // 4] |= kind << i % 4 * 2
    return bytes(header) + b"".join(map(delta_group, groups, kinds))


def delta_group(group, kind):
    if kind == 0:
        return b""
    if kind == 3:
        return bytes(group)
    bits, packed = 2 * kind, 0
    largest = (1 << bits) - 1
    for delta in group:
        packed = packed << bits | min(delta, largest)
    return packed.to_bytes(2 * bits, "big") + bytes(delta for delta in group if delta >= largest)


def index_sequence(rng, indices):
    out, last = bytearray([0xD1]), [0, 0]
    for index in indices:
        which = rng.randrange(2)
        out += varint(zigzag(index - last[which]) << 1 | which)
        last[which] = index
    return bytes(out) + bytes(4)


class Triangles:
    """Keeps the latest edges and vertices as the decoder does: the last of a list is the latest."""

    def __init__(self, rng):
        self.rng, self.codes, self.data = rng, bytearray([0xE1]), bytearray()
        self.table = bytes([0, *(rng.randrange(15) << 4 | rng.randrange(15) for _ in range(15))])  # 0: three new ones
        self.edges, self.vertices, self.new, self.last = [(None, None)] * 16, [None] * 16, 0, 0

    def encode(self, indices):
        for i in range(0, len(indices), 3):
            a, b, c = indices[i:i + 3]
            ranks = [k for k in range(15) if self.edges[-1 - k] == (a, b)]
            if ranks and self.rng.random() < 0.8:
                self.on_edge(self.rng.choice(ranks), a, b, c)
            else:
                self.of_vertices(a, b, c)
        return bytes(self.codes + self.data) + self.table

    def free(self, index):
        delta, self.last = zigzag(index - self.last), index
        return varint(delta)

    def on_edge(self, rank, a, b, c):
        choices = [15] + [z for z in range(1, 13) if self.vertices[-1 - z] == c]
        choices += [0] * (c == self.new) + [13] * (c == self.last - 1) + [14] * (c == self.last + 1)
        z = self.rng.choice(choices)
        self.codes.append(rank << 4 | z)
        if z == 15:
            self.data += self.free(c)
        elif z >= 13:
            self.last = c
        self.new += z == 0
        self.vertices += [c] if z == 0 or z >= 13 else []
        self.edges += [(c, b), (a, c)]

    def of_vertices(self, a, b, c):
        if (a, b, c) == (0, 1, 2) and self.rng.random() < 0.5:
            self.new, y, z = 3, 0, 0
            self.codes.append(0xFE)  # begins again
            self.data.append(0)
        else:
            free_a = a != self.new or self.rng.random() < 0.3
            self.new += not free_a
            y = self.rank(b, True)
            z = self.rank(c, not (free_a and y == 0))  # those three would begin again
            in_table = [k for k in range(14) if self.table[k] == (y << 4 | z) and not free_a]
            if in_table:
                self.codes.append(0xF0 | self.rng.choice(in_table))
            else:
                self.codes.append(0xFF if free_a else 0xFE)
                self.data.append(y << 4 | z)
            for index, is_free in ((a, free_a), (b, y == 15), (c, z == 15)):
                self.data += self.free(index) if is_free else b""
        self.vertices += [a] + [b] * (y in (0, 15)) + [c] * (z in (0, 15))
        self.edges += [(b, a), (c, b), (a, c)]

    def rank(self, index, may_be_new):
        known = [k + 1 for k in range(14) if self.vertices[-1 - k] == index]
        chosen = self.rng.choice([15, *known] + [0] * (may_be_new and index == self.new))
        self.new += chosen == 0
        return chosen

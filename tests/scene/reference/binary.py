"""The binary half of a generated document."""
import struct

from reference import meshopt_encoder

INTEGERS = {5120: ("b", -128, 127), 5121: ("B", 0, 255), 5122: ("h", -32768, 32767), 5123: ("H", 0, 65535)}
WIDTH = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Binary:
    """Buffer views and accessors, of random layout: padded rows, sparse ones, some without a buffer view."""

    def __init__(self, rng):
        self.rng, self.bytes, self.views, self.accessors, self.fallback = rng, bytearray(), [], [], 0

    def view(self, rows, layout, stride=None, indices=False, **more):
        size = stride or struct.calcsize(layout)
        content = b"".join(struct.pack(layout, *row) + bytes(size - struct.calcsize(layout)) for row in rows)
        view = {"buffer": 0, "byteOffset": self.append(content), "byteLength": len(content), **more}
        if self.rng.random() < 0.3 and (size in (2, 4) if indices else size % 4 == 0):
            mode, stream = self.compressed(rows, content, size, indices)
            view.update(buffer=1, byteOffset=0, extensions={"EXT_meshopt_compression": {
                "buffer": 0, "byteOffset": self.append(stream), "byteLength": len(stream), "byteStride": size,
                "count": len(rows), "mode": mode}})
            self.fallback = max(self.fallback, len(content))
        self.views.append(view)
        return len(self.views) - 1

    def append(self, content):
        self.bytes += bytes(-len(self.bytes) % 4) + content
        return len(self.bytes) - len(content)

    def compressed(self, rows, content, stride, indices):
        if not indices:
            return "ATTRIBUTES", meshopt_encoder.attributes(self.rng, content, stride)
        if len(rows) % 3 or self.rng.random() < 0.5:
            return "INDICES", meshopt_encoder.index_sequence(self.rng, [i for (i,) in rows])
        return "TRIANGLES", meshopt_encoder.Triangles(self.rng).encode([i for (i,) in rows])

    def accessor(self, kind, component, rows, normalized=False, may_be_padded=False, indices=False):
        letter = INTEGERS[component][0] if component in INTEGERS else {5125: "I", 5126: "f"}[component]
        layout = "<" + letter * WIDTH[kind]
        accessor = {"componentType": component, "type": kind, "count": len(rows)}
        if normalized:
            accessor["normalized"] = True
        if may_be_padded and self.rng.random() < 0.2:
            chosen = sorted(self.rng.sample(range(len(rows)), self.rng.randint(1, len(rows))))
            targets = self.view([(i,) for i in chosen], "<H", indices=True)
            values = self.view([rows[i] for i in chosen], layout)
            accessor["sparse"] = {"count": len(chosen), "indices": {"bufferView": targets, "componentType": 5123},
                                  "values": {"bufferView": values}}
            rows = [self.rng.choice(rows)] * len(rows) if self.rng.random() < 0.5 else None
        if rows is not None:
            size = struct.calcsize(layout)
            stride = size + -size % 4 + self.rng.choice((0, 4)) if may_be_padded else None
            more = {"byteStride": stride} if stride else {}
            accessor["bufferView"] = self.view(rows, layout, stride, indices, **more)
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def floats(self, kind, rows, **more):
        return self.accessor(kind, 5126, rows, **more)

    def integers(self, kind, component, count, normalized, **more):
        _, low, high = INTEGERS[component]
        rows = [[self.rng.choice((low, high, self.rng.randint(low, high))) for _ in range(WIDTH[kind])]
                for _ in range(count)]
        return self.accessor(kind, component, rows, normalized, **more)

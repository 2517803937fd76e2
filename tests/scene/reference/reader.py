"""GLB files: the JSON, the bytes of buffer views, and accessors as lists of tuples."""
import json
import pathlib
import struct

from reference import meshopt

COMPONENTS = {5120: ("b", 127), 5121: ("B", 255), 5122: ("h", 32767), 5123: ("H", 65535),
              5125: ("I", 2**32 - 1), 5126: ("f", None)}
COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Document:
    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        size = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + size])
        self.binary = data[28 + size:]
        self.views, self.accessors = {}, {}
        if "KHR_draco_mesh_compression" in self.list("extensionsRequired"):
            raise NotImplementedError("%s is compressed by Draco" % path)

    def list(self, name):
        return self.json.get(name, [])

    def view(self, index):
        """The bytes of a buffer view. A GLB's only buffer with bytes in it is the first."""
        if index not in self.views:
            view = self.json["bufferViews"][index]
            compressed = view.get("extensions", {}).get("EXT_meshopt_compression")
            part = compressed or view
            start = part.get("byteOffset", 0)
            content = self.binary[start:start + part["byteLength"]]
            if compressed:
                content = meshopt.decode(content, compressed["mode"], compressed.get("filter", "NONE"),
                                         compressed["count"], compressed["byteStride"])
            self.views[index] = content
        return self.views[index]

    def elements(self, view, offset, count, layout, stride):
        return [struct.unpack_from(layout, self.view(view), offset + i * stride) for i in range(count)]

    def accessor(self, index):
        """One tuple for each element: integers where they are not normalised, else floats."""
        if index not in self.accessors:
            self.accessors[index] = self.read_accessor(self.json["accessors"][index])
        return self.accessors[index]

    def read_accessor(self, a):
        letter, largest = COMPONENTS[a["componentType"]]
        layout = "<" + letter * COUNTS[a["type"]]
        tight = struct.calcsize(layout)
        if "bufferView" in a:
            stride = self.json["bufferViews"][a["bufferView"]].get("byteStride", tight)
            values = self.elements(a["bufferView"], a.get("byteOffset", 0), a["count"], layout, stride)
        else:
            values = [(0,) * COUNTS[a["type"]]] * a["count"]
        if "sparse" in a:
            count, at, new = a["sparse"]["count"], a["sparse"]["indices"], a["sparse"]["values"]
            index_layout = "<" + COMPONENTS[at["componentType"]][0]
            targets = self.elements(at["bufferView"], at.get("byteOffset", 0), count, index_layout,
                                    struct.calcsize(index_layout))
            replacements = self.elements(new["bufferView"], new.get("byteOffset", 0), count, layout, tight)
            for (target,), value in zip(targets, replacements):
                values[target] = value
        if a.get("normalized") and largest:
            values = [tuple(max(x / largest, -1.0) for x in value) for value in values]
        return values

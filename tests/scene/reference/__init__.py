"""A second evaluator of everything in glTF 2.0 that decides triangles and spheres, slow and plain.

Shares no code with the library. Python's floats are float64, and its products and sums are rounded one by one, in
the order that src/scene/README.md states ("Loading arithmetic (R1), in full"). It trusts its input, reads GLB files
only, and does not know Draco.

    reader      the container, buffer views, accessors
    meshopt     EXT_meshopt_compression
    slerp       the factors of spherical interpolation, rounded once
    animation   samplers; the values that an animation gives to nodes at a time
    nodes       affine matrices; hierarchy, roots, instances
    deform      morph targets and skins
    loader      primitives of all placed meshes: vertices, triangles, spheres

    documents, binary, meshopt_encoder      generated files, on which evaluator and program must agree
"""

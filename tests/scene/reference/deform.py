"""Morph targets and skins: what happens to positions before a node places them, or instead of it."""
from reference.nodes import from_columns, product


def morphed(document, primitive, positions, weights):
    for target, weight in zip(primitive.get("targets", []), weights):
        if weight != 0 and "POSITION" in target:
            positions = [tuple(p + weight * d for p, d in zip(position, displacement))
                         for position, displacement in zip(positions, document.accessor(target["POSITION"]))]
    return positions


def joint_matrices(document, hierarchy, skin):
    worlds = [hierarchy.world(joint) for joint in skin["joints"]]
    if "inverseBindMatrices" not in skin:
        return worlds
    inverse_binds = document.accessor(skin["inverseBindMatrices"])
    return [product(world, from_columns(inverse)) for world, inverse in zip(worlds, inverse_binds)]


def vertex_matrices(document, primitive, joints):
    """For each vertex the weighted sum of its joints' matrices."""
    influences = [[] for _ in document.accessor(primitive["attributes"]["POSITION"])]
    number = 0
    while "JOINTS_%d" % number in primitive["attributes"]:
        attributes = (document.accessor(primitive["attributes"][name % number]) for name in ("JOINTS_%d", "WEIGHTS_%d"))
        for vertex, chosen, weights in zip(influences, *attributes):
            vertex += [(w, joints[j]) for j, w in zip(chosen, weights) if w != 0]
        number += 1
    return [weighted_sum(vertex) for vertex in influences]


def weighted_sum(influences):
    total = [[0.0] * 4 for _ in range(3)]
    for weight, matrix in influences:
        for r in range(3):
            for c in range(4):
                total[r][c] = total[r][c] + weight * matrix[r][c]
    return total

"""What an animation gives to nodes at a time: {node: {"translation" | "rotation" | "scale" | "weights": value}}."""
import math

from reference.slerp import slerp


def pose(document, animation, time):
    """animation: index, or name, of one of the file's animations; none: the first. No time: the rest pose."""
    animations = document.list("animations")
    if time is None or not animations:
        return {}
    chosen = animations[find(animations, animation)]
    values = {}
    for channel in chosen["channels"]:
        target = channel["target"]
        if "node" in target and target["path"] in ("translation", "rotation", "scale", "weights"):
            value = sample(document, chosen["samplers"][channel["sampler"]], target["path"], time)
            values.setdefault(target["node"], {})[target["path"]] = value
    return values


def find(animations, wanted):
    """An exact name wins over an index."""
    names = [a.get("name") for a in animations]
    if not wanted:
        return 0
    return names.index(wanted) if wanted in names else int(wanted)


def sample(document, sampler, path, time):
    times = [float(t) for (t,) in document.accessor(sampler["input"])]
    values = [tuple(map(float, value)) for value in document.accessor(sampler["output"])]
    return interpolate(sampler.get("interpolation", "LINEAR"), path, times, values, time)


def interpolate(interpolation, path, times, values, time):
    """values: those of all keys, one behind the other, as an accessor holds them."""
    parts = 3 if interpolation == "CUBICSPLINE" else 1
    if path == "weights":  # scalars, one for each target
        targets = len(values) // (len(times) * parts)
        scalars = [x for (x,) in values]
        values = [tuple(scalars[i:i + targets]) for i in range(0, len(scalars), targets)]
    keys = [values[i:i + parts] for i in range(0, len(values), parts)]
    value_at = [key[parts // 2] for key in keys]  # an in-tangent, the value, an out-tangent; or the value alone

    time = min(max(time, times[0]), times[-1])
    if time in times:
        return value_at[times.index(time)]
    i = max(i for i in range(len(times)) if times[i] < time)
    d = times[i + 1] - times[i]
    u = (time - times[i]) / d
    if interpolation == "STEP":
        return value_at[i]
    if interpolation == "LINEAR":
        if path == "rotation":
            return slerp(value_at[i], value_at[i + 1], u)
        return tuple((1 - u) * v0 + u * v1 for v0, v1 in zip(value_at[i], value_at[i + 1]))
    result = cubic_spline(value_at[i], keys[i][2], value_at[i + 1], keys[i + 1][0], d, u)
    return normalised(result) if path == "rotation" else result


def cubic_spline(values0, out_tangents0, values1, in_tangents1, d, u):
    u2 = u * u
    u3 = u2 * u
    c0 = (2 * u3 - 3 * u2) + 1
    c1 = d * ((u3 - 2 * u2) + u)
    c2 = 3 * u2 - 2 * u3
    c3 = d * (u3 - u2)
    return tuple(((c0 * v0 + c1 * b0) + c2 * v1) + c3 * a1
                 for v0, b0, v1, a1 in zip(values0, out_tangents0, values1, in_tangents1))


def normalised(q):
    x, y, z, w = q
    length = math.sqrt(((x * x + y * y) + z * z) + w * w)
    return x / length, y / length, z / length, w / length

"""What the pipelines return, in numpy, from the description of the node format and of the slab test.

Operands and results are structured arrays with the fields of the exported C header, as words of 32 bits.
"""

import re

import numpy as np

SIGN = np.uint32(1 << 31)


def structures(header):
    """The structures of a C header as numpy types: {name without prefix: dtype}."""
    found = {}
    for prefix, name, body in re.findall(r"struct (\w+)_(ray|node|box|result|operands) \{(.*?)\n\};", header, re.S):
        fields = []
        for kind, field in re.findall(r"^    ((?:struct )?\w+) (\w+);", body, re.M):
            struct = re.fullmatch(rf"struct {prefix}_(\w+)", kind)
            fields.append((field, found[struct[1]] if struct else np.dtype(f"<u{int(kind[4:-2]) // 8}")))
        found[name] = np.dtype(fields)
    return found


def _minimum_number(a, b):
    """The lesser number, -0 before +0; a NaN is dropped."""
    least = np.where(np.less(a, b) | (np.equal(a, b) & np.signbit(a)), a, b)
    return np.where(np.isnan(a), b, np.where(np.isnan(b), a, least)).astype(np.float32)


def _maximum_number(a, b):
    return -_minimum_number(-a, -b)


def _floats(array, *names):
    return [array[name].view(np.float32) for name in names]


def _axes(ray, stem):
    return np.stack(_floats(ray, *(f"{stem}_{axis}" for axis in "xyz")), axis=-1)


def dual_split(operands):
    """(code, near slot, far slot) of each step; a slot is (offset, t_min, t_max), the times as words."""
    node, ray = operands["node"], operands["ray"]
    header = node["header"]
    rows = np.arange(len(header))
    carve, leaf = header >> 31 & 1 == 1, header >> 26 & 1 == 1
    kind, size, offset = header >> 29 & 3, header >> 27 & 3, header & 0x3FFFFFF
    dual = carve & (kind != 2)
    axis = np.stack([kind, kind])
    axis = np.where(carve, size, axis)
    axis = np.where(dual, np.stack([kind >> 1, (kind & 1) + 1]), axis)
    axis = np.minimum(axis, 2)
    min_side = np.where(dual, np.stack([size >> 1 & 1, size & 1]), np.array([[0], [1]])) == 1

    planes = np.stack(_floats(node, "plane_0", "plane_1"))
    origin, entry, leave = (_axes(ray, stem)[rows, axis] for stem in ("origin", "inv_entry", "inv_exit"))
    downwards = np.signbit(entry)
    is_exit = downwards == min_side
    with np.errstate(all="ignore"):
        t = (planes - origin) * np.where(is_exit, leave, entry)
    t_min, t_max = _floats(ray, "t_min", "t_max")
    lower, upper = t_min, t_max
    for plane in range(2):
        upper = np.where(is_exit[plane], _minimum_number(upper, t[plane]), upper)
        lower = np.where(is_exit[plane], lower, _maximum_number(lower, t[plane]))

    near, far = np.less_equal(t_min, upper), np.less_equal(lower, t_max)
    inside = np.less_equal(lower, upper)
    split = ~carve & ~leaf
    code = np.where(split, near.astype(int) + far, np.where(leaf, np.where(carve & ~inside, 0, 3), inside))
    second = offset + size
    near_offset = np.where(downwards[0], second, offset)
    far_offset = np.where(downwards[0], offset, second)
    words = [x.view(np.uint32) for x in (lower, upper, t_min, t_max)]
    lower, upper, t_min, t_max = words
    slot = {
        # The only child accepted is in the near slot.
        "near": (
            np.where(split, np.where(near, near_offset, far_offset), offset),
            np.where(carve | (split & ~near), lower, t_min),
            np.where(carve | (split & near), upper, t_max),
        ),
        "far": (far_offset, lower, t_max),
    }
    return code, slot["near"], slot["far"]


def ray_box(operands):
    """(hit, distance of entry as a word) of each test."""
    bounds, ray = operands["bounds"], operands["ray"]
    low, high = _axes(bounds, "box_min"), _axes(bounds, "box_max")
    origin, entry, leave = (_axes(ray, stem) for stem in ("origin", "inv_entry", "inv_exit"))
    downwards = np.signbit(entry)
    with np.errstate(all="ignore"):
        t_low = (low - origin) * np.where(downwards, leave, entry)
        t_high = (high - origin) * np.where(downwards, entry, leave)
    t_min, t_max = _floats(ray, "t_min", "t_max")
    is_free = np.isnan(t_low) | np.isnan(t_high)
    for axis in range(3):
        near = np.where(is_free[:, axis], np.float32("nan"), _minimum_number(t_low[:, axis], t_high[:, axis]))
        far = np.where(is_free[:, axis], np.float32("nan"), _maximum_number(t_low[:, axis], t_high[:, axis]))
        t_min, t_max = _maximum_number(t_min, near), _minimum_number(t_max, far)
    return np.less_equal(t_min, t_max), t_min.view(np.uint32)


def random_operands(dtype, count, seed):
    """Rays and nodes or boxes on a coarse grid, so that planes meet; special values in a few places."""
    rng = np.random.default_rng(seed)
    operands = np.zeros(count, dtype)
    special = np.array([0, 1 << 31, 0x7F800000, 0xFF800000, 0x7FC00000, 1, 0x007FFFFF, 0x7F7FFFFF], np.uint32)

    def grid(low=-16, high=17):
        return (rng.integers(low, high, count) * np.float32(0.25)).astype(np.float32).view(np.uint32)

    ray = operands["ray"]
    for axis in "xyz":
        ray[f"origin_{axis}"] = grid()
        with np.errstate(divide="ignore"):
            inverse = (np.float32(1) / grid().view(np.float32)).view(np.uint32)
        ray[f"inv_entry_{axis}"] = ray[f"inv_exit_{axis}"] = inverse
    ray["t_min"], ray["t_max"] = grid(0), grid(0, 65)
    shape = operands["node"] if "node" in dtype.names else operands["bounds"]
    for name in shape.dtype.names:
        shape[name] = rng.integers(0, 1 << 32, count, np.uint32) if name == "header" else grid()
    for part in (ray, shape):
        for name in part.dtype.names:
            if name != "header":
                chosen = rng.random(count) < 0.02
                part[name] = np.where(chosen, rng.choice(special, count), part[name])
    return operands

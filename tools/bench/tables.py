"""Results as Markdown, and two results beside one another."""


TIERS = ("structure", "filter", "interval", "mpfr", "exact")


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}" if abs(value) < 1000 else f"{value:.0f}"


def percent(value):
    return "-" if value is None else f"{100 * value:.4g} %"


def markdown(head, *rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


def add_ratios(rows):
    """Divides by the z-buffer pass of the same scene and view in the same run."""
    yardstick = {(r["scene"], r["view"]): r["cpu"] for r in rows
                 if r["configuration"] == "z-buffer" and "cpu" in r}
    for row in rows:
        if "cpu" in row and (row["scene"], row["view"]) in yardstick:
            row["ratio"] = row["cpu"] / yardstick[row["scene"], row["view"]]


def key_of(row):
    return row["scene"], row["view"], row["configuration"], row["threads"]


def tiers(row):
    counts = row.get("tiers")
    if not counts or not sum(counts.values()):
        return "-"
    total = sum(counts.values())
    return f"{total / 1e6:.3g} M: " + ", ".join(f"{tier} {100 * counts[tier] / total:.2g} %" for tier in TIERS)


def overview(rows):
    """One line to a view: what the exact answer costs, and what the others do for theirs."""
    by_key = {key_of(row): row for row in rows}
    lines = []
    for scene, view in dict.fromkeys((r["scene"], r["view"]) for r in rows):
        def of(configuration, threads, what):
            return by_key.get((scene, view, configuration, threads), {}).get(what)
        pass_cpu, triangles, visible = (of("z-buffer", 1, "cpu"), of("z-buffer", 1, "triangles"),
                                        of("exact", 2, "visible"))
        lines.append([
            scene, view, triangles or "-", percent(visible / triangles if triangles and visible is not None else None),
            number(1e9 * pass_cpu / triangles if triangles and pass_cpu else None), percent(of("z-buffer", 1, "share")),
            number(of("exact", 2, "cpu")), number(of("exact", 2, "ratio")), number(of("exact", 1, "ratio")),
            number(of("exact doubles", 1, "ratio")), number(of("aggressive", 1, "ratio")),
            number(of("paper", 1, "ratio")), number(of("Embree build", 1, "ratio")),
            number(of("Embree 16 rays", 1, "ratio")), percent(of("Embree 1 rays", 1, "share")),
            percent(of("Embree 16 rays", 1, "share")), number(of("exact", 2, "extra_bytes_per_triangle"))])
    return markdown(["scene", "view", "triangles", "visible", "z-buffer ns/tri", "finds", "exact CPU s", "exact", "x1",
                     "doubles", "aggressive", "paper", "Embree build", "16 rays", "1 ray finds", "16 find",
                     "B/tri"], *lines)


def details(rows):
    lines = []
    for row in rows:
        line = [row["scene"], row["view"], row["configuration"], row["threads"]]
        if "unavailable" in row:
            lines.append(line + ["not available: " + row["unavailable"].replace("|", "/")] + ["-"] * 9)
            continue
        lines.append(line + [
            number(row["cpu"]), number(row["wall"]), len(row["runs"]["cpu"]), number(row.get("ratio")),
            row.get("visible", "-"), percent(row.get("share")), row.get("wrong", "-"),
            number(row["peak_bytes"] / 1e6), number(row["extra_bytes_per_triangle"]), tiers(row)])
    return markdown(["scene", "view", "configuration", "threads", "CPU s", "wall s", "runs", "ratio", "visible", "share",
                     "wrong", "peak MB", "extra B/tri", "signs"], *lines)


def report(result):
    options = ", ".join(f"{key} {value}" for key, value in result["options"].items())
    skipped = "".join(f"- skipped {line}\n" for line in result["skipped"])
    return (f"# Benchmark of {result['date']}, commit {result['commit']}\n\n"
            f"{result['machine']}; {options}. 1280x720. CPU seconds from the scene in memory to the finished set; columns "
            f"without a unit are ratios to the z-buffer pass of the same run; shares are of the exact set.\n\n"
            f"{skipped}\n{overview(result['rows'])}\n{details(result['rows'])}")


def comparison(old, new):
    """New divided by old: seconds, and ratios to the z-buffer, which a busy machine does not change as much."""
    before = {key_of(row): row for row in old["rows"]}
    lines = []
    for row in new["rows"]:
        earlier = before.get(key_of(row), {})
        if "cpu" not in row or "cpu" not in earlier:
            continue
        def change(key):
            return number(row[key] / earlier[key]) if row.get(key) and earlier.get(key) else "-"
        note = "" if row.get("visible") == earlier.get("visible") else f"{earlier.get('visible')} -> {row.get('visible')}"
        lines.append([*key_of(row), change("cpu"), change("ratio"), change("peak_bytes"), note or "same"])
    return (f"New {new['commit']} ({new['date']}) divided by old {old['commit']} ({old['date']})\n\n" +
            markdown(["scene", "view", "configuration", "threads", "CPU", "ratio to z-buffer", "peak memory", "visible"],
                     *lines))

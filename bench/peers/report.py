"""The tables (markdown) and plots of a run."""

import os

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402: after choosing a backend that needs no display

import curves  # noqa: E402

EQUAL_RAYS = 100
GOAL = 0.002
PEERS = ["POV-Ray", "Cycles"]
TITLES = {"A": "A: soft shadow", "B": "B: depth of field", "C": "C: glossy reflection", "D": "D: motion blur",
          "E": "E: mesh of 70 312 triangles"}


def least(runs, figure):
    return min(r[figure] for r in runs)


def curve(results, scene, name):
    """Points (seconds, error), from large errors to small ones; seconds are the least of all turns."""
    points = {}
    for run in results["runs"]:
        if run["scene"] == scene and run["series"] == name:
            points.setdefault(run["value"], []).append(run)
    measured = [(least(r, "render_cpu_seconds"), r[0]["rmse"]) for r in points.values()]
    cited = [(c["seconds"], c["rmse"]) for c in results["cited"] if (c["scene"], c["series"]) == (scene, name)]
    return sorted(measured + cited, key=lambda point: -point[1])


def time_to_goal(results, scene, name):
    points = curve(results, scene, name)
    return curves.crossing(points, GOAL) if points else (None, "")


def scenes_of(results):
    return sorted({r["scene"] for r in results["runs"]})


def names_of(results):
    """All series, in the order of measurement; cited ones last."""
    return list(dict.fromkeys([r["series"] for r in results["runs"]] + [c["series"] for c in results["cited"]]))


def patterns_of(results):
    return [n for n in names_of(results) if n.startswith("Penumbra ") and n != "Penumbra --noise"]


def table(head, rows):
    lines = [head, ["---"] + ["--:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines) + "\n"


def equal_rays(results):
    rows = []
    for scene in scenes_of(results):
        runs = {name: [r for r in results["runs"] if (r["scene"], r["series"], r["value"]) == (scene, name, EQUAL_RAYS)]
                for name in PEERS + ["Penumbra"]}
        ours = runs["Penumbra"]
        row = [TITLES[scene]]
        for name, measured in runs.items():
            if measured:
                render, process = (least(measured, f) for f in ("render_cpu_seconds", "process_cpu_seconds"))
                row += [f"{render:.3g} ({process:.3g})", f"{measured[0]['rmse']:.5f}"]
            else:
                row += ["", ""]
        for name in PEERS:
            ratio = [least(runs[name], f) / least(ours, f) for f in ("render_cpu_seconds", "process_cpu_seconds")
                     if runs[name]]
            row.append(f"{ratio[0]:.1f} ({ratio[1]:.1f})" if ratio else "")
        rows.append(row)
    head = ["scene"] + [cell for name in PEERS + ["Penumbra"] for cell in (f"{name} s", "RMSE")]
    return table(head + [f"{name} / Penumbra" for name in PEERS], rows)


def seconds_cell(found, remark):
    if found is None:
        return remark
    return f"{found:.3g}" + (f" ({remark})" if remark else "")


def equal_error(results, names):
    rows = [[TITLES[scene]] + [seconds_cell(*time_to_goal(results, scene, name)) for name in names]
            for scene in scenes_of(results)]
    return table(["scene"] + [f"{name} s" for name in names], rows)


def times_sooner(results, names):
    rows = []
    for scene in scenes_of(results):
        ours = [time_to_goal(results, scene, name)[0] for name in ("Penumbra", "Penumbra --noise")]
        row = [TITLES[scene]]
        for name in names:
            theirs, remark = time_to_goal(results, scene, name)
            ratios = " / ".join(f"{theirs / o:.0f}" if o else "-" for o in ours) if theirs else remark
            row.append(ratios + (f" ({remark})" if theirs and remark else ""))
        rows.append(row)
    return table(["scene"] + names, rows)


def tables(results):
    names = names_of(results)
    others = [n for n in names if not n.startswith("Penumbra")]
    versions = ", ".join(results["versions"])
    return "\n".join([
        f"{results['machine']}; {versions}. {results['turns']} turns, core {results['core']}, {results['date']}.\n",
        f"{EQUAL_RAYS} rays per pixel: CPU seconds of rendering (of the whole process), and the error:\n",
        equal_rays(results),
        f"CPU seconds of rendering to an RMSE of {GOAL}:\n",
        equal_error(results, ["Penumbra", "Penumbra --noise"] + others),
        "How many times sooner Penumbra is there / Penumbra with --noise:\n",
        times_sooner(results, others),
        f"CPU seconds of Penumbra's patterns to an RMSE of {GOAL}:\n",
        equal_error(results, ["Penumbra"] + patterns_of(results))])


def plot(results, folder):
    """One plot for each scene: error over seconds."""
    os.makedirs(folder, exist_ok=True)
    adaptive = {f"{name} adaptive" for name in PEERS} | {"Penumbra --noise"}
    drawn = [n for n in names_of(results) if n not in patterns_of(results)]
    colours = {"POV-Ray": "tab:blue", "Cycles": "tab:orange", "Penumbra": "tab:green"}
    cited = dict.fromkeys(c["series"] for c in results["cited"])
    colours.update(zip(cited, ["dimgrey", "darkgrey", "black"]))
    for scene in scenes_of(results):
        figure, axes = pyplot.subplots(figsize=(6.4, 4), layout="constrained")
        for name in drawn:
            points = curve(results, scene, name)
            if points:
                axes.loglog([p[0] for p in points], [p[1] for p in points], marker="o", markersize=4, label=name,
                            color=colours[name if name in cited else name.split()[0]],
                            linestyle="--" if name in adaptive else "-",
                            markerfacecolor="white" if name in adaptive else None)
        axes.axhline(GOAL, color="grey", linewidth=0.8, linestyle=":")
        axes.set(title=TITLES[scene], xlabel="CPU seconds of rendering, one core", ylabel="RMSE")
        axes.xaxis.set_major_formatter(ticker.FormatStrFormatter("%g"))
        axes.yaxis.set_major_formatter(ticker.FormatStrFormatter("%g"))
        axes.grid(which="major", linewidth=0.4)
        axes.legend(fontsize="small")
        figure.savefig(os.path.join(folder, f"peers-{scene}.png"), dpi=100, metadata={"Software": None})
        pyplot.close(figure)

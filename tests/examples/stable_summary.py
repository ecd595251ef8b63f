"""What of a summary or report is held by the examples, and where two of them differ."""

import json
import math

STABLE = ("program", "status", "alarm", "blocks", "motions", "tools", "messages", "position",
          "extents", "time_s", "time_feed_s", "dwell_s", "cut_mm", "rapid_mm", "variables")
# Where a part was cut, and of the report of kerf stock.
STABLE_OF_PART = ("findings", "counts", "not_checked")
STABLE_OF_REPORT = ("program", "status", "alarm", "time_s", "stock", "model", "removed_mm3",
                    "left_mm3", "extents", "pieces", "tools", "threads", "sheet", "compare",
                    "against", *STABLE_OF_PART)
STABLE_OF_EDIT = ("edits", "blocks", "bytes_changed", "regenerated", "ids", "verified", "warnings")
STABLE_OF_FEATURES = ("program", "status", "alarm", "features", "holes", "patterns", "disagreements",
                      "unrecognised")
STABLE_WITHIN = {
    "alarm": ("code", "program", "line"),
    "findings": ("severity", "code", "line", "tool", "at", "depth_mm", "count"),
    "model": ("kind", "cell_mm"),
    "pieces": ("volume_mm3", "held"),
    "tools": ("tool", "type", "diameter", "source", "cut_mm", "removed_mm3"),
    "features": ("id", "key", "type", "parent", "z", "size", "volume_mm3", "strategy", "editable",
                 "reasons"),
    "holes": ("id", "form", "parent", "at", "diameter", "z", "pattern"),
    "verified": ("recognised", "others_unchanged", "difference_mm3", "outside_mm3",
                 "corner_rest_mm2", "new_findings", "time_s"),
}
RELATIVE, ABSOLUTE = 1e-6, 1e-6  # the second one for values about 0


def stable(summary: dict) -> dict:
    """What must be as expected, of a summary or of a report of kerf stock."""
    if summary.get("kerf") == "edit":  # a report is there only where all was verified
        kept = {"status": "end", **{key: summary[key] for key in STABLE_OF_EDIT}}
    elif summary.get("kerf") == "features":
        kept = {key: summary[key] for key in STABLE_OF_FEATURES}
        kept["layers"] = [[feature["id"], layer["z"], layer["lines"], len(layer.get("loops") or [])]
                          for feature in summary["features"] for layer in feature["layers"]]
    elif "stock" in summary:
        kept = {key: summary[key] for key in STABLE_OF_REPORT if key in summary}
    else:
        kept = {key: summary.get(key) for key in STABLE}
        kept |= {key: summary[key] for key in STABLE_OF_PART if key in summary}
    return {key: stable_within(key, value) for key, value in kept.items()}


def stable_within(key: str, value):
    if isinstance(value, list):
        return [stable_within(key, one) for one in value]
    if key not in STABLE_WITHIN or not isinstance(value, dict):
        return value
    return {name: value.get(name) for name in STABLE_WITHIN[key]}


def differences(expected, actual, path: str = "") -> list:
    """One line for each place where two JSON values differ."""
    if isinstance(expected, dict) and isinstance(actual, dict):
        return [line for key in [*expected, *(key for key in actual if key not in expected)]
                for line in differences(expected.get(key, "nothing"), actual.get(key, "nothing"),
                                        f"{path}.{key}" if path else key)]
    if isinstance(expected, list) and isinstance(actual, list) and len(expected) == len(actual):
        return [line for i, pair in enumerate(zip(expected, actual))
                for line in differences(*pair, f"{path}[{i}]")]
    if is_number(expected) and is_number(actual):
        same = math.isclose(expected, actual, rel_tol=RELATIVE, abs_tol=ABSOLUTE)
    else:
        same = expected == actual
    return [] if same else [f"{path}: expected {json.dumps(expected)}, got {json.dumps(actual)}"]


def is_number(value) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)

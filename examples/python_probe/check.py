"""Moves the probe of the module, and checks what is known of its motion."""

import math

from probe import Probe

names = Probe.columns()
start = [0.0] * 13
start[names.index("attitude.w")] = 1.0
start[names.index("angular_velocity.z")] = 6.0
samples = Probe().samples(start, 400.0, 30.0, 0.5)
assert len(samples) == 61
for time, state in samples:
    row = dict(zip(names, state))
    # equal moments about x and y, and thrust along z: the spin stays
    assert abs(row["angular_velocity.z"] - 6.0) < 1e-12
    attitude = [row[f"attitude.{k}"] for k in "xyzw"]
    assert abs(math.hypot(*attitude) - 1.0) < 1e-14
try:
    Probe(math.nan)
except ValueError as error:
    print("refused:", error)
else:
    raise AssertionError("NaN is no offset")
time, state = samples[-1]
print(f"after {time} s:", {name: round(number, 3) for name, number in zip(names, state)})

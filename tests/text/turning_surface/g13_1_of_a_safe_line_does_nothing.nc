(run with: --machine lathe3c)
O1 (Polar interpolation)
G13.1G40G80G98
G00X40.Z2.
M30
(finally machine X40)

(run with: --machine lathe2)
O1 (G75 without P)
G97S500M03
G00X46.Z-12.
G75R.5
G75X34.F.1
M30
(finally alarm PS0319)

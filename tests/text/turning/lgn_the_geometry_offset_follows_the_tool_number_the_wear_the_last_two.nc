(run with: --machine lathe2 --param LGN=1 --set #2701=3 --set #2712=7 --set #2012=0.5)
O1 (LGN: the geometry offset follows the tool number, the wear the last two digits)
G97S500M03
T0112
G00X50.Z0
#100=#5021
M30
(finally #100=53.5)

(run with: --machine lathe2)
O1 (a bare G90 of a mill's safe line is harmless before G00)
G18G21G40G80G90G99
G97S500M03
G00X52.Z2.
G01Z-5.F.2
M30
(finally moves: rapid X52 Z2; line X52 Z-5)

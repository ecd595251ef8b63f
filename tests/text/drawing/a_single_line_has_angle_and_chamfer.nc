(run with: --machine lathe2)
O1 (one coordinate, the angle and what comes behind)
G98 G00 X20. Z0.
G01 X40. ,A150. ,C1. F100
Z-30.
M30
(finally moves: rapid X20 Z0; line X39 Z-16.4545; line X40 Z-18.3205; line Z-30)

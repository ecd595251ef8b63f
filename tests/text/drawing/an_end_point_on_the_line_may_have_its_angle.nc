(run with: --machine lathe2)
O1 (X and Z are as the angle says, but for decimals)
G98 G00 X20. Z0.
G01 X40. Z-17.321 ,A150. F100 (expect moves: line X40 Z-17.321)
M30

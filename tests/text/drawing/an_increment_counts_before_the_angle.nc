(run with: --machine lathe2)
O1 (U is a diameter)
G98 G00 X20. Z0.
G01 U20. ,A150. F100 (expect moves: line X40 Z-17.3205)
M30

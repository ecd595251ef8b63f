(run with: --machine lathe2)
O1 (A stands in front of its words)
G98 G00 X20. Z0.
G01 X40. A-30. F100 (expect moves: line X40 Z-17.3205)
M30

(run with: --machine lathe2)
O1 (in front of the axis: 2.075 of radius away from it, outwards by 30 degrees)
G98 G00 X-17.6 Z0
G01 X-21.75 ,A30. F100 (expect moves: line X-21.75 Z-3.594)
M30

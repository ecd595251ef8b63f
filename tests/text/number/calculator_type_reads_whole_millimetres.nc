(run with: --decimal-point calculator)
O1 (NUM-1: with DPI 1 the missing point is behind the last digit)
G90 G00 X10 Y2.5 (expect moves: rapid X10 Y2.5)
G01 X0 F100 (expect moves: line X0 F100)
M30

O1 (WCS-4: also G55)
G90 G00 X5.
G92 X0
G55 G00 X1. (expect moves: rapid X6)
M30

O1 (G-3: wherever it stands)
G90 G00 X1. Y1.
X1. G91 Y1. (expect moves: rapid X2 Y2)
M30

O1 (G50.1: Y is still mirrored)
G51.1 X0 Y0
G50.1 X0
G90 G00 X1. Y1. (expect moves: rapid X1 Y-1)
M30

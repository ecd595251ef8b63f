O1 (X0 Y0 Z200 with an X1.5 behind)
G90 G0 X0 Y0 Z200 (expect moves: rapid X0 Y0 Z0.2)
X1.5 Y1500 Z-1 (expect moves: rapid X1.5 Y1.5 Z-0.001)
M30

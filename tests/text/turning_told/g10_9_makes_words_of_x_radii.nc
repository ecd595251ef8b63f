(run with: --machine lathe2)
O1 (Diameter or radius)
G00X40.Z2. (expect moves: rapid X40 Z2)
G10.9X0 (expect assumed: G10.9 makes words of X radii or diameters)
G00X10. (expect moves: rapid X20)
G00U1. (expect moves: rapid X22)
G10.9X1
G00X10. (expect moves: rapid X10)
M30
